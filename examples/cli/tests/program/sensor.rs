//! What the command sensor says of known lamps, and of the files that tell it about the chip.

use crate::run::{Program, number};
use nanospectra::color::Xyz;
use nanospectra::observer::{CIE_1931, KM};
use nanospectra::radiometry::ppfd;
use nanospectra::sensor::chip::{self, as7262, as7265x, as7341, as7343};
use nanospectra::{Fine, Power, light};
use nanospectra_cli::sensor::simulate;
use serde_json::Value;

const SENSOR: Program = Program("sensor", module_path!());

fn assert_near(what: &str, value: &Value, expected: f64, tolerance: f64) {
    let found = number(value);
    assert!((found - expected).abs() <= tolerance, "{what}: {found} is not {expected} within {tolerance}");
}

fn has_note(reading: &Value, word: &str) -> bool {
    reading["notes"].as_array().is_some_and(|notes| notes.iter().any(|note| note.to_string().contains(word)))
}

fn labeled<'a>(readings: &'a [Value], label: &str) -> &'a Value {
    readings.iter().find(|reading| reading["label"] == label).unwrap_or_else(|| panic!("no {label}"))
}

fn xyz(light: &Fine<Power>) -> Xyz {
    Xyz::from(CIE_1931.sees(light).map(|sum| KM * sum))
}

/// A log of an AS7341 at gain 8, 50 ms, of lights without noise.
fn log_of(lights: &[(String, Fine<Power>)]) -> String {
    let mut log = "label,gain,atime,astep,f1,f2,f3,f4,f5,f6,f7,f8\n".to_owned();
    for (label, light) in lights {
        let counts = simulate::basic(light).map(|basic| (basic * 8.0 * 50.04).round().to_string()).join(",");
        log += &format!("{label},8,29,599,{counts}\n");
    }
    log
}

/// How near nominal Gaussians, which the simulated chip has, and the smoothest spectrum bring a lamp: no more
/// can be had without calibration. Tolerances: xy, share of the color temperature, Duv, share of Y.
const NEAR: [(&str, [f64; 4]); 6] = [
    ("A", [0.002, 0.006, 0.001, 0.01]),
    ("D65", [0.002, 0.012, 0.001, 0.01]),
    ("FL2", [0.004, 0.012, 0.003, 0.01]),
    ("FL11", [0.014, 0.08, 0.003, 0.05]),
    ("LED-B3", [0.006, 0.015, 0.003, 0.01]),
    ("HP1", [0.012, 0.06, 0.004, 0.02]),
];

#[test]
fn known_lamps_have_nearly_their_colors() {
    let readings = SENSOR.json(&[]);
    for ((label, name, lux), (same, [xy, share, duv, of_y])) in simulate::LAMPS.into_iter().zip(NEAR) {
        assert_eq!(label, same);
        let reading = labeled(&readings, label);
        let truth = xyz(&simulate::lamp(name, lux));
        let (at, uv) = (truth.xy().expect("a color"), truth.uv1960().expect("a color"));
        let (cct_k, true_duv) = uv.cct().near().expect("a white");
        println!(
            "{label}: x {:+.4} y {:+.4} CCT {:+.0} K Duv {:+.4}",
            number(&reading["xy"][0]) - f64::from(at.x),
            number(&reading["xy"][1]) - f64::from(at.y),
            number(&reading["cct_k"]) - f64::from(cct_k),
            number(&reading["duv"]) - f64::from(true_duv)
        );
        assert_near(label, &reading["xy"][0], at.x.into(), xy);
        assert_near(label, &reading["xy"][1], at.y.into(), xy);
        assert_near(label, &reading["cct_k"], cct_k.into(), share * f64::from(cct_k));
        assert_near(label, &reading["duv"], true_duv.into(), duv);
        let y = f64::from(lux) / 683.002 * simulate::COUNTS_PER_W;
        assert_near(label, &reading["XYZ"][1], y, of_y * y);
        assert_eq!([&reading["status"], &reading["cct"], &reading["unit"]], ["ok", "near", "relative"]);
        assert!(reading["lux"].is_null() && reading["ppfd"].is_null());
        assert!(has_note(reading, "NOMINAL") && has_note(reading, "Y is relative"));
        let uncertainty = &reading["uncertainty"];
        assert!((1.0..25.0).contains(&number(&uncertainty["cct_k"])), "{uncertainty}");
        assert!(number(&uncertainty["XYZ"][1]) < 0.005 * number(&reading["XYZ"][1]), "{uncertainty}");
        let bins = reading["spectrum"].as_array().expect("a spectrum").len();
        assert!(bins > 30 && reading["wavelengths_nm"].as_array().expect("nm").len() == bins);
    }
}

