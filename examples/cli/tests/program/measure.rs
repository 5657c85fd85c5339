//! The command measure from outside: what it reads, prints, and refuses.

use crate::run::*;
use serde_json::Value;
use std::fs;

const MEASURE: Program = Program("measure", module_path!());

/// In the order of the documentation; more may follow.
const KEYS: &str = "name XYZ xy uv1960 uv1976 cct_k duv lux ler_lm_per_w lab srgb hex dominant_wavelength_nm purity \
    cri_ra cri_r tm30_rf tm30_rg melanopic_edi_ratio ppfd notes";

/// The reading of one column of a file below `tables/`.
fn table(file: &str, name: &str, arguments: &[&str]) -> Value {
    let path = format!("tables/{file}.csv");
    let readings = MEASURE.json(&[&[path.as_str()], arguments].concat());
    readings.into_iter().find(|reading| reading["name"] == name).expect("the table has the column")
}

fn notes(reading: &Value) -> Vec<&str> {
    reading["notes"].as_array().expect("notes").iter().filter_map(Value::as_str).collect()
}

fn has_note(reading: &Value, key: &str, word: &str) -> bool {
    let start = format!("{key}: ");
    notes(reading).iter().any(|note| note.starts_with(&start) && note.contains(word))
}

#[test]
fn without_files_it_reports_the_lamp_it_brings() {
    let readings = MEASURE.json(&[]);
    assert_eq!(readings.len(), 1);
    // CIE L41 by an f64 model of the same rule.
    assert_all_near(&readings[0]["XYZ"], &[100.890778, 100.0, 67.717730], 1e-4);
    assert_near(&readings[0]["cct_k"], 4102.8048, 0.5);
    assert_near(&readings[0]["duv"], -0.00065980, 1e-6);
    assert_near(&readings[0]["ler_lm_per_w"], 316.208166, 3e-4);
}

#[test]
fn keys_stand_in_order_and_every_null_has_a_note_with_its_key() {
    let lamp = &MEASURE.json(&[])[0];
    let surface = &MEASURE.json_with("400 0.1\n700 0.9\n", &["--reflectance", "-"])[0];
    for reading in [lamp, surface] {
        let keys = keys(reading);
        assert!(keys.starts_with(&format!("{KEYS} ")), "{keys}");
        for key in keys.split(' ') {
            assert!(!reading[key].is_null() || has_note(reading, key, ""), "{key} is null without a note");
        }
    }
    let nulls =
        |reading: &Value| KEYS.split(' ').filter(|key| reading[key].is_null()).collect::<Vec<_>>().join(" ");
    assert_eq!(nulls(lamp), "lux lab ppfd");
    assert!(has_note(lamp, "delta_e2000_to_white", "surface") && has_note(lamp, "srgb", "Y = 100"));
    let of_the_light = "cct_k duv lux ler_lm_per_w cri_ra cri_r tm30_rf tm30_rg melanopic_edi_ratio ppfd";
    assert_eq!(nulls(surface), of_the_light);
    assert_eq!(surface["light"], "D65");
    assert_eq!([&lamp["observer"], &lamp["interpolation"], &lamp["unit"]], ["1931", "linear", "relative"]);
}

/// X, Z (Y = 100), CCT, Duv, LER: an f64 model of the reference rule on the same tables.
#[test]
fn standard_illuminants_have_their_values() {
    let expected = [
        ("illuminants/D65_1nm", "D65", [95.0470559, 108.8828736], [6502.71210, 0.003205545], 184.1735541),
        ("illuminants/A_1nm", "A", [109.8503153, 35.5849301], [2855.54269, 0.0], 122.6653775),
        ("illuminants/FL_5nm", "FL11", [100.8994576, 64.2639988], [4000.72873, 0.000154698], 336.8016224),
        ("illuminants/FL_5nm", "FL4", [109.1480781, 38.8131880], [2939.56655, -0.000740443], 370.3363184),
        ("illuminants/LED_5nm", "LED-B3", [100.8618895, 67.6339401], [4102.49576, -0.000600741], 316.8680626),
    ];
    for (file, name, [x, z], [cct_k, duv], ler) in expected {
        let reading = table(file, name, &["--interpolation", "linear"]);
        assert_all_near(&reading["XYZ"], &[x, 100.0, z], 1e-4);
        // 0.01 mired.
        assert_near(&reading["cct_k"], cct_k, cct_k * cct_k * 1e-8);
        assert_near(&reading["duv"], duv, 1e-6);
        assert_near(&reading["ler_lm_per_w"], ler, ler * 1e-6);
    }
}

