//! Every operator in every form, against plain arithmetic on the numbers.

use nanospectra::color::{Rgb, Srgb, Xyz};
use nanospectra::geometry::Integrand;
use nanospectra::math::{Fast, Math};
use nanospectra::radiometry::{Carried, Irradiance, Luminous, PerSr, Radiance, Radiant};
use nanospectra::{Factor, Light, Power, Reflectance, RefractiveIndex, Spectrum};
use proptest::prelude::*;

type Seven<Q> = Spectrum<Q, 7>;

/// By value and by reference.
macro_rules! same {
    ($a:expr, $op:tt, $b:expr, $expected:expr) => {{
        let (a, b, expected) = ($a, $b, $expected);
        prop_assert_eq!(a $op b, expected);
        prop_assert_eq!(a $op &b, expected);
        prop_assert_eq!(&a $op b, expected);
        prop_assert_eq!(&a $op &b, expected);
    }};
    ($a:expr, $op:tt, $assign:tt, $b:expr, $expected:expr) => {{
        let (a, b, expected) = ($a, $b, $expected);
        same!(a, $op, b, expected);
        let (mut by_value, mut by_reference) = (a, a);
        by_value $assign b;
        by_reference $assign &b;
        prop_assert_eq!([by_value, by_reference], [expected; 2]);
    }};
}

/// What `linear_operators` promises, by the numbers: `$make` makes a value of an array.
macro_rules! linear {
    ($make:expr, $a:expr, $b:expr, $k:expr) => {{
        let (make, k) = ($make, $k);
        let with = |f: fn(f32, f32) -> f32| make(core::array::from_fn(|i| f($a[i], $b[i])));
        let each = |f: &dyn Fn(f32) -> f32| make($a.map(f));
        let (a, b) = (make($a), make($b));
        same!(a, +, +=, b, with(|a, b| a + b));
        same!(a, -, -=, b, with(|a, b| a - b));
        same!(a, *, *=, k, each(&|a| a * k));
        same!(a, /, /=, k, each(&|a| a / k));
        same!(k, *, a, each(&|a| a * k));
        prop_assert_eq!([-a, -&a], [each(&|a| -a); 2]);
        let three = with(|a, b| 0.0 + a + b + a);
        let mut sums = [a; 2];
        sums[0] = [a, b, a].into_iter().sum();
        sums[1] = [a, b, a].iter().sum();
        prop_assert_eq!(sums, [three; 2]);
    }};
}

fn numbers<const N: usize>() -> impl Strategy<Value = [f32; N]> {
    prop::array::uniform(
        prop_oneof![8 => -1e3f32..1e3, 1 => Just(0.0), 1 => Just(-0.0), 1 => -1e-30f32..1e30],
    )
}

