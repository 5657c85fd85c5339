//! The command paint from outside: what it answers, in which order, and what it draws.

use crate::fuzz::input::SPACES;
use crate::run::{Program, assert_all_near, assert_near, files, keys, number, numbers};
use model::fold::{EqualBins, Reconstruction, on_cie_nodes, weights};
use model::interpolation::{Interpolation::Linear, Outside::Zero};
use model::{linear, rgb, tables, transfer};
use nanospectra::color::{EncodedRgb, Srgb};
use nanospectra::upsample::{Sigmoid, SmitsBins, Viewing};
use nanospectra::{Curve, Nodes, Reflectance, light::D65, observer::CIE_1931};
use serde_json::Value;
use std::fs;
use std::path::Path;

const PAINT: Program = Program("paint", module_path!());

const KEYS: &str = "rgb space method status wavelengths_nm spectrum values_are roundtrip_rgb delta_e2000 \
    linear grid beyond lights notes";

/// XYZ of an answer's spectrum and of white under a light, Y = 100, by the f64 model.
fn seen(answer: &Value, light: &str) -> ([f64; 3], [f64; 3]) {
    let grid = answer["grid"].as_str().expect("a grid");
    let (layout, sizes) = grid.split_once(':').expect("LAYOUT:N,FROM,TO");
    let sizes: Vec<f64> = sizes.split(',').map(|size| size.parse().expect("a number")).collect();
    let [count, from, to] = sizes[..] else { panic!("{grid}") };
    let half = if layout == "nodes" { (to - from) / (count - 1.0) / 2.0 } else { 0.0 };
    let bins = EqualBins { low: from - half, high: to + half, count: count as usize };
    for (k, nm) in numbers(&answer["wavelengths_nm"]).into_iter().enumerate() {
        assert!((nm - (bins.edge(k) + bins.edge(k + 1)) / 2.0).abs() < 1e-4, "{grid}: {nm}");
    }
    let power = tables::source(light).on_cie_grid(Linear, Zero);
    let eye = tables::Observer::Cie1931.on_cie_grid().map(|row| {
        let lit: Vec<f64> = row.iter().zip(&power).map(|(weight, power)| weight * power).collect();
        weights(&on_cie_nodes(&lit), bins, Reconstruction::Step)
    });
    let k = 100.0 / eye[1].iter().sum::<f64>();
    let shares = numbers(&answer["spectrum"]);
    let dot = |row: &Vec<f64>| k * row.iter().zip(&shares).map(|(w, s)| w * s).sum::<f64>();
    ([dot(&eye[0]), dot(&eye[1]), dot(&eye[2])], eye.map(|row| k * row.iter().sum::<f64>()))
}

/// A transfer function below zero: that of the size, with the sign.
fn odd(curve: fn(f64) -> f64, value: f64) -> f64 {
    curve(value.abs()).copysign(value)
}

/// Holds everything an answer says about its spectrum to the model.
fn assert_follows_the_model(answer: &Value) {
    for light in answer["lights"].as_array().expect("lights") {
        let (xyz, white) = seen(answer, light["name"].as_str().expect("a name"));
        assert_all_near(&light["XYZ"], &xyz, 1e-4);
        assert_all_near(&light["lab"], &model::lab::lab(xyz, white), 4e-4);
    }
    type Code = fn(f64) -> f64;
    let (space, encode, decode): (_, Code, Code) = match answer["space"].as_str() {
        Some("srgb") => ("sRGB", transfer::srgb_encode, transfer::srgb_decode),
        Some("p3") => ("Display P3", transfer::srgb_encode, transfer::srgb_decode),
        Some("adobe") => ("Adobe RGB (1998)", transfer::adobe_encode, transfer::adobe_decode),
        Some("prophoto") => ("ProPhoto RGB", transfer::prophoto_encode, transfer::prophoto_decode),
        other => panic!("{other:?}"),
    };
    let (xyz, white) = seen(answer, answer["lights"][0]["name"].as_str().expect("a name"));
    let sum: f64 = white.iter().sum();
    // The white of the matrix is that of the sums.
    let space = rgb::RgbSpace { white: [white[0] / sum, white[1] / sum], ..*rgb::named(space) };
    let is_linear = answer["linear"] == true;
    let back = linear::apply(space.xyz_to_rgb(), xyz.map(|value| value / 100.0));
    let back = if is_linear { back } else { back.map(|value| odd(encode, value)) };
    assert_all_near(&answer["roundtrip_rgb"], &back, 1e-5);
    let asked: Vec<f64> = numbers(&answer["rgb"]);
    let asked = if is_linear { asked } else { asked.into_iter().map(|code| odd(decode, code)).collect() };
    let asked = linear::apply(space.rgb_to_xyz(), [asked[0], asked[1], asked[2]]).map(|value| 100.0 * value);
    let off = model::delta_e::de2000(model::lab::lab(asked, white), model::lab::lab(xyz, white));
    assert_near(&answer["delta_e2000"], off, 1e-4 + 1e-5 * off);
}

