//! Every f32 of the domain of every own function, against f64 or the hardware.
//!
//! `cargo test` tries every 251st, `cargo xtask full` every fifth. All of them, 200 s of one core (100 s on
//! two):
//!
//!     NANOSPECTRA_STRIDE=1 cargo test --release -p nanospectra --test spectrum every_f32

use model::allowed::check;
use nanospectra::math::{self, Fast, Math};
use std::f64::consts::TAU;
use std::ops::RangeInclusive;

/// Every f32 from `first` to `last` (of one sign, by growing size) on all cores: none may be off by more than
/// the entry allows. `error` is what is measured.
fn sweep(what: &'static str, first: f32, last: f32, error: impl Fn(f32) -> f64 + Sync) {
    let mut check = check(what);
    let (count, worst, at) = worst(first.to_bits()..=last.to_bits(), &error);
    println!("{what}: {count} numbers");
    check.value(&format!("{at:e}"), worst, 0.0);
    check.tight(1);
}

/// How many were tried, the largest error, and where it is.
fn worst(bits: RangeInclusive<u32>, error: &(impl Fn(f32) -> f64 + Sync)) -> (u64, f64, f32) {
    let stride =
        std::env::var("NANOSPECTRA_STRIDE").map_or(251, |n| n.parse().expect("NANOSPECTRA_STRIDE: a number"));
    let (first, last) = (u64::from(*bits.start()), u64::from(*bits.end()));
    let cores = std::thread::available_parallelism().map_or(2, |cores| cores.get() as u64);
    let share = |core: u64| {
        let (mut count, mut worst, mut at) = (0, 0.0, f32::NAN);
        let mut bits = first + core * stride;
        while bits <= last {
            let x = f32::from_bits(bits as u32);
            let off = error(x);
            assert!(!off.is_nan(), "no number for {x:e}");
            if off > worst {
                (worst, at) = (off, x);
            }
            count += 1;
            bits += stride * cores;
        }
        (count, worst, at)
    };
    let shares: Vec<_> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..cores).map(|core| scope.spawn(move || share(core))).collect();
        threads.into_iter().map(|thread| thread.join().expect("a share of the numbers")).collect()
    });
    let count = shares.iter().map(|share| share.0).sum();
    assert_eq!(count, (last - first) / stride + 1);
    let (_, worst, at) = shares.into_iter().max_by(|a, b| a.1.total_cmp(&b.1)).expect("a core");
    (count, worst, at)
}

/// The relative error, below the normal numbers that of the smallest of them.
fn relative(got: f32, exact: f64) -> f64 {
    if f64::from(got) == exact {
        return 0.0;
    }
    (f64::from(got) - exact).abs() / exact.abs().max(f32::MIN_POSITIVE.into())
}

/// The relative error of a cube root by its cube (to 1e-13); infinite where the root is not odd.
fn error_of_cube_root(cbrt: impl Fn(f32) -> f32, x: f32) -> f64 {
    let root = cbrt(x);
    if cbrt(-x) != -root {
        return f64::INFINITY;
    }
    let (root, x) = (f64::from(root), f64::from(x));
    (root * root * root - x).abs() / (3.0 * x)
}

#[test]
fn the_square_root_is_the_hardwares() {
    let off = |x: f32| {
        let (own, hardware) = (math::sqrt(x), x.sqrt());
        let same = own.to_bits() == hardware.to_bits() && Fast::sqrt(x).to_bits() == own.to_bits();
        if same { 0.0 } else { f64::INFINITY }
    };
    let (count, error, at) = worst(0..=f32::INFINITY.to_bits(), &off);
    assert!(
        error == 0.0 && count > 8_000_000,
        "{at:e}: {:e}, the hardware says {:e}",
        math::sqrt(at),
        at.sqrt()
    );
    // The root of any other number is one of theirs with another exponent.
    for bits in 1.0f32.to_bits()..=4.0f32.to_bits() {
        let x = f32::from_bits(bits);
        assert!(off(x) == 0.0, "{x:e}: {:e}, the hardware says {:e}", math::sqrt(x), x.sqrt());
    }
    for bits in (1.0f32.to_bits()..=f32::INFINITY.to_bits()).step_by(100_003).chain([1]) {
        assert!(math::sqrt(-f32::from_bits(bits)).is_nan());
    }
    assert_eq!(math::sqrt(-0.0).to_bits(), (-0.0f32).to_bits());
}

