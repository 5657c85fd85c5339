//! Tests the results of readings, by the same program on a host and on boards:
//!
//! ```text
//! cargo test                              # on this machine
//! cargo test --target thumbv6m-none-eabi  # on a board, which is QEMU by run.sh, or a real one by probe-rs
//! ```
//!
//! It exits with 1 if a check fails. To test that, one check fails if the program is built with `MUST_FAIL=1`
//! in the environment.
#![cfg_attr(target_os = "none", no_std, no_main)]

use as7341::{As7341, Gain};
use nanospectra::color::{Cct, Xyz};
use nanospectra::sensor::{ReadingError, chip};
use nanospectra_firmware::bits;
use nanospectra_firmware::mock_bus::{As7341Registers, NoDelay};
use nanospectra_firmware::pipeline::{Color, TO_XYZ, measure};
use nanospectra_firmware::readings::{BLACK_BODY, DAYLIGHT, EXPOSURE, INCANDESCENT, LED};
#[cfg(target_os = "none")]
use semihosting::{println, process};
#[cfg(not(target_os = "none"))]
use std::process;

#[cfg(not(target_os = "none"))]
fn main() {
    process::exit(exit_code())
}

#[cfg(target_os = "none")]
#[nanospectra_firmware::entry]
fn main() -> ! {
    process::exit(exit_code())
}

fn exit_code() -> i32 {
    let mut checks = Checks { passed: 0, failed: 0 };
    lamps(&mut checks);
    limits(&mut checks);
    dark(&mut checks);
    driver(&mut checks);
    checks.that(
        "the bits on record for every machine",
        recorded("readings") == Some(bits::Hash::of(bits::sensor::readings)),
    );
    checks.that("nothing is asked to fail", option_env!("MUST_FAIL").is_none());
    println!("on_target: {} ok, {} FAILED", checks.passed, checks.failed);
    i32::from(checks.failed > 0)
}

/// Returns the hash on record for a group of results.
fn recorded(group: &str) -> Option<u32> {
    let mut lines = include_str!("../../../tests/data/bits.txt").lines();
    let hash = lines.find_map(|line| line.strip_prefix(group)?.strip_prefix(' '))?;
    u32::from_str_radix(hash, 16).ok()
}

struct Checks {
    passed: u32,
    failed: u32,
}

impl Checks {
    fn that(&mut self, what: &str, holds: bool) {
        if holds {
            self.passed += 1;
        } else {
            self.failed += 1;
            println!("FAILED   {what}");
        }
    }
}

fn near<const N: usize>(values: [f32; N], expected: [f32; N], allowed: f32) -> bool {
    values.iter().zip(&expected).all(|(value, expected)| (value - expected).abs() <= allowed)
}

/// Checks readings of lamps. The expected values were computed by numpy in f64, which found the nearest black
/// body by search.
fn lamps(checks: &mut Checks) {
    let mut lamp = |what: &str, counts: &[u16; 8], xyz: [f32; 3], cct: [f32; 2], lab: [f32; 3]| {
        let color = measure(counts).unwrap_or(NOTHING);
        checks.that(what, near(color.xyz.to_array(), xyz, 1e-3));
        let (cct_k, duv) = color.cct.near().unwrap_or_default();
        checks.that(what, near([cct_k], [cct[0]], 0.5) && near([duv], [cct[1]], 2e-6));
        checks.that(what, color.lab.is_some_and(|found| near([found.l, found.a, found.b], lab, 2e-4)));
    };
    lamp(
        "incandescent",
        &INCANDESCENT,
        [548.12869, 499.45464, 177.83455],
        [2860.899, 0.0000844],
        [76.03577, 19.47743, 49.35841],
    );
    lamp(
        "daylight",
        &DAYLIGHT,
        [949.50437, 998.57843, 1090.63172],
        [6519.815, 0.0031282],
        [99.94501, 0.06766, -0.20507],
    );
    lamp("LED", &LED, [559.27856, 500.0031, 168.39769], [2735.02, -0.0008656], [76.06945, 22.13531, 51.3855]);
    lamp(
        "black body",
        &BLACK_BODY,
        [302.62279, 299.83713, 193.2901],
        [4004.29, 0.0000652],
        [61.64017, 6.76578, 21.45886],
    );
}

