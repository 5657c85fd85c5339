//! Correlated color temperature in integers.
//!
//! A point between the normals of two knots of the locus has distances d0 and d1 to them along their
//! tangents. The ratio d0 : -d1 is nearly that in which the point divides the locus between the knots. What
//! is missing is a parabola that depends on the distance from the locus. So one division and a dozen products
//! replace the Newton step of the floats, at 0.11 mired.

include!(concat!(env!("OUT_DIR"), "/fixed_locus.rs"));

/// The number of segments of the table.
const SEGMENTS: usize = FIXED_LOCUS.len() - 1;
/// A Duv of 0.05 in units of 2^-20, with room for the error of the formula; and a distance at which a point
/// is surely off the locus, in units of 2^-18.
const MAX_DUV: i32 = 52_429 + 32;
const FAR: i32 = 16_384;
/// By how much the sign of a coarse distance may be wrong, in units of 2^-30.
const SLACK: i32 = 16 << 14;
/// 1 mired and 1000 mired in 4096ths, with room for rounding: 1/100 of a mired at the cold end, 1/20 at the
/// hot.
const HOTTEST: u32 = 4096 - 205;
const COLDEST: u32 = 4_096_000 + 41;

/// A color temperature and Duv in integers, or the reason why a color has none.
///
/// It says what [`Cct`](crate::color::Cct) says in floats.
///
/// [`FixedXyz::cct`](crate::sensor::fixed::FixedXyz::cct) returns it.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::fixed::{FixedCct, FixedXyz};
///
/// // CIE illuminant A, X = 109.85, Y = 100, Z = 35.585, in units of 2^-20: 2856 K, on the locus.
/// let a = FixedXyz::new([109.85, 100.0, 35.585].map(|value: f32| (value * 1048576.0) as i32), 20);
/// let Some(FixedCct::Near { cct_k, mired_e3, duv_e6 }) = a.cct() else { return };
/// assert!((2855..=2857).contains(&cct_k) && (350_000..350_400).contains(&mired_e3) && duv_e6.abs() < 60);
/// // A saturated green has no color temperature.
/// assert_eq!(FixedXyz::new([20 << 20, 100 << 20, 5 << 20], 20).cct(), Some(FixedCct::OffLocus));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum FixedCct {
    /// The color is near the locus of black bodies and has a color temperature. See the [example](#example).
    Near {
        /// The temperature of the nearest black body, rounded to whole K. It lies within 1000..=1 000 000
        /// (and 5 % more, for rounding).
        cct_k: u32,
        /// The reciprocal of the temperature in thousandths of a mired, which keeps what whole kelvins lose
        /// at the cold end.
        mired_e3: u32,
        /// The distance from the locus in the CIE 1960 plane in millionths, which is positive above it
        /// (greenish).
        duv_e6: i32,
    },
    /// The color is further than 0.05 from the locus, so that it is not a white and has no color temperature.
    /// See the [example](#example).
    OffLocus,
    /// The color is redder than a black body of 1000 K.
    TooCold,
    /// The color is bluer than a black body of a million K.
    TooHot,
}

/// A knot of the locus, and how its segment differs from a straight line.
struct Knot {
    /// u and v in units of 2^-20, and the unit tangent there in units of 2^-14.
    u: i32,
    v: i32,
    tangent: [i16; 2],
    /// The parabola along the locus, in units of 2^-15: at Duv 0, and what Duv 1 adds.
    bulge: [i16; 2],
    /// The parabola across the locus, for each d0 d1 and in units of 1/64: at Duv 0, and what Duv 1 adds.
    sagitta: [i16; 2],
}

