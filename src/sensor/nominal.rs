//! Nominal responsivities: Gaussians with the peaks and widths of data sheets, *not* the chip on your bus.
//!
//! Each is 1 at its peak. Real peaks lie 5 to 10 nm beside the nominal ones (users have measured 410, 440, 470,
//! 510, 550, 583, 620 and 670 nm for the AS7341), real curves are no Gaussians, and every channel leaks a little
//! infrared. They serve for simulation, for tests and for a first look; a measured table ([`responsivities`]) or
//! measured patches ([`Fit`](crate::sensor::Fit)) make an instrument.
//!
//! [`responsivities`]: crate::sensor::responsivities

use crate::grid::{Grid, Nodes};
use crate::observer::{FineObserver, Observer};
use crate::spectrum::Power;

/// Gaussian channels on any grid, from (peak, full width at half maximum), both in nm; each 1 at its peak.
///
/// On bins wider than a few nanometers these are values at the centers and not averages: make them on 1 nm and
/// [`fold`](Observer::fold).
///
/// ```
/// # use nanospectra::{Nodes, Observer, Power, sensor::nominal};
/// static MINE: Observer<2, 701, Power, Nodes<300, 1000>> = nominal::gaussians([(450.0, 40.0), (850.0, 60.0)]);
/// assert!((MINE.weights()[0][170] - 0.5).abs() < 1e-6); // 470 nm: half of the peak
/// ```
#[must_use]
pub const fn gaussians<const C: usize, const N: usize, G: Grid>(
    channels: [(f64, f64); C],
) -> Observer<C, N, Power, G> {
    let mut rows = [[0.0; N]; C];
    let mut c = 0;
    while c < C {
        let (peak, fwhm) = channels[c];
        let mut k = 0;
        while k < N {
            let widths = (crate::grid::Layout::<G, N>::center(k) as f64 - peak) / fwhm;
            // 16^(-(d/fwhm)^2) is a half at d = fwhm / 2.
            rows[c][k] = exp2_below_zero(-4.0 * widths * widths) as f32;
            k += 1;
        }
        c += 1;
    }
    Observer::from_rows(rows)
}

/// 2^x for x <= 0, in const fn; what is below 2^-40 becomes 0.
const fn exp2_below_zero(x: f64) -> f64 {
    if x < -40.0 {
        return 0.0;
    }
    // 2^x = (2^(x/64))^64; the series of e^t for |t| <= 0.44 ends below 1e-16 after 13 terms.
    let t = x / 64.0 * core::f64::consts::LN_2;
    let (mut sum, mut n) = (1.0, 13);
    while n > 0 {
        sum = 1.0 + sum * t / n as f64;
        n -= 1;
    }
    let mut squarings = 0;
    while squarings < 6 {
        sum *= sum;
        squarings += 1;
    }
    sum
}

/// AS7341, channels F1 to F8 (415 to 680 nm; data sheet DS000504). Without the infrared and the clear channel.
pub static AS7341: FineObserver<8> = gaussians([
    (415.0, 26.0),
    (445.0, 30.0),
    (480.0, 36.0),
    (515.0, 39.0),
    (555.0, 39.0),
    (590.0, 40.0),
    (630.0, 50.0),
    (680.0, 52.0),
]);

/// AS7343 and TCS3448, channels F1, F2, FZ, F3, F4, F5, FY, FXL, F6, F7, F8 (405 to 745 nm; widths as users of the
/// TCS3448 tabulate them). Without the infrared and the clear channel.
pub static AS7343: FineObserver<11> = gaussians([
    (405.0, 28.0),
    (425.0, 29.0),
    (450.0, 67.0),
    (475.0, 38.0),
    (515.0, 48.0),
    (550.0, 44.0),
    (555.0, 123.0),
    (600.0, 93.0),
    (640.0, 58.0),
    (690.0, 63.0),
    (745.0, 77.0),
]);

/// AS7262, six channels of 40 nm from 450 to 650 nm.
pub static AS7262: FineObserver<6> =
    gaussians([(450.0, 40.0), (500.0, 40.0), (550.0, 40.0), (570.0, 40.0), (600.0, 40.0), (650.0, 40.0)]);

/// AS7265x, 18 channels of 20 nm from 410 to 940 nm.
pub static AS7265X: Observer<18, 701, Power, Nodes<300, 1000>> = gaussians([
    (410.0, 20.0),
    (435.0, 20.0),
    (460.0, 20.0),
    (485.0, 20.0),
    (510.0, 20.0),
    (535.0, 20.0),
    (560.0, 20.0),
    (585.0, 20.0),
    (610.0, 20.0),
    (645.0, 20.0),
    (680.0, 20.0),
    (705.0, 20.0),
    (730.0, 20.0),
    (760.0, 20.0),
    (810.0, 20.0),
    (860.0, 20.0),
    (900.0, 20.0),
    (940.0, 20.0),
]);
