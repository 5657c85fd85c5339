//! CIE daylight of any correlated color temperature.

use crate::grid::Nodes;
use crate::light::{S0, S1, S2};
use crate::spectrum::{Power, Spectrum};
use crate::tristimulus::Xy;

/// A daylight spectrum, which lies on the grid of its components: 300..=830 nm in steps of 5 nm. See the
/// [example](daylight).
pub type Daylight = Spectrum<Power, 107, Nodes<300, 830>>;

/// Returns the chromaticity of CIE daylight whose correlated color temperature is `cct_k`, in K, or `None`
/// outside 4000..=25000 K.
///
/// The CIE's formula is a polynomial, so [`cct`](crate::color::Uv1960::cct) finds a slightly different
/// temperature for its color: 4999.7 K for 5000 K, and 24 913 K for 25 000 K.
///
/// # Reference
/// CIE 15:2018, equations 3.3 to 3.5.
///
/// ```
/// # use nanospectra::light::daylight_xy;
/// let d65 = daylight_xy(6504.0).ok_or("in range")?;
/// assert!((d65.x - 0.31271).abs() < 1e-5 && (d65.y - 0.32912).abs() < 2e-5);
///
/// let (bluest_k, _) = daylight_xy(25000.0).and_then(|xy| xy.uv1960().cct().near()).ok_or("in range")?;
/// assert!((bluest_k - 24_913.0).abs() < 1.0);
/// # Ok::<(), &str>(())
/// ```
#[must_use]
pub fn daylight_xy(cct_k: f32) -> Option<Xy> {
    (4000.0..=25000.0).contains(&cct_k).then(|| locus(cct_k))
}

/// Returns the spectrum of CIE daylight whose correlated color temperature is `cct_k`, in K, or `None`
/// outside 4000..=25000 K.
///
/// The spectrum is 100 at 560 nm. The factors M1 and M2 are not rounded to three decimals, as those of the
/// tables of D50, D55, D65 and D75 once were.
///
/// ```
/// use nanospectra::light::{D50, daylight};
///
/// // D50 has a nominal temperature of 5000 K; with today's second radiation constant that is 5003 K.
/// let d50 = daylight(5003.0).ok_or("out of range")?;
/// let at_600_nm = (d50.values()[(600 - 300) / 5], D50.values()[600 - 300]);
/// assert!((at_600_nm.0 - at_600_nm.1).abs() < 0.1);
/// assert!(daylight(3000.0).is_none());
/// # Ok::<(), &str>(())
/// ```
///
/// # Reference
/// CIE 15:2018, 3.1: S0 + M1 S1 + M2 S2, linear between the 5 nm nodes.
#[must_use]
pub fn daylight(cct_k: f32) -> Option<Daylight> {
    (4000.0..=25000.0).contains(&cct_k).then(|| spectrum(cct_k))
}

fn locus(cct_k: f32) -> Xy {
    let r = 1000.0 / cct_k;
    let x = if cct_k <= 7000.0 {
        0.244_063 + r * (0.099_11 + r * (2.967_8 - r * 4.607_0))
    } else {
        0.237_040 + r * (0.247_48 + r * (1.901_8 - r * 2.006_4))
    };
    Xy { x, y: -0.275 + x * (2.870 - 3.000 * x) }
}

/// Computes as [`daylight`] does, but at any temperature: references above 25000 K follow the same formula.
pub(crate) fn spectrum(cct_k: f32) -> Daylight {
    let [m1, m2] = factors(cct_k);
    let mut light = S0;
    for (value, (s1, s2)) in light.values_mut().iter_mut().zip(S1.values().iter().zip(S2.values())) {
        *value = *value + s1 * m1 + s2 * m2;
    }
    light
}

/// M1 and M2, the factors of S1 and S2.
pub(crate) fn factors(cct_k: f32) -> [f32; 2] {
    let Xy { x, y } = locus(cct_k);
    let m = 0.0241 + 0.2562 * x - 0.7341 * y;
    let m1 = (-1.3515 - 1.7703 * x + 5.9114 * y) / m;
    let m2 = (0.0300 - 31.4424 * x + 30.0717 * y) / m;
    [m1, m2]
}
