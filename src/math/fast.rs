//! The backend that needs no feature: kernels of this crate, in f32 and without tables.

use crate::math::{Math, cos_turns, sin_turns, sqrt};
use core::f32::consts::{FRAC_PI_2, LN_2, LOG2_E, PI};

/// Computes all functions by f32 kernels of this crate that need few instructions.
///
/// This backend is meant for small processors. It needs no feature, and its results have the same bits on
/// every target. See the [example](crate::math#example).
///
/// # Accuracy
/// Relative, for every f32 of the domain (`tests/spectrum/every_f32.rs`): the square root half a unit in the
/// last place, the cube root 1.45e-7, exp 9e-8, expm1 and ln 1.2e-7, sine and cosine 1.7e-7 absolute. powf:
/// 2e-7 for an exponent of 2.4 and 1.3e-7 for 1/2.4. Where a search over pairs of numbers ended: atan2
/// 1.7e-7, and powf 5.5e-7 with exponents up to 10.
///
/// # Cost
/// Instructions on a Cortex-M4F: the square root 5, the cube root 26, exp 33, expm1 35, ln 30, powf 76, atan2
/// 58, cosine 32, sine 46 (`examples/firmware/src/bin/backends.rs`).
///
/// # Domain
/// NaN gives NaN, except in `powf(NaN, 0)`, which is 1 as in IEEE 754. Overflow gives infinity; underflow
/// gives subnormals, and then 0. `ln(0)` is -inf, and `ln` and `powf` of a negative number are NaN. `atan2`
/// tells the zeros apart as IEEE 754 does. For the sake of speed there are three limits: the cube root of an
/// infinity is NaN, cube roots of subnormals are within 2.3e-13 absolute only, and the exponent of `powf`
/// must be finite.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Fast;

impl Math for Fast {
    #[inline]
    fn sqrt(x: f32) -> f32 {
        sqrt(x)
    }

    fn cbrt(x: f32) -> f32 {
        // Minus a third of the exponent gives 1 / cbrt(x) to 4 %, with the sign. The constants are such that
        // one instruction can hold them.
        let bits = x.to_bits();
        let third = ((u64::from(bits & 0x7fff_ffff) * 0x5555_5555) >> 32) as u32;
        let guess = f32::from_bits(0x5480_0000_u32.wrapping_sub(third) | (bits & 0x8000_0000));
        // The best parabola in x * guess^3 corrects the guess, to 7e-5.
        let cube = x * guess * guess * guess;
        let inverse = guess * (1.884_770_9 - cube * (1.672_421_5 - cube * 0.845_072_8));
        // Newton's step improves cbrt(x) = x * inverse^2. The factor near 2/3 is the one for which rounding
        // errors are smallest.
        let root = x * inverse * inverse;
        root + root * 0.666_664_3 * (1.0 - root * inverse)
    }

    fn exp(x: f32) -> f32 {
        let (doublings, rest) = split(x);
        doubled(1.0 + growth(rest), doublings)
    }

    fn expm1(x: f32) -> f32 {
        let (doublings, rest) = split(x);
        let grown = growth(rest);
        if doublings.abs() < NORMAL {
            let scale = raised(1.0, doublings + WHOLE);
            scale * grown + (scale - 1.0)
        } else {
            far_doubled(1.0 + grown, doublings) - 1.0
        }
    }

    fn ln(x: f32) -> f32 {
        let (exponent, ln) = if is_normal(x) {
            exponent_and_ln(x)
        } else if x == 0.0 {
            return f32::NEG_INFINITY;
        } else if x > 0.0 && x < f32::INFINITY {
            subnormal_exponent_and_ln(x)
        } else {
            return if x > 0.0 { x } else { f32::NAN };
        };
        exponent * LN_2 + ln
    }

    fn powf(x: f32, y: f32) -> f32 {
        if is_normal(x) { power(exponent_and_ln(x), y) } else { power_of_the_rest(x, y) }
    }

    fn atan2(y: f32, x: f32) -> f32 {
        let steep = y.abs() > x.abs();
        let (small, large) = if steep { (x.abs(), y.abs()) } else { (y.abs(), x.abs()) };
        // Two zeros have the ratio 0, and two infinities the ratio 1.
        let ratio = if small != large {
            small / large
        } else if large == 0.0 {
            0.0
        } else {
            1.0
        };
        let s = ratio * ratio;
        let series = 0.043_211_86 - s * (0.016_367_927 - s * 0.002_920_691_8);
        let series = 0.142_110_56 - s * (0.106_660_05 - s * (0.075_522_14 - s * series));
        let series = s * (0.333_331_53 - s * (0.199_937_73 - s * series));
        let angle = ratio - ratio * series;
        let angle = if steep { FRAC_PI_2 - angle } else { angle };
        let angle = if x.is_sign_negative() { PI - angle } else { angle };
        angle.copysign(y)
    }

