//! What the command scene does not take: exit code 2 and one line that says where, what and what to do.

use crate::run::{Program, assert_refused};
use std::process::Stdio;

const SCENE: Program = Program("scene", module_path!());

/// A scene, the line to blame, and a word of the message. Every scene begins with a title and a lamp on lines
/// 1 to 3.
const BAD: &[(&str, usize, &str)] = &[
    ("", 1, "missing field `part`"),
    ("[[part]]\n", 4, "one of filter, surface"),
    ("[[part]]\nfilter.points = [[400, 0.2, 1], [500, 0.2]]\n", 5, "a row of points"),
    ("[[part]]\nfilter.points = [[400, 0.2], [500]]\n", 5, "a row of points"),
    ("[[part]]\nfilter.points = [[400, 0.2, 1], [500, 0.2, 'x', true]]\n", 5, "points"),
    ("[[part]]\nfilter.points = [[400, 0.2, 'x'], [500, 0.2]]\n", 5, "invalid type"),
    (
        "[[part]]\nfilm = { n = 1.5, thickness_nm = 300, angle_deg = 50 }\n[[part]]\npolarizer.axis_deg = 0\n",
        4,
        "at an angle",
    ),
    (
        "[[part]]\npolarizer.axis_deg = 0\n[[part]]\nfilter.flat = 1\n[[part]]\nfilm = { n = 1.5, thickness_nm = 300, angle_deg = 50 }\n",
        8,
        "at an angle",
    ),
    (
        "[[part]]\nmirror = { n = 1.5, angle_deg = 50 }\n[[part]]\nfilm = { n = 1.5, thickness_nm = 300, angle_deg = 50 }\n",
        6,
        "at an angle",
    ),
    (
        "[[part]]\nfilm = { n = 1.5, thickness_nm = 300, angle_deg = 50 }\n[[part]]\nfilm = { n = 1.5, thickness_nm = 300, angle_deg = 50 }\n",
        4,
        "at an angle",
    ),
    ("[[part]]\nfilter.flat = 0.5\nsurface.flat = 0.5\n", 4, "one of filter, surface"),
    ("[[part]]\nfilter.flt = 0.5\n", 5, "unknown field `flt`"),
    ("[[part]]\nfilter.flat = \"half\"\n", 5, "invalid type"),
    ("[[part]]\nfilter.flat = 0,5\n", 5, "expected newline"),
    ("[[part]\nfilter.flat = 0.5\n", 4, "]"),
    ("[[part]]\nfilter.flat = 0.5\n\n[[part]]\nname = \"b\"\nfilter.flat = 1.5\n", 7, "1.5 is not a share"),
    ("[[part]]\nfilter.flat = nan\n", 4, "not a share"),
    ("[[part]]\nfilter.points = [[500, 50], [600, 60]]\n", 4, "not percent"),
    ("[[part]]\nfilter.points = [[600, 0.5], [500, 0.5]]\n", 4, "not above the one before"),
    ("[[part]]\nfilter.points = [[600, 0.5]]\n", 4, "fewer than 2"),
    ("[[part]]\nfilter = { flat = 0.5, ces = 1 }\n", 4, "one of flat, points"),
    ("[[part]]\nfilter = {}\n", 4, "one of flat, points"),
    ("[[part]]\nsurface.ces = 100\n", 4, "1..99"),
    ("[[part]]\nsurface.ces = 0\n", 4, "1..99"),
    ("[[part]]\nfilter.absorbance_per_cm = [[400, 1], [700, 1]]\n", 4, "path_cm"),
    ("[[part]]\nfilter = { flat = 0.5, path_cm = 1 }\n", 4, "path_cm"),
    ("[[part]]\nfilter = { absorbance_per_cm = [[400, -1], [700, 1]], path_cm = 1 }\n", 4, "absorb"),
    ("[[part]]\nfilter = { absorbance_per_cm = [[400, 1], [700, 1]], path_cm = -1 }\n", 4, "path_cm = -1"),
    ("[[part]]\nfilm = { n = 1.33, thickness_nm = -1 }\n", 4, "thickness_nm = -1"),
    ("[[part]]\nfilm = { n = 0, thickness_nm = 1 }\n", 4, "refraction"),
    ("[[part]]\nfilm = { n = 1.33, thickness_nm = 1, angle_deg = 91 }\n", 4, "angle of incidence"),
    ("[[part]]\nmirror = { n = 1.33 }\n", 5, "angle_deg"),
    ("[[part]]\nmirror = { n = 1.33, k = -1, angle_deg = 0 }\n", 4, "refraction"),
    ("[[part]]\npolarizer = { axis_deg = 0, along = 2 }\n", 4, "along and across"),
    ("[[part]]\npolarizer.axis_deg = inf\n", 4, "axis_deg = inf"),
    ("[[part]]\nretarder = { path_difference_nm = -1, axis_deg = 0 }\n", 4, "path_difference_nm = -1"),
    ("[[part]]\nretarder = { path_difference_nm = 100000.01, axis_deg = 0 }\n", 4, "give 0..100000"),
    (
        "[[part]]\n[part.dye]\nreflectance = [[400, 0.5], [700, 0.5]]\nabsorption = [[400, 0.9], [700, 0]]\n\
         emission = [[500, 1], [600, 1]]\nquantum_yield = 0.9\n",
        4,
        "more energy",
    ),
    (
        "[[part]]\n[part.dye]\nreflectance = [[400, 0.1], [700, 0.1]]\nabsorption = [[400, 0.9], [700, 0]]\n\
         emission = [[500, 1], [600, 1]]\nquantum_yield = 2\n",
        4,
        "quantum yield",
    ),
];

