//! The command scene from outside: its numbers against an f64 model and published ones.

use crate::run::{Program, assert_all_near, assert_near, number, numbers};
use model::fine::Curve;
use model::fold::{EqualBins, Reconstruction, on_cie_nodes, weights};
use model::interpolation::{Interpolation::Linear, Outside};
use model::{csv, delta_e, lab, tables};
use nanospectra::matter::{Mirror, Polarizer, Retarder};
use nanospectra::observer::CIE_1931;
use nanospectra::{Curve as Fold, Light, Nodes, Observer, Power};
use serde_json::Value;
use std::fs;

const SCENE: Program = Program("scene", module_path!());
const BUNDLED: [&str; 6] = ["paper", "vest", "asphalt", "soap", "wine", "window"];

/// Bin k of nodes:81,380,780.
const BINS: EqualBins = EqualBins { low: 377.5, high: 782.5, count: 81 };

/// The TOML of a bundled scene as the program prints it.
fn bundled(name: &str) -> toml::Table {
    SCENE.says(&["--print", name]).parse().expect("TOML")
}

/// [[nm, value], ..] over the 81 bins.
fn over_bins(points: &toml::Value, outside: Outside) -> Vec<f64> {
    let value =
        |value: &toml::Value| value.as_float().or(value.as_integer().map(|n| n as f64)).expect("a number");
    let pairs = points.as_array().expect("points").iter().map(|pair| (value(&pair[0]), value(&pair[1])));
    let curve = Curve::new(pairs.collect(), outside);
    (0..81).map(|k| curve.mean(BINS.edge(k), BINS.edge(k + 1))).collect()
}

/// The power of a CIE illuminant in the 81 bins: the mean of five nodes.
fn lamp(id: &str) -> Vec<f64> {
    let fine = tables::source(id).on_cie_grid(Linear, Outside::Zero);
    (0..81).map(|k| fine[18 + 5 * k..23 + 5 * k].iter().sum::<f64>() / 5.0).collect()
}

/// XYZ of light in the 81 bins.
fn seen(light: &[f64]) -> [f64; 3] {
    tables::Observer::Cie1931.on_cie_grid().map(|row| {
        let row = weights(&on_cie_nodes(&row), BINS, Reconstruction::Spline);
        row.iter().zip(light).map(|(weight, power)| weight * power).sum()
    })
}

/// Holds the color of an answer to what leaves by the model; its Lab.
fn assert_looks(answer: &Value, lamp: &[f64], leaving: &[f64]) -> [f64; 3] {
    let (white, xyz) = (seen(lamp), seen(leaving));
    let scale = 100.0 / white[1];
    assert_all_near(&answer["XYZ"], &xyz.map(|value| scale * value), 1e-4);
    assert_near(&answer["luminous_factor_percent"], scale * xyz[1], 1e-4);
    let sum: f64 = xyz.iter().sum();
    assert_all_near(&answer["xy"], &[xyz[0] / sum, xyz[1] / sum], 1e-6);
    let lab = lab::lab(xyz, white);
    assert_all_near(&answer["lab"], &lab, 3e-4);
    lab
}

fn product(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a * b).collect()
}

#[test]
fn dyes_glow_as_photons_are_counted() {
    for (name, id, lux) in [("paper", "FL11", 500.0), ("vest", "LED-B3", 200.0)] {
        let (scene, answer, lamp) = (bundled(name), SCENE.one(&[name]), lamp(id));
        let dye = &scene["part"][0]["dye"];
        let nm = |k: usize| 380.0 + 5.0 * k as f64;
        let reflects = over_bins(&dye["reflectance"], Outside::Hold);
        let absorbed = product(&lamp, &over_bins(&dye["absorption"], Outside::Hold));
        let emits = over_bins(&dye["emission"], Outside::Zero);
        let photons =
            |power: &[f64]| -> f64 { power.iter().enumerate().map(|(k, power)| nm(k) * power).sum() };
        let glow = dye["quantum_yield"].as_float().expect("a number") * photons(&absorbed) / photons(&emits);
        let dull = product(&lamp, &reflects);
        let leaving: Vec<f64> = dull.iter().zip(&emits).map(|(power, emits)| power + glow * emits).collect();
        let lab = assert_looks(&answer, &lamp, &leaving);
        let cost = delta_e::de2000(lab, lab::lab(seen(&dull), seen(&lamp)));
        assert_near(&answer["bill"][0]["without_delta_e2000"], cost, 1e-3);

        // The level: 683.002 lm/W and V, over the grid.
        let [_, v, _] = seen(&lamp);
        let per_unit = lux / (683.002 * v);
        let absolute = &answer["absolute"];
        let share = number(&answer["luminous_factor_percent"]) / 100.0;
        let watts = |power: &[f64]| 5.0 * per_unit * power.iter().sum::<f64>();
        assert_near(&absolute["illuminance_lx"], lux, 1e-6 * lux);
        assert_near(&absolute["irradiance_w_m2"], watts(&lamp), 1e-5 * watts(&lamp));
        assert_near(&absolute["exitance_lm_m2"], lux * share, 2e-6 * lux);
        assert_near(&absolute["exitance_w_m2"], watts(&leaving), 1e-5 * watts(&lamp));
        let pi = std::f64::consts::PI;
        assert_near(&absolute["luminance_cd_m2"], lux * share / pi, 1e-6 * lux);
        assert_near(&absolute["radiance_w_m2_sr"], watts(&leaving) / pi, 1e-5 * watts(&lamp));
    }
}

