//! What is decided rather than rounded: what is refused, what lies outside, where a line on an edge goes,
//! that a constant stays that constant at every number of bands.

use nanospectra::color::Xyz;
use nanospectra::light::{self, FL11};
use nanospectra::observer::{CIE_1931, V_PHOTOPIC};
use nanospectra::{
    Bins, Curve, Factor, Fine, Grid, Interpolation, Light, Nodes, Observer, Outside, Power, Quantity,
    Reflectance, RefractiveIndex, SamplesError, Spectrum,
};

/// Calls a function for every number of bands from 1 to 120; in a debug build, where each takes its time to
/// compile, for those around the powers of two and the ones in use.
macro_rules! for_every_n {
    ($f:ident) => {
        #[cfg(debug_assertions)]
        for_every_n!(@ $f: 1 2 3 4 5 7 8 9 15 16 17 31 32 33 60 63 64 65 81 119 120);
        #[cfg(not(debug_assertions))]
        for_every_n!(@ $f: 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30
            31 32 33 34 35 36 37 38 39 40 41 42 43 44 45 46 47 48 49 50 51 52 53 54 55 56 57 58 59 60
            61 62 63 64 65 66 67 68 69 70 71 72 73 74 75 76 77 78 79 80 81 82 83 84 85 86 87 88 89 90
            91 92 93 94 95 96 97 98 99 100 101 102 103 104 105 106 107 108 109 110 111 112 113 114 115
            116 117 118 119 120)
    };
    (@ $f:ident: $($n:literal)*) => { $($f::<$n>();)* };
}

/// Values that f32 does not hold exactly, and extreme ones.
const CONSTANTS: [f32; 6] = [0.1, 1.0 / 3.0, 100.0, 1e-30, 7.3e29, -0.7];

/// Samples of a constant at irregular steps, one to many in a bin, from below to above the grid.
fn irregular(value: f32) -> Vec<(f32, f32)> {
    let mut nm = 371.3f32;
    let mut samples = Vec::new();
    while nm < 745.0 {
        samples.push((nm, value));
        nm += 0.37 + 11.0 * (nm * 0.7).sin().abs().powi(3);
    }
    samples
}

#[test]
fn the_average_of_a_constant_is_that_constant_at_every_number_of_bands() {
    fn bands<const N: usize>() {
        for value in CONSTANTS {
            let all = [value; N];
            let flat = Light::<N>::flat(value);
            assert_eq!(flat.values(), &all, "flat, N = {N}");
            let many = Light::<N>::from_samples(&irregular(value));
            assert_eq!(many.as_ref().map(Spectrum::values), Ok(&all), "samples, N = {N}");
            // Two samples in the middle, held to both sides.
            let held = Light::<N>::from_samples_outside(&[(501.7, value), (502.9, value)], Outside::Hold);
            assert_eq!(held.as_ref().map(Spectrum::values), Ok(&all), "held samples, N = {N}");
            let points = Light::<N>::interpolated(&irregular(value), Interpolation::Linear);
            assert_eq!(points.as_ref().map(Spectrum::values), Ok(&all), "points, N = {N}");
            for by in [Interpolation::Linear, Interpolation::Sprague] {
                let spread = flat.interpolate_outside::<120, Bins<300, 900>>(by, Outside::Hold);
                assert_eq!(spread.values(), &[value; 120], "interpolated, {by:?}, N = {N}");
            }
            assert_eq!(flat.resample::<31, Bins<400, 700>>().values(), &[value; 31], "from N = {N}");
            assert_eq!(
                flat.resample_outside::<90, Bins<300, 999>>(Outside::Hold).values(),
                &[value; 90],
                "from N = {N}"
            );
            let wide = Light::<37, Nodes<360, 830>>::flat(value);
            assert_eq!(wide.resample::<N, Bins<380, 730>>().values(), &all, "to N = {N}");
        }
    }
    for_every_n!(bands);
}

/// Values without a pattern, none of them round.
fn uneven<Q, const N: usize, G: Grid>() -> Spectrum<Q, N, G> {
    Spectrum::at_centers(|nm| (nm * 0.913).sin().abs() + 0.01)
}