#[test]
fn a_bad_part_ends_with_one_line_that_says_where() {
    for (k, (toml, line, word)) in BAD.iter().enumerate() {
        let path =
            SCENE.file(&format!("bad-{k}.toml"), &format!("title = \"bad\"\n[lamp]\ncie = \"D65\"\n{toml}"));
        SCENE.refuses(&[&path], &format!("{path}:{line}: "), word);
    }
}

/// A lamp, and a word of the message.
const BAD_LAMPS: &[(&str, &str)] = &[
    ("", "one of cie"),
    ("cie = \"D65\"\nblackbody_k = 2856", "one of cie"),
    ("cie = \"moonlight\"", "'moonlight' is not a CIE illuminant"),
    ("blackbody_k = 0", "blackbody_k = 0 is out of range"),
    ("points = [[400, 1], [500, -1]]", "not a power"),
    ("points = [[400, 0], [500, 0]]", "nothing is visible"),
    ("points = [[900, 1], [1000, 1]]", "nothing is visible"),
    ("points = [[790, 1], [830, 1]]", "dark on nodes:81,380,780"),
    ("points = [[790, 1], [830, 1]]\nilluminance_lx = 100", "dark on nodes:81,380,780"),
    ("points = [[400, 1e34], [700, 1e34]]", "out of range"),
    ("points = [[400, 1e-37], [700, 1e-37]]", "out of range"),
    ("cie = \"D65\"\nilluminance_lx = 0", "illuminance_lx = 0 is out of range"),
    ("cie = \"D65\"\nilluminance_lx = inf", "illuminance_lx = inf is out of range"),
];

#[test]
fn a_bad_lamp_is_refused() {
    for (k, (lamp, word)) in BAD_LAMPS.iter().enumerate() {
        let toml = format!("title = \"bad\"\n\n[lamp]\n{lamp}\n[[part]]\nfilter.flat = 0.5\n");
        let path = SCENE.file(&format!("lamp-{k}.toml"), &toml);
        SCENE.refuses(&[&path], &format!("{path}:3: "), word);
    }
}

#[test]
fn a_scene_without_parts_is_refused_however_it_is_written() {
    let path = SCENE.file("empty.toml", "title = \"bad\"\npart = []\n[lamp]\ncie = \"D65\"\n");
    SCENE.refuses(&[&path], &format!("{path}:2: "), "without a part");
    // Files may be called in capitals.
    let path = SCENE.file("empty.TOML", "title = \"bad\"\n[lamp]\ncie = \"D65\"\n");
    SCENE.refuses(&[&path], &format!("{path}:1: "), "missing field `part`");
}

#[test]
fn a_refusal_that_nobody_reads_is_a_refusal_still() {
    let mut child = SCENE.start(&["moon"], Stdio::null());
    drop(child.stderr.take());
    assert_eq!(child.wait().expect("it ends").code(), Some(2));
}

#[test]
fn what_is_not_there_is_named() {
    let scene = |head: &str, part: &str| {
        let toml = format!("title = \"bad\"\n{head}\n[lamp]\ncie = \"D65\"\n[[part]]\n{part}\n");
        let path = SCENE.file("missing.toml", &toml);
        (SCENE.run(&[&path]), path)
    };
    let (outcome, path) = scene("grid = \"bins:17,380,730\"", "filter.flat = 1");
    assert_refused(&outcome, &format!("{path}:2: "), "'bins:17,380,730' is not compiled in");
    let (outcome, path) = scene("eye = \"cat\"", "filter.flat = 1");
    assert_refused(&outcome, &format!("{path}:2: "), "CIE 1964");
    let (outcome, path) = scene("sensor = \"AS7342\"", "filter.flat = 1");
    assert_refused(&outcome, &format!("{path}:2: "), "AS7341");
    let (outcome, _) = scene("", "filter.csv = \"not-there.csv\"");
    assert!(outcome.err.contains("not-there.csv: there is no such file"), "{:?}", outcome.err);
    let (outcome, path) = scene("", &"filter.flat = 1\n[[part]]\n".repeat(17));
    assert_refused(&outcome, &format!("{path}:"), "more than 16 parts");

    SCENE.refuses(&["moon"], "moon: ", "paper, vest");
    SCENE.refuses(&["--print", "moon"], "moon: ", "paper, vest");
    SCENE.refuses(&["not-there.toml"], "not-there.toml: ", "no such file");
    SCENE.refuses(&["vest", "--budget", "-1"], "--budget: ", "not a color difference");
    SCENE.refuses(&["vest", "--budget", "nan"], "--budget: ", "not a color difference");
    SCENE.refuses(&["vest", "--budget", "much"], "scene: ", "'much' for '--budget <DE>': not a number");
    SCENE.refuses(&["--json"], "scene: ", "--list");
    SCENE.refuses(&["vest", "--list"], "scene: ", "cannot be used");
    SCENE.refuses(&["vest", "--svg", "/dev/null/x"], "--svg /dev/null/x: ", "cannot be written");
}

#[test]
fn a_name_of_many_characters_or_escapes_stays_on_its_line() {
    let toml =
        "title = \"\\u001b[31m\"\n[lamp]\ncie = \"D65\"\n[[part]]\nname = \"\\n\\u0007\"\nfilter.flat = 1\n";
    let outcome = SCENE.run(&[&SCENE.file("escapes.toml", toml)]);
    assert_eq!(outcome.code, Some(0));
    assert!(!outcome.out.contains(['\u{1b}', '\u{7}']), "{:?}", outcome.out);
    SCENE.refuses(&[&"x".repeat(500)], &format!("{}..: ", "x".repeat(40)), "no scene");
}
