//! What is made of readings besides color: uncertainty, flicker, the median of the last ones.

use model::allowed::check;
use model::cct::{cct as nearest, uv_at};
use nanospectra::color::{Uv1960, Xyz};
use nanospectra::observer::CIE_1931;
use nanospectra::sensor::{
    BasicCounts, Calibration, Exposure, Flicker, Noise, Variances, XyzCovariance, amplitude_at, chip::as7341,
    mean_over_periods, whole_periods_ms,
};

/// Mean and standard deviation.
fn spread(values: &[f64]) -> (f64, f64) {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let squares: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
    (mean, (squares / (values.len() - 1) as f64).sqrt())
}

/// Rows from the eye's functions at the channels' peaks: enough to spread noise like a real calibration.
fn by_the_peaks() -> Calibration<8> {
    let peaks = [415, 445, 480, 515, 555, 590, 630, 680];
    Calibration::from_rows(CIE_1931.weights().map(|row| peaks.map(|nm: usize| row[nm - 360])))
}

#[test]
fn uncertainties_are_the_spread_of_simulated_readings() {
    const DRAWS: usize = 40_000;
    let (exposure, to_xyz) = (as7341::exposure(16.0, 29, 599), by_the_peaks());
    let noise = Noise { electrons_per_count: 180.0, read_counts: 1.5 };
    let mut dice = model::noise::Noise(0x5eed_5eed_5eed_5eed);
    for level in [1.0, 0.2] {
        let counts =
            [820.0, 2310.0, 3050.0, 4100.0, 5200.0, 6050.0, 7400.0, 6900.0].map(|count: f64| count * level);
        let draw = |dice: &mut model::noise::Noise| {
            counts.map(|count| {
                let variance = count * 16.0 / 180.0 + 1.5 * 1.5;
                (count + variance.sqrt() * dice.normal()).round() as u16
            })
        };
        let mut drawn: [Vec<f64>; 5] = Default::default();
        for _ in 0..DRAWS {
            let basic = exposure.basic_counts(&draw(&mut dice)).expect("neither dark nor saturated");
            let xyz = to_xyz.xyz(&basic).expect("no negative sums");
            let (cct_k, duv) = xyz.uv1960().expect("not black").cct().near().expect("near the locus");
            for (all, one) in drawn.iter_mut().zip([xyz.x, xyz.y, xyz.z, 1e6 / cct_k, duv]) {
                all.push(one.into());
            }
        }
        let exact: [u16; 8] = counts.map(|count| count.round() as u16);
        let covariance = to_xyz.covariance(&noise.variances(&exposure, &exact));
        let xyz = to_xyz.xyz(&exposure.basic_counts(&exact).expect("counts")).expect("a color");
        let [x, y, z] = covariance.uncertainty().to_array();
        let cct = covariance.cct(xyz).expect("near the locus");
        // The spread of so many draws is itself uncertain by 0.35 %; four times that, and 0.5 % for the bend
        // of the locus over the noise.
        for (of, (said, seen)) in ["X", "Y", "Z", "mired", "Duv"]
            .into_iter()
            .zip([x, y, z, cct.mired, cct.duv].into_iter().zip(drawn.iter().map(|all| spread(all).1)))
        {
            println!("level {level}, {of}: said {said:.6e}, seen {seen:.6e}");
            assert!((f64::from(said) / seen - 1.0).abs() < 0.02, "{of}: {said} and not {seen}");
        }
        let [lux] =
            Calibration::from_rows([to_xyz.rows()[1]]).uncertainty(&noise.variances(&exposure, &exact));
        assert_eq!(lux, y);
    }
}