/// tests/data/03_cri.csv, 03_tm30.csv (1 nm by Sprague) and 07_photometry_sources.csv.
#[test]
fn rendering_and_the_melanopic_ratio_follow_the_goldens() {
    let expected = [
        ("illuminants/D65_1nm", "D65", [99.998897, 99.996847, 99.999875], 1.0),
        ("illuminants/A_1nm", "A", [99.999954, 100.000051, 99.999934], 0.495745331),
        ("illuminants/FL_5nm", "FL4", [51.352457, 56.699733, 83.490979], 0.314957209),
    ];
    for (file, name, [ra, rf, rg], ratio) in expected {
        let reading = table(file, name, &["--interpolation", "sprague"]);
        assert_near(&reading["cri_ra"], ra, 2e-3);
        assert_near(&reading["tm30_rf"], rf, 2e-3);
        assert_near(&reading["tm30_rg"], rg, 2e-3);
        assert_near(&reading["melanopic_edi_ratio"], ratio, 1e-6);
        assert_eq!(numbers(&reading["cri_r"]).len(), 15);
    }
}

/// tests/data/01_xyz_sources.csv: D65 by the 10 degree observer; what is defined for 2 degrees stays.
#[test]
fn another_observer_changes_the_chromaticity_but_not_the_color_temperature() {
    let wide = table("illuminants/D65_1nm", "D65", &["--observer", "1964"]);
    let usual = table("illuminants/D65_1nm", "D65", &[]);
    assert_all_near(&wide["XYZ"], &[94.8110600624, 100.0, 107.304669543], 1e-4);
    assert_all_near(&wide["xy"], &[0.313823646939, 0.33099898549], 1e-6);
    for key in ["cct_k", "duv", "cri_ra", "tm30_rf", "ler_lm_per_w"] {
        assert_eq!(wide[key], usual[key]);
    }
    assert!(has_note(&wide, "observer", "1931"));
    for observer in ["2015-2", "2015-10"] {
        assert_eq!(table("illuminants/D65_1nm", "D65", &["--observer", observer])["observer"], observer);
    }
}

/// tests/data/04_reflectance_colorimetry.csv: test color sample 1, everything by Sprague.
#[test]
fn a_surface_has_the_colors_of_the_goldens() {
    let expected = [
        (
            "D65",
            [32.9934740625, 29.7837492677, 24.5129039112],
            [61.4671856, 17.4881313, 11.8964803],
            [0.72815864, 0.53624894, 0.50291716],
        ),
        (
            "A",
            [42.343049605, 32.7126226392, 7.970592307],
            [63.9275395, 19.3692905, 16.3447383],
            [0.75618515, 0.54562873, 0.49955131],
        ),
        (
            "FL11",
            [37.0655756901, 31.0878185072, 14.5778815321],
            [62.5816973, 19.3038507, 13.5673479],
            [0.74150729, 0.53944372, 0.50382517],
        ),
    ];
    for (light, xyz, lab, srgb) in expected {
        let options = ["--reflectance", "--light", light, "--interpolation", "sprague"];
        let reading = table("samples/cri_tcs14_5nm", "TCS01", &options);
        assert_all_near(&reading["XYZ"], &xyz, 5e-5);
        assert_all_near(&reading["lab"], &lab, 2e-4);
        assert_all_near(&reading["srgb"], &srgb, 4e-6);
        assert_eq!(reading["light"], light);
    }
}

