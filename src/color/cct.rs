//! Correlated color temperature, and distance from the Planckian locus.

use crate::color::{Uv1960, Xyz};
use crate::math::sqrt;
use core::fmt;

include!(concat!(env!("OUT_DIR"), "/locus.rs"));

/// The number of segments of the locus table.
pub(in crate::color) const SEGMENTS: usize = LOCUS.len() - 1;

/// The largest distance from the locus at which CIE 15 gives a correlated color temperature a meaning, with
/// room for the rounding of u and v. (The radius of curvature of the locus goes down to 0.1001, and a point
/// that is further away has no unique nearest point.)
pub(in crate::color) const MAX_DUV: f32 = 0.05 + 2e-7;

/// A correlated color temperature with its Duv, or the reason why a color has none.
///
/// [`Xyz::cct`] and [`Uv1960::cct`] return it. Match on it to handle each case, or call
/// [`near`](Cct::near) if the reason does not matter.
///
/// # Example
/// ```
/// use nanospectra::color::{Cct, Xy};
/// let found = |x, y| Xy::new(x, y).uv1960().cct();
/// let (cct_k, duv) = found(0.3127, 0.3290).near().ok_or("D65 is a white")?;
/// assert!((cct_k - 6504.0).abs() < 2.0 && (duv - 0.0032).abs() < 1e-4);
///
/// assert_eq!(found(0.15, 0.70), Cct::OffLocus); // a green
/// assert_eq!(found(0.68, 0.32), Cct::TooCold); // a red
/// assert_eq!(found(0.235, 0.225), Cct::TooHot); // a blue
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Cct {
    /// The color is near the Planckian locus and has a correlated color temperature.
    ///
    /// See the [example](Xyz::cct).
    Near {
        /// The temperature of the black body that comes nearest, in K, 1000..=1e6.
        cct_k: f32,
        /// The distance from the locus in the CIE 1960 plane, which is positive above it (greenish) and
        /// negative below (pinkish), within -0.05..=0.05.
        duv: f32,
    },
    /// The color is further than 0.05 from the locus: it is not a white, and has no color temperature.
    ///
    /// See the [example](Cct#example).
    OffLocus,
    /// The color is near the locus but redder than a black body of 1000 K.
    ///
    /// See the [example](Cct#example).
    TooCold,
    /// The color is near the locus but bluer than a black body of a million K.
    ///
    /// See the [example](Cct#example).
    TooHot,
}

impl Cct {
    /// Returns the temperature in K and Duv, or `None` if the color has no temperature.
    ///
    /// See the [example](Cct#example).
    #[must_use]
    pub const fn near(self) -> Option<(f32, f32)> {
        match self {
            Cct::Near { cct_k, duv } => Some((cct_k, duv)),
            _ => None,
        }
    }

    /// The size in bytes of the table that [`Uv1960::cct`] reads.
    pub const TABLE_BYTES: usize = size_of_val(&LOCUS);
}

impl fmt::Display for Cct {
    /// Writes `6503 K, Duv +0.0032`, or the reason why there is no temperature.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Cct::Near { cct_k, duv } if cct_k.is_finite() && duv.is_finite() => {
                return write!(f, "{cct_k:.0} K, Duv {duv:+.4}");
            }
            Cct::Near { .. } => "not a color: its chromaticity is not a number",
            Cct::OffLocus => "not a white: more than 0.05 from the Planckian locus",
            Cct::TooCold => "redder than a black body of 1000 K",
            Cct::TooHot => "bluer than a black body of a million K",
        })
    }
}