#[test]
fn uncertainty_of_color_temperature_follows_the_model_over_the_whole_range() {
    let (mut mireds, mut duvs) = (check("uncertainty of CCT"), check("uncertainty of Duv"));
    for mired in [1.0, 3.0, 20.0, 100.0, 153.8, 200.0, 333.0, 500.0, 700.0, 950.0, 1000.0] {
        for duv in [-0.0499, -0.03, -0.01, 0.0, 0.01, 0.03, 0.0499] {
            let [u, v] = uv_at(1e6 / mired, duv);
            // Y = 100.
            let size = 600.0 / v;
            let xyz = [u * size / 4.0, 100.0, (size - u * size / 4.0 - 1500.0) / 3.0];
            let point = |xyz: [f64; 3]| {
                let size = xyz[0] + 15.0 * xyz[1] + 3.0 * xyz[2];
                nearest([4.0 * xyz[0] / size, 6.0 * xyz[1] / size])
            };
            // How far the point moves by each of X, Y and Z.
            let moves = [0, 1, 2].map(|cause| {
                let mut moved = [xyz; 2];
                moved[0][cause] += 1e-3;
                moved[1][cause] -= 1e-3;
                let [after, before] = moved.map(point);
                let by_mired = (1e6 / after.cct_k - 1e6 / before.cct_k).abs() / 2e-3;
                [by_mired, (after.duv - before.duv).abs() / 2e-3]
            });
            // In units of what all three do together: one of them may do nothing.
            let [all_mired, all_duv] =
                [0, 1].map(|k| moves.iter().map(|by| by[k] * by[k]).sum::<f64>().sqrt());
            for (cause, [by_mired, by_duv]) in moves.into_iter().enumerate() {
                let variance = |of: usize| if of == cause { 1.0 } else { 0.0 };
                let covariance = XyzCovariance {
                    xx: variance(0),
                    yy: variance(1),
                    zz: variance(2),
                    ..XyzCovariance::default()
                };
                let found = covariance.cct(Xyz::from(xyz.map(|value| value as f32)));
                let place = format!("{mired} mired, Duv {duv}, by {cause}");
                let found = found.unwrap_or_else(|| panic!("no uncertainty at {place}"));
                mireds.value(&place, f64::from(found.mired) / all_mired, by_mired / all_mired);
                duvs.value(&place, f64::from(found.duv) / all_duv, by_duv / all_duv);
                let in_k = f64::from(found.mired) * 1e6 / (mired * mired);
                assert!((f64::from(found.cct_k) / in_k - 1.0).abs() < 0.02, "{place}");
            }
        }
    }
    mireds.tight_over_all();
    duvs.tight_over_all();
}

#[test]
fn what_has_no_color_temperature_has_no_uncertainty_of_one() {
    let covariance = XyzCovariance { xx: 1.0, yy: 1.0, zz: 1.0, ..XyzCovariance::default() };
    assert_eq!(covariance.cct(Xyz::new(0.0, 0.0, 0.0)), None);
    assert_eq!(covariance.cct(Xyz::new(20.0, 100.0, 5.0)), None); // a green
    let nan = covariance.cct(Xyz::new(f32::NAN, 100.0, 100.0)).expect("NaN is not hidden");
    assert!(nan.mired.is_nan() && nan.duv.is_nan() && nan.cct_k.is_nan());
    let none = XyzCovariance::default().cct(Xyz::new(95.0, 100.0, 108.0)).expect("near daylight");
    assert_eq!((none.mired, none.duv), (0.0, 0.0));
}

#[test]
fn variances_add_up_and_shrink_with_the_number_of_readings() {
    let exposure = Exposure::new(4.0, 0.5, 65_535);
    let noise = Noise { electrons_per_count: 50.0, read_counts: 3.0 };
    // (1000 * 4 / 50 + 9 + 1/12) / (4 * 0.5)^2
    let [of_one, of_none, of_dark] = noise.variances(&exposure, &[1000.0, 0.0, -7.0]).to_array();
    assert!((of_one - (80.0 + 9.0 + 1.0 / 12.0) / 4.0).abs() < 1e-5);
    assert!((of_none - (9.0 + 1.0 / 12.0) / 4.0).abs() < 1e-6);
    assert_eq!(of_none, of_dark);
    let both = Variances::new([4.0, 9.0]).plus(&Variances::new([5.0, 16.0]));
    assert_eq!(both.uncertainty(), BasicCounts::new([3.0, 5.0]));
    assert_eq!(both.of_mean(9).uncertainty().values()[0], 1.0);
    assert_eq!(both.of_mean(0), both);
    assert!(noise.variances(&exposure, &[f32::NAN]).uncertainty().values()[0].is_nan());
    let without_shot_noise = Noise { electrons_per_count: f32::INFINITY, read_counts: 0.0 };
    assert_eq!(without_shot_noise.variances(&exposure, &[60_000_u16]).to_array(), [1.0 / 48.0]);
}