const COLORS: &str = "0.8 0.2 0.1\n0.05 0.3 0.6\n0.5 0.5 0.5\n0.9 0.95 0.3\n0 0 0\n1 1 1\n0.02 0.01 0.03\n";

#[test]
fn every_method_space_and_grid_says_what_an_f64_model_finds() {
    for method in ["sigmoid", "basis", "smits"] {
        for space in ["srgb", "p3", "adobe", "prophoto"] {
            let options = ["--method", method, "--space", space, "--light", "A,FL11,LED-B3", "-"];
            for answer in PAINT.json_with(COLORS, &options) {
                assert_follows_the_model(&answer);
            }
        }
    }
    let grids = "nodes:31,400,700 nodes:36,380,730 nodes:81,380,780 bins:16,380,730 bins:31,380,730 \
        bins:36,380,730 bins:60,380,730 bins:60,400,700";
    for grid in grids.split(' ') {
        for answer in PAINT.json_with(COLORS, &["--grid", grid, "--linear", "-"]) {
            assert_eq!(answer["grid"], grid);
            assert_eq!(answer["status"], "exact");
            assert!(number(&answer["delta_e2000"]) <= 0.002, "{answer}");
            assert_all_near(&answer["roundtrip_rgb"], &numbers(&answer["rgb"]), 2e-5);
            assert_follows_the_model(&answer);
        }
    }
}

#[test]
fn a_spectrum_has_the_bits_that_the_library_gives() {
    let light = D65.fine();
    let viewing: Viewing<31, Nodes<400, 700>> = Viewing::new(&CIE_1931.under(&light).fold(Curve::Step));
    let sigmoid = Sigmoid::<31, _>::new(&viewing);
    let rgb = EncodedRgb::<Srgb>::new(0.8, 0.2, 0.1).decode();
    let expected: Reflectance<31, Nodes<400, 700>> = sigmoid.reflectance(rgb).spectrum.on_grid();
    let answer = &PAINT.json(&["0.8,0.2,0.1", "--grid", "nodes:31,400,700"])[0];
    let found: Vec<f32> = numbers(&answer["spectrum"]).into_iter().map(|share| share as f32).collect();
    assert_eq!(found, expected.values());
    assert_eq!(number(&answer["delta_e2000"]) as f32, viewing.delta_e(rgb, &expected));
    // Smits on grids other than his: his bins, averaged; the last bin of 380..730 is his last step.
    let red = SmitsBins::new().reflectance(rgb);
    let answer = &PAINT.json(&["0.8,0.2,0.1", "--method", "smits", "--grid", "bins:36,380,730"])[0];
    assert_near(&answer["spectrum"][35], f64::from(red.values()[9]), 1e-7);
    assert_eq!(answer["status"], "approximate");
}

#[test]
fn keys_stand_in_order_and_grays_are_flat() {
    let answer = &PAINT.json(&["0.5,0.5,0.5", "--linear"])[0];
    assert_eq!(keys(answer), KEYS);
    assert!(numbers(&answer["spectrum"]).iter().all(|share| *share == 0.5));
    assert_eq!(numbers(&answer["wavelengths_nm"])[..2], [380.0, 385.0]);
    let lights = answer["lights"].as_array().expect("lights");
    let names: Vec<&str> = lights.iter().filter_map(|light| light["name"].as_str()).collect();
    assert_eq!(names, ["D65", "A", "FL11"]);
    // A gray is that gray under every light.
    assert!(lights.iter().all(|light| light["hex"] == "#bcbcbc"), "{lights:?}");
    let aces = &PAINT.json(&["0.5,0.5,0.5", "--space", "acescg", "--light", "fl3.1"])[0];
    assert_eq!((&aces["lights"][0]["name"], &aces["lights"][1]["name"]), (&"D60".into(), &"FL3.1".into()));
}

