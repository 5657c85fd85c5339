//! Rows 49 to 51: eight counts of a sensor to 31 bins or to XYZ.

use super::Cases;
use nanospectra::light::D65;
use nanospectra::math::sqrt;
use nanospectra::matter::CES;
use nanospectra::observer::CIE_1931;
use nanospectra::sensor::{
    BasicCounts, Calibration, DEFAULT_ALPHA, Fit, Reconstruction, chip::as7341, gaussian_responsivities,
};
use nanospectra::{Curve, Fine, FineObserver, Nodes, Observer, Power};

pub fn rows(cases: &mut impl Cases) {
    let alphas = [1e-8, 1e-6, 1e-5, 1e-3, 1e-2].map(|alpha| [alpha]);
    cases.row("49", &alphas, normal_equations, tikhonov);
    let noises = [1e-7, 1e-6, 1e-5, 1e-4, 1e-2].map(|alpha| [alpha]);
    cases.row("50a", &noises, naive_wiener, wiener);
    cases.row("50b", &[[0.0]], twins_by_cholesky, twins);
    cases.row("51a", &[[0.0]], by_spectrum, direct);
    cases.row("51b", &[[0.0]], by_spectrum, direct);
}

const N: usize = 31;
type Points = Nodes<400, 700>;
pub type Chip = Observer<8, N, Power, Points>;

pub static AS7341: Chip = as7341::NOMINAL.fold(Curve::Step);

/// A chip of eight channels that are 120 nm wide, so that each overlaps its neighbors widely.
pub static WIDE: Chip = {
    let mut channels = [(415.0, 120.0); 8];
    let mut c = 0;
    while c < 8 {
        channels[c].0 = 415.0 + 265.0 / 7.0 * c as f64;
        c += 1;
    }
    let fine: FineObserver<8> = gaussian_responsivities(channels);
    fine.fold(Curve::Step)
};

/// The channel that counts 1 while the others count 0, so that the spectrum is a column of the matrix.
pub const COUNTED: usize = 3;
static COUNTS: [f32; 8] = {
    let mut counts = [0.0; 8];
    counts[COUNTED] = 1.0;
    counts
};
/// The correlation between neighboring bins of a smooth spectrum.
pub const SMOOTH: f32 = 0.95;

fn dot(a: &[f32], b: &[f32]) -> f32 {
    a.iter().zip(b).fold(0.0, |sum, (a, b)| sum + a * b)
}

/// Returns the mean square of a channel, to which alpha is relative.
fn signal(chip: &Chip) -> f32 {
    chip.weights().iter().fold(0.0, |sum, row| sum + dot(row, row)) / 8.0
}

/// Solves A x = b by Cholesky's factor; the result is NaN if a pivot is not positive.
#[expect(clippy::needless_range_loop, reason = "as the textbook has it")]
fn cholesky<const M: usize>(a: &mut [[f32; M]; M], b: &mut [f32; M]) {
    for j in 0..M {
        for i in j..M {
            let mut sum = a[i][j];
            for k in 0..j {
                sum -= a[i][k] * a[j][k];
            }
            a[i][j] = if i == j { sqrt(sum) } else { sum / a[j][j] };
        }
    }
    for i in 0..M {
        for k in 0..i {
            b[i] -= a[i][k] * b[k];
        }
        b[i] /= a[i][i];
    }
    for i in (0..M).rev() {
        for k in i + 1..M {
            b[i] -= a[k][i] * b[k];
        }
        b[i] /= a[i][i];
    }
}

/// Solves (G' G + alpha) s = G' c, which are 31 equations.
fn normal_equations(&[alpha]: &[f32; 1]) -> [f32; N] {
    let g = AS7341.weights();
    let (mut a, mut b) = ([[0.0; N]; N], [0.0; N]);
    for (i, (row, b)) in a.iter_mut().zip(&mut b).enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            *entry = g.iter().fold(0.0, |sum, g| sum + g[i] * g[j]);
        }
        row[i] += alpha * signal(&AS7341);
        *b = g.iter().zip(&COUNTS).fold(0.0, |sum, (g, c)| sum + g[i] * c);
    }
    cholesky(&mut a, &mut b);
    b
}

