//! Calibration by patches: that the matrix is the one with the least squares, at any scale, and that what
//! cannot be fitted is refused.

use model::allowed::check;
use model::check::Check;
use model::noise::Noise;
use model::sensor::{self, wide};
use nanospectra::const_unwrap;
use nanospectra::light;
use nanospectra::matter::CES;
use nanospectra::observer::CIE_1931;
use nanospectra::sensor::{BasicCounts, Calibration, Fit, FitError, chip::as7341};
use proptest::prelude::*;

/// Counts, what they should come to, and the weight.
type Patch<const C: usize, const D: usize> = ([f32; C], [f32; D], f32);

/// Patches of the samples under these lamps.
fn patches(lamps: &[&str]) -> Vec<Patch<8, 3>> {
    let mut patches = Vec::new();
    for lamp in lamps {
        let lamp = light::named(lamp).expect("a lamp");
        for sample in &CES {
            let seen = lamp * sample.fine();
            let xyz = CIE_1931.sees(&seen);
            patches.push((as7341::NOMINAL.sees(&seen), xyz, 1.0 / xyz[1]));
        }
    }
    patches
}

fn fitted<const C: usize, const D: usize>(patches: &[Patch<C, D>]) -> Fit<C, D> {
    let mut fit = Fit::new();
    patches.iter().for_each(|(counts, target, weight)| fit.add(&BasicCounts::new(*counts), *target, *weight));
    fit
}

/// The same in f64.
fn model_fit<const C: usize, const D: usize>(patches: &[Patch<C, D>]) -> Vec<Vec<f64>> {
    let counts: Vec<_> = patches.iter().map(|(counts, ..)| wide(&[*counts]).remove(0)).collect();
    let targets: Vec<_> = patches.iter().map(|(_, target, _)| wide(&[*target]).remove(0)).collect();
    let weights: Vec<_> = patches.iter().map(|(.., weight)| f64::from(*weight)).collect();
    sensor::fit(&counts, &targets, &weights)
}

/// Coefficients relative to the largest of their row.
fn compare(check: &mut Check, rows: &[[f32; 8]; 3], expected: &[Vec<f64>]) {
    for (d, (row, expected)) in rows.iter().zip(expected).enumerate() {
        let size = expected.iter().fold(0.0f64, |size, v| size.max(v.abs()));
        for (c, (got, expected)) in row.iter().zip(expected).enumerate() {
            check.value(&format!("row {d}, channel {c}"), f64::from(*got) / size, expected / size);
        }
    }
}

#[test]
fn the_matrix_of_297_patches_is_the_one_of_f64() {
    let patches = patches(&["FL2", "FL11", "LED-B3"]);
    let fit = fitted(&patches);
    assert_eq!(fit.patches(), 297);
    let matrix = fit.solve().expect("different colors");
    let mut coefficients = check("matrix of a fit");
    compare(&mut coefficients, matrix.rows(), &model_fit(&patches));
    coefficients.tight(24);
    // Its errors on the patches, of the size that the samples' metamerism makes.
    let mut rms = [0.0f64; 3];
    for (counts, xyz, weight) in &patches {
        for ((rms, got), expected) in rms.iter_mut().zip(matrix.apply(&BasicCounts::new(*counts))).zip(xyz) {
            *rms += f64::from((got - expected) * weight).powi(2) / 297.0;
        }
    }
    let mut residuals = check("residual of a fit");
    for (d, (got, expected)) in fit.residual_rms().into_iter().zip(rms).enumerate() {
        residuals.value(&format!("result {d}"), got.into(), expected.sqrt());
    }
    residuals.tight(3);
}

