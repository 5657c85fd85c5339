//! Interpolates between samples whose wavelengths f32 cannot hold.
//!
//! The crate takes wavelengths in f32, which is exact for whole, half and quarter nanometers. The wavelength
//! of a pixel at 546.0761 nm is rounded by up to 3e-5 nm, which can change XYZ by 3e-5 beside a narrow line.
//! A file with such wavelengths is therefore interpolated in f64, by the same two rules.

use nanospectra::Interpolation;

/// Returns whether f32 would round one of the wavelengths.
pub fn is_needed(samples: &[(f64, f64)]) -> bool {
    samples.iter().any(|(nm, _)| f64::from(*nm as f32) != *nm)
}

/// Returns the value at `nm`, or `None` outside the samples.
///
/// For Sprague's rule there must be six or more samples at equal steps.
pub fn at(samples: &[(f64, f64)], nm: f64, by: Interpolation) -> Option<f64> {
    let (first, last) = (samples.first()?, samples.last()?);
    if !(first.0..=last.0).contains(&nm) {
        return None;
    }
    let above = samples.partition_point(|sample| sample.0 <= nm).min(samples.len() - 1);
    let (a, b) = (samples[above - 1], samples[above]);
    let t = (nm - a.0) / (b.0 - a.0);
    Some(match by {
        Interpolation::Linear => a.1 + (b.1 - a.1) * t,
        Interpolation::Sprague => {
            let step = (last.0 - first.0) / (samples.len() - 1) as f64;
            let cell = above - 1;
            sprague(samples, cell, (nm - first.0) / step - cell as f64)
        }
    })
}

/// Interpolates by CIE 167:2005 between the samples `cell` and `cell + 1`.
fn sprague(samples: &[(f64, f64)], cell: usize, t: f64) -> f64 {
    let n = samples.len();
    // The six samples from two before the cell to two behind it. Beyond an end, the boundary formula
    // provides them.
    let p: [f64; 6] = std::array::from_fn(|j| match (cell + j).checked_sub(2) {
        None => beyond(1 - (cell + j), |k| samples[k].1),
        Some(k) if k >= n => beyond(k - n, |k| samples[n - 1 - k].1),
        Some(k) => samples[k].1,
    });
    let a1 = (2.0 * p[0] - 16.0 * p[1] + 16.0 * p[3] - 2.0 * p[4]) / 24.0;
    let a2 = (-p[0] + 16.0 * p[1] - 30.0 * p[2] + 16.0 * p[3] - p[4]) / 24.0;
    let a3 = (-9.0 * p[0] + 39.0 * p[1] - 70.0 * p[2] + 66.0 * p[3] - 33.0 * p[4] + 7.0 * p[5]) / 24.0;
    let a4 = (13.0 * p[0] - 64.0 * p[1] + 126.0 * p[2] - 124.0 * p[3] + 61.0 * p[4] - 12.0 * p[5]) / 24.0;
    let a5 = (-5.0 * p[0] + 25.0 * p[1] - 50.0 * p[2] + 50.0 * p[3] - 25.0 * p[4] + 5.0 * p[5]) / 24.0;
    p[2] + t * (a1 + t * (a2 + t * (a3 + t * (a4 + t * a5))))
}

/// Returns the sample that is `steps + 1` (1 or 2) steps beyond an end, from the six inside it, nearest
/// first.
fn beyond(steps: usize, inside: impl Fn(usize) -> f64) -> f64 {
    let weights =
        [[508.0, -540.0, 488.0, -367.0, 144.0, -24.0], [884.0, -1960.0, 3033.0, -2648.0, 1080.0, -180.0]];
    weights[steps].iter().enumerate().map(|(k, weight)| weight * inside(k)).sum::<f64>() / 209.0
}

/// Returns the mean over each of 471 nanometers, of which the first is around `first_nm`, of straight lines between
/// samples, which go on with the values `outside`.
pub fn means(samples: &[(f64, f64)], first_nm: f64, outside: [f64; 2]) -> Vec<f64> {
    let mut means = vec![0.0; 471];
    let ends = (samples[0].0, samples[samples.len() - 1].0);
    let mut add = |from: f64, to: f64, value: &dyn Fn(f64) -> f64| {
        let cell = |nm: f64| (nm - first_nm + 0.5).floor().clamp(0.0, 470.0) as usize;
        for (k, mean) in means.iter_mut().enumerate().take(cell(to) + 1).skip(cell(from)) {
            let middle = first_nm + k as f64;
            let (low, high) = (from.max(middle - 0.5), to.min(middle + 0.5));
            if high > low {
                *mean += (high - low) * value(f64::midpoint(low, high));
            }
        }
    };
    add(f64::NEG_INFINITY, ends.0, &|_| outside[0]);
    for pair in samples.windows(2) {
        let [a, b] = [pair[0], pair[1]];
        add(a.0, b.0, &|nm| a.1 + (b.1 - a.1) * ((nm - a.0) / (b.0 - a.0)));
    }
    add(ends.1, f64::INFINITY, &|_| outside[1]);
    means
}
