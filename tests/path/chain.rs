//! Light on its way: what the chain gives, what it costs, and that folding it changes nothing.
#![cfg(feature = "libm")]

use model::allowed::check;
use model::delta_e::de2000;
use model::lab::lab;
use nanospectra::color::{AcesCg, Rgb, RgbBands, RgbSpace, Srgb, Xyz};
use nanospectra::light::{D65, FL1, FL2, FL3, FL4, FL5, FL6, FL7, FL8, FL9, FL10, FL11, FL12};
use nanospectra::matter::{CES, Donaldson, Dye, Mirror, Phosphor, Polarizer, Retarder};
use nanospectra::observer::CIE_1931;
use nanospectra::observer::Stimulus;
use nanospectra::path::{Effects, Plain, Price, Priced, Times, price_of};
use nanospectra::{
    Bins, Curve, Factor, Fine, FineObserver, Grid, Light, Observer, Power, Reflectance, Spectrum,
};
use proptest::prelude::*;

static EYE: Observer<3, 31, Power> = CIE_1931.fold(Curve::Spline);

#[test]
fn a_path_of_factors_is_their_product_to_the_bit() {
    let sun: Light<31> = FL11.resample();
    let glass = Reflectance::<31>::at_centers(|nm| nm / 800.0);
    let paper = Reflectance::<31>::at_centers(|nm| 1.0 - nm / 900.0);
    let path = sun.through(&glass).onto(&paper);
    assert_eq!(path.collected(), sun * glass * paper);
    assert_eq!(EYE.sees(path), EYE.sees(&(sun * glass * paper)));
    for k in 0..31 {
        assert_eq!(path.at(k), path.collected().values()[k]);
    }
    assert!(path.at(31).is_nan(), "there is no bin 31");
}

#[test]
fn a_path_of_factors_is_for_an_eye_with_the_light_folded_in() {
    static UNDER: Observer<3, 31> = CIE_1931.under(&FL11.fine()).fold(Curve::Spline);
    let glass = Reflectance::<31>::at_centers(|nm| nm / 800.0);
    let paper = Reflectance::<31>::at_centers(|nm| 1.0 - nm / 900.0);
    assert_eq!(UNDER.sees(glass.onto(&paper)), UNDER.sees(&(glass * paper)));
}

#[test]
fn a_bill_is_known_while_compiling() {
    type Scene<'a> = Plain<Power, Times<Times<&'a Light<31>, &'a Reflectance<31>>, &'a Reflectance<31>>>;
    const BILL: Price = Scene::PRICE;
    const { assert!(BILL.multiply_adds <= 62 && BILL.bytes <= 372) }
    let (sun, glass) = (Light::<31>::flat(1.0), Reflectance::flat(0.5));
    let path: Scene<'_> = sun.through(&glass).onto(&glass).within::<62>();
    assert_eq!(path.price(), BILL);
    assert_eq!(price_of(&path), BILL);
    assert_eq!(BILL.effects, Effects::NONE);
    assert_eq!(price_of(&sun), Price::light(31));
    assert_eq!(BILL, Price::light(31).plus(Price::factor(31)).plus(Price::factor(31)));

    let (lake, sheet) = (Mirror::<31>::dielectric(&[1.33; 31], 0.6, 0.0), Polarizer::<31>::ideal(0.0));
    let path = sun.polarized().onto(&lake).through(&glass).through(&sheet);
    assert_eq!(path.within::<{ 24 * 31 }>().price().effects, Effects::POLARIZATION);
    assert_eq!(path.price().bytes, 124 + 504 + 124 + 504);
    assert_eq!(path.ignoring_polarization().onto(&glass).price().multiply_adds, (4 + 4 + 16 + 1) * 31);

    let natural = sun.polarized();
    assert_eq!(natural.price(), Price { effects: Effects::POLARIZATION, ..Price::light(31) });
    assert_eq!((natural.stokes_at(30), natural.stokes_at(31)[0].is_nan()), ([1.0, 0.0, 0.0, 0.0], true));
    // A dye reads the light in front of it twice: first all of it, for its glow, and then each bin.
    let dye = Dye::new(&glass, &glass, &sun, 0.5).expect("possible");
    let dyed = natural.through(&sheet).through(&glass).onto(&dye);
    assert_eq!(dyed.price().multiply_adds, (2 * (4 + 4) + 3) * 31);
}

