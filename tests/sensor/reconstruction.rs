//! From counts to a spectrum: that the matrices are those of f64 down to the smallest alpha, what alpha does,
//! and that the positive spectrum is the least of all positive ones.

use model::allowed::check;
use model::check::Check;
use model::noise::Noise;
use model::sensor::{self, wide};
use nanospectra::light::{FL2, FL11, HP1, LED_B1, LED_B3, LED_RGB1};
use nanospectra::matter::CES;
use nanospectra::observer::CIE_1931;
use nanospectra::sensor::{
    BasicCounts, Calibration, DEFAULT_ALPHA, FitError, Reconstruction, chip::as7341, covariance_of,
    gaussian_responsivities, nonnegative_spectrum,
};
use nanospectra::{
    Curve, FineObserver, Interpolation, Light, Nodes, Observer, Outside, Power, Spectrum, const_unwrap,
};
use proptest::prelude::*;

type Grid = Nodes<400, 700>;
type Chip = Observer<8, 31, Power, Grid>;

static AS7341: Chip = as7341::NOMINAL.fold(Curve::Step);
static EYE: Observer<3, 31, Power, Grid> = CIE_1931.fold(Curve::Step);
/// Eight channels so wide that each sees much of what its neighbors see.
static WIDE: Chip = wide_channels(80.0);
static WIDER: Chip = wide_channels(120.0);

const fn wide_channels(fwhm: f64) -> Chip {
    let mut channels = [(415.0, fwhm); 8];
    let mut c = 0;
    while c < 8 {
        channels[c].0 = 415.0 + 265.0 / 7.0 * c as f64;
        c += 1;
    }
    let fine: FineObserver<8> = gaussian_responsivities(channels);
    fine.fold(Curve::Step)
}

/// Made while compiling: the matrix alone is in the program.
static TO_SPECTRUM: Reconstruction<8, 31, Grid> =
    const_unwrap!(Reconstruction::smooth(&AS7341, 0.95, DEFAULT_ALPHA));
static TO_XYZ: Calibration<8> = TO_SPECTRUM.seen_by(&EYE);

static LAMPS: [Light<31, Grid>; 6] =
    [on_grid(&FL2), on_grid(&FL11), on_grid(&HP1), on_grid(&LED_B1), on_grid(&LED_B3), on_grid(&LED_RGB1)];
static LEARNT: Reconstruction<8, 31, Grid> =
    const_unwrap!(Reconstruction::wiener(&AS7341, &covariance_of(&LAMPS), DEFAULT_ALPHA));

const fn on_grid(lamp: &Spectrum<Power, 81, Nodes<380, 780>>) -> Light<31, Grid> {
    lamp.interpolate_outside(Interpolation::Linear, Outside::Hold)
}

/// Entries relative to the largest one.
fn compare(check: &mut Check, place: &str, rows: &[[f32; 8]; 31], expected: &[Vec<f64>]) {
    let size = expected.iter().flatten().fold(0.0f64, |size, v| size.max(v.abs()));
    for (n, (row, expected)) in rows.iter().zip(expected).enumerate() {
        for (got, expected) in row.iter().zip(expected) {
            check.value(&format!("{place}, bin {n}"), f64::from(*got) / size, expected / size);
        }
    }
}

#[test]
fn the_matrices_are_those_of_f64_down_to_the_smallest_alpha() {
    // Rows 49 and 50: the channels of a chip, and channels ever less different.
    for (what, chip) in [
        ("spectra of an AS7341, alpha 1e-6 to 0.1", &AS7341),
        ("spectra of 80 nm channels, alpha 1e-6 to 0.1", &WIDE),
        ("spectra of 120 nm channels, alpha 1e-6 to 0.1", &WIDER),
    ] {
        let mut check = check(what);
        let g = wide(chip.weights());
        println!("{what}: condition of G G' {:.3e}", sensor::condition(&sensor::transposed(&g)).powi(2));
        for correlation in [0.0f32, 0.95] {
            let k = sensor::smooth_covariance(31, correlation.into());
            for alpha in [1e-6f32, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1] {
                let got = Reconstruction::smooth(chip, correlation, alpha).expect("channels that differ");
                let expected = sensor::wiener(&g, &k, alpha.into());
                compare(&mut check, &format!("{correlation} {alpha}"), got.rows(), &expected);
            }
        }
        check.tight(31 * 8 * 12);
    }
}

