//! One source for red, green and blue and for spectra: the pixels of code written by hand, in both.
#![cfg(feature = "libm")]

use model::allowed::check;
use nanospectra::color::{AcesCg, DisplayP3, EncodedRgb, Rgb, RgbBands, RgbSpace, Srgb, Xyz};
use nanospectra::geometry::{Direction, GaussLegendre};
use nanospectra::matter::scattering::{rho_hd, scattered};
use nanospectra::matter::{Brdf, Lambert, Microfacet, OrenNayar, Smooth, Specular, TrowbridgeReitz};
use nanospectra::observer::StandardObserver;
use nanospectra::radiometry::{Intensity, Irradiance, Radiance};
use nanospectra::sensor::fixed::FixedObserver;
use nanospectra::upsample::{FromRgb, kubelka_munk};
use nanospectra::{Bands, Bins, Light, Nodes, Observer, Power, Reflectance};
use proptest::prelude::*;

/// What a pixel is made of.
struct Scene<const N: usize, G: Bands> {
    lamp: Intensity<Light<N, G>>,
    wall: OrenNayar<Reflectance<N, G>>,
    varnish: Microfacet<Reflectance<N, G>>,
    sky: Light<N, G>,
    filter: Reflectance<N, G>,
    eye: Observer<3, N, Power, G>,
}

const DISTANCE_M: f32 = 2.5;

/// A wall under a lamp and a sky, through a filter: BRDFs, radiometry, a path, an observer.
fn shade<const N: usize, G: Bands>(scene: &Scene<N, G>, wo: Direction, wi: Direction) -> [f32; 3] {
    let arriving: Irradiance<Light<N, G>> = scene.lamp.at_distance(DISTANCE_M, wi.cos_theta());
    let f = scene.wall.f(wo, wi) + scene.varnish.f(wo, wi);
    let from_lamp = Radiance::new(arriving.value() * f);
    let from_sky = Radiance::new(scene.sky).exitance() * rho_hd(&scene.wall, wo, &GaussLegendre::<2, 2>);
    let leaving = from_lamp + from_sky.lambertian();
    scene.eye.sees(leaving.value().through(&scene.filter).onto(&scene.filter))
}

/// The same by hand, from the numbers of each band.
fn by_hand<const N: usize>(
    [lamp, wall, varnish, sky, filter]: &[[f32; N]; 5],
    wo: Direction,
    wi: Direction,
) -> [f32; N] {
    use core::f32::consts::{FRAC_1_PI, PI};
    let facets = TrowbridgeReitz::new(0.3);
    core::array::from_fn(|k| {
        let arriving = lamp[k] * wi.cos_theta() / DISTANCE_M / DISTANCE_M;
        let rough = OrenNayar::new(wall[k], 0.5);
        let f = rough.f(wo, wi) + Microfacet { facets, boundary: varnish[k] }.f(wo, wi);
        let diffuse = sky[k] * PI * rho_hd(&rough, wo, &GaussLegendre::<2, 2>) * FRAC_1_PI;
        (arriving * f + diffuse) * filter[k] * filter[k]
    })
}

fn scene<const N: usize, G: Bands>(
    [lamp, wall, varnish, sky, filter]: [[f32; N]; 5],
    eye: Observer<3, N, Power, G>,
) -> Scene<N, G> {
    let paint = Reflectance::from_bins;
    let varnish = Microfacet { facets: TrowbridgeReitz::new(0.3), boundary: paint(varnish) };
    Scene {
        lamp: Intensity::new(Light::from_bins(lamp)),
        wall: OrenNayar::new(paint(wall), 0.5),
        varnish,
        sky: Light::from_bins(sky),
        filter: paint(filter),
        eye,
    }
}

fn direction() -> impl Strategy<Value = Direction> {
    (0.0f32..1.5, -4.0f32..4.0).prop_map(|(theta, phi)| Direction::spherical(theta, phi))
}

proptest! {
    #[test]
    fn rgb_has_the_bits_of_three_floats_by_hand(
        numbers in any::<[[u8; 3]; 5]>(), wo in direction(), wi in direction()
    ) {
        let numbers = numbers.map(|band| band.map(|code| f32::from(code) / 255.0));
        let eye: Observer<3, 3, Power, RgbBands<Srgb>> = Observer::standard();
        let [r, g, b] = by_hand(&numbers, wo, wi);
        // In the order of additions that `Observer::sees` has.
        let expected = Srgb::TO_XYZ.map(|[x, y, z]| (100.0 * x * r + 100.0 * z * b) + 100.0 * y * g);
        prop_assert_eq!(shade(&scene(numbers, eye), wo, wi), expected);
    }

    #[test]
    fn spectra_have_what_31_floats_have_by_hand(
        numbers in prop::collection::vec(0.0f32..1.0, 5 * 31), wo in direction(), wi in direction()
    ) {
        let numbers: [[f32; 31]; 5] = core::array::from_fn(|i| core::array::from_fn(|k| numbers[31 * i + k]));
        let eye: Observer<3, 31, Power> = Observer::standard();
        let leaving = by_hand(&numbers, wo, wi);
        prop_assert_eq!(shade(&scene(numbers, eye), wo, wi), eye.sees(&Light::from_bins(leaving)));
        for (row, sum) in eye.weights().iter().zip(eye.sees(&Light::from_bins(leaving))) {
            let exact: f64 = row.iter().zip(leaving).map(|(w, l)| f64::from(*w) * f64::from(l)).sum();
            prop_assert!((f64::from(sum) - exact).abs() <= 1e-6 * exact);
        }
    }
}