#[test]
fn a_matt_surface_forgets_how_light_was_polarized_and_glass_does_not() {
    let sun = Light::<31>::flat(1.0);
    let (gray, sheet, crossed) = (Reflectance::flat(0.5), Polarizer::ideal(0.0), Polarizer::ideal(0.25));
    let polarized = sun.polarized().through(&sheet);
    let dark = polarized.through(&gray).through(&crossed).ignoring_polarization();
    assert_eq!(EYE.sees(dark), [0.0; 3]);
    let light = polarized.onto(&gray).polarized().through(&crossed).ignoring_polarization();
    assert_eq!(light.collected(), sun * 0.125);
    // A dye glows as the intensity says, and its light is not polarized.
    let dye = Dye::new(&gray, &Reflectance::flat(0.0), &sun, 0.5).expect("possible");
    assert_eq!(polarized.onto(&dye).collected(), sun * 0.25);
}

/// What a path in RGB is off by: each of the 99 samples of CIE 224 as its color under D65, each lamp as its
/// color.
#[test]
fn rgb_is_this_far_from_the_spectrum() {
    fn errors<S: RgbSpace>() -> (f64, f64) {
        let eye = Observer::<3, 3, Power, RgbBands<S>>::standard();
        let daylight: FineObserver<3, Factor> = CIE_1931.under(&D65.fine()).with_white_y(100.0);
        let (mut sum, mut worst, mut count) = (0.0, 0.0f64, 0);
        for lamp in [&FL1, &FL2, &FL3, &FL4, &FL5, &FL6, &FL7, &FL8, &FL9, &FL10, &FL11, &FL12] {
            let lamp = lamp.fine();
            let under = CIE_1931.under(&lamp).with_white_y(100.0);
            let white = under.sees(&Fine::flat(1.0));
            let light = Light::<3, RgbBands<S>>::from_rgb(Rgb::from_xyz(Xyz::from(white)));
            let white = white.map(f64::from);
            for sample in &CES {
                let sample = sample.fine();
                let paint =
                    Reflectance::<3, RgbBands<S>>::from_rgb(Rgb::from_xyz(Xyz::from(daylight.sees(&sample))));
                let got = lab(eye.sees(light.onto(&paint)).map(f64::from), white);
                let exact = lab(under.sees(&sample).map(f64::from), white);
                let error = de2000(got, exact);
                sum += error;
                worst = worst.max(error);
                count += 1;
            }
        }
        (sum / f64::from(count), worst)
    }
    let ((srgb, srgb_worst), (ap1, ap1_worst)) = (errors::<Srgb>(), errors::<AcesCg>());
    for (what, got) in [
        ("sRGB paths in the mean, CIEDE2000", srgb),
        ("sRGB paths at worst, CIEDE2000", srgb_worst),
        ("ACEScg paths in the mean, CIEDE2000", ap1),
        ("ACEScg paths at worst, CIEDE2000", ap1_worst),
    ] {
        let mut check = check(what);
        check.value("99 samples under 12 lamps", got, 0.0);
        check.tight(1);
    }
}

