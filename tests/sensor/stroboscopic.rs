//! The stroboscopic visibility measure: the published threshold, waves with a known series, the f64 model.
#![cfg(feature = "libm")]

use model::allowed::check;
use model::flicker::{svm, threshold};
use model::noise::Noise;
use model::search::{Range::Even, worst};
use nanospectra::math::Fast;
use nanospectra::sensor::{stroboscopic_visibility, stroboscopic_visibility_with};
use std::f64::consts::{PI, TAU};

/// A light of this many readings in each period.
fn wave(per_period: usize, periods: usize, light: impl Fn(f64) -> f64) -> Vec<f32> {
    (0..per_period * periods).map(|k| light((k % per_period) as f64 / per_period as f64) as f32).collect()
}

/// The curve of IEC TR 63158 for a sine, as a table: what swings by so much is just visible.
#[test]
fn a_sine_at_the_published_threshold_is_just_visible() {
    for (hz, swing) in [
        (80.0, 0.242_9),
        (100.0, 0.256_3),
        (120.0, 0.275_7),
        (200.0, 0.365_4),
        (300.0, 0.491_5),
        (400.0, 0.618_6),
        (1000.0, 0.973_2),
        (2000.0, 0.999_8),
    ] {
        assert!((threshold(hz) - swing).abs() < 1e-4, "{hz} Hz: {}", threshold(hz));
        let readings = wave(20, 20, |turns| 50.0 * (1.0 + swing * (TAU * turns).sin()));
        let found = stroboscopic_visibility(&readings, 20.0 * hz as f32, hz as f32).expect("a light");
        assert!((found - 1.0).abs() < 4e-4, "{hz} Hz: {found}");
    }
}

#[test]
fn the_measure_follows_the_model() {
    let (mut all, mut fast) = (check("SVM"), check("SVM by Fast"));
    let mut noise = Noise(63158);
    for per_period in [10, 16, 20, 40, 50, 100] {
        for hz in [60.0, 100.0, 120.0, 250.0, 377.0, 1000.0] {
            for _ in 0..20 {
                let parts: [f32; 5] = noise.shares();
                let swing = f64::from(noise.decades(0.01, 1.0));
                let light = |turns: f64| {
                    let part =
                        |(m, part): (usize, &f32)| f64::from(*part) * (TAU * turns * (m + 1) as f64).sin();
                    300.0 * (1.0 + 0.3 * swing * parts.iter().enumerate().map(part).sum::<f64>())
                };
                let readings = wave(per_period, 1000 / per_period, light);
                let exact: Vec<f64> = readings.iter().map(|v| f64::from(*v)).collect();
                let (rate, hz) = ((per_period as f32) * hz, hz);
                let exact = svm(&exact, rate.into());
                let found = stroboscopic_visibility(&readings, rate, hz).expect("a light");
                let place = format!("{per_period} readings in each period of {hz} Hz");
                all.value(&place, f64::from(found) / exact, 1.0);
                let found = stroboscopic_visibility_with::<Fast, _>(&readings, rate, hz).expect("a light");
                fast.value(&place, f64::from(found) / exact, 1.0);
            }
        }
    }
    all.tight(6 * 6 * 20);
    fast.tight(6 * 6 * 20);
}

/// Long runs of slow turns are where the recurrence loses most. The model sees one period, which is enough of
/// a light that repeats.
#[test]
fn a_second_of_readings_is_measured_as_promised() {
    let ranges = [Even(10.0, 500.0), Even(80.0, 125.0), Even(0.0, 40.0), Even(0.0, 1.0)];
    worst(1, 40, ranges, |[per_period, hz, fall, phase]| {
        let (per_period, hz) = (per_period as usize, hz as usize);
        if per_period * hz > 50_000 {
            return -1.0;
        }
        let light = |turns: f64| (-f64::from(fall) * (turns + f64::from(phase)).fract()).exp();
        let readings = wave(per_period, hz, light);
        let period: Vec<f64> = readings[..per_period].iter().map(|v| f64::from(*v)).collect();
        let rate_hz = (per_period * hz) as f32;
        let exact = svm(&period, rate_hz.into());
        // Of light that is nearly steady, only what is seen counts.
        stroboscopic_visibility(&readings, rate_hz, hz as f32)
            .map_or(f64::NAN, |found| (f64::from(found) - exact).abs() / exact.max(0.01))
    })
    .is_what_is_promised("SVM of a second of readings", 1e-2);
}

/// A light that is on for 50 readings of 100 has odd parts of 4 / (100 sin(pi m / 100)), which are nearly the
/// 4 / (pi m) of a square wave.
#[test]
fn square_waves_are_seen_by_their_odd_parts() {
    let readings = wave(100, 10, |turns| if turns < 0.495 { 2.0 } else { 0.0 });
    let found = stroboscopic_visibility(&readings, 10_000.0, 100.0).expect("a light");
    let part = |m: f64| 4.0 / (100.0 * (PI * m / 100.0).sin());
    let parts = (0..10).map(|k| f64::from(2 * k + 1)).map(|m| (part(m) / threshold(100.0 * m)).powf(3.7));
    let series = parts.sum::<f64>().powf(1.0 / 3.7);
    assert!((f64::from(found) / series - 1.0).abs() < 1e-4, "{found}, by the series {series}");
    assert!((series - 4.9704).abs() < 0.01, "{series}");
}

#[test]
fn steady_light_is_zero_and_what_cannot_be_told_is_none() {
    let svm = |readings: &[f32], rate_hz, hz| stroboscopic_visibility(readings, rate_hz, hz);
    assert_eq!(svm(&[5.0; 400], 4000.0, 100.0), Some(0.0));
    assert_eq!(svm(&[], 4000.0, 100.0), None);
    assert_eq!(svm(&[5.0; 39], 4000.0, 100.0), None, "less than a period");
    assert_eq!(svm(&[0.0; 400], 4000.0, 100.0), None, "no light");
    assert_eq!(svm(&[5.0; 400], 0.0, 100.0), None);
    assert_eq!(svm(&[5.0; 400], 4000.0, 0.0), None);
    assert_eq!(svm(&[5.0; 400], 150.0, 100.0), None, "fewer than two readings in a period");
    assert!(svm(&[f32::NAN; 400], 4000.0, 100.0).is_some_and(f32::is_nan));
}
