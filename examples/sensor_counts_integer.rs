//! This example converts the counts of an eight-channel color sensor (AS7341) to illuminance, CCT and Duv
//! without any float at run time. It is for firmware on a core without an FPU (Cortex-M0, RV32IMAC), where
//! floats need twenty times as many instructions.
//!
//! `cargo run --release --example sensor_counts_integer`

use nanospectra::observer::CIE_1931;
use nanospectra::sensor::fixed::{FixedCct, FixedMeter};
use nanospectra::sensor::{Calibration, ReadingError, Reconstruction, chip::as7341};
use nanospectra::{Curve, Nodes, Observer, Power, const_unwrap};

type Grid = Nodes<400, 700>;

/// The chip by its data sheet, the eye, and the matrix that converts counts to XYZ. Only the compiler
/// computes with these floats.
const CHIP: Observer<8, 31, Power, Grid> = as7341::NOMINAL.fold(Curve::Step);
const EYE: Observer<3, 31, Power, Grid> = CIE_1931.fold(Curve::Step);
const TO_XYZ: Calibration<8> = const_unwrap!(Reconstruction::smooth(&CHIP, 0.95, 0.01)).seen_by(&EYE);

/// The meter, for gain 16 and 50 ms. The factor, which the example `sensor_counts` finds, makes Y illuminance
/// in lux. This static is all that is in flash.
static METER: FixedMeter<8> =
    FixedMeter::new(&as7341::exposure(16.0, 29, 599), &TO_XYZ.scaled(27.363_61)).unwrap();

/// The function that firmware would call. It returns the illuminance in lux and, if the light is white, the
/// CCT in kelvins and Duv in millionths.
fn read(counts: &[u16; 8]) -> Result<(u32, Option<(u32, i32)>), ReadingError> {
    let xyz = METER.xyz(counts)?;
    let white = match xyz.cct() {
        Some(FixedCct::Near { cct_k, duv_e6, .. }) => Some((cct_k, duv_e6)),
        _ => None,
    };
    Ok((xyz.lux(), white))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("{} bytes of flash for the meter", size_of_val(&METER));

    // These are simulated counts of channels F1 to F8 under a white LED (CIE illuminant LED-B3) of 500 lx.
    let (lux, white) = read(&[416, 3675, 2876, 4434, 6022, 6825, 6864, 3069])?;
    let (cct_k, duv_e6) = white.ok_or("this light is not white")?;
    println!("{lux} lx, CCT {cct_k} K, Duv {duv_e6} millionths");

    assert_eq!(read(&[0; 8]), Err(ReadingError::TooDark));
    // By CIE 15:2018, LED-B3 has 4103 K. Eight channels measure that to about 1 %, and integers add no error
    // that is visible beside it.
    assert!(lux.abs_diff(500) <= 5 && cct_k.abs_diff(4103) <= 41);
    Ok(())
}
