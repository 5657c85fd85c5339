//! What the command measure does not take: exit code 2 and one line that says where, what and what to do.

use crate::run::*;
use std::fs;

const MEASURE: Program = Program("measure", module_path!());

/// Bad input: a file's text, the line to blame, and a word of the message.
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
    ("500.2,1\n500.6,1\n", 1, "nothing is visible"),
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
        MEASURE.refuses_of(text, &["-"], &format!("stdin:{line}: "), word);
    }
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
        (&[&two, &missing], &missing, "no such file"),
        (&[folder], folder, "directory"),
        (&[&latin], &format!("{latin}:2: "), "UTF-8"),
        (&[&wide], &format!("{wide}:1: "), "UTF-16"),
        (&["no\nsuch\u{1b}[0m"], "no\\nsuch", "no such file"),
        (&["--nonsense"], "measure: ", "--nonsense"),
        (&["--observer", "1930"], "measure: ", "2015-10"),
        (&["--unit", "watt"], "measure: ", "absolute"),
        (&["--interpolation", "cubic"], "measure: ", "sprague"),
        (&["--json", "--json"], "measure: ", "--json"),
        (&["--svg"], "measure: ", "--svg"),
        (&["--light", "D65"], "measure: ", "--reflectance"),
        (&["--reflectance", "--light", "D56", &two], "--light D56: ", "LED-B1"),
        (&["--reflectance", "--light", &two, &two], &two, "takes one"),
        (&["--reflectance", "--unit", "absolute", &two], "--unit absolute: ", "no unit"),
        (&["--reflectance", &two], &format!("{two}:2: "), ""),
        (&["--compare", &two], &two, "takes one"),
        (&["--compare", &missing], &missing, "no such file"),
        (&["--interpolation", "sprague", &two], &format!("{two}:1: "), "linear"),
        (&["--svg", &two], "--svg ", "directory"),
        (&["-", "-"], "-: ", "once"),
    ];
    for (arguments, start, word) in cases {
        // 2 at 505 nm is still a reflectance, 2.5 is none.
        if arguments == &["--reflectance", two.as_str()] {
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
