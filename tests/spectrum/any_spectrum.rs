//! What holds for every spectrum, on spectra that nobody chose.

use model::fine::Curve as Lines;
use model::interpolation::Outside as ModelOutside;
use nanospectra::color::{Xyz, cie76, dominant_wavelength};
use nanospectra::light::FL11;
use nanospectra::observer::CIE_1931;
use nanospectra::{
    Bins, Curve, Factor, Fine, FineObserver, Grid, Interpolation, Light, Nodes, Observer, Outside, Power,
    Reflectance, Spectrum,
};
use proptest::prelude::*;

/// Increasing wavelengths around the visible, at steps from a hundredth to 40 nm, and positive values.
fn samples() -> impl Strategy<Value = Vec<(f32, f32)>> {
    let steps = prop_oneof![0.01f32..0.5, 0.5f32..5.0, 5.0f32..40.0];
    (340.0f32..420.0, prop::collection::vec((steps, 0.0f32..10.0), 2..400)).prop_map(|(start, steps)| {
        let mut nm = start;
        let mut samples = Vec::new();
        for (step, value) in steps {
            samples.push((nm, value));
            nm += step;
        }
        samples
    })
}

/// Hundreds of samples in a bin, or one in many bins: the spacing is the same throughout.
fn dense_or_sparse() -> impl Strategy<Value = Vec<(f32, f32)>> {
    (prop_oneof![Just(0.05f32), Just(0.3), Just(7.0), Just(120.0)], prop::collection::vec(0.0f32..10.0, 300))
        .prop_map(|(step, values)| {
            let count = ((400.0 / step) as usize).clamp(4, 300);
            let start = if count == 300 { 500.0 } else { 370.0 };
            values.iter().take(count).enumerate().map(|(k, v)| (start + k as f32 * step, *v)).collect()
        })
}

fn bins<Q, const N: usize, G: Grid>() -> impl Strategy<Value = Spectrum<Q, N, G>> {
    prop::collection::vec(0.0f32..1.0, N).prop_map(|values| {
        let mut spectrum = Spectrum::flat(0.0);
        spectrum.values_mut().copy_from_slice(&values);
        spectrum
    })
}

/// Any finite f32 at all: tiny, huge, negative.
fn wild<Q, const N: usize, G: Grid>() -> impl Strategy<Value = Spectrum<Q, N, G>> {
    use prop::num::f32::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    prop::collection::vec(POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO, N).prop_map(|values| {
        let mut spectrum = Spectrum::flat(0.0);
        spectrum.values_mut().copy_from_slice(&values);
        spectrum
    })
}

/// Samples at any finite wavelengths, often the largest that there are.
fn anywhere() -> impl Strategy<Value = Vec<(f32, f32)>> {
    use prop::num::f32::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    let edges = prop::sample::select(vec![f32::MIN, f32::MAX, -1e38, 1e38, -1e-45, 1e-45, 380.0, 730.0]);
    let nm = prop_oneof![POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO, edges, 300.0f32..900.0];
    prop::collection::vec((nm, -2.0f32..2.0), 2..12).prop_map(|mut samples| {
        samples.sort_by(|a, b| a.0.total_cmp(&b.0));
        samples.dedup_by(|a, b| a.0 == b.0);
        if samples.len() < 2 {
            samples = vec![(f32::MIN, 1.0), (f32::MAX, -1.0)];
        }
        samples
    })
}

/// |a - b| within `share` of what is summed up to them.
fn near(a: f32, b: f32, size: f32, share: f32) -> Result<(), TestCaseError> {
    prop_assert!((a - b).abs() <= share * size, "{a} and {b} differ by {:e} of {size}", (a - b).abs() / size);
    Ok(())
}

fn near_f64(a: f64, b: f64, share: f64) -> Result<(), TestCaseError> {
    prop_assert!((a - b).abs() <= share * b, "{a} and {b} differ by {:e}", a / b - 1.0);
    Ok(())
}

/// The power without the rounding of its own sum.
fn power_of<const N: usize, G: Grid>(light: &Spectrum<Power, N, G>) -> f64 {
    let bins = if G::CENTERED { N - 1 } else { N } as f64;
    light.values().iter().map(|v| f64::from(*v)).sum::<f64>() * (G::LAST - G::FIRST) / bins
}