#[test]
fn what_is_no_measurement_says_so() {
    let readings = SENSOR.json(&[]);
    let dark = labeled(&readings, "dark");
    assert_eq!(dark["status"], "too dark");
    assert!(dark["XYZ"].is_null() && dark["cct_k"].is_null() && dark["next"]["same"] == true);
    let bright = labeled(&readings, "D65 at a gain too high");
    assert_eq!(bright["status"], "saturated");
    assert_eq!(bright["saturated"].as_array().map(Vec::len), Some(8));
    assert_eq!(bright["counts"]["f1"], 18_000);
    assert!(number(&bright["next"]["gain"]) <= 4.0);
    let green = labeled(&readings, "green LED");
    assert_eq!([&green["status"], &green["cct"]], ["ok", "off the locus"]);
    assert!(green["cct_k"].is_null() && green["duv"].is_null() && green["uncertainty"]["cct_k"].is_null());
    // One brighter channel is one name.
    let one =
        SENSOR.json_with("gain,atime,astep,f1,f2,f3,f4,f5,f6,f7,f8\n8,29,599,1,1,1,1,18000,1,1,1\n", &["-"]);
    assert_eq!(one[0]["saturated"], serde_json::json!(["f5"]));
}

#[test]
fn flicker_is_found_at_its_frequency_and_averages_to_its_duty() {
    let run = SENSOR.json(&[]).pop().expect("a run at the end");
    assert_eq!([&run["kind"], &run["label"]], ["run", "PWM"]);
    assert_near("rate", &run["rate_hz"], 999.2, 0.01);
    let at = &run["flicker"][0];
    let mean = simulate::PWM_DUTY * 1500.0 / 683.002 * simulate::COUNTS_PER_W;
    assert_near("mean", &at["mean"], mean, 0.01 * mean);
    assert_near("percent flicker", &at["percent"], 100.0, 0.1);
    assert_near("flicker index", &at["index"], 1.0 - simulate::PWM_DUTY, 0.01);
    // 2 sin(pi d) / (pi d), of which readings of 1 ms show 98.4 %; the 9th and 11th harmonic fold onto it.
    assert_near("amplitude", &at["amplitude"], 1.489, 0.045);
    assert!(number(&run["flicker"][1]["amplitude"]) < 0.8);
    let slow = SENSOR.json_with(
        "time,gain,atime,astep,f1,f2,f3,f4,f5,f6,f7,f8\n\
         0,8,29,599,90,90,90,90,90,90,90,90\n1,8,29,599,90,90,90,90,90,90,90,90\n",
        &["-"],
    );
    assert_eq!(slow[2]["flicker"][0]["note"], "needs 200 or more readings a second");
}

/// A photodiode as a sensor of one channel. Its light jumps by 0.6832 %, 17.6 times a second, and swings by 11 % with
/// 100 Hz: Pst LM is 1 by IEC TR 61547-1, and SVM is 0.11 / 0.2563 by IEC TR 63158.
#[test]
fn a_run_has_the_severity_of_its_flicker() {
    let matrix = SENSOR.file("photodiode.csv", "row,light\nX,1\nY,1\nZ,1\n");
    let arguments = ["--sensor", "custom", "-", "--calibration", &matrix];
    let log = |rate_hz: f64, readings: usize| {
        let row = |k: usize| {
            let time = k as f64 / rate_hz;
            let up = if (8.8 * time).fract() < 0.5 { 1.0 } else { -1.0 };
            let ripple = 1.0 - 0.11 * (std::f64::consts::TAU * 100.0 * time).cos();
            format!("{time},1,1,1000000000,{}\n", (5e7 * ripple * (1.0 + up * 0.003_416)).round())
        };
        format!("time,gain,time_ms,full_scale,light\n{}", (0..readings).map(row).collect::<String>())
    };
    let long = log(500.0, 16_000);
    let run = SENSOR.json_with(&long, &arguments).pop().expect("a run at the end");
    assert_near("Pst LM", &run["pst_lm"], 1.0, 0.01);
    assert!(run.get("note").is_none() && run["flicker"][0]["svm"].is_null(), "{run}");
    let text = SENSOR.says_to(&long, &arguments);
    assert!(text.contains("Pst LM 0.99") || text.contains("Pst LM 1.00"), "{}", &text[text.len() - 900..]);
    let fast = log(5000.0, 1000);
    let run = SENSOR.json_with(&fast, &arguments).pop().expect("a run at the end");
    assert_near("SVM", &run["flicker"][0]["svm"], 0.11 / 0.2563, 0.005);
    assert!(run["pst_lm"].is_null() && run["notes"][0] == "pst_lm: needs readings of 30 s or more", "{run}");
    let text = SENSOR.says_to(&fast, &arguments);
    assert!(text.contains("Pst LM unknown (needs readings of 30 s or more)") && text.contains("SVM 0.43"));
}

