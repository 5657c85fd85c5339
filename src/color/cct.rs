//! Correlated color temperature and distance from the Planckian locus.

use crate::color::{Uv1960, Xyz};
use crate::math::sqrt;
use core::fmt;

include!(concat!(env!("OUT_DIR"), "/locus.rs"));

/// Segments of the locus table.
const SEGMENTS: usize = LOCUS.len() - 1;

/// CIE 15: a correlated color temperature has no meaning further than this from the locus, with room for the
/// rounding of u and v. (Its radius of curvature goes down to 0.1001 there, and points beyond that have no
/// nearest one.)
const MAX_DUV: f32 = 0.05 + 2e-7;

/// A correlated color temperature with its Duv, or the reason why a color has none.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Cct {
    /// A color near the locus.
    Near {
        /// Temperature of the nearest black body, K, 1000..=1e6.
        cct_k: f32,
        /// Distance from the locus in the CIE 1960 plane, above it (greenish) positive; |duv| <= 0.05.
        duv: f32,
    },
    /// Further than 0.05 from the locus: not a white, it has no color temperature.
    OffLocus,
    /// Redder than a black body of 1000 K.
    TooCold,
    /// Bluer than a black body of a million K.
    TooHot,
}

impl Cct {
    /// Size in bytes of the table that [`Uv1960::cct`] reads.
    pub const TABLE_BYTES: usize = size_of_val(&LOCUS);

    /// Temperature in K and Duv, if the color has them.
    #[must_use]
    pub const fn near(self) -> Option<(f32, f32)> {
        match self {
            Cct::Near { cct_k, duv } => Some((cct_k, duv)),
            _ => None,
        }
    }
}

impl fmt::Display for Cct {
    /// `6503 K, Duv +0.0032`, or the reason.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Cct::Near { cct_k, duv } => return write!(f, "{cct_k:.0} K, Duv {duv:+.4}"),
            Cct::OffLocus => "not a white: more than 0.05 from the Planckian locus",
            Cct::TooCold => "redder than a black body of 1000 K",
            Cct::TooHot => "bluer than a black body of a million K",
        })
    }
}

impl Xyz {
    /// CCT and Duv of the chromaticity, as [`Uv1960::cct`]; `None` for black, which has no chromaticity.
    ///
    /// ```
    /// # use nanospectra::color::{Cct, Xyz};
    /// let d65 = Xyz::new(95.047, 100.0, 108.883);
    /// assert_eq!(d65.cct().ok_or("black")?.to_string(), "6503 K, Duv +0.0032");
    /// assert_eq!(Xyz::default().cct(), None);
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    #[inline]
    pub fn cct(self) -> Option<Cct> {
        self.uv1960().map(|uv| uv.cct())
    }
}

impl Uv1960 {
    /// The temperature of the nearest black body and the distance to it, for a chromaticity of
    /// the CIE 1931 2 degree observer.
    ///
    /// Planck's law with c2 = 1.4388e-2 m K as color temperatures are defined: a black body by
    /// today's constants reads 1.6e-5 of T higher. NaN gives NaN.
    ///
    /// # Accuracy
    /// 0.009 mired and 2e-7 in Duv over 1000 K..1e6 K and |Duv| <= 0.05 (swept in `tests/color/cct.rs`);
    /// 0.009 mired are 0.4 K at 6500 K.
    ///
    /// # Cost
    /// 400 bytes of table; a search by halves, one Newton step and one square root.
    ///
    /// # Reference
    /// CIE 15:2018, 9.5; Ohno, Leukos 10 (2014) for Duv. The locus is a Hermite curve through 25
    /// knots made from the CIE 1931 functions when the crate is built.
    ///
    /// ```
    /// # use nanospectra::{color::Xy, color::Cct};
    /// // Illuminant A by its definition, T = 1.4388e-2 / 1.4350e-2 * 2848 K.
    /// let Cct::Near { cct_k, duv } = Xy::new(0.447_58, 0.407_45).uv1960().cct() else { return };
    /// assert!((cct_k - 2855.5).abs() < 0.5 && duv.abs() < 1e-5);
    /// assert_eq!(Xy::new(0.15, 0.70).uv1960().cct(), Cct::OffLocus); // a green
    /// ```
    #[must_use]
    #[cfg_attr(not(target_arch = "wasm32"), inline)]
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    pub fn cct(self) -> Cct {
        // The knots' normals do not cross where a temperature is defined: halve.
        let (mut segment, mut left) = (0, SEGMENTS);
        while left > 1 {
            let half = left / 2;
            if LOCUS.get(segment + half).is_some_and(|knot| along(knot, self) >= 0.0) {
                segment += half;
            }
            left -= half;
        }
        let Some([from, to]) = LOCUS.get(segment..).and_then(|rest| rest.first_chunk()) else {
            return Cct::OffLocus; // never: segment < SEGMENTS
        };
        let (first, last) = (along(from, self), along(to, self));
        // Only the two ends of the table have a point on neither side.
        if first < 0.0 {
            return self.beyond(from, Cct::TooHot);
        }
        if last > 0.0 {
            return self.beyond(to, Cct::TooCold);
        }
        // A point divides the way between two normals nearly as it divides the segment.
        let (s, duv) = Segment::between(from, to).nearest(self, first / (first - last));
        if duv.abs() <= MAX_DUV {
            let place = segment as f32 + s;
            Cct::Near { cct_k: 1e6 / (FIRST + place * (LINEAR + CUBIC * place * place)), duv }
        } else if self.u.is_nan() || self.v.is_nan() {
            Cct::Near { cct_k: f32::NAN, duv: f32::NAN }
        } else {
            Cct::OffLocus
        }
    }