#[test]
fn resampling_to_the_same_grid_gives_the_same_bits_at_every_number_of_bands() {
    fn bands<const N: usize>() {
        for outside in [Outside::Zero, Outside::Hold] {
            let bins = uneven::<Power, N, Bins<380, 730>>();
            assert_eq!(bins.resample_outside::<N, Bins<380, 730>>(outside), bins, "N = {N}");
            let bins = uneven::<Factor, N, Bins<317, 881>>();
            assert_eq!(bins.resample_outside::<N, Bins<317, 881>>(outside), bins, "N = {N}");
        }
    }
    for_every_n!(bands);
    let nodes = uneven::<Power, 81, Nodes<380, 780>>();
    assert_eq!(nodes.resample::<81, Nodes<380, 780>>(), nodes);
    for by in [Interpolation::Linear, Interpolation::Sprague] {
        assert_eq!(nodes.interpolate::<81, Nodes<380, 780>>(by), nodes, "{by:?}");
    }
}

#[test]
fn what_lies_outside_is_the_choice_of_the_quantity() {
    /// Every short form onto a wider grid, beside the long one.
    fn compare<Q: Quantity>(outside: Outside) {
        assert_eq!(Q::OUTSIDE, outside);
        type Wide = Bins<300, 900>;
        let spectrum = uneven::<Q, 71, Nodes<380, 730>>();
        let samples: Vec<(f32, f32)> = spectrum.iter().collect();
        let same = |short: &[f32], long: &[f32]| {
            let bits = |values: &[f32]| values.iter().map(|value| value.to_bits()).collect::<Vec<u32>>();
            assert_eq!(bits(short), bits(long));
            // Both ends lie far outside the data.
            let ends = [short.first(), short.last()];
            let expected = match outside {
                Outside::Zero => [Some(&0.0); 2],
                Outside::Hold => [spectrum.values().first(), spectrum.values().last()],
            };
            assert_eq!(ends, expected);
        };
        let fine = spectrum.interpolate_outside(Interpolation::Linear, outside);
        same(spectrum.fine().values(), Fine::<Q>::values(&fine));
        same(
            spectrum.resample::<60, Wide>().values(),
            spectrum.resample_outside::<60, Wide>(outside).values(),
        );
        let wide = |spectrum: Result<Spectrum<Q, 60, Wide>, SamplesError>| spectrum.expect("good samples");
        same(
            wide(Spectrum::from_samples(&samples)).values(),
            wide(Spectrum::from_samples_outside(&samples, outside)).values(),
        );
        for by in [Interpolation::Linear, Interpolation::Sprague] {
            same(
                spectrum.interpolate::<60, Wide>(by).values(),
                spectrum.interpolate_outside::<60, Wide>(by, outside).values(),
            );
            same(
                wide(Spectrum::interpolated(&samples, by)).values(),
                wide(Spectrum::interpolated_outside(&samples, by, outside)).values(),
            );
        }
    }
    compare::<Power>(Outside::Zero);
    compare::<Factor>(Outside::Hold);
    compare::<RefractiveIndex>(Outside::Hold);
    let named = light::named("FL11").expect("a CIE illuminant");
    assert_eq!(named, FL11.interpolate_outside(Interpolation::Linear, Outside::Zero));
    let smooth = light::interpolated("FL11", Interpolation::Sprague).expect("a CIE illuminant");
    assert_eq!(smooth, FL11.interpolate_outside(Interpolation::Sprague, Outside::Zero));
}

#[test]
fn a_white_surface_is_the_light_at_every_number_of_bands() {
    fn bands<const N: usize>() {
        let white = CIE_1931.row_sums();
        for curve in [Curve::Step, Curve::Parabola, Curve::Spline] {
            let eye: Observer<3, N, Power> = CIE_1931.fold(curve);
            for (got, exact) in eye.sees(&Light::flat(1.0)).into_iter().zip(white) {
                let error = (f64::from(got) / exact - 1.0).abs();
                assert!(error < 4e-7, "{curve:?}, N = {N}: {got} for {exact}");
            }
        }
    }
    for_every_n!(bands);
}

#[test]
fn one_two_and_three_bands_are_spectra_too() {
    let samples = [(380.0, 0.0), (730.0, 1.0)];
    let light = |outside| {
        (
            Light::<1>::from_samples_outside(&samples, outside),
            Light::<2>::from_samples_outside(&samples, outside),
            Light::<3>::from_samples_outside(&samples, outside),
        )
    };
    let (one, two, three) = light(Outside::Zero);
    let near = |got: &[f32], expected: &[f32]| got.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-6);
    assert!(one.is_ok_and(|s| near(s.values(), &[0.5]) && (s.power() - 175.0).abs() < 1e-4));
    assert!(two.is_ok_and(|s| near(s.values(), &[0.25, 0.75])));
    assert!(three.is_ok_and(|s| near(s.values(), &[1.0 / 6.0, 0.5, 5.0 / 6.0])));
    let mut lamp = Light::<1>::flat(0.0);
    assert_eq!((lamp.add_line(500.0, 7.0), lamp.power()), (0.0, 7.0));
    // A slope is seen as a slope from two bands on.
    let slope = |x: f32| [x, 1.0 - x];
    let eye: Observer<1, 2, Power> = V_PHOTOPIC.fold(Curve::Parabola);
    let [rising] = eye.sees(&Light::from_bins(slope(0.25)));
    let [falling] = eye.sees(&Light::from_bins(slope(0.75)));
    assert!(rising > falling, "V(lambda) lies a little to the red: {rising} {falling}");
}

