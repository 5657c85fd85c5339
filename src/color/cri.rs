//! The CIE color rendering index (CIE 13.3).

use crate::color::reference::{RenderingError, temperature};
use crate::color::test_colors::{Colors, under, under_reference};
use crate::color::{Uv1960, Xyz};
use crate::math::{cbrt, sqrt};
use crate::spectrum::{Fine, Power};

/// The CIE color rendering indices of a light, which [`cri`] computes.
///
/// See the [example](cri#example).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cri {
    /// The general index Ra, which is the mean of R1 to R8.
    ///
    /// See the [example](cri#example).
    pub ra: f32,
    /// The special indices R1..=R14, which R15 follows (TCS15, Japanese skin).
    ///
    /// 100 is perfect, and there is no lower limit. See the [example](cri#example).
    pub r: [f32; 15],
    /// The correlated color temperature that the light has, and its reference too, in K.
    ///
    /// See the [example](cri#example).
    pub cct_k: f32,
    /// The distance of the light from the Planckian locus, which is positive above it.
    pub duv: f32,
    /// The distance that light and reference have in the CIE 1960 diagram.
    ///
    /// CIE 13.3 asks for less than 5.4e-3; beyond that the indices do not mean much.
    pub dc: f32,
}

/// Computes the color rendering indices Ra and R1 to R15 of a light by the CIE 1974 test color method.
///
/// The indices are not rounded. The reference is a black body below 5000 K and CIE daylight from there
/// (M1 and M2 not rounded; above 25000 K by the same formula). Sums are over 360..=830 nm at 1 nm with the
/// CIE 1931 observer, and the test color samples are interpolated by Sprague's method. The additions are made
/// in another order than in the standard, and the compiler computes most of the sums for the reference; both
/// change the results by rounding alone.
///
/// # Accuracy
/// Ra is within 4e-4 and each R within 1.5e-3 of f64, over 1800 spectra of lamps that stand in no table, up
/// to |Duv| = 0.05; where a search for the largest errors ended, Ra was off by 7e-4 (a black body, of which
/// rounding can only lower what is 100) and R by 2e-3, or below -100 by 9e-6 of what R lacks to 100
/// (`tests/color/held_out.rs`). The reference changes by a jump at 5000 K: a light within 0.05 K of it may
/// get the other one. TCS15 is tabulated over 380..=780 nm only; beyond, its end values are used.
///
/// # Cost
/// 17 KB of tables, color-matching functions included; 13,000 multiplications and additions and no
/// exponential, 2.1 us on an x86-64 host. On a Cortex-M4F it takes 2,070 bytes of stack at opt-level 3, and
/// 1,990 at "s".
///
/// # Errors
/// Returns a [`RenderingError`] if the light is dark, if it is not a white, or if it has values so negative
/// that a sample has no color.
///
/// # Reference
/// CIE 13.3-1995.
///
/// # Example
/// ```
/// use nanospectra::{color::cri, light};
/// let cool_white = cri(&light::FL2.fine())?;
/// assert_eq!(cool_white.ra.round(), 64.0); // CIE 15 tabulates 64, and a CCT of 4230 K
/// assert!((cool_white.cct_k - 4230.0).abs() < 10.0);
/// assert!(cool_white.r[8] < 0.0); // R9, a saturated red
/// # Ok::<(), nanospectra::color::RenderingError>(())
/// ```
pub fn cri(light: &Fine<Power>) -> Result<Cri, RenderingError> {
    let (cct_k, duv) = temperature(light)?;
    let (test, standard) = (Judge::new(under(light))?, Judge::new(under_reference(cct_k))?);
    let dc = {
        let (du, dv) = (test.white.u - standard.white.u, test.white.v - standard.white.v);
        sqrt(du * du + dv * dv)
    };
    let mut r = [0.0; 15];
    for (r, (seen, expected)) in r.iter_mut().zip(test.samples().zip(standard.samples())) {
        let (a, b) = (test.uvw(seen, &standard)?, standard.uvw(expected, &standard)?);
        let d = [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
        *r = 100.0 - 4.6 * sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    }
    if r.iter().any(|r| !r.is_finite()) {
        return Err(RenderingError::Unreal);
    }
    let ra = r.iter().take(8).sum::<f32>() / 8.0;
    Ok(Cri { ra, r, cct_k, duv, dc })
}

/// A light with the colors that the samples have under it.
struct Judge {
    colors: Colors,
    white: Uv1960,
    white_cd: [f32; 2],
    /// The factor that brings Y of the white to 100.
    scale: f32,
}

impl Judge {
    fn new(colors: Colors) -> Result<Self, RenderingError> {
        let [[.., x], [.., y], [.., z]] = colors;
        let white = Xyz { x, y, z }.uv1960().ok_or(RenderingError::Dark)?;
        Ok(Judge { colors, white, white_cd: cd(Xyz { x, y, z }), scale: 100.0 / y })
    }

    /// Returns the colors of the 15 samples, followed by the white.
    fn samples(&self) -> impl Iterator<Item = Xyz> {
        let [x, y, z] = &self.colors;
        x.iter().zip(y.iter().zip(z)).map(|(x, (y, z))| Xyz { x: *x, y: *y, z: *z }.scaled(self.scale))
    }

    /// Computes U*, V*, W* of a sample, adapted to the white of the reference by von Kries' rule for the
    /// quantities c and d of the standard.
    fn uvw(&self, sample: Xyz, reference: &Judge) -> Result<[f32; 3], RenderingError> {
        let own = cd(sample);
        let c = reference.white_cd[0] / self.white_cd[0] * own[0];
        let d = reference.white_cd[1] / self.white_cd[1] * own[1];
        let bottom = 16.518 + 1.481 * c - d;
        if sample.y <= 0.0 || bottom <= 0.0 {
            return Err(RenderingError::Unreal);
        }
        let (u, v) = ((10.872 + 0.404 * c - 4.0 * d) / bottom, 5.520 / bottom);
        let w = 25.0 * cbrt(sample.y) - 17.0;
        Ok([13.0 * w * (u - reference.white.u), 13.0 * w * (v - reference.white.v), w])
    }
}

/// Computes the quantities c and d of the standard, which takes them from u and v: c = (4 - u - 10 v) / v and
/// d = (1.708 v + 0.404 - 1.481 u) / v. Written in X, Y and Z they lose no digits.
fn cd(p: Xyz) -> [f32; 2] {
    let (x, z) = (p.x / p.y, p.z / p.y);
    [2.0 * z, 1.708 + 1.01 - 0.92 * x + 0.202 * z]
}
