//! Small files of each form.

use crate::{AxisUnit, Kind, Options, Quantity, Reading, Refusal, Setting, read};

/// Ten points of a transmittance, with other data.
fn file(data: &str) -> String {
    format!(
        "##TITLE= filter $$ one of two\n##JCAMP-DX= 4.24\n##DATA TYPE= UV/VIS SPECTRUM\n##ORIGIN= A\n\
         ##XUNITS= NANOMETERS\n##YUNITS= TRANSMITTANCE\n##XFACTOR= 0.5\n##YFACTOR= 0.01\n##FIRSTX= 400\n\
         ##LASTX= 418\n##DELTAX= 2\n##NPOINTS= 10\n##FIRSTY= 0.1\n##XYDATA= (X++(Y..Y))\n{data}\n##END=\n"
    )
}

fn reading(text: &str) -> Result<Reading, Refusal> {
    read(text.as_bytes(), &Options::default())
}

#[test]
fn all_forms_are_read() {
    for data in [
        "800 10 11 12 13 14\n820 15 14 13 13 13",
        "800+10+11+12+13+14\n820+15+14+13+13+13",
        "800A0A1A2A3A4\n820A5A4A3U",
        "800A0JJJJ\n816A4Jjj%T",
        "800A0JV\n816A4Jjj%T",
    ] {
        let reading = reading(&file(data)).unwrap_or_else(|refusal| panic!("{data}: {refusal}"));
        let curve = &reading.curves[0];
        assert_eq!(curve.name.as_deref(), Some("filter"));
        assert_eq!(curve.wavelengths, [400.0, 402.0, 404.0, 406.0, 408.0, 410.0, 412.0, 414.0, 416.0, 418.0]);
        let percent: Vec<f64> = curve.values.iter().map(|value| (value * 100.0).round()).collect();
        assert_eq!(percent, [10.0, 11.0, 12.0, 13.0, 14.0, 15.0, 14.0, 13.0, 13.0, 13.0], "{data}");
        assert_eq!(curve.unit.map(|unit| (unit.quantity, unit.factor)), Some((Quantity::Transmittance, 1.0)));
        assert_eq!(curve.line_range(), 14..=16);
        assert!(reading.facts.iter().any(|fact| fact.name == "ORIGIN" && fact.line == 4));
    }
}

#[test]
fn pairs_are_read() {
    for (form, data) in [
        ("XYPOINTS= (XY..XY)", "800, 10\n802.5, 20\n\n810, 30"),
        ("XYPOINTS= (XY..XY)", "800,10; 802.5,20; 810,30"),
        ("XYDATA= (XY..XY)", "800 10 802.5 20\n810 30 $$ the last"),
    ] {
        let text = file(data).replace("XYDATA= (X++(Y..Y))", form).replace("NPOINTS= 10", "NPOINTS= 3");
        let curve = reading(&text).unwrap().curves.remove(0);
        assert_eq!(curve.wavelengths, [400.0, 401.25, 405.0]);
        assert_eq!(curve.values, [0.1, 0.2, 0.3]);
    }
}

#[test]
fn units_of_both_axes_are_read() {
    let data = "800 10 11 12 13 14\n820 15 14 13 13 13";
    let text =
        file(data).replace("NANOMETERS", "1/CM").replace("400\n", "20000\n").replace("418\n", "20018\n");
    let text = text.replace("800 ", "40000 ").replace("820 ", "40020 ");
    let curve = reading(&text).unwrap().curves.remove(0);
    assert_eq!(curve.axis, AxisUnit::PerCentimeter);
    assert!((curve.wavelengths[9] - 500.0).abs() < 1e-9 && curve.values[9] == 0.1);
    for (said, quantity, factor) in [
        ("REFLECTANCE", Quantity::Reflectance, 1.0),
        ("% TRANSMITTANCE", Quantity::Transmittance, 0.01),
        ("ARBITRARY UNITS", Quantity::Relative, 1.0),
        ("W/m2/nm", Quantity::Irradiance, 1.0),
    ] {
        let curve = reading(&file(data).replace("TRANSMITTANCE", said)).unwrap().curves.remove(0);
        assert_eq!(curve.unit.map(|unit| (unit.quantity, unit.factor)), Some((quantity, factor)), "{said}");
    }
    let percent = reading(&file(data).replace("YFACTOR= 0.01", "YFACTOR= 1")).unwrap();
    assert!((percent.curves[0].values[0] - 0.1).abs() < 1e-12);
    assert!(percent.notes.iter().any(|note| note.setting == Some(Setting::Percent)));
    let unknown = reading(&file(data).replace("TRANSMITTANCE", "Logarithm epsilon")).unwrap();
    assert!(unknown.notes.iter().any(|note| note.kind == Kind::Assumed && note.what.contains("epsilon")));
}

