//! Each layout is read as the lamp that it holds, and the reader says what it assumed.

use crate::layouts::{FIRST, LAST, all, lamp};
use nanospectra_files::{By, Kind, Options, Unit, read};

#[test]
fn every_layout_is_the_lamp() {
    for layout in all() {
        let name = layout.name;
        let reading =
            read(&layout.bytes, &Options::default()).unwrap_or_else(|refusal| panic!("{name}: {refusal}"));
        let names: Vec<Option<&str>> = reading.curves.iter().map(|curve| curve.name.as_deref()).collect();
        assert_eq!(names, layout.names, "{name}");
        for curve in &reading.curves {
            assert_eq!(curve.wavelengths.len(), (LAST - FIRST + 1) as usize, "{name}");
            for ((nm, at), value) in (FIRST..=LAST).zip(&curve.wavelengths).zip(&curve.values) {
                assert!((at / f64::from(nm) - 1.0).abs() < 1e-9, "{name}: {at} is not {nm}");
                let expected = lamp(nm) * layout.factor;
                assert!(
                    (value - expected).abs() <= 1e-9 * expected.abs(),
                    "{name}: {value} is not {expected} at {nm}"
                );
            }
            assert_eq!(curve.unit.map(|unit| unit.written()).as_deref(), layout.unit, "{name}");
            assert_eq!(curve.unit_by == By::Nobody, layout.unit.is_none(), "{name}");
            assert!(!curve.origin().is_empty());
        }
        for words in layout.notes {
            assert!(
                reading.notes.iter().any(|note| note.what.contains(words)),
                "{name}: {:?}",
                reading.notes
            );
        }
        let assumed = reading.notes.iter().filter(|note| note.kind == Kind::Assumed).count();
        assert!(assumed <= layout.notes.len(), "{name}: {:?}", reading.notes);
    }
}

#[test]
fn curves_say_where_they_were_read() {
    let text = "Model;X\nWave [nm];a;E [mW/m2/nm]\n400;1;2\n410;1;2\n\n420;1;2\n";
    let reading = read(text.as_bytes(), &Options::default()).expect("two curves");
    assert_eq!(reading.curves[1].origin(), "lines 3..6, column 3 of 3, mW/m2/nm by 'E [mW/m2/nm]'");
    assert_eq!(*reading.curves[1].lines, [3, 4, 6]);
    assert_eq!(reading.curves[0].origin(), "lines 3..6, column 2 of 3, no unit");
    assert_eq!((reading.facts[0].name.as_str(), reading.facts[0].value.as_str()), ("Model", "X"));
    let options = Options { unit: Unit::parse("uW/cm2/nm"), ..Options::default() };
    let reading = read(b"nm,a\n400,1\n410,3\n", &options).expect("a curve");
    assert_eq!(reading.curves[0].origin(), "lines 2..3, column 2 of 2, uW/cm2/nm by the option");
    assert_eq!(reading.curves[0].values, [0.01, 0.03]);
}

/// Bands from one wavelength to another, and those whose edges lie half way between.
#[test]
fn averages_have_the_edges_of_their_bands() {
    let edges =
        |text: &str| read(text.as_bytes(), &Options::default()).expect("a curve").curves[0].edges.clone();
    assert_eq!(edges("400 410 1\n410 420 2\n420 440 3\n"), Some(vec![400.0, 410.0, 420.0, 440.0]));
    assert_eq!(edges("band-nm,a\n400,1\n410,2\n430,3\n"), Some(vec![395.0, 405.0, 420.0, 440.0]));
    assert_eq!(edges("nm,a\n400,1\n410,2\n430,3\n"), None);
}

#[test]
fn gaps_are_left_out_and_dead_columns_too() {
    let text = "nm,a,b,c,d\n400,1,0,,5\n410,NaN,0,,6\n420,3,0,,7\n430,4,0,,\n";
    let reading = read(text.as_bytes(), &Options::default()).expect("two curves");
    let found: Vec<_> =
        reading.curves.iter().map(|curve| (curve.name.as_deref(), curve.values.clone())).collect();
    assert_eq!(found, [(Some("a"), vec![1.0, 3.0, 4.0]), (Some("d"), vec![5.0, 6.0, 7.0])]);
    for words in ["'a' has no value in 1 of 4", "'d' has no value in 1 of 4", "'b' is zero", "'c' is empty"] {
        assert!(reading.notes.iter().any(|note| note.what.contains(words)), "{words}: {:?}", reading.notes);
    }
}

#[test]
fn a_heading_that_says_something_unknown_has_a_note() {
    let reading = read(b"nm,lamp (flurbs/m2)\n400,1\n410,2\n", &Options::default()).expect("a curve");
    assert!(
        reading.notes.iter().any(|note| note.what.contains("'flurbs/m2' of the heading")),
        "{:?}",
        reading.notes
    );
}