#[test]
fn a_slow_log_says_which_rates_the_measures_need() {
    let run = SENSOR.json(&[]).pop().expect("a run at the end");
    let notes = run["notes"].to_string();
    assert!(notes.contains("pst_lm: needs readings of 30 s or more"), "{notes}");
    assert!(notes.contains("flicker.svm: needs 4000 or more readings a second"), "{notes}");
    let text = SENSOR.says(&[]);
    assert!(text.contains("SVM unknown (needs 4000 or more readings a second)"), "{text}");
    let slow = "time,gain,atime,astep,f1,f2,f3,f4,f5,f6,f7,f8\n\
                0,8,29,599,90,90,90,90,90,90,90,90\n1,8,29,599,90,90,90,90,90,90,90,90\n";
    let run = SENSOR.json_with(slow, &["-"]).pop().expect("a run at the end");
    assert!(run["notes"].to_string().contains("pst_lm: needs 400 to 50000 readings a second"), "{run}");
}

#[test]
fn steps_of_time_are_equal_to_two_hundredths() {
    let run = |middle: &str| {
        let rows = ["0", middle, "2"].map(|time| format!("{time},8,29,599,90,90,90,90,90,90,90,90\n"));
        let log = format!("time,gain,atime,astep,f1,f2,f3,f4,f5,f6,f7,f8\n{}", rows.concat());
        SENSOR.json_with(&log, &["-"]).pop().expect("a run at the end")
    };
    for middle in ["1", "1.019", "0.981"] {
        assert_near(middle, &run(middle)["rate_hz"], 1.0, 1e-6);
    }
    for middle in ["1.021", "0.979"] {
        let run = run(middle);
        assert!(
            run["rate_hz"].is_null() && run.to_string().contains("the steps of time are not equal"),
            "{run}"
        );
    }
}

#[test]
fn measured_responsivities_give_lux_and_photons() {
    // The simulated chip's own, in basic counts for each W/m2, every 3 nm.
    let mut text = "nm,f8,f7,f6,f5,f4,f3,f2,f1\n".to_owned();
    for nm in (360..=830).step_by(2) {
        let cells = as7341::NOMINAL.weights().map(|row| f64::from(row[nm - 360]) * simulate::COUNTS_PER_W);
        let cells: Vec<String> = cells.iter().rev().map(f64::to_string).collect();
        text += &format!("{nm},{}\n", cells.join(","));
    }
    let path = SENSOR.file("responsivity.csv", &text);
    let readings = SENSOR.json(&["--responsivity", &path, "--unit", "absolute"]);
    let relative = SENSOR.json(&["--responsivity", &path]);
    let nominal = SENSOR.json(&[]);
    for (label, name, lux) in simulate::LAMPS {
        let reading = labeled(&readings, label);
        println!("{label}: {} lx, {} umol/m2/s", reading["lux"], reading["ppfd"]);
        assert_near(label, &reading["lux"], lux.into(), 0.05 * f64::from(lux));
        let photons = f64::from(ppfd(&simulate::lamp(name, lux)));
        assert_near(label, &reading["ppfd"], photons, 0.06 * photons);
        assert_eq!(reading["responsivities"], "file");
        let cct_k = number(&labeled(&nominal, label)["cct_k"]);
        assert_near(label, &reading["cct_k"], cct_k, 0.002 * cct_k);
        assert!(labeled(&relative, label)["lux"].is_null());
        assert!(!has_note(reading, "NOMINAL"));
    }
}