#[test]
fn perfect_white_is_white_under_every_light_and_observer() {
    for light in ["D65", "a", "fl3.1", "LED-B1", "E", "HP1", "FL11_1nm"] {
        for observer in ["1931", "1964", "2015-2", "2015-10"] {
            let options = ["--reflectance", "--light", light, "--observer", observer, "-"];
            let reading = &MEASURE.json_with("400,1\n700,1\n", &options)[0];
            assert_near(&reading["XYZ"][1], 100.0, 1e-4);
            assert_all_near(&reading["lab"], &[100.0, 0.0, 0.0], 2e-4);
            assert_near(&reading["delta_e2000_to_white"], 0.0, 3e-4);
            assert_eq!(reading["hex"], "#ffffff", "{light} {observer}");
            assert!(reading["dominant_wavelength_nm"].is_null());
        }
    }
}

#[test]
fn black_is_a_color_of_surfaces() {
    let reading = &MEASURE.json_with("400,0\n700,0\n", &["--reflectance", "-"])[0];
    assert_all_near(&reading["lab"], &[0.0, 0.0, 0.0], 0.0);
    assert_eq!(reading["hex"], "#000000");
    assert!(reading["xy"].is_null() && has_note(reading, "xy", "black"));
    assert_near(&reading["delta_e2000_to_white"], 100.0, 1e-4);
}

#[test]
fn a_light_may_come_from_a_file() {
    let file = "tables/illuminants/A_1nm.csv";
    let by_file = &MEASURE.json_with("400 .2\n700 .8\n", &["--reflectance", "--light", file, "-"])[0];
    let by_name = &MEASURE.json_with("400 .2\n700 .8\n", &["--reflectance", "--light", "A", "-"])[0];
    assert_eq!(by_file["XYZ"], by_name["XYZ"]);
    assert_eq!(by_file["light"], "A");
}

#[test]
fn absolute_input_has_lux_and_photons() {
    let flat = "360 0.01\n830 0.01\n";
    let reading = &MEASURE.json_with(flat, &["--unit", "absolute", "-"])[0];
    // 683.002 times 0.01 times the sum of V(lambda), 106.856895 (CIE 018).
    assert_near(&reading["lux"], 729.83473, 1e-3);
    assert_near(&reading["XYZ"][1], 729.83473, 1e-3);
    // The integral of the wavelength over h c N_A.
    let photons = |from: f64, to: f64| 0.01 * (to * to - from * from) / 2.0 / 119.626_565_6;
    assert_near(&reading["ppfd"], photons(400.0, 700.0), 1e-5);
    assert_near(&reading["epar"], photons(400.0, 750.0), 1e-5);
    for (band, from, to) in
        [("blue", 400.0, 500.0), ("green", 500.0, 600.0), ("red", 600.0, 700.0), ("far_red", 700.0, 800.0)]
    {
        assert_near(&reading["photons"][band], photons(from, to), 1e-5);
        assert_near(&reading["photon_shares"][band], photons(from, to) / photons(400.0, 700.0), 1e-6);
    }
    assert_near(&reading["r_fr"], 660.0 / 730.0, 1e-6);
    assert_near(&reading["irradiance_w_m2"], 4.7, 1e-9);
    assert_eq!(reading["unit"], "W/m2/nm");
}

/// Melanopic and the others: an f64 model of CIE S 026.
#[test]
fn receptors_have_their_equivalent_daylight() {
    let text = fs::read_to_string("../../tables/illuminants/FL_5nm.csv").expect("a table");
    let reading = &MEASURE.json_with(&text, &["-", "--column", "FL4", "--lux", "500"])[0];
    let light = model::tables::source("FL4")
        .on_cie_grid(model::interpolation::Interpolation::Sprague, model::interpolation::Outside::Zero);
    let ratios = model::photometry::Photometry::of(&light).alpha_opic_der();
    // The ratios are to the illuminance of 380..=780 nm, which has nearly all of it.
    for (receptor, der) in ["s_cone", "m_cone", "l_cone", "rhodopic", "melanopic"].into_iter().zip(ratios) {
        let one = &reading["alpha_opic"][receptor];
        assert_near(&one["der"], der, 1e-6);
        assert_near(&one["edi_lx"], 500.0 * der, 1e-3);
        // CIE S 026: 1 lx of daylight has these mW/m2.
        let daylight = number(&one["irradiance_w_m2"]) / number(&one["edi_lx"]) * 1000.0;
        let published = [0.8173, 1.4558, 1.6289, 1.4497, 1.3262];
        assert!(published.iter().any(|value| (value - daylight).abs() < 1e-4), "{receptor}: {daylight}");
    }
    assert_near(&reading["lux"], 500.0, 1e-4);
    assert_eq!(reading["unit"], "W/m2/nm");
}

