//! Every math backend against f64, over the whole domain of every function. (`every_f32` has the own
//! functions at every number.)

use model::allowed::check;
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

/// Bases and exponents that color needs: signals 1e-6..=1e4, exponents of transfer functions and of five.
fn powers() -> Vec<(f32, f32)> {
    let exponents = [1.0 / 2.4, 2.4, 0.45, 1.0 / 0.45, 0.159_301_76, 78.843_75 / 8.0, 1.0 / 3.0, 5.0, -2.0];
    let bases = spread(1e-3, 1e3).step_by(11);
    bases.flat_map(|x| exponents.map(|y| (x, y))).collect()
}

/// Points all around the origin, near and far.
fn points() -> Vec<(f32, f32)> {
    let sizes = spread(1e-3, 1e3).step_by(300);
    let angles: Vec<f32> = (0..720).map(|k| (k as f32 * 0.5 + 0.123).to_radians()).collect();
    sizes.flat_map(|r| angles.iter().map(move |a| (r * a.sin(), r * a.cos())).collect::<Vec<_>>()).collect()
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

backend!(the_fast_backend_is_near_f64 "Fast" math::Fast, turns to 1e6);
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

/// Where a search over millions of pairs found the largest errors of `Fast`.
#[test]
fn the_worst_pairs_for_fast_are_within_what_it_says() {
    let mut power = check("Fast powf at its worst");
    for (x, y) in [(0.087_542_63_f32, 9.868_293_f32), (11.281_575, 9.619_881)] {
        power.value(&format!("{x}, {y}"), math::Fast::powf(x, y).into(), f64::from(x).powf(y.into()));
    }
    power.tight(2);
    let mut angle = check("Fast atan2 at its worst");
    for (y, x) in
        [(1.351_303_5_f32, 0.864_288_6_f32), (0.708_332_36, 0.450_712_68), (0.858_257_3, 0.543_158_9)]
    {
        angle.value(&format!("{y}, {x}"), math::Fast::atan2(y, x).into(), f64::from(y).atan2(x.into()));
    }
    angle.tight(3);
}

#[cfg(feature = "micromath")]
#[test]
fn micromath_is_not_for_color() {
    use math::Micromath;
    use model::allowed::Singles;
    use nanospectra::color::transfer::{self, Transfer};
    use nanospectra::color::{Rgb, RgbSpace, Srgb};
    let (mut lab, mut encoded) = (check("Lab by Micromath"), check("sRGB by Micromath"));
    let levels = || (0..=20u16).map(|level| f32::from(level) / 20.0);
    for (r, g, b) in levels().flat_map(|r| levels().flat_map(move |g| levels().map(move |b| (r, g, b)))) {
        let (color, white) = (Rgb::<Srgb>::new(r, g, b).xyz(), Srgb::WHITE_XYZ);
        let exact = model::lab::lab(color.to_array().map(f64::from), white.to_array().map(f64::from));
        let got = color.lab_with::<Micromath>(white).expect("a white");
        lab.add_all(&format!("{r} {g} {b}"), [got.l, got.a, got.b], exact);
    }
    let mut codes = 0;
    for k in 1..=10_000u16 {
        let y = f32::from(k) / 1e4;
        let (got, exact) =
            (transfer::SrgbTransfer::encode_with::<Micromath>(y), model::transfer::srgb_encode(y.into()));
        encoded.add(&format!("{y}"), got, exact);
        let code = |v: f64| (255.0 * v).round() as i32;
        codes = codes.max((code(got.into()) - code(exact)).abs());
    }
    assert_eq!(codes, 12);
    lab.tight(3 * 21 * 21 * 21);
    encoded.tight(10_000);
}

/// What Portable and Fast have in common at the edges of their domains.
fn edges<M: Math>() {
    assert_eq!((M::exp(0.0), M::expm1(0.0), M::ln(1.0)), (1.0, 0.0, 0.0));
    assert_eq!((M::exp(-200.0), M::exp(200.0)), (0.0, f32::INFINITY));
    assert_eq!((M::exp(f32::NEG_INFINITY), M::exp(f32::INFINITY)), (0.0, f32::INFINITY));
    assert_eq!((M::expm1(-200.0), M::expm1(200.0)), (-1.0, f32::INFINITY));
    assert_eq!(
        (M::ln(0.0), M::ln(-0.0), M::ln(f32::INFINITY)),
        (-f32::INFINITY, -f32::INFINITY, f32::INFINITY)
    );
    assert_eq!((M::powf(0.0, 2.4), M::powf(7.0, 0.0), M::powf(1.0, 9.0)), (0.0, 1.0, 1.0));
    assert_eq!((M::powf(0.0, -2.4), M::powf(0.0, 0.0), M::powf(f32::NAN, 0.0)), (f32::INFINITY, 1.0, 1.0));
    assert_eq!((M::powf(1e20, 2.4), M::powf(1e20, -2.4)), (f32::INFINITY, 0.0));
    assert_eq!((M::powf(f32::INFINITY, 0.5), M::powf(f32::INFINITY, -0.5)), (f32::INFINITY, 0.0));
    assert_eq!((M::powf(0.9, 1e30), M::powf(1.1, 1e30)), (0.0, f32::INFINITY));
    assert_eq!((M::cbrt(0.0).to_bits(), M::cbrt(-0.0).to_bits()), (0, 0x8000_0000));
    assert_eq!((M::sqrt(0.0).to_bits(), M::sqrt(-0.0).to_bits()), (0, 0x8000_0000));
    assert!(M::ln(-1.0).is_nan() && M::ln(-1e-40).is_nan() && M::ln(-f32::INFINITY).is_nan());
    assert!(M::sqrt(-1.0).is_nan() && M::powf(-1.0, 0.5).is_nan());
    for f in [M::sqrt, M::cbrt, M::exp, M::expm1, M::ln, M::cos_turns, M::sin_turns] {
        assert!(f(f32::NAN).is_nan());
    }
    for f in [M::powf, M::atan2] {
        assert!(f(f32::NAN, 2.0).is_nan() && f(2.0, f32::NAN).is_nan());
    }
    // The results that only subnormals can be.
    let least = f32::from_bits(1);
    for (got, exact) in [
        (M::exp(-100.0), (-100f64).exp()),
        (M::powf(1e-20, 2.1), f64::from(1e-20f32).powf(2.1f32.into())),
        (M::powf(1e-40, 1.0), f64::from(1e-40f32)),
    ] {
        assert!((f64::from(got) - exact).abs() < 2.0 * f64::from(least), "{got:e}, not {exact:e}");
    }
    assert!((M::ln(least) / -103.278_93 - 1.0).abs() < 2e-7);
    assert!((f64::from(M::powf(least, -0.5)) / 2f64.powf(74.5) - 1.0).abs() < 2e-7);
    // Signed zeros and infinities, as IEEE 754 has them.
    for x in [0.0, -0.0, 1.0, -1.0, f32::INFINITY, f32::NEG_INFINITY] {
        for y in [0.0, -0.0, 1.0, -1.0, f32::INFINITY, f32::NEG_INFINITY] {
            let (got, exact) = (M::atan2(y, x), y.atan2(x));
            assert!(
                (got - exact).abs() < 5e-7 && got.is_sign_negative() == exact.is_sign_negative(),
                "{y}, {x}"
            );
        }
    }
}

#[cfg(feature = "libm")]
#[test]
fn portable_functions_at_the_edges_of_their_domains() {
    edges::<math::Portable>();
}

#[test]
fn fast_functions_at_the_edges_of_their_domains() {
    use math::Fast;
    edges::<Fast>();
    // What it says of itself: no number for an infinity, the gray of a white exactly 1.
    assert!(Fast::cbrt(f32::INFINITY).is_nan() && Fast::cbrt(f32::NEG_INFINITY).is_nan());
    for k in -40..=40 {
        assert_eq!(Fast::cbrt(8f32.powi(k)), 2f32.powi(k), "the cube root of 8^{k}");
    }
}

#[test]
fn whole_half_and_quarter_turns_are_exact_however_many() {
    for k in [0.0, 1.0, -3.0, 1000.0, 4_194_303.0, 4_194_304.0, 8_388_607.0, 1e30] {
        assert_eq!((math::cos_turns(k), math::sin_turns(k)), (1.0, 0.0), "{k} turns");
    }
    for (turns, cos, sin) in
        [(0.25, 0.0, 1.0), (0.5, -1.0, 0.0), (0.75, 0.0, -1.0), (-0.25, 0.0, -1.0), (4_194_304.5, -1.0, 0.0)]
    {
        let (c, s) = (math::cos_turns(turns), math::sin_turns(turns));
        assert!((c - cos).abs() < 1e-7 && (s - sin).abs() < 1e-7, "{turns} turns: {c}, {s}");
    }
    for x in [f32::INFINITY, f32::NEG_INFINITY, f32::NAN] {
        assert!(math::cos_turns(x).is_nan() && math::sin_turns(x).is_nan(), "{x} turns");
    }
}
