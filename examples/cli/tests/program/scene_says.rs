//! What the command scene says and draws: levels, luminances, shares, colors, help.

use crate::run::{Program, assert_near, number};
use serde_json::Value;
use std::fs;

const SCENE: Program = Program("scene", module_path!());

#[test]
fn a_channel_that_the_bare_lamp_leaves_dark_has_no_share() {
    let dark = "sensor = \"AS7341\"\n[lamp]\npoints = [[699, 0], [700, 1], [701, 0]]\nilluminance_lx = 100\n\
                [[part]]\nfilter.flat = 0.5\n";
    let answer = SCENE.written("dark", dark);
    assert_eq!(answer["sensor"]["of_lamp"][0], Value::Null);
    assert_near(&answer["sensor"]["of_lamp"][7], 0.5, 1e-6);
    let report = SCENE.run(&[&SCENE.file("dark.toml", &format!("title = \"dark\"\n{dark}"))]).out;
    assert!(report.contains("none") && !report.contains("NaN"), "{report}");
}

#[test]
fn the_level_asked_for_is_the_level_told_on_every_grid() {
    for grid in
        ["bins:16,380,730", "bins:31,380,730", "bins:60,380,730", "nodes:36,380,730", "nodes:81,380,780"]
    {
        for lamp in ["cie = \"FL11\"", "cie = \"A\"", "points = [[770, 1], [775, 1]]"] {
            if lamp.starts_with("points") && !grid.ends_with("780") {
                continue;
            }
            let head = format!(
                "grid = \"{grid}\"\n[lamp]\n{lamp}\nilluminance_lx = 500\n[[part]]\nsurface.flat = 0.5\n"
            );
            let absolute = &SCENE.written("level", &head)["absolute"];
            assert_near(&absolute["illuminance_lx"], 500.0, 1e-3);
            assert_near(&absolute["exitance_lm_m2"], 250.0, 1e-3);
        }
    }
}

#[test]
fn matt_is_what_scatters_last_whatever_sheets_are_behind_it() {
    let luminance = |parts: &str| {
        let head = format!("[lamp]\ncie = \"E\"\nilluminance_lx = 100\n{parts}");
        SCENE.written("matt", &head)["absolute"]["luminance_cd_m2"].clone()
    };
    let paper = "[[part]]\nsurface.flat = 0.8\n";
    let dye = |more: &str| {
        format!(
            "[[part]]\n[part.dye]\nreflectance = [[400, 0.5], [700, 0.5]]\nabsorption = [[400, 0], [700, 0]]\n\
             emission = [[500, 1], [600, 1]]\nquantum_yield = 0.5\n{more}\n"
        )
    };
    let pi = std::f64::consts::PI;
    for (sheet, share) in [
        ("", 1.0),
        ("filter.flat = 0.5", 0.5),
        ("polarizer.axis_deg = 20", 0.5),
        ("retarder = { path_difference_nm = 0, axis_deg = 0 }", 1.0),
        ("retarder = { path_difference_nm = 100000, axis_deg = 0 }", 1.0),
    ] {
        let sheet = if sheet.is_empty() { String::new() } else { format!("[[part]]\n{sheet}\n") };
        assert_near(&luminance(&format!("{paper}{sheet}")), 80.0 * share / pi, 1e-4);
        assert_near(&luminance(&format!("{}{sheet}", dye(""))), 50.0 * share / pi, 1e-4);
        assert_eq!(luminance(&format!("{}{sheet}", dye("transmitted = true"))), Value::Null);
    }
    assert_eq!(luminance(&format!("{paper}[[part]]\nmirror = {{ n = 1.5, angle_deg = 0 }}\n")), Value::Null);
    assert_eq!(luminance("[[part]]\npolarizer.axis_deg = 20\n"), Value::Null);
}

