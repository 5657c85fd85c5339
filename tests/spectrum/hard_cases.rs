//! What goes wrong in f32 if it is written naively, at the tolerance that the stable form holds: Planck's law
//! from 1 K to 1e12 K, long sums, extreme scales. (Color differences, Lab and transfer functions have files
//! of their own; the locus has `cct.rs`, the roots have `backends.rs`.)
#![cfg(feature = "libm")]

use model::allowed::{Singles, check};
use model::check::{Check, EPS};
use model::csv::golden;
use model::noise::Noise;
use model::planck;
use nanospectra::color::Xyz;
use nanospectra::light::{blackbody, blackbody_relative, blackbody_relative_with, blackbody_with};
use nanospectra::math::{Libm, Math, Portable, cbrt};
use nanospectra::observer::{ALPHA_OPIC, CIE_1931};
use nanospectra::{Bins, Fine, Grid, Light, Nodes, Observer, Power, Spectrum};

/// Below this `blackbody` gives zero.
const FLUSHED: f64 = 1e-38;

/// Spectral radiance per nm of these very f32, in f64.
fn radiance(nm: f32, kelvin: f32) -> f64 {
    1e-9 * planck::radiance(nm.into(), kelvin.into())
}

/// The error as a multiple of what conditioning excuses; both are compared as (error / excuse) against 0.
fn compare(check: &mut Check, nm: f32, kelvin: f32, got: f32, exact: f64, excuse: f64) {
    let error = (f64::from(got) - exact).abs() / (exact * excuse * EPS);
    check.value(&format!("{nm} nm, {kelvin} K: {got:e} for {exact:e}"), error, 0.0);
}

/// Compares one radiance, or sees that it is flushed; says whether it was compared.
fn compare_planck(check: &mut Check, nm: f32, kelvin: f32) -> bool {
    let (got, exact) = (blackbody(nm, kelvin), radiance(nm, kelvin));
    if got == 0.0 {
        assert!(exact < FLUSHED * (1.0 + 1e-4), "{nm} nm, {kelvin} K: 0 for {exact:e}");
        return false;
    }
    compare(check, nm, kelvin, got, exact, 3.0 * planck::x(nm.into(), kelvin.into()) + 8.0);
    true
}

#[test]
fn planck_is_right_wherever_light_is_seen() {
    let mut check = check("Planck, 360 to 830 nm, in (3x + 8) eps");
    let mut points = 0;
    for nm in 360..=830 {
        for step in 0..=230 {
            // 500 K to 1e5 K, equally spaced in the logarithm.
            let kelvin = (500.0 * 10f64.powf(f64::from(step) / 100.0)) as f32;
            assert!(compare_planck(&mut check, nm as f32, kelvin), "{nm} nm, {kelvin} K");
            points += 1;
        }
    }
    check.tight(points);
}

#[test]
fn planck_agrees_with_the_golden_from_x_rays_to_a_meter() {
    let mut check = check("Planck of the golden, in (3x + 8) eps");
    let (mut compared, mut flushed, mut exact_inputs) = (0, 0, 0);
    for row in golden("06_planck").rows() {
        let [nm, kelvin] = row.numbers(["wavelength_nm", "T"]);
        let (nm32, kelvin32) = (nm as f32, kelvin as f32);
        if !compare_planck(&mut check, nm32, kelvin32) {
            flushed += 1;
            continue;
        }
        compared += 1;
        // Where f32 holds the inputs, the printed value is the reference too.
        if f64::from(nm32) == nm && f64::from(kelvin32) == kelvin {
            let expected = 1e-9 * row.number("B_lambda");
            let excuse = 3.0 * row.number("x") + 8.0;
            compare(&mut check, nm32, kelvin32, blackbody(nm32, kelvin32), expected, excuse);
            exact_inputs += 1;
        }
    }
    check.tight(compared + exact_inputs);
    println!("{compared} compared, {exact_inputs} of them with exact inputs, {flushed} flushed to zero");
    assert!(exact_inputs > 200 && flushed > 50, "{exact_inputs} {flushed}");
    assert_eq!(compared + flushed, 609, "rows of the golden");
}