    #[inline]
    fn cos_turns(turns: f32) -> f32 {
        cos_turns(turns)
    }

    #[inline]
    fn sin_turns(turns: f32) -> f32 {
        sin_turns(turns)
    }
}

/// 1.5 * 2^23. Numbers near it have no fraction in f32, and their low bits count up and down like an
/// integer's.
const WHOLE: f32 = 12_582_912.0;

/// 2 to the power of -126..=126 is normal, and so are numbers within a factor of root 2 of it.
const NORMAL: f32 = 126.0;

/// x in doublings, which is x / ln 2, and what remains of x without the nearest whole number of them: within
/// 0.35.
fn split(x: f32) -> (f32, f32) {
    let doublings = x * LOG2_E;
    let n = doublings + WHOLE - WHOLE;
    // 355/512 has nine bits, so n times it is exact, and so is the difference.
    (doublings, x - n * 0.693_359_375 + n * 2.121_944_4e-4)
}

/// exp(x) - 1 for |x| < 0.35, with an error of 3e-9 of exp(x).
fn growth(x: f32) -> f32 {
    let series = 0.041_668_39 + x * (0.008_368_75 + x * 0.001_381_45);
    x + x * x * (0.499_999_93 + x * (0.166_665_2 + x * series))
}

/// x * 2^n, where n is the nearest whole number of `doublings` and x is within a factor of root 2 of 1.
fn doubled(x: f32, doublings: f32) -> f32 {
    if doublings.abs() < NORMAL { raised(x, doublings + WHOLE) } else { far_doubled(x, doublings) }
}

/// x * 2^n where the result is normal; `counter` is n + [`WHOLE`].
fn raised(x: f32, counter: f32) -> f32 {
    f32::from_bits(x.to_bits().wrapping_add(counter.to_bits() << 23))
}

/// Computes as [`doubled`] does where the result may be infinite, subnormal, zero or NaN.
#[cold]
#[inline(never)]
fn far_doubled(x: f32, doublings: f32) -> f32 {
    if doublings.abs() < 160.0 {
        // With two factors neither of them overflows, and only the second product is rounded.
        let half = 0.5 * doublings + WHOLE;
        let rest = doublings + WHOLE - (half - WHOLE);
        x * raised(1.0, half) * raised(1.0, rest)
    } else if doublings > 0.0 {
        f32::INFINITY
    } else if doublings < 0.0 {
        0.0
    } else {
        doublings // NaN
    }
}

/// Whether a number is above zero, and neither subnormal nor infinite nor NaN.
fn is_normal(x: f32) -> bool {
    x.to_bits().wrapping_sub(0x0080_0000) < 0x7f00_0000
}

/// e and ln(m) for a normal x = m * 2^e > 0, with m from root 1/2 to root 2.
fn exponent_and_ln(x: f32) -> (f32, f32) {
    let bits = x.to_bits();
    let exponent = bits.wrapping_sub(0x3f35_04f3) & 0xff80_0000;
    let f = f32::from_bits(bits.wrapping_sub(exponent)) - 1.0;
    // ln(1 + f) = 2 atanh(s) and 2 s = f - s f, so an error of s counts only in proportion to f.
    let s = f / (2.0 + f);
    let t = s * s;
    let series = t * (0.666_667_77 + t * (0.399_774_8 + t * 0.298_735));
    ((exponent as i32 >> 23) as f32, f - s * (f - series))
}

#[cold]
#[inline(never)]
fn subnormal_exponent_and_ln(x: f32) -> (f32, f32) {
    let (exponent, ln) = exponent_and_ln(x * 16_777_216.0);
    (exponent - 24.0, ln)
}

/// (2^exponent e^ln)^y.
fn power((exponent, ln): (f32, f32), y: f32) -> f32 {
    // Twelve bits of y times the exponent are exact, so the whole part can be subtracted without loss.
    let head = f32::from_bits(y.to_bits() & 0xffff_f000);
    let tail = y - head;
    let doublings = y * exponent + y * ln * LOG2_E;
    let n = doublings + WHOLE - WHOLE;
    let rest = ((head * exponent - n) + tail * exponent) * LN_2 + y * ln;
    doubled(1.0 + growth(rest), doublings)
}

/// Powers of numbers that are not positive normal numbers: 0, infinity, NaN, negative and subnormal ones.
#[cold]
#[inline(never)]
fn power_of_the_rest(x: f32, y: f32) -> f32 {
    if y == 0.0 {
        1.0
    } else if x.is_nan() || y.is_nan() || x < 0.0 {
        f32::NAN
    } else if x == 0.0 || x == f32::INFINITY {
        if (x == 0.0) == (y > 0.0) { 0.0 } else { f32::INFINITY }
    } else {
        power(subnormal_exponent_and_ln(x), y)
    }
}
