//! What holds for every colour, on colours that nobody chose.
#![cfg(feature = "libm")]

use nanospectra::color::{Rgb, Srgb};
use nanospectra::light::D65;
use nanospectra::observer::CIE_1931;
use nanospectra::upsample::{Basis, Sigmoid, Smits, Status, Viewing};
use nanospectra::{Bins, Curve, Fine, Interpolation, Nodes, Outside, Power, Reflectance};
use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence;

const LIGHT: Fine<Power> = D65.interpolate(Interpolation::Linear, Outside::Zero);
type Grid = Nodes<400, 700>;
static VIEWING: Viewing<31, Grid> = Viewing::new(&CIE_1931.under(&LIGHT).fold(Curve::Step));
static SIGMOID: Sigmoid<31, Grid> = Sigmoid::new(&VIEWING);

/// The whole range, the faces, near black, near white, near grey.
fn component() -> impl Strategy<Value = f32> {
    prop_oneof![
        4 => 0.0f32..=1.0,
        1 => Just(0.0f32),
        1 => Just(1.0f32),
        1 => (-30.0f32..0.0).prop_map(f32::exp2),
        1 => (-24.0f32..0.0).prop_map(|e| 1.0 - e.exp2()),
        1 => (-1e-6f32..1e-6).prop_map(|d| 0.5 + d),
    ]
}

fn color() -> impl Strategy<Value = [f32; 3]> {
    let near_gray = (0.0f32..=1.0, -1e-6f32..1e-6, -1e-6f32..1e-6)
        .prop_map(|(gray, d, e)| [gray, (gray + d).clamp(0.0, 1.0), (gray + e).clamp(0.0, 1.0)]);
    prop_oneof![5 => [component(), component(), component()], 1 => near_gray]
}

fn any_number() -> impl Strategy<Value = f32> {
    prop_oneof![
        3 => component(),
        2 => -3.0f32..5.0,
        1 => Just(f32::NAN),
        1 => Just(f32::INFINITY),
        1 => Just(f32::NEG_INFINITY),
        1 => any::<f32>(),
    ]
}

fn solve([r, g, b]: [f32; 3]) -> Reflectance<31, Grid> {
    let solved = SIGMOID.reflectance(Rgb::new(r, g, b));
    assert_eq!(solved.status, Status::Exact, "{r} {g} {b}");
    solved.spectrum.on_grid()
}

