//! No finite number gives NaN where a function of matter takes it, and NaN in any argument is seen in the
//! result: they are called with numbers of every size that f32 has, and with those at the ends.
#![cfg(feature = "libm")]

use model::noise::Noise;
use nanospectra::geometry::{Direction, Frame, GaussLegendre};
use nanospectra::matter::scattering::{rho_dh, rho_hd};
use nanospectra::matter::{
    Absorber, Brdf, Burley, Cauchy, Conductor, Dielectric, Dipole, Glass, Lambert, Layer, Medium, Microfacet,
    Mirror, N_BK7, OrenNayar, Polarizer, Reflector, Retarder, Slab, Smooth, Specular, Stack, ThinFilm,
    TrowbridgeReitz, VisibleNormals, air_refractivity, burley_distance, external_reflectance, king_factor,
    rayleigh_cross_section, rayleigh_phase,
};
use nanospectra::{Bins, Reflectance, Spectrum};

const CASES: usize = if cfg!(debug_assertions) { 2_000 } else { 40_000 };

type One = Bins<500, 510>;

/// A function of five numbers, how many it takes, and the range that its documentation gives to each.
type Family = (&'static str, &'static [[f32; 2]], fn([f32; 5]) -> Option<Vec<f32>>);

const ANY: [f32; 2] = [f32::MIN, f32::MAX];
const SHARE: [f32; 2] = [0.0, 1.0];
const ABOVE: [f32; 2] = [0.0, f32::MAX];
const INDEX: [f32; 2] = [1e-3, 1e3];
const NM: [f32; 2] = [1.0, 1e9];
const THICK: [f32; 2] = [0.0, 1e12];

fn flat(value: f32) -> Reflectance<1, One> {
    Reflectance::flat(value)
}

fn brdf<B: Brdf<Value = f32>>(of: B, [t, p, u, q]: [f32; 4]) -> Option<Vec<f32>> {
    let [wo, wi] = [Direction::spherical(t, p), Direction::spherical(u, q)];
    let [wo2, wi2] = [Direction::from_cosine(t, p), Direction::from_cosine(u, q)];
    Some(vec![of.f(wo, wi) + of.f(wo2, wi2)])
}

fn light_of(plate: &nanospectra::matter::Mueller<1, One>) -> Option<Vec<f32>> {
    Some(plate.turn(0, [1.0, 0.6, 0.0, 0.8]).into())
}

fn facets(alpha: f32) -> Microfacet<Conductor> {
    Microfacet { facets: TrowbridgeReitz::new(alpha), boundary: Conductor::new(0.2, 3.0) }
}