#[test]
fn planck_holds_at_a_trillion_kelvin_and_for_x_rays() {
    let mut check = check("Planck of great heat or short waves, in eps");
    for step in 0..400 {
        // 0.1 nm to 1 um, hot enough that x is small: rows 2 and 3, and between them.
        let nm = (0.1 * 10f64.powf(0.01 * f64::from(step))) as f32;
        for kelvin in [1e8f32, 3e8, 1e10, 1e12] {
            if planck::x(nm.into(), kelvin.into()) < 0.5 {
                compare(&mut check, nm, kelvin, blackbody(nm, kelvin), radiance(nm, kelvin), 1.0);
            }
        }
    }
    check.tight_over_more_than(1000);
    for (nm, kelvin) in [(555.0f32, 1e8f32), (555.0, 1e10), (555.0, 1e12), (0.1, 1e10), (1.0, 1e8)] {
        let (got, exact) = (f64::from(blackbody(nm, kelvin)), radiance(nm, kelvin));
        assert!((got - exact).abs() <= 4.0 * EPS * exact, "{nm} nm, {kelvin} K: {got:e} for {exact:e}");
    }
    assert_eq!((blackbody(1.0, 300.0), blackbody(0.1, 6500.0)), (0.0, 0.0), "too cold for x-rays");
}

#[test]
fn planck_fades_out_instead_of_stopping_where_the_exponential_overflows() {
    let mut check = check("Planck beyond x = 80, in (3x + 8) eps");
    let (mut compared, mut flushed) = (0, 0);
    for step in 0..4000 {
        let kelvin = 200.0 + 0.05 * step as f32;
        let x = planck::x(555.0, kelvin.into());
        let (got, exact) = (blackbody(555.0, kelvin), radiance(555.0, kelvin));
        if x <= 80.0 {
            continue;
        }
        if got == 0.0 {
            assert!(exact < FLUSHED * (1.0 + 1e-4), "{kelvin} K: 0 for {exact:e}");
            flushed += 1;
            continue;
        }
        compare(&mut check, 555.0, kelvin, got, exact, 3.0 * x + 8.0);
        compared += 1;
    }
    check.tight(compared);
    assert!(compared > 1000 && flushed > 100, "{compared} compared, {flushed} flushed");
    // Row 4 of the hard cases, 2e-30 W m-2 sr-1 for a meter, is 2e-39 for a nanometer: flushed.
    assert_eq!(blackbody(555.0, 250.0), 0.0);
    assert!(blackbody(555.0, 255.0) > 0.0);
    // No step where the two forms meet.
    let (below, above) = (blackbody(555.0, 324.05), blackbody(555.0, 324.06));
    assert!(below < above && above / below < 1.003, "{below:e} {above:e}");
}

#[test]
fn planck_of_nonsense_is_zero_infinite_or_nan_but_no_other_number() {
    assert_eq!(blackbody(555.0, 0.0), 0.0, "nothing radiates at absolute zero");
    assert!(blackbody(f32::NAN, 6500.0).is_nan() && blackbody(555.0, f32::NAN).is_nan());
    assert_eq!(blackbody(555.0, f32::INFINITY), f32::INFINITY);
    // Gamma rays: 10 MeV and beyond, where the fifth power underflows.
    for nm in [1e-4, 1e-5, 1e-7, 1e-10] {
        assert_eq!(blackbody(nm, 6500.0), 0.0, "{nm} nm");
    }
}