const NOTHING: Color = Color { xyz: Xyz { x: 0.0, y: 0.0, z: 0.0 }, cct: Cct::OffLocus, lab: None };

/// Checks readings at the ends of the range.
fn limits(checks: &mut Checks) {
    let mut counts = DAYLIGHT;
    (counts[2], counts[7]) = (18_000, 18_001);
    let saturated = measure(&counts);
    checks.that(
        "a channel at full scale is saturated, and the error names it",
        matches!(saturated, Err(ReadingError::Saturated { channels }) if channels.bits() == 0b1000_0100),
    );
    checks.that("counts of zero are too dark", measure(&[0; 8]) == Err(ReadingError::TooDark));
    let [equal, full] = [[5000; 8], [17_999; 8]].map(|counts| measure(&counts).unwrap_or(NOTHING));
    checks.that(
        "equal counts in all channels give this XYZ",
        near(equal.xyz.to_array(), [662.16215, 661.20604, 846.90953], 1e-3),
    );
    checks.that(
        "counts just below full scale give this XYZ",
        near(full.xyz.to_array(), [2383.6513, 2380.2095, 3048.705], 4e-3),
    );
    let cct = [equal, full].map(|color| color.cct.near().unwrap_or_default().0);
    checks.that("the color temperature does not depend on brightness", near(cct, [7262.05; 2], 0.8));
    checks.that(
        "a light of deep red alone is beyond the calibration",
        matches!(measure(&[0, 0, 0, 0, 0, 0, 0, 9000]), Err(ReadingError::Negative { xyz }) if xyz.y < 0.0),
    );
}

/// Checks that a channel below its dark level counts, as a negative number.
fn dark(checks: &mut Checks) {
    let mut counts = INCANDESCENT;
    counts[0] = 100;
    let basic = EXPOSURE.basic_counts_above(&[120.0; 8], &counts);
    checks.that(
        "20 counts below the dark level are negative",
        basic.is_ok_and(|basic| near([basic.values()[0]], [-20.0 / 800.64], 1e-6)),
    );
    let xyz = basic.and_then(|basic| TO_XYZ.xyz(&basic)).unwrap_or(NOTHING.xyz);
    checks.that(
        "one negative channel of a bright reading is accepted",
        near(xyz.to_array(), [531.17035, 483.83425, 151.96392], 1e-3),
    );

    let levels = [130.0, 120.0, 140.0, 125.0, 118.0, 131.0, 122.0, 127.0];
    let noise: [u16; 8] = [120, 121, 139, 130, 123, 130, 125, 129];
    let color = EXPOSURE.basic_counts_above(&levels, &noise).and_then(|basic| TO_XYZ.xyz(&basic));
    checks.that(
        "noise around the dark level has no color",
        matches!(color, Err(ReadingError::Negative { xyz }) if xyz.z < 0.0 && xyz.y > 0.0),
    );
    let strict = EXPOSURE.with_floor(10.0);
    checks.that(
        "with a floor of 10 counts such noise is too dark",
        strict.basic_counts_above(&levels, &noise) == Err(ReadingError::TooDark),
    );
}

/// Checks that a published driver reads the simulated chip.
fn driver(checks: &mut Checks) {
    let diodes = [106, 1023, 1182, 2001, 3619, 5224, 6082, 3066, 6231, 240];
    let mut chip = As7341::new(As7341Registers::counting(diodes), NoDelay);
    let reading = chip.init().and_then(|()| chip.set_gain(Gain::X16)).and_then(|()| chip.read_all_channels());
    checks.that(
        "the driver reads what the diodes count",
        reading.is_ok_and(|reading| reading.as_array() == diodes),
    );
    let (bus, _) = chip.destroy();
    let (atime, astep) = (bus.register(0x81), u16::from_le_bytes([bus.register(0xca), bus.register(0xcb)]));
    checks.that(
        "the driver sets the exposure of the recording",
        chip::as7341::exposure(16.0, atime, astep) == EXPOSURE,
    );
}