/// Readings that integrate a wave of one turn: `rate_hz` of them in a second.
fn read(wave: impl Fn(f64) -> f64, rate_hz: f64, frequency_hz: f64, phase: f64, readings: usize) -> Vec<f32> {
    const PARTS: usize = 400;
    let turns = |k: usize, part: usize| {
        phase + (k as f64 + (part as f64 + 0.5) / PARTS as f64) * frequency_hz / rate_hz
    };
    (0..readings)
        .map(|k| (0..PARTS).map(|part| wave(turns(k, part).rem_euclid(1.0))).sum::<f64>() / PARTS as f64)
        .map(|mean| mean as f32)
        .collect()
}

#[test]
fn pulses_average_to_their_duty_whatever_phase_and_rate() {
    let mut worst: f64 = 0.0;
    let mut worst_plain: f64 = 0.0;
    for (rate, frequency) in
        [(1000.0, 100.0), (1000.0, 120.0), (333.0, 100.0), (2777.0, 1220.0), (80.0, 100.0)]
    {
        for step in 0..20 {
            for duty in [0.1, 0.5, 0.9] {
                let pulses = |turn: f64| if turn < duty { 100.0 } else { 0.0 };
                let readings = read(pulses, rate, frequency, f64::from(step) / 20.0, 57);
                let mean = mean_over_periods(&readings, rate as f32, frequency as f32).expect("periods");
                let plain = f64::from(readings.iter().sum::<f32>()) / 57.0;
                worst = worst.max((f64::from(mean) / 100.0 - duty).abs());
                worst_plain = worst_plain.max((plain / 100.0 - duty).abs());
                if rate == 1000.0 && frequency == 100.0 {
                    assert!((f64::from(mean) / 100.0 - duty).abs() < 1e-4, "{mean} for {duty}");
                }
            }
        }
    }
    println!("duty off by {worst:.4}, by {worst_plain:.4} as a plain mean");
    assert!(worst < 0.011 && worst_plain > 2.0 * worst);
}

#[test]
fn percent_and_index_are_those_of_textbook_waves() {
    use std::f64::consts::{PI, TAU};
    let of = |wave: &dyn Fn(f64) -> f64| {
        let readings = read(wave, 100_000.0, 100.0, 0.0, 2500);
        Flicker::of(&readings, 100_000.0, 100.0).expect("two periods")
    };
    let near = |found: Flicker, mean: f64, percent: f64, index: f64| {
        let found = [found.mean, found.percent / 100.0, found.index].map(f64::from);
        for (found, wanted) in found.into_iter().zip([mean, percent / 100.0, index]) {
            assert!((found - wanted).abs() < 4e-3, "{found} and not {wanted}");
        }
    };
    near(of(&|_| 5.0), 5.0, 0.0, 0.0);
    near(of(&|turn| 1.0 + 0.4 * (TAU * turn).sin()), 1.0, 40.0, 0.4 / PI);
    // A full-wave rectifier: mean 2/pi; the area above it is (2 cos a - 2 a' 2/pi) ... of a half sine.
    let a = (2.0 / PI).asin();
    let above = (2.0 * a.cos() - (PI - 2.0 * a) * 2.0 / PI) / 2.0;
    near(of(&|turn| (PI * turn).sin()), 2.0 / PI, 100.0, above);
    near(of(&|turn| if turn < 0.2 { 3.0 } else { 0.0 }), 0.6, 100.0, 0.8);
    near(of(&|turn| if turn < 0.5 { 3.0 } else { 1.0 }), 2.0, 50.0, 0.25);
}