/// The same source behind two aliases, with colors for what goes in.
macro_rules! rendered {
    ($n:literal, $bands:ty, $color:expr) => {{
        type Paint = Reflectance<$n, $bands>;
        type Beam = Light<$n, $bands>;
        static EYE: Observer<3, $n, Power, $bands> = Observer::standard();
        let white = Beam::from_rgb(Rgb::<Srgb>::new(1.0, 1.0, 1.0));
        let paint = Paint::from_rgb($color);
        let matt = scattered(&Lambert(paint), Direction::NORMAL, &GaussLegendre::<4, 1>, |_| white);
        let mirror = scattered(&Smooth(paint), Direction::NORMAL, &Specular, |_| white * 2.0);
        [
            EYE.sees(&Beam::from_rgb($color)),
            EYE.sees(&matt),
            EYE.sees(&(mirror * 0.5)),
            EYE.sees(white.onto(&paint)),
        ]
    }};
}

#[test]
fn one_source_gives_both_the_same_colors() {
    let mut check = check("colors of spectra from RGB, CIEDE2000");
    let white = Xyz::from(Observer::<3, 3, Power, RgbBands<Srgb>>::standard().sees(&Light::flat(1.0)));
    for code in 0..17 * 17 * 17 {
        let [r, g, b] = [code % 17, code / 17 % 17, code / 289].map(|step: u32| (16 * step).min(255) as u8);
        let color = EncodedRgb::<Srgb>::from_u8([r, g, b]).decode();
        let rgb = rendered!(3, RgbBands<Srgb>, color);
        for spectral in [
            rendered!(31, Bins<380, 730>, color),
            rendered!(31, Nodes<400, 700>, color),
            rendered!(16, Bins<400, 700>, color),
            rendered!(81, Nodes<380, 780>, color),
        ] {
            for (spectral, rgb) in spectral.into_iter().zip(rgb) {
                let difference = Xyz::from(spectral).delta_e(Xyz::from(rgb), white);
                check.value(&format!("{r} {g} {b}"), f64::from(difference), 0.0);
            }
        }
    }
    check.tight(4 * 4 * 17 * 17 * 17);
}

/// Every space, by its own white; also in code that is generic over the bands.
#[test]
fn the_white_of_each_space_is_seen_as_it_is() {
    fn xyz<S: RgbSpace, const N: usize, G: StandardObserver<N>>(color: Rgb<S>) -> Xyz
    where
        Light<N, G>: FromRgb<S>,
    {
        Xyz::from(Observer::<3, N, Power, G>::standard().sees(&Light::<N, G>::from_rgb(color)))
    }
    fn holds<S: RgbSpace>() {
        for color in [[1.0, 1.0, 1.0], [0.9, 0.4, 0.3], [20.0, 30.0, 10.0], [0.0, 0.0, 0.0]] {
            let [r, g, b] = color;
            let by_matrix = xyz::<S, 3, RgbBands<S>>(Rgb::new(r, g, b)).to_array();
            let by_bins = xyz::<S, 31, Nodes<400, 700>>(Rgb::new(r, g, b)).to_array();
            for (a, b) in by_matrix.iter().zip(by_bins) {
                assert!((a - b).abs() <= 1e-4 * by_matrix[1], "{by_matrix:?} {by_bins:?}");
            }
        }
    }
    holds::<Srgb>();
    holds::<DisplayP3>();
    holds::<AcesCg>();
}

/// Mixed paints and observers in integers mean no wavelengths either.
#[test]
fn paints_and_integers_need_no_wavelengths() {
    fn seen<const N: usize, G: StandardObserver<N>>() -> (f32, f32) {
        let (white, black) = (Reflectance::<N, G>::flat(1.0), Reflectance::flat(0.04));
        let eye = Observer::<3, N, Power, G>::standard();
        let fixed = FixedObserver::new(&eye).expect("weights");
        let y = fixed.sees(&[10_000; N])[1] as f32 * fixed.unit() / 10_000.0;
        (kubelka_munk(&[(0.99, &white), (0.01, &black)])[1], y)
    }
    let (spectral, rgb) = (seen::<31, Bins<380, 730>>(), seen::<3, RgbBands<Srgb>>());
    assert!(spectral.0 == rgb.0 && (spectral.1 - 100.0).abs() < 0.01 && (rgb.1 - 100.0).abs() < 0.01);
}