    /// A point beyond an end of the table: `reason`, if it is near the tangent there.
    #[cold]
    #[inline(never)]
    fn beyond(self, end: Knot, reason: Cct) -> Cct {
        let [u, v, _, steepness] = *end;
        let across = (self.v - v) - (self.u - u) * steepness;
        if across * across <= MAX_DUV * MAX_DUV * (1.0 + steepness * steepness) {
            reason
        } else {
            Cct::OffLocus
        }
    }
}

/// One cubic of the locus, in its own parameter 0..=1.
struct Segment {
    start: [f32; 2],
    tangent: [f32; 2],
    bend: [f32; 2],
    twist: [f32; 2],
}

/// u, v, du and dv/du.
type Knot = &'static [f32; 4];

/// How far along the locus `p` lies from knot `k`; the sign says on which side. (In units of the length of a
/// tangent with du = 1, and u rises all along the locus.)
#[inline(always)]
fn along(knot: Knot, p: Uv1960) -> f32 {
    let [u, v, _, steepness] = *knot;
    (p.u - u) + (p.v - v) * steepness
}

impl Segment {
    #[inline(always)]
    fn between(from: Knot, to: Knot) -> Self {
        let ([u0, v0, du0, steep0], [u1, v1, du1, steep1]) = (*from, *to);
        let (across, t0, t1) = ([u1 - u0, v1 - v0], [du0, du0 * steep0], [du1, du1 * steep1]);
        let twist = |i: usize| t0[i] + t1[i] - 2.0 * across[i];
        let twist = [twist(0), twist(1)];
        let bend = |i: usize| across[i] - t0[i] - twist[i];
        Segment { start: [u0, v0], tangent: t0, bend: [bend(0), bend(1)], twist }
    }

    /// Place and signed distance of the point nearest to `p`: one Newton step on (locus - p) . tangent = 0
    /// from `s`, which leaves 4e-4 mired; the Taylor series about `s` gives the point it leads to.
    #[inline(always)]
    fn nearest(&self, p: Uv1960, s: f32) -> (f32, f32) {
        let at = |i: usize, p: f32| {
            (self.start[i] - p) + s * (self.tangent[i] + s * (self.bend[i] + s * self.twist[i]))
        };
        let curve = |i: usize| self.bend[i] + 3.0 * s * self.twist[i]; // half of the second derivative
        let slope = |i: usize| self.tangent[i] + s * (self.bend[i] + curve(i));
        let (a, b, c) = ([at(0, p.u), at(1, p.v)], [slope(0), slope(1)], [curve(0), curve(1)]);
        let speed = b[0] * b[0] + b[1] * b[1] + 2.0 * (a[0] * c[0] + a[1] * c[1]);
        let back = (a[0] * b[0] + a[1] * b[1]) / speed;
        let turn = [back * c[0], back * c[1]];
        let half_turned = [b[0] - turn[0], b[1] - turn[1]];
        let a = [a[0] - back * half_turned[0], a[1] - back * half_turned[1]];
        let b = [half_turned[0] - turn[0], half_turned[1] - turn[1]];
        let cross = a[0] * b[1] - a[1] * b[0];
        (s - back, cross / sqrt(b[0] * b[0] + b[1] * b[1]))
    }
}