#[test]
fn what_a_file_states_beside_its_spectra_is_told() {
    let meter = "Model;X-1\nCCT(K);3182\nnm;lamp\n400;1\n500;2\n700;4\nMemo;good\n";
    let reading = &MEASURE.json_with(meter, &["-"])[0];
    assert_eq!(reading["stated"], serde_json::json!({"Model": "X-1", "CCT(K)": "3182", "Memo": "good"}));
}

#[test]
fn each_unit_has_the_readings_of_its_kind() {
    let flat = "360 0.01\n830 0.01\n";
    // 683.002 times 0.01 times the sum of V(lambda), 106.856895 (CIE 018).
    let luminous = 729.834_73;
    for (unit, key, factor) in [
        ("W/m2/nm", "lux", 1.0),
        ("mW/m2/nm", "lux", 1e-3),
        ("uW/cm2/nm", "lux", 1e-2),
        ("W/m2/sr/nm", "luminance_cd_m2", 1.0),
        ("W/nm", "luminous_flux_lm", 1.0),
        ("mW/sr/nm", "luminous_intensity_cd", 1e-3),
    ] {
        let reading = &MEASURE.json_with(flat, &["--unit", unit, "-"])[0];
        assert_near(&reading[key], luminous * factor, 1e-3 * factor);
        assert_near(&reading["XYZ"][1], luminous * factor, 1e-3 * factor);
        assert_eq!(reading["lux"].is_null(), key != "lux", "{unit}");
        assert_eq!(reading["ppfd"].is_null(), key != "lux", "{unit}");
    }
    let photons: String = (380..=780).map(|nm| format!("{nm},0.01\n")).collect();
    let photons = &MEASURE.json_with(&photons, &["--unit", "umol/m2/s/nm", "-"])[0];
    assert_near(&photons["ppfd"], 3.0, 1e-5);
    let counts = &MEASURE.json_with(flat, &["--unit", "counts", "-"])[0];
    assert!(counts["lux"].is_null() && has_note(counts, "lux", "relative"));
}

#[test]
fn relative_light_is_scaled_to_a_known_reading() {
    let lamp = "nm,lamp\n400,1\n500,3\n600,2\n700,4\n";
    let usual = &MEASURE.json_with(lamp, &["--unit", "absolute", "-"])[0];
    let lux = &MEASURE.json_with(lamp, &["--lux", "250", "-"])[0];
    let factor = 250.0 / number(&usual["lux"]);
    assert_near(&lux["lux"], 250.0, 1e-4);
    assert_near(&lux["ppfd"], number(&usual["ppfd"]) * factor, 1e-5);
    assert_near(&lux["irradiance_w_m2"], number(&usual["irradiance_w_m2"]) * factor, 1e-6);
    assert!(has_note(lux, "data", "scaled to 250 lx"));
    let ppfd = &MEASURE.json_with(lamp, &["--ppfd", "100", "-"])[0];
    assert_near(&ppfd["ppfd"], 100.0, 1e-4);
    assert_near(&ppfd["lux"], number(&usual["lux"]) * 100.0 / number(&usual["ppfd"]), 1e-2);
}

#[test]
fn strength_changes_nothing_but_the_absolute_numbers() {
    let scaled = |power: &str| {
        format!("400 1{power}\n450 5{power}\n500 2{power}\n550 3{power}\n600 4{power}\n700 1{power}\n")
    };
    let usual = &MEASURE.json_with(&scaled("e0"), &["--unit", "absolute", "-"])[0];
    for (power, factor) in [("e-300", 1e-300), ("e-40", 1e-40), ("e12", 1e12), ("e290", 1e290)] {
        let reading = &MEASURE.json_with(&scaled(power), &["--unit", "absolute", "-"])[0];
        assert_near(&reading["lux"], number(&usual["lux"]) * factor, number(&usual["lux"]) * factor * 1e-6);
        for key in ["cct_k", "cri_ra", "tm30_rg", "ler_lm_per_w", "melanopic_edi_ratio"] {
            assert_near(&reading[key], number(&usual[key]), number(&usual[key]) * 2e-6);
        }
    }
}