fn as_f64(samples: &[(f32, f32)]) -> Vec<(f64, f64)> {
    samples.iter().map(|(nm, value)| (f64::from(*nm), f64::from(*value))).collect()
}

/// Bin averages against the exact integral of the straight lines between the samples.
fn averages_are_exact<const N: usize, G: Grid>(samples: &[(f32, f32)]) -> Result<(), TestCaseError> {
    let peak = samples.iter().map(|s| s.1).fold(0.0, f32::max);
    for (outside, model) in [(Outside::Zero, ModelOutside::Zero), (Outside::Hold, ModelOutside::Hold)] {
        let lines = Lines::new(as_f64(samples), model);
        let spectrum =
            Spectrum::<Power, N, G>::from_samples_outside(samples, outside).expect("increasing samples");
        for (k, got) in spectrum.values().iter().enumerate() {
            let edge = |k: usize| f64::from(Spectrum::<Power, N, G>::edge_nm(k));
            // Beyond the samples' ends zero begins at once: the model has the bin's exact average.
            let exact = lines.mean(edge(k), edge(k + 1));
            near(*got, exact as f32, peak, 2e-6)?;
        }
    }
    Ok(())
}

fn power_is_conserved<const N: usize, G: Grid, const M: usize, H: Grid>(
    light: &Spectrum<Power, N, G>,
) -> Result<(), TestCaseError> {
    let there: Spectrum<Power, M, H> = light.resample();
    near_f64(power_of(&there), power_of(light), 5e-7)?;
    // Also of a single bin, where no errors cancel.
    let mut one = Spectrum::<Power, N, G>::flat(0.0);
    let k = light.values()[0].to_bits() as usize % N;
    one.values_mut()[k] = 1.0;
    let there: Spectrum<Power, M, H> = one.resample();
    near_f64(power_of(&there), power_of(&one), 2e-6)
}

