//! The light flickermeter of IEC TR 61547-1, in two ways: by the filters of digital flickermeters, and by the
//! analog filters, which a light that repeats passes as a sum of sines.
//!
//! The report gives the analog filters (A.4 and A.5) and leaves to a meter how it computes them. The Matlab
//! function of Philips takes the bilinear transform, whose corners are kept for the Butterworth filters and
//! not for the weighting filter. That is the first way here; the second one says what it changes.

use std::f64::consts::{PI, TAU};

/// The factor by which a sine of 8.8 Hz that swings by 0.63 % from crest to trough is an instantaneous
/// flicker of 1.
pub const SCALE: f64 = 1.101603155420234e6;

/// The weighting filter, equation A.5: its numerator and its denominator, from the fourth power of s.
const WEIGHTING: [[f64; 5]; 2] =
    [[0.041661, 44.758, 2715.6, 29839.0, 0.0], [1.0, 196.32, 11781.0, 534820.0, 3505380.0]];

/// The short-term severity of instantaneous flicker: percentiles of the sorted values.
pub fn severity(instantaneous: &[f64]) -> f64 {
    let mut sorted = instantaneous.to_vec();
    sorted.sort_by(|a, b| b.total_cmp(a));
    let exceeded = |percent: &f64| {
        let place = percent / 100.0 * sorted.len() as f64 - 0.5;
        let (low, part) = (place.max(0.0).floor(), place.max(0.0).fract());
        let next = (low as usize + 1).min(sorted.len() - 1);
        sorted[low as usize] * (1.0 - part) + sorted[next] * part
    };
    let smoothed = |percents: &[f64]| percents.iter().map(exceeded).sum::<f64>() / percents.len() as f64;
    let sum = 0.0314 * smoothed(&[0.1])
        + 0.0525 * smoothed(&[0.7, 1.0, 1.5])
        + 0.0657 * smoothed(&[2.2, 3.0, 4.0])
        + 0.28 * smoothed(&[6.0, 8.0, 10.0, 13.0, 17.0])
        + 0.08 * smoothed(&[30.0, 50.0, 80.0]);
    sum.sqrt()
}

/// The instantaneous flicker of readings at equal steps after the first 20 s, as digital flickermeters
/// compute it: every filter is the bilinear transform of the analog one, and the mean of all readings is
/// subtracted first.
pub fn instantaneous(readings: &[f64], rate_hz: f64) -> Vec<f64> {
    let mean = readings.iter().sum::<f64>() / readings.len() as f64;
    let mut signal: Vec<f64> = readings.iter().map(|value| value / mean - 1.0).collect();
    // Butterworth filters, whose corners are kept by the transform.
    let warped = |hz: f64| 2.0 * rate_hz * (PI * hz / rate_hz).tan();
    let w = warped(0.05);
    filter(&mut signal, &bilinear(&[1.0, 0.0], &[1.0, w], rate_hz));
    let w = warped(35.0);
    for k in 0..3 {
        let damping = 2.0 * (PI * (2 * k + 1) as f64 / 12.0).sin();
        filter(&mut signal, &bilinear(&[0.0, 0.0, w * w], &[1.0, damping * w, w * w], rate_hz));
    }
    let [numerator, denominator] = WEIGHTING;
    filter(&mut signal, &bilinear(&numerator, &denominator, rate_hz));
    signal.iter_mut().for_each(|value| *value = SCALE * *value * *value);
    filter(&mut signal, &bilinear(&[0.0, 1.0], &[0.3, 1.0], rate_hz));
    signal.split_off((20.0 * rate_hz) as usize)
}

/// The severity of readings at equal steps.
pub fn pst_lm(readings: &[f64], rate_hz: f64) -> f64 {
    severity(&instantaneous(readings, rate_hz))
}