#[test]
fn separators_line_ends_and_comments_make_no_difference() {
    // But where it was read, and what was assumed of the axis.
    let read = |text: &str| {
        let mut reading = MEASURE.json_with(text, &["-"]).remove(0);
        reading["read"].take();
        reading["stated"].take();
        let notes = reading["notes"].as_array_mut().expect("notes");
        notes.retain(|note| !note.as_str().unwrap_or("").starts_with("read: "));
        reading
    };
    let wanted = read("nm,lamp\n400,1\n500,2.5\n700,0.5\n");
    let variants = [
        "nm;lamp\n400;1\n500;2.5\n700;0.5\n",
        "nm\tlamp\n400\t1\n500\t2.5\n700\t0.5",
        "nm lamp\n  400   1\n500 2.5\n700\t0.5\n",
        "nm,lamp\r\n400,1\r\n500,2.5\r\n700,0.5\r\n",
        "\u{feff}nm,lamp\n400,1\n500,2.5\n700,0.5\n",
        "# a lamp, measured\n\nnm, \"lamp\"\n# here it begins\n400 , 1\n\n5e2 , 25E-1\n7.0e+2 , .5\n",
        "\"wave length\"   lamp\n400 1\n500 2.5\n700 .5\n",
        "\"nm\"\t \"lamp\" \n400\t1\n500\t2.5\n700\t.5\n",
        "\"nm\",\"lamp\"\n\"400\",\"1\"\n\"500\",\"2.5\"\n\"700\",\"0.5\"\n",
    ];
    for variant in variants {
        assert_eq!(read(variant), wanted, "{variant:?}");
    }
}

#[test]
fn spectra_are_named_by_the_heading_or_else_by_the_file() {
    let names = |input: &str, arguments: &[&str]| -> Vec<String> {
        MEASURE
            .json_with(input, arguments)
            .iter()
            .map(|r| r["name"].as_str().unwrap_or("").to_owned())
            .collect()
    };
    assert_eq!(names("nm,\"a, b\",\"say \"\"c\"\"\"\n400,1,2\n500,1,2\n", &["-"]), ["a, b", "say \"c\""]);
    assert_eq!(names("nm;a b;\n400;1;2\n500;1;2\n", &["-"]), ["a b", "stdin:2"]);
    assert_eq!(names("400 1 2\n500 1 2\n", &["-"]), ["stdin:1", "stdin:2"]);
    assert_eq!(names("400 1\n500 2\n", &["-"]), ["stdin"]);
    let directory = MEASURE.scratch("names");
    let (one, two) = (directory.join("lamp.one.csv"), directory.join("two.txt"));
    fs::write(&one, "400 1\n500 1\n").expect("written");
    fs::write(&two, "400 1 1\n500 1 2\n").expect("written");
    let files = [one.to_str().expect("UTF-8"), two.to_str().expect("UTF-8")];
    assert_eq!(names("", &files), ["lamp.one", "two:1", "two:2"]);
}

