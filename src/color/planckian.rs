//! From a color temperature to a chromaticity: the way back of `cct.rs`, by the same table.

use crate::color::Uv1960;
use crate::color::cct::{CUBIC, FIRST, LINEAR, LOCUS, MAX_DUV, SEGMENTS, Segment};
use crate::math::sqrt;

impl Uv1960 {
    /// Finds the chromaticity of a black body, a point of the Planckian locus, from its color temperature in
    /// K.
    ///
    /// The chromaticity is one of the CIE 1931 2 degree observer; [`Uv1960::xy`] and [`Uv1960::uv1976`]
    /// convert it. The temperature is on the scale of color temperatures (c2 = 1.4388e-2 m K), as in
    /// [`Uv1960::cct`]. The result is `None` outside of 1000 to 1e6 K. NaN stays NaN.
    ///
    /// # Accuracy
    /// 1.5e-7 in u and v (searched in `tests/color/planckian.rs`).
    ///
    /// # Cost
    /// The table of [`Uv1960::cct`], and 115 instructions on a Cortex-M4F.
    ///
    /// # Example
    /// ```
    /// use nanospectra::color::Uv1960;
    /// // Illuminant A by its definition, at 2855.5 K of this scale: x 0.44758, y 0.40745 (CIE 15).
    /// let a = Uv1960::planckian(1.4388 / 1.4350 * 2848.0).ok_or("too hot or too cold")?.xy();
    /// assert!((a.x - 0.447_58).abs() < 2e-5 && (a.y - 0.407_45).abs() < 2e-5);
    /// assert_eq!(Uv1960::planckian(900.0), None);
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn planckian(cct_k: f32) -> Option<Self> {
        Self::of_cct(cct_k, 0.0)
    }

    /// Finds the chromaticity that has this color temperature in K and this Duv, as [`Uv1960::cct`] reads
    /// them.
    ///
    /// It lies on the normal of the locus at `cct_k`, above it (greenish) where `duv` is positive. The result
    /// is `None` outside of 1000 to 1e6 K, and for more than 0.05 from the locus. NaN stays NaN.
    ///
    /// # Accuracy
    /// 2e-6 in u and v; [`Uv1960::cct`] of it is within 0.002 mired of `cct_k` (searched in
    /// `tests/color/planckian.rs`).
    ///
    /// # Cost
    /// The table of [`Uv1960::cct`], and 114 instructions on a Cortex-M4F.
    ///
    /// # Reference
    /// CIE 15:2018, 9.5; Ohno, Leukos 10 (2014) for Duv.
    ///
    /// # Example
    /// ```
    /// use nanospectra::color::{Uv1960, Xy};
    /// // D65 is what is 0.0032 above the locus at 6504 K.
    /// let d65 = Uv1960::of_cct(6504.0, 0.0032).ok_or("not a white")?;
    /// let expected = Xy::new(0.3127, 0.3290).uv1960();
    /// assert!((d65.u - expected.u).abs() < 5e-5 && (d65.v - expected.v).abs() < 5e-5);
    /// assert_eq!(Uv1960::of_cct(6504.0, 0.06), None);
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn of_cct(cct_k: f32, duv: f32) -> Option<Self> {
        let (cold, hot) = (cct_k < 1000.0, cct_k > 1e6); // both are false for NaN
        if cold || hot || duv.abs() > MAX_DUV {
            return None;
        }
        let place = place(1e6 / cct_k - FIRST);
        let segment = (place as usize).min(SEGMENTS - 1);
        let [from, to] = LOCUS.get(segment..).and_then(|rest| rest.first_chunk())?;
        let ([u, v], [du, dv]) = Segment::between(from, to).at(place - segment as f32);
        let share = duv / sqrt(du * du + dv * dv);
        Some(Uv1960 { u: u - share * dv, v: v + share * du })
    }
}

/// Finds the place in the table, counted in knots, that is this many mired beyond its first knot: the root of
/// k (LINEAR + k^2 CUBIC) = `mired`.
fn place(mired: f32) -> f32 {
    // The guess is within 6 %, and two of Newton's steps leave only rounding.
    let mut k = mired / (LINEAR + 0.025 * mired);
    for _ in 0..2 {
        let cubic = CUBIC * k * k;
        k -= (k * (LINEAR + cubic) - mired) / (LINEAR + 3.0 * cubic);
    }
    k
}
