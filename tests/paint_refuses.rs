//! What paint does not take: exit code 2 and one line that says where, what and what to do.

mod cli;
#[path = "paint/program.rs"]
mod program;

use cli::scratch;
use program::{run, run_with};
use std::fs;

/// Bad input: a text, the line to blame, and a word of the message.
const BAD: &[(&[u8], usize, &str)] = &[
    (b"", 1, "no colour"),
    (b"# only\n#\n\n", 1, "no colour"),
    (b"0.1 0.2\n", 1, "2 cells"),
    (b"0.1 0.2 0.3\n\n# x\n0.1 0.2 0.3 0.4\n", 4, "4 cells"),
    (b"0.1,0.2,0.3,\n", 1, "4 cells"),
    (b"0.1,,0.3\n", 1, "an empty cell"),
    (b"red\n", 1, "'red'"),
    (b"0.1 0.2 O.3\r\n", 1, "'O.3' is not a number"),
    (b"0.1 0.2 0.3\r\n0.1 nan 0.3\r\n", 2, "not a finite number"),
    (b"inf 0 0\n", 1, "not a finite number"),
    (b"0 0 -1e39\n", 1, "not a finite number"),
    (b"0,1;0,2;0,3\n", 1, "decimal point"),
    (b"0 0 0\n1e38 0 0\n", 2, "too large"),
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
        let outcome = run_with(text, &["0,0,0", "-"]);
        assert_eq!((outcome.code, outcome.out.as_str()), (Some(2), ""), "{line} {word}");
        assert_one_line(&outcome.err, &format!("stdin:{line}: "), word);
    }
}

#[test]
fn bad_words_and_options_end_with_one_line() {
    let directory = scratch("paint-bad");
    let file = directory.join("file");
    fs::write(&file, "").expect("written");
    let file = file.to_str().expect("UTF-8");
    let cases: &[(&[&str], &str, &str)] = &[
        (&["0.1,0.2"], "colour 0.1,0.2: ", "2 cells"),
        (&["#cc331"], "colour #cc331: ", "#cc331a"),
        (&["--rgb", "nan,0,0"], "colour nan,0,0: ", "finite"),
        (&["0,0,0", "1,1,1", "x\n\u{1b}[0m"], "colour x\\n", "2 cells"),
        (&["-", "--rgb", "-"], "-: ", "once"),
        (&["--nonsense"], "paint: ", "--nonsense"),
        (&["--space", "xyz"], "paint: ", "acescg"),
        (&["--method", "magic"], "paint: ", "smits"),
        (&["--light", "moon"], "--light moon: ", "LED-B1"),
        (&["--light", "A,D56", "0,0,0"], "--light D56: ", "FL12"),
        (&["--space", "p3"], "--space: ", "--rgb"),
        (&["--json", "--json"], "paint: ", "--json"),
        (&["--svg"], "paint: ", "--svg"),
        (&["--svg", file], &format!("--svg {file}: "), "directory"),
    ];
    for (arguments, start, word) in cases {
        let outcome = run(arguments);
        assert_eq!((outcome.code, outcome.out.as_str()), (Some(2), ""), "{arguments:?}");
        assert_one_line(&outcome.err, start, word);
    }
    for grid in ["bins:5,400,700", "nodes:81", "nodes:81,380,781", "nodes: 81,380,780", "", "81"] {
        let outcome = run(&["--grid", grid, "0,0,0"]);
        assert_eq!((outcome.code, outcome.out.as_str()), (Some(2), ""), "{grid}");
        for possible in ["nodes:31,400,700", "nodes:81,380,780", "nodes:36,380,730", "bins:60,400,700"] {
            assert_one_line(&outcome.err, "paint: ", possible);
        }
    }
}

fn assert_one_line(message: &str, start: &str, word: &str) {
    assert_eq!(message.lines().count(), 1, "{message:?}");
    assert!(message.ends_with('\n') && !message.trim_end().contains(|c: char| c.is_control()), "{message:?}");
    assert!(message.starts_with(start), "{message:?} does not start with {start:?}");
    assert!(message.contains(word), "{message:?} does not say {word:?}");
    assert!(message.contains(';'), "{message:?} does not say what to do");
}

#[test]
fn help_and_version_are_no_errors() {
    let help = run(&["--help"]);
    assert_eq!((help.code, help.err.as_str()), (Some(0), ""));
    for option in ["--rgb", "--space", "--linear", "--method", "--light", "--grid", "--json", "--svg"] {
        assert!(help.out.contains(option), "{option}");
    }
    assert_eq!(run(&["--version"]).out.trim(), concat!("paint ", env!("CARGO_PKG_VERSION")));
}
