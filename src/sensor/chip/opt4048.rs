//! Describes the OPT4048 of Texas Instruments, whose three color channels are near X, Y and Z and whose range
//! adapts to the light.
//!
//! # Example
//!
//! ```
//! use nanospectra::color::Cct;
//! use nanospectra::sensor::chip::opt4048;
//!
//! // Mantissa and exponent of each channel; codes that daylight D65 gives by the maker's matrix.
//! let codes = [(60_934, 2), (135_087, 2), (42_477, 2)].map(|(m, e)| opt4048::code(m, e));
//! let basic = opt4048::exposure().basic_counts(&codes)?;
//! let [lux] = opt4048::TO_LUX.apply(&basic);
//! assert!((lux - 1161.7).abs() < 0.1); // 4 * 135 087 * 2.15e-3
//! let Some(Cct::Near { cct_k, .. }) = opt4048::TO_XYZ.xyz(&basic)?.cct() else { return Ok(()) };
//! assert!((cct_k - 6503.0).abs() < 5.0);
//! # Ok::<(), nanospectra::sensor::ReadingError>(())
//! ```

use crate::sensor::chip::{Chip, rows};
use crate::sensor::{Calibration, Exposure};

/// Returns the exposure that holds for every reading of this chip.
///
/// There is nothing to set, because a [code] means the same light at every range and conversion time.
/// Basic counts are therefore equal to the codes. See the module's [example](self#example).
#[must_use]
pub const fn exposure() -> Exposure {
    Exposure::new(1.0, 1.0, LARGEST)
}

/// The largest code, at the largest mantissa and exponent.
const LARGEST: u32 = 0x000f_ffff << 8;

/// Computes the code of a channel from 20 bits of mantissa, which are shifted left by 4 bits of exponent (at
/// most 8 in use).
///
/// ```
/// # use nanospectra::sensor::chip::opt4048;
/// let codes = [0, opt4048::code(250_000, 2), 0];
/// let [lux] = opt4048::TO_LUX.apply(&opt4048::exposure().basic_counts(&codes)?);
/// assert!((lux - 2150.0).abs() < 1e-3);
/// # Ok::<(), nanospectra::sensor::ReadingError>(())
/// ```
#[must_use]
pub const fn code(mantissa: u32, exponent: u8) -> u32 {
    (mantissa & 0x000f_ffff) << if exponent < 12 { exponent } else { 12 }
}

/// The names of channels 0, 1 and 2, which are near X, Y and Z and stand in the order of the registers. (The
/// fourth channel is wide.)
pub static CHANNELS: [&str; 3] = ["ch0", "ch1", "ch2"];

/// The matrix of Texas Instruments that turns the codes of [`CHANNELS`] into X, Y and Z on a scale of their
/// own.
///
/// For XYZ with Y in lux, pass the result of [`TO_LUX`] to [`Xyz::with_y`](crate::color::Xyz::with_y). See
/// the module's [example](self#example).
///
/// # Reference
/// The data sheet's coefficients as Adafruit's driver for this chip has them.
pub static TO_XYZ: Calibration<3> = Calibration::from_rows([
    [2.348_929_92e-4, 4.074_674_41e-5, 9.286_194_04e-5],
    [-1.896_523_90e-5, 1.989_582_02e-4, -1.697_395_53e-5],
    [1.208_116_84e-5, -1.588_481_15e-5, 6.740_215_20e-4],
]);

/// The row that turns the same codes into illuminance in lux.
///
/// See the module's [example](self#example).
///
/// # Reference
/// As that of [`TO_XYZ`].
pub static TO_LUX: Calibration<3, 1> = Calibration::from_rows([[0.0, 2.15e-3, 0.0]]);

/// All facts of this module as a [`Chip`], for programs that let their users choose one.
pub static CHIP: Chip = Chip {
    name: "OPT4048",
    summary: "near X, Y and Z; codes: mantissa shifted left by the exponent",
    channels: &CHANNELS,
    settings: &[],
    ladder: &[],
    largest_count: LARGEST,
    whole_counts: true,
    to_xyz: Some(rows(&TO_XYZ)),
    to_lux: Some(&TO_LUX.rows()[0]),
    exposure: |settings| settings.is_empty().then_some(exposure()),
    nominal: None,
};