#[test]
fn a_color_that_displays_do_not_have_says_so() {
    let green = "[lamp]\ncie = \"E\"\n[[part]]\nfilter.points = [[500, 0], [520, 0.5], [540, 0]]\n";
    for (name, toml, is_clipped) in [
        ("green", green.to_string(), true),
        ("gray", green.replace("points = [[500, 0], [520, 0.5], [540, 0]]", "flat = 0.5"), false),
        ("white", green.replace("points = [[500, 0], [520, 0.5], [540, 0]]", "flat = 1"), false),
    ] {
        assert_eq!(SCENE.written(name, &toml)["hex_is_clipped"], is_clipped, "{name}");
        let report =
            SCENE.run(&[&SCENE.file(&format!("{name}.toml"), &format!("title = \"test\"\n{toml}"))]).out;
        assert_eq!(report.contains("clipped"), is_clipped, "{report}");
    }
}

#[test]
fn films_at_an_angle_stand_alone_or_behind_what_scatters() {
    let film = "[[part]]\nfilm = { n = 1.5, thickness_nm = 300, angle_deg = 56.31 }\n";
    let sheet = "[[part]]\npolarizer.axis_deg = 30\n";
    let factor = |parts: &str| {
        number(&SCENE.written("film", &format!("[lamp]\ncie = \"E\"\n{parts}"))["luminous_factor_percent"])
    };
    let alone = factor(film);
    let between = "[[part]]\nsurface.flat = 1\n";
    for parts in [format!("{film}{between}{sheet}"), format!("{sheet}{between}{film}")] {
        assert!((factor(&parts) - 0.5 * alone).abs() < 1e-4, "{parts}");
    }
    // At right angles it does nothing to polarization.
    let upright = film.replace("56.31", "0");
    assert!((factor(&format!("{upright}{sheet}")) - 0.5 * factor(&upright)).abs() < 1e-4);
}

#[test]
fn a_picture_is_drawn_once() {
    let folder = SCENE.scratch("svg");
    let path = folder.join("pictures");
    let (report, answer) =
        (SCENE.says(&["vest", "--svg", path.to_str().expect("UTF-8")]), SCENE.one(&["vest"]));
    let picture = fs::read_to_string(path.join("vest.svg")).expect("a picture");
    assert!(report.contains("vest.svg"));
    for part in ["<svg", "</svg>", "hi-vis yellow", "fluorescence", answer["hex"].as_str().expect("a code")] {
        assert!(picture.contains(part), "no {part}");
    }
    assert!(picture.contains("with, without") && picture.contains("clipped: outside sRGB"));
    let (left, path) = (folder.join("left out.svg"), folder.join("chip.svg"));
    let left = left.to_str().expect("UTF-8");
    assert_eq!(SCENE.run(&["vest", "--budget", "20", "--svg", left]).code, Some(0));
    let picture = fs::read_to_string(left).expect("a picture");
    let budget = SCENE.one(&["vest", "--budget", "20"])["budget"]["hex"].clone();
    for part in ["within 20 CIEDE2000: 1 effect left out", budget.as_str().expect("a code")] {
        assert!(picture.contains(part), "no {part}");
    }
    assert_eq!(SCENE.run(&["window", "--svg", path.to_str().expect("UTF-8")]).code, Some(0));
    let picture = fs::read_to_string(path).expect("a picture");
    for part in ["AS7341, nominal, of the lamp", "AS7341, nominal, W/m2", "\n555\n", "%\n"] {
        assert!(picture.contains(part), "no {part}");
    }
    let named = folder.join("mine.SVG");
    let named = named.to_str().expect("UTF-8");
    assert_eq!(SCENE.run(&["wine", "--svg", named]).code, Some(0));
    SCENE.refuses(&["wine", "--svg", named], &format!("--svg {named}: "), "already");
}

#[test]
fn help_names_every_json_key() {
    let help = SCENE.run(&["--help"]).out;
    let answer = SCENE.one(&["window", "--budget", "1"]);
    let mut keys: Vec<&String> = Vec::new();
    let mut look = vec![&answer];
    while let Some(value) = look.pop() {
        match value {
            Value::Object(map) => {
                keys.extend(map.keys());
                look.extend(map.values());
            }
            Value::Array(values) => look.extend(values),
            _ => {}
        }
    }
    assert!(keys.len() > 40);
    for key in keys {
        assert!(help.contains(key.as_str()), "--help does not say {key}");
    }
}
