//! Every public function of `spectrum`, on numbers of any bits: none panics, and finite numbers give what is
//! documented.

use nanospectra::math::Fast;
use nanospectra::{Bins, Factor, Fine, Interpolation, Light, Nodes, Outside, Power, Reflectance, Spectrum};
use proptest::prelude::*;

/// Numbers of any bits, and often of a size that is in use, or an edge.
fn bits() -> impl Strategy<Value = f32> {
    let edges =
        vec![0.0, -0.0, 1.0, -1.0, f32::MAX, f32::MIN, f32::MIN_POSITIVE, 1e-45, f32::INFINITY, f32::NAN];
    prop_oneof![4 => any::<u32>().prop_map(f32::from_bits), 4 => -2.0f32..2.0, 1 => prop::sample::select(edges)]
}

/// Wavelengths of any bits, and mostly those of light.
fn nm() -> impl Strategy<Value = f32> {
    prop_oneof![1 => bits(), 3 => 300.0f32..900.0]
}

/// How often each test draws: 2,000 times, or as NANOSPECTRA_RUNS says.
fn runs() -> ProptestConfig {
    let runs = std::env::var("NANOSPECTRA_RUNS").ok().and_then(|runs| runs.parse().ok());
    ProptestConfig { cases: runs.unwrap_or(2_000), ..ProptestConfig::default() }
}

fn same(a: f32, b: f32) -> bool {
    a.is_nan() && b.is_nan() || a == b
}

proptest! {
    #![proptest_config(runs())]

    #[test]
    fn functions_of_bins_of_any_bits(
        a in prop::array::uniform8(bits()), b in prop::array::uniform8(bits()), low in bits(), high in bits(), t in bits(),
    ) {
        let (x, y) = (Light::<8>::from_bins(a), Light::<8>::from_bins(b));
        let (share, other) = (Reflectance::<8>::from_bins(b), Reflectance::<8>::from_bins(a));
        let (larger, smaller, roots) = (x.max(&y), x.min(&y), other.sqrt());
        for k in 0..8 {
            let (a, b) = (a[k], b[k]);
            let [most, least] = if a.is_nan() || b.is_nan() { [f32::NAN; 2] } else { [a.max(b), a.min(b)] };
            let so = [larger.values()[k], smaller.values()[k], roots.values()[k]];
            prop_assert!(same(so[0], most) && same(so[1], least) && same(so[2], a.sqrt()), "{a} {b} {so:?}");
        }
        // The limits of a clamp may be of any order and NaN.
        let clamped = x.clamp(low, high);
        if low <= high {
            for (before, after) in a.iter().zip(clamped.values()) {
                prop_assert!(same(*after, before.clamp(low, high)), "{before} {low} {high} {after}");
            }
        }
        prop_assert_eq!(x.is_black(), a.iter().all(|value| *value == 0.0));
        prop_assert_eq!(x.peak().is_nan(), a.iter().any(|value| value.is_nan()));
        let _ = (x.lerp(&y, t), other.exp_with::<Fast>(), x * share + y - x * t, x / y, -x, x.onto(&share));
        let _ = (x.power(), x.within(low, high), x.iter().len());
        for (value, power) in a.iter().zip(other.exp_with::<Fast>().values()) {
            prop_assert!(value.is_nan() == power.is_nan() && (power.is_nan() || *power >= 0.0), "{value} {power}");
        }
    }

    #[test]
    fn other_grids_and_lines_of_any_bits(a in prop::array::uniform16(bits()), nm in nm(), power in bits()) {
        let mut light = Light::<16>::from_bins(a);
        let far: Spectrum<Power, 7, Nodes<700, 900>> = light.resample_outside(Outside::Hold);
        let near: Spectrum<Power, 16, Bins<380, 730>> = light.resample();
        let fine: Fine<Power> = light.interpolate(Interpolation::Sprague);
        let other: Fine<Power> = light.interpolate_outside(Interpolation::Linear, Outside::Zero);
        let surface: Fine<Factor> = Reflectance::<16>::from_bins(a).fine();
        let _ = (far.peak(), near.peak(), fine.peak(), other.peak(), surface.peak());
        // The same grid is the same light.
        prop_assert!(near.values().iter().zip(a).all(|(after, before)| same(*after, before)));
        let lost = light.add_line(nm, power);
        prop_assert!(same(lost, power) || lost == 0.0 || lost == power * 0.5, "{} of {}", lost, power);
    }

    #[test]
    fn samples_of_any_bits(
        mut samples in prop::collection::vec((nm(), bits()), 0..24), sorted in any::<bool>(), tame in any::<bool>(),
    ) {
        if sorted {
            samples.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        if tame {
            samples.retain(|(_, value)| value.is_nan() || value.abs() <= 1e30);
        }
        for outside in [Outside::Zero, Outside::Hold] {
            let averages = Light::<31>::from_samples_outside(&samples, outside);
            let points = Fine::<Power>::interpolated_outside(&samples, Interpolation::Linear, outside);
            let smooth = Fine::<Power>::interpolated_outside(&samples, Interpolation::Sprague, outside);
            prop_assert_eq!(averages.is_ok(), points.is_ok());
            prop_assert!(points.is_ok() || smooth.is_err());
            // No average and no line between two points is beyond the samples.
            let most = samples.iter().map(|sample| sample.1.abs()).fold(0.0, f32::max);
            if let (true, Ok(averages), Ok(points)) = (tame, averages, points) {
                for value in averages.values().iter().chain(points.values()) {
                    prop_assert!(value.abs() <= most * 1.000_001 + 1e-44, "{} of {}", value, most);
                }
            }
        }
        prop_assert_eq!(Light::<31>::from_samples(&samples).is_ok(), Fine::<Power>::interpolated(&samples, Interpolation::Linear).is_ok());
    }
}