/// A fine observer under, through and before something, and what then falls on it the long way round.
fn chain(light: &Fine<Power>, a: &Fine<Factor>, b: &Fine<Factor>) -> [([f32; 3], [f32; 3]); 3] {
    let eye: &FineObserver<3> = &CIE_1931;
    [
        (eye.through(a).sees(light), eye.sees(&(*light * *a))),
        (eye.under(light).sees(a), eye.sees(&(*light * *a))),
        (eye.through(a).looking_at(b).under(light).sees(&Fine::flat(1.0)), eye.sees(&(*light * *a * *b))),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 500,
        ..ProptestConfig::default()
    })]

    #[test]
    fn averages_are_the_exact_integral_of_irregular_samples(samples in samples()) {
        averages_are_exact::<1, Bins<380, 730>>(&samples)?;
        averages_are_exact::<16, Bins<380, 730>>(&samples)?;
        averages_are_exact::<81, Nodes<380, 780>>(&samples)?;
        averages_are_exact::<471, Nodes<360, 830>>(&samples)?;
    }

    #[test]
    fn averages_are_exact_with_one_or_with_hundreds_of_samples_in_a_bin(samples in dense_or_sparse()) {
        averages_are_exact::<3, Bins<380, 730>>(&samples)?;
        averages_are_exact::<31, Bins<400, 700>>(&samples)?;
        averages_are_exact::<401, Nodes<380, 780>>(&samples)?;
    }

    #[test]
    fn all_the_power_of_the_samples_is_on_a_grid_that_holds_them(samples in samples()) {
        let samples: Vec<(f32, f32)> = samples.into_iter().filter(|(nm, _)| *nm < 900.0).collect();
        let (first, last) = (samples[0].0, samples[samples.len() - 1].0);
        let light = Light::<61, Bins<300, 900>>::from_samples(&samples).expect("increasing");
        let lines = Lines::new(as_f64(&samples), ModelOutside::Zero);
        let exact = lines.mean(first.into(), last.into()) * f64::from(last - first);
        // A bin is good to 2e-6 of the largest sample.
        let peak = samples.iter().map(|s| s.1).fold(0.0, f32::max);
        near(light.power(), exact as f32, exact as f32 + Light::<61, Bins<300, 900>>::WIDTH_NM * peak, 2e-6)?;
    }

    #[test]
    fn what_is_seen_is_linear_in_the_light(
        a in bins::<Power, 31, Bins<380, 730>>(), b in bins::<Power, 31, Bins<380, 730>>(), k in 0.01f32..100.0,
    ) {
        let eye: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);
        let (of_a, of_b, both) = (eye.sees(&a), eye.sees(&b), eye.sees(&(a + b * k)));
        for c in 0..3 {
            let sum = of_a[c] + k * of_b[c];
            near(both[c], sum, sum, 1e-6)?;
        }
        // A power of two is exact, so it is the same bits.
        prop_assert_eq!(eye.sees(&(a * 0.25)), of_a.map(|v| v * 0.25));
    }

    #[test]
    fn power_is_conserved_between_grids(
        wide in bins::<Power, 16, Bins<380, 730>>(), narrow in bins::<Power, 350, Bins<380, 730>>(),
        nodes in bins::<Power, 81, Nodes<380, 780>>(),
    ) {
        power_is_conserved::<16, _, 31, Bins<380, 730>>(&wide)?;
        power_is_conserved::<16, _, 1, Bins<380, 730>>(&wide)?;
        power_is_conserved::<16, _, 471, Nodes<360, 830>>(&wide)?;
        power_is_conserved::<350, _, 16, Bins<380, 730>>(&narrow)?;
        power_is_conserved::<350, _, 349, Bins<380, 730>>(&narrow)?;
        power_is_conserved::<350, _, 471, Bins<380, 730>>(&narrow)?;
        power_is_conserved::<350, _, 37, Bins<300, 1000>>(&narrow)?;
        power_is_conserved::<81, _, 60, Bins<370, 790>>(&nodes)?;
        power_is_conserved::<81, _, 401, Nodes<350, 850>>(&nodes)?;
    }

    #[test]
    fn finer_bins_come_nearer_to_the_truth(
        lamp in bins::<Power, 9, Bins<380, 730>>(), paint in bins::<Factor, 9, Bins<380, 730>>(),
    ) {
        // A smooth surface under a smooth light, seen at 1 nm and in ever more bins.
        let knots = |values: &[f32]| -> Vec<(f32, f32)> {
            values.iter().enumerate().map(|(k, v)| (360.0 + 47.0 * k as f32, 0.2 + v)).collect()
        };
        let by = Interpolation::Sprague;
        let light = Fine::<Power>::interpolated_outside(&knots(lamp.values()), by, Outside::Hold).expect("regular");
        let paint = Fine::<Factor>::interpolated(&knots(paint.values()), by).expect("regular");
        let eye = CIE_1931.under(&light);
        prop_assume!(eye.row_sums()[1] > 1.0);
        let eye = eye.with_white_y(100.0);
        let truth = Xyz::from(eye.sees(&paint));
        fn off<const N: usize>(eye: &FineObserver<3, Factor>, paint: &Fine<Factor>, truth: Xyz) -> f32 {
            let folded: Observer<3, N, Factor, Nodes<360, 830>> = eye.fold(Curve::Parabola);
            let seen = Xyz::from(folded.sees(&paint.resample()));
            (seen.x - truth.x).abs().max((seen.y - truth.y).abs()).max((seen.z - truth.z).abs())
        }
        let errors = [off::<11>(&eye, &paint, truth), off::<48>(&eye, &paint, truth), off::<471>(&eye, &paint, truth)];
        let [coarse, fine, finest] = errors;
        prop_assert!(fine <= 0.05 * coarse + 0.15 && finest < 2e-4, "{errors:?}");
    }

    #[test]
    fn a_folded_chain_is_the_chain_folded(
        light in bins::<Power, 471, Nodes<360, 830>>(),
        a in bins::<Factor, 471, Nodes<360, 830>>(),
        b in bins::<Factor, 471, Nodes<360, 830>>(),
    ) {
        for (folded, walked) in chain(&light, &a, &b) {
            for c in 0..3 {
                near(folded[c], walked[c], walked[c], 1.2e-6)?;
            }
        }
        // What comes first and what second is the same glass; and to fold at full resolution changes nothing.
        let eye = CIE_1931.through(&a).through(&b);
        let other = CIE_1931.through(&b).looking_at(&a);
        let full: FineObserver<3> = eye.fold(Curve::Step);
        for c in 0..3 {
            near(eye.sees(&light)[c], other.sees(&light)[c], eye.sees(&light)[c], 1.2e-6)?;
            near(eye.sees(&light)[c], full.sees(&light)[c], eye.sees(&light)[c], 1e-6)?;
        }
    }

    #[test]
    fn the_light_itself_is_the_same_at_every_number_of_bins(light in bins::<Power, 471, Nodes<360, 830>>()) {
        let eye = CIE_1931.under(&light);
        let exact = eye.row_sums();
        let white = |seen: [f32; 3]| -> Result<(), TestCaseError> {
            for (got, exact) in seen.iter().zip(exact) {
                prop_assert!((f64::from(*got) / exact - 1.0).abs() < 4e-7, "{got} {exact}");
            }
            Ok(())
        };
        for curve in [Curve::Step, Curve::Parabola, Curve::Spline] {
            white(eye.fold::<1, Bins<380, 730>>(curve).sees(&Reflectance::flat(1.0)))?;
            white(eye.fold::<16, Bins<380, 730>>(curve).sees(&Reflectance::flat(1.0)))?;
            white(eye.fold::<81, Nodes<380, 780>>(curve).sees(&Reflectance::flat(1.0)))?;
        }
    }

    #[test]
    fn a_batch_is_seen_as_its_spectra_are_one_by_one(
        batch in prop::collection::vec(bins::<Power, 31, Bins<380, 730>>(), 0..9), room in 0usize..9,
    ) {
        let eye: Observer<3, 31, Power> = CIE_1931.fold(Curve::Spline);
        let mut reports = vec![[-1.0f32; 3]; room];
        eye.sees_each(&batch, &mut reports);
        for (k, report) in reports.iter().enumerate() {
            // The shorter of the two says how many; the rest is left alone.
            let expected = batch.get(k).map_or([-1.0; 3], |light| eye.sees(light));
            prop_assert_eq!(report.map(f32::to_bits), expected.map(f32::to_bits));
        }
    }

    #[test]
    fn mixed_channels_are_the_matrix_times_what_is_seen(
        light in bins::<Power, 31, Bins<380, 730>>(), m in prop::array::uniform6(-2.0f32..2.0),
    ) {
        let eye: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);
        let matrix = [[m[0], m[1], m[2]], [m[3], m[4], m[5]]];
        let (seen, mixed) = (eye.sees(&light), eye.mixed(&matrix).sees(&light));
        for (row, got) in matrix.iter().zip(mixed) {
            let terms: Vec<f32> = row.iter().zip(seen).map(|(m, s)| m * s).collect();
            let size = terms.iter().map(|t| t.abs()).sum();
            near(got, terms.iter().sum(), size, 2e-6)?;
        }
    }

    #[test]
    fn what_is_swapped_is_the_same(
        a in bins::<Factor, 31, Bins<380, 730>>(), b in bins::<Factor, 31, Bins<380, 730>>(),
        light in bins::<Power, 31, Bins<380, 730>>(),
    ) {
        prop_assert_eq!(a * b, b * a);
        prop_assert_eq!(a + b, b + a);
        let eye: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);
        let (first, last) = (eye.through(&a).under(&light).sees(&b), eye.under(&light).through(&a).sees(&b));
        for c in 0..3 {
            near(first[c], last[c], last[c], 1e-6)?;
            let there = eye.sees(&(light * a))[c];
            near(eye.looking_at(&a).sees(&light)[c], there, there, 1e-6)?;
        }
        let white = Xyz::from(eye.sees(&light));
        let [one, two] = [&a, &b].map(|s| Xyz::from(eye.under(&light).sees(s)).lab(white).expect("light"));
        prop_assert_eq!(cie76(one, two), cie76(two, one));
    }

    #[test]
    fn no_finite_spectrum_makes_it_panic(
        light in wild::<Power, 16, Bins<380, 730>>(), paint in wild::<Factor, 16, Bins<380, 730>>(),
        nm in prop::num::f32::ANY, power in prop::num::f32::ANY,
    ) {
        let mut lamp = light * paint + light - light * 2.0;
        let _ = (lamp.add_line(nm, power), lamp.power(), lamp.peak());
        let far: Spectrum<Power, 7, Nodes<700, 900>> = lamp.resample_outside(Outside::Hold);
        let fine: Fine<Power> = lamp.interpolate(Interpolation::Sprague);
        let eye: Observer<3, 16, Power> = CIE_1931.fold(Curve::Spline);
        let _ = (far.within(nm, power), eye.under(&light).with_white_y(100.0).sees(&paint));
        for xyz in [eye.sees(&lamp), CIE_1931.sees(&fine)].map(Xyz::from) {
            let (xy, uv) = (xyz.xy(), xyz.uv1960());
            let _ = (uv.map(|uv| uv.cct()), xyz.with_y(100.0), xyz.lab(Xyz::new(95.0, 100.0, 109.0)));
            if let Some(xy) = xy {
                let _ = (dominant_wavelength(xy, xy, &CIE_1931), xy.xyz(power), xy.uv1976());
            }
        }
    }

    #[test]
    fn lines_between_samples_anywhere_are_those_of_f64(samples in anywhere()) {
        let peak = samples.iter().map(|s| s.1.abs()).fold(0.0, f32::max);
        let lines = Lines::new(as_f64(&samples), ModelOutside::Zero);
        let points = Fine::<Power>::interpolated(&samples, Interpolation::Linear).expect("increasing samples");
        for (nm, value) in points.iter() {
            near(value, lines.at(nm.into()) as f32, peak, 5e-7)?;
        }
        let averages = Light::<31>::from_samples(&samples).expect("increasing samples");
        for (k, value) in averages.values().iter().enumerate() {
            let [low, high] = [k, k + 1].map(|k| f64::from(Light::<31>::edge_nm(k)));
            near(*value, lines.mean(low, high) as f32, peak, 8.2e-6)?;
        }
    }

    #[test]
    fn a_ramp_stays_one_at_any_regular_spacing(first in -3.4e38f32..700.0, step in 0.0f32..1.0, size in -4i32..39) {
        let step = f64::from(step) * 10_f64.powi(size) + 1.0;
        let nm = |k: usize| (f64::from(first) + k as f64 * step) as f32;
        let ramp: Vec<(f32, f32)> = (0..7).map(|k| (nm(k), k as f32)).collect();
        if let Ok(points) = Fine::<Power>::interpolated(&ramp, Interpolation::Sprague) {
            let line = Lines::new(as_f64(&ramp), ModelOutside::Zero);
            for (nm, value) in points.iter() {
                let exact = line.at(nm.into());
                // A sample may be off by 1 % of a step.
                prop_assert!((f64::from(value) - exact).abs() < 0.03, "{nm} nm: {value} for {exact}");
            }
        }
    }

    #[test]
    fn no_samples_make_it_panic(samples in prop::collection::vec((prop::num::f32::ANY, prop::num::f32::ANY), 0..20)) {
        let mut sorted = samples.clone();
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
        for samples in [samples, sorted] {
            for outside in [Outside::Zero, Outside::Hold] {
                let averages = Light::<31>::from_samples_outside(&samples, outside);
                let points = Fine::<Power>::interpolated_outside(&samples, Interpolation::Linear, outside);
                prop_assert_eq!(averages.is_ok(), points.is_ok());
                let _ = Fine::<Power>::interpolated_outside(&samples, Interpolation::Sprague, outside);
                let good = samples.len() >= 2
                    && samples.windows(2).all(|pair| pair[0].0 < pair[1].0)
                    && samples.iter().all(|(nm, value)| nm.is_finite() && value.is_finite());
                prop_assert_eq!(averages.is_ok(), good);
            }
        }
    }
}

#[test]
fn a_lamp_seen_through_glass_is_the_folded_glass_under_the_lamp() {
    // One chain with real tables, at compile time and at run time.
    static LAMP: Fine<Power> = FL11.fine();
    static GLASS: Fine<Factor> = nanospectra::matter::TCS[3];
    static EYE: Observer<3, 31, Factor> = CIE_1931.through(&GLASS).under(&LAMP).fold(Curve::Spline);
    let walked = CIE_1931.sees(&(LAMP * GLASS));
    for (folded, walked) in EYE.sees(&Reflectance::flat(1.0)).into_iter().zip(walked) {
        assert!((folded / walked - 1.0).abs() < 6e-7, "{folded} {walked}");
    }
}