#[test]
fn blocks_are_read_one_by_one() {
    let block = file("800 10 11 12 13 14\n820 15 14 13 13 13");
    let peaks = "##TITLE= peaks\n##XUNITS= NANOMETERS\n##PEAK TABLE= (XY..XY)\n400,1\n410,2\n##END=\n";
    let linked = format!("##TITLE= both\n##DATA TYPE= LINK\n##BLOCKS= 3\n{block}{peaks}{block}##END=\n");
    let reading = reading(&linked).unwrap();
    assert_eq!(reading.curves.len(), 2);
    assert!(
        reading.notes.iter().any(|note| note.kind == Kind::LeftOut && note.what.contains("table of peaks"))
    );
}

#[test]
fn the_loose_form_is_read() {
    let text = "##TITLE= A\n##XUNITS= NANOMETERS\n##YUNITS= ABSORBANCE\n##XYPOINTS= (XY..XY)\n380, 0.1\n390, 0.2\n##END=";
    assert_eq!(reading(text).unwrap_err().setting, Some(Setting::Absorbance));
    let curve = reading(&text.replace("ABSORBANCE", "TRANSMITTANCE")).unwrap().curves.remove(0);
    assert_eq!(curve.unit.map(|unit| unit.quantity), Some(Quantity::Transmittance));
    assert_eq!(curve.values, [0.1, 0.2]);
}

#[test]
fn what_is_no_light_is_refused_by_name() {
    let data = "800 10 11 12 13 14\n820 15 14 13 13 13";
    let refusal = |from: &str, to: &str| reading(&file(data).replace(from, to)).unwrap_err();
    assert!(refusal("UV/VIS", "NMR").what.contains("NMR SPECTRUM"));
    assert!(refusal("NANOMETERS", "M/Z").what.contains("M/Z"));
    assert!(refusal("TRANSMITTANCE", "KUBELKA-MUNK").what.contains("Kubelka"));
    assert!(refusal("XYDATA= (X++(Y..Y))", "PEAK TABLE= (XY..XY)").what.contains("peaks"));
    assert!(refusal("(X++(Y..Y))", "(X++(R..R))").what.contains("R..R"));
    assert!(reading("##TITLE= a\n##JCAMP-DX= 5\n##END=\n").is_err());
}

#[test]
fn faults_are_refused_with_their_lines() {
    let line = |text: String| reading(&text).unwrap_err().line;
    let data = "800 10 11 12 13 14\n820 15 14 13 13 13";
    assert_eq!(line(file("800 10 11 12 13 14\n820 15 14 13 13")), Some(12));
    assert_eq!(line(file("800 10 11 12 13 14\n810 15 14 13 13 13")), Some(16));
    assert_eq!(line(file("800A0J\n802A2JJJJJJJJ")), Some(16));
    assert_eq!(line(file(data).replace("LASTX= 418", "LASTX= x")), Some(10));
    assert_eq!(line(file(data).replace("15 14", "15 *")), Some(16));
    let odd = file("800, 10\n802").replace("XYDATA= (X++(Y..Y))", "XYPOINTS= (XY..XY)");
    assert_eq!(line(odd), Some(16));
}

#[test]
fn no_cut_panics() {
    let text = file("800A0JV\n816A4Jjj%T") + &file("800 10 1.1E+1 12 13 14\n820 15 14 13 13 13");
    for end in 0..text.len() {
        let _ = reading(&text[..end]);
    }
}
