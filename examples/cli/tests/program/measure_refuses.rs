//! What the command measure does not take: exit code 2 and one line that says where, what and what to do.

use crate::run::*;
use std::fs;

const MEASURE: Program = Program("measure", module_path!());

/// Input that is bad if nothing is assumed: a file's text, the line to blame, and a word of the message.
const BAD: &[(&str, usize, &str)] = &[
    ("", 1, "no row of numbers"),
    ("# only\n# comments\n", 1, "no row of numbers"),
    ("dear reader\nthis is a letter\n", 1, "no row of numbers"),
    ("nm,a\n", 1, "no row of numbers"),
    ("nm,a\n500,1\n", 2, "one sample"),
    ("500\n510\n", 1, "no value"),
    ("nm,a,b\n500,1,2\n505,1\n", 3, "2 cells"),
    ("500 1\n505 1 2\n", 2, "3 cells"),
    ("nm,a,\n500,1\n505,2\n", 2, "heading"),
    ("wave length,a\nW,nm\n500,1\n505,2\n", 2, "begin the line with '#'"),
    ("500,1\n505,\n", 2, "empty"),
    ("nm,a,b\n500,1,2\n505,,3\n", 3, "'a' is empty"),
    ("500,1,\n505,2,\n", 1, "last separator"),
    ("500\t1\t\n505\t2\t\n", 1, "last separator"),
    ("500,1\n505,abc\n", 2, "'abc'"),
    ("500,1\n505,NaN\n", 2, "not a finite number"),
    ("500,1\n505,-inf\n", 2, "not a finite number"),
    ("500,1\n505,1e999\n", 2, "not a finite number"),
    ("500;1,5\n505;2,5\n", 1, "decimal point"),
    ("500,1\n510,1\n505,2\n", 3, "sort the rows"),
    ("# a\n\n500,1\n505,2\n505,3\n", 5, "line 4 too"),
    ("500.000001,1\n500.000002,2\n501,1\n", 2, "too near"),
    ("-500,1\n505,2\n", 1, "not a wavelength"),
    ("0,1\n505,2\n", 1, "not a wavelength"),
    ("5OO,1\n505,2\n510,3\n", 1, "'5OO'"),
    ("S00,1\n505,2\n510,3\n", 1, "'S00'"),
    ("0.38,1\n0.78,2\n", 1, "micrometers"),
    ("3800,1\n7800,2\n", 1, "ångströms"),
    ("900,1\n1000,2\n", 1, "nothing is visible"),
    ("nm,a,b\n400,1,0\n500,1,0\n", 2, "'b': every value is zero"),
    ("400,-1\n500,-2\n", 1, "nothing is visible"),
    ("nm,\"a\n500,1\n505,2\n", 1, "quote"),
    ("nm,lamp \"a\"\n500,1\n505,2\n", 1, "quoted cell"),
    ("500,1\r505,2\r", 1, "carriage return"),
    (
        "500,1\n505,what-has-more-than-forty-letters-is-no-number\n",
        2,
        "'what-has-more-than-forty-letters-is-no-n..', which is not a number",
    ),
];

#[test]
fn bad_input_ends_with_one_line_that_says_where() {
    for (text, line, word) in BAD {
        MEASURE.refuses_of(text, &["-", "--strict", "--fail-fast"], &format!("stdin:{line}: "), word);
    }
}