#[test]
fn answers_stand_in_the_order_of_the_colors() {
    let rgb = |answers: &[Value]| -> Vec<Vec<f64>> { answers.iter().map(|a| numbers(&a["rgb"])).collect() };
    let arguments = ["0,0,0", "--rgb", "#f00", "-", "--rgb", "1,1,1", "0.5 0.25 0"];
    let found = rgb(&PAINT.json_with("0.1 0.2 0.3\n0.4,0.5,0.6\n", &arguments));
    let expected = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.1, 0.2, 0.3],
        [0.4, 0.5, 0.6],
        [1.0, 1.0, 1.0],
        [0.5, 0.25, 0.0],
    ];
    assert_eq!(found, expected);
    let many: String = (0..500).map(|k| format!("{} 0.5 0.25\n", f64::from(k) / 1000.0)).collect();
    let found = rgb(&PAINT.json_with(&many, &["--rgb", "-", "--grid", "bins:16,380,730"]));
    assert_eq!(found.len(), 500);
    assert!(found.iter().enumerate().all(|(k, rgb)| rgb[0] == k as f64 / 1000.0));
}

#[test]
fn spellings_of_a_color_make_no_difference() {
    let wanted = PAINT.json(&["0.8,0.2,0.4"]).remove(0);
    let variants = [
        "0.8 0.2 0.4",
        "  .8\t2e-1   +0.4\r\n",
        "\u{feff}0.8, 0.2, 0.4\r\n\r\n",
        "# a comment\n#\n0.8;0.2;0.4 # and another\n",
        "#cc3366",
        "#CC3366\t# raspberry",
        "#c36\n",
    ];
    for variant in variants {
        let found = PAINT.json_with(variant, &["-"]);
        assert_eq!(found.len(), 1, "{variant:?}");
        assert_all_near(&found[0]["rgb"], &[0.8, 0.2, 0.4], 1e-7);
        assert_all_near(&found[0]["spectrum"], &numbers(&wanted["spectrum"]), 1e-6);
    }
    // A code is encoded even where numbers are linear.
    let linear = &PAINT.json(&["#cc3366", "--linear"])[0];
    let expected = [0.8, 0.2, 0.4].map(transfer::srgb_decode);
    assert_all_near(&linear["rgb"], &expected, 1e-6);
    assert_all_near(&linear["spectrum"], &numbers(&wanted["spectrum"]), 1e-6);
}

#[test]
fn what_no_surface_has_is_answered_with_a_status() {
    let status =
        |arguments: &[&str]| PAINT.json(arguments)[0]["status"].as_str().expect("a status").to_owned();
    assert_eq!(status(&["--rgb", "-0.1,0.4,0.4"]), "exact");
    assert_eq!(status(&["2,3,4"]), "unreachable");
    assert_eq!(status(&["--rgb=-0.2,0,-0.1"]), "unreachable");
    assert_eq!(status(&["--", "-0.1,0.4,0.4"]), "exact");
    assert_eq!(status(&["0,1,0", "--space", "bt2020"]), "unreachable");
    assert_eq!(status(&["0,1,0", "--space", "p3", "--method", "basis"]), "unphysical");
    let bright = &PAINT.json(&["2,3,4"])[0];
    assert!(numbers(&bright["spectrum"]).iter().all(|share| *share == 1.0));
    assert!(number(&bright["delta_e2000"]) > 10.0);
    PAINT.says(&["1e5,1e8,-1e8", "--linear"]);
}

