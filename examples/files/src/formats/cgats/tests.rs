//! Small files of each program.

use crate::{Kind, Options, Quantity, Reading, Refusal, Setting, read};

fn reading(text: &str) -> Result<Reading, Refusal> {
    read(text.as_bytes(), &Options::default())
}

const PAPER: &str = "CGATS.17\nORIGINATOR\t\"A\"\nNUMBER_OF_FIELDS\t6\nBEGIN_DATA_FORMAT\n\
    SAMPLE_ID\tSAMPLE_NAME\tLAB_L\tSPECTRAL_NM380\tSPECTRAL_NM390\tSPECTRAL_NM400\nEND_DATA_FORMAT\n\
    NUMBER_OF_SETS\t2\nBEGIN_DATA\n1\t50% cyan\t60\t29.5\t29.75\t30\n2\tP2\t70\t49.5\t0.75\t50\nEND_DATA\n";

#[test]
fn each_row_is_a_curve() {
    let reading = reading(PAPER).unwrap();
    let [one, two] = &reading.curves[..] else { panic!() };
    assert_eq!((one.name.as_deref(), two.name.as_deref()), (Some("50% cyan"), Some("P2")));
    assert_eq!(one.wavelengths, [380.0, 390.0, 400.0]);
    assert_eq!(one.values, [0.295, 0.2975, 0.3]);
    assert_eq!(one.unit.map(|unit| unit.quantity), Some(Quantity::Reflectance));
    assert_eq!((one.line_range(), two.line_range()), (9..=9, 10..=10));
    let percent = reading.notes.iter().find(|note| note.setting == Some(Setting::Percent)).unwrap();
    assert_eq!(percent.kind, Kind::Assumed);
    assert!(reading.notes.iter().any(|note| note.kind == Kind::LeftOut && note.what.contains("LAB_L")));
    assert!(
        reading.facts.iter().any(|fact| fact.name == "ORIGINATOR" && fact.value == "A" && fact.line == 2)
    );
}

#[test]
fn parts_of_one_and_spellings_of_fields_are_read() {
    for (first, second, third) in [
        ("nm380", "nm390", "nm400"),
        ("SPECTRAL_NM_380", "SPECTRAL_NM_390", "SPECTRAL_NM_400"),
        ("R_380", "R_390", "R_400"),
        ("380nm", "390nm", "400nm"),
        ("SPECTRAL_380", "SPECTRAL_390", "SPECTRAL_400"),
        ("380", "390", "400"),
        ("SPECTRAL_DEC380", "SPECTRAL_DEC390", "SPECTRAL_DEC400"),
    ] {
        let text = PAPER.replace("SPECTRAL_NM380", first).replace("SPECTRAL_NM390", second);
        let text = text.replace("SPECTRAL_NM400", third).replace("29.5\t29.75\t30", "0.1\t0,2\t0.3");
        let text = text.replace("49.5\t0.75\t50", "0.4\t0.5\t0.6");
        let reading = reading(&text).unwrap();
        assert_eq!(reading.curves[0].values, [0.1, 0.2, 0.3], "{first}");
        assert_eq!(reading.curves[0].wavelengths, [380.0, 390.0, 400.0], "{first}");
        let assumed = reading.notes.iter().any(|note| note.setting == Some(Setting::Percent));
        assert_eq!(assumed, !first.starts_with("SPECTRAL_DEC"), "{first}");
    }
}

#[test]
fn rows_that_state_their_wavelengths_are_read() {
    let text = "CGATS.17\nBEGIN_DATA_FORMAT\nSAMPLE_ID SPECTRAL_NM SPECTRAL_PCT SPECTRAL_NM SPECTRAL_PCT\n\
                END_DATA_FORMAT\nBEGIN_DATA\nA1 380 1.5 390 1\nEND_DATA\n";
    let reading = reading(text).unwrap();
    assert_eq!(
        (&reading.curves[0].wavelengths[..], reading.curves[0].values[0]),
        (&[380.0, 390.0][..], 0.015)
    );
}

/// A lamp in a file of ArgyllCMS, whose names of fields are rounded.
fn sp(head: &str) -> String {
    format!(
        "SPECT\n\nDESCRIPTOR \"my lamp, 5% \"\nKEYWORD \"SPECTRAL_BANDS\"\nSPECTRAL_BANDS \"4\"\n\
         SPECTRAL_START_NM \"380.0\"\nSPECTRAL_END_NM \"390.0\"\n{head}\nNUMBER_OF_FIELDS 4\nBEGIN_DATA_FORMAT\n\
         SPEC_380 SPEC_383 SPEC_387\nSPEC_390\nEND_DATA_FORMAT\n# data\nNUMBER_OF_SETS 1\nBEGIN_DATA\n10 20\n30 \
         40\nEND_DATA\n"
    )
}

#[test]
fn steps_are_more_exact_than_names() {
    let reading = reading(&sp("SPECTRAL_NORM \"1.0\"")).unwrap();
    let curve = &reading.curves[0];
    assert!((curve.wavelengths[1] - 383.333_333).abs() < 1e-5);
    assert_eq!((curve.values.clone(), curve.unit), (vec![10.0, 20.0, 30.0, 40.0], None));
    assert_eq!((curve.name.as_deref(), curve.line_range()), (Some("my lamp, 5%"), 17..=18));
}