/// Every tenth nanometer of spectra at 1 nm: white LEDs of the CIE, and the samples of TM-30.
#[test]
fn interpolation_by_default_comes_nearer_than_straight_lines() {
    let coarse = |file: &str| {
        let text = fs::read_to_string(format!("../../tables/{file}.csv")).expect("a table");
        let is_kept = |line: &&str| {
            let nm = line.split(',').next().and_then(|cell| cell.parse::<u32>().ok());
            nm.is_none_or(|nm| nm % 10 == 0 && (380..=780).contains(&nm))
        };
        let rows = text.lines().filter(|line| !line.starts_with('#'));
        let visible = |line: &&str| {
            line.split(',')
                .next()
                .and_then(|cell| cell.parse().ok())
                .is_none_or(|nm| (380..=780).contains(&nm))
        };
        let join = |rows: Vec<&str>| rows.join("\n");
        (join(rows.clone().filter(visible).collect()), join(rows.filter(is_kept).collect()))
    };
    let worst = |key: &str, [whole, coarse]: [&str; 2], options: &[&str]| {
        let [whole, coarse] =
            [whole, coarse].map(|text| MEASURE.json_with(text, &[&["-"], options].concat()));
        let apart = |(a, b): (&Value, &Value)| {
            let squares = numbers(&a[key]).into_iter().zip(numbers(&b[key])).map(|(a, b)| (a - b).powi(2));
            squares.sum::<f64>().sqrt()
        };
        whole.iter().zip(&coarse).map(apart).fold(0.0, f64::max)
    };
    let (whole, coarse_lamps) = coarse("illuminants/LED_1nm");
    let lines = worst("xy", [&whole, &coarse_lamps], &["--interpolation", "linear"]);
    let usual = worst("xy", [&whole, &coarse_lamps], &[]);
    assert!(lines > 5.0 * usual && lines < 1.1e-3 && usual < 1.5e-4, "{lines} and {usual}");
    let (whole, coarse_samples) = coarse("samples/cie224_ces99_1nm");
    let lines = worst("lab", [&whole, &coarse_samples], &["--reflectance", "--interpolation", "linear"]);
    let usual = worst("lab", [&whole, &coarse_samples], &["--reflectance"]);
    assert!(lines > 4.0 * usual && lines < 0.46 && usual < 0.114, "{lines} and {usual}");
}

/// A line 0.2 nm wide has its power wherever it lies; the exact sums are those of an f64 model at 0.1 nm.
#[test]
fn narrow_lines_between_nanometers_keep_their_power() {
    let lamp = |line_nm: f64| {
        let rows = (3800..=7800).map(|tenth| {
            let nm = f64::from(tenth) / 10.0;
            let value = 0.001 + (10.0 - (nm - line_nm).abs() * 50.0).max(0.0);
            format!("{nm:.1},{value}\n")
        });
        MEASURE.json_with(&rows.collect::<String>(), &["-", "--unit", "absolute"]).remove(0)
    };
    let [whole, between] = [532.0, 532.5].map(lamp);
    for (reading, nm) in [(&whole, 532.0), (&between, 532.5)] {
        assert_eq!(reading["interpolation"], "means");
        assert_near(&reading["irradiance_w_m2"], 2.4, 1e-9);
        // 2 W at the line and a thousandth of a watt for each nanometer beside it.
        assert_near(
            &reading["ppfd"],
            (2.0 * nm + 0.001 * (700.0f64.powi(2) - 400.0f64.powi(2)) / 2.0) / 119.626_565_6,
            2e-4,
        );
    }
    // Half of the line counts at each of its two neighbors.
    let v = model::tables::function("cmf/v_photopic_1nm.csv", "V");
    let more = model::photometry::KM * 2.0 * (v[533 - 360] - v[532 - 360]) / 2.0;
    assert_near(&between["lux"], number(&whole["lux"]) + more, 1e-3);
}

#[test]
fn a_table_has_a_row_for_each_spectrum() {
    let lamps = "nm,\"a, b\",=c\n400,1,2\n500,2,1\n700,3,3\n";
    let table = MEASURE.says_to(lamps, &["-", "--csv", "--unit", "mW/m2/nm"]);
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let heading = reader.headers().expect("a heading").clone();
    let rows: Vec<csv::StringRecord> = reader.records().collect::<Result<_, _>>().expect("rows");
    let at = |row: usize, key: &str| {
        let column = heading.iter().position(|name| name == key).unwrap_or_else(|| panic!("{key}"));
        rows[row][column].to_owned()
    };
    assert_eq!((rows.len(), at(0, "name"), at(1, "name")), (2, "a, b".into(), "'=c".into()));
    for (k, reading) in MEASURE.json_with(lamps, &["-", "--unit", "mW/m2/nm"]).iter().enumerate() {
        for (key, value) in [
            ("lux", &reading["lux"]),
            ("XYZ.2", &reading["XYZ"][1]),
            ("alpha_opic.melanopic.edi_lx", &reading["alpha_opic"]["melanopic"]["edi_lx"]),
            ("photons.far_red", &reading["photons"]["far_red"]),
        ] {
            assert_near(value, at(k, key).parse().expect("a number"), 0.0);
        }
    }
}