#[test]
fn samples_that_are_no_spectrum_are_refused_and_never_sorted() {
    use SamplesError::*;
    let cases: [(&[(f32, f32)], SamplesError); 9] = [
        (&[], TooFew { needed: 2 }),
        (&[(500.0, 1.0)], TooFew { needed: 2 }),
        (&[(500.0, 1.0), (400.0, 1.0)], NotIncreasing { index: 1 }),
        (&[(400.0, 1.0), (500.0, 1.0), (500.0, 2.0)], NotIncreasing { index: 2 }),
        (&[(400.0, 1.0), (500.0, f32::NAN)], NotFinite { index: 1 }),
        (&[(f32::NAN, 1.0), (500.0, 1.0)], NotFinite { index: 0 }),
        (&[(400.0, 1.0), (f32::INFINITY, 1.0)], NotFinite { index: 1 }),
        (&[(400.0, f32::NEG_INFINITY), (500.0, 1.0)], NotFinite { index: 0 }),
        (&[(700.0, 1.0), (600.0, 1.0), (f32::NAN, 1.0)], NotIncreasing { index: 1 }),
    ];
    for (samples, error) in cases {
        assert_eq!(Light::<16>::from_samples(samples), Err(error), "{samples:?}");
        for by in [Interpolation::Linear, Interpolation::Sprague] {
            let fine = Fine::<Power>::interpolated(samples, by);
            assert_eq!(fine, Err(error), "{samples:?}, {by:?}");
        }
    }
    let sprague =
        |samples: &[(f32, f32)]| Fine::<Power>::interpolated(samples, Interpolation::Sprague).map(|_| ());
    let regular: Vec<(f32, f32)> = (0..7).map(|k| (400.0 + 50.0 * k as f32, 1.0)).collect();
    assert_eq!(sprague(&regular), Ok(()));
    assert_eq!(sprague(&regular[..5]), Err(TooFew { needed: 6 }));
    let mut uneven = regular;
    uneven[3].0 += 1.0;
    assert_eq!(sprague(&uneven), Err(NotRegular { index: 3 }));
    assert_eq!(
        NotIncreasing { index: 3 }.to_string(),
        "the wavelength of sample 3 is not above the one before it"
    );
}

#[test]
fn beyond_the_samples_lights_are_dark_and_surfaces_go_on() {
    let samples = [(500.0, 0.4), (600.0, 0.8)];
    for by in [Interpolation::Linear, Interpolation::Sprague] {
        let samples: Vec<(f32, f32)> =
            (0..=10).map(|k| (500.0 + 10.0 * k as f32, 0.4 + 0.04 * k as f32)).collect();
        let light = Fine::<Power>::interpolated(&samples, by).expect("good samples");
        let paint = Fine::<Factor>::interpolated(&samples, by).expect("good samples");
        let at = |nm: usize| (light.values()[nm - 360], paint.values()[nm - 360]);
        let end = samples[10].1;
        assert_eq!((at(360), at(499)), ((0.0, 0.4), (0.0, 0.4)), "{by:?}");
        assert_eq!((at(500), at(600)), ((0.4, 0.4), (end, end)), "the ends are inside, {by:?}");
        assert_eq!((at(601), at(830)), ((0.0, end), (0.0, end)), "{by:?}");
    }
    let light = Light::<35>::from_samples(&samples).expect("good samples");
    let paint = Reflectance::<35>::from_samples(&samples).expect("good samples");
    assert_eq!((light.values()[11], light.values()[22]), (0.0, 0.0));
    assert_eq!((paint.values()[11], paint.values()[22]), (0.4, 0.8));
    assert!((light.power() - 60.0).abs() < 1e-4);
    // The same rule from grid to grid, also for a grid that is altogether elsewhere.
    let infrared = light.resample::<4, Bins<800, 900>>();
    assert_eq!(infrared.values(), &[0.0; 4]);
    assert_eq!(paint.resample::<4, Bins<800, 900>>().values(), &[0.8; 4]);
    assert_eq!(paint.resample::<4, Bins<300, 340>>().values(), &[0.4; 4]);
}

