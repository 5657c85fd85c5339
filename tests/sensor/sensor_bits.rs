//! Every public function of `sensor`, on numbers of any bits: none panics, and what is returned as a result
//! is one. (The integers of [`fixed`](nanospectra::sensor::fixed) have tests of their own besides.)
#![cfg(feature = "libm")]

use nanospectra::color::Xyz;
use nanospectra::math::Portable;
use nanospectra::sensor::fixed::{FixedMeter, FixedObserver, FixedXyz};
use nanospectra::sensor::*;
use nanospectra::{Bins, Light, Observer, Power};
use proptest::prelude::*;

type Grid = Bins<400, 700>;

/// Numbers of any bits, and often of a size that is in use, or an edge.
fn bits() -> impl Strategy<Value = f32> {
    let edges =
        vec![0.0, -0.0, 1.0, -1.0, f32::MAX, f32::MIN, f32::MIN_POSITIVE, 1e-45, f32::INFINITY, f32::NAN];
    prop_oneof![4 => any::<u32>().prop_map(f32::from_bits), 4 => -2.0f32..2.0, 1 => prop::sample::select(edges)]
}

fn four() -> impl Strategy<Value = [f32; 4]> {
    prop::array::uniform4(bits())
}

/// How often each test draws: 2,000 times, or as NANOSPECTRA_RUNS says.
fn runs() -> ProptestConfig {
    let runs = std::env::var("NANOSPECTRA_RUNS").ok().and_then(|runs| runs.parse().ok());
    ProptestConfig { cases: runs.unwrap_or(2_000), ..ProptestConfig::default() }
}

fn is_finite(numbers: &[f32]) -> bool {
    numbers.iter().all(|number| number.is_finite())
}