impl FixedCct {
    /// The color temperature of u and v in units of 2^-20.
    pub(super) fn of([u, v]: [i32; 2]) -> Self {
        let (mut segment, mut left) = (0, SEGMENTS);
        while left > 1 {
            let half = left / 2;
            if FIXED_LOCUS.get(segment + half).is_some_and(|knot| knot.along_from_afar(u, v) >= 0) {
                segment += half;
            }
            left -= half;
        }
        let Some([from, to]) = FIXED_LOCUS.get(segment..).and_then(|rest| rest.first_chunk()) else {
            return FixedCct::OffLocus; // never happens, since segment < SEGMENTS
        };
        // Only at the two ends of the table can a point be on neither side, and there nothing has a
        // temperature.
        let (first, last) = (from.along_from_afar(u, v), to.along_from_afar(u, v));
        if first < -SLACK || last > SLACK {
            let (end, reason) = if first < 0 { (from, FixedCct::TooHot) } else { (to, FixedCct::TooCold) };
            return if end.across_from_afar(u, v).abs() <= MAX_DUV >> 2 {
                reason
            } else {
                FixedCct::OffLocus
            };
        }
        if from.across_from_afar(u, v).abs() > FAR {
            return FixedCct::OffLocus;
        }
        let (d0, d1) = (from.along(u, v), to.along(u, v));
        let r = share(d0, d0 - d1);
        // Both distances across, in units of 2^-20; then their weighted mean, and what the locus bends away
        // from both tangents.
        let (n0, n1) = (from.across(u, v) >> 14, to.across(u, v) >> 14);
        let mean = n0 + (((n1 - n0) * r) >> 15);
        let product = ((d0 >> 14) * (d1 >> 14)) >> 14;
        let [sagitta, steeper] = from.sagitta.map(i32::from);
        let duv = mean + ((product * (sagitta + ((steeper * mean) >> 20))) >> 12);
        if duv.abs() > MAX_DUV {
            return FixedCct::OffLocus;
        }
        let [bulge, with_duv] = from.bulge.map(i32::from);
        let s = r + ((((r * (32_768 - r)) >> 15) * (bulge + ((with_duv * duv) >> 20))) >> 15);
        // The mired at k + s, which are 17 k + 11/256 k^3; in 256ths they are a + s (b + s (c + 11 s)).
        let k = segment as i32;
        let (a, b, c) = (k * (4352 + 11 * k * k), 4352 + 33 * k * k, 33 * k);
        let more = s * (b + ((s * (c + ((s * 11) >> 15))) >> 15));
        let mired = ((a << 4) + (more >> 11)) as u32;
        if mired < HOTTEST || more < 0 && a == 0 {
            FixedCct::TooHot
        } else if mired > COLDEST {
            FixedCct::TooCold
        } else {
            // Duv in millionths: 10^6 / 2^20 = 15625 / 2^14.
            FixedCct::Near {
                // The temperature in K: 10^6 * 4096 / mired = 2^21 * 15625 / (8 mired).
                cct_k: quotient(15_625, 8 * mired, 21) as u32,
                mired_e3: (mired * 125) >> 9,
                duv_e6: (duv * 15_625) >> 14,
            }
        }
    }
}

impl Knot {
    /// How far along the locus a point lies from here, in units of 2^-34, for points within 0.12.
    fn along(&self, u: i32, v: i32) -> i32 {
        (u - self.u) * i32::from(self.tangent[0]) + (v - self.v) * i32::from(self.tangent[1])
    }

    /// How far above the locus a point lies, in units of 2^-34, for points within 0.12.
    fn across(&self, u: i32, v: i32) -> i32 {
        (v - self.v) * i32::from(self.tangent[0]) - (u - self.u) * i32::from(self.tangent[1])
    }

    /// As [`along`](Self::along), in units of 2^-30, for all points.
    fn along_from_afar(&self, u: i32, v: i32) -> i32 {
        ((u - self.u) >> 4) * i32::from(self.tangent[0]) + ((v - self.v) >> 4) * i32::from(self.tangent[1])
    }

    /// As [`across`](Self::across), in units of 2^-18, for all points.
    fn across_from_afar(&self, u: i32, v: i32) -> i32 {
        (((v - self.v) >> 4) * i32::from(self.tangent[0]) - ((u - self.u) >> 4) * i32::from(self.tangent[1]))
            >> 12
    }
}

/// Computes part / whole in units of 2^-15, for -whole < part < 2 whole and 0 < whole < 2^30.
fn share(part: i32, whole: i32) -> i32 {
    let (size, whole) = (part.unsigned_abs(), whole as u32);
    let digits =
        if size < whole { quotient(size, whole, 15) } else { 32_768 + quotient(size - whole, whole, 15) };
    if part < 0 { -digits } else { digits }
}

/// Computes numerator / denominator in units of 2^-digits, rounded, for numerator < denominator < 2^31.
///
/// It finds one binary digit at a time, since a Cortex-M0 has no division. (The compiler's own is as quick
/// and takes 400 bytes.)
#[inline(never)]
pub(super) fn quotient(numerator: u32, denominator: u32, digits: u32) -> i32 {
    let (mut rest, mut found, mut left) = (numerator, 0, digits + 1);
    while left > 0 {
        rest <<= 1;
        found <<= 1;
        if rest >= denominator {
            rest -= denominator;
            found += 1;
        }
        left -= 1;
    }
    (found + 1) >> 1
}
