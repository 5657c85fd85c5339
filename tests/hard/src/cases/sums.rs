//! Rows 41 to 45: long sums, extreme scales and thin absorbers.

use super::Cases;
use super::noise::Noise;
use super::textbook::exp;
use nanospectra::matter::Absorber;
use nanospectra::observer::CIE_1931;
use nanospectra::{Bins, Fine, Grid, Nodes, Observer, Power, Spectrum};

pub fn rows(cases: &mut impl Cases) {
    cases.row("41", &terms::<942>(270), naive::<942>, lanes::<942, 471, Nodes<360, 830>>);
    cases.row("42a", &terms::<62>(2155), naive::<62>, lanes::<62, 31, Bins<400, 700>>);
    cases.row("42b", &terms::<162>(740), naive::<162>, lanes::<162, 81, Nodes<380, 780>>);
    cases.row("43", &[[1e30], [1e36], [1e37]], naive_bright, |&[scale]| CIE_1931.sees(&Fine::flat(scale)));
    cases.row("44", &[[1e-30], [1e-36], [1e-38]], |&[scale]| faint(scale), |_| faint(1e-30));
    cases.row(
        "45",
        &[1e-8, 1e-6, 1e-4, 1e-2, 1.0, 5.0].map(|tau| [tau]),
        |&[tau]| [1.0 - exp(-tau)],
        absorbed,
    );
}

/// Returns sixteen draws of weights and values from 0 to 1, among them one for which the naive sum is bad.
fn terms<const A: usize>(first: u64) -> [[f32; A]; 16] {
    let mut seed = first;
    [(); 16].map(|()| {
        let mut noise = Noise(seed);
        seed += 1;
        [(); A].map(|()| noise.share())
    })
}

/// Sums the products of the two halves, one after the other.
fn naive<const A: usize>(terms: &[f32; A]) -> [f32; 1] {
    let (weights, values) = terms.split_at(A / 2);
    [weights.iter().zip(values).fold(0.0, |sum, (w, v)| sum + w * v)]
}

fn lanes<const A: usize, const N: usize, G: Grid>(terms: &[f32; A]) -> [f32; 1] {
    let halves = terms.split_at(A / 2);
    let (Ok(weights), Ok(values)) = (<[f32; N]>::try_from(halves.0), <[f32; N]>::try_from(halves.1)) else {
        return [f32::NAN];
    };
    Observer::<1, N, Power, G>::from_weights([weights]).sees(&Spectrum::from_bins(values))
}

/// Sums the rows for an equal-energy light of `scale` per nm.
fn naive_bright(&[scale]: &[f32; 1]) -> [f32; 3] {
    CIE_1931.weights().map(|row| row.iter().fold(0.0, |sum, w| sum + w * scale))
}

/// Returns XYZ of a light that falls off towards red, computed at a scale and divided by it.
fn faint(scale: f32) -> [f32; 3] {
    let mut share = 1.0;
    let light = Fine::<Power>::from_bins([(); 471].map(|()| {
        share *= 0.99;
        share * scale
    }));
    CIE_1931.sees(&light).map(|v| v / scale)
}

fn absorbed(&[tau]: &[f32; 1]) -> [f32; 1] {
    match Absorber::<1>::from_per_m([tau]) {
        Ok(dye) => *dye.absorbed(1.0).values(),
        Err(_) => [f32::NAN],
    }
}
