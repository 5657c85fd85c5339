//! Small files of each shape.

use crate::{AxisUnit, Kind, Options, Quantity, Reading, Refusal, Setting, read};

fn reading(text: &str) -> Result<Reading, Refusal> {
    read(text.as_bytes(), &Options::default())
}

const SHAPES: [&str; 26] = [
    r#"{"wavelength": [380, 390, 400], "a": [0.1, 0.2, 0.3]}"#,
    r#"{"wavelengths": ["380", "390", "400"], "a": ["0.1", "0,2", "0.3"]}"#,
    r#"{"name": "a", "x": [380, 390, 400], "y": [0.1, 0.2, 0.3]}"#,
    r#"{"a": {"nm": [380, 390, 400], "values": [0.1, 0.2, 0.3]}}"#,
    r#"[{"wavelength": 380, "a": 0.1}, {"wavelength": 390, "a": 0.2}, {"wavelength": 400, "a": 0.3}]"#,
    r#"{"a": [{"x": 380, "y": 0.1}, {"x": 390, "y": 0.2}, {"x": 400, "y": 0.3}]}"#,
    r#"{"a": [[380, 0.1], [390, 0.2], [400, 0.3]]}"#,
    r#"[["nm", "a"], [380, 0.1], [390, 0.2], [400, 0.3]]"#,
    r#"{"a": [[380, 390, 400], [0.1, 0.2, 0.3]]}"#,
    r#"{"380": {"a": 0.1}, "390": {"a": 0.2}, "400": {"a": 0.3}}"#,
    r#"{"a": {"380": [0.1], "390": [0.2], "400": [0.3]}}"#,
    r#"{"0": {"nm": 380, "a": 0.1}, "1": {"nm": 390, "a": 0.2}, "2": {"nm": 400, "a": 0.3}}"#,
    r#"{"a": {"380": 0.1, "390": 0.2, "400": 0.3}}"#,
    r#"{"name": "a", "390nm": 0.2, "380nm": 0.1, "400nm": 0.3}"#,
    r#"{"spectra": [{"name": "a", "unit": "W/m2/nm", "wavelengths": [380, 390, 400], "values": [0.1, 0.2, 0.3]}]}"#,
    r#"{"wavelengths": [380, 390, 400], "spectra": {"a": [0.1, 0.2, 0.3]}}"#,
    r#"{"wavelengths": [380, 390, 400], "spectra": [{"name": "a", "values": [0.1, 0.2, 0.3]}]}"#,
    r#"{"name": "a", "start": 380, "step": 10, "values": [0.1, 0.2, 0.3]}"#,
    r#"{"name": "a", "start_nm": 380, "end_nm": 400, "values": [0.1, 0.2, 0.3]}"#,
    r#"{"wavelengthStart": 380, "wavelengthEnd": 400, "interval": 10, "a": [0.1, 0.2, 0.3]}"#,
    r#"{"wavelength": {"0": 380, "1": 390, "2": 400}, "a": {"0": 0.1, "1": 0.2, "2": 0.3}}"#,
    r#"{"wl": [400, 390, 380], "a": [0.3, 0.2, 0.1], "flags": [true, false, true]}"#,
    r#"{"meta": {"CCT": 3000}, "data": {"lamp": {"wavelength_nm": [380, 390, 400], "name": "a", "spd": [0.1, 0.2, 0.3]}}}"#,
    r#"[{"wavelength": "380", "a": "0.1"}, {"wavelength": "390", "a": "0.2"}, {"wavelength": "400", "a": "0.3"}]"#,
    r#"{"name": "a", "wavelength": [380, 390, 400], "values": [0.1, 0.2, 0.3], "xy": [0.3, 0.4]}"#,
    r#"{"name": "a", "x_unit": "nm", "x": [380, 390, 400], "values": [0.1, 0.2, 0.3]}"#,
];

#[test]
fn every_shape_is_read() {
    for text in SHAPES {
        let reading = reading(text).unwrap_or_else(|refusal| panic!("{text}: {refusal}"));
        let curve = &reading.curves[0];
        assert_eq!(reading.curves.len(), 1, "{text}");
        assert_eq!(curve.wavelengths, [380.0, 390.0, 400.0], "{text}");
        assert_eq!(curve.values, [0.1, 0.2, 0.3], "{text}");
        assert_eq!(curve.name.as_deref(), Some("a"), "{text}");
    }
}

