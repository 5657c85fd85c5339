//! The steps from counts to color that an instrument takes with every reading.

use crate::readings::EXPOSURE;
use nanospectra::color::{Cct, Lab, Xyz};
use nanospectra::math::Fast;
use nanospectra::sensor::fixed::{FixedCct, FixedMeter};
use nanospectra::sensor::{Calibration, Meter, ReadingError};

/// The matrix from basic counts to XYZ with Y in lux. It finds the smooth spectrum behind the counts of the
/// nominal channels and applies the CIE 1931 observer.
pub static TO_XYZ: Calibration<8> = Calibration::from_rows([
    [2.283, 18.13, 2.785, 1.332, 14.85, 43.1, 23.85, -0.2993],
    [-0.5321, 2.728, 0.4422, 26.31, 40.98, 26.91, 9.224, -0.1845],
    [11.87, 86.97, 37.38, -2.114, 2.34, -1.107, 0.37, -0.09507],
]);

/// The same calibration for raw counts of the one exposure that is in use.
pub static METER: Meter<8> = Meter::new(&EXPOSURE, &TO_XYZ);

/// The same calibration in integers.
pub static FIXED_METER: FixedMeter<8> = FixedMeter::new(&EXPOSURE, &TO_XYZ).unwrap();

/// XYZ of a perfect white in daylight of 1000 lx.
pub static WHITE: Xyz = Xyz { x: 950.47, y: 1000.0, z: 1088.83 };

/// The results of one reading.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(all(target_os = "none", feature = "instrument"), derive(defmt::Format))]
pub struct Color {
    pub xyz: Xyz,
    pub cct: Cct,
    pub lab: Option<Lab>,
}

/// Computes the results of one reading, and refuses saturated, dark and negative readings.
pub fn measure(counts: &[u16; 8]) -> Result<Color, ReadingError> {
    let xyz = METER.xyz(counts)?;
    let cct = xyz.uv1960().map_or(Cct::OffLocus, |uv| uv.cct());
    Ok(Color { xyz, cct, lab: xyz.lab_with::<Fast>(WHITE) })
}

/// Computes lux, CCT and Duv in integers only.
pub fn measure_fixed(counts: &[u16; 8]) -> Result<(u32, Option<FixedCct>), ReadingError> {
    let xyz = FIXED_METER.xyz(counts)?;
    Ok((xyz.lux(), xyz.cct()))
}