#[test]
fn wine_takes_its_absorbance_twice() {
    let (scene, answer, lamp) = (bundled("wine"), SCENE.one(&["wine"]), lamp("A"));
    let absorbance = over_bins(&scene["part"][0]["filter"]["absorbance_per_cm"], Outside::Hold);
    assert_eq!(scene["part"][2]["filter"], scene["part"][0]["filter"]);
    let leaving: Vec<f64> = lamp
        .iter()
        .zip(absorbance)
        .map(|(power, per_cm)| power * 0.85 * 10f64.powf(-2.0 * 0.3 * per_cm))
        .collect();
    assert_looks(&answer, &lamp, &leaving);
}

#[test]
fn films_of_soap_have_the_published_colors() {
    let (mut compared, mut worst) = (0, 0.0f64);
    for row in csv::golden("10_thin_film_color").rows().filter(|row| row.text("stack") == "soap") {
        let (thickness, angle) = (row.number("d_nm"), row.number("theta_deg"));
        let film = format!("film = {{ n = 1.33, thickness_nm = {thickness}, angle_deg = {angle} }}");
        let answer = SCENE.written("soap-film", &format!("[lamp]\ncie = \"D65\"\n[[part]]\n{film}\n"));
        // 5 nm averages under a spline, where the golden sums points at 1 nm.
        let published = row.numbers(["X", "Y", "Z"]);
        for (found, published) in numbers(&answer["XYZ"]).into_iter().zip(published) {
            worst = worst.max((found - published).abs());
        }
        compared += 1;
    }
    assert!(compared > 20 && worst < 4e-3, "{compared} films, {worst}");
    println!("{compared} films, worst {worst}");
    let row = csv::golden("10_thin_film_color").find("id", "soap_300_0");
    assert_all_near(&SCENE.one(&["soap"])["XYZ"], &row.numbers(["X", "Y", "Z"]), 4e-3);
}

/// Shares of s and p that a surface of index n reflects.
fn fresnel(n: f64, angle_deg: f64) -> [f64; 2] {
    let (sine, cosine) = angle_deg.to_radians().sin_cos();
    let inside = (n * n - sine * sine).sqrt();
    let s = (cosine - inside) / (cosine + inside);
    let p = (n * n * cosine - inside) / (n * n * cosine + inside);
    [s * s, p * p]
}

#[test]
fn sunglasses_take_the_glare_off_a_wet_road() {
    let answer = SCENE.one(&["asphalt"]);
    let [s, p] = fresnel(1.333, 60.0);
    assert_near(&answer["XYZ"][1], 100.0 * 0.5 * (s * 0.001 + p * 0.76), 1e-5);
    assert!(number(&answer["bill"][1]["without_delta_e2000"]) > 5.0);
    assert_eq!(answer["absolute"]["luminance_cd_m2"], Value::Null);
    // The same sheet turned takes little.
    let turned = SCENE.run(&["--print", "asphalt"]).out.replace("axis_deg = 90", "axis_deg = 0");
    let answer = SCENE.one(&[&SCENE.file("turned.toml", &turned)]);
    assert_near(&answer["XYZ"][1], 100.0 * 0.5 * (s * 0.76 + p * 0.001), 1e-5);
}