#[test]
fn a_color_out_of_reach_comes_near_or_is_desaturated() {
    let green = ["0,1,0", "--space", "p3", "--linear"];
    let with = |beyond: &str| PAINT.json(&[&green[..], &["--beyond", beyond]].concat()).remove(0);
    let (near, less) = (with("nearest"), with("desaturate"));
    assert_eq!(near, PAINT.json(&green)[0]);
    assert_eq!([&near["status"], &near["beyond"]], ["unreachable", "nearest"]);
    assert_eq!([&less["status"], &less["beyond"]], ["desaturated", "desaturate"]);
    assert!(near.get("kept").is_none());
    for answer in [&near, &less] {
        assert_follows_the_model(answer);
    }
    // So far from the gray of its luminance, and hardly further.
    let (kept, y) = (number(&less["kept"]), rgb::named("Display P3").rgb_to_xyz()[1][1]);
    let mixed = |kept: f64| [y - kept * y, y + kept * (1.0 - y), y - kept * y];
    assert_all_near(&less["roundtrip_rgb"], &mixed(kept), 1e-4);
    let further = mixed(kept + 0.005).map(|share| share.to_string()).join(",");
    assert_eq!(PAINT.json(&[&further, "--space", "p3", "--linear"])[0]["status"], "unreachable");
    assert!(number(&less["delta_e2000"]) > 0.1);
    // What is within reach is the same either way, and the other methods reach everything.
    let teal = |beyond| PAINT.json(&["0.1,0.5,0.4", "--beyond", beyond]).remove(0);
    assert_eq!(teal("desaturate")["spectrum"], teal("damp")["spectrum"]);
    assert_eq!(teal("desaturate")["status"], "exact");
    assert!(PAINT.json(&["0,0,0", "--method", "basis"])[0]["beyond"].is_null());
    let said = |beyond| PAINT.run(&[&green[..], &["--beyond", beyond]].concat()).out;
    assert!(said("nearest").contains("unreachable (nearest), CIEDE2000"));
    assert!(said("desaturate").contains(&format!("desaturated (desaturate: {:.1} %", 100.0 * kept)));
}

#[test]
fn a_light_is_shown_once() {
    let names = |lights: &str| -> Vec<String> {
        let answer = PAINT.json(&["#c31", "--light", lights]).remove(0);
        let looks = answer["lights"].as_array().expect("lights").iter();
        looks.map(|look| look["name"].as_str().expect("a name").to_owned()).collect()
    };
    assert_eq!(names("D65,D65"), ["D65"]);
    assert_eq!(names("a, FL11,d65,A"), ["D65", "A", "FL11"]);
    assert_eq!(PAINT.run(&["#c31", "--light", "D65,A,A"]).out.matches("under A ").count(), 1);
}

#[test]
fn a_space_is_decoded_by_the_function_that_help_names() {
    for (space, decoded) in [
        ("srgb", transfer::srgb_decode(0.5)),
        ("p3", transfer::srgb_decode(0.5)),
        ("dci-p3", 0.5_f64.powf(2.6)),
        ("bt2020", 0.5_f64.powf(2.4)),
        ("adobe", 0.5_f64.powf(563.0 / 256.0)),
        ("prophoto", 0.5_f64.powf(1.8)),
        ("acescg", 0.5),
        ("aces2065", 0.5),
    ] {
        let answer = &PAINT.json(&["0.5,0.5,0.5", "--space", space])[0];
        assert_near(&answer["spectrum"][40], decoded, 1e-7);
        assert_all_near(&answer["roundtrip_rgb"], &[0.5; 3], 1e-6);
    }
}

/// White under the first light of an answer, as x, y, beside what the standards say.
#[test]
fn the_white_of_a_space_is_that_of_its_standard() {
    for (space, light, x, y) in [
        ("srgb", "D65", 0.3127, 0.3290),
        ("dci-p3", "DCI", 0.314, 0.351),
        ("prophoto", "D50", 0.3457, 0.3585),
        ("acescg", "D60", 0.32168, 0.33767),
        ("aces2065", "D60", 0.32168, 0.33767),
    ] {
        let first = &PAINT.json(&["1,1,1", "--space", space])[0]["lights"][0];
        assert_eq!(first["name"], light);
        let xyz = numbers(&first["XYZ"]);
        let sum: f64 = xyz.iter().sum();
        assert!((xyz[0] / sum - x).abs() < 2e-4 && (xyz[1] / sum - y).abs() < 2e-4, "{space}: {xyz:?}");
    }
}

/// The names of the types in the library that implement `RgbSpace`.
fn spaces_of_the_library(folder: &Path) -> Vec<String> {
    let mut names = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder").flatten() {
        if entry.path().is_dir() {
            names.extend(spaces_of_the_library(&entry.path()));
        } else {
            let text = fs::read_to_string(entry.path()).expect("UTF-8");
            let named = text.lines().filter_map(|line| line.strip_prefix("impl RgbSpace for "));
            names.extend(named.filter_map(|rest| Some(rest.split_once(' ')?.0.to_owned())));
        }
    }
    names
}