#[test]
fn notes_say_how_the_samples_were_used() {
    let reading = |input: &str| MEASURE.json_with(input, &["-", "--interpolation", "linear"]).remove(0);
    assert!(has_note(&reading("400 1\n700 1\n"), "data", "400..700 nm; what is outside counts as zero"));
    assert!(has_note(&reading("300 1\n500 1\n900 1\n"), "data", "2 samples outside 360..830"));
    assert!(has_note(&reading("400 1\n500 -0.5\n600 3\n"), "data", "1 negative"));
    // Zero is not negative, and steps of 20 nm are not coarse.
    let dark = reading("400 0\n420 -0.5\n440 0\n460 3\n480 0\n");
    assert!(has_note(&dark, "data", "1 negative values"), "{:?}", notes(&dark));
    assert!(!has_note(&dark, "data", "nm wide"), "{:?}", notes(&dark));
    let coarse = reading("400 0\n420 0.5\n440.5 0\n460 3\n480 0\n");
    assert!(!has_note(&coarse, "data", "negative"), "{:?}", notes(&coarse));
    assert!(has_note(&coarse, "data", "the steps are up to 20.5 nm wide"), "{:?}", notes(&coarse));
    // 499.9 is read for 499 nm, 500.1 for 500 and 501, 500.3 and 500.5 by none, 500.7 for 501.
    let fine = reading("499.9 1\n500.1 1\n500.3 1\n500.5 1\n500.7 1\n501.2 1\n");
    assert!(has_note(&fine, "data", "2 of 6 samples"), "{:?}", notes(&fine));
    assert!(notes(&table("illuminants/L41_1nm", "L41", &[])).iter().all(|note| !note.starts_with("data")));
}

#[test]
fn what_is_no_white_has_no_color_temperature() {
    let green = &MEASURE.json_with("nm,laser\n531,0\n532,1\n533,0\n", &["-"])[0];
    for key in ["cct_k", "duv", "cri_ra", "cri_r", "tm30_rf", "tm30_rg"] {
        assert!(green[key].is_null() && has_note(green, key, ""), "{key}");
    }
    assert_near(&green["dominant_wavelength_nm"], 532.0, 0.01);
    assert_near(&green["purity"], 1.0, 1e-5);
    let magenta = &MEASURE.json_with("440 1\n450 0\n640 0\n650 1\n", &["-"])[0];
    assert!(number(&magenta["dominant_wavelength_nm"]) < 0.0);
}