#[test]
fn the_cube_roots_are_near_f64() {
    let (first, last) = (f32::MIN_POSITIVE, f32::MAX);
    sweep("Fast cbrt of every f32", first, last, |x| error_of_cube_root(Fast::cbrt, x));
    sweep("cube root of every f32", f32::from_bits(1), last, |x| error_of_cube_root(math::cbrt, x));
    // Subnormals go to zero more slowly than their roots, but neither can be far from it.
    let subnormals = 0.0f32.to_bits()..=first.to_bits();
    let off = |x: f32| (f64::from(Fast::cbrt(x)) - f64::from(x).cbrt()).abs();
    let (_, error, at) = worst(subnormals, &off);
    assert!(error <= 2.3e-13, "{at:e} is off by {error:e}");
    for x in [0.0, -0.0, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(math::cbrt(x).to_bits(), x.to_bits());
    }
    for k in 1u8..=100 {
        let k = f32::from(k);
        assert!((math::cbrt(k * k * k) / k - 1.0).abs() < 2.4e-7, "the cube of {k}");
    }
}

/// The function in f64, and near zero, where three in four of all f32 are, by two terms: as exact, and
/// quicker.
fn quickly(x: f32, f: impl Fn(f64) -> f64, two_terms: impl Fn(f64) -> f64) -> f64 {
    let size = x.abs();
    let x = f64::from(x);
    if size < 1e-6 { two_terms(x) } else { f(x) }
}

#[test]
fn the_exponential_function_is_near_f64() {
    // Up to the last that does not overflow, down to where nothing is left.
    let of = |x: f32| relative(Fast::exp(x), quickly(x, f64::exp, |x| 1.0 + x + 0.5 * x * x));
    sweep("Fast exp of every f32 above 0", 0.0, 88.722_83, of);
    sweep("Fast exp of every f32 below 0", -0.0, -104.0, of);
}

#[test]
fn exp_less_1_is_near_f64() {
    let of = |x: f32| relative(Fast::expm1(x), quickly(x, f64::exp_m1, |x| x + 0.5 * x * x));
    sweep("Fast expm1 of every f32 above 0", 0.0, 88.722_83, of);
    sweep("Fast expm1 of every f32 below 0", -0.0, -104.0, of);
}

#[test]
fn the_logarithm_is_near_f64() {
    let of = |x: f32| relative(Fast::ln(x), f64::from(x).ln());
    sweep("Fast ln of every f32", f32::from_bits(1), f32::MAX, of);
}

#[test]
fn the_powers_of_signals_are_near_f64() {
    let of = |x: f32, y: f32| relative(Fast::powf(x, y), f64::from(x).powf(y.into()));
    sweep("Fast x^2.4 of every signal", 1e-6, 1e4, |x| of(x, 2.4));
    sweep("Fast x^(1/2.4) of every signal", 1e-6, 1e4, |x| of(x, 1.0 / 2.4));
}

#[test]
fn the_arc_tangent_is_near_f64() {
    let of = |x: f32| relative(Fast::atan2(x, 1.0), quickly(x, f64::atan, |x| x - x * x * x / 3.0));
    sweep("Fast atan of every f32 up to 1", 0.0, 1.0, of);
}

#[test]
fn sine_and_cosine_are_near_f64() {
    let of = |x: f32| {
        let (cos, sin) = (Fast::cos_turns(x), Fast::sin_turns(x));
        if Fast::cos_turns(-x) != cos || Fast::sin_turns(-x) != -sin {
            return f64::INFINITY;
        }
        let angle = |turns: f64| TAU * (turns - turns.round());
        let exact_cos = quickly(x, |x| angle(x).cos(), |x| 1.0 - 0.5 * (TAU * x).powi(2));
        let exact_sin = quickly(x, |x| angle(x).sin(), |x| TAU * x);
        (f64::from(cos) - exact_cos).abs().max((f64::from(sin) - exact_sin).abs())
    };
    sweep("sine and cosine of every f32", 0.0, 8_388_608.0, of);
}