/// Input that only the user can explain, with the options for which it asks and what it says then.
#[test]
fn what_is_ambiguous_is_refused_with_the_option_that_settles_it() {
    let all = |start: &str, row: &dyn Fn(usize) -> String| {
        start.to_owned() + &(0..41).map(|k| row(k) + "\n").collect::<String>()
    };
    let plain = |k: usize| format!("{},{}", 380 + 10 * k, k + 1);
    let cases: &[(String, &[&str], &str)] = &[
        (
            all("", &|k| format!("{},1", 3800 + 100 * k)),
            &["--wavelength-unit", "angstrom"],
            "--wavelength-unit",
        ),
        (
            all("", &|k| format!("{:.2},1", 0.38 + 0.01 * k as f64)),
            &["--wavelength-unit", "um"],
            "--wavelength-unit",
        ),
        (all("THz,lamp\n", &|k| format!("{},1", 400 + 10 * k)), &["--unit", "relative"], "--wavelength-unit"),
        (
            all("nm,Absorbance\n", &|k| format!("{},.5", 380 + 10 * k)),
            &["--unit", "absorbance"],
            "--unit absorbance",
        ),
        (all("nm,lamp\n370,-999\n", &plain), &["--missing", "-999"], "--missing"),
        (all("nm,PFD (umol/m2/s)\n", &plain), &["--unit", "umol/m2/s/nm"], "--unit"),
    ];
    for (text, options, word) in cases {
        MEASURE.refuses_of(text, &["-"], "stdin", word);
        assert_eq!(MEASURE.json_with(text, &[&["-"], *options].concat()).len(), 1, "{options:?}");
    }
    let percent = all("", &|k| format!("{},{}", 380 + 10 * k, k + 20));
    MEASURE.refuses_of(&percent, &["-", "--reflectance"], "stdin:1: ", "--percent");
    assert_eq!(MEASURE.json_with(&percent, &["-", "--percent"])[0]["unit"], "reflectance");
}

/// What a file states is not overridden in silence.
#[test]
fn what_contradicts_the_file_is_refused() {
    let cases = [
        ("nm,E (mW/m2/nm)\n400,1\n500,2\n", "--unit", "absolute", "mW/m2/nm"),
        ("nm,E (mW/m2/nm)\n400,1\n500,2\n", "--lux", "100", "already"),
        ("um,lamp\n.4,1\n.5,2\n", "--wavelength-unit", "nm", "um"),
        ("nm,E (mW/m2/nm)\n400,1\n500,2\n", "--light", "A", "--reflectance"),
        ("nm,R%\n400,1\n500,2\n", "--unit", "absolute", "percent"),
    ];
    for (text, option, value, word) in cases {
        MEASURE.refuses_of(text, &["-", option, value], "stdin", word);
    }
    MEASURE.refuses_of(cases[0].0, &["-", "--reflectance"], "stdin", "no share of light");
    MEASURE.refuses_of("nm,a,a\n400,1,2\n500,1,2\n", &["-", "--column", "a"], "stdin", "give a number");
    MEASURE.refuses_of("nm,a,b\n400,1,2\n500,1,2\n", &["-", "--column", "c"], "stdin", "'a', 'b'");
    MEASURE.refuses_of("nm,a,b\n400,1,2\n500,1,2\n", &["-", "--column", "4"], "stdin", "the last one is 3");
}

#[test]
fn no_light_lies_outside_the_spectrum_locus() {
    let dark = "nm,lamp\n400,1\n480,-3\n500,-3\n520,-3\n600,5\n700,1\n";
    MEASURE.refuses_of(dark, &["-"], "stdin", "spectrum locus");
    let bright = MEASURE.json_with("400 9\n700 9\n", &["-", "--unit", "absolute"]).remove(0);
    assert!(bright["notes"].to_string().contains("brighter than the sun"), "{bright}");
}

/// The others are measured, and every file that cannot be read has a line.
#[test]
fn one_bad_file_spoils_no_other() {
    let directory = MEASURE.scratch("batch");
    let write = |name: &str, text: &str| {
        let path = directory.join(name);
        fs::write(&path, text).expect("written");
        path.to_str().expect("UTF-8").to_owned()
    };
    let files = [
        write("one.csv", "nm,one\n400,1\n700,1\n"),
        write("letter.txt", "dear reader\n"),
        write("two.csv", "nm,two,dark\n400,1,-1\n700,1,-1\n"),
        write("empty.csv", ""),
    ];
    let files: Vec<&str> = files.iter().map(String::as_str).collect();
    let Outcome { code, out, err } = MEASURE.run(&[&["--json"], &files[..]].concat());
    assert_eq!((code, out.lines().count(), err.lines().count()), (Some(2), 2, 3), "{out}\n{err}");
    assert!(out.contains("\"one\"") && out.contains("\"two\""), "{out}");
    for (line, file) in err.lines().zip([files[1], files[3], files[2]]) {
        assert!(line.starts_with(file) && line.contains(';'), "{line}");
    }
    MEASURE.refuses(&[&["--fail-fast"], &files[..]].concat(), files[1], "no row of numbers");
}

