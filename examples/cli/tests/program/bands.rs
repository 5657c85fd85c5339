//! Spectra of bands, which are averages: what paint prints and measure reads keeps its color.

use crate::run::{Program, assert_near, numbers};
use nanospectra::color::{EncodedRgb, Rgb, Srgb, Xyz, ciede2000};
use nanospectra::light::D65;
use nanospectra::observer::CIE_1931;
use nanospectra::upsample::Viewing;
use nanospectra::{Curve, Nodes};
use nanospectra_cli::output::table::cell;

const MEASURE: Program = Program("measure", module_path!());
const PAINT: Program = Program("paint", module_path!());
const SCENE: Program = Program("scene", module_path!());

const GRIDS: [&str; 8] = [
    "nodes:31,400,700",
    "nodes:36,380,730",
    "nodes:81,380,780",
    "bins:16,380,730",
    "bins:31,380,730",
    "bins:36,380,730",
    "bins:60,380,730",
    "bins:60,400,700",
];

/// The promise of the status "exact".
const PROMISED: f32 = 0.002;

#[test]
fn a_painted_spectrum_gives_its_color_back_when_it_is_measured() {
    let colors = ["0.8,0.2,0.1", "0.1,0.6,0.9", "0.9,0.8,0.05", "0.5,0.5,0.5", "0.02,0.3,0.1"];
    // The RGB space has the white of the lamp itself, and not the one that its standard rounds to four
    // digits.
    let viewing: Viewing<81, Nodes<380, 780>> = Viewing::new(&CIE_1931.under(&D65.fine()).fold(Curve::Step));
    let white = viewing.xyz(Rgb::new(1.0, 1.0, 1.0));
    for grid in GRIDS {
        let table = PAINT.says(&[&["--csv", "--grid", grid], &colors[..]].concat());
        let answers = PAINT.json(&[&["--grid", grid], &colors[..]].concat());
        let readings = MEASURE.json_with(&table, &["--reflectance", "-"]);
        assert_eq!(readings.len(), colors.len());
        for ((reading, answer), color) in readings.iter().zip(&answers).zip(colors) {
            assert_eq!((&reading["interpolation"], &answer["status"]), (&"averages".into(), &"exact".into()));
            for (read, seen) in numbers(&reading["XYZ"]).iter().zip(numbers(&answer["lights"][0]["XYZ"])) {
                assert!((read - seen).abs() < 1e-5 * seen, "{read} is not {seen} for {color} on {grid}");
            }
            let [r, g, b] =
                std::array::from_fn(|k| color.split(',').nth(k).expect("three").parse().expect("a number"));
            let asked = viewing.xyz(EncodedRgb::<Srgb>::new(r, g, b).decode());
            let xyz = numbers(&reading["XYZ"]);
            let found = Xyz::new(xyz[0] as f32, xyz[1] as f32, xyz[2] as f32);
            let [asked, found] = [asked, found].map(|xyz| xyz.lab(white).expect("a white"));
            let apart = ciede2000(asked, found);
            assert!(apart < PROMISED, "{color} on {grid} is {apart} off");
        }
    }
}

/// Under another lamp, too, measure sees what paint shows.
#[test]
fn averages_are_seen_alike_under_every_lamp() {
    let table = PAINT.says(&["--csv", "0.8,0.2,0.1", "--grid", "bins:16,380,730"]);
    let answer = &PAINT.json(&["0.8,0.2,0.1", "--grid", "bins:16,380,730", "--light", "FL11"])[0];
    let reading = &MEASURE.json_with(&table, &["--reflectance", "--light", "FL11", "-"])[0];
    for (read, seen) in numbers(&reading["XYZ"]).iter().zip(numbers(&answer["lights"][1]["XYZ"])) {
        assert!((read - seen).abs() < 1e-5 * seen, "{read} is not {seen}");
    }
}

#[test]
fn averages_of_a_light_end_at_the_outer_edges() {
    // Two bands of 100 nm, which reach from 450 to 550 and from 550 to 650 nm.
    let light = |heading: &str| {
        MEASURE.json_with(&format!("{heading},a\n500,1\n600,3\n"), &["--unit", "absolute", "-"]).remove(0)
    };
    let steps: String = (360..=830)
        .map(|nm| {
            format!(
                "{nm},{}\n",
                match nm {
                    451..550 => "1",
                    551..650 => "3",
                    450 => "0.5",
                    550 => "2",
                    650 => "1.5",
                    _ => "0",
                }
            )
        })
        .collect();
    let model = &MEASURE.json_with(&format!("nm,a\n{steps}"), &["--unit", "absolute", "-"])[0];
    for key in ["lux", "ppfd", "cct_k"] {
        assert_near(
            &light("band-nm")[key],
            model[key].as_f64().expect("a number"),
            1e-9 * model[key].as_f64().expect("a number").abs(),
        );
        assert_ne!(light("nm")[key], light("BAND-NM")[key]);
    }
    assert!(light("band-nm")["notes"].to_string().contains("averages over bands"));
}

/// A scene reads the same table, as a surface.
#[test]
fn a_scene_reads_averages() {
    let table = PAINT.says(&["--csv", "0.8,0.2,0.1", "--grid", "bins:16,380,730"]);
    let path = SCENE.file("bands.csv", &table);
    let answer = SCENE.written(
        "bands",
        &format!("grid = \"bins:16,380,730\"\n[lamp]\ncie = \"D65\"\n[[part]]\nsurface.csv = '{path}'\n"),
    );
    let ratio: Vec<f64> = numbers(&answer["leaving_spectrum"])
        .iter()
        .zip(numbers(&answer["lamp_spectrum"]))
        .map(|(a, b)| a / b)
        .collect();
    let painted = numbers(&PAINT.json(&["0.8,0.2,0.1", "--grid", "bins:16,380,730"])[0]["spectrum"]);
    for (read, painted) in ratio.iter().zip(painted) {
        assert!((read - painted).abs() < 1e-5, "{read} is not {painted}");
    }
}

#[test]
fn names_in_a_table_are_no_formulas() {
    for (name, expected) in [
        ("=1+2", "'=1+2"),
        ("+a", "'+a"),
        ("-a", "'-a"),
        ("@a", "'@a"),
        ("\ta", "\"'\ta\""),
        ("\ra", "\"'\ra\""),
        ("=a,\"b\"", "\"'=a,\"\"b\"\"\""),
        ("red", "red"),
        ("a,b", "\"a,b\""),
        (" a", "\" a\""),
    ] {
        assert_eq!(cell(name), expected);
    }
    let table = PAINT.says(&["--csv", "--rgb", "-0.1,0.5,0.4"]);
    let heading = table.lines().find(|line| line.starts_with("band-nm")).expect("a heading");
    assert_eq!(heading, "band-nm,srgb -0.1 0.5 0.4");
}