fn tikhonov(&[alpha]: &[f32; 1]) -> [f32; N] {
    Reconstruction::tikhonov(&AS7341, alpha).map_or([f32::NAN; N], spectrum)
}

fn spectrum(matrix: Reconstruction<8, N, Points>) -> [f32; N] {
    *matrix.spectrum(&BasicCounts::new(COUNTS)).values()
}

/// Computes K G' (G K G' + alpha)^-1 c with the covariance K of smooth spectra, which takes 8 equations.
fn smooth_by_cholesky(chip: &Chip, alpha: f32) -> [f32; N] {
    let g = chip.weights();
    let mut powers = [1.0; N];
    for k in 1..N {
        powers[k] = SMOOTH * powers[k - 1];
    }
    // K G' has a column for each channel.
    let kg = g.map(|row| {
        let mut column = [0.0; N];
        for (i, value) in column.iter_mut().enumerate() {
            *value = row.iter().enumerate().fold(0.0, |sum, (j, g)| sum + powers[i.abs_diff(j)] * g);
        }
        column
    });
    let mut m = [[0.0; 8]; 8];
    for (i, (row, g)) in m.iter_mut().zip(g).enumerate() {
        for (entry, column) in row.iter_mut().zip(&kg) {
            *entry = dot(g, column);
        }
        row[i] += alpha * signal(chip);
    }
    let mut x = COUNTS;
    cholesky(&mut m, &mut x);
    let mut spectrum = [0.0; N];
    for (column, x) in kg.iter().zip(x) {
        spectrum.iter_mut().zip(column).for_each(|(value, k)| *value += k * x);
    }
    spectrum
}

fn naive_wiener(&[alpha]: &[f32; 1]) -> [f32; N] {
    smooth_by_cholesky(&WIDE, alpha)
}

fn wiener(&[alpha]: &[f32; 1]) -> [f32; N] {
    Reconstruction::smooth(&WIDE, SMOOTH, alpha).map_or([f32::NAN; N], spectrum)
}

/// A chip with two equal channels, which cannot be told apart.
static TWINS: Chip = {
    let mut rows = *AS7341.weights();
    rows[1] = rows[0];
    Observer::from_weights(rows)
};

fn twins_by_cholesky(_: &[f32; 1]) -> [f32; 1] {
    let [first, ..] = smooth_by_cholesky(&TWINS, 0.0);
    super::answered(Some(if first.is_finite() { first } else { f32::NAN }))
}

fn twins(_: &[f32; 1]) -> [f32; 1] {
    super::answered(Reconstruction::smooth(&TWINS, SMOOTH, 0.0).ok().map(|matrix| spectrum(matrix)[0]))
}

/// Returns every second sample of CIE 224 under D65.
fn patches(first: usize) -> impl Iterator<Item = Fine<Power>> {
    let lamp: Fine<Power> = D65.fine();
    CES.iter().skip(first).step_by(2).map(move |sample| lamp * sample.fine())
}

fn counts(patch: &Fine<Power>) -> BasicCounts<8> {
    BasicCounts::new(as7341::NOMINAL.sees(patch))
}

/// Returns XYZ of the samples from which `calibration` was not made.
fn judged(calibration: &Calibration<8>) -> [f32; 147] {
    let mut all = [f32::NAN; 147];
    for (xyz, patch) in all.chunks_mut(3).zip(patches(1)) {
        xyz.copy_from_slice(&calibration.apply(&counts(&patch)));
    }
    all
}

/// Finds XYZ by way of 31 bins.
fn by_spectrum(_: &[f32; 1]) -> [f32; 147] {
    let eye: Observer<3, N, Power, Points> = CIE_1931.fold(Curve::Step);
    Reconstruction::smooth(&AS7341, SMOOTH, DEFAULT_ALPHA)
        .map_or([f32::NAN; 147], |matrix| judged(&matrix.seen_by(&eye)))
}

/// Finds XYZ by 3 x 8 numbers that were fitted to the other samples.
fn direct(_: &[f32; 1]) -> [f32; 147] {
    let mut fit = Fit::<8>::new();
    for patch in patches(0) {
        fit.add_relative(&counts(&patch), CIE_1931.sees(&patch).into());
    }
    fit.solve().map_or([f32::NAN; 147], |matrix| judged(&matrix))
}