/// The coefficients of powers of 1/z for those of s, with s = 2 rate (z - 1) / (z + 1).
fn bilinear(numerator: &[f64], denominator: &[f64], rate_hz: f64) -> [Vec<f64>; 2] {
    let order = denominator.len() - 1;
    [numerator, denominator].map(|of_s| {
        let mut of_z = vec![0.0; order + 1];
        for (k, coefficient) in of_s.iter().enumerate() {
            // s^power as (2 rate)^power (1 - 1/z)^power (1 + 1/z)^(order - power)
            let power = order - k;
            let mut product = vec![coefficient * (2.0 * rate_hz).powi(power as i32)];
            for factor in 0..order {
                let sign = if factor < power { -1.0 } else { 1.0 };
                product.push(0.0);
                for n in (1..product.len()).rev() {
                    product[n] += sign * product[n - 1];
                }
            }
            of_z.iter_mut().zip(product).for_each(|(sum, value)| *sum += value);
        }
        of_z
    })
}

/// Filters a signal in place, from rest.
fn filter(signal: &mut [f64], [numerator, denominator]: &[Vec<f64>; 2]) {
    let order = numerator.len() - 1;
    let mut states = vec![0.0; order + 1];
    for value in signal {
        let input = *value / denominator[0];
        let out = numerator[0] * input + states[0];
        for k in 0..order {
            states[k] = states[k + 1] + numerator[k + 1] * input - denominator[k + 1] / denominator[0] * out;
        }
        *value = out;
    }
}

/// One part of a light beside its mean of 1: frequency in Hz, cosine and sine.
pub type Part = [f64; 3];

/// The severity of a light that is a sum of sines, which the analog filters have passed forever: `seconds` of
/// it, in steps of half a millisecond.
pub fn of_parts(parts: &[Part], seconds: f64) -> f64 {
    let step = 5e-4;
    // (rotation in a step, value), as complex numbers
    let mut lines: Vec<[f64; 4]> = parts
        .iter()
        .map(|[hz, cos, sin]| {
            let gain = analog(*hz);
            let (re, im) = (cos * gain[0] + sin * gain[1], cos * gain[1] - sin * gain[0]);
            let (s, c) = (TAU * hz * step).sin_cos();
            [c, s, re, im]
        })
        .filter(|[_, _, re, im]| re.hypot(*im) > 1e-9)
        .collect();
    let mut smooth = 0.0;
    let mut before: f64 = 0.0;
    let mut all = Vec::new();
    let settle = (10.0 / step) as usize;
    for k in 0..settle + (seconds / step) as usize {
        let seen: f64 = lines.iter().map(|line| line[2]).sum();
        for [c, s, re, im] in &mut lines {
            (*re, *im) = (*re * *c - *im * *s, *re * *s + *im * *c);
        }
        // The smoothing is exact for squares that change linearly within a step.
        let square = SCALE * seen * seen;
        let (x, decay) = (step / 0.3, (-step / 0.3_f64).exp());
        let slope = (square - before) / x;
        smooth = (smooth - before + slope) * decay + square - slope;
        before = square;
        if k >= settle {
            all.push(smooth);
        }
    }
    severity(&all)
}

/// The product of the analog filters at a frequency, real and imaginary.
fn analog(hz: f64) -> [f64; 2] {
    let times = |a: [f64; 2], b: [f64; 2]| [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]];
    let over = |a: [f64; 2], b: [f64; 2]| {
        let size = b[0] * b[0] + b[1] * b[1];
        [(a[0] * b[0] + a[1] * b[1]) / size, (a[1] * b[0] - a[0] * b[1]) / size]
    };
    let of = |polynomial: &[f64]| {
        polynomial.iter().fold([0.0, 0.0], |sum, next| {
            let [re, im] = times(sum, [0.0, TAU * hz]);
            [re + next, im]
        })
    };
    let w = TAU * 0.05;
    let mut gain = over(of(&[1.0, 0.0]), of(&[1.0, w]));
    let w = TAU * 35.0;
    for k in 0..3 {
        let damping = 2.0 * (PI * (2 * k + 1) as f64 / 12.0).sin();
        gain = times(gain, over([w * w, 0.0], of(&[1.0, damping * w, w * w])));
    }
    times(gain, over(of(&WEIGHTING[0]), of(&WEIGHTING[1])))
}