#[test]
fn a_small_alpha_gains_nothing_and_amplifies_noise() {
    // Rows 49 and 50: the reflectances of the samples from their counts, with noise of 3 % of the mean signal
    // and without.
    let rms = |alpha: f32, noise: f64| {
        let matrix = Reconstruction::smooth(&AS7341, 0.95, alpha).expect("channels that differ");
        let (mut squares, mut random) = (0.0f64, Noise(9));
        for sample in &CES {
            let sample = Light::<31, Grid>::from_bins(*sample.resample::<31, Grid>().values());
            let mut counts = AS7341.sees(&sample);
            let mean = f64::from(counts.iter().sum::<f32>()) / 8.0;
            counts.iter_mut().for_each(|count| *count += (noise * mean * random.normal()) as f32);
            for (got, is) in matrix.spectrum(&BasicCounts::new(counts)).values().iter().zip(sample.values()) {
                squares += f64::from(got - is).powi(2);
            }
        }
        (squares / (99.0 * 31.0)).sqrt()
    };
    let least = rms(1e-8, 0.0);
    assert!((0.012..0.014).contains(&least), "{least}");
    for alpha in [1e-6, 1e-4, 1e-3, DEFAULT_ALPHA] {
        println!("alpha {alpha}: {:.3} of {least}", rms(alpha, 0.0) / least);
        assert!((rms(alpha, 0.0) / least - 1.0).abs() < 0.02, "{alpha}: {}", rms(alpha, 0.0));
    }
    println!("alpha 0.1: {:.3}", rms(1e-1, 0.0) / least);
    assert!(rms(1e-1, 0.0) > 1.2 * least);
    println!("with noise {} {} {}", rms(1e-6, 0.03), rms(DEFAULT_ALPHA, 0.03), rms(1e-1, 0.03));
    assert!(rms(DEFAULT_ALPHA, 0.03) < rms(1e-6, 0.03));
}

/// The covariance of lamps in f64, each divided by its mean.
pub fn exact_covariance<const N: usize, G: nanospectra::Grid>(lamps: &[Light<N, G>]) -> Vec<Vec<f64>> {
    let rows: Vec<Vec<f64>> = lamps
        .iter()
        .map(|lamp| {
            let values = wide(&[*lamp.values()]).remove(0);
            let mean = values.iter().sum::<f64>() / N as f64;
            values.into_iter().map(|v| v / mean).collect()
        })
        .collect();
    let mut covariance = sensor::product(&sensor::transposed(&rows), &rows);
    covariance.iter_mut().flatten().for_each(|v| *v /= lamps.len() as f64);
    covariance
}

#[test]
fn a_learnt_prior_gives_the_matrix_of_f64() {
    let k = exact_covariance(&LAMPS);
    let mut covariance = check("covariance of lamps");
    for (got, expected) in covariance_of(&LAMPS).iter().flatten().zip(k.iter().flatten()) {
        covariance.value("", (*got).into(), *expected);
    }
    covariance.tight(31 * 31);
    let g = wide(AS7341.weights());
    let mut learnt = check("spectra by a learnt prior");
    compare(&mut learnt, "0.01", LEARNT.rows(), &sensor::wiener(&g, &k, DEFAULT_ALPHA.into()));
    for alpha in [1e-6f32, 1e-4, 1e-1] {
        let matrix = Reconstruction::wiener(&AS7341, &covariance_of(&LAMPS), alpha).expect("channels");
        compare(&mut learnt, &format!("{alpha}"), matrix.rows(), &sensor::wiener(&g, &k, alpha.into()));
    }
    learnt.tight(4 * 31 * 8);
    // It knows the lamps it was made from better than one that only knows that spectra are smooth.
    let error = |matrix: &Reconstruction<8, 31, Grid>, lamp: &Light<31, Grid>| {
        let got = matrix.spectrum(&BasicCounts::new(AS7341.sees(lamp)));
        got.values().iter().zip(lamp.values()).map(|(got, is)| (got - is).powi(2)).sum::<f32>()
    };
    let all = |matrix| LAMPS.iter().map(|lamp| error(matrix, lamp)).sum::<f32>();
    println!("squares of errors: {} learnt, {} smooth", all(&LEARNT), all(&TO_SPECTRUM));
    assert!(all(&LEARNT) < 0.5 * all(&TO_SPECTRUM));
}