#[test]
fn the_shape_of_a_black_body_is_right_where_both_ends_underflow() {
    let mut check = check("Planck over 560 nm, in (4dx + 12) eps");
    let mut noise = Noise(5);
    for nm in (0..=940).map(|step| 360.0 + 0.5 * step as f32) {
        let random = 100.0 * 10f32.powf(noise.share());
        for kelvin in
            [random, 100.0, 150.0, 200.0, 250.0, 300.0, 1000.0, 2856.0, 6500.0, 2.5e4, 1e5, 1e8, 1e12]
        {
            let [x, x560] = [nm, 560.0].map(|nm| planck::x(nm.into(), kelvin.into()));
            let shape = (planck::ln_radiance(nm.into(), kelvin.into())
                - planck::ln_radiance(560.0, kelvin.into()))
            .exp();
            if !(1e-37..1e37).contains(&shape) {
                continue;
            }
            let excuse = 4.0 * (x - x560).abs() + 12.0;
            compare(&mut check, nm, kelvin, blackbody_relative(nm, kelvin), shape, excuse);
        }
    }
    check.tight_over_more_than(1000);
    assert_eq!(blackbody_relative(560.0, 2856.0), 1.0);
    // At 1 K the ratio is beyond f32 on both sides.
    assert_eq!((blackbody_relative(360.0, 1.0), blackbody_relative(830.0, 1.0)), (0.0, f32::INFINITY));
}

#[test]
fn short_names_mean_the_portable_backend() {
    for (nm, kelvin) in [(360.0, 500.0), (555.0, 2856.0), (830.0, 1e5)] {
        assert_eq!(blackbody(nm, kelvin), blackbody_with::<Portable>(nm, kelvin));
        assert_eq!(blackbody(nm, kelvin), blackbody_with::<Libm>(nm, kelvin));
        assert_eq!(blackbody_relative(nm, kelvin), blackbody_relative_with::<Portable>(nm, kelvin));
    }
}

#[cfg(feature = "micromath")]
#[test]
fn micromath_is_no_backend_for_color() {
    use nanospectra::math::Micromath;
    let mut check = check("Planck by micromath");
    for nm in (360..=830).step_by(10) {
        let nm = nm as f32;
        for kelvin in [500.0, 1000.0, 2000.0, 2856.0, 4000.0, 6500.0, 10_000.0, 1e5] {
            let got = blackbody_with::<Micromath>(nm, kelvin);
            check.value(&format!("{nm} nm, {kelvin} K"), got.into(), radiance(nm, kelvin));
        }
    }
    check.tight_over_all();
}

#[test]
fn thin_absorption_is_not_lost() {
    let mut check = check("1 - exp(-tau), in eps");
    for step in 0..=1000 {
        // 1e-12 to 10, equally spaced in the logarithm; rows 45: 1e-6 and 1e-8.
        let tau = (1e-12 * 10f64.powf(13.0 * f64::from(step) / 1000.0)) as f32;
        let exact = -(-f64::from(tau)).exp_m1();
        let got = -Portable::expm1(-tau);
        check.in_eps(&format!("tau {tau:e}"), got, exact);
    }
    check.tight_over_all();
    assert_eq!(1.0 - Portable::exp(-1e-8), 0.0, "the naive form loses it all");
}

#[test]
fn cube_roots_of_lab_are_better_than_a_power() {
    let mut check = check("cube root over 0.008 to 1, in eps");
    let (mut points, mut bits) = (0, 0.008f32.to_bits());
    while bits <= 1.0f32.to_bits() {
        let x = f32::from_bits(bits);
        let exact = f64::from(x).cbrt();
        check.in_eps(&format!("{x}"), cbrt(x), exact);
        points += 1;
        bits += 37;
    }
    check.tight(points);
    assert_eq!((cbrt(0.0), cbrt(-0.027), cbrt(1.0)), (0.0, -cbrt(0.027), 1.0));
}

