//! Mini-spectrometers: pixels to wavelengths to bins, no count lost.

use model::allowed::check;
use model::noise::Noise;
use model::sensor::{self, wide};
use nanospectra::observer::CIE_1931;
use nanospectra::sensor::{FirstPixel, PixelWavelengths, PixelWavelengthsError, above_dark_pixels};
use nanospectra::{Bins, Curve, Grid, Nodes, Observer, PerBin, Power, Spectrum, const_unwrap};
use proptest::prelude::*;

/// The coefficients of a C12880MA, as its sheet prints them.
const SHEET: [f32; 6] = [3.102_449e2, 2.683_674, -1.121_367e-3, -6.962_632e-6, 8.478_353e-9, 5.208_724e-12];

static UNIT: PixelWavelengths<288> = const_unwrap!(PixelWavelengths::new(SHEET, FirstPixel::One));

/// The polynomial in f64, as its powers.
fn nm(coefficients: &[f32], pixel: f64) -> f64 {
    coefficients.iter().enumerate().map(|(k, c)| f64::from(*c) * pixel.powi(k as i32)).sum()
}

fn unit_edges() -> Vec<f64> {
    (0..=288).map(|k| nm(&SHEET, f64::from(k) + 0.5)).collect()
}

fn edges<const N: usize, G: Grid>() -> Vec<f64> {
    (0..=N).map(|k| f64::from(Spectrum::<PerBin, N, G>::edge_nm(k))).collect()
}

#[test]
fn pixels_lie_where_the_polynomial_says() {
    let mut pixels = check("wavelengths of pixels, nm");
    for pixel in 0..288 {
        pixels.value(&format!("{pixel}"), UNIT.nm(pixel).into(), nm(&SHEET, pixel as f64 + 1.0));
        pixels.value(&format!("{pixel}, edge"), UNIT.edge_nm(pixel).into(), nm(&SHEET, pixel as f64 + 0.5));
    }
    pixels.tight(576);
    let from_zero = PixelWavelengths::<288>::new(SHEET, FirstPixel::Zero).expect("it rises");
    assert_eq!(from_zero.nm(1), UNIT.nm(0));
    assert_eq!(from_zero.nm(0), SHEET[0]);
}

#[test]
fn mistyped_coefficients_are_refused() {
    let of = |coefficients| PixelWavelengths::<288>::new(coefficients, FirstPixel::One);
    let with = |k: usize, c: f32| {
        let mut mistyped = SHEET;
        mistyped[k] = c;
        mistyped
    };
    // A lost exponent, a lost sign, the order reversed, nonsense.
    assert!(
        matches!(of(with(2, -1.121_367e-2)), Err(PixelWavelengthsError { pixel }) if (100..130).contains(&pixel))
    );
    assert_eq!(of(with(1, -2.683_674)), Err(PixelWavelengthsError { pixel: 0 }));
    let mut reversed = SHEET;
    reversed.reverse();
    assert!(of(with(1, 0.0)).is_err() && of(with(3, f32::NAN)).is_err() && of(with(5, 1e38)).is_err());
    assert!(PixelWavelengths::<288, 1>::new([500.0], FirstPixel::Zero).is_err());
    assert!(PixelWavelengths::<288, 0>::new([], FirstPixel::Zero).is_err());
    let error = of(with(1, -2.683_674)).expect_err("it falls").to_string();
    assert!(error.contains("pixel 0") && error.contains("check the coefficients"), "{error}");
}

/// Counts of a lamp on a pedestal.
fn frame() -> [f32; 288] {
    let mut noise = Noise(12);
    std::array::from_fn(|_| 100.0 + 4000.0 * noise.uniform().powi(4) as f32)
}

fn compare<const N: usize, G: Grid>(check: &mut model::check::Check, place: &str) -> usize {
    let counts = frame();
    let rebinned = UNIT.rebinned::<N, G>(&counts);
    let values = wide(&[counts]).remove(0);
    let expected = sensor::rebinned(&unit_edges(), &values, &edges::<N, G>());
    let total: f64 = values.iter().sum();
    let size = expected.iter().fold(0.0f64, |size, v| size.max(*v));
    for (got, expected) in rebinned.counts.values().iter().zip(&expected) {
        check.value(place, f64::from(*got) / size, expected / size);
    }
    let got =
        rebinned.counts.values().iter().map(|v| f64::from(*v)).sum::<f64>() + f64::from(rebinned.outside);
    assert!((got / total - 1.0).abs() < 5e-7, "{place}: {got} of {total}");
    let outside = total - expected.iter().sum::<f64>();
    assert!((f64::from(rebinned.outside) - outside).abs() < 2e-6 * total, "{place}: {}", rebinned.outside);
    N
}

