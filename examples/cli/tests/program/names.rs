//! Names that disturb what stands around them: in reports, messages, JSON and pictures.

use crate::run::{Outcome, Program, files};
use nanospectra_cli::sensor::simulate;
use serde_json::Value;
use std::fs;

const MEASURE: Program = Program("measure", module_path!());
const SENSOR: Program = Program("sensor", module_path!());
const PAINT: Program = Program("paint", module_path!());
const SCENE: Program = Program("scene", module_path!());

/// Markup, and characters that command a terminal, turn text around or are not allowed in XML.
const BAD: &str = "<b>&\u{1b}[31m\u{7}\u{7f}\u{85}\u{9b}\u{61c}\u{200e}\u{200f}\u{2028}\u{2029}\u{202e}\u{2066}\u{fffe}\u{ffff}";

/// Returns whether a character may stand in what the program writes.
fn is_harmless(c: char) -> bool {
    !c.is_control() && (c.is_ascii() || !BAD.contains(c))
}

#[track_caller]
fn assert_harmless(text: &str) {
    let found = text.chars().find(|c| !is_harmless(*c) && *c != '\n');
    assert_eq!(found.map(|c| c.escape_unicode().to_string()), None, "{text:?}");
}

#[track_caller]
fn assert_answered(outcome: &Outcome) {
    assert_eq!((outcome.code, outcome.err.as_str()), (Some(0), ""));
    assert_harmless(&outcome.out);
}

#[track_caller]
fn assert_briefly_refused(outcome: &Outcome) {
    assert_eq!((outcome.code, outcome.err.lines().count()), (Some(2), 1), "{}", outcome.err);
    assert_harmless(&outcome.err);
    assert!(
        outcome.err.len() < 1000 && outcome.err.contains(';'),
        "{} bytes: {}",
        outcome.err.len(),
        outcome.err
    );
}

fn spectrum(name: &str) -> String {
    format!("nm,\"{name}\"\n400,1\n700,1\n")
}

fn scene(name: &str) -> String {
    let name = Value::from(name.replace('\u{7f}', ""));
    format!("title = {name}\n[lamp]\ncie = \"A\"\n[[part]]\nname = {name}\nfilter.flat = 0.5\n")
}

fn log(label: &str) -> String {
    format!(
        "time,label,gain,time_ms,full_scale,\"{BAD}\",red\n0,\"{label}\",1,1,100,500,5\n1,\"{label}\",1,1,100,5,5\n"
    )
}

#[test]
fn reports_and_json_have_no_character_that_disturbs() {
    // The names of the files are bad too, as far as their systems allow.
    let name = if cfg!(windows) { "bad" } else { &BAD.replace('/', "") };
    let lamp = MEASURE.file(&format!("{name}.csv"), &spectrum(BAD));
    let toml = SCENE.file(&format!("{name}.toml"), &scene(BAD));
    let counts = SENSOR.file(&format!("{name}-log.csv"), &log(BAD));
    let matrix =
        SENSOR.file(&format!("{name}-matrix.csv"), &format!("row,\"{BAD}\",red\nX,1,1\nY,1,1\nZ,1,1\n"));
    let pictures = MEASURE.scratch(&format!("{name}-pictures"));
    let pictures = pictures.to_str().expect("UTF-8");
    let svg = ["--force", "--svg", pictures];
    for json in [&[][..], &["--json"]] {
        assert_answered(&MEASURE.run(&[&[&lamp, "--compare", &lamp], &svg[..], json].concat()));
        assert_answered(
            &MEASURE.run(&[&[&lamp, "--reflectance", "--light", &lamp], &svg[..], json].concat()),
        );
        assert_answered(&SCENE.run(&[&[toml.as_str()], &svg[..], json].concat()));
        assert_answered(&PAINT.run(&[&["0,0,0"], &svg[..], json].concat()));
        assert_answered(&PAINT.run(&[&svg[..], json].concat()));
        assert_answered(
            &SENSOR.run(&[&["--sensor", "custom", &counts, "--calibration", &matrix], json].concat()),
        );
    }
    // JSON has the names themselves.
    assert_eq!(MEASURE.one(&[&lamp])["name"], BAD);
    assert_eq!(SCENE.one(&[&toml])["title"], BAD.replace('\u{7f}', ""));
    assert_eq!(SENSOR.json(&["--sensor", "custom", &counts, "--calibration", &matrix])[0]["label"], BAD);
}