#[test]
fn names_are_right_where_steps_are_wrong() {
    let reading = reading(&sp("").replace("START_NM \"380.0\"", "START_NM \"355.0\"")).unwrap();
    assert_eq!(reading.curves[0].wavelengths, [380.0, 383.0, 387.0, 390.0]);
    assert!(reading.notes.iter().any(|note| note.kind == Kind::Assumed && note.what.contains("355")));
}

#[test]
fn the_head_says_what_is_measured() {
    for (head, quantity, factor, first) in [
        ("MEAS_TYPE \"EMISSION\"", Quantity::Radiance, 1e-3, 0.01),
        ("MEAS_TYPE \"AMBIENT\"", Quantity::Irradiance, 1e-3, 0.01),
        ("MEAS_TYPE \"AMBIENT_FLASH\"", Quantity::Relative, 1.0, 10.0),
        ("MEAS_TYPE \"REFLECTIVE\"\nSPECTRAL_NORM \"100.0\"", Quantity::Reflectance, 0.01, 0.1),
        ("MEAS_TYPE \"TRANSMISSIVE\"\nSPECTRAL_NORM \"50\"", Quantity::Transmittance, 1.0, 0.2),
        ("DEVICE_CLASS \"OUTPUT\"\nSPECTRAL_NORM \"100.0\"", Quantity::Reflectance, 0.01, 0.1),
        ("DEVICE_CLASS \"OUTPUT\"", Quantity::Reflectance, 0.01, 0.1),
        ("DEVICE_CLASS \"DISPLAY\"", Quantity::Radiance, 1e-3, 0.01),
        ("DEVICE_CLASS \"DISPLAY\"\nNORMALIZED_TO_Y_100 \"YES\"", Quantity::Relative, 1.0, 10.0),
    ] {
        let curve = reading(&sp(head)).unwrap().curves.remove(0);
        let unit = curve.unit.unwrap();
        assert_eq!((unit.quantity, unit.factor), (quantity, factor), "{head}");
        assert!((curve.values[0] / first - 1.0).abs() < 1e-12, "{head}: {}", curve.values[0]);
    }
    let lamp = reading(&sp("SPECTRAL_NORM \"100\"")).unwrap();
    assert_eq!((lamp.curves[0].values[0], lamp.curves[0].unit), (0.1, None));
    assert!(lamp.notes.iter().any(|note| note.kind == Kind::Stated && note.what.contains("100")));
    let ccss = reading(&sp("").replace("SPECT\n", "CCSS\n")).unwrap();
    assert_eq!(ccss.curves[0].unit.map(|unit| unit.quantity), Some(Quantity::Relative));
    let light = PAPER.replace("ORIGINATOR\t\"A\"", "MEASUREMENT_TYPE\t\"Emission\"");
    assert_eq!(reading(&light).unwrap().curves[0].unit, None);
}

#[test]
fn several_tables_are_read() {
    let second = "CTI3\n\nBEGIN_DATA_FORMAT\nRGB_R XYZ_X\nEND_DATA_FORMAT\nBEGIN_DATA\n1 2\nEND_DATA\n";
    let both = format!("{PAPER}{second}{}", PAPER.replace("P2", "P3"));
    let reading = reading(&both).unwrap();
    assert_eq!(reading.curves.len(), 4);
    assert_eq!(reading.curves[3].name.as_deref(), Some("P3"));
}

#[test]
fn faults_are_refused_with_their_lines() {
    let line = |text: String| reading(&text).unwrap_err().line;
    assert_eq!(line(PAPER.replace("29.75", "high")), Some(9));
    assert_eq!(line(PAPER.replace("\t0.75\t", "\t")), Some(10));
    assert_eq!(line(PAPER.replace("FIELDS\t6", "FIELDS\t7")), Some(6));
    assert_eq!(line(PAPER.replace("SETS\t2", "SETS\t3")), Some(7));
    assert_eq!(line(PAPER.replace("END_DATA\n", "")), Some(8));
    assert_eq!(line(PAPER.replace("END_DATA_FORMAT\n", "")), Some(4));
    assert_eq!(line(PAPER.replace("SPECTRAL_NM", "XYZ_")), Some(4));
    assert_eq!(line(sp("SPECTRAL_NORM \"0\"")), Some(8));
    assert_eq!(reading("CGATS.17\nORIGINATOR \"A\"\n").unwrap_err().line, None);
    let nothing = "CGATS.17\nBEGIN_DATA_FORMAT\nSPEC_380 SPEC_390\nEND_DATA_FORMAT\nBEGIN_DATA\nEND_DATA\n";
    assert_eq!(line(nothing.to_owned()), Some(6));
}

#[test]
fn no_cut_panics() {
    for text in [PAPER.to_owned(), sp("SPECTRAL_NORM \"1.0\"\nMEAS_TYPE \"EMISSION\"")] {
        for end in 0..text.len() {
            let _ = reading(&text[..end]);
        }
    }
}
