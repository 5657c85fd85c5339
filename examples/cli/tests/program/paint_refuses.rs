//! What the command paint does not take: exit code 2 and one line that says where, what and what to do.

use crate::run::{Program, assert_refused};
use std::fs;

const PAINT: Program = Program("paint", module_path!());

/// Bad input: a text, the line to blame, and a word of the message.
const BAD: &[(&[u8], usize, &str)] = &[
    (b"", 1, "no color"),
    (b"# only\n#\n\n", 1, "no color"),
    (b"0.1 0.2\n", 1, "2 cells"),
    (b"0.1 0.2 0.3\n\n# x\n0.1 0.2 0.3 0.4\n", 4, "4 cells"),
    (b"0.1,0.2,0.3,\n", 1, "4 cells"),
    (b"0.1,,0.3\n", 1, "a cell is empty"),
    (b"red\n", 1, "'red'"),
    (b"0.1 0.2 O.3\r\n", 1, "'O.3' is not a number"),
    (b"0.1 0.2 0.3\r\n0.1 nan 0.3\r\n", 2, "not a finite number"),
    (b"inf 0 0\n", 1, "not a finite number"),
    (b"0 0 -1e39\n", 1, "not a finite number"),
    (b"0,1;0,2;0,3\n", 1, "decimal point"),
    (b"0 0 0\n1e38 0 0\n", 2, "too large"),
    (b"0 0 0\r1 1 1\r", 1, "carriage return"),
    (b"1 1 1\r\n0.1 0.2\r0.3\r\n", 2, "carriage return"),
    (b"# all of it\r0 0 0\r", 1, "carriage return"),
    (b"#12345\n", 1, "hexadecimal"),
    (b"#+12345\n", 1, "hexadecimal"),
    (b"#cc331a#\n", 1, "hexadecimal"),
    (b"#\xc3\xa9\xc3\xa9\xc3\xa9\n", 1, "hexadecimal"),
    (b"0 0 0\n\xb5\n", 2, "UTF-8"),
    (b"\xff\xfe0\x00", 1, "UTF-16"),
];

#[test]
fn bad_input_ends_with_one_line_that_says_where() {
    for (text, line, word) in BAD {
        PAINT.refuses_of(text, &["0,0,0", "-"], &format!("stdin:{line}: "), word);
    }
}

#[test]
fn bad_words_and_options_end_with_one_line() {
    let directory = PAINT.scratch("paint-bad");
    let file = directory.join("file");
    fs::write(&file, "").expect("written");
    let file = file.to_str().expect("UTF-8");
    let cases: &[(&[&str], &str, &str)] = &[
        (&["0.1,0.2"], "color 0.1,0.2: ", "2 cells"),
        (&["#cc331"], "color #cc331: ", "#cc331a"),
        (&["--rgb", "nan,0,0"], "color nan,0,0: ", "finite"),
        (&["0,0,0", "1,1,1", "x\n\u{1b}[0m"], "color x\\n", "2 cells"),
        (&["-", "--rgb", "-"], "-: ", "once"),
        (&["--nonsense"], "paint: ", "--nonsense"),
        (&["--space", "xyz"], "paint: ", "acescg"),
        (&["--method", "magic"], "paint: ", "smits"),
        (&["--light", "moon"], "--light moon: ", "LED-B1"),
        (&["--light", "A,D56", "0,0,0"], "--light D56: ", "FL12"),
        (&["--light", ""], "--light: ", "a name is empty; write --light A,FL11"),
        (&["--light", "D65,,A", "0,0,0"], "--light: ", "a name is empty"),
        (&["-0.1,0.5,0.4"], "paint: ", "write --rgb -0.1,0.5,0.4"),
        (&["0,0,0", "-.1 0 0"], "paint: ", "write --rgb -0.1,0.5,0.4"),
        (&["--beyond", "clip"], "paint: ", "desaturate"),
        (&["--beyond", "damp", "--method", "basis", "0,0,0"], "--beyond: ", "--method"),
        (&["--space", "p3"], "--space: ", "--rgb"),
        (&["--json", "--json"], "paint: ", "--json"),
        (&["--svg"], "paint: ", "--svg"),
        (&["--svg", file], &format!("--svg {file}: "), "directory"),
    ];
    for (arguments, start, word) in cases {
        PAINT.refuses(arguments, start, word);
    }
    for grid in ["bins:5,400,700", "nodes:81", "nodes:81,380,781", "nodes: 81,380,780", "", "81"] {
        let outcome = PAINT.run(&["--grid", grid, "0,0,0"]);
        for possible in ["nodes:31,400,700", "nodes:81,380,780", "nodes:36,380,730", "bins:60,400,700"] {
            assert_refused(&outcome, "paint: ", possible);
        }
    }
}

#[test]
fn a_message_shows_how_a_long_cell_begins() {
    let long = "x".repeat(300);
    let (option, cell) = (format!("--{long}"), format!("0,0,{long}"));
    let words: [&[&str]; 7] = [
        &[&long],
        &[&cell],
        &["--light", &long],
        &["--grid", &long],
        &["--space", &long],
        &["--beyond", &long],
        &[&option],
    ];
    for arguments in words {
        let outcome = PAINT.run(arguments);
        assert_refused(&outcome, "", "xx..");
        assert!(!outcome.err.contains(&"x".repeat(41)), "{}", outcome.err);
    }
    for line in [long.clone(), cell.clone(), format!("#{long}"), format!("0 0 1e{}", "9".repeat(300))] {
        let outcome = PAINT.run_with(&line, &["-"]);
        assert_refused(&outcome, "stdin:1: ", "..");
        assert!(outcome.err.len() < 150, "{}", outcome.err);
    }
}

#[test]
fn help_and_version_are_no_errors() {
    PAINT.assert_helps("--rgb --space --linear --method --beyond --light --grid --json --svg");
    // What the space's own transfer function is; `paint.rs` measures it.
    assert!(PAINT.says(&["--help"]).contains("adobe by a power of 563/256"));
}