#[test]
fn measured_patches_give_lux_and_color_of_lamps_that_were_not_among_them() {
    // Lamps that are not in the log, among them kin of those that are.
    let names = [
        "D50", "D75", "C", "FL1", "FL3", "FL4", "FL7", "FL9", "FL10", "FL12", "FL3.4", "FL3.9", "HP2", "HP3",
        "HP4", "LED-B1", "LED-B2", "LED-B4", "LED-B5", "LED-RGB1", "LED-V1", "LED-V2", "LED-BH1", "ID50",
    ];
    let mut text = "f1,f2,f3,f4,f5,f6,f7,f8,X,Y,Z\n".to_owned();
    for name in names {
        let lamp = simulate::lamp(name, 250.0);
        let basic = simulate::basic(&lamp).map(|basic| basic.to_string()).join(",");
        let [x, y, z] = xyz(&lamp).to_array();
        text += &format!("{basic},{x},{y},{z}\n");
    }
    let path = SENSOR.file("patches.csv", &text);
    let readings = SENSOR.json(&["--calibration", &path]);
    for (label, name, lux) in simulate::LAMPS {
        let reading = labeled(&readings, label);
        let truth = xyz(&simulate::lamp(name, lux)).uv1960().expect("a color").cct();
        let (cct_k, _) = truth.near().expect("a white");
        println!("{label}: {} lx for {lux}, {} K for {cct_k}", reading["lux"], reading["cct_k"]);
        assert_near(label, &reading["lux"], lux.into(), 0.04 * f64::from(lux));
        assert_near(label, &reading["cct_k"], cct_k.into(), 0.03 * f64::from(cct_k));
        assert_eq!(reading["unit"], "absolute");
        assert!(has_note(reading, "24 patches") && has_note(reading, "left out"));
        assert!(has_note(reading, "condition") && !has_note(reading, "Y is relative"));
        assert!(number(&reading["ppfd"]) > 0.0);
    }
    assert!(SENSOR.json(&["--calibration", &path, "--unit", "relative"])[0]["lux"].is_null());
}

#[test]
fn a_matrix_is_multiplied_as_it_stands() {
    let path = SENSOR.file("matrix.csv", "row,a,b\nY,1,2\nX,3,4\nZ,5,6\n");
    let log = "time_ms;gain;full_scale;b;a\n10;2;1000;200;100\n";
    let reading = &SENSOR.json_with(log, &["--sensor", "custom", "--calibration", &path, "-"])[0];
    // Basic counts 5 and 10.
    assert_eq!(reading["XYZ"], serde_json::json!([55.0, 25.0, 85.0]));
    assert_eq!(reading["lux"], 25.0);
    assert_eq!(reading["basic_counts"], serde_json::json!({"b": 10.0, "a": 5.0}));
    assert!(reading["spectrum"].is_null() && reading["next"].is_null());
    // Rounding alone: sqrt(1/12) counts, of which 20 are a basic count.
    assert_near("lux", &reading["uncertainty"]["lux"], (5.0_f64 / 12.0).sqrt() / 20.0, 1e-6);
    assert!(has_note(reading, "rounding"));
    let noisy =
        ["--electrons-per-count", "50", "--read-counts", "3", "--sensor", "custom", "--calibration", &path];
    let noisy = &SENSOR.json_with(log, &[&noisy[..], &["-"]].concat())[0];
    let variance = |count: f64| count * 2.0 / 50.0 + 9.0 + 1.0 / 12.0;
    let expected = (variance(100.0) + 4.0 * variance(200.0)).sqrt() / 20.0;
    assert_near("lux", &noisy["uncertainty"]["lux"], expected, 1e-5);
    assert!(!has_note(noisy, "rounding"));
    let negative = SENSOR.file("negative.csv", "row,a,b\nX,1,2\nY,3,4\nZ,5,-6\n");
    let reading = &SENSOR.json_with(log, &["--sensor", "custom", "--calibration", &negative, "-"])[0];
    assert_eq!(reading["status"], "negative");
    assert!(reading["cct_k"].is_null() && reading["lux"].is_null() && reading["XYZ"][2] == -35.0);
}