#[test]
fn a_covariance_given_as_numbers_is_the_smooth_one() {
    let covariance: [[f32; 31]; 31] =
        std::array::from_fn(|i| std::array::from_fn(|j| 0.95f32.powi(i.abs_diff(j) as i32)));
    let given = Reconstruction::wiener(&AS7341, &covariance, DEFAULT_ALPHA).expect("channels that differ");
    for (a, b) in given.rows().iter().flatten().zip(TO_SPECTRUM.rows().iter().flatten()) {
        assert!((a - b).abs() < 1e-6, "{a} {b}");
    }
    let tikhonov = Reconstruction::tikhonov(&AS7341, DEFAULT_ALPHA).expect("channels that differ");
    assert_eq!(
        tikhonov.rows(),
        Reconstruction::smooth(&AS7341, 0.0, DEFAULT_ALPHA).expect("the same").rows()
    );
}

#[test]
fn an_eye_sees_what_the_spectrum_shows() {
    let folded = sensor::product(&wide(EYE.weights()), &wide(TO_SPECTRUM.rows()));
    let mut check = check("reconstruction folded into an eye");
    for (row, expected) in TO_XYZ.rows().iter().zip(folded) {
        let size = expected.iter().fold(0.0f64, |size, v| size.max(v.abs()));
        for (got, expected) in row.iter().zip(expected) {
            check.value("", f64::from(*got) / size, expected / size);
        }
    }
    check.tight(24);
    for lamp in &LAMPS {
        let counts = BasicCounts::new(AS7341.sees(lamp));
        let long_way = EYE.sees(&TO_SPECTRUM.spectrum(&counts));
        for (a, b) in TO_XYZ.apply(&counts).into_iter().zip(long_way) {
            assert!((a / b - 1.0).abs() < 1e-5, "{a} {b}");
        }
    }
}

#[test]
fn sensors_of_any_unit_reconstruct_alike() {
    // Row 44.
    for scale in [1e-30f32, 1e-20, 1e20] {
        let chip: Chip = Observer::from_weights(AS7341.weights().map(|row| row.map(|w| w * scale)));
        let matrix = Reconstruction::smooth(&chip, 0.95, DEFAULT_ALPHA).expect("channels that differ");
        for (a, b) in matrix.rows().iter().flatten().zip(TO_SPECTRUM.rows().iter().flatten()) {
            assert!((a * scale - b).abs() < 1e-6, "{scale}: {a} {b}");
        }
        let counts = BasicCounts::new(chip.sees(&LAMPS[0]));
        let light = nonnegative_spectrum(&chip, &counts, DEFAULT_ALPHA, 30).expect("a lamp");
        let unscaled = BasicCounts::new(AS7341.sees(&LAMPS[0]));
        let unscaled = nonnegative_spectrum(&AS7341, &unscaled, DEFAULT_ALPHA, 30).expect("a lamp");
        for (a, b) in light.values().iter().zip(unscaled.values()) {
            assert!((a - b).abs() < 1e-5 * unscaled.peak(), "{scale}: {a} {b}");
        }
    }
}

#[test]
fn what_cannot_be_told_is_refused() {
    let smooth = |chip: &Chip, alpha| Reconstruction::smooth(chip, 0.95, alpha).map(|matrix| *matrix.rows());
    // Two channels alike: only alpha tells them apart.
    let mut rows = *AS7341.weights();
    rows[4] = rows[3];
    let twice: Chip = Observer::from_weights(rows);
    assert!(smooth(&twice, DEFAULT_ALPHA).is_ok());
    let refused = smooth(&twice, 0.0);
    assert!(matches!(refused, Err(FitError::IllConditioned { .. })), "{refused:?}");
    assert!(smooth(&AS7341, 0.0).is_ok());
    // A blind channel has no part in it; a blind chip is none.
    rows[4] = [0.0; 31];
    let blind_channel = smooth(&Observer::from_weights(rows), DEFAULT_ALPHA).expect("seven channels see");
    assert!(blind_channel.iter().all(|row| row[4] == 0.0));
    let blind: Chip = Observer::from_weights([[0.0; 31]; 8]);
    assert_eq!(smooth(&blind, DEFAULT_ALPHA), Err(FitError::IllConditioned { condition: f32::INFINITY }));
    for alpha in [-1.0, f32::NAN, f32::INFINITY] {
        assert_eq!(smooth(&AS7341, alpha), Err(FitError::NotFinite), "{alpha}");
    }
    for correlation in [1.5, f32::NAN] {
        assert!(Reconstruction::smooth(&AS7341, correlation, DEFAULT_ALPHA).is_err());
    }
    rows[4] = [f32::NAN; 31];
    assert_eq!(smooth(&Observer::from_weights(rows), DEFAULT_ALPHA), Err(FitError::NotFinite));
    let none = covariance_of::<31, Grid>(&[]);
    assert!(none.iter().flatten().all(|v| *v == 0.0));
    assert!(Reconstruction::wiener(&AS7341, &none, DEFAULT_ALPHA).is_err());
    assert_eq!(covariance_of(&[Light::<31, Grid>::flat(0.0), LAMPS[0]]), covariance_of(&[LAMPS[0]]));
    assert!(covariance_of(&[Light::<31, Grid>::flat(f32::NAN)])[0][0].is_nan());
    // A thousandth of a lamp is the same lamp.
    for (a, b) in
        covariance_of(&[LAMPS[1] * 1e-30]).iter().flatten().zip(covariance_of(&[LAMPS[1]]).iter().flatten())
    {
        assert!((a - b).abs() <= 1e-5 * b);
    }
}