#[test]
fn bad_files_and_options_end_with_one_line() {
    let directory = MEASURE.scratch("bad");
    let path = |name: &str| directory.join(name).to_str().expect("UTF-8").to_owned();
    let (latin, wide, two) = (path("latin.csv"), path("utf16.csv"), path("two.csv"));
    fs::write(&latin, b"500,1\n# \xb5W\n505,2\n").expect("written");
    fs::write(&wide, b"\xff\xfe5\x000\x00").expect("written");
    fs::write(&two, "500 1 1\n505 2 2\n").expect("written");
    let missing = path("missing.csv");
    let folder = directory.to_str().expect("UTF-8");
    let cases: &[(&[&str], &str, &str)] = &[
        (&[&missing], &missing, "no such file"),
        (&["--fail-fast", &two, &missing], &missing, "no such file"),
        (&[folder], folder, "directory"),
        (&["--strict", &latin], &format!("{latin}:2: "), "UTF-8"),
        (&["--strict", &wide], &format!("{wide}:1: "), "UTF-16"),
        (&["no\nsuch\u{1b}[0m"], "no\\nsuch", "no such file"),
        (&["--nonsense"], "measure: ", "--nonsense"),
        (&["--observer", "1930"], "measure: ", "2015-10"),
        (&["--unit", "watt"], "measure: ", "absolute"),
        (&["--interpolation", "cubic"], "measure: ", "sprague"),
        (&["--json", "--json"], "measure: ", "--json"),
        (&["--svg"], "measure: ", "--svg"),
        (&["--light", "D65", "--fail-fast", &two], &format!("{two}:1: "), "--reflectance"),
        (&["--csv", "--json"], "measure: ", "--json"),
        (&["--lux", "0"], "measure: ", "above zero"),
        (&["--strict", "--percent"], "measure: ", "--percent"),
        (&["--strict", "--unit", "mW/m2/nm"], "--unit mW/m2/nm: ", "--strict"),
        (&["--wavelength-unit", "furlong"], "measure: ", "angstrom"),
        (&["--reflectance", "--light", "D56", &two], "--light D56: ", "LED-B1"),
        (&["--reflectance", "--light", &two, &two], &two, "takes one"),
        (&["--reflectance", "--unit", "absolute", &two], "--unit W/m2/nm: ", "no unit"),
        (&["--reflectance", "--fail-fast", &two], &format!("{two}:2: "), ""),
        (&["--compare", &two], &two, "takes one"),
        (&["--compare", &missing], &missing, "no such file"),
        (&["--interpolation", "sprague", "--fail-fast", &two], &format!("{two}:1: "), "linear"),
        (&["--svg", &two], "--svg ", "directory"),
        (&["-", "-"], "-: ", "once"),
    ];
    for (arguments, start, word) in cases {
        // 2 at 505 nm is still a reflectance, 2.5 is none.
        if arguments == &["--reflectance", "--fail-fast", two.as_str()] {
            fs::write(&two, "500 1 1\n505 2 2.5\n").expect("written");
        }
        MEASURE.refuses(arguments, start, word);
    }
}

#[test]
fn sprague_names_the_row_that_is_off_the_step() {
    let input = "400 1\n405 1\n411 1\n415 1\n420 1\n425 1\n";
    MEASURE.refuses_of(input, &["-", "--interpolation", "sprague"], "stdin:3: ", "linear");
}

#[test]
fn help_and_version_are_no_errors() {
    MEASURE.assert_helps("--observer --reflectance --light --unit --interpolation --json --svg --compare");
}
