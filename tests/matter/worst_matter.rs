//! That the documented bounds hold for the worst matter that a search finds.
#![cfg(feature = "libm")]

use model::fresnel;
use model::geometry::{gauss, integral};
use model::search::{Range::*, units, worst};
use model::surface;
use nanospectra::geometry::Direction;
use nanospectra::matter::{
    Absorber, Burley, Conductor, Dielectric, Glass, N_BK7, N_SF11, Retarder, ThinFilm, TrowbridgeReitz,
    air_refractivity, burley_distance, external_reflectance, internal_transmittance,
};
use nanospectra::{Bins, Reflectance, Spectrum};
use std::f64::consts::TAU;

const STEPS: usize = 1000;

type One = Bins<500, 510>;

/// The mean of e^(2 pi i path / l) over the wavelengths l between two ends: cosine and sine.
fn mean_of_waves(nodes: &[(f64, f64)], path: f64, low: f64, high: f64) -> [f64; 2] {
    let waves = (path / low - path / high).abs();
    let panels = (0.5 * waves).ceil().max(1.0) as usize;
    let width = (high - low) / panels as f64;
    let mean = |f: fn(f64) -> f64| {
        let panel = |k: usize| {
            let from = low + width * k as f64;
            integral(nodes, from, from + width, |nm| f(TAU * path / nm))
        };
        (0..panels).map(panel).sum::<f64>() / (high - low)
    };
    [mean(f64::cos), mean(f64::sin)]
}

/// The worst error of a component of the light behind a plate, for light of any polarization: the elements of
/// the plate's matrix turn U and V, so it is the distance of two complex numbers.
fn plates_in_bins<const N: usize>(what: &str, share: impl Fn(f64, f64) -> f64, bound: f64) {
    let (nodes, width) = (gauss(40), 350.0 / N as f64);
    worst(1, 200, [Sizes(1.0, 1e6), Even(0.0, N as f32 - 0.01)], |[path_nm, bin]| {
        let k = bin as usize;
        let plate = Retarder::<N, Bins<380, 730>>::from_path_difference(path_nm, 0.0);
        let [_, _, c, s] = plate.mueller().turn(k, [1.0, 0.0, 1.0, 0.0]);
        let low = 380.0 + width * k as f64;
        let [cos, sin] = mean_of_waves(&nodes, path_nm.into(), low, low + width);
        let error = (f64::from(c) - cos).hypot(f64::from(-s) - sin);
        let center = low + 0.5 * width;
        let (reach, waves) = (0.5 * width / center, f64::from(path_nm) / center);
        error / share(reach, waves.min(1.0 / (6.0 * reach)))
    })
    .is_what_is_promised(what, bound);
}

#[test]
fn plates_are_as_exact_as_promised() {
    let formula = |reach: f64, waves: f64| 0.7 * reach * reach + 1.4e-6 * waves + 3e-7;
    plates_in_bins::<1>("a plate in 1 bin", formula, 1.0);
    plates_in_bins::<2>("a plate in 2 bins", formula, 1.0);
    plates_in_bins::<8>("a plate in 8 bins", formula, 1.0);
    plates_in_bins::<81>("a plate in 81 bins", formula, 1.0);
    plates_in_bins::<350>("a plate in 350 bins", formula, 1.0);
    plates_in_bins::<31>("a plate in 31 bins", |_, _| 1.0, 1.6e-4);
    plates_in_bins::<16>("a plate in 16 bins", |_, _| 1.0, 6e-4);
}

/// The share of s and p that a dielectric reflects, without cancellation.
fn dielectric(eta: f64, cos: f64) -> [f64; 2] {
    let sine2 = (1.0 - cos) * (1.0 + cos);
    let g = ((eta - 1.0) * (eta + 1.0) + cos * cos).sqrt();
    let s = (eta - 1.0) * (eta + 1.0) / (cos + g).powi(2);
    let ratio = (cos * g - sine2) / (cos * g + sine2);
    [s * s, s * s * ratio * ratio]
}