/// The conditions of a minimum over s >= 0: alpha s = max(0, G' (c - G s)), relative to the sizes of what is
/// summed there.
fn off_the_minimum(chip: &Chip, counts: &[f32; 8], light: &Light<31, Grid>, alpha: f64) -> f64 {
    let (g, s) = (wide(chip.weights()), wide(&[*light.values()]).remove(0));
    let damping = alpha * g.iter().map(|row| sensor::dot(row, row)).sum::<f64>() / 8.0;
    let (mut rest, mut sizes) = (Vec::new(), Vec::new());
    for (row, count) in g.iter().zip(counts) {
        let count = f64::from(*count);
        rest.push(count - sensor::dot(row, &s));
        sizes.push(count.abs() + row.iter().zip(&s).map(|(g, s)| (g * s).abs()).sum::<f64>());
    }
    let (mut off, mut size) = (0.0f64, 0.0f64);
    for (column, s) in sensor::transposed(&g).iter().zip(&s) {
        off = off.max((damping * s - sensor::dot(column, &rest).max(0.0)).abs());
        size = size.max(column.iter().zip(&sizes).map(|(g, size)| g.abs() * size).sum());
    }
    if size > 0.0 { off / size } else { off }
}

#[test]
fn the_positive_spectrum_is_the_least_of_all_positive_ones() {
    let mut least = check("positive spectra");
    let (mut compared, mut most) = (0, None);
    let mut laser = Light::<31, Grid>::flat(0.0);
    let _ = laser.add_line(532.0, 1.0);
    let narrow =
        Light::<31, Grid>::from_bins(std::array::from_fn(|n| if n == 6 || n == 23 { 1.0 } else { 0.0 }));
    for light in LAMPS.iter().chain([&laser, &narrow]) {
        for alpha in [1e-1f32, 1e-2, 1e-3] {
            let counts = AS7341.sees(light);
            let got = nonnegative_spectrum(&AS7341, &BasicCounts::new(counts), alpha, 30).expect("a lamp");
            let expected = sensor::nonnegative(&wide(AS7341.weights()), &wide(&[counts])[0], alpha.into());
            let steps = (1..30)
                .find(|most| nonnegative_spectrum(&AS7341, &BasicCounts::new(counts), alpha, *most).is_ok());
            let allowed = if *light == laser { 11 } else { 5 };
            assert!(steps.is_some_and(|steps| steps <= allowed), "{steps:?}");
            most = most.max(steps);
            let size = expected.iter().fold(0.0f64, |size, v| size.max(*v));
            for (got, expected) in got.values().iter().zip(expected) {
                assert!(*got >= 0.0);
                least.value(&format!("{alpha}"), f64::from(*got) / size, expected / size);
                compared += 1;
            }
        }
    }
    least.tight(compared);
    assert_eq!(most, Some(11));
    // Where the linear one swings below zero.
    let counts = BasicCounts::new(AS7341.sees(&narrow));
    assert!(TO_SPECTRUM.spectrum(&counts).values().iter().any(|v| *v < -0.01));
}