#[test]
fn counts_of_1e_minus_30_and_of_1e30_calibrate_as_well() {
    let patches = patches(&["FL2", "FL11"]);
    let mut coefficients = check("matrix at any scale");
    for (counts_scale, xyz_scale) in [(1e-30f32, 1.0f32), (1e-30, 1e-30), (1.0, 1e-30), (1e28, 1e28)] {
        let scaled: Vec<_> = patches
            .iter()
            .map(|(counts, xyz, weight)| {
                let counts = counts.map(|c| c * counts_scale);
                (counts, xyz.map(|v| v * xyz_scale), weight / xyz_scale)
            })
            .collect();
        let fit = fitted(&scaled);
        let matrix = fit.solve().unwrap_or_else(|error| panic!("{counts_scale} {xyz_scale}: {error}"));
        compare(&mut coefficients, matrix.rows(), &model_fit(&scaled));
        let (counts, xyz, weight) = scaled[7];
        let basic = BasicCounts::new(counts);
        let errors = fit.leave_one_out(&basic, xyz, weight).expect("198 patches");
        let [_, unscaled, _] = fitted(&patches)
            .leave_one_out(&BasicCounts::new(patches[7].0), patches[7].1, patches[7].2)
            .expect("198 patches");
        assert!((errors[1] / xyz_scale / unscaled - 1.0).abs() < 1e-2, "{errors:?} {unscaled}");
    }
    coefficients.tight(96);
}

#[test]
fn the_error_without_a_patch_is_that_of_a_fit_without_it() {
    let patches = patches(&["FL2"]);
    let fit = fitted(&patches);
    let mut check = check("leave one out");
    for (k, (counts, xyz, weight)) in patches.iter().enumerate() {
        let mut others = patches.clone();
        others.remove(k);
        let refitted = model_fit(&others);
        let expected = refitted.iter().map(|row| sensor::dot(row, &wide(&[*counts])[0]));
        let errors = fit.leave_one_out(&BasicCounts::new(*counts), *xyz, *weight).expect("99 patches");
        for ((got, expected), target) in errors.into_iter().zip(expected).zip(xyz) {
            // In units of the patch's brightness.
            let per_y = f64::from(*weight);
            check.value(
                &format!("sample {k}"),
                f64::from(got) * per_y,
                (expected - f64::from(*target)) * per_y,
            );
        }
    }
    check.tight(297);
}

/// A matrix without a pattern, and patches that it fits exactly.
fn exact(patches: usize, seed: u64) -> (Vec<Patch<8, 3>>, [[f32; 8]; 3]) {
    let mut noise = Noise(seed);
    let rows: [[f32; 8]; 3] =
        std::array::from_fn(|_| std::array::from_fn(|_| (noise.uniform() * 64.0).floor() as f32 - 20.0));
    let mut draw = || {
        let counts: [f32; 8] = std::array::from_fn(|_| (noise.uniform() * 256.0).floor() as f32);
        let target = rows.map(|row| row.iter().zip(counts).map(|(w, c)| w * c).sum());
        (counts, target, 1.0 + (noise.uniform() * 4.0).floor() as f32)
    };
    ((0..patches).map(|_| draw()).collect(), rows)
}

#[test]
fn a_linear_sensor_is_recovered() {
    let mut check = check("a linear sensor recovered");
    for patches in [8, 9, 24, 300] {
        let (patches, rows) = exact(patches, 7);
        let fit = fitted(&patches);
        let matrix = fit.solve().expect("different patches");
        for (got, expected) in matrix.rows().iter().flatten().zip(rows.iter().flatten()) {
            check.value(&format!("{} patches", patches.len()), (*got).into(), (*expected).into());
        }
        assert!(fit.residual_rms().iter().all(|rms| *rms < 0.1), "{:?}", fit.residual_rms());
    }
    check.tight_over_all();
}