impl Xyz {
    /// Finds the correlated color temperature and Duv of this color, as [`Uv1960::cct`] does.
    ///
    /// The color must be one of the CIE 1931 2 degree observer. The result is `None` for black, which has no
    /// chromaticity.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::color::{Cct, Xyz};
    /// let d65 = Xyz::new(95.047, 100.0, 108.883);
    /// let cct = d65.cct().ok_or("black")?;
    /// assert!(matches!(cct, Cct::Near { cct_k, duv } if (6502.0..6506.0).contains(&cct_k) && duv > 0.0));
    /// assert_eq!(cct.to_string(), "6503 K, Duv +0.0032");
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
    /// Finds the correlated color temperature and Duv: the temperature of the black body that comes nearest,
    /// and the distance to it.
    ///
    /// The chromaticity must be one of the CIE 1931 2 degree observer. Color temperatures are defined with
    /// c2 = 1.4388e-2 m K in Planck's law; the light of a black body by today's constants therefore reads
    /// 1.6e-5 of T higher than its temperature. NaN gives NaN.
    ///
    /// # Accuracy
    /// 0.009 mired and 2e-7 in Duv over 1000 K..1e6 K and |Duv| <= 0.05 (swept in `tests/color/cct.rs`);
    /// 0.009 mired are 0.4 K at 6500 K.
    ///
    /// # Cost
    /// A table of 400 bytes, a search by halves, one Newton step and one square root.
    ///
    /// # Reference
    /// CIE 15:2018, 9.5; Ohno, Leukos 10 (2014) for Duv. The locus is a Hermite curve through 25 knots, which
    /// are computed from the CIE 1931 functions when the crate is built.
    ///
    /// # Example
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
        self.nearest_of(&LOCUS)
    }

    /// Finds the same to 0.002 mired, by a table of 784 bytes, for color rendering, which multiplies errors
    /// of the temperature.
    #[cfg(feature = "libm")]
    pub(super) fn fine_cct(self) -> Cct {
        self.nearest_of(&FINE_LOCUS)
    }

    /// Finds the place that is nearest on a locus with these knots. (It is one function in a web page, where
    /// bytes count, and on other targets a function of its own for each locus.)
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    fn nearest_of(self, locus: &'static [[f32; 4]]) -> Cct {
        let pieces = locus.len() - 1;
        // Halve the table until one segment is left. This works because the normals at the knots do not
        // cross each other where a temperature is defined.
        let (mut segment, mut left) = (0, pieces);
        while left > 1 {
            let half = left / 2;
            if locus.get(segment + half).is_some_and(|knot| along(knot, self) >= 0.0) {
                segment += half;
            }
            left -= half;
        }
        let Some([from, to]) = locus.get(segment..).and_then(|rest| rest.first_chunk()) else {
            return Cct::OffLocus; // never happens, because segment < pieces
        };
        let (first, last) = (along(from, self), along(to, self));
        // After the search the point lies between the two knots, unless it is beyond an end of the table.
        if first < 0.0 {
            return self.beyond(from, Cct::TooHot);
        }
        if last > 0.0 {
            return self.beyond(to, Cct::TooCold);
        }
        // The distances from the two normals have nearly the ratio in which the nearest point divides the
        // segment: that is where the Newton step starts.
        let (s, duv) = Segment::between(from, to).nearest(self, first / (first - last));
        if duv.abs() <= MAX_DUV {
            let place = (segment as f32 + s) * (SEGMENTS as f32 / pieces as f32);
            Cct::Near { cct_k: 1e6 / (FIRST + place * (LINEAR + CUBIC * place * place)), duv }
        } else if self.u.is_nan() || self.v.is_nan() {
            Cct::Near { cct_k: f32::NAN, duv: f32::NAN }
        } else {
            Cct::OffLocus
        }
    }

    /// Judges a point beyond an end of the table: `reason` if it is near the tangent there, else `OffLocus`.
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

/// One cubic piece of the locus, whose parameter goes from 0 to 1.
pub(in crate::color) struct Segment {
    start: [f32; 2],
    tangent: [f32; 2],
    bend: [f32; 2],
    twist: [f32; 2],
}

/// A knot of the locus: u, v, du and dv/du.
type Knot = &'static [f32; 4];

/// Returns how far along the locus `p` lies from a knot, with a sign that says on which side. (The unit is
/// the length of a tangent with du = 1; u rises all along the locus.)
#[inline(always)]
fn along(knot: Knot, p: Uv1960) -> f32 {
    let [u, v, _, steepness] = *knot;
    (p.u - u) + (p.v - v) * steepness
}

impl Segment {
    #[inline(always)]
    pub(in crate::color) fn between(from: Knot, to: Knot) -> Self {
        let ([u0, v0, du0, steep0], [u1, v1, du1, steep1]) = (*from, *to);
        let (across, t0, t1) = ([u1 - u0, v1 - v0], [du0, du0 * steep0], [du1, du1 * steep1]);
        let twist = |i: usize| t0[i] + t1[i] - 2.0 * across[i];
        let twist = [twist(0), twist(1)];
        let bend = |i: usize| across[i] - t0[i] - twist[i];
        Segment { start: [u0, v0], tangent: t0, bend: [bend(0), bend(1)], twist }
    }

    /// Returns the point of the cubic at the parameter `s`, and its derivative there.
    pub(in crate::color) fn at(&self, s: f32) -> ([f32; 2], [f32; 2]) {
        let point = |i: usize| self.start[i] + s * (self.tangent[i] + s * (self.bend[i] + s * self.twist[i]));
        let slope = |i: usize| self.tangent[i] + s * (2.0 * self.bend[i] + 3.0 * s * self.twist[i]);
        ([point(0), point(1)], [slope(0), slope(1)])
    }

    /// Finds the point of the cubic that is nearest to `p`, and returns its parameter and signed distance.
    ///
    /// It takes one Newton step on (locus - p) . tangent = 0 from `s`, which leaves an error of 4e-4 mired.
    /// The Taylor series about `s` gives the point to which the step leads.
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