#[test]
fn dielectrics_are_as_exact_as_promised() {
    let ranges = [Sizes(1.0, 10.0), Even(0.0, 1.0)];
    worst(1, STEPS, ranges, |[eta, cos]| {
        let [s, _] = dielectric(eta.into(), cos.into());
        if eta == 1.0 { -1.0 } else { units(Dielectric::new(eta).fresnel(cos).s, s) }
    })
    .is_what_is_promised("s of dielectrics, in units", 14.0);
    worst(2, STEPS, ranges, |[eta, cos]| {
        let [_, p] = dielectric(eta.into(), cos.into());
        if eta == 1.0 { -1.0 } else { (f64::from(Dielectric::new(eta).fresnel(cos).p) - p).abs() }
    })
    .is_what_is_promised("p of dielectrics", 5.5e-7);
}

#[test]
fn metals_are_as_exact_as_promised() {
    let ranges = [Even(0.05, 6.0), Even(0.05, 8.0), Even(0.0, 1.0)];
    let exact = |[eta, k, cos]: [f32; 3]| fresnel::reflectances([eta.into(), k.into()], cos.into());
    worst(1, STEPS, ranges, |at| units(Conductor::new(at[0], at[1]).fresnel(at[2]).s, exact(at).0))
        .is_what_is_promised("s of metals, in units", 14.0);
    worst(2, STEPS, ranges, |at| {
        (f64::from(Conductor::new(at[0], at[1]).fresnel(at[2]).p) - exact(at).1).abs()
    })
    .is_what_is_promised("p of metals", 5e-7);
}

#[test]
fn densities_of_facets_are_as_exact_as_promised() {
    worst(1, STEPS, [Sizes(1e-4, 1.0), Even(0.0, 1.57), Even(0.0, 6.25)], |[alpha, theta, phi]| {
        let wm = Direction::spherical(theta, phi);
        let exact = surface::ggx_d(alpha.into(), wm.to_array().map(f64::from));
        units(TrowbridgeReitz::new(alpha).d(wm), exact)
    })
    .is_what_is_promised("densities of facets, in units", 11.0);
}

#[test]
fn absorbers_are_as_exact_as_promised() {
    let medium = |sigma: f32| Absorber::<1, One>::from_per_m([sigma]).expect("a coefficient");
    let ranges = [Sizes(1e-6, 1e6), Sizes(1e-6, 1e3)];
    let depth = |sigma: f32, path: f32| f64::from(sigma) * f64::from(path);
    worst(1, STEPS, ranges, |[sigma, path]| {
        let tau = depth(sigma, path);
        if tau > 86.0 {
            -1.0
        } else {
            units(medium(sigma).transmittance(path)[0], (-tau).exp()) / (tau + 1.2)
        }
    })
    .is_what_is_promised("transmittance, in (tau + 1.2) units", 1.0);
    worst(2, STEPS, ranges, |[sigma, path]| {
        units(medium(sigma).absorbed(path)[0], -(-depth(sigma, path)).exp_m1())
    })
    .is_what_is_promised("what is absorbed, in units", 2.0);
}

#[test]
fn transmittances_within_glass_are_as_exact_as_promised() {
    worst(1, STEPS, [Sizes(1.0, 4.0), Sizes(1e-6, 1.0)], |[eta, share]| {
        let n = f64::from(eta);
        let r = ((n - 1.0) / (n + 1.0)).powi(2);
        let external = (f64::from(share) * (1.0 - r) / (1.0 + r)) as f32;
        let Ok(got) = internal_transmittance(&Reflectance::<1, One>::flat(external), &Spectrum::flat(eta))
        else {
            return -1.0;
        };
        let through = f64::from(external) / (1.0 - r);
        let exact = 2.0 * through / ((1.0 - r) + (1.0 - r).hypot(2.0 * r * through));
        units(got[0], exact)
    })
    .is_what_is_promised("internal transmittance, in units", 12.0);
}