proptest! {
    #![proptest_config(runs())]

    #[test]
    fn readings_of_any_bits(
        [gain, time_ms, floor, k] in four(), full_scale in any::<u32>(), counts in four(), whole in any::<[u32; 4]>(),
        dark in four(), rows in prop::array::uniform3(four()), celsius in bits(), readings in any::<u16>(),
    ) {
        let exposure = Exposure::new(gain, time_ms, full_scale).with_floor(floor);
        let calibration = Calibration::from_rows(rows);
        let model = DarkCounts { offset: dark, rate: counts, measured_at_c: k, doubles_every_k: floor };
        let _ = (model.levels(&exposure), model.levels_at_with::<Portable>(&exposure, celsius));
        let noise = Noise { electrons_per_count: k, read_counts: celsius };
        let variances = noise.variances(&exposure, &counts).plus(&noise.variances(&exposure, &whole)).of_mean(readings);
        let covariance = calibration.covariance(&variances);
        let _ = (variances.uncertainty(), calibration.uncertainty(&variances), covariance.uncertainty());
        let saturated = exposure.saturated(&counts);
        let results = [
            exposure.basic_counts(&counts), exposure.basic_counts(&whole),
            exposure.basic_counts_above(&dark, &counts), exposure.basic_counts_above(&dark, &whole),
        ];
        if saturated.count() > 0 {
            prop_assert_eq!(results[0], Err(ReadingError::Saturated { channels: saturated }));
        }
        for basic in results.into_iter().flatten() {
            let drift = Drift { per_k: dark, calibrated_at_c: k };
            let _ = (basic.scaled(&dark), basic.without(&drift, celsius), calibration.scaled(k).apply(&basic));
            if let Ok(xyz) = calibration.xyz(&basic) {
                prop_assert!(!xyz.to_array().iter().any(|part| *part < 0.0), "{:?}", xyz);
                let _ = covariance.cct(xyz).map(|of| (of.cct_k, of.mired, of.duv));
            }
        }
        for meter in [Meter::new(&exposure, &calibration), Meter::new_above(&exposure, &dark, &calibration).scaled(k)] {
            for xyz in [meter.xyz(&counts), meter.xyz(&whole)].into_iter().flatten() {
                prop_assert!(!xyz.to_array().iter().any(|part| *part < 0.0), "{:?}", xyz);
            }
        }
    }

    #[test]
    fn integers_of_any_bits(
        [gain, time_ms, k, _] in four(), full_scale in any::<u32>(), counts in any::<[u16; 4]>(), dark in four(),
        rows in prop::array::uniform3(four()), xyz in any::<[i32; 3]>(), fraction in any::<i32>(),
    ) {
        let (exposure, calibration) = (Exposure::new(gain, time_ms, full_scale), Calibration::from_rows(rows).scaled(k));
        for meter in [FixedMeter::new(&exposure, &calibration), FixedMeter::new_above(&exposure, &dark, &calibration)]
            .into_iter()
            .flatten()
        {
            let _ = meter.saturated(&counts);
            if let Ok(found) = meter.xyz(&counts) {
                let _ = (found.cct(), found.uv1960(), found.lux(), found.millilux(), found.to_xyz());
            }
        }
        let found = FixedXyz::new(xyz, fraction);
        let _ = (found.cct(), found.uv1960(), found.lux(), found.millilux(), found.to_xyz(), found.fraction());
        if let Some(fixed) = FixedObserver::new(&Observer::<3, 4, Power, Grid>::from_weights(rows)) {
            prop_assert!(is_finite(rows.as_flattened()));
            let _ = (fixed.sees(&counts), fixed.unit());
        }
    }

    #[test]
    fn times_and_exposures_of_any_bits(
        ladder in prop::collection::vec((bits(), bits(), any::<u32>()), 0..6), counts in four(), share in bits(),
        place in 0usize..6, readings in prop::collection::vec(bits(), 0..40), rate in bits(), hz in bits(),
    ) {
        let exposures: Vec<Exposure> =
            ladder.iter().map(|(gain, ms, full_scale)| Exposure::new(*gain, *ms, *full_scale)).collect();
        if let Ok(auto) = AutoExposure::new(&exposures) {
            let auto = auto.with_target(share);
            prop_assert!(auto.middle() < exposures.len());
            let advice = auto.advise(place.min(exposures.len() - 1), &counts);
            prop_assert!(advice.next < exposures.len());
            let _ = (auto.exposure(advice.next), auto.advise(place, &[u16::MAX; 4]), auto.exposure(place));
        }
        for exposure in exposures {
            let _ = (exposure.residual_modulation(hz), exposure.averages(hz), exposure.per_count());
        }
        let flicker = Flicker::of(&readings, rate, hz);
        let (mean, amplitude) = (mean_over_periods(&readings, rate, hz), amplitude_at(&readings, rate, hz));
        prop_assert!(rate > 0.0 && hz > 0.0 || flicker.is_none() && mean.is_none() && amplitude.is_none());
        if let Some(flicker) = flicker {
            prop_assert!(flicker.mean > 0.0 || flicker.mean.is_nan());
            prop_assert!(!flicker.percent.is_nan() || !is_finite(&readings) || flicker.mean.is_infinite(), "{:?}", flicker);
        }
        if let Some(ms) = whole_periods_ms(hz, rate).filter(|_| hz.is_finite()) {
            // (A period that is missing a hundred-thousandth of all of them counts.)
            prop_assert!(ms > 0.0 && ms <= rate * 1.000_011, "{} {}", ms, rate);
        }
    }

    #[test]
    fn light_flickermeters_of_any_bits(
        rate in prop_oneof![bits(), 400.0f32..450.0], readings in prop::collection::vec(bits(), 1..40),
        sizes in prop::collection::vec(-1e15f32..1e15, 1..40),
    ) {
        let Some(meter) = LightFlickermeter::new(rate) else {
            prop_assert!(!(400.0..=50_000.0).contains(&rate), "{}", rate);
            return Ok(());
        };
        // A period as long as the list, again and again for 31 s.
        let of = |period: &[f32]| {
            let mut meter = meter.clone();
            let count = if rate < 500.0 { (31.0 * rate) as usize } else { period.len() };
            period.iter().cycle().take(count).for_each(|reading| meter.push(*reading));
            (count > 5000, meter.pst_lm())
        };
        for period in [&readings, &sizes] {
            let (is_long, severity) = of(period);
            let is_usable = period.iter().all(|reading| reading.abs() <= 1e15);
            match severity {
                Ok(severity) => prop_assert!(is_long && is_usable && severity >= 0.0 && severity.is_finite()),
                Err(PstLmError::NotANumber) => prop_assert!(!is_usable),
                Err(why) => prop_assert!(is_usable && is_long == (why == PstLmError::NoLight)),
            }
        }
    }

    #[test]
    fn spectra_of_any_bits(
        rows in prop::array::uniform2(prop::array::uniform8(bits())), counts in prop::array::uniform2(bits()),
        alpha in prop_oneof![bits(), 1e-4f32..1.0], correlation in prop_oneof![bits(), 0.0f32..1.0], others in four(),
    ) {
        let chip: Observer<2, 8, Power, Grid> = Observer::from_weights(rows);
        let basic = BasicCounts::new(counts);
        let lights = [Light::<8, Grid>::from_bins(rows[0]), Light::from_bins(rows[1])];
        let prior = covariance_of(&lights);
        let found = [
            Reconstruction::smooth(&chip, correlation, alpha), Reconstruction::tikhonov(&chip, alpha),
            Reconstruction::wiener(&chip, &prior, alpha),
        ];
        for found in found.into_iter().flatten() {
            prop_assert!(is_finite(found.rows().as_flattened()), "{:?}", found.rows());
            let _ = (found.spectrum(&basic), found.seen_by(&chip));
        }
        if let Ok(light) = nonnegative_spectrum(&chip, &basic, alpha, 20) {
            prop_assert!(light.iter().all(|(_, value)| value >= 0.0), "{:?}", light);
        }
        let mut fit = Fit::<2>::new();
        for [a, b, weight, y] in [others, [1.0, 2.0, 1.0, 3.0], [2.0, 1.0, 0.5, 1.0]] {
            fit.add(&BasicCounts::new([a, b]), [a, y, b], weight);
            fit.add_relative(&BasicCounts::new([b, a]), Xyz::new(a, y, b));
        }
        if let Ok(matrix) = fit.solve() {
            prop_assert!(is_finite(matrix.rows().as_flattened()));
            let _ = matrix.corrected(&counts).behind_glass(alpha);
            let leaks = [counts, [others[0], others[1]]];
            let in_use = leaks.as_flattened().iter().all(|leak| *leak == 0.0 || (1e-15..1e15).contains(&leak.abs()));
            let small = matrix.rows().as_flattened().iter().all(|weight| weight.abs() < 1e15);
            if let Ok(apart) = matrix.without_crosstalk(&leaks) {
                prop_assert!(!(in_use && small) || is_finite(apart.rows().as_flattened()), "{:?}", apart);
            }
        }
        let _ = (fit.residual_rms(), fit.condition(), fit.patches());
        if let Ok(errors) = fit.leave_one_out(&basic, [others[0], others[1], others[2]], alpha) {
            prop_assert!(is_finite(&errors));
        }
    }

    #[test]
    fn pixels_counters_and_bends_of_any_bits(
        coefficients in four(), counts in prop::array::uniform8(bits()), from in 0usize..9, to in 0usize..9, pixel in 0usize..8,
        text in "[ -~\n\r\t]{0,40}",
    ) {
        for first in [FirstPixel::Zero, FirstPixel::One] {
            if let Ok(pixels) = PixelWavelengths::<8, 4>::new(coefficients, first) {
                prop_assert!(pixels.nm(pixel).is_finite() && pixels.edge_nm(pixel) <= pixels.edge_nm(pixel + 1));
                let _ = pixels.rebinned::<16, Bins<380, 730>>(&counts);
            }
        }
        let _ = above_dark_pixels(&counts, from..to);
        let [seconds, rate, a, b] = coefficients;
        let counter = DeadTime::new(seconds);
        let (counted, arrived) = (counter.counted(rate), counter.arrived(rate));
        prop_assert!(seconds.is_nan() || rate.is_nan() || !is_finite(&[seconds, rate]) || !counted.is_nan() && !arrived.is_some_and(f32::is_nan));
        if let Some(bend) = Nonlinearity::new([a, b]) {
            let _ = bend.read(rate);
            prop_assert!(bend.signal(rate).is_none_or(|signal| signal.is_nan() == rate.is_nan()), "{}", rate);
        }
        let _ = read_responsivities::<1, 4, Grid>(&text);
        for chip in chip::ALL {
            let _ = (chip.exposure(&coefficients), chip.exposure(&coefficients[..3]), chip.peak_nm(pixel), chip::named(&text));
            prop_assert!(chip.settings.iter().all(|setting| !setting.allows(f32::NAN)));
        }
    }
}