const FAMILIES: [Family; 34] = [
    ("spherical direction", &[ANY; 2], |[t, p, ..]| Some(Direction::spherical(t, p).to_array().into())),
    ("direction of a cosine", &[ANY; 2], |[c, p, ..]| Some(Direction::from_cosine(c, p).to_array().into())),
    ("angles of a direction", &[ANY; 2], |[t, p, ..]| {
        let w = Direction::spherical(t, p);
        Some(vec![w.theta_rad(), w.phi_rad(), w.sin_theta()])
    }),
    ("refraction", &[ANY; 3], |[t, p, eta, ..]| {
        Some(Direction::spherical(t, p).refracted(eta)?.to_array().into())
    }),
    ("direction of a vector", &[ANY; 3], |[x, y, z, ..]| {
        Some(Direction::from_vector([x, y, z])?.to_array().into())
    }),
    ("frame", &[ANY; 3], |[x, y, z, ..]| Some(Frame::from_normal([x, y, z])?.axes().concat())),
    ("dielectric", &[ANY; 2], |[eta, cos, ..]| {
        let glass = Dielectric::new(eta);
        let (r, t, a) = (glass.fresnel(cos), glass.entering(cos), glass.amplitudes(cos));
        Some(vec![r.s, r.p, t.s, t.p, a.s.re, a.s.im, a.p.re, a.p.im, a.retardation().re])
    }),
    ("conductor", &[ANY; 3], |[eta, k, cos, ..]| {
        let metal = Conductor::new(eta, k);
        let (r, t, a) = (metal.fresnel(cos), metal.entering(cos), metal.amplitudes(cos));
        Some(vec![r.s, r.p, t.s, t.p, a.s.re, a.s.im, a.p.re, a.p.im, a.retardation().re])
    }),
    ("a number as a reflector", &[ANY; 2], |[r, cos, ..]| Some(vec![r.reflectance(cos)])),
    ("a spectrum as a reflector", &[ANY; 2], |[r, cos, ..]| Some(flat(r).reflectance(cos).values().to_vec())),
    ("Lambert", &[SHARE, ANY, ANY, ANY, ANY], |[r, angles @ ..]| brdf(Lambert(r), angles)),
    ("Oren and Nayar", &[ANY; 5], |[r, angles @ ..]| brdf(OrenNayar::new(r, 0.5), angles)),
    ("rough Oren and Nayar", &[ANY; 5], |[r, angles @ ..]| brdf(OrenNayar::new(0.5f32, r), angles)),
    ("facets", &[ANY; 5], |[alpha, angles @ ..]| brdf(facets(alpha), angles)),
    ("smooth", &[ANY; 4], |[t, p, u, q, _]| brdf(Smooth(0.5f32), [t, p, u, q])),
    ("densities of facets", &[ANY; 5], |[alpha, t, p, u, q]| {
        let (facets, w) = (TrowbridgeReitz::new(alpha), Direction::spherical(t, p));
        let wm = Direction::spherical(u, q);
        Some(vec![facets.d(wm), facets.g1(w), facets.visible_d(w, wm)])
    }),
    ("a visible normal", &[ANY, ANY, ANY, SHARE, ANY], |[alpha, t, p, share, turns]| {
        let w = Direction::spherical(t, p);
        Some(TrowbridgeReitz::new(alpha).visible_normal(w, share, turns).to_array().into())
    }),
    ("reflectances", &[ANY; 3], |[alpha, t, p, ..]| {
        let (w, rough) = (Direction::spherical(t, p), facets(alpha));
        let mirror = Smooth(0.5f32);
        Some(vec![
            rho_hd(&rough, w, &VisibleNormals::<2, 4>),
            rho_dh(&OrenNayar::new(0.5f32, alpha), w, &GaussLegendre::<2, 2>),
            if w.cos_theta() > 0.0 || w.cos_theta().is_nan() { rho_hd(&mirror, w, &Specular) } else { 0.0 },
        ])
    }),
    ("a mean reflectance", &[[1.0, 3.0]], |[eta, ..]| Some(vec![external_reflectance(eta)])),
    ("a film", &[INDEX, INDEX, THICK, NM, ANY], |[film, behind, d, nm, cos]| {
        let [s, p] = ThinFilm::new([1.0, film, behind], d).at(nm, cos);
        Some(vec![s.reflected, s.transmitted, p.reflected, p.transmitted])
    }),
    ("means of a film", &[INDEX, INDEX, THICK, ANY], |[film, behind, d, cos, _]| {
        Some(ThinFilm::new([1.5, film, behind], d).reflectance::<2, Bins<400, 700>>(cos).values().to_vec())
    }),
    ("a stack", &[INDEX, [0.0, 1e3], THICK, NM, ANY], |[n, k, thickness_nm, nm, cos]| {
        let layers = [Layer { medium: Medium { n, k }, thickness_nm }];
        let [s, p] = Stack { incident: 1.0, layers, substrate: Medium { n: 1.5, k: 0.1 } }.at(nm, cos);
        Some(vec![s.reflected, s.transmitted, s.absorbed, p.reflected, p.transmitted, p.absorbed])
    }),
    ("a slab", &[ABOVE, ABOVE, ABOVE, ANY], |[index, sigma, thickness_m, cos, _]| {
        let absorber = Absorber::<1, One>::from_per_m([sigma]).ok()?;
        let slab = Slab { index: Spectrum::flat(index), absorber, thickness_m };
        Some(vec![slab.reflectance(cos)[0], slab.transmittance(cos)[0], slab.absorbed(cos)[0]])
    }),
    ("an absorber", &[ABOVE; 2], |[sigma, path, ..]| {
        let absorber = Absorber::<1, One>::from_per_m([sigma]).ok()?;
        Some(vec![absorber.transmittance(path)[0], absorber.absorbed(path)[0]])
    }),
    ("an absorber of a plate", &[ANY; 3], |[share, thickness, path, ..]| {
        let absorber = Absorber::from_transmittance(&flat(share), thickness).ok()?;
        if path < 0.0 { None } else { Some(vec![absorber.transmittance(path)[0]]) }
    }),
    ("a dipole", &[[0.0, 1e18], [0.0, 1e18], [1.0, 3.0], ABOVE, ANY], |[a, s, eta, r, cos]| {
        let skin = Dipole::<1, One>::new([a], [s], eta);
        Some(vec![skin.reflectance()[0], skin.profile(r)[0], skin.hemispherical_directional(cos)[0]])
    }),
    ("Burley", &[SHARE, ABOVE, ABOVE], |[albedo, d, r, ..]| {
        let skin = Burley::new(flat(albedo), [d]);
        Some(vec![skin.within(r)[0], skin.times_radius(r)[0]])
    }),
    ("Burley's distance", &[SHARE], |[share, ..]| Some(vec![burley_distance(share)])),
    ("air", &[[200.0, 2000.0], [0.0, 1000.0], [-1.0, 1.0]], |[nm, co2, cos, ..]| {
        let king = king_factor(nm, co2);
        Some(vec![air_refractivity(nm), rayleigh_cross_section(nm, co2), rayleigh_phase(cos, king)])
    }),
    ("Sellmeier", &[ANY], |[nm, ..]| N_BK7.index(nm).map(|n| vec![n])),
    ("Cauchy", &[ANY; 4], |[a, b, c, nm, _]| Cauchy { a, b, c }.index(nm).map(|n| vec![n])),
    ("a mirror", &[ANY; 3], |[eta, cos, axis, ..]| {
        light_of(Mirror::<1, One>::dielectric(&[eta], cos, axis).mueller())
    }),
    ("a metal mirror", &[ANY; 4], |[eta, k, cos, axis, _]| {
        light_of(Mirror::<1, One>::conductor(&Spectrum::flat(eta), &Spectrum::flat(k), cos, axis).mueller())
    }),
    ("plates and sheets", &[ANY, ANY, SHARE, SHARE], |[path, axis, along, across, _]| {
        let plate = Retarder::<1, One>::from_path_difference(path, axis);
        let sheet = Polarizer::new(&flat(along), &flat(across), axis);
        let same = Retarder::<1, One>::flat(path, axis);
        Some([light_of(plate.mueller())?, light_of(sheet.mueller())?, light_of(same.mueller())?].concat())
    }),
];