#[test]
fn polarizers_follow_malus_and_crossed_ones_are_black() {
    let pair = |deg: f64, between: &str| {
        let sheets = format!(
            "[lamp]\ncie = \"E\"\n[[part]]\npolarizer.axis_deg = 0\n{between}[[part]]\npolarizer.axis_deg = {deg}\n"
        );
        SCENE.written("pair", &sheets)
    };
    for deg in [0.0, 30.0, 45.0, 60.0, 90.0] {
        let malus = 50.0 * f64::to_radians(deg).cos().powi(2);
        assert_near(&pair(deg, "")["luminous_factor_percent"], malus, 1e-5);
    }
    let black = pair(90.0, "");
    assert_eq!((&black["hex"], &black["XYZ"]), (&"#000000".into(), &serde_json::json!([0.0, 0.0, 0.0])));
    assert_eq!(black["xy"], Value::Null);
    // A matt surface between them forgets: half of half.
    let gray = pair(90.0, "[[part]]\nsurface.flat = 1.0\n");
    assert_near(&gray["luminous_factor_percent"], 25.0, 1e-5);
}

#[test]
fn a_metal_turns_polarized_light_as_its_phase_says() {
    // Gold in the green, n = 0.4 + 2.4i, met at 70 degrees: complex Fresnel, by hand.
    let (n, k, sine2, cosine) = (0.4f64, 2.4f64, 70f64.to_radians().sin().powi(2), 70f64.to_radians().cos());
    let (re, im) = (n * n - k * k - sine2, 2.0 * n * k);
    let size = re.hypot(im);
    let (a, b) = (((size + re) / 2.0).sqrt(), ((size - re) / 2.0).sqrt());
    let s2 = ((cosine - a).powi(2) + b * b) / ((cosine + a).powi(2) + b * b);
    // tan(psi) e^(i delta) = r_p / r_s for a metal (Born and Wolf, 14.2): sin tan is real.
    let st = sine2 / cosine;
    let ratio2 = ((a - st).powi(2) + b * b) / ((a + st).powi(2) + b * b);
    let cos_delta =
        (a * a + b * b - st * st) / (((a - st).powi(2) + b * b) * ((a + st).powi(2) + b * b)).sqrt();
    let parts = |mirror: &str, deg: f64| {
        format!(
            "[lamp]\ncie = \"E\"\n[[part]]\npolarizer.axis_deg = 45\n[[part]]\nmirror = {mirror}\n\
             [[part]]\npolarizer.axis_deg = {deg}\n"
        )
    };
    for (deg, sign) in [(45.0, 1.0), (-45.0, -1.0)] {
        // |r_s + r_p|^2 / 4 of the half that the first sheet passes.
        let expected = 0.5 * 0.25 * s2 * (1.0 + ratio2 + sign * 2.0 * ratio2.sqrt() * cos_delta);
        let answer = SCENE.written("gold", &parts("{ n = 0.4, k = 2.4, angle_deg = 70 }", deg));
        assert_near(&answer["luminous_factor_percent"], 100.0 * expected, 2e-5);
    }
    // Total reflection: r_p / r_s has the phase -2 phi, tan(phi) = cos sqrt(sin^2 - n^2) / sin^2; beyond
    // Brewster's angle p comes back on the other side, so it is the sheet across that lets most of it
    // through.
    let (sine2, cosine) = (60f64.to_radians().sin().powi(2), 60f64.to_radians().cos());
    let phi = (cosine * (sine2 - 0.66f64 * 0.66).sqrt() / sine2).atan();
    let answer = SCENE.written("total", &parts("{ n = 0.66, angle_deg = 60 }", -45.0));
    assert_near(&answer["luminous_factor_percent"], 50.0 * phi.cos().powi(2), 2e-5);
    // Behind a plate the sign of the phase shows too: as the library has it.
    let plate = "retarder = { path_difference_nm = 137.5, axis_deg = 0 }";
    let sheets = parts("{ n = 0.66, angle_deg = 60 }", -45.0).replacen(
        "[[part]]\npolarizer.axis_deg = -",
        &format!("[[part]]\n{plate}\n[[part]]\npolarizer.axis_deg = -"),
        1,
    );
    let answer = SCENE.written("behind a plate", &sheets);
    let eye: Observer<3, 81, Power, Nodes<380, 780>> = CIE_1931.fold(Fold::Spline);
    let (lamp, [first, last]) = (Light::flat(1.0), [0.125, -0.125].map(Polarizer::ideal));
    let (prism, plate) =
        (Mirror::dielectric(&[0.66; 81], 0.5, 0.0), Retarder::from_path_difference(137.5, 0.0));
    let path = lamp.polarized().through(&first).onto(&prism).through(&plate).through(&last);
    let [_, y, _] = eye.sees(path.ignoring_polarization());
    let [_, white, _] = eye.sees(&lamp);
    let expected = 100.0 * f64::from(y / white);
    assert!(!(15.0..35.0).contains(&expected), "the sign would not show: {expected}");
    assert_near(&answer["luminous_factor_percent"], expected, 2e-5);
}