#[test]
fn profiles_of_skin_are_as_exact_as_promised() {
    let skin = |d: f32| Burley::<1, One>::new(Reflectance::flat(1.0), [d]);
    let ranges = [Sizes(1e-3, 1e3), Sizes(1e-6, 1e3)];
    worst(1, STEPS, ranges, |[d, r]| {
        let x = f64::from(r) / f64::from(d);
        units(skin(d).within(r)[0], -0.25 * (-x).exp_m1() - 0.75 * (-x / 3.0).exp_m1())
    })
    .is_what_is_promised("Burley within a radius, in units", 4.0);
    worst(2, STEPS, ranges, |[d, r]| {
        let (r, d64) = (r, f64::from(d));
        let x = f64::from(r) / d64;
        if x > 200.0 {
            return -1.0;
        }
        let exact = ((-x).exp() + (-x / 3.0).exp()) / (4.0 * TAU * d64);
        units(skin(d).times_radius(r)[0], exact) / (x + 4.0)
    })
    .is_what_is_promised("Burley times the radius, in (x + 4) units", 1.0);
    // The share that belongs to the distance that was found, over its slope.
    worst(3, STEPS, [Sizes(1e-6, 0.999_999)], |[share]| {
        let x = f64::from(burley_distance(share));
        let rest = 0.25 * (-x).exp() + 0.75 * (-x / 3.0).exp();
        let missing = (1.0 - f64::from(share)) - rest;
        let slope = 0.25 * ((-x).exp() + (-x / 3.0).exp());
        (missing / slope / x).abs()
    })
    .is_what_is_promised("Burley's distance", 4e-7);
}

#[test]
fn refractive_indices_are_as_exact_as_promised() {
    let exact = |glass: nanospectra::matter::Sellmeier, nm: f32| {
        let um2 = (1e-3 * f64::from(nm)).powi(2);
        let terms = glass.b.iter().zip(glass.c).map(|(b, c)| f64::from(*b) * um2 / (um2 - f64::from(c)));
        (1.0 + terms.sum::<f64>()).sqrt()
    };
    worst(1, STEPS, [Even(380.0, 1000.0)], |[nm]| {
        [N_BK7, N_SF11]
            .map(|glass| (f64::from(glass.index(nm).expect("an index")) / exact(glass, nm) - 1.0).abs())
            .into_iter()
            .fold(0.0, f64::max)
    })
    .is_what_is_promised("indices of glasses", 1.2e-7);
    worst(2, STEPS, [Even(200.0, 2000.0)], |[nm]| {
        let per_um2 = 1e6 / f64::from(nm).powi(2);
        let exact = 1e-8 * (8060.51 + 2_480_990.0 / (132.274 - per_um2) + 17_455.7 / (39.32957 - per_um2));
        (f64::from(air_refractivity(nm)) / exact - 1.0).abs()
    })
    .is_what_is_promised("refractivity of air", 2e-7);
    let nodes = gauss(64);
    worst(3, STEPS / 4, [Even(1.2, 3.0)], |[eta]| {
        // Squares of the cosine, since it is steep at grazing angles.
        let mean = integral(&nodes, 0.0, 1.0, |t| {
            let cos = t * t;
            let [s, p] = dielectric(eta.into(), cos);
            (s + p) * cos * 2.0 * t
        });
        (f64::from(external_reflectance(eta)) - mean).abs()
    })
    .is_what_is_promised("mean reflectance", 3e-7);
}

/// The phase near the critical angle too, where the cosine within the film is a small difference.
#[test]
fn phases_of_films_are_as_exact_as_promised() {
    let ranges = [Even(1.0, 4.0), Even(1.0, 4.0), Even(0.01, 1.0), Sizes(1.0, 1e8), Even(380.0, 780.0)];
    let error = |[n0, n1, cos, thickness, nm]: [f32; 5]| {
        let [a, b, c, d, nm64] = [n0, n1, cos, thickness, nm].map(f64::from);
        let square = (b - a) * (b + a) + (a * c) * (a * c);
        if square < 1e-6 {
            return -1.0;
        }
        let turns = square.sqrt() * (2.0 * d / nm64);
        let exact = turns - turns.round();
        let got = f64::from(ThinFilm::new([n0, n1, 1.0], thickness).phase_turns(nm, cos));
        let off = (got - exact).abs();
        off.min(1.0 - off) / (5e-8 + 4.5e-15 * turns * a * a / square)
    };
    worst(1, STEPS, ranges, error).is_what_is_promised("phases of films, in what is promised", 1.0);
}