/// Any finite number of a range; often one of a usual size, or one at an end.
fn any(noise: &mut Noise, [low, high]: [f32; 2]) -> f32 {
    const ENDS: [f32; 10] = [0.0, -0.0, 1.0, -1.0, 0.5, 1.5, f32::MIN_POSITIVE, 1e-45, -1e-45, 1.000_000_1];
    let number = match noise.bits() % 8 {
        0 | 1 => 3.0 * noise.offset(),
        2 => ENDS[noise.bits() as usize % ENDS.len()],
        3 => [low, high][noise.bits() as usize % 2],
        _ => loop {
            let number = f32::from_bits(noise.bits());
            if number.is_finite() {
                break number;
            }
        },
    };
    // What is beyond the range comes back into it, with most of its digits.
    if (low..=high).contains(&number) { number } else { number.abs().clamp(low, high) }
}

#[test]
fn no_finite_number_gives_nan_where_matter_takes_it() {
    for (what, ranges, function) in FAMILIES {
        let mut noise = Noise(11);
        for _ in 0..CASES {
            let mut numbers = [0.5f32; 5];
            numbers.iter_mut().zip(ranges).for_each(|(number, range)| *number = any(&mut noise, *range));
            let got = function(numbers);
            assert!(!got.iter().flatten().any(|v| v.is_nan()), "{what} of {numbers:?}: {got:?}");
        }
    }
}

#[test]
fn matter_never_swallows_nan() {
    let beside = [[0.5f32; 5], [1.0; 5], [0.0; 5], [1.5, 1.2, 0.7, 0.4, 0.3], [0.3, 0.6, 0.55, 0.9, 0.2]];
    for (what, ranges, function) in FAMILIES {
        for others in beside {
            for k in 0..ranges.len() {
                let mut numbers = others;
                numbers.iter_mut().zip(ranges).for_each(|(v, [low, high])| *v = v.clamp(*low, *high));
                numbers[k] = f32::NAN;
                let got = function(numbers);
                let is_seen = got.as_ref().is_none_or(|got| got.iter().any(|v| v.is_nan()));
                assert!(is_seen, "{what} of {numbers:?}: {got:?}");
            }
        }
    }
}

/// A surface that reads one component of a direction only shall see that another one is NaN.
#[test]
fn a_direction_of_no_azimuth_is_no_direction() {
    let (no_azimuth, up) = (Direction::spherical(0.5, f32::NAN), Direction::NORMAL);
    assert!(no_azimuth.to_array().iter().all(|part| part.is_nan()));
    assert!(Direction::from_cosine(0.5, f32::NAN).to_array().iter().all(|part| part.is_nan()));
    assert!(Lambert(0.5f32).f(up, no_azimuth).is_nan() && Lambert(0.5f32).f(no_azimuth, up).is_nan());
    assert!(facets(0.3).f(no_azimuth, up).is_nan());
    // Beside it, the zero of a cosine keeps its sign.
    assert!(Direction::from_cosine(-0.0, 0.3).cos_theta().is_sign_negative());
}