#[test]
fn pictures_are_xml_whatever_the_names_hold() {
    let pictures = MEASURE.scratch("pictures");
    let svg = ["--svg", pictures.to_str().expect("UTF-8")];
    let lamp = MEASURE.file("lamp.csv", &spectrum(BAD));
    assert_answered(&MEASURE.run(&[&[lamp.as_str()], &svg[..]].concat()));
    let other = MEASURE.file("other.csv", &spectrum("other"));
    assert_answered(&MEASURE.run(&[&[other.as_str(), "--reflectance", "--light", &lamp], &svg[..]].concat()));
    assert_answered(&SCENE.run(&[&[SCENE.file("bad.toml", &scene(BAD)).as_str()], &svg[..]].concat()));
    assert_answered(&PAINT.run(&[&["0,0,0"], &svg[..]].concat()));
    let names = files(&pictures);
    assert_eq!(names.len(), 4);
    for name in names {
        let picture = fs::read_to_string(pictures.join(&name)).expect("a picture");
        assert_harmless(&picture);
        if let Err(error) = roxmltree::Document::parse(&picture) {
            panic!("{name}: {error}");
        }
    }
}

#[test]
fn a_name_of_many_characters_gives_a_short_message() {
    for name in ["x".repeat(70_000), BAD.repeat(2_000)] {
        let name = name.as_str();
        let refused = |input: &str, command: &Program, arguments: &[&str]| {
            assert_briefly_refused(&command.run_with(input, arguments));
        };
        for rows in ["400,x\n700,1\n", "400,1\n", "400,0\n700,0\n", "4,1\n5,1\n", "400,-1\n700,-1\n"] {
            refused(&format!("nm,\"{name}\"\n{rows}"), &MEASURE, &["-"]);
        }
        let table = MEASURE.file("long.csv", &format!("nm,\"{name}\",b\n400,1,1\n700,1,1\n"));
        refused("", &MEASURE, &["--compare", &table]);
        refused(&format!("{name}\n"), &MEASURE, &["-"]);
        refused(&format!("nm,a\n400,{name}\n700,1\n"), &MEASURE, &["-"]);
        refused(&format!("nm,\"{name}\"\n400,3\n700,1\n"), &MEASURE, &["-", "--reflectance"]);
        for option in ["--light", "--compare", "--svg", "--observer", "--unit", "--interpolation"] {
            refused("", &MEASURE, &["--reflectance", &table, option, name]);
        }
        refused("", &MEASURE, &[name]);

        let headed = |heading: &str, row: &str| {
            format!("{}\n{row}\n", heading.replace("NAME", &format!("\"{name}\"")))
        };
        let custom = ["--sensor", "custom", "-"];
        let matrix = SENSOR.file("long.csv", &headed("row,NAME,NAME2", "X,1,2"));
        for (heading, row) in [
            ("gain,time_ms,full_scale,NAME,NAME", "1,1,100,5,5"),
            ("gain,time_ms,full_scale,NAME", "1,1,100,-5"),
            ("gain,time_ms,full_scale,NAME", "1,1,100,x"),
            ("gain,time_ms,full_scale,NAME", "1,1,100,"),
            ("gain,time_ms,full_scale,NAME,dark_b", "1,1,100,5,5"),
            ("NAME", "1"),
        ] {
            refused(&headed(heading, row), &SENSOR, &[&custom[..], &["--calibration", &matrix]].concat());
        }
        let sound = headed("gain,time_ms,full_scale,NAME", "1,1,100,5");
        for table in ["row,b\nX,1\n", "b,X,Y,Z\n1,1,1,1\n", "nm,b\n400,1\n"] {
            let table = SENSOR.file("other-log.csv", table);
            for option in ["--calibration", "--responsivity"] {
                refused(&sound, &SENSOR, &[&custom[..], &[option, &table]].concat());
            }
        }
        for option in ["--sensor", "--responsivity", "--calibration", "--dark", "--unit", "--flicker-hz"] {
            refused("", &SENSOR, &[option, name]);
        }
        refused("", &SENSOR, &[name]);

        for option in ["--rgb", "--space", "--method", "--beyond", "--grid", "--light", "--svg"] {
            refused("", &PAINT, &["0,0,0", option, name]);
        }
        refused("", &PAINT, &[name]);
        refused(name, &PAINT, &["-"]);

        for option in ["--budget", "--svg", "--print"] {
            refused("", &SCENE, &["vest", option, name]);
        }
        refused("", &SCENE, &[name]);
        refused("", &SCENE, &[&format!("{name}.toml")]);
        let quoted = Value::from(name.replace('\u{7f}', ""));
        for wrong in [
            format!("{quoted} = 1\n"),
            format!("title = \"\"\n{quoted} = 1\n"),
            format!("title = \"\"\ngrid = {quoted}\n[lamp]\ncie = \"A\"\n[[part]]\nfilter.flat = 1\n"),
            format!("title = \"\"\neye = {quoted}\n[lamp]\ncie = \"A\"\n[[part]]\nfilter.flat = 1\n"),
            format!("title = \"\"\nsensor = {quoted}\n[lamp]\ncie = \"A\"\n[[part]]\nfilter.flat = 1\n"),
            format!("title = \"\"\n[lamp]\ncie = {quoted}\n[[part]]\nfilter.flat = 1\n"),
            format!("title = \"\"\n[lamp]\ncie = \"A\"\n[[part]]\nname = {quoted}\nfilter.flat = 3\n"),
            format!("title = \"\"\n[lamp]\ncie = \"A\"\n[[part]]\nfilter.csv = {quoted}\n"),
            format!("title = \"\"\n[lamp]\ncsv = {quoted}\n[[part]]\nfilter.flat = 1\n"),
        ] {
            refused("", &SCENE, &[&SCENE.file("long.toml", &wrong)]);
        }
        let program = Program("", module_path!());
        refused("", &program, &[name]);
        refused("", &program, &[&format!("--{name}")]);
    }
}

#[test]
fn a_report_shortens_a_long_name() {
    let name = "x".repeat(70_000);
    let report = MEASURE.says_to(spectrum(&name), &["-"]);
    assert!(report.len() < 5_000, "{} bytes", report.len());
    let report = SCENE.says(&[&SCENE.file("name.toml", &scene(&name))]);
    assert!(report.len() < 5_000, "{} bytes", report.len());
    let readings = format!(
        "label,gain,atime,astep,f1,f2,f3,f4,f5,f6,f7,f8,\"{name}\"\n{name},8,29,599,3,8,1,1,1,1,1,9,0\n"
    );
    let report = SENSOR.says_to(readings, &["-"]);
    assert!(report.len() < 5_000, "{} bytes", report.len());
}

/// A cell that begins so is a formula to a spreadsheet. The log is the only CSV that the program writes.
#[test]
fn no_cell_of_the_log_is_a_formula() {
    let log = simulate::log();
    let rows = log.lines().filter(|line| !line.starts_with('#'));
    for cell in rows.flat_map(|row| row.split(',')) {
        assert!(!cell.starts_with(['=', '+', '-', '@', '\t', '\r', '"', '\'']), "{cell:?}");
    }
}