#[test]
fn a_patch_that_alone_tells_something_cannot_be_left_out() {
    let (patches, _) = exact(8, 3);
    let fit = fitted(&patches);
    let (counts, target, weight) = patches[0];
    assert_eq!(
        fit.leave_one_out(&BasicCounts::new(counts), target, weight),
        Err(FitError::TooFew { patches: 7, needed: 8 })
    );
    // Twenty patches, but one channel counts in one of them only.
    let (mut patches, _) = exact(20, 3);
    patches[1..].iter_mut().for_each(|patch| patch.0[5] = 0.0);
    let fit = fitted(&patches);
    assert!(fit.solve().is_ok());
    let (counts, target, weight) = patches[0];
    let refused = fit.leave_one_out(&BasicCounts::new(counts), target, weight);
    assert!(matches!(refused, Err(FitError::IllConditioned { .. })), "{refused:?}");
    // Another one can.
    let (counts, target, weight) = patches[1];
    assert!(fit.leave_one_out(&BasicCounts::new(counts), target, weight).is_ok());
}

/// The nearer the other patches are to one color, the more of its result a third one decides. What is left of
/// the error is then of the size of rounding, and must not be taken for it.
#[test]
fn an_error_without_a_patch_is_right_or_refused() {
    let (mut told, mut refused) = (0, 0);
    for k in 1..=12 {
        // Of the first two, 1 and 3 are the exact coefficients, which make 4 of the third patch.
        let step = 0.5f32.powi(k);
        let patches =
            [([1.0, 0.0], [1.0], 1.0), ([1.0, step], [1.0 + 3.0 * step], 1.0), ([1.0; 2], [2.0], 1.0)];
        match fitted(&patches).leave_one_out(&BasicCounts::new([1.0; 2]), [2.0], 1.0) {
            Ok([error]) => {
                println!("{step}: {error} instead of 2");
                assert!((error - 2.0).abs() < 0.02, "{step}: {error} instead of 2");
                told += 1;
            }
            Err(FitError::IllConditioned { condition }) => {
                assert!(condition > 8e4, "{step}: {condition}");
                refused += 1;
            }
            Err(error) => panic!("{step}: {error}"),
        }
    }
    assert!(told >= 6 && refused >= 4, "{told} {refused}");
}

#[test]
fn too_few_patches_are_too_few_however_often_repeated() {
    assert_eq!(Fit::<8>::new().solve(), Err(FitError::TooFew { patches: 0, needed: 8 }));
    assert_eq!(Fit::<8>::default().residual_rms(), [0.0; 3]);
    let (patches, _) = exact(7, 1);
    assert_eq!(fitted(&patches).solve(), Err(FitError::TooFew { patches: 7, needed: 8 }));
    let repeated: Vec<_> = patches.iter().cycle().take(50).copied().collect();
    let refused = fitted(&repeated).solve();
    assert!(matches!(refused, Err(FitError::IllConditioned { .. })), "{refused:?}");
    // A patch twice is a patch of weight root of 2.
    let (mut twice, _) = exact(20, 2);
    twice.iter_mut().for_each(|patch| patch.1[0] += 5.0 * patch.0[0] / (1.0 + patch.0[1]));
    let mut heavier = twice.clone();
    twice.push(twice[4]);
    heavier[4].2 *= 2f32.sqrt();
    let (twice, heavier) = (fitted(&twice).solve().expect("20"), fitted(&heavier).solve().expect("20"));
    for (a, b) in twice.rows().iter().flatten().zip(heavier.rows().iter().flatten()) {
        assert!((a - b).abs() < 1e-3, "{a} {b}");
    }
}

#[test]
fn patches_without_weight_are_not_there() {
    let (patches, _) = exact(20, 5);
    let mut fit = fitted(&patches);
    let before = fit;
    fit.add(&BasicCounts::new([f32::NAN; 8]), [f32::INFINITY; 3], 0.0);
    assert_eq!(fit, before);
    // Black patches say nothing and hurt nothing.
    fit.add(&BasicCounts::new([0.0; 8]), [0.0; 3], 1.0);
    assert_eq!((fit.patches(), fit.solve()), (21, before.solve()));
    // No light has no relative error.
    let mut none = Fit::<8>::new();
    none.add_relative(&BasicCounts::new([1.0; 8]), [1.0, 0.0, 1.0].into());
    none.add_relative(&BasicCounts::new([1.0; 8]), [1.0, -1.0, 1.0].into());
    assert_eq!(none, Fit::new());
    let mut weighted = Fit::<8>::new();
    weighted.add(&BasicCounts::new([2.0; 8]), [1.0, 4.0, 3.0], 0.25);
    none.add_relative(&BasicCounts::new([2.0; 8]), [1.0, 4.0, 3.0].into());
    assert_eq!(none, weighted);
}