#[test]
fn bins_get_what_overlaps_them_and_no_count_is_lost() {
    // Bins narrower and wider than pixels, inside the chip's range, beyond it, and a single one.
    let mut bins = check("rebinned pixels");
    let compared = compare::<31, Nodes<400, 700>>(&mut bins, "10 nm")
        + compare::<81, Nodes<380, 780>>(&mut bins, "5 nm")
        + compare::<471, Nodes<360, 830>>(&mut bins, "1 nm")
        + compare::<701, Nodes<300, 1000>>(&mut bins, "beyond the chip")
        + compare::<1, Bins<400, 700>>(&mut bins, "one bin")
        + compare::<4, Bins<500, 501>>(&mut bins, "inside one pixel");
    bins.tight(compared);
    // All of it outside.
    let far = UNIT.rebinned::<3, Bins<1000, 1300>>(&[1.0; 288]);
    assert_eq!((far.counts.values(), far.outside), (&[0.0; 3], 288.0));
}

#[test]
fn equal_light_gives_equal_densities_although_pixels_are_not_equal() {
    // The trap: a flat light fills wide pixels more. Counts per pixel as they come from 1 count per nm.
    let counts: [f32; 288] = std::array::from_fn(|k| UNIT.edge_nm(k + 1) - UNIT.edge_nm(k));
    let blue_over_red = counts[40] / counts[200];
    assert!(blue_over_red > 1.15, "{blue_over_red}");
    let light = UNIT.rebinned::<31, Nodes<400, 700>>(&counts).counts.density();
    for (nm, value) in light.iter() {
        assert!((value - 1.0).abs() < 1e-4, "{nm}: {value}");
    }
    // And so to an eye.
    let eye: Observer<3, 31, Power, Nodes<400, 700>> = CIE_1931.fold(Curve::Step);
    let [x, y, z] = eye.sees(&light);
    assert!((x / (x + y + z) - 1.0 / 3.0).abs() < 2e-3, "{x} {y} {z}");
}

#[test]
fn masked_pixels_tell_the_dark() {
    let mut counts = [1000u16; 288];
    counts[..8].copy_from_slice(&[60, 61, 62, 63, 64, 65, 66, 67]);
    let above = above_dark_pixels(&counts, 0..8).expect("eight pixels");
    assert_eq!((above[100], above[0]), (936.5, -3.5));
    for nonsense in [0..0, 8..8, 280..289, usize::MAX - 1..usize::MAX] {
        assert_eq!(above_dark_pixels(&counts, nonsense), None);
    }
    #[expect(clippy::reversed_empty_ranges, reason = "what a caller may get wrong")]
    let reversed = 9..3;
    assert_eq!(above_dark_pixels(&counts, reversed), None);
    // 24 bits and more.
    let wide = above_dark_pixels(&[0xffff_fff0u32; 4], 0..2).expect("two pixels");
    assert_eq!(wide, [0.0; 4]);
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 300,
        ..ProptestConfig::default()
    })]

    #[test]
    fn any_polynomial_is_refused_or_keeps_the_counts(
        constant in 200.0f32..500.0,
        slope in -0.5f32..20.0,
        bend in -0.1f32..0.1,
        counts in prop::array::uniform32(0.0f32..1e6),
    ) {
        if let Ok(unit) = PixelWavelengths::<32, 3>::new([constant, slope, bend], FirstPixel::One) {
            let rebinned = unit.rebinned::<16, Bins<380, 730>>(&counts);
            let total: f64 = counts.iter().map(|c| f64::from(*c)).sum();
            let got = f64::from(rebinned.counts.total()) + f64::from(rebinned.outside);
            prop_assert!((got - total).abs() <= 1e-6 * total);
            prop_assert!(rebinned.counts.values().iter().all(|v| *v >= 0.0));
        }
    }

    #[test]
    fn any_numbers_at_all_end_without_a_panic(
        coefficients in prop::array::uniform4(any::<f32>()),
        counts in prop::array::uniform8(any::<f32>()),
    ) {
        if let Ok(unit) = PixelWavelengths::<8, 4>::new(coefficients, FirstPixel::Zero) {
            let _ = unit.rebinned::<16, Bins<380, 730>>(&counts);
        }
    }
}