#[test]
fn rgb_goes_through_the_same_paths() {
    static EYE: Observer<3, 3, Power, RgbBands<Srgb>> = Observer::standard();
    let lamp = Light::<3, RgbBands<Srgb>>::from_rgb(Rgb::new(1.0, 0.9, 0.8));
    let red = Reflectance::from_rgb(Rgb::new(0.5, 0.25, 0.125));
    let xyz = EYE.sees(lamp.through(&red).onto(&red));
    let expected = Rgb::<Srgb>::new(0.25, 0.9 * 0.0625, 0.8 * 0.015625);
    assert_eq!(lamp.onto(&red).onto(&red).collected().to_rgb(), expected);
    let expected = expected.xyz().to_array();
    assert!(xyz.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-5), "{xyz:?} {expected:?}");
    // And folds in the same way.
    assert_eq!(EYE.under(&lamp).through(&red).sees(&red), EYE.through(&red).under(&lamp).sees(&red));
    let [_, white, _] = EYE.sees(&Light::from_rgb(Rgb::new(1.0, 1.0, 1.0)));
    assert!((white - 100.0).abs() < 1e-5, "{white}");
}

#[test]
fn nan_in_is_nan_out_by_every_way() {
    let mut broken = Light::<31>::flat(1.0);
    broken.values_mut()[7] = f32::NAN;
    let gray = Reflectance::<31>::flat(0.5);
    let dye = Dye::new(&gray, &gray, &Light::flat(1.0), 0.5).expect("possible");
    let matrix: Donaldson<31, 496> = Donaldson::from_dye(&dye);
    let mut phosphor = Phosphor::new(dye, 1.0);
    let lake = Mirror::dielectric(&[1.33; 31], 0.5, 0.1);
    let nan = |xyz: [f32; 3]| assert!(xyz.iter().all(|v| v.is_nan()), "{xyz:?}");
    nan(EYE.sees(broken.through(&gray).onto(&gray)));
    nan(EYE.sees(broken.onto(&dye)));
    nan(EYE.sees(broken.onto(&matrix)));
    nan(EYE.sees(broken.polarized().onto(&lake).ignoring_polarization()));
    nan(EYE.sees(broken.polarized().onto(&lake).onto(&gray)));
    phosphor.step(&broken, 1.0);
    nan(EYE.sees(Light::flat(0.0).onto(&phosphor)));
    nan(EYE.looking_at_dye(&dye).sees(&broken));
    // Of matter, too.
    let mut hole = gray;
    hole.values_mut()[3] = f32::NAN;
    let sun = Light::<31>::flat(1.0);
    nan(EYE.sees(sun.onto(&hole)));
    nan(EYE.sees(sun.polarized().through(&Polarizer::new(&hole, &gray, 0.0)).ignoring_polarization()));
    nan(EYE.sees(sun.polarized().onto(&Mirror::dielectric(&[f32::NAN; 31], 0.5, 0.0)).onto(&gray)));
    let sheet = Polarizer::ideal(0.1);
    let polarized = sun.polarized().through(&sheet);
    nan(EYE
        .sees(polarized.through(&Retarder::flat(f32::NAN, 0.0)).through(&Polarizer::ideal(0.0)).onto(&gray)));
}

fn bins<Q, const N: usize, G: Grid>(range: std::ops::Range<f32>) -> impl Strategy<Value = Spectrum<Q, N, G>> {
    prop::collection::vec(range, N).prop_map(|values| {
        let mut spectrum = Spectrum::flat(0.0);
        spectrum.values_mut().copy_from_slice(&values);
        spectrum
    })
}

/// Walked, folded without the light, and folded with it.
fn folding_is_walking<const N: usize, G: Grid>(
    eye: &Observer<3, N, Power, G>,
    light: &Light<N, G>,
    glass: &Reflectance<N, G>,
    paper: &Reflectance<N, G>,
) -> Result<(), TestCaseError> {
    let walked = eye.sees(light.through(glass).onto(paper));
    let folded = eye.looking_at(paper).through(glass);
    let under = folded.under(light).sees(&Spectrum::flat(1.0));
    for ((walked, folded), under) in walked.into_iter().zip(folded.sees(light)).zip(under) {
        prop_assert!((walked - folded).abs() <= 4e-7 * walked.abs(), "{walked} {folded}");
        prop_assert!((walked - under).abs() <= 4e-7 * walked.abs(), "{walked} {under}");
    }
    Ok(())
}

