//! The program without a command, with a wrong one, and with none of its own words.

use crate::run::Program;

const NANOSPECTRA: Program = Program("", module_path!());

#[test]
fn without_a_command_it_measures_the_lamp_it_brings() {
    let bare = NANOSPECTRA.says(&[]);
    assert!(bare.contains("l41_white_led") && bare == NANOSPECTRA.says(&["measure"]));
}

/// The reports in README.md are those of the program; of the sensor's the last columns are left out.
#[test]
fn the_readme_shows_what_the_program_says() {
    let readme = include_str!("../../README.md");
    let block = |start: &str| {
        let text = readme.split("```text\n").skip(1).find(|text| text.starts_with(start)).expect("a block");
        text.split("```").next().expect("its end")
    };
    assert_eq!(block("CIE L41").trim_end(), NANOSPECTRA.says(&[]).trim_end());

    let sensor = Program("sensor", module_path!());
    let report = sensor.says_to(block("label,gain"), &["--sensor", "as7341", "-"]);
    assert_eq!(block("AS7341").lines().count(), report.lines().count());
    for (shown, said) in block("AS7341").lines().zip(report.lines()) {
        assert!(said.starts_with(shown), "{shown:?} is {said:?}");
    }

    let measure = Program("measure", module_path!());
    let table = "nm,E (mW/m2/nm)\n500,1\n510,2\n";
    let refused = measure.run_with(table, &["-", "--unit", "absolute"]);
    assert_eq!(block("lamp.csv: "), refused.err.replace("stdin", "lamp.csv"));

    let meter = measure.json_with(&block("Model Name").replace("...", "382;0,022"), &["-"]).remove(0);
    assert_eq!(meter["read"], "lines 4..6, column 2 of 2, mW/m2/nm by 'E [mW/(m²·nm)]'");
    assert_eq!(meter["unit"], "W/m2/nm");
}

#[test]
fn help_names_every_command_with_a_sentence() {
    let help = NANOSPECTRA.says(&["--help"]);
    for command in ["measure", "sensor", "flicker", "paint", "scene"] {
        let line = help.lines().find(|line| line.trim_start().starts_with(command)).expect("a line");
        assert!(line.split_whitespace().count() > 6, "{line}");
        let usage = NANOSPECTRA.run(&[command, "--help"]).out;
        assert!(usage.contains(&format!("Usage: nanospectra {command} [OPTIONS]")), "{usage}");
    }
    assert_eq!(NANOSPECTRA.run(&["--version"]).out, concat!("nanospectra ", env!("CARGO_PKG_VERSION"), "\n"));
}

#[test]
fn a_word_that_is_no_command_is_refused_on_one_line() {
    for word in ["lamp.csv", "measur", "help"] {
        NANOSPECTRA.refuses(
            &[word],
            &format!("nanospectra: '{word}' "),
            "measure, sensor, flicker, paint, scene",
        );
    }
    let long = "x".repeat(300);
    NANOSPECTRA.refuses(&[&long], &format!("nanospectra: '{}..' ", "x".repeat(40)), "not a command");
    NANOSPECTRA.refuses(&["--json"], "nanospectra: ", "--json");
}

#[cfg(unix)]
#[test]
fn a_word_that_is_no_text_is_refused_on_one_line() {
    use std::os::unix::ffi::OsStrExt;
    let word = std::ffi::OsStr::from_bytes(b"\xff");
    let program = std::process::Command::new(env!("CARGO_BIN_EXE_nanospectra")).arg(word).output();
    let output = program.expect("it runs");
    assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0));
    assert_eq!(String::from_utf8_lossy(&output.stderr).lines().count(), 1);
}