fn largest_difference(a: &Reflectance<31, Grid>, b: &Reflectance<31, Grid>) -> f32 {
    a.values().iter().zip(b.values()).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 2000,
        failure_persistence: Some(Box::new(FileFailurePersistence::Direct("tests/upsample.regressions"))),
        ..ProptestConfig::default()
    })]

    #[test]
    fn every_color_of_the_cube_has_a_possible_reflectance_that_gives_it_back(rgb in color()) {
        let spectrum = solve(rgb);
        prop_assert!(spectrum.values().iter().all(|s| (0.0..=1.0).contains(s)), "{:?}", spectrum);
        let [r, g, b] = rgb;
        let off = VIEWING.delta_e(Rgb::new(r, g, b), &spectrum);
        prop_assert!(off <= 2e-3, "{} for {:?}", off, rgb);
    }

    #[test]
    fn a_dark_spectrum_is_no_brighter_than_twice_its_largest_component(rgb in color()) {
        let largest = rgb.into_iter().fold(0.0, f32::max);
        let smallest = rgb.into_iter().fold(1.0, f32::min);
        for share in solve(rgb).values() {
            prop_assert!(*share <= (2.0 * largest).min(1.0) && 1.0 - share <= (2.0 * (1.0 - smallest)).min(1.0));
        }
    }

    #[test]
    fn exposure_scales_dark_spectra(rgb in color(), stops in 1..40i32) {
        let dark = rgb.map(|c| 0.25 * c);
        let bright = solve(dark);
        let darker = solve(dark.map(|c| c * 0.5f32.powi(stops)));
        // Subnormal components lose bits, and so may their spectra.
        prop_assume!(dark.iter().all(|c| *c == 0.0 || *c > 1e-20));
        prop_assert_eq!(darker, bright * 0.5f32.powi(stops));
    }

    #[test]
    fn a_darker_exposure_is_darker_at_every_wavelength(rgb in color(), part in 0.05f32..0.95) {
        let dark = rgb.map(|c| 0.49 * c);
        let (bright, less) = (solve(dark), solve(dark.map(|c| part * c)));
        for (bright, less) in bright.values().iter().zip(less.values()) {
            prop_assert!(less <= bright, "{} {}", less, bright);
        }
    }

    #[test]
    fn there_is_no_seam_where_the_scale_and_the_complement_begin(rgb in color()) {
        let [r, g, b] = rgb;
        let largest = r.max(g).max(b).max(1e-3);
        let seam = [r, g, b].map(|c| 0.5 * (c / largest));
        let below = solve(seam.map(|c| c * (1.0 - 1e-6)));
        let above = solve(seam.map(|c| (c * (1.0 + 1e-6)).min(1.0)));
        prop_assert!(largest_difference(&below, &above) < 1e-3, "{:?}", seam);
        let high = seam.map(|c| 1.0 - c);
        let below = solve(high.map(|c| c * (1.0 - 1e-6)));
        let above = solve(high.map(|c| (c * (1.0 + 1e-6)).min(1.0)));
        prop_assert!(largest_difference(&below, &above) < 1e-3, "{:?}", high);
    }

    #[test]
    fn nothing_that_is_asked_panics_or_leaves_the_range(r in any_number(), g in any_number(), b in any_number()) {
        let rgb = Rgb::<Srgb>::new(r, g, b);
        let finite = r.is_finite() && g.is_finite() && b.is_finite();
        let solved = SIGMOID.reflectance(rgb);
        let spectrum = solved.spectrum.on_grid::<31, Grid>();
        prop_assert_eq!(solved.status == Status::NotFinite, !finite);
        for share in spectrum.values() {
            prop_assert!(if finite { (0.0..=1.0).contains(share) } else { share.is_nan() }, "{:?} {:?}", rgb, solved);
        }
        if solved.status == Status::Exact {
            prop_assert!(VIEWING.delta_e(rgb, &spectrum) <= 2e-3);
        }
        let eight = SIGMOID.reflectance_8(&[rgb; 8]);
        for one in eight {
            // NaN is not equal to itself.
            prop_assert_eq!(one.spectrum.to_texel().map(f32::to_bits), solved.spectrum.to_texel().map(f32::to_bits));
        }
        let less = SIGMOID.desaturated(rgb).spectrum.on_grid::<31, Grid>();
        prop_assert!(!finite || less.values().iter().all(|s| (0.0..=1.0).contains(s)));
        let shares = SIGMOID.unbounded(rgb).spectrum.on_grid::<31, Grid>();
        prop_assert!(!finite || shares.values().iter().all(|s| *s >= 0.0));
        let mixed = Smits::<31, Grid>::new().reflectance(rgb);
        let is_nan = r.is_nan() || g.is_nan() || b.is_nan();
        prop_assert!(!is_nan || mixed.values().iter().all(|s| s.is_nan()));
    }

    #[test]
    fn the_basis_is_linear_and_possible(one in color(), other in color(), part in 0.0f32..=1.0) {
        let viewing: Viewing<60, Bins<400, 700>> = Viewing::new(&CIE_1931.under(&LIGHT).fold(Curve::Step));
        let basis = Basis::new(&viewing);
        let of = |[r, g, b]: [f32; 3]| basis.reflectance(Rgb::new(r, g, b));
        let mixed = of([0, 1, 2].map(|c| part * one[c] + (1.0 - part) * other[c]));
        let sum = of(one) * part + of(other) * (1.0 - part);
        for (mixed, sum) in mixed.values().iter().zip(sum.values()) {
            prop_assert!((mixed - sum).abs() < 1e-6 && (-1e-7..=1.0000001).contains(mixed));
        }
    }
}