/// Errors of sums of `N` products, in units of eps of the sum of their sizes.
fn sums<const N: usize, G: Grid>(what: &'static str, scale: f32) {
    let mut check = check(what);
    let mut noise = Noise(N as u64);
    for trial in 0..20_000 {
        let (weights, values) = (noise.shares::<N>(), noise.shares::<N>().map(|v| v * scale));
        let eye = Observer::<1, N, Power, G>::from_weights([weights]);
        let [got] = eye.sees(&Spectrum::from_bins(values));
        let exact: f64 = weights.iter().zip(values).map(|(w, v)| f64::from(*w) * f64::from(v)).sum();
        check.in_eps(&format!("trial {trial}"), got, exact);
    }
    check.tight(20_000);
}

#[test]
fn sums_of_471_81_and_31_terms_round_like_eight_short_ones() {
    sums::<471, Nodes<360, 830>>("sums of 471 products, in eps", 1.0);
    sums::<81, Nodes<380, 780>>("sums of 81 products, in eps", 1.0);
    sums::<31, Bins<400, 700>>("sums of 31 products, in eps", 1.0);
}

#[test]
fn sums_keep_their_accuracy_from_1e_minus_30_to_1e30() {
    sums::<471, Nodes<360, 830>>("sums of 471 products, in eps", 1e30);
    sums::<471, Nodes<360, 830>>("sums of 471 products, in eps", 1e-30);
    // A little beyond, the sum is infinite, as documented, and not a wrong number.
    let bright = CIE_1931.sees(&Fine::flat(1e37)).map(f32::is_infinite);
    assert_eq!(bright, [true; 3]);
    let xy = Xyz::from(CIE_1931.sees(&Fine::flat(1e30))).xy().expect("light");
    let faint = Xyz::from(CIE_1931.sees(&Fine::flat(1e-30))).xy().expect("light");
    assert!((xy.x - faint.x).abs() < 2e-7 && (xy.x - 0.33331).abs() < 1e-5, "{xy:?} {faint:?}");
}

/// What a core that treats subnormal numbers as zero makes of an eight-lane sum.
fn flushing(weights: &[f32], values: &[f32]) -> f32 {
    let flush = |x: f32| if x.is_subnormal() { 0.0 } else { x };
    let mut lanes = [0.0f32; 8];
    for (k, (w, v)) in weights.iter().zip(values).enumerate() {
        lanes[k % 8] = flush(lanes[k % 8] + flush(flush(*w) * flush(*v)));
    }
    let [a, b, c, d, e, f, g, h] = lanes;
    ((a + e) + (c + g)) + ((b + f) + (d + h))
}

#[test]
fn sums_are_the_same_on_cores_that_flush_subnormals() {
    let mut noise = Noise(44);
    let light = Fine::<Power>::from_bins(noise.shares());
    for scale in [1.0, 1e-20, 1e-30] {
        let light = light * scale;
        for (eye, sees) in [
            (CIE_1931.weights().as_slice(), CIE_1931.sees(&light).as_slice()),
            (ALPHA_OPIC.weights().as_slice(), ALPHA_OPIC.sees(&light).as_slice()),
        ] {
            for (row, got) in eye.iter().zip(sees) {
                let flushed = flushing(row, light.values());
                assert!((flushed / got - 1.0).abs() < 1e-6, "{scale:e}: {got:e} or {flushed:e}");
            }
        }
    }
    // In the ordinary range there is nothing to flush: the very same bits, lane by lane.
    for (row, got) in CIE_1931.weights().iter().zip(CIE_1931.sees(&light)) {
        assert_eq!(flushing(row, light.values()), got);
    }
}

#[test]
fn power_is_summed_as_carefully() {
    let mut check = check("power of 471 bins, in eps");
    let mut noise = Noise(3);
    for trial in 0..20_000 {
        let light = Light::<471, Nodes<360, 830>>::from_bins(noise.shares());
        let exact: f64 = light.values().iter().map(|v| f64::from(*v)).sum();
        check.in_eps(&format!("trial {trial}"), light.power(), exact);
    }
    check.tight(20_000);
}
