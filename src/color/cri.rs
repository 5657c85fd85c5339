//! The CIE color rendering index.

use crate::color::reference::{RenderingError, temperature};
use crate::color::test_colors::{Colors, under, under_reference};
use crate::color::{Uv1960, Xyz};
use crate::math::{cbrt, sqrt};
use crate::spectrum::{Fine, Power};

/// The CIE color rendering indices of a light.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cri {
    /// The general index: the mean of the first eight.
    pub ra: f32,
    /// R1..=R14, and R15 (TCS15, Japanese skin). 100 is perfect; there is no lower end.
    pub r: [f32; 15],
    /// Correlated color temperature of the light and of its reference, K.
    pub cct_k: f32,
    /// Distance from the Planckian locus.
    pub duv: f32,
    /// Distance between light and reference, CIE 1960. CIE 13.3 asks for less than 5.4e-3; beyond, the
    /// indices are numbers without much meaning.
    pub dc: f32,
}

/// The CIE 1974 test color method, unrounded.
///
/// The reference is a black body below 5000 K and daylight (M1, M2 not rounded) from there, above 25000 K by
/// the same formula; 1 nm sums over 360..=830 nm, samples by Sprague's interpolation, CIE 1931 observer. The
/// sums are taken in another order, samples last, and for the reference ahead of time; the numbers are the
/// same but for rounding.
///
/// # Accuracy
/// Ra is within 3e-4 and each R within 1.4e-3 of f64, over 63 lamps (`tests/color/rendering.rs`). TCS15 is
/// tabulated over 380..=780 nm only; its end values are held beyond.
///
/// # Cost
/// 17 KB of tables, color-matching functions included; 13,000 multiplications and additions and no
/// exponential, 2.1 us on an x86-64 host.
///
/// # Errors
/// [`RenderingError`]: dark, no white, or with values so negative that a sample has no color.
///
/// # Reference
/// CIE 13.3-1995.
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

/// A light under which samples are looked at.
struct Judge {
    colors: Colors,
    white: Uv1960,
    white_cd: [f32; 2],
    /// Brings Y of the white to 100.
    scale: f32,
}

impl Judge {
    fn new(colors: Colors) -> Result<Self, RenderingError> {
        let [[.., x], [.., y], [.., z]] = colors;
        let white = Xyz { x, y, z }.uv1960().ok_or(RenderingError::Dark)?;
        Ok(Judge { colors, white, white_cd: cd(white), scale: 100.0 / y })
    }

    /// The 15 samples (and, for who asks for more, the white).
    fn samples(&self) -> impl Iterator<Item = Xyz> {
        let [x, y, z] = &self.colors;
        x.iter().zip(y.iter().zip(z)).map(|(x, (y, z))| Xyz { x: *x, y: *y, z: *z }.scaled(self.scale))
    }

    /// U*, V*, W* of a sample, adapted to the white of the reference by von Kries' rule on the
    /// quantities c and d of the standard.
    fn uvw(&self, sample: Xyz, reference: &Judge) -> Result<[f32; 3], RenderingError> {
        let own = cd(sample.uv1960().ok_or(RenderingError::Unreal)?);
        let c = reference.white_cd[0] / self.white_cd[0] * own[0];
        let d = reference.white_cd[1] / self.white_cd[1] * own[1];
        let bottom = 16.518 + 1.481 * c - d;
        let (u, v) = ((10.872 + 0.404 * c - 4.0 * d) / bottom, 5.520 / bottom);
        let w = 25.0 * cbrt(sample.y) - 17.0;
        Ok([13.0 * w * (u - reference.white.u), 13.0 * w * (v - reference.white.v), w])
    }
}

fn cd(p: Uv1960) -> [f32; 2] {
    [(4.0 - p.u - 10.0 * p.v) / p.v, (1.708 * p.v + 0.404 - 1.481 * p.u) / p.v]
}