#[test]
fn dark_counts_come_off_from_columns_or_from_a_file() {
    let heading = "gain,atime,astep,f1,f2,f3,f4,f5,f6,f7,f8";
    let dark_heading = "dark_f1,dark_f2,dark_f3,dark_f4,dark_f5,dark_f6,dark_f7,dark_f8";
    let wanted =
        &SENSOR.json_with(&format!("{heading}\n8,29,599,100,200,300,400,500,600,700,800\n"), &["-"])[0];
    let log = format!("{heading}\n8,29,599,105,206,307,408,509,610,711,812\n");
    let columns = log.replace(heading, &format!("{heading},{dark_heading}"));
    let columns = columns.replace(",812", ",812,5,6,7,8,9,10,11,12");
    let plain = SENSOR.file("dark.csv", "f1,f2,f3,f4,f5,f6,f7,f8\n4,5,6,7,8,9,10,11\n6,7,8,9,10,11,12,13\n");
    let exposed = "8,29,599,5,6,7,8,9,10,11,12\n16,29,599,50,60,70,80,90,100,110,120\n";
    let exposed = SENSOR.file("dark_exposed.csv", &format!("{heading}\n{exposed}"));
    let from_columns = &SENSOR.json_with(&columns, &["-"])[0];
    let from_file = &SENSOR.json_with(&log, &["--dark", &plain, "-"])[0];
    let from_exposed = &SENSOR.json_with(&log, &["--dark", &exposed, "-"])[0];
    for reading in [from_columns, from_file, from_exposed] {
        assert_eq!(reading["basic_counts"], wanted["basic_counts"]);
        assert_eq!(reading["xy"], wanted["xy"]);
        let [more, less] = [reading, wanted].map(|reading| number(&reading["uncertainty"]["XYZ"][1]));
        assert!(more > less, "a dark reading is noisy too");
    }
    let other = log.replace("8,29", "4,29");
    let outcome = SENSOR.run_with(other.as_bytes(), &["--dark", &exposed, "-"]);
    assert!(outcome.code == Some(2) && outcome.err.contains("line 2 of the log"), "{}", outcome.err);
}

#[test]
fn every_chip_sees_equal_energy_as_nearly_white() {
    let flat = light::named("E").expect("equal energy");
    let counts =
        |values: &[f32]| values.iter().map(|value| (value * 400.0).round().to_string()).collect::<Vec<_>>();
    let eleven = counts(&as7343::NOMINAL.sees(&flat));
    let six = counts(&as7262::NOMINAL.sees(&flat));
    let wide = counts(&as7265x::NOMINAL.sees(&nanospectra::Spectrum::flat(1.0)));
    let nm = "410,435,460,485,510,535,560,585,610,645,680,705,730,760,810,860,900,940";
    let cases = [
        ("as7343", "gain,atime,astep,f1,f2,fz,f3,f4,f5,fy,fxl,f6,f7,f8", "0.5,199,599", &eleven),
        ("as7262", "cycles,gain,v,b,g,y,o,r", "18,3.7", &six),
        ("as7265x", &format!("gain,cycles,{nm}"), "64,255", &wide),
    ];
    for (chip, heading, settings, counts) in cases {
        let log = format!("{heading}\n{settings},{}\n", counts.join(","));
        let reading = &SENSOR.json_with(&log, &["--sensor", chip, "-"])[0];
        println!("{chip}: {}", reading["xy"]);
        assert_near(chip, &reading["xy"][0], 1.0 / 3.0, 0.02);
        assert_near(chip, &reading["xy"][1], 1.0 / 3.0, 0.02);
        assert!(has_note(reading, "NOMINAL"));
    }
}

