//! What the command sensor does not take: exit code 2 and one line that says where, what and what to do.

use crate::run::Program;

const SENSOR: Program = Program("sensor", module_path!());

/// Bad input: options, the log, where the message begins and a word of it.
const BAD: &[(&[&str], &str, &str, &str)] = &[
    (&[], "", "stdin:1: ", "nothing in the file"),
    (&[], "# only\n", "stdin:1: ", "heading"),
    (&[], "gain,atime,astep,f1,f2,f3,f4,f5,f6,f7,f8\n", "stdin:1: ", "only a heading"),
    (&[], "gain,atime,astep,f1,f2,f3,f4,f5,f6,f7\n1,2,3,4,5,6,7,8,9,10\n", "stdin:1: ", "no column 'f8'"),
    (&[], "gain,astep,f1,f2,f3,f4,f5,f6,f7,f8\n1,2,3,4,5,6,7,8,9,10\n", "stdin:1: ", "no column 'atime'"),
    (&[], "G\n8,29,599,1,2,3,4,5,6,7\n", "stdin:3: ", "10 cells"),
    (&[], "G\n8,29,599,1,2,3,4,x,6,7,8\n", "stdin:3: ", "'x', which is not a number"),
    (&[], "G\n8,29,599,1,2,3,4,NaN,6,7,8\n", "stdin:3: ", "not a finite number"),
    (&[], "G\n8,29,599,1,2,3,4,-5,6,7,8\n", "stdin:3: ", "dark_"),
    (&[], "G\n8,29,599,1,2,3,4,,6,7,8\n", "stdin:3: ", "'f5' is empty"),
    (&[], "G\n8,29,599,1,2,3,4,5.5,6,7,8\n", "stdin:3: ", "not a whole count"),
    (&[], "G\n9,29,599,1,2,3,4,5,6,7,8\n", "stdin:3: ", "not the register's code"),
    (&[], "G\n8,256,599,1,2,3,4,5,6,7,8\n", "stdin:3: ", "0..255"),
    (&[], "G\n8,29,599,1,2,3,4,5,6,7,\"8\n", "stdin:3: ", "quote"),
    (&[], "f1,F1\n1,2\n", "stdin:1: ", "two columns"),
    (&[], "f1,,f2\n1,2,3\n", "stdin:1: ", "no name"),
    (
        &["--sensor", "tcs3472"],
        "gain,atime,red,green,blue,clear\n1,0,1,2,3,4\n",
        "--sensor: ",
        "--calibration",
    ),
    (&["--sensor", "custom"], "gain,time_ms,full_scale,a\n1,1,1,1\n", "--sensor: ", "--responsivity"),
    (&["--sensor", "custom"], "gain,time_ms,full_scale\n1,1,1\n", "stdin:1: ", "no channel"),
    (&["--sensor", "custom"], "gain,time_ms,full_scale,a\n1,0,1,1\n", "stdin:2: ", "above zero"),
    (&["--sensor", "custom"], "gain,time_ms,full_scale,a\n1,1,0,1\n", "stdin:2: ", "cannot be a full scale"),
    (&["--sensor", "custom"], "gain,time_ms,full_scale,a\n1,1,4294967295,1\n", "stdin:2: ", "0..2147483647"),
    (&["--sensor", "custom"], "gain,time_ms,full_scale,a\n1e20,1e20,9,1\n", "stdin:2: ", "out of range"),
    (&[], "G\n8,29,599,1,2,3,4,70000,6,7,8\n", "stdin:3: ", "more than the chip can count"),
    (&["--floor", "-1"], "", "--floor: ", "0 or more"),
    (&["--floor", "few"], "", "sensor: ", "not a number"),
    (&["--sensor", "as7342"], "", "sensor: ", "as7341"),
    (&["--unit", "absolute"], "G\n8,29,599,1,2,3,4,5,6,7,8\n", "--unit: ", "--responsivity"),
    (&["--calibration", "-"], "", "-: ", "once"),
    (&["--calibration", "nowhere.csv"], "G\n8,29,599,1,2,3,4,5,6,7,8\n", "nowhere.csv: ", "no such file"),
    (&["--responsivity", "tests"], "G\n8,29,599,1,2,3,4,5,6,7,8\n", "tests: ", "directory"),
    (&["--flicker-hz", "0"], "", "--flicker-hz: ", "above 0"),
    (&["--flicker-hz", "-50"], "", "--flicker-hz: ", "above 0"),
    (&["--electrons-per-count", "-1"], "", "--electrons-per-count: ", "above 0"),
];

#[test]
fn what_is_wrong_ends_with_one_line_that_says_where() {
    for (options, log, start, word) in BAD {
        let log = log.replace("G\n", "# raw counts\ngain,atime,astep,f1,f2,f3,f4,f5,f6,f7,f8\n");
        SENSOR.refuses_of(log.as_bytes(), &[options, &["-"][..]].concat(), start, word);
    }
    SENSOR.refuses_of(b"", &["--sensor", "as7343"], "--sensor: ", "LOG of your sensor");
    SENSOR.refuses_of(b"\xff\xfea\0", &["-"], "stdin:1: ", "UTF-16");
    SENSOR.refuses_of(b"a\n\xb5\n", &["-"], "stdin:2: ", "UTF-8");
}

#[test]
fn files_about_the_chip_are_checked_as_strictly() {
    let log = "gain,time_ms,full_scale,a,b\n1,1,100,10,20\n";
    let cases = [
        ("--calibration", "row,a,b\nX,1,2\nY,1,2\n", 1, "not exactly one row Z"),
        ("--responsivity", "nm,a,b\n400,1,1\n500,-1,1\n", 3, "not a responsivity"),
        ("--calibration", "row,a,b\nX,1,2\nY,1,2\nZ,1,2\nW,1,2\n", 5, "none of X, Y, Z"),
        ("--calibration", "a,b\n1,2\n", 1, "neither a matrix nor patches"),
        ("--calibration", "row,a\nX,1\n", 1, "no column 'b'"),
        ("--calibration", "a,b,X,Y,Z\n1,2,3,0,5\n", 2, "Y is not above zero"),
        ("--calibration", "a,b,X,Y,Z\n1,2,3,inf,5\n", 2, "not a finite number"),
        ("--responsivity", "a,b\n1,2\n", 1, "no column 'nm'"),
        ("--responsivity", "nm,a,b\n500,1,2\n", 1, "one wavelength"),
        ("--responsivity", "nm,a,b\n500,1,2\n400,1,2\n", 3, "sort the rows"),
        ("--responsivity", "nm,a,b\n400,1,0\n500,2,0\n", 1, "'b' sees nothing"),
    ];
    for (option, text, line, word) in cases {
        let path = SENSOR.file("bad.csv", text);
        SENSOR.refuses_of(
            log.as_bytes(),
            &["--sensor", "custom", option, &path, "-"],
            &format!("{path}:{line}: "),
            word,
        );
    }
    for (text, word) in [
        ("a,b,X,Y,Z\n1,2,3,4,5\n", "1 patches for 2 channels"),
        ("a,b,X,Y,Z\n1,2,3,4,5\n2,4,3,4,5\n3,6,1,1,1\n", "told apart"),
    ] {
        let path = SENSOR.file("few.csv", text);
        SENSOR.refuses_of(
            log.as_bytes(),
            &["--sensor", "custom", "--calibration", &path, "-"],
            &format!("{path}: "),
            word,
        );
    }
}

#[test]
fn help_and_version_are_no_errors() {
    SENSOR.assert_helps("--sensor --responsivity --calibration --dark --json astep NOMINAL");
}