#[test]
fn the_search_ends_for_random_chips_and_counts() {
    let mut minimum = check("conditions of a minimum");
    let mut noise = Noise(5);
    let (mut most, mut total) = (0, 0);
    for trial in 0..4000 {
        let kind = trial % 4;
        let mut rows = [[0.0f32; 31]; 8];
        for (c, row) in rows.iter_mut().enumerate() {
            for (n, weight) in row.iter_mut().enumerate() {
                *weight = match kind {
                    // Like a chip; anything positive; sparse; anything.
                    0 => AS7341.weights()[c][n] * (0.5 + noise.uniform() as f32),
                    1 => noise.uniform() as f32,
                    2 if noise.uniform() < 0.8 => 0.0,
                    _ => noise.normal() as f32,
                };
            }
        }
        let chip: Chip = Observer::from_weights(rows);
        let counts: [f32; 8] = std::array::from_fn(|_| match trial / 4 % 3 {
            0 => noise.uniform() as f32 * 1000.0,
            1 => noise.normal() as f32 * 1e-3,
            _ => {
                if noise.uniform() < 0.5 {
                    0.0
                } else {
                    noise.uniform() as f32
                }
            }
        });
        let alpha = [1e-1f32, 1e-2, 1e-3, 1e-4][trial / 12 % 4];
        let mut steps = 1;
        let light = loop {
            match nonnegative_spectrum(&chip, &BasicCounts::new(counts), alpha, steps) {
                Ok(light) => break light,
                Err(FitError::NotConverged { iterations }) => {
                    assert_eq!(iterations, steps);
                    steps += 1;
                    assert!(steps < 60, "trial {trial}");
                }
                Err(error) => panic!("trial {trial}: {error}"),
            }
        };
        most = most.max(steps);
        total += steps;
        assert!(light.values().iter().all(|v| *v >= 0.0));
        minimum.value(&format!("trial {trial}"), off_the_minimum(&chip, &counts, &light, alpha.into()), 0.0);
    }
    println!("{most} steps at most, {} in the mean", f64::from(total) / 4000.0);
    assert_eq!(most, 34);
    minimum.tight(4000);
}

#[test]
fn counts_that_no_light_makes_end_in_the_dark() {
    let dark = Light::flat(0.0);
    let of = |counts: [f32; 8]| nonnegative_spectrum(&AS7341, &BasicCounts::new(counts), DEFAULT_ALPHA, 30);
    assert_eq!(of([0.0; 8]), Ok(dark));
    assert_eq!(of([-3.0; 8]), Ok(dark));
    let mixed = of([-1.0, 5.0, 0.0, -2.0, 0.0, 0.0, 7.0, -0.5]).expect("some light");
    assert!(mixed.values().iter().all(|v| *v >= 0.0) && mixed.peak() > 0.0);
    for bad in [f32::NAN, f32::INFINITY] {
        assert_eq!(of([1.0, bad, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0]), Err(FitError::NotFinite));
        let counts = BasicCounts::new([1.0; 8]);
        assert_eq!(nonnegative_spectrum(&AS7341, &counts, bad, 30), Err(FitError::NotFinite));
    }
    let counts = BasicCounts::new([1.0; 8]);
    assert_eq!(nonnegative_spectrum(&AS7341, &counts, 0.0, 30), Err(FitError::NotFinite));
    assert_eq!(
        nonnegative_spectrum(&AS7341, &counts, DEFAULT_ALPHA, 0),
        Err(FitError::NotConverged { iterations: 0 })
    );
    let blind: Chip = Observer::from_weights([[0.0; 31]; 8]);
    assert!(nonnegative_spectrum(&blind, &counts, DEFAULT_ALPHA, 30).is_err());
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 300,
        ..ProptestConfig::default()
    })]

    #[test]
    fn any_chip_gives_finite_spectra_or_an_error(
        weights in prop::collection::vec(any::<f32>(), 12),
        counts in prop::array::uniform3(any::<f32>()),
        correlation in any::<f32>(),
        alpha in any::<f32>(),
    ) {
        let mut rows = [[0.0f32; 4]; 3];
        rows.iter_mut().flatten().zip(&weights).for_each(|(row, weight)| *row = *weight);
        let chip: Observer<3, 4, Power, Grid> = Observer::from_weights(rows);
        for correlation in [correlation, 0.5] {
            for alpha in [alpha, DEFAULT_ALPHA] {
                if let Ok(matrix) = Reconstruction::smooth(&chip, correlation, alpha) {
                    prop_assert!(matrix.rows().iter().flatten().all(|w| w.is_finite()));
                }
                if let Ok(light) = nonnegative_spectrum(&chip, &BasicCounts::new(counts), alpha, 50) {
                    prop_assert!(light.values().iter().all(|v| v.is_finite() && *v >= 0.0));
                }
            }
        }
    }
}