#[test]
fn a_sensor_counts_what_its_channels_see() {
    let (scene, answer, lamp) = (bundled("window"), SCENE.one(&["window"]), lamp("D65"));
    let glass = over_bins(&scene["part"][0]["filter"]["points"], Outside::Hold);
    let peaks = numbers(&answer["sensor"]["channels_nm"]);
    let widths = [26.0, 30.0, 36.0, 39.0, 39.0, 40.0, 50.0, 52.0];
    let shares = peaks.iter().zip(widths).map(|(peak, width)| {
        let channel = |k: usize| -> f64 {
            let nodes = if k == 0 { 360..=382 } else { 378 + 5 * k..=382 + 5 * k };
            nodes.map(|nm| (-4.0 * 2f64.ln() * ((nm as f64 - peak) / width).powi(2)).exp()).sum()
        };
        let (mut through, mut bare) = (0.0, 0.0);
        for k in 0..81 {
            bare += channel(k) * lamp[k];
            through += 0.6 * glass[k] * channel(k) * lamp[k];
        }
        through / bare
    });
    // (What the chip sees below the grid counts in its first bin.)
    assert_all_near(&answer["sensor"]["of_lamp"], &shares.collect::<Vec<_>>(), 1e-6);
    let leaving: Vec<f64> = lamp.iter().zip(&glass).map(|(power, share)| 0.6 * power * share).collect();
    assert_looks(&answer, &lamp, &leaving);
    // With a level in W/m2: its lux over 683 lm/W and the sum with V, of 5 nm bins.
    let unit = 10_000.0 / (683.002 * seen(&lamp)[1]);
    let watts: f64 = (0..81)
        .map(|k| {
            let nodes = if k == 0 { 360..=382 } else { 378 + 5 * k..=382 + 5 * k };
            let seen: f64 =
                nodes.map(|nm| (-4.0 * 2f64.ln() * ((nm as f64 - peaks[4]) / widths[4]).powi(2)).exp()).sum();
            unit * seen * leaving[k]
        })
        .sum();
    assert_near(&answer["sensor"]["channels"][4], watts, 2e-6 * watts);
    let report = SCENE.run(&["window"]).out;
    let row = |title: &str| -> Vec<String> {
        let row = report.lines().find_map(|line| line.trim_start().strip_prefix(title));
        row.expect("a row").split_whitespace().map(String::from).collect()
    };
    assert!(report.contains("AS7341, nominal") && !report.contains("counts"), "{report}");
    assert_eq!(row("nm")[4], "555");
    let share = 100.0 * number(&answer["sensor"]["of_lamp"][4]);
    assert_eq!(
        (row("of the lamp")[4].clone(), row("W/m2")[4].clone()),
        (format!("{share:.2}%"), format!("{watts:.3}"))
    );
}

#[test]
fn a_budget_leaves_out_what_does_not_show() {
    let full = SCENE.one(&["paper"]);
    let cost = number(&full["bill"][0]["without_delta_e2000"]);
    assert!(full["budget"].is_null() && full["bill"][0]["left_out"] == false);
    for (allowed, out) in [(cost - 0.01, 0), (cost + 0.01, 1), (0.0, 0)] {
        let answer = SCENE.one(&["paper", "--budget", &allowed.to_string()]);
        let budget = &answer["budget"];
        assert_eq!(budget["left_out"].as_array().map(Vec::len), Some(out), "{allowed}");
        assert_near(&budget["cost_delta_e2000"], if out == 1 { cost } else { 0.0 }, 1e-6);
        assert_eq!(answer["bill"][0]["left_out"], out == 1);
        let saved = number(&full["walked"]["multiply_adds"]) - number(&budget["multiply_adds"]);
        assert_eq!(saved, if out == 1 { 2.0 * 81.0 } else { 0.0 });
        assert_eq!(answer["XYZ"], full["XYZ"]);
    }
    assert!(SCENE.run(&["vest", "--budget", "2"]).out.contains("nothing can be left out"));
    assert!(SCENE.run(&["vest", "--budget", "20"]).out.contains("1 effect left out"));
}