#[test]
fn several_spectra_have_their_names() {
    for (text, names) in [
        (r#"{"nm": [380, 390], "a": [1, 2], "b": [3, 4]}"#, ["a", "b"]),
        (r#"[{"nm": 380, "a": 1, "b": 3}, {"nm": 390, "a": 2, "b": 4}]"#, ["a", "b"]),
        (r#"[["nm", "a", "b"], [380, 1, 3], [390, 2, 4], [400, 2, 5]]"#, ["a", "b"]),
        (r#"{"a": {"nm": [380, 390], "v": [1, 2]}, "b": {"nm": [400, 410], "v": [1, 2]}}"#, ["a", "b"]),
        (r#"{"380": {"a": 1, "b": 2}, "390": {"a": 3, "b": 4}}"#, ["a", "b"]),
        (r#"{"380": [1, 2], "390": [3, 4]}"#, ["1", "2"]),
        (r#"{"nm": [380, 390], "lamps": [[1, 2], [3, 4]]}"#, ["lamps 1", "lamps 2"]),
        (r#"{"name": "L", "nm": [380, 390], "dark": [1, 2], "light": [3, 4]}"#, ["L dark", "L light"]),
        (r#"[[[380, 1], [390, 2]], [[380, 1], [390, 3]]]"#, ["spectrum 1", "spectrum 2"]),
    ] {
        let reading = reading(text).unwrap_or_else(|refusal| panic!("{text}: {refusal}"));
        let found: Vec<&str> = reading.curves.iter().filter_map(|curve| curve.name.as_deref()).collect();
        assert_eq!(found, names, "{text}");
    }
}

#[test]
fn units_are_read() {
    let unit = |text: &str| reading(text).unwrap().curves[0].unit.map(|unit| (unit.quantity, unit.factor));
    assert_eq!(
        unit(r#"{"nm": [380, 390], "v": [1, 2], "unit": "mW/m2/nm"}"#),
        Some((Quantity::Irradiance, 1e-3))
    );
    let inside = r#"{"units": {"nm": "nm", "v": "W/m2/sr/nm"}, "nm": [380, 390], "v": [1, 2]}"#;
    assert_eq!(unit(inside), Some((Quantity::Radiance, 1.0)));
    assert_eq!(unit(r#"{"nm": [380, 390], "reflectance": [0.5, 2]}"#), Some((Quantity::Reflectance, 1.0)));
    assert_eq!(
        unit(r#"{"nm": [380, 390], "irradiance (W/m2/nm)": [1, 2]}"#),
        Some((Quantity::Irradiance, 1.0))
    );
    let percent = reading(r#"{"nm": [380, 390], "reflectance": [50, 60]}"#).unwrap();
    assert_eq!(percent.curves[0].values, [0.5, 0.6]);
    assert!(percent.notes.iter().any(|note| note.setting == Some(Setting::Percent)));
    let micrometers =
        reading(r#"{"wavelength_unit": "um", "wavelength": [0.5, 0.75], "v": [1, 2]}"#).unwrap();
    assert_eq!(
        (micrometers.curves[0].axis, micrometers.curves[0].wavelengths[0]),
        (AxisUnit::Micrometer, 500.0)
    );
    let unknown = reading(r#"{"nm": [380, 390], "v": [1, 2], "unit": "furlongs"}"#).unwrap();
    assert!(unknown.notes.iter().any(|note| note.kind == Kind::Assumed && note.what.contains("furlongs")));
}

#[test]
fn facts_and_missing_values_are_kept() {
    let text =
        r#"{"device": {"CCT": 3012.5, "model": "M1"}, "nm": [380, 390, 400, 410], "v": [1, null, NaN, 2]}"#;
    let reading = reading(text).unwrap();
    assert!(reading.facts.iter().any(|fact| fact.name == "device.CCT" && fact.value == "3012.5"));
    assert_eq!(
        (&reading.curves[0].wavelengths[..], &reading.curves[0].values[..]),
        (&[380.0, 410.0][..], &[1.0, 2.0][..])
    );
    assert!(reading.notes.iter().any(|note| note.kind == Kind::LeftOut && note.what.contains("2 of 4 rows")));
}

#[test]
fn what_is_no_spectrum_is_refused_with_its_place() {
    let what = |text: &str| reading(text).unwrap_err().what;
    assert!(
        what(r#"{"spectra": [{"nm": [380, 390, 400], "values": [1, 2]}]}"#)
            .contains("spectra[0].values has 2")
    );
    assert!(what("[0.1, 0.2, 0.3]").contains("no wavelengths"));
    assert!(what(r#"{"0": {"r": 1, "u": 2}, "1": {"r": 2, "u": 3}}"#).contains("no spectrum"));
    assert!(what("{}").contains("no spectrum"));
    assert!(what(r#"[{"nm": 380, "v": 1}, {"v": 2}]"#).contains("[1]"));
    assert!(what(r#"{"start": 380, "end": 400, "step": 5, "values": [1, 2, 3]}"#).contains("steps of 5"));
    let deep = format!("{}{}{}", "{\"a\":".repeat(20), "1", "}".repeat(20));
    assert!(what(&deep).contains("levels"));
    assert_eq!(reading("{\n\"nm\": [380,\n}").unwrap_err().line, Some(3));
}

#[test]
fn no_cut_panics() {
    for text in SHAPES {
        for end in 0..text.len() {
            assert!(reading(&text[..end]).is_err(), "{}", &text[..end]);
        }
    }
}