/// Of a chip that the library lists the program needs to be told nothing.
#[test]
fn every_chip_of_the_library_is_read() {
    let help = SENSOR.says(&["--help"]);
    for chip in chip::ALL {
        let name = chip.name.to_lowercase();
        let columns = chip.settings.iter().map(|setting| setting.name).chain(chip.channels.iter().copied());
        let settings = chip.ladder.first().copied().unwrap_or_default().iter();
        let counts = chip.channels.iter().map(|_| 40.0);
        let log = columns.collect::<Vec<_>>().join(",")
            + "\n"
            + &settings.copied().chain(counts).map(|value| value.to_string()).collect::<Vec<_>>().join(",")
            + "\n";
        let ones = |row: &str| format!("{row}{}\n", ",1".repeat(chip.channels.len()));
        let matrix = format!("row,{}\n{}", chip.channels.join(","), ["X", "Y", "Z"].map(ones).concat());
        let matrix = SENSOR.file(&format!("{name}.csv"), &matrix);
        let reading = &SENSOR.json_with(&log, &["--sensor", &name, "--calibration", &matrix, "-"])[0];
        assert_eq!((&reading["sensor"], &reading["status"]), (&chip.name.into(), &"ok".into()), "{log}");
        assert_eq!(reading["next"].is_null(), chip.ladder.is_empty(), "{name}");
        assert!(help.contains(&format!("{name} ")) && help.contains(chip.summary), "{name}");
    }
}

#[test]
fn the_opt4048_has_the_makers_matrix() {
    let log = "ch0,ch1,ch2\n100000,200000,50000\n";
    let reading = &SENSOR.json_with(log, &["--sensor", "opt4048", "-"])[0];
    assert_near("lux", &reading["lux"], 430.0, 0.01);
    assert_near("X", &reading["XYZ"][0], 23.489_299_2 + 8.149_348_8 + 4.643_097, 1e-4);
    assert_eq!(reading["responsivities"], "unknown");
    assert!(reading["spectrum"].is_null());
}

#[test]
fn separators_line_ends_and_the_order_of_columns_make_no_difference() {
    let wanted =
        &SENSOR.json_with("gain,atime,astep,f1,f2,f3,f4,f5,f6,f7,f8\n8,29,599,1,2,3,4,50,6,7,8\n", &["-"])[0];
    let variants = [
        "gain;atime;astep;f1;f2;f3;f4;f5;f6;f7;f8\n8;29;599;1;2;3;4;50;6;7;8\n",
        "gain\tatime\tastep\tf1\tf2\tf3\tf4\tf5\tf6\tf7\tf8\r\n8\t29\t599\t1\t2\t3\t4\t50\t6\t7\t8",
        "\u{feff}GAIN, ATime, astep, F8, f7, f6, f5, f4, f3, f2, f1\n8.0, 29, 5.99e2, 8, 7, 6, 50, 4, 3, 2, 1\n",
    ];
    for variant in variants {
        let found = &SENSOR.json_with(variant, &["-"])[0];
        for key in ["counts", "exposure", "XYZ", "spectrum", "uncertainty", "next"] {
            assert_eq!(found[key], wanted[key], "{variant:?}");
        }
    }
    let more = "nir,clear,gain,atime,astep,f1,f2,f3,f4,f5,f6,f7,f8,temperature_c\n9,9,8,29,599,1,2,3,4,50,6,7,8,21.5\n";
    let found = &SENSOR.json_with(more, &["-"])[0];
    assert!(has_note(found, "these columns are not used: nir, clear") && found["temperature_c"] == 21.5);
}

#[test]
fn answers_come_in_the_order_of_the_log_and_none_is_lost() {
    let lights: Vec<_> =
        ["FL11", "A", "D65", "HP1"].map(|name| (name.to_owned(), simulate::lamp(name, 500.0))).into();
    let mut log = log_of(&lights);
    log += "# a remark\n\ndark,8,29,599,0,0,0,0,0,0,0,0\n";
    let readings = SENSOR.json_with(&log, &["-"]);
    let labels: Vec<&str> = readings.iter().filter_map(|reading| reading["label"].as_str()).collect();
    assert_eq!(labels, ["FL11", "A", "D65", "HP1", "dark"]);
    assert_eq!(readings[4]["line"], 8);
    let text = SENSOR.says_to(&log, &["-"]);
    for word in ["NOMINAL", "TOO DARK", "relative", "FL11", "next", "notes"] {
        assert!(text.contains(word), "{word} in {text}");
    }
}

#[test]
fn a_pipe_that_is_closed_is_no_error() {
    SENSOR.assert_may_be_left_unread(&SENSOR.says(&["--simulate"]), &["--json", "-"]);
}