#[test]
fn a_channel_that_never_counts_is_refused() {
    let (mut patches, _) = exact(20, 11);
    patches.iter_mut().for_each(|patch| patch.0[3] = 0.0);
    assert_eq!(fitted(&patches).solve(), Err(FitError::IllConditioned { condition: f32::INFINITY }));
    let error = FitError::IllConditioned { condition: f32::INFINITY };
    assert!(error.to_string().contains("leave out a channel"), "{error}");
}

#[test]
fn one_channel_is_a_factor() {
    let mut fit = Fit::<1, 1>::new();
    assert_eq!(fit.solve(), Err(FitError::TooFew { patches: 0, needed: 1 }));
    fit.add(&BasicCounts::new([4.0]), [2.0], 1.0);
    assert_eq!(fit.solve(), Ok(Calibration::from_rows([[0.5]])));
    assert_eq!(
        fit.leave_one_out(&BasicCounts::new([4.0]), [2.0], 1.0),
        Err(FitError::TooFew { patches: 0, needed: 1 })
    );
    fit.add(&BasicCounts::new([2.0]), [2.0], 1.0);
    // (4 * 2 + 2 * 2) / (16 + 4)
    let matrix = fit.solve().expect("two patches");
    assert!((matrix.rows()[0][0] - 0.6).abs() < 1e-6, "{matrix:?}");
    // Without the second it is 0.5, and 1 for 2.
    let [error] = fit.leave_one_out(&BasicCounts::new([2.0]), [2.0], 1.0).expect("two patches");
    assert!((error + 1.0).abs() < 1e-6, "{error}");
}

#[test]
fn what_is_not_finite_is_refused() {
    let (patches, _) = exact(20, 13);
    for (at, bad) in [f32::NAN, f32::INFINITY, -f32::INFINITY, 3e38].into_iter().enumerate() {
        let mut counts = patches.clone();
        counts[at].0[at] = bad;
        let mut targets = patches.clone();
        targets[at].1[at % 3] = bad;
        let mut weights = patches.clone();
        weights[at].2 = bad;
        for patches in [counts, targets, weights] {
            let outcome = fitted(&patches).solve();
            let fine = |matrix: Calibration<8>| matrix.rows().iter().flatten().all(|w| w.is_finite());
            match outcome {
                Ok(matrix) => assert!(bad == 3e38 && fine(matrix), "{bad}"),
                Err(error) => assert!(bad == 3e38 || error == FitError::NotFinite, "{bad}: {error}"),
            }
        }
    }
}

