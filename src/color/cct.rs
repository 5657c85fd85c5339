//! Correlated colour temperature and distance from the Planckian locus.

use crate::color::Uv1960;
use crate::math::sqrt;

include!(concat!(env!("OUT_DIR"), "/locus.rs"));

/// Segments of the locus table, and the mired at the end of the last one.
const SEGMENTS: usize = LOCUS.len() - 1;
const COLDEST_MIRED: f32 = 1000.0;
/// Knot k is at k^2 times this.
const MIRED_SCALE: f32 = COLDEST_MIRED / (SEGMENTS * SEGMENTS) as f32;
const HOTTEST_MIRED: f32 = 1.0;
/// What rounding of u, v may put a point beyond an end of the range, in mired.
const SLACK_MIRED: f32 = 0.01;
/// CIE 15: a correlated colour temperature has no meaning further than this from the locus. (Its
/// radius of curvature goes down to 0.1001 there, and points beyond that have no nearest one.)
const MAX_DUV: f32 = 0.05;
const DUV_SLACK: f32 = 2e-7;

/// The outcome of asking for a correlated colour temperature.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Cct {
    /// A colour near the locus.
    Near {
        /// Temperature of the nearest black body, K, 1000..=1e6.
        cct_k: f32,
        /// Distance from the locus in the CIE 1960 plane, above it (greenish) positive; |duv| <= 0.05.
        duv: f32,
    },
    /// Further than 0.05 from the locus: not a white, it has no colour temperature.
    OffLocus,
    /// Redder than a black body of 1000 K.
    TooCold,
    /// Bluer than a black body of a million K.
    TooHot,
}

impl Cct {
    /// Temperature in K and Duv, if there are such numbers.
    #[must_use]
    pub const fn near(self) -> Option<(f32, f32)> {
        match self {
            Cct::Near { cct_k, duv } => Some((cct_k, duv)),
            _ => None,
        }
    }
}

impl Uv1960 {
    /// The temperature of the nearest black body and the distance to it, for a chromaticity of
    /// the CIE 1931 2 degree observer.
    ///
    /// Planck's law with c2 = 1.4388e-2 m K as colour temperatures are defined: a black body by
    /// today's constants reads 1.6e-5 of T higher. NaN gives NaN.
    ///
    /// # Accuracy
    /// 0.015 mired and 2e-7 in Duv over 1000 K..1e6 K and |Duv| <= 0.05 (swept in `tests/cct.rs`);
    /// 0.015 mired are 0.6 K at 6500 K.
    ///
    /// # Cost
    /// 496 bytes of table; a binary search, two Newton steps and one square root.
    ///
    /// # Reference
    /// CIE 15:2018, 9.5; Ohno, Leukos 10 (2014) for Duv. The locus is a Hermite curve through 31
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
    pub fn cct(self) -> Cct {
        if self.u.is_nan() || self.v.is_nan() {
            return Cct::Near { cct_k: f32::NAN, duv: f32::NAN };
        }
        if self.u.is_infinite() || self.v.is_infinite() {
            return Cct::OffLocus;
        }
        let (mired, duv) = if along(0, self) < 0.0 {
            beyond(0, self)
        } else if along(SEGMENTS, self) > 0.0 {
            beyond(SEGMENTS, self)
        } else {
            // The knots' normals do not cross where a temperature is defined: halve.
            let (mut segment, mut stride) = (0, 16);
            while stride > 0 {
                if segment + stride < SEGMENTS && along(segment + stride, self) >= 0.0 {
                    segment += stride;
                }
                stride /= 2;
            }
            Segment::of(segment).nearest(self)
        };
        if duv.is_nan() || duv.abs() > MAX_DUV + DUV_SLACK {
            Cct::OffLocus
        } else if mired > COLDEST_MIRED + SLACK_MIRED {
            Cct::TooCold
        } else if mired < HOTTEST_MIRED - SLACK_MIRED {
            Cct::TooHot
        } else {
            Cct::Near { cct_k: 1e6 / mired, duv }
        }
    }
}

/// One cubic of the locus, in its own parameter 0..=1.
struct Segment {
    start: [f32; 2],
    tangent: [f32; 2],
    bend: [f32; 2],
    twist: [f32; 2],
    /// Mired at the start, and across the segment.
    mired: f32,
    width: f32,
}

fn knot(k: usize) -> [f32; 4] {
    LOCUS.get(k).copied().unwrap_or([0.0; 4])
}

/// How far along the locus `p` lies from knot `k`; the sign says on which side.
fn along(k: usize, p: Uv1960) -> f32 {
    let [u, v, du, dv] = knot(k);
    (p.u - u) * du + (p.v - v) * dv
}

/// Mired and distance of a point beyond an end, from the tangent there.
fn beyond(k: usize, p: Uv1960) -> (f32, f32) {
    let [u, v, du, dv] = knot(k);
    let speed = du * du + dv * dv;
    let cross = (p.v - v) * du - (p.u - u) * dv;
    (MIRED_SCALE * (k * k) as f32 + along(k, p) / speed, cross / sqrt(speed))
}

impl Segment {
    /// The cubic between knots `k` and `k + 1`.
    fn of(k: usize) -> Self {
        let width = MIRED_SCALE * (2 * k + 1) as f32;
        let ([u0, v0, du0, dv0], [u1, v1, du1, dv1]) = (knot(k), knot(k + 1));
        let (across, t0, t1) = ([u1 - u0, v1 - v0], [du0 * width, dv0 * width], [du1 * width, dv1 * width]);
        let bend = |i: usize| 3.0 * across[i] - 2.0 * t0[i] - t1[i];
        let twist = |i: usize| t0[i] + t1[i] - 2.0 * across[i];
        Segment {
            start: [u0, v0],
            tangent: t0,
            bend: [bend(0), bend(1)],
            twist: [twist(0), twist(1)],
            mired: MIRED_SCALE * (k * k) as f32,
            width,
        }
    }

    /// Mired and signed distance of the nearest point: Newton on (locus - p) . tangent = 0.
    fn nearest(&self, p: Uv1960) -> (f32, f32) {
        let offset = [self.start[0] - p.u, self.start[1] - p.v];
        let mut s = 0.5;
        let mut step = 0;
        loop {
            let at = |i: usize| offset[i] + s * (self.tangent[i] + s * (self.bend[i] + s * self.twist[i]));
            let slope = |i: usize| self.tangent[i] + s * (2.0 * self.bend[i] + 3.0 * s * self.twist[i]);
            let curve = |i: usize| 2.0 * self.bend[i] + 6.0 * s * self.twist[i];
            let (a, b) = ([at(0), at(1)], [slope(0), slope(1)]);
            if step == 3 {
                let cross = a[0] * b[1] - a[1] * b[0];
                return (self.mired + s * self.width, cross / sqrt(b[0] * b[0] + b[1] * b[1]));
            }
            let speed = b[0] * b[0] + b[1] * b[1] + a[0] * curve(0) + a[1] * curve(1);
            s -= (a[0] * b[0] + a[1] * b[1]) / speed;
            step += 1;
        }
    }
}