#[test]
fn goertzel_finds_the_amplitude_of_its_frequency_and_of_no_other() {
    let mut amplitudes = check("amplitude of one frequency");
    for (per_period, periods) in [(2.5, 40), (4.0, 1), (4.0, 250), (10.0, 100), (20.0, 5), (100.0, 10)] {
        for phase in [0.0, 0.1, 0.37, 0.8] {
            let readings: Vec<f32> = (0..(per_period * f64::from(periods)) as usize)
                .map(|k| {
                    let turn = std::f64::consts::TAU * (k as f64 / per_period + phase);
                    (7.0 + 3.0 * turn.sin() + 0.5 * (2.0 * turn).cos()) as f32
                })
                .collect();
            let found = amplitude_at(&readings, 1000.0, (1000.0 / per_period) as f32).expect("periods");
            // With four readings a period and fewer the octave falls on its own or another frequency.
            if per_period > 4.0 || per_period == 2.5 {
                amplitudes.value(&format!("{per_period} in each of {periods}"), found.into(), 3.0);
            } else {
                assert!((found - 3.0).abs() < 1e-3, "{found}");
            }
        }
    }
    amplitudes.tight_over_all();
    let constant = [5.0; 40];
    assert!(amplitude_at(&constant, 1000.0, 100.0).is_some_and(|amplitude| amplitude < 1e-5));
}

#[test]
fn flicker_has_no_answer_where_there_is_none() {
    let pulses = [4.0, 0.0, 4.0, 0.0];
    for (rate, frequency) in [(0.0, 100.0), (1000.0, 0.0), (-1.0, 1.0), (f32::NAN, 1.0), (1.0, f32::NAN)] {
        assert_eq!(Flicker::of(&pulses, rate, frequency), None);
        assert_eq!(mean_over_periods(&pulses, rate, frequency), None);
        assert_eq!(amplitude_at(&pulses, rate, frequency), None);
    }
    for few in [&pulses[..0], &pulses[..1]] {
        assert_eq!(mean_over_periods(few, 1000.0, 500.0), None);
        assert_eq!(Flicker::of(few, 1000.0, 500.0), None);
    }
    // One reading that is a whole period has a mean, and shows no flicker.
    assert_eq!(mean_over_periods(&[3.0], 100.0, 100.0), Some(3.0));
    assert_eq!(Flicker::of(&[3.0], 100.0, 100.0), None);
    assert_eq!(Flicker::of(&[0.0; 4], 1000.0, 500.0), None);
    assert_eq!(Flicker::of(&[-1.0; 4], 1000.0, 500.0), None);
    let hidden = Flicker::of(&[1.0, f32::NAN, 1.0, 1.0], 1000.0, 500.0).expect("NaN is not hidden");
    assert!(hidden.mean.is_nan() && hidden.percent.is_nan() && hidden.index.is_nan());
    assert!(amplitude_at(&[1.0, f32::NAN, 1.0, 1.0], 1000.0, 500.0).is_some_and(f32::is_nan));
    // What is left over after whole periods does not matter.
    assert_eq!(mean_over_periods(&[1.0, 3.0, f32::NAN], 1000.0, 500.0), Some(2.0));
    // Noise below zero is no more than all.
    let dark = Flicker::of(&[4.0, -1.0, 4.0, -1.0], 1000.0, 500.0).expect("some light");
    assert_eq!(dark.percent, 100.0);
}

