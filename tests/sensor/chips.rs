//! What is known of the chips: complete, listed, and of one piece.

use nanospectra::sensor::chip::{self, Chip, SettingValues};
use nanospectra::sensor::{AutoExposure, Exposure};
use nanospectra::{Nodes, Observer, Power};
use std::collections::BTreeSet;
use std::fs;

/// A file in `src/sensor/chip/` that the list has forgotten would be unknown to every program.
#[test]
fn every_file_of_a_chip_is_in_the_list() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/src/sensor/chip");
    let files = fs::read_dir(folder).expect("the chips").map(|entry| entry.expect("a file").file_name());
    let files: BTreeSet<String> =
        files.filter_map(|name| Some(name.to_str()?.strip_suffix(".rs")?.to_owned())).collect();
    let listed = chip::ALL.map(|chip| chip.name.to_lowercase());
    assert_eq!(files, listed.iter().cloned().chain(["mod".into()]).collect());
    for (chip, name) in chip::ALL.into_iter().zip(listed) {
        assert!(chip::named(&name).is_some_and(|found| core::ptr::eq(found, chip)), "{name}");
    }
    assert!(chip::named("AS7342").is_none());
}

#[test]
fn channels_and_what_is_known_of_them_are_as_many() {
    for chip in chip::ALL {
        let channels = chip.channels.len();
        let nominal = |k: usize| -> Option<Observer<1, 71, Power, Nodes<300, 1000>>> { chip.nominal(k) };
        let known = (0..=channels).filter(|k| nominal(*k).is_some()).count();
        assert!(known == 0 || known == channels, "{}: {known} of {channels} channels", chip.name);
        assert!(nominal(channels).is_none() && chip.peak_nm(channels).is_none());
        let rows = chip.to_xyz.iter().flatten().chain(&chip.to_lux);
        assert!(rows.into_iter().all(|row| row.len() == channels), "{}", chip.name);
        let names: BTreeSet<&str> = chip.channels.iter().copied().collect();
        assert!(names.len() == channels && names.iter().all(|name| *name == name.to_lowercase()));
        assert!(!chip.summary.is_empty());
    }
    assert_eq!(chip::named("AS7341").and_then(|chip| chip.peak_nm(7)), Some(680.0));
    assert_eq!(chip::named("AS7265x").and_then(|chip| chip.peak_nm(17)), Some(940.0));
}

/// The peaks in nm by the data sheets of the makers: DS000504 (AS7341), DS001046 (AS7343), and those of the
/// AS7262 and the AS7265x, whose channels are called by them.
#[test]
fn every_channel_peaks_where_the_data_sheet_says() {
    let peaks: [(&str, &[f32]); 4] = [
        ("AS7341", &[415.0, 445.0, 480.0, 515.0, 555.0, 590.0, 630.0, 680.0]),
        ("AS7343", &[405.0, 425.0, 450.0, 475.0, 515.0, 550.0, 555.0, 600.0, 640.0, 690.0, 745.0]),
        ("AS7262", &[450.0, 500.0, 550.0, 570.0, 600.0, 650.0]),
        (
            "AS7265x",
            &[
                410.0, 435.0, 460.0, 485.0, 510.0, 535.0, 560.0, 585.0, 610.0, 645.0, 680.0, 705.0, 730.0,
                760.0, 810.0, 860.0, 900.0, 940.0,
            ],
        ),
    ];
    for chip in chip::ALL {
        let published = peaks.iter().find(|(name, _)| *name == chip.name).map_or(&[][..], |(_, peaks)| peaks);
        let found: Vec<f32> = (0..chip.channels.len()).filter_map(|k| chip.peak_nm(k)).collect();
        assert_eq!(found, published, "{}", chip.name);
        let named: Vec<f32> = chip.channels.iter().filter_map(|name| name.parse().ok()).collect();
        assert!(named.is_empty() || named == published, "{}: {named:?}", chip.name);
    }
}

/// The last values of their registers, by the data sheets: AS7341 and AS7343 reserve the last ASTEP.
#[test]
fn registers_end_where_the_data_sheets_say() {
    let long: &[f32] = &[1.0, 255.0, 65_534.0];
    let short: &[f32] = &[1.0, 255.0];
    let last =
        [("AS7341", long), ("AS7343", long), ("AS7262", short), ("AS7265x", short), ("TCS3472", short)];
    for (name, last) in last {
        let chip = chip::named(name).expect(name);
        assert!(chip.exposure(last).is_some(), "{name}");
        for register in 1..last.len() {
            for beyond in [last[register] + 1.0, 0.5, -1.0, f32::NAN] {
                let mut settings = last.to_vec();
                settings[register] = beyond;
                assert_eq!(chip.exposure(&settings), None, "{name} {settings:?}");
            }
        }
        assert_eq!(chip.exposure(&last[1..]), None, "{name}");
    }
}

#[test]
fn every_ladder_climbs_in_settings_that_the_chip_has() {
    for chip in chip::ALL.into_iter().filter(|chip| !chip.settings.is_empty()) {
        let ladder: Option<Vec<Exposure>> =
            chip.ladder.iter().map(|settings| chip.exposure(settings)).collect();
        let ladder = ladder.unwrap_or_else(|| panic!("{}: a setting that it does not have", chip.name));
        assert!(AutoExposure::new(&ladder).is_ok(), "{}", chip.name);
        assert!(ladder.iter().all(|exposure| exposure.full_scale() <= chip.largest_count));
        // All gains occur.
        let [gain, ..] = chip.settings else { panic!("{}: no settings", chip.name) };
        let SettingValues::OneOf(gains) = gain.values else { panic!("{}: not the gain first", chip.name) };
        assert!(
            gain.name == "gain" && gains.iter().all(|gain| chip.ladder.iter().any(|rung| rung[0] == *gain))
        );
    }
    let of_modules = [
        (&chip::as7341::CHIP, &chip::as7341::LADDER[..]),
        (&chip::as7343::CHIP, &chip::as7343::LADDER),
        (&chip::as7262::CHIP, &chip::as7262::LADDER),
        (&chip::as7265x::CHIP, &chip::as7265x::LADDER),
        (&chip::tcs3472::CHIP, &chip::tcs3472::LADDER),
    ];
    for (chip, ladder) in of_modules {
        assert!(
            ladder.iter().zip(chip.ladder).all(|(exposure, rung)| chip.exposure(rung) == Some(*exposure))
        );
        assert_eq!(ladder.len(), chip.ladder.len());
    }
}

#[test]
fn settings_that_a_chip_does_not_have_make_no_exposure() {
    let of = |chip: &Chip, settings: &[f32]| chip.exposure(settings);
    let as7341 = chip::named("as7341").expect("a chip");
    assert!(of(as7341, &[512.0, 255.0, 65_534.0]).is_some());
    for bad in [
        &[3.0, 29.0, 599.0][..],
        &[1.0, 256.0, 599.0],
        &[1.0, 0.5, 599.0],
        &[1.0, -1.0, 599.0],
        &[1.0, f32::NAN, 599.0],
        &[1.0, 29.0, 65_535.0],
        &[1.0, 29.0],
        &[1.0, 29.0, 599.0, 1.0],
        &[],
    ] {
        assert_eq!(of(as7341, bad), None, "{bad:?}");
    }
    let opt4048 = chip::named("OPT4048").expect("a chip");
    assert_eq!(of(opt4048, &[]), Some(chip::opt4048::exposure()));
    assert_eq!(of(opt4048, &[1.0]), None);
}