proptest! {
    #[test]
    fn they_are_those_of_the_numbers(a in numbers::<7>(), b in numbers::<7>(), k in 1e-3f32..1e3) {
        linear!(Seven::<Power>::from_bins, a, b, k);
        linear!(Seven::<Factor>::from_bins, a, b, k);
        linear!(|v| Irradiance::new(Light::<7>::from_bins(v)), a, b, k);
    }

    #[test]
    fn colors_and_quantities_have_them_too(a in numbers::<3>(), b in numbers::<3>(), k in 1e-3f32..1e3) {
        linear!(|[x, y, z]: [f32; 3]| Xyz::new(x, y, z), a, b, k);
        linear!(|[r, g, b]: [f32; 3]| Rgb::<Srgb>::new(r, g, b), a, b, k);
        linear!(|[v, ..]: [f32; 3]| Radiant(v), a, b, k);
        linear!(|[v, ..]: [f32; 3]| Irradiance::new(Luminous(v)), a, b, k);
    }

    #[test]
    fn quantities_multiply_and_divide_where_that_means_something(a in numbers::<7>(), b in numbers::<7>()) {
        let (light, other) = (Seven::<Power>::from_bins(a), Seven::<Power>::from_bins(b));
        let (factor, share) = (Seven::<Factor>::from_bins(b), Seven::<Factor>::from_bins(a));
        let product: [f32; 7] = core::array::from_fn(|k| a[k] * b[k]);
        let ratio: [f32; 7] = core::array::from_fn(|k| a[k] / b[k]);
        let (a, b) = (light, factor);
        same!(a, *, *=, b, Seven::from_bins(product));
        same!(b, *, a, Seven::<Power>::from_bins(product));
        same!(share, *, *=, b, Seven::from_bins(product));
        if !ratio.iter().any(|ratio| ratio.is_nan()) {
            same!(a, /, /=, b, Seven::from_bins(ratio));
            same!(share, /, /=, b, Seven::from_bins(ratio));
            same!(a, /, other, Seven::<Factor>::from_bins(ratio));
        }
        let arriving = Irradiance::new(light);
        same!(arriving, *, *=, b, Irradiance::new(light * b));
        same!(b, *, arriving, Irradiance::new(light * b));
        same!(arriving, *, PerSr(b), Radiance::new(light * b));
        same!(PerSr(b), *, arriving, Radiance::new(light * b));
        same!(Irradiance::new(Radiant(3.0)), *, PerSr(0.5), Radiance::new(Radiant(1.5)));
    }

    #[test]
    fn functions_are_those_of_each_bin(a in numbers::<7>(), b in numbers::<7>(), t in 0.0f32..1.0) {
        let (one, two) = (Seven::<Factor>::from_bins(a), Seven::<Factor>::from_bins(b));
        prop_assert_eq!(one.clamp(-1.0, 2.0), Seven::from_bins(a.map(|a| a.clamp(-1.0, 2.0))));
        prop_assert_eq!(one.max(&two), Seven::from_bins(core::array::from_fn(|k| a[k].max(b[k]))));
        prop_assert_eq!(one.min(&two), Seven::from_bins(core::array::from_fn(|k| a[k].min(b[k]))));
        prop_assert_eq!([one.lerp(&two, 0.0), one.lerp(&two, 1.0)], [one, two]);
        for (k, between) in one.lerp(&two, t).values().iter().enumerate() {
            prop_assert_eq!(one[k], a[k]);
            let [from, to, t] = [a[k], b[k], t].map(f64::from);
            let off = f64::from(*between) - ((1.0 - t) * from + t * to);
            prop_assert!(off.abs() <= 2e-7 * (from.abs() + to.abs()), "{off}");
        }
        let sizes = Seven::<Factor>::from_bins(a.map(f32::abs));
        prop_assert_eq!(sizes.sqrt(), Seven::from_bins(a.map(|a| a.abs().sqrt())));
        prop_assert_eq!((-sizes).exp_with::<Fast>(), Seven::from_bins(a.map(|a| Fast::exp(-a.abs()))));
        prop_assert_eq!(one.is_black(), a.iter().all(|a| *a == 0.0));
        let mut written = one;
        written[3] = 7.0;
        prop_assert_eq!(written.values()[3], 7.0);
        prop_assert_eq!(one.map(|a| a + 1.0), Seven::from_bins(a.map(|a| a + 1.0)));
    }
}

#[test]
fn nan_stays_in_its_bin() {
    let (numbers, broken) = (Light::<3>::flat(1.0), Light::from_bins([0.5, f32::NAN, 2.0]));
    for light in [
        broken.max(&numbers),
        numbers.max(&broken),
        broken.min(&numbers),
        numbers.min(&broken),
        broken.clamp(0.0, 1.0),
        broken.lerp(&numbers, 1.0),
        numbers.lerp(&broken, 0.0),
    ] {
        assert_eq!(light.values().map(f32::is_nan), [false, true, false], "{light:?}");
    }
    assert!(!broken.is_black());
}

#[test]
fn nothing_is_the_default() {
    assert_eq!(Seven::<RefractiveIndex>::default(), Seven::flat(0.0));
    assert_eq!(Irradiance::<Light<7>>::default(), Irradiance::NONE);
    assert_eq!([].iter().sum::<Reflectance<7>>(), Reflectance::flat(0.0));
    assert_eq!([].iter().sum::<Xyz>(), Xyz::new(0.0, 0.0, 0.0));
}

#[test]
#[should_panic(expected = "the len is 7 but the index is 7")]
fn an_index_beyond_the_last_bin_panics() {
    let beyond = std::hint::black_box(7);
    let _ = Light::<7>::flat(1.0)[beyond];
}

/// One rule for what is divided by zero, by a relation and by the operator.
#[test]
fn a_quotient_by_zero_is_the_largest_number_and_nothing_over_nothing_is_nothing() {
    fn holds<V: Carried + PartialEq + core::fmt::Debug>(some: V, none: V) {
        let largest = some.map(|value| f32::MAX.copysign(value));
        assert_eq!(Irradiance::new(some).radiance(0.0, 1.0).value(), largest);
        assert_eq!((Irradiance::new(some) / 0.0).value(), largest);
        assert_eq!(Irradiance::new(none).radiance(0.0, 1.0).value(), none);
        assert_eq!((Irradiance::new(none) / 0.0).value(), none);
    }
    holds(Radiant(2.0), Radiant(0.0));
    holds(Luminous(-2.0), Luminous(0.0));
    holds(Light::<7>::flat(2.0), Light::flat(0.0));
    assert!((Irradiance::new(Radiant(f32::NAN)) / 0.0).value().0.is_nan());
}
