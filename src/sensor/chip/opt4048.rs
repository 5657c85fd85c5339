//! OPT4048 of Texas Instruments: channels near X, Y and Z, with a range that adapts to the light.

use crate::sensor::chip::{Chip, rows};
use crate::sensor::{Calibration, Exposure};

/// The exposure of every reading: [codes](code) do not depend on range and conversion time, so that basic
/// counts are the codes themselves.
#[must_use]
pub const fn exposure() -> Exposure {
    Exposure::new(1.0, 1.0, LARGEST)
}

/// The largest code.
const LARGEST: u32 = 0x000f_ffff << 8;

/// The code of a channel: 20 bits of mantissa, shifted left by 4 bits of exponent (at most 8 in use).
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

/// Channels 0, 1 and 2, as the registers have them: near X, Y and Z. (The fourth is wide.)
pub static CHANNELS: [&str; 3] = ["ch0", "ch1", "ch2"];

/// TI's matrix: X, Y and Z on a scale of their own, from the codes of [`CHANNELS`].
///
/// # Reference
/// The data sheet's coefficients as Adafruit's driver for this chip has them.
pub static TO_XYZ: Calibration<3> = Calibration::from_rows([
    [2.348_929_92e-4, 4.074_674_41e-5, 9.286_194_04e-5],
    [-1.896_523_90e-5, 1.989_582_02e-4, -1.697_395_53e-5],
    [1.208_116_84e-5, -1.588_481_15e-5, 6.740_215_20e-4],
]);

/// Illuminance in lux from the same codes; same source.
pub static TO_LUX: Calibration<3, 1> = Calibration::from_rows([[0.0, 2.15e-3, 0.0]]);

/// All facts of this module as data.
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