#[test]
fn the_bill_is_that_of_the_library() {
    let price = |line: &Value| [&line["multiply_adds"], &line["bytes"]].map(|value| number(value) as usize);
    let bill = |name: &str| {
        SCENE.one(&[name])["bill"].as_array().expect("a bill").iter().map(price).collect::<Vec<_>>()
    };
    assert_eq!(bill("wine"), vec![[81, 324]; 3]);
    assert_eq!(bill("vest"), [[243, 972]]);
    // Unpolarized light before the first part that polarizes is a quarter of the work.
    assert_eq!(bill("asphalt"), [[324, 1304], [1296, 1304]]);
    let answer = SCENE.one(&["vest"]);
    assert_eq!((price(&answer["walked"]), price(&answer["folded"])), ([486, 2268], [243, 1296]));
    let soap = SCENE.one(&["soap"]);
    assert_eq!((price(&soap["walked"]), price(&soap["folded"])), ([324, 1620], [243, 1296]));
}

#[test]
fn every_bundled_scene_is_listed_and_starts_one_of_the_users() {
    let listed = SCENE.run(&["--list"]).out;
    assert_eq!(listed, SCENE.run(&[]).out);
    for name in BUNDLED {
        assert!(listed.lines().any(|line| line.starts_with(&format!("  {name} "))), "{name}");
        let text = SCENE.run(&["--print", name]).out;
        let path = SCENE.file(&format!("{name}.toml"), &text);
        let (mut copied, original) = (SCENE.one(&[&path]), SCENE.one(&[name]));
        // Named after its file, which has the test's name before it.
        assert_eq!((&original["scene"], &copied["scene"]), (&name.into(), &format!("scene-{name}").into()));
        copied["scene"] = original["scene"].clone();
        assert_eq!(copied, original);
        assert!(text.contains('#'), "{name} says nothing about its numbers");
        let report = SCENE.says(&[name]);
        assert!(report.contains(original["hex"].as_str().expect("a code")));
        assert!(!report.contains('\u{1b}') && !report.contains("NaN"));
    }
    let texts = BUNDLED.map(|name| SCENE.run(&["--print", name]).out).concat();
    assert!(texts.matches("ominal").count() >= 4, "what is invented says so");
}

#[test]
fn every_way_to_give_a_lamp_and_a_share_gives_it() {
    let folder = SCENE.scratch("csv");
    fs::write(folder.join("flat.csv"), "nm,share\n380,0.5\n780,0.5\n").expect("a file");
    fs::write(folder.join("lamp.csv"), "nm,power\n300,2\n900,2\n").expect("a file");
    let answer = |lamp: &str, part: &str| {
        let path = folder.join("scene.toml");
        fs::write(&path, format!("title = \"test\"\n[lamp]\n{lamp}\n[[part]]\n{part}\n")).expect("a file");
        SCENE.one(&[path.to_str().expect("UTF-8")])
    };
    let half = answer("cie = \"e\"", "filter.flat = 0.5");
    assert_near(&half["luminous_factor_percent"], 50.0, 1e-5);
    for lamp in ["csv = \"lamp.csv\"", "points = [[300, 7], [900, 7.0]]"] {
        for part in [
            "surface.csv = \"flat.csv\"",
            "surface.points = [[400, 0.5], [700, 0.5]]",
            "filter = { absorbance_per_cm = [[400, 0.30103], [700, 0.30103]], path_cm = 1 }",
        ] {
            let found = answer(lamp, part);
            assert_all_near(&found["XYZ"], &numbers(&half["XYZ"]), 1e-4);
        }
    }
    // CIE 15: the chromaticity of illuminant A, a black body of 2856 K by an older constant.
    let hot = answer("blackbody_k = 2855.5", "filter.flat = 1");
    assert_all_near(&hot["xy"], &[0.44758, 0.40745], 1e-4);
    let red = answer("cie = \"D65\"", "surface.ces = 2");
    assert!(numbers(&red["lab"])[1] > 10.0, "{red}");
    // Every grid, and the eye for large fields.
    for grid in ["bins:16,380,730", "bins:31,380,730", "bins:60,380,730", "nodes:36,380,730"] {
        for eye in ["CIE 1931", "CIE 1964"] {
            let head = format!(
                "grid = \"{grid}\"\neye = \"{eye}\"\n[lamp]\ncie = \"D65\"\n[[part]]\nfilter.flat = 0.25\n"
            );
            let answer = SCENE.written("grids", &head);
            assert_near(&answer["luminous_factor_percent"], 25.0, 1e-5);
            assert_eq!((&answer["grid"], &answer["eye"]), (&grid.into(), &eye.into()));
        }
    }
}
