//! What only the user can know is asked, and what is no spectrum is refused.

use nanospectra_files::{AxisUnit, Choice, Options, Setting, Unit, read};

/// A text, the setting that settles it, and a word of what is said.
const REFUSED: &[(&str, Option<Setting>, &str)] = &[
    ("", None, "no row of numbers"),
    ("dear reader\nthis is a letter\n", None, "no row of numbers"),
    ("nm,a\n500,1\n", None, "too few samples"),
    ("380,0,604\n381,0,061\n382,0,599\n", None, "commas"),
    ("nm,a\n400,1\n410,2\n410,3\n", None, "410 nm twice"),
    ("nm,a\n400,1\n420,2\n410,3\n", None, "sort the rows"),
    ("nm,a\n400,1\n410,2\nnan,3\n", None, "wavelength is missing"),
    ("nm,a\n400,1\n410,2\ninfinity,3\n", None, "wavelength is missing"),
    ("nm,a\n400,1\n410,2\n42O,3\n", None, "no row of it"),
    ("nm,a\n400,1\n410,2\n42O,3\n430,4\n440,5\n", None, "no row of it"),
    ("nm,a\n400,1\n,2\n420,3\n", None, "wavelength is missing"),
    ("nm,a\n400,1\n410,SAT\n420,3\n", Some(Setting::Column), "'SAT'"),
    ("nm,a\n400,1\n410,-999\n420,3\n", Some(Setting::Missing), "-999"),
    ("nm,a\n400,1\n410,-1.23e34\n420,3\n", Some(Setting::Missing), "nothing was measured"),
    ("3800,1\n3900,2\n4000,3\n", Some(Setting::AxisUnit), "not stated"),
    (".38,1\n.39,2\n.40,3\n", Some(Setting::AxisUnit), "not stated"),
    ("1,5\n2,6\n3,7\n4,8\n", Some(Setting::Column), "counts the rows"),
    ("THz,a\n400,1\n410,2\n", Some(Setting::Density), "per THz"),
    ("nm,Absorbance\n400,1\n410,2\n", Some(Setting::Absorbance), "absorbance"),
    ("nm,E (W/m2)\n400,1\n410,2\n", Some(Setting::Unit), "per nm"),
    ("nm,a,b\n400,,\n410,,\n420,,\n", None, "no row of numbers"),
];

#[test]
fn what_is_not_clear_is_refused_with_what_settles_it() {
    for (text, setting, word) in REFUSED {
        let refusal = read(text.as_bytes(), &Options::default()).expect_err(text);
        assert_eq!(refusal.setting, *setting, "{text:?}: {refusal}");
        assert!(refusal.what.contains(word), "{text:?}: {refusal}");
    }
}

#[test]
fn the_settings_settle_it() {
    let none = Options::default();
    let cases = [
        ("3800,1\n3900,2\n", Options { axis: Some(AxisUnit::Angstrom), ..none.clone() }, [1.0, 2.0]),
        ("nm,a\n400,1\n405,-999\n410,2\n", Options { missing: Some(-999.0), ..none.clone() }, [1.0, 2.0]),
        (
            "nm,Absorbance\n400,1\n410,2\n",
            Options { unit: Unit::parse("absorbance"), ..none.clone() },
            [0.1, 0.01],
        ),
        ("nm,E (W/m2)\n400,1\n410,2\n", Options { unit: Unit::parse("W/m2/nm"), ..none.clone() }, [1.0, 2.0]),
        ("nm,a\n400,10\n410,20\n", Options { percent: true, ..none.clone() }, [0.1, 0.2]),
        ("nm,R%\n400,10\n410,20\n", Options { is_ratio: true, ..none.clone() }, [0.1, 0.2]),
        (
            "7,400,1\n9,410,2\n",
            Options {
                axis_column: Some(Choice::Number(2)),
                columns: vec![Choice::Number(3)],
                ..none.clone()
            },
            [1.0, 2.0],
        ),
        (
            "nm,a,b\n400,5,1\n410,6,2\n",
            Options { columns: vec![Choice::Name("b".into())], ..none },
            [1.0, 2.0],
        ),
    ];
    for (text, options, values) in cases {
        let reading = read(text.as_bytes(), &options).unwrap_or_else(|refusal| panic!("{text:?}: {refusal}"));
        assert_eq!(reading.curves.len(), 1, "{text:?}");
        assert_eq!(reading.curves[0].values, values, "{text:?}");
    }
}

#[test]
fn other_kinds_of_files_are_named() {
    for (start, word) in [
        (&b"%PDF-1.7"[..], "PDF"),
        (b"\x1f\x8b\x08", "gzip"),
        (b"\x89PNG\r\n", "picture"),
        (b"\xd0\xcf\x11\xe0", ".xls"),
    ] {
        let refusal = read(start, &Options::default()).expect_err("no spectrum");
        assert!(refusal.what.contains(word) && refusal.what.contains(';'), "{refusal}");
    }
}