#[test]
fn a_comparison_is_this_minus_the_other() {
    let warm = ["tables/illuminants/A_1nm.csv", "--compare", "tables/illuminants/D65_1nm.csv"];
    let reading = &MEASURE.json(&warm)[0];
    assert!(keys(reading).starts_with("name compare "), "{}", keys(reading));
    let difference = &reading["compare"];
    assert!(
        keys(difference).starts_with("to delta_cct_k delta_duv delta_tm30_rf delta_e2000 "),
        "{}",
        keys(difference)
    );
    assert_eq!(difference["to"], "D65");
    // Lab of A with D65 as the white, both at Y = 100, and CIEDE2000 of that to the white: by the f64 model.
    let [a, white] = [[109.8503153, 100.0, 35.5849301], [95.0470559, 100.0, 108.8828736]];
    let apart = model::delta_e::de2000(model::lab::lab(a, white), [100.0, 0.0, 0.0]);
    assert_near(&difference["delta_e2000"], apart, 1e-4 * apart);
    assert_near(&difference["delta_cct_k"], 2855.5427 - 6502.7121, 0.5);
    assert_all_near(&difference["delta_xy"], &[0.447573514 - 0.312726871, 0.407439444 - 0.329023207], 1e-6);
    assert_near(&difference["delta_duv"], -0.003205545, 1e-6);
    let same = ["tables/illuminants/A_1nm.csv", "--compare", "tables/illuminants/A_1nm.csv"];
    let nothing = &MEASURE.json(&same)[0]["compare"];
    for (key, value) in
        [("delta_uv1976", 0.0), ("delta_tm30_rf", 0.0), ("spectral_rms", 0.0), ("y_ratio", 1.0)]
    {
        assert_near(&nothing[key], value, 0.0);
    }
    let directory = MEASURE.scratch("compare");
    let gray = directory.join("gray.csv");
    fs::write(&gray, "400 0.4\n700 0.4\n").expect("written");
    let options = ["--reflectance", "--compare", gray.to_str().expect("UTF-8"), "-"];
    let surfaces = &MEASURE.json_with("400 0.5\n700 0.5\n", &options)[0]["compare"];
    assert_near(&surfaces["y_ratio"], 1.25, 1e-6);
    assert_near(&surfaces["spectral_rms"], 0.1, 1e-6);
    // L* of Y = 50 and 40: 76.0693 and 69.4695.
    assert_all_near(&surfaces["delta_lab"], &[6.5998, 0.0, 0.0], 2e-4);
    assert_near(&surfaces["delta_e76"], 6.5998, 2e-4);
}

#[test]
fn pictures_have_safe_and_different_names() {
    let directory = MEASURE.scratch("pictures");
    let pictures = directory.join("made/here");
    let input = "nm,a/b,A_B,<&>,..\n400,1,2,3,1\n500,2,1,1,1\n600,1,1,2,1\n";
    MEASURE.says_to(input, &["-", "--svg", pictures.to_str().expect("UTF-8")]);
    let names = files(&pictures);
    assert_eq!(names, ["A_B-2.svg", "___.svg", "a_b.svg", "spectrum.svg"]);
    for name in names {
        let text = fs::read_to_string(pictures.join(name)).expect("a text");
        assert!(text.starts_with("<svg") && text.trim_end().ends_with("</svg>"));
        assert!(!text.contains("<&>") && !text.contains("NaN"));
    }
}

#[test]
fn a_piped_report_is_plain_text_whatever_the_names_hold() {
    for arguments in [&["-"][..], &["-", "--json"], &["-", "--reflectance"]] {
        let report = MEASURE.says_to("nm,\"\u{1b}[31mred\u{7}\"\n400,1\n700,0.5\n", arguments);
        assert!(report.chars().all(|c| c == '\n' || !c.is_control()), "{report:?}");
    }
}

#[test]
fn wavelengths_that_f32_would_round_are_read_as_they_are() {
    let line = "nm,v\n545.3,0\n545.7,.3\n546.1,1\n546.5,.3\n546.9,0\n";
    let found = &MEASURE.json_with(line, &["-", "--unit", "absolute", "--interpolation", "linear"])[0];
    // By the rule in f64: 546 nm reads 0.825 and nothing else is on a whole nanometer.
    for (value, expected) in numbers(&found["XYZ"]).into_iter().zip([210.787_543, 554.513_089, 6.934_837]) {
        assert!((value / expected - 1.0).abs() < 3e-7, "{value} for {expected}");
    }
}

#[test]
fn sprague_reads_such_wavelengths_as_the_model_does() {
    let lamp = model::tables::source("FL11");
    let shifted = model::interpolation::Samples::new(380.1, 5.0, lamp.values.clone());
    let lines: String = shifted.points().iter().map(|(nm, value)| format!("{nm:.1} {value}\n")).collect();
    let found = &MEASURE.json_with(&lines, &["-", "--interpolation", "sprague"])[0];
    let (expected, _) = model::tristimulus::xyz_of_light(
        &shifted,
        model::tables::Observer::Cie1931,
        model::tristimulus::Method::SpragueZero,
    );
    for (value, expected) in numbers(&found["XYZ"]).into_iter().zip(expected) {
        assert!((value / expected - 1.0).abs() < 5e-7, "{value} for {expected}");
    }
}