#[test]
fn channels_that_are_nearly_one_are_refused_by_their_condition() {
    let mut checked = check("condition of a fit");
    let mut compared = 0;
    for power in 4..=23 {
        // Two channels that differ by 2^-power of 1, in two of three patches: exact in f32.
        let apart = 2f32.powi(-power);
        let rows = [[1.0, 1.0 + apart], [1.0, 1.0], [1.0, 1.0 - apart]];
        let exact = sensor::condition(&sensor::equal_columns(&wide(&rows)));
        let mut fit = Fit::<2, 1>::new();
        rows.iter().for_each(|row| fit.add(&BasicCounts::new(*row), [1.0], 1.0));
        match fit.solve() {
            Ok(_) => assert!(exact < 0.9e5, "{exact} was accepted"),
            Err(FitError::IllConditioned { condition }) => {
                assert!(exact > 0.7e5, "{exact} was refused");
                // Beyond 1e6 rounding decides.
                if exact < 5e5 {
                    checked.value(&format!("{exact}"), condition.into(), exact);
                    compared += 1;
                }
            }
            Err(error) => panic!("{error}"),
        }
    }
    for seed in 0..20 {
        // The eighth channel is the sum of the others, but for one count here and there.
        let mut noise = Noise(seed);
        let rows: Vec<[f32; 8]> = (0..30)
            .map(|_| {
                let mut row: [f32; 8] = std::array::from_fn(|_| (noise.uniform() * 16384.0).floor() as f32);
                row[7] = row[..7].iter().sum::<f32>() + (noise.uniform() * 2.0).floor() as f32;
                row
            })
            .collect();
        let wide: Vec<_> = rows.iter().map(|row| wide(&[*row]).remove(0)).collect();
        let exact = sensor::condition(&sensor::equal_columns(&wide));
        let mut fit = Fit::<8, 1>::new();
        rows.iter().for_each(|row| fit.add(&BasicCounts::new(*row), [row[0]], 1.0));
        let Err(FitError::IllConditioned { condition }) = fit.solve() else { panic!("{exact} was accepted") };
        checked.value(&format!("8 channels, {exact}"), condition.into(), exact);
        compared += 1;
    }
    checked.tight(compared);
}

/// Fitted while compiling: three patches, two channels.
static FITTED: Calibration<2, 1> = {
    let mut fit = Fit::new();
    fit.add(&BasicCounts::new([1.0, 0.0]), [3.0], 1.0);
    fit.add(&BasicCounts::new([0.0, 1.0]), [2.0], 1.0);
    fit.add(&BasicCounts::new([1.0, 1.0]), [5.0], 1.0);
    const_unwrap!(fit.solve())
};

#[test]
fn a_calibration_can_be_fitted_while_compiling() {
    let [lux] = FITTED.apply(&BasicCounts::new([10.0, 20.0]));
    assert!((lux - 70.0).abs() < 1e-4, "{lux}");
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 500,
        ..ProptestConfig::default()
    })]

    #[test]
    fn any_patches_give_a_finite_matrix_or_an_error(
        patches in prop::collection::vec((prop::array::uniform4(any::<f32>()), prop::array::uniform2(any::<f32>()), any::<f32>()), 0..12),
    ) {
        let fit = fitted(&patches);
        if let Ok(matrix) = fit.solve() {
            prop_assert!(matrix.rows().iter().flatten().all(|w| w.is_finite()));
        }
        for (counts, target, weight) in &patches {
            if let Ok(errors) = fit.leave_one_out(&BasicCounts::new(*counts), *target, *weight) {
                prop_assert!(errors.iter().all(|e| e.is_finite()));
            }
        }
        let _ = fit.residual_rms();
    }

    #[test]
    fn no_other_matrix_has_smaller_squares(
        patches in prop::collection::vec((prop::array::uniform3(0.0f32..1.0), prop::array::uniform1(0.0f32..1.0), 0.1f32..2.0), 4..40),
        nudge in prop::array::uniform3(-0.1f32..0.1),
    ) {
        let Ok(matrix) = fitted(&patches).solve() else { return Ok(()) };
        let squares = |row: [f32; 3]| -> f64 {
            patches
                .iter()
                .map(|(counts, target, weight)| {
                    let error = sensor::dot(&wide(&[row])[0], &wide(&[*counts])[0]) - f64::from(target[0]);
                    (error * f64::from(*weight)).powi(2)
                })
                .sum()
        };
        let [row] = *matrix.rows();
        let other: [f32; 3] = std::array::from_fn(|c| row[c] + nudge[c]);
        let size = row.iter().fold(1.0f64, |size, w| size.max(f64::from(w.abs())));
        prop_assert!(squares(row) <= squares(other) + 1e-6 * size * size);
    }
}