#[test]
fn every_rgb_space_of_the_library_can_be_named() {
    let library = spaces_of_the_library(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../src")));
    let program = include_str!("../../src/paint/answer.rs");
    for name in &library {
        assert!(program.contains(&format!("=> painter::<N, G, {name}>(job)")), "paint does not offer {name}");
    }
    assert_eq!(library.len(), SPACES.len(), "{library:?}, {SPACES:?}");
    for space in SPACES {
        assert_eq!(PAINT.json(&["0.5,0.4,0.3", "--space", space])[0]["space"], space);
    }
}

#[test]
fn without_colors_it_shows_samples_of_ces_99_under_three_lights() {
    let answers = PAINT.json(&[]);
    assert_eq!(answers.len(), 24);
    for (k, answer) in answers.iter().enumerate() {
        let name = format!("CES{:02}", 4 * k + 1);
        assert_eq!(answer["sample"], name.as_str());
        // The measured sample under D65, in f64.
        let surface = tables::reflectance(&format!("CES:{name}"));
        let surface = surface.on_cie_grid(Linear, model::interpolation::Outside::Hold);
        let power = tables::source("D65").on_cie_grid(Linear, Zero);
        let eye = tables::Observer::Cie1931.on_cie_grid();
        let xyz = model::tristimulus::xyz_of_surface(&surface, &power, &eye);
        let rgb = linear::apply(rgb::named("sRGB").xyz_to_rgb(), xyz.map(|value| value / 100.0));
        // 5 nm bands instead of 1 nm, and a white of four digits.
        let coded = rgb.map(|value| transfer::srgb_encode(value.clamp(0.0, 1.0)));
        assert_all_near(&answer["rgb"], &coded, 2e-3);
        assert_eq!(answer["status"], "exact");
        assert_eq!(answer["lights"].as_array().map(Vec::len), Some(3));
        assert_follows_the_model(answer);
    }
    let report = PAINT.says(&[]);
    for word in ["24 samples of CES99", "D65, A, FL11", "CES01", "CES93"] {
        assert!(report.contains(word), "{word}");
    }
    assert_eq!(report.lines().filter(|line| line.trim_start().starts_with("CES")).count(), 24);
}

#[test]
fn pictures_are_new_files_in_the_order_of_the_colors() {
    let pictures = PAINT.scratch("paint").join("made/here");
    let directory = pictures.to_str().expect("UTF-8");
    let report = PAINT.says_to("0 0 0\n0 1 0\n", &["#cc331a", "-", "--svg", directory, "--space", "p3"]);
    let made = files(&pictures);
    assert_eq!(made.len(), 3);
    for (name, number) in made.iter().zip(["1-", "2-000000", "3-00ff"]) {
        let text = fs::read_to_string(pictures.join(name)).expect("a text");
        assert!(name.starts_with(number) && report.contains(name.as_str()), "{name}");
        assert!(text.starts_with("<svg") && text.trim_end().ends_with("</svg>"));
        assert!(text.contains("under FL11") && text.contains("url(#rainbow)") && !text.contains("NaN"));
    }
    // A file of that name stays as it is, and nothing is drawn beside it.
    fs::write(pictures.join("1-000000.svg"), "mine").expect("written");
    let refused = PAINT.run(&["0,0,0", "1,1,1", "--svg", directory]);
    assert_eq!((refused.code, refused.out.as_str()), (Some(2), ""));
    assert!(refused.err.contains("1-000000.svg: the file exists already; "), "{}", refused.err);
    assert_eq!(fs::read_to_string(pictures.join("1-000000.svg")).expect("still there"), "mine");
    assert_eq!(files(&pictures).len(), 4);
}

#[test]
fn pictures_stay_when_the_report_is_not_read_to_its_end() {
    let directory = PAINT.scratch("unread");
    PAINT.assert_may_be_left_unread("0 0 0\n1 1 1\n", &["-", "--svg", directory.to_str().expect("UTF-8")]);
    assert_eq!(files(&directory).len(), 2);
}

#[test]
fn a_piped_report_is_plain_text() {
    for arguments in [&["#c31", "0,0,0"][..], &[], &["--method", "smits"]] {
        let report = PAINT.says(arguments);
        assert!(report.chars().all(|c| c == '\n' || !c.is_control()), "{report:?}");
    }
    let report = PAINT.run(&["0.8,0.2,0.1"]).out;
    for word in
        ["gives back    0.80000  0.20000  0.10000", "exact, CIEDE2000 0.0000", "#cc331a", "under FL11"]
    {
        assert!(report.contains(word), "{word}: {report}");
    }
}
