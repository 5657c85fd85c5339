//! This example converts the counts of an eight-channel color sensor (AS7341) to illuminance, XYZ and CCT, in
//! f32. One reading under a lamp of known illuminance calibrates it. It is for firmware on a core with an
//! FPU; for a core without one, see `sensor_counts_integer`.
//!
//! `cargo run --release --example sensor_counts`

use nanospectra::color::Cct;
use nanospectra::observer::CIE_1931;
use nanospectra::sensor::{Calibration, Exposure, Meter, ReadingError, Reconstruction, chip::as7341};
use nanospectra::{Curve, Nodes, Observer, Power, const_unwrap};

type Grid = Nodes<400, 700>;

/// The responsivities of the chip by its data sheet. Those measured of your own chip are better.
static CHIP: Observer<8, 31, Power, Grid> = as7341::NOMINAL.fold(Curve::Step);
static EYE: Observer<3, 31, Power, Grid> = CIE_1931.fold(Curve::Step);

/// A matrix of 96 bytes that converts counts to XYZ, by way of the smoothest spectrum that explains them. The
/// compiler computes it.
static TO_XYZ: Calibration<8> = const_unwrap!(Reconstruction::smooth(&CHIP, 0.95, 0.01)).seen_by(&EYE);
/// The exposure: gain 16, and with the registers ATIME 29 and ASTEP 599 a time of 50 ms and a full scale of
/// 18000 counts.
static EXPOSURE: Exposure = as7341::exposure(16.0, 29, 599);

/// The counts of channels F1 to F8 under an incandescent lamp (CIE illuminant A) that gives 500 lx by a lux
/// meter. These counts and the next are simulated, so that the lamps are known exactly.
const KNOWN: ([u16; 8], f32) = ([733, 1349, 2527, 3918, 5441, 7035, 10882, 13899], 500.0);
/// The same under a white LED (CIE illuminant LED-B3) of 500 lx.
const COUNTS: [u16; 8] = [416, 3675, 2876, 4434, 6022, 6825, 6864, 3069];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (counts, lux) = KNOWN;
    let meter = Meter::new(&EXPOSURE, &TO_XYZ);
    let factor = lux / meter.xyz(&counts)?.y;
    println!("calibration: scale Y by {factor}");
    let meter = meter.scaled(factor);

    let xyz = meter.xyz(&COUNTS)?;
    let (cct_k, duv) = xyz.cct().and_then(Cct::near).ok_or("this light is not white")?;
    println!(
        "{:.0} lx, XYZ {:.0}, {:.0}, {:.0}, CCT {cct_k:.0} K, Duv {duv:+.4}",
        xyz.y, xyz.x, xyz.y, xyz.z
    );

    // A reading that says nothing about the light is an error and not a color.
    let blinded = meter.xyz(&[18_000_u16; 8]);
    assert!(matches!(blinded, Err(ReadingError::Saturated { channels }) if channels.count() == 8));
    // By CIE 15:2018, LED-B3 has 4103 K, x = 0.3756, y = 0.3723. Eight channels measure that to about 1 %.
    let xy = xyz.xy().ok_or("dark")?;
    assert!((xyz.y / 500.0 - 1.0).abs() < 0.01 && (cct_k / 4103.0 - 1.0).abs() < 0.01);
    assert!((xy.x - 0.3756).abs() < 0.002 && (xy.y - 0.3723).abs() < 0.002);
    Ok(())
}
