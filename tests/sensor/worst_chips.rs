//! How exact spectra made of counts are, for the worst chips, alphas and lights that a search finds.
#![cfg(feature = "libm")]

use model::linear::solve;
use model::search::{Range::*, Worst, worst};
use model::sensor::{self, dot, transposed, wide};
use nanospectra::sensor::{BasicCounts, Reconstruction, nonnegative_spectrum};
use nanospectra::{Nodes, Observer, Power};

type Chip = Observer<8, 31, Power, Nodes<400, 700>>;

const AS7341_NM: [f64; 8] = [415.0, 445.0, 480.0, 515.0, 555.0, 590.0, 630.0, 680.0];

fn bell(n: usize, center_nm: f64, fwhm_nm: f64) -> f64 {
    let x = (400.0 + 10.0 * n as f64 - center_nm) / fwhm_nm;
    (-4.0 * std::f64::consts::LN_2 * x * x).exp()
}

/// Channels where those of the AS7341 are. What is off by -1 to 1 is a height, by half of it; a center, by 5 nm;
/// and a width, by a fifth.
fn chip(fwhm_nm: f64, off: &[f32]) -> Chip {
    let off = |k: usize| f64::from(off[k]);
    Observer::from_weights(std::array::from_fn(|c| {
        let (center, width) = (AS7341_NM[c] + 5.0 * off(8 + c), fwhm_nm * (1.0 + 0.2 * off(16 + c)));
        std::array::from_fn(|n| (10.0 * (1.0 + 0.5 * off(c)) * bell(n, center, width)) as f32)
    }))
}

/// Of the largest entry.
fn smooth(seed: u64, fwhm_nm: f64) -> Worst<25> {
    let mut ranges = [Even(-1.0, 1.0); 25];
    ranges[24] = Sizes(1e-6, 0.1);
    let covariance = sensor::smooth_covariance(31, 0.95_f32.into());
    worst(seed, 250, ranges, |at| {
        let chip = chip(fwhm_nm, &at);
        let Ok(found) = Reconstruction::smooth(&chip, 0.95, at[24]) else { return f64::NAN };
        let exact = sensor::wiener(&wide(chip.weights()), &covariance, at[24].into());
        let size = exact.iter().flatten().fold(0.0f64, |size, v| size.max(v.abs()));
        let pairs = found.rows().iter().flatten().zip(exact.iter().flatten());
        pairs.map(|(found, exact)| (f64::from(*found) - exact).abs() / size).fold(0.0, f64::max)
    })
}

#[test]
fn smooth_spectra_are_as_exact_as_promised() {
    smooth(1, 30.0).is_what_is_promised("smooth spectra, AS7341", 2e-6);
    smooth(2, 80.0).is_what_is_promised("smooth spectra, 80 nm", 8e-5);
    smooth(14, 120.0).is_what_is_promised("smooth spectra, 120 nm", 2e-3);
}

/// The least of all spectra that are nowhere negative, from the bins that are bright in one that is nearly it.
/// `None` if bright and dark bins do not settle.
fn least(g: &[Vec<f64>], counts: &[f64], alpha: f64, near: &[f32; 31]) -> Option<Vec<f64>> {
    let damping = alpha * g.iter().map(|row| dot(row, row)).sum::<f64>() / 8.0;
    let mut bright = near.map(|value| value > 0.0);
    for _ in 0..30 {
        let seen = |a: &[f64], b: &[f64]| (0..31).filter(|n| bright[*n]).map(|n| a[n] * b[n]).sum::<f64>();
        let mut normal: Vec<Vec<f64>> =
            g.iter().map(|one| g.iter().map(|other| seen(one, other)).collect()).collect();
        (0..8).for_each(|c| normal[c][c] += damping);
        let shares = solve(normal, counts.iter().map(|count| vec![*count]).collect());
        let shares: Vec<f64> = shares.into_iter().flatten().collect();
        let spectrum: Vec<f64> = transposed(g).iter().map(|column| dot(column, &shares)).collect();
        let now = std::array::from_fn(|n| spectrum[n] > 0.0);
        if now == bright {
            return Some(spectrum.into_iter().map(|value| value.max(0.0)).collect());
        }
        bright = now;
    }
    None
}

/// Of the peak, under a line or a diode and something wider.
fn positive(seed: u64, fwhm_nm: f64) -> Worst<30> {
    let mut ranges = [Even(-1.0, 1.0); 30];
    ranges[24] = Sizes(1e-3, 0.1);
    ranges[25..].copy_from_slice(&[
        Even(400.0, 700.0),
        Even(3.0, 60.0),
        Even(0.0, 1.0),
        Even(400.0, 700.0),
        Even(20.0, 120.0),
    ]);
    worst(seed, 1000, ranges, |at| {
        let (chip, alpha) = (chip(fwhm_nm, &at), at[24]);
        let [line, width, share, middle, wider] = [25, 26, 27, 28, 29].map(|k: usize| f64::from(at[k]));
        let light = std::array::from_fn(|n| (bell(n, line, width) + share * bell(n, middle, wider)) as f32);
        let counts = chip.sees(&nanospectra::Light::from_bins(light));
        let found = nonnegative_spectrum(&chip, &BasicCounts::new(counts), alpha, 50).expect("a light");
        let exact = least(&wide(chip.weights()), &wide(&[counts])[0], alpha.into(), found.values());
        let Some(exact) = exact else { return -1.0 };
        let size = exact.iter().fold(0.0f64, |size, v| size.max(*v));
        let pairs = found.values().iter().zip(&exact);
        pairs.map(|(found, exact)| (f64::from(*found) - exact).abs() / size).fold(0.0, f64::max)
    })
}

#[test]
fn positive_spectra_are_as_exact_as_promised() {
    positive(1, 30.0).is_what_is_promised("positive spectra, AS7341", 1.5e-6);
    positive(7, 80.0).is_what_is_promised("positive spectra, 80 nm", 1e-5);
}
