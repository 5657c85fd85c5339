//! Every maths backend against f64, over the whole domain of every function; and the roots, which must be the same
//! on every machine. `NANOSPECTRA_EXHAUSTIVE=1` tries every f32 there is.

mod allowed;
mod model;

use allowed::check;
use nanospectra::math;

/// The functions that a backend has, where a feature provides one.
#[cfg(any(feature = "libm", feature = "std", feature = "micromath"))]
mod near_f64 {
    use super::allowed::check;
    use nanospectra::math::{self, Math};
    use std::f64::consts::TAU;

    /// The positive f32 from `low` to `high`, 300 thousand of them, spread over all sizes.
    fn spread(low: f32, high: f32) -> impl Iterator<Item = f32> {
        let (low, high) = (low.to_bits(), high.to_bits());
        // Odd, so that all low bits get their turn.
        let stride = ((high - low) / 300_000) | 1;
        (low..=high).step_by(stride as usize).map(f32::from_bits)
    }

    /// The same and its mirror image.
    fn both(low: f32, high: f32) -> impl Iterator<Item = f32> {
        spread(low, high).flat_map(|x| [x, -x])
    }

    /// Compares one function of one number.
    fn one(what: &'static str, inputs: impl Iterator<Item = f32>, f: fn(f32) -> f32, exact: fn(f64) -> f64) {
        let mut check = check(what);
        let mut count = 0;
        for x in inputs {
            check.value(&format!("{x:e}"), f(x).into(), exact(x.into()));
            count += 1;
        }
        assert!(count > 100_000, "{what}: {count} inputs");
        check.tight(count);
    }

    /// Compares one function of two numbers.
    fn two(what: &'static str, inputs: &[(f32, f32)], f: fn(f32, f32) -> f32, exact: fn(f64, f64) -> f64) {
        let mut check = check(what);
        for (x, y) in inputs {
            check.value(&format!("{x:e}, {y:e}"), f(*x, *y).into(), exact((*x).into(), (*y).into()));
        }
        assert!(inputs.len() > 100_000, "{what}: {} inputs", inputs.len());
        check.tight(inputs.len());
    }

    /// Bases and exponents that colour needs: signals 1e-6..=1e4, exponents of transfer functions and of five.
    fn powers() -> Vec<(f32, f32)> {
        let exponents =
            [1.0 / 2.4, 2.4, 0.45, 1.0 / 0.45, 0.159_301_76, 78.843_75 / 8.0, 1.0 / 3.0, 5.0, -2.0];
        let bases = spread(1e-3, 1e3).step_by(11);
        bases.flat_map(|x| exponents.map(|y| (x, y))).collect()
    }

    /// Points all around the origin, near and far.
    fn points() -> Vec<(f32, f32)> {
        let sizes = spread(1e-3, 1e3).step_by(300);
        let angles: Vec<f32> = (0..720).map(|k| (k as f32 * 0.5 + 0.123).to_radians()).collect();
        sizes
            .flat_map(|r| angles.iter().map(move |a| (r * a.sin(), r * a.cos())).collect::<Vec<_>>())
            .collect()
    }

    /// Turns from a millionth to a million.
    fn turns() -> impl Iterator<Item = f32> {
        both(1e-6, 1e6)
    }

    fn exact_cos(turns: f64) -> f64 {
        (TAU * (turns - turns.round())).cos()
    }

    fn exact_sin(turns: f64) -> f64 {
        (TAU * (turns - turns.round())).sin()
    }

    /// One test for each backend; the names are those of the table of allowed errors.
    macro_rules! backend {
        ($test:ident $name:literal $m:ty, turns to $turns:literal) => {
            #[test]
            fn $test() {
                one(concat!($name, " sqrt"), spread(f32::MIN_POSITIVE, f32::MAX), <$m>::sqrt, f64::sqrt);
                one(concat!($name, " cbrt"), both(f32::MIN_POSITIVE, f32::MAX), <$m>::cbrt, f64::cbrt);
                one(concat!($name, " exp"), both(1e-6, 87.0), <$m>::exp, f64::exp);
                one(concat!($name, " expm1"), both(1e-12, 87.0), <$m>::expm1, f64::exp_m1);
                one(concat!($name, " ln"), spread(f32::MIN_POSITIVE, f32::MAX), <$m>::ln, f64::ln);
                two(concat!($name, " powf"), &powers(), <$m>::powf, f64::powf);
                two(concat!($name, " atan2"), &points(), <$m>::atan2, f64::atan2);
                let few = |x: &f32| x.abs() <= $turns;
                one(concat!($name, " cos"), turns().filter(few), <$m>::cos_turns, exact_cos);
                one(concat!($name, " sin"), turns().filter(few), <$m>::sin_turns, exact_sin);
            }
        };
    }