#[test]
fn a_line_on_an_edge_goes_half_to_each_side_in_any_order() {
    // Bins of 10 nm; 500 nm is an edge.
    let line = |light: &mut Light<35>, nm| assert_eq!(light.add_line(nm, 0.3), 0.0);
    let mut one = Light::<35>::flat(0.0);
    line(&mut one, 500.0);
    assert_eq!(one.values()[11], one.values()[12]);
    assert_eq!(one.values()[11], 0.3 / 10.0 / 2.0);
    assert_eq!(one.power(), 0.3);
    let orders = [[500.0, 510.0, 505.0], [505.0, 510.0, 500.0], [510.0, 505.0, 500.0]];
    let lamps = orders.map(|order| {
        let mut lamp = Light::<35>::flat(0.0);
        for nm in order {
            line(&mut lamp, nm);
        }
        lamp
    });
    assert!(lamps.iter().all(|lamp| *lamp == lamps[0]), "{:?}", &lamps);
    // Mirrored about an edge: neither side is preferred.
    let (mut low, mut high) = (Light::<35>::flat(0.0), Light::<35>::flat(0.0));
    line(&mut low, 499.999);
    line(&mut high, 500.001);
    assert_eq!((low.values()[11], high.values()[12]), (0.3 / 10.0, 0.3 / 10.0));
}

#[test]
fn a_line_keeps_its_power_and_what_is_lost_is_reported() {
    fn bands<const N: usize>() {
        for step in 0..=700 {
            // Through the range and beyond it on both sides, edges among them.
            let nm = 370.0 + 0.528_571_43 * step as f32;
            let mut light = Light::<N>::flat(0.0);
            let lost = light.add_line(nm, 0.7);
            let whole = light.power() + lost;
            assert!((whole - 0.7).abs() <= 0.7 * f32::EPSILON, "N = {N}, {nm} nm: {whole}");
            assert_eq!(lost == 0.7, !(380.0..=730.0).contains(&nm), "N = {N}, {nm} nm: lost {lost}");
        }
        for end in [380.0, 730.0] {
            let mut light = Light::<N>::flat(0.0);
            assert_eq!(light.add_line(end, 0.5), 0.25, "half of a line on an outer edge, N = {N}");
            assert!((light.power() - 0.25).abs() <= 0.25 * f32::EPSILON);
        }
        for nm in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, -1.0, 0.0] {
            let mut light = Light::<N>::flat(0.0);
            assert_eq!((light.add_line(nm, 0.5), light), (0.5, Light::flat(0.0)), "{nm} nm");
        }
    }
    for_every_n!(bands);
}

#[test]
fn nan_in_is_nan_out_and_stays_where_it_is() {
    let mut light = uneven::<Power, 35, Bins<380, 730>>();
    light.values_mut()[12] = f32::NAN;
    assert!(light.power().is_nan());
    assert!(light.peak().is_nan(), "the peak of a spectrum with a NaN is {}", light.peak());
    let eye: Observer<3, 35, Power> = CIE_1931.fold(Curve::Spline);
    let seen = eye.sees(&light);
    assert!(seen.iter().all(|v| v.is_nan()));
    let mut batch = [[0.0; 3]; 2];
    eye.sees_each(&[light, uneven()], &mut batch);
    assert!(batch[0].iter().all(|v| v.is_nan()) && batch[1].iter().all(|v| v.is_finite()));
    let xyz = Xyz::from(seen);
    assert!(xyz.xy().is_some_and(|p| p.x.is_nan() && p.y.is_nan()));
    assert!(xyz.uv1960().is_some_and(|p| p.u.is_nan()) && xyz.uv1976().is_some_and(|p| p.v.is_nan()));
    // 500..510 nm is bad, and nothing else becomes so.
    let bad = |spectrum: &[f32]| spectrum.iter().filter(|v| v.is_nan()).count();
    assert_eq!(bad(light.resample::<35, Bins<380, 730>>().values()), 1);
    assert_eq!(bad(light.resample::<70, Bins<380, 730>>().values()), 2);
    assert_eq!(bad(light.resample::<7, Bins<380, 730>>().values()), 1);
    assert_eq!(bad(light.resample::<3, Bins<600, 700>>().values()), 0);
    // Straight lines: between the neighbors at 495 and 515 nm and no further.
    let points = light.interpolate_outside::<351, Nodes<380, 730>>(Interpolation::Linear, Outside::Hold);
    assert_eq!(bad(points.values()), 19);
    assert!((light + uneven()).values()[12].is_nan() && (light * 0.0).values()[12].is_nan());
}