#[test]
fn whole_periods_leave_no_flicker() {
    let mut left = check("residual modulation");
    for step in 1..=2000 {
        let time_ms = f64::from(step) * 0.1;
        let exposure = Exposure::new(1.0, time_ms as f32, 65_535);
        for hz in [50.0, 100.0, 120.0, 1000.0] {
            let half = std::f64::consts::PI * hz * f64::from(exposure.time_ms()) * 1e-3;
            left.value(
                &format!("{time_ms} ms, {hz} Hz"),
                exposure.residual_modulation(hz as f32).into(),
                (half.sin() / half).abs(),
            );
        }
    }
    left.tight(8000);
    assert_eq!(Exposure::new(1.0, 50.0, 1).residual_modulation(0.0), 1.0);
    assert!(Exposure::new(1.0, 50.0, 1).averages(100.0) && Exposure::new(1.0, 50.0, 1).averages(120.0));
    assert!(!Exposure::new(1.0, 15.0, 1).averages(100.0));
    assert_eq!(whole_periods_ms(100.0, 57.0), Some(50.0));
    assert_eq!(whole_periods_ms(120.0, 50.0), Some(50.0));
    assert_eq!(whole_periods_ms(100.0, 9.0), None);
    for nothing in [0.0, -100.0, f32::NAN] {
        assert_eq!(whole_periods_ms(nothing, 50.0), None);
        assert_eq!(whole_periods_ms(100.0, nothing), None);
    }
}

/// Rates are not round numbers: a hundred thousandth of a period may be missing, and no more.
#[test]
fn a_period_that_is_nearly_whole_counts() {
    // Of five periods of 10 ms 0.8 and 1.2 hundred thousandths are missing.
    assert_eq!(whole_periods_ms(100.0, 49.9996), Some(50.0));
    assert_eq!(whole_periods_ms(100.0, 49.9994), Some(40.0));
    // Four readings of a flicker with periods of 2 and of nearly 2 readings.
    let readings = [1.0, 3.0, 1.0, 7.0];
    assert_eq!(mean_over_periods(&readings, 1000.0, 499.997), Some(3.0));
    assert!(mean_over_periods(&readings, 1000.0, 499.98).is_some_and(|mean| (mean - 2.0).abs() < 1e-3));
}

#[test]
fn colors_near_every_corner_of_the_range_have_an_uncertainty() {
    let covariance = XyzCovariance { xx: 1.0, yy: 1.0, zz: 1.0, ..XyzCovariance::default() };
    let mut without = 0;
    for mired in [1.0, 1.5, 998.0, 1000.0] {
        for duv in [-0.05, -0.0497, 0.0497, 0.05] {
            let [u, v] = uv_at(1e6 / mired, duv).map(|value| value as f32);
            let size = 600.0 / v;
            let xyz = Xyz::new(u * size / 4.0, 100.0, (size - u * size / 4.0 - 1500.0) / 3.0);
            let at = Uv1960 { u, v };
            if at.cct().near().is_some() && covariance.cct(xyz).is_none() {
                without += 1;
            }
        }
    }
    assert_eq!(without, 0);
}

#[cfg(feature = "heapless")]
#[test]
fn a_window_has_the_median_of_what_it_holds() {
    use nanospectra::sensor::Window;
    let mut dice = model::noise::Noise(0x77ee_dd00_1122_3344);
    let mut window = Window::<9>::new();
    assert_eq!((window.median(), window.mean(), window.last()), (None, None, None));
    let mut all: Vec<f32> = Vec::new();
    for _ in 0..500 {
        // Few different values: most windows hold some twice.
        let reading = (dice.uniform() * 12.0).floor() as f32;
        window.push(reading);
        all.push(reading);
        let held = &all[all.len().saturating_sub(9)..];
        assert!(window.iter().eq(held) && window.len() == held.len());
        let mut sorted = held.to_vec();
        sorted.sort_by(f32::total_cmp);
        let half = sorted.len() / 2;
        let median =
            if sorted.len() % 2 == 1 { sorted[half] } else { (sorted[half - 1] + sorted[half]) / 2.0 };
        assert_eq!(window.median(), Some(median), "{held:?}");
        let mean = held.iter().sum::<f32>() / held.len() as f32;
        assert!((window.mean().expect("readings") - mean).abs() < 1e-5);
        assert_eq!(window.last(), Some(reading));
    }
    assert!(window.is_full());
    window.push(f32::NAN);
    assert!(window.median().is_some_and(f32::is_nan) && window.mean().is_some_and(f32::is_nan));
    window.clear();
    assert!(window.is_empty() && window.median().is_none());
}