    #[cfg(feature = "libm")]
    backend!(the_portable_backend_is_near_f64 "Portable" math::Portable, turns to 1e6);
    // In radians the reduction of large angles is the caller's rounding: compared where it does not count.
    #[cfg(feature = "libm")]
    backend!(the_libm_backend_is_near_f64 "Libm" math::Libm, turns to 1.0);
    // Other platforms have another library, with other last bits.
    #[cfg(all(feature = "std", target_os = "linux", target_arch = "x86_64"))]
    backend!(the_std_backend_is_near_f64 "Std" math::Std, turns to 1e6);
    #[cfg(feature = "micromath")]
    backend!(the_micromath_backend_is_as_far_off_as_its_page_says "Micromath" math::Micromath, turns to 1.0);

    #[cfg(feature = "libm")]
    #[test]
    fn portable_functions_at_the_edges_of_their_domains() {
        use math::Portable;
        assert_eq!((Portable::exp(0.0), Portable::expm1(0.0), Portable::ln(1.0)), (1.0, 0.0, 0.0));
        assert_eq!((Portable::exp(-200.0), Portable::exp(200.0)), (0.0, f32::INFINITY));
        assert_eq!((Portable::expm1(-200.0), Portable::ln(0.0)), (-1.0, f32::NEG_INFINITY));
        assert_eq!(
            (Portable::powf(0.0, 2.4), Portable::powf(7.0, 0.0), Portable::powf(1.0, 9.0)),
            (0.0, 1.0, 1.0)
        );
        assert_eq!(Portable::atan2(0.0, 0.0), 0.0);
        assert!(Portable::ln(-1.0).is_nan() && Portable::sqrt(-1.0).is_nan());
        for f in [
            Portable::sqrt,
            Portable::cbrt,
            Portable::exp,
            Portable::expm1,
            Portable::ln,
            Portable::cos_turns,
        ] {
            assert!(f(f32::NAN).is_nan());
        }
        // Whole, half and quarter turns are exact, however many.
        for k in [0.0, 1.0, -3.0, 1000.0, 8_388_607.0, 1e30] {
            assert_eq!((math::cos_turns(k), math::sin_turns(k)), (1.0, 0.0), "{k} turns");
        }
        for (turns, cos, sin) in [(0.25, 0.0, 1.0), (0.5, -1.0, 0.0), (0.75, 0.0, -1.0), (-0.25, 0.0, -1.0)] {
            let (c, s) = (math::cos_turns(turns), math::sin_turns(turns));
            assert!((c - cos).abs() < 1e-7 && (s - sin).abs() < 1e-7, "{turns} turns: {c}, {s}");
        }
        for x in [f32::INFINITY, f32::NEG_INFINITY, f32::NAN] {
            assert!(math::cos_turns(x).is_nan() && math::sin_turns(x).is_nan(), "{x} turns");
        }
    }
}

/// Every f32 if asked for; otherwise every 251st, and all of those from 1 to 4: the root of any
/// other is one of theirs with another exponent.
fn all_f32() -> Box<dyn Iterator<Item = u32>> {
    if std::env::var_os("NANOSPECTRA_EXHAUSTIVE").is_some() {
        return Box::new(0..=u32::MAX);
    }
    Box::new((0..=u32::MAX).step_by(251).chain(1.0f32.to_bits()..=4.0f32.to_bits()))
}

#[test]
fn the_square_root_is_the_hardwares_for_every_f32() {
    let mut count = 0u64;
    all_f32().for_each(|bits| {
        let x = f32::from_bits(bits);
        let (own, hardware) = (math::sqrt(x), x.sqrt());
        let same = own.to_bits() == hardware.to_bits() || own.is_nan() && hardware.is_nan();
        assert!(same, "{x:e} ({bits:#010x}): {own:e}, the hardware says {hardware:e}");
        count += 1;
    });
    assert!(count > 30_000_000, "{count}");
    let edges = [0.0, -0.0, f32::from_bits(1), f32::MIN_POSITIVE, f32::MAX, f32::INFINITY];
    for x in edges {
        assert_eq!(math::sqrt(x).to_bits(), x.sqrt().to_bits(), "{x:e}");
    }
    assert!(math::sqrt(f32::NEG_INFINITY).is_nan() && math::sqrt(-1e-45).is_nan());
}

#[test]
fn the_cube_root_is_within_2_3e_7_for_every_f32() {
    let mut check = check("cube root of every f32");
    let (mut count, mut bits) = (0, 1u32);
    // The root of every other number is one of these three binades' with another exponent, or is subnormal.
    while bits < 0x7f80_0000 {
        let x = f32::from_bits(bits);
        let dense = (1.0..8.0).contains(&x) || std::env::var_os("NANOSPECTRA_EXHAUSTIVE").is_some();
        let root = math::cbrt(x);
        check.value(&format!("{x:e}"), root.into(), f64::from(x).cbrt());
        assert_eq!(math::cbrt(-x), -root, "odd at {x:e}");
        count += 1;
        bits += if dense { 11 } else { 1009 };
    }
    check.tight(count);
    for x in [0.0, -0.0, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(math::cbrt(x).to_bits(), x.to_bits());
    }
    assert!(math::cbrt(f32::NAN).is_nan());
    for k in 1u8..=100 {
        let k = f32::from(k);
        assert!((math::cbrt(k * k * k) / k - 1.0).abs() < 2.4e-7, "the cube of {k}");
    }
}
