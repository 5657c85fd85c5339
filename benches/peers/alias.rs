//! What the types of nanospectra cost beside plain loops over arrays, and beside three floats where a color
//! is RGB. At a ratio of 0.91 they take 1.1 times as long. Results are compared bit by bit before they are
//! timed.

use crate::race::{Races, each};
use nanospectra::color::{RgbBands, RgbSpace, Srgb};
use nanospectra::geometry::Direction;
use nanospectra::matter::{Brdf, Lambert, Microfacet, TrowbridgeReitz};
use nanospectra::{Bands, Bins, Light, Observer, Power, Reflectance};

/// A hit on a path: the lamp, the color of the matt part and of the gloss, the roughness, the directions, and
/// the share of the lamp's light that arrives.
struct Hit<const N: usize, G> {
    lamp: Light<N, G>,
    matt: Reflectance<N, G>,
    gloss: Reflectance<N, G>,
    facets: TrowbridgeReitz,
    wo: Direction,
    wi: Direction,
    geometry: f32,
}

/// Numbers from 0 to 1, the same in every run.
fn random() -> impl FnMut() -> f32 {
    let mut state = 0x2545_f491_4f6c_dd1du64;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / (1 << 24) as f32
    }
}

/// Makes 64 paths of eight hits each.
fn paths<const N: usize, G: Bands>() -> Vec<[Hit<N, G>; 8]> {
    let mut random = random();
    let mut path = || {
        core::array::from_fn(|_| {
            let [lamp, matt, gloss] = [(); 3].map(|()| core::array::from_fn(|_| random()));
            let [wo, wi] = [(); 2].map(|()| Direction::spherical(1.5 * random(), 6.0 * random()));
            Hit {
                lamp: Light::from_bins(lamp),
                matt: Reflectance::from_bins(matt),
                gloss: Reflectance::from_bins(gloss),
                facets: TrowbridgeReitz::new(0.1 + 0.5 * random()),
                wo,
                wi,
                geometry: random(),
            }
        })
    };
    (0..64).map(|_| path()).collect()
}

/// The color that is seen along a path. The same code serves RGB and spectra.
fn pixel<const N: usize, G: Bands>(eye: &Observer<3, N, Power, G>, path: &[Hit<N, G>; 8]) -> [f32; 3] {
    let (mut radiance, mut throughput) = (Light::default(), Reflectance::flat(1.0));
    for hit in path {
        let rough = Microfacet { facets: hit.facets, boundary: hit.gloss };
        let f = Lambert(hit.matt).f(hit.wo, hit.wi) + rough.f(hit.wo, hit.wi);
        radiance += hit.lamp * throughput * f * hit.geometry;
        throughput *= hit.matt;
    }
    eye.sees(radiance.through(&throughput))
}

/// The same, written with arrays.
fn by_hand<const N: usize, G: Bands>(eye: impl Fn([f32; N]) -> [f32; 3], path: &[Hit<N, G>; 8]) -> [f32; 3] {
    let (mut radiance, mut throughput) = ([0.0; N], [1.0; N]);
    for hit in path {
        let matt = Lambert(1.0).f(hit.wo, hit.wi);
        let gloss = Microfacet { facets: hit.facets, boundary: 1.0 }.f(hit.wo, hit.wi);
        let (lamp, paint, varnish) = (hit.lamp.values(), hit.matt.values(), hit.gloss.values());
        for k in 0..N {
            radiance[k] += lamp[k] * throughput[k] * (paint[k] * matt + varnish[k] * gloss) * hit.geometry;
            throughput[k] *= paint[k];
        }
    }
    for k in 0..N {
        radiance[k] *= throughput[k];
    }
    eye(radiance)
}

fn plain_sum<const N: usize>(a: &[f32; N], b: &[f32; N]) -> [f32; N] {
    let mut sum = [0.0; N];
    for k in 0..N {
        sum[k] = a[k] + b[k];
    }
    sum
}

fn plain_product<const N: usize>(a: &[f32; N], b: &[f32; N]) -> [f32; N] {
    let mut product = [0.0; N];
    for k in 0..N {
        product[k] = a[k] * b[k];
    }
    product
}

/// Sums and products by value and by reference, eight at a time because one takes less time than a clock can
/// measure.
fn arithmetic<const N: usize, G: Bands>(races: &mut Races) {
    let paths = paths::<N, G>();
    for Hit { lamp, matt, gloss, .. } in paths.iter().flatten() {
        assert_eq!((*gloss + *matt).values(), &plain_sum(gloss.values(), matt.values()));
        assert_eq!((lamp * matt).values(), &plain_product(lamp.values(), matt.values()));
    }
    macro_rules! race {
        ($what:literal, $ours:expr, $by_hand:ident) => {
            let ours = each(&paths, |path| path.each_ref().map($ours));
            let by_hand =
                each(&paths, |path| path.each_ref().map(|h| $by_hand(h.lamp.values(), h.matt.values())));
            races.run(format!("{}, N = {N}", $what), 1.0 / 1.1, 8.0, ours, ("plain loop", by_hand));
        };
    }
    race!("a + b", |h| h.gloss + h.matt, plain_sum);
    race!("&a + &b", |Hit { gloss, matt, .. }| gloss + matt, plain_sum);
    race!("l * f", |h| h.lamp * h.matt, plain_product);
    race!("&l * &f", |Hit { lamp, matt, .. }| lamp * matt, plain_product);
}

pub fn all(races: &mut Races) {
    arithmetic::<4, Bins<400, 700>>(races);
    arithmetic::<31, Bins<400, 700>>(races);

    let eye: Observer<3, 3, Power, RgbBands<Srgb>> = Observer::standard();
    let rgb = paths();
    // Added in the order in which `sees` adds, so that the bits are equal.
    let xyz =
        |[r, g, b]: [f32; 3]| Srgb::TO_XYZ.map(|m| (100.0 * m[0] * r + 100.0 * m[2] * b) + 100.0 * m[1] * g);
    for path in &rgb {
        assert_eq!(pixel(&eye, path), by_hand(xyz, path));
    }
    races.run(
        "RGB, a path of 8 hits",
        1.0 / 1.05,
        1.0,
        each(&rgb, |p| pixel(&eye, p)),
        ("three floats by hand", each(&rgb, |p| by_hand(xyz, p))),
    );

    let eye: Observer<3, 31, Power> = Observer::standard();
    let spectral = paths();
    let xyz = |bins: [f32; 31]| eye.sees(&Light::from_bins(bins));
    for path in &spectral {
        assert_eq!(pixel(&eye, path), by_hand(xyz, path));
    }
    races.run(
        "31 bins, a path of 8 hits",
        1.0 / 1.1,
        1.0,
        each(&spectral, |p| pixel(&eye, p)),
        ("loops by hand", each(&spectral, |p| by_hand(xyz, p))),
    );
}