/// From 1e-4 to 1e4, evenly in the logarithm, either sign or zero.
fn wide() -> impl Strategy<Value = f32> {
    prop_oneof![
        Just(0.0f32),
        (-4.0f32..4.0, any::<bool>())
            .prop_map(|(e, minus)| { if minus { -10f32.powf(e) } else { 10f32.powf(e) } })
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn folding_a_path_is_walking_it(
        light in bins::<Power, 16, Bins<380, 730>>(0.0..1.0), glass in bins(0.0..1.0), paper in bins(0.0..1.0),
        light_31 in bins::<Power, 31, Bins<380, 730>>(0.0..1.0), glass_31 in bins(0.0..1.0), paper_31 in bins(0.0..1.0),
    ) {
        let eye: Observer<3, 16, Power> = CIE_1931.fold(Curve::Step);
        folding_is_walking(&eye, &light, &glass, &paper)?;
        let eye: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);
        folding_is_walking(&eye, &light_31, &glass_31, &paper_31)?;
    }

    #[test]
    fn the_order_of_absorbers_changes_nothing(
        light in bins::<Power, 31, Bins<380, 730>>(0.0..1.0),
        a in bins::<Factor, 31, Bins<380, 730>>(0.0..1.0), b in bins(0.0..1.0), c in bins(0.0..1.0),
    ) {
        let eye: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);
        let first = eye.sees(light.through(&a).through(&b).through(&c));
        for other in [
            light.through(&a).through(&c).through(&b),
            light.through(&b).through(&a).through(&c),
            light.through(&b).through(&c).through(&a),
            light.through(&c).through(&a).through(&b),
            light.through(&c).through(&b).onto(&a),
        ] {
            for (one, other) in first.into_iter().zip(eye.sees(other)) {
                prop_assert!((one - other).abs() <= 4e-7 * one, "{one} {other}");
            }
        }
    }

    #[test]
    fn finite_light_and_matter_never_give_nan(
        light in prop::collection::vec(wide(), 31), factors in prop::collection::vec(wide(), 31),
        cos in -1.0f32..1.0, axis in wide(), retardance in wide(), time in 0.0f32..1e6, lifetime in 0.0f32..1e6,
    ) {
        let mut sun = Light::<31>::flat(0.0);
        sun.values_mut().copy_from_slice(&light);
        let mut gray = Reflectance::<31>::flat(0.0);
        gray.values_mut().copy_from_slice(&factors);
        let half = Reflectance::flat(0.4);
        let dye = Dye::new(&half, &half, &Light::flat(1.0), 0.5).expect("possible");
        let matrix: Donaldson<31, 496> = Donaldson::from_dye(&dye);
        let mut phosphor = Phosphor::new(dye, lifetime);
        phosphor.step(&sun, time);
        let mut eta = [0.0; 31];
        eta.iter_mut().zip(&factors).for_each(|(eta, f)| *eta = f.abs());
        let (lake, plate) = (Mirror::dielectric(&eta, cos, axis), Retarder::flat(retardance, axis));
        let seen = [
            EYE.sees(sun.through(&gray).onto(&gray)),
            EYE.sees(sun.onto(&gray).onto(&dye)),
            EYE.sees(sun.onto(&matrix).onto(&gray)),
            EYE.sees(sun.onto(&phosphor)),
            EYE.sees(sun.polarized().onto(&lake).through(&plate).onto(&lake).ignoring_polarization()),
            EYE.sees(sun.polarized().through(&Polarizer::ideal(axis)).through(&gray).onto(&dye)),
        ];
        prop_assert!(seen.iter().flatten().all(|v| v.is_finite()), "{seen:?}");
    }
}
