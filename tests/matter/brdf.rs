//! What every BRDF keeps (reciprocity, energy, no NaN), what each is held to, and the integrals over them.

use model::allowed::{Singles, check};
use model::noise::Noise;
use model::surface;
use nanospectra::geometry::{Cosine, Direction, GaussLegendre, Hemisphere, Uniform};
use nanospectra::matter::scattering::{reciprocity, rho_dh, rho_hd, rho_hh, scattered, white_furnace};
use nanospectra::matter::{
    Brdf, Conductor, Dielectric, Glass, Lambert, Microfacet, N_BK7, OrenNayar, Reflector, Smooth, Specular,
    TrowbridgeReitz, VisibleNormals,
};
use nanospectra::{Light, Nodes, Reflectance, RefractiveIndex, Spectrum};

/// In the plane of x.
fn tilted(cos_theta: f32) -> Direction {
    Direction::from_cosine(cos_theta, 0.0)
}

fn as_f64(w: Direction) -> surface::Vector {
    w.to_array().map(f64::from)
}

fn facets<F>(alpha: f32, boundary: F) -> Microfacet<F> {
    Microfacet { facets: TrowbridgeReitz::new(alpha), boundary }
}

/// A BRDF that no matter has: it favors one side.
struct OneWay;

impl Brdf for OneWay {
    type Value = f32;

    fn f(&self, wo: Direction, wi: Direction) -> f32 {
        0.3 * wo.cos_theta() * (1.0 + wi.x())
    }
}

#[test]
fn reciprocity_is_kept_by_all_and_its_check_finds_who_does_not() {
    let nodes = Uniform::<5, 7>;
    assert_eq!(reciprocity(&Lambert(0.5), &nodes), 0.0);
    assert_eq!(reciprocity(&OrenNayar::new(0.8, 0.7), &nodes), 0.0);
    assert_eq!(reciprocity(&facets(0.3, Dielectric::new(1.5)), &nodes), 0.0);
    let metal = Conductor::new(Spectrum::<RefractiveIndex, 3>::flat(0.2), Spectrum::flat(3.0));
    assert_eq!(reciprocity(&facets(0.5, metal), &nodes), 0.0);
    let found = reciprocity(&OneWay, &nodes);
    assert!(found > 0.1, "{found}");
    assert!(reciprocity(&Lambert(f32::NAN), &nodes).is_nan());
}

#[test]
fn no_surface_returns_more_than_it_gets_and_the_furnace_finds_who_would() {
    let rule = GaussLegendre::<16, 32>;
    let lambert = white_furnace(&Lambert(1.0), &rule, &Cosine::<8, 8>);
    assert!((lambert - 1.0).abs() < 2e-7, "{lambert}");
    for alpha in [1.0, 0.3, 1e-2, 1e-4] {
        let furnace = white_furnace(&facets(alpha, 1.0), &rule, &VisibleNormals::<16, 32>);
        assert!((0.5..=1.0).contains(&furnace), "{alpha}: {furnace}");
    }
    assert!(white_furnace(&Smooth(1.0), &rule, &Specular) == 1.0);
    assert!(white_furnace(&Lambert(1.01), &rule, &rule) > 1.0);
    assert!(white_furnace(&Lambert(f32::NAN), &rule, &rule).is_nan());
    // One wavelength above 1 is enough.
    let bright = Reflectance::<3>::from_bins([0.5, 1.2, 0.5]);
    assert!((white_furnace(&Lambert(bright), &rule, &rule) - 1.2).abs() < 1e-6);
}

#[test]
fn rough_matt_surfaces_are_the_published_model() {
    let mut check = check("Oren-Nayar, of the formulas");
    for (albedo, roughness) in [(1.0f32, 1.0f32), (0.5, 0.5), (0.18, 0.1), (0.9, 0.02)] {
        let matt = OrenNayar::new(albedo, roughness);
        for (o, i) in (1..=20).flat_map(|o| (1..=20).map(move |i| (o, i))) {
            let (wo, wi) =
                (tilted(0.05 * o as f32), Direction::from_cosine(0.05 * i as f32, 0.037 * (o + i) as f32));
            let exact = surface::eon_f(albedo.into(), roughness.into(), as_f64(wo), as_f64(wi));
            check.add(&format!("{albedo}, {roughness}, {wo:?}, {wi:?}"), matt.f(wo, wi), exact);
        }
    }
    check.tight_over_all();
}

#[test]
fn a_white_rough_matt_surface_returns_all_light() {
    // The model and the formulas that are independent of it: brute force, and the crate's own rules.
    let steps = if cfg!(debug_assertions) { 300 } else { 1000 };
    for (roughness, cosine) in [(1.0, 0.9), (1.0, 0.2), (0.3, 0.5)] {
        let of_model =
            surface::rho(surface::tilted(cosine), steps, |wo, wi| surface::eon_f(1.0, roughness, wo, wi));
        assert!((of_model - 1.0).abs() < 3e-4, "{roughness}, {cosine}: {of_model}");
        let matt = OrenNayar::new(1.0f32, roughness as f32);
        let got = rho_hd(&matt, tilted(cosine as f32), &Uniform::<200, 200>);
        assert!((f64::from(got) - 1.0).abs() < 1e-3, "{roughness}, {cosine}: {got}");
    }
    // Where nothing depends on azimuth the rule is exact.
    let mut check = check("reflectance of white Oren-Nayar");
    for roughness in [0.0f32, 0.1, 0.5, 1.0] {
        check.add(
            "at the normal",
            rho_hd(&OrenNayar::new(1.0, roughness), Direction::NORMAL, &GaussLegendre::<32, 1>),
            1.0,
        );
    }
    check.tight(4);
}

#[test]
fn leaving_and_arriving_reflectances_are_equal_for_the_same_direction() {
    let mut check = check("facets, leaving and arriving by two rules");
    // For gloss by the normals seen from either direction, for roughness by fixed directions too.
    let cases = [(1.0f32, 1.0f32), (1.0, 0.6), (0.5, 1.0), (0.5, 0.7), (0.5, 0.4)];
    for (alpha, cosine) in cases {
        let (rough, w) = (facets(alpha, 1.0), tilted(cosine));
        let leaving = rho_dh(&rough, w, &GaussLegendre::<32, 64>);
        let arriving = rho_hd(&rough, w, &VisibleNormals::<128, 128>);
        check.add(&format!("{alpha}, {cosine}"), arriving, leaving.into());
    }
    for (alpha, cosine) in
        [(0.1f32, 1.0f32), (0.1, 0.5), (0.01, 0.3), (0.01, 0.03), (1e-3, 0.1), (1e-4, 0.01)]
    {
        let (glossy, w) = (facets(alpha, 1.0), tilted(cosine));
        let leaving = rho_dh(&glossy, w, &VisibleNormals::<256, 128>);
        let arriving = rho_hd(&glossy, w, &VisibleNormals::<224, 96>);
        check.add(&format!("{alpha}, {cosine}"), arriving, leaving.into());
    }
    check.tight(11);
    // The same direction, and no other.
    let glass = facets(0.5, Dielectric::new(1.5));
    let (up, low) =
        (rho_hd(&glass, tilted(1.0), &Uniform::<64, 64>), rho_dh(&glass, tilted(0.1), &Uniform::<64, 64>));
    assert!((up - low).abs() > 0.05, "{up} {low}");
    // A BRDF that is not reciprocal has two.
    let (hd, dh) =
        (rho_hd(&OneWay, tilted(0.5), &Uniform::<64, 64>), rho_dh(&OneWay, tilted(0.5), &Uniform::<64, 64>));
    assert!((hd - dh).abs() > 0.1, "{hd} {dh}");
}

#[test]
fn the_hemisphere_sees_the_mean_of_all_directions() {
    let rule = GaussLegendre::<16, 32>;
    assert!((rho_hh(&Lambert(0.4f32), &rule, &rule) - 0.4).abs() < 1e-6);
    // A smooth glass: its diffuse reflectance, 0.0918 for n = 1.5.
    let glass = Smooth(Dielectric::new(1.5));
    assert!((rho_hh(&glass, &GaussLegendre::<8, 1>, &Specular) - 0.091_778).abs() < 1e-6);
    let spectral = Lambert(Reflectance::<3>::from_bins([0.1, 0.2, 0.7]));
    let share = rho_hh(&spectral, &rule, &rule);
    assert!(share.values().iter().zip([0.1, 0.2, 0.7]).all(|(a, b)| (a - b).abs() < 1e-6));
}

#[test]
fn the_scattering_equation_has_the_cosine_once_and_pi_where_it_belongs() {
    // A lamp of radiance 50 that fills a cone of 10 degrees around the zenith, on paper of 0.8: E = pi L
    // sin^2, Lo = rho E / pi.
    let edge = 10f32.to_radians();
    let sky = |wi: Direction| if wi.cos_theta() > edge.cos() { 50.0f32 } else { 0.0 };
    let lo = scattered(&Lambert(0.8f32), tilted(0.5), &Uniform::<20_000, 1>, sky);
    assert!((lo / (0.8 * 50.0 * edge.sin().powi(2)) - 1.0).abs() < 2e-3, "{lo}");
    // A mirror shows what is there, and only that.
    let (wo, lamp) =
        (tilted(0.5), |wi: Direction| if wi.x() < -0.8 { Light::<16>::flat(3.0) } else { Light::flat(0.0) });
    let shown = scattered(&Smooth(Reflectance::<16>::flat(0.9)), wo, &Specular, lamp);
    assert!(shown.values().iter().all(|value| (value - 2.7).abs() < 1e-6));
    // A nearly smooth surface of facets shows the same.
    let shown = scattered(&facets(1e-4, Reflectance::<16>::flat(0.9)), wo, &VisibleNormals::<8, 16>, lamp);
    assert!(shown.values().iter().all(|value| (value - 2.7).abs() < 1e-5));
}

#[test]
fn spectra_scatter_as_their_numbers_do() {
    let eta = N_BK7.indices::<5, Nodes<400, 800>>().expect("no resonance");
    let k = Spectrum::<RefractiveIndex, 5, Nodes<400, 800>>::from_bins([0.1, 1.0, 2.0, 3.0, 4.0]);
    let (wo, wi) = (tilted(0.7), Direction::from_cosine(0.8, 0.45));
    let glass = facets(0.2, Dielectric::new(eta)).f(wo, wi);
    let metal = facets(0.2, Conductor::new(eta, k)).f(wo, wi);
    let matt = OrenNayar::new(Reflectance::<5, Nodes<400, 800>>::from_bins([0.0, 0.1, 0.5, 0.9, 1.0]), 0.4)
        .f(wo, wi);
    for (band, (eta, k)) in eta.values().iter().zip(k.values()).enumerate() {
        assert_eq!(glass.values()[band], facets(0.2, Dielectric::new(*eta)).f(wo, wi));
        assert_eq!(metal.values()[band], facets(0.2, Conductor::new(*eta, *k)).f(wo, wi));
        let albedo = [0.0, 0.1, 0.5, 0.9, 1.0][band];
        assert_eq!(matt.values()[band], OrenNayar::new(albedo, 0.4).f(wo, wi));
    }
    assert_eq!(Reflectance::<5>::flat(0.3).reflectance(0.1).values(), &[0.3; 5]);
}

#[test]
fn facets_scatter_as_the_published_model() {
    let mut check = check("facets, of the formulas");
    for alpha in [1.0f32, 0.5, 0.1] {
        for (o, i) in (1..=20).flat_map(|o| (1..=20).map(move |i| (o, i))) {
            let (wo, wi) = (
                tilted(0.05 * o as f32),
                Direction::from_cosine(0.05 * i as f32, 0.5 + 0.004 * (o + i) as f32),
            );
            let exact = surface::ggx_f(alpha.into(), as_f64(wo), as_f64(wi));
            check.add(&format!("{alpha}, {wo:?}, {wi:?}"), facets(alpha, 1.0).f(wo, wi), exact);
        }
    }
    check.tight_over_all();
}

/// Directions above and below the surface: near the poles, at the horizon, everywhere.
fn direction(noise: &mut Noise) -> Direction {
    let cosine = match (4.0 * noise.uniform()) as u32 {
        0 => 10f64.powf(-45.0 * noise.uniform()),
        1 => 1.0 - 10f64.powf(-8.0 * noise.uniform()),
        2 => 2.0 * noise.uniform() - 1.0,
        _ => noise.uniform(),
    };
    let turns = [noise.uniform(), 0.0, 0.25, 0.5][(4.0 * noise.uniform()) as usize];
    Direction::from_cosine(cosine as f32, turns as f32)
}

/// A number of any size and sign, or an ordinary one.
fn wild(noise: &mut Noise) -> f32 {
    let any = f32::from_bits((noise.uniform() * 4_294_967_296.0) as u32);
    if noise.uniform() < 0.5 && any.is_finite() { any } else { noise.uniform() as f32 }
}

#[test]
fn no_finite_surface_and_direction_give_nan_or_less_than_nothing() {
    let mut noise = Noise(7);
    let cases = if cfg!(debug_assertions) { 20_000 } else { 250_000 };
    for case in 0..cases {
        let (wo, wi) = (direction(&mut noise), direction(&mut noise));
        let (a, b, albedo) = (wild(&mut noise), wild(&mut noise), noise.uniform() as f32);
        let values = [
            Lambert(albedo).f(wo, wi),
            OrenNayar::new(albedo, a).f(wo, wi),
            facets(a, Dielectric::new(b)).f(wo, wi),
            facets(b, Conductor::new(a, b)).f(wo, wi),
        ];
        let swapped = [
            Lambert(albedo).f(wi, wo),
            OrenNayar::new(albedo, a).f(wi, wo),
            facets(a, Dielectric::new(b)).f(wi, wo),
            facets(b, Conductor::new(a, b)).f(wi, wo),
        ];
        let up = wo.cos_theta() > 0.0 && wi.cos_theta() > 0.0;
        for (value, swapped) in values.into_iter().zip(swapped) {
            assert!(value.is_finite() && value >= 0.0, "{case}: {a:e}, {b:e}, {wo:?}, {wi:?}: {values:?}");
            assert!(up || value == 0.0, "{case}: light through the surface, {values:?}");
            assert_eq!(value, swapped, "{case}: {a:e}, {b:e}, {wo:?}, {wi:?}: not reciprocal");
        }
        for cosine in [wild(&mut noise), wo.cos_theta()] {
            let shares = [Dielectric::new(a).reflectance(cosine), Conductor::new(a, b).reflectance(cosine)];
            assert!(
                shares.iter().all(|share| (0.0..=1.0).contains(share)),
                "{case}: {a:e}, {b:e}, {cosine:e}: {shares:?}"
            );
            let refracted = wo.refracted(a).map_or([0.0; 3], Direction::to_array);
            assert!(
                refracted.iter().all(|part| part.abs() <= 1.000_001),
                "{case}: {a:e}, {wo:?}: {refracted:?}"
            );
        }
        let wm = TrowbridgeReitz::new(a).visible_normal(wo, albedo, b);
        assert!(wm.to_array().iter().all(|part| part.is_finite()), "{case}: {a:e}, {wo:?}: {wm:?}");
    }
}

#[test]
fn energy_is_kept_by_surfaces_that_nobody_chose() {
    let mut noise = Noise(11);
    for case in 0..if cfg!(debug_assertions) { 100 } else { 2000 } {
        let alpha = 10f64.powf(-4.0 * noise.uniform()) as f32;
        let wo =
            Direction::from_cosine(10f64.powf(-4.0 * noise.uniform().powi(2)) as f32, noise.uniform() as f32);
        let (eta, k) = (3.0 * noise.uniform() as f32, 5.0 * noise.uniform() as f32);
        let metal = rho_hd(&facets(alpha, Conductor::new(eta, k)), wo, &VisibleNormals::<8, 16>);
        let white = rho_hd(&facets(alpha, 1.0), wo, &VisibleNormals::<8, 16>);
        assert!(0.0 <= metal && metal <= white && white <= 1.0, "{case}: {alpha}, {wo:?}: {metal} {white}");
        let matt = rho_hd(&OrenNayar::new(noise.uniform() as f32, alpha), wo, &Cosine::<8, 16>);
        assert!((0.0..=1.001).contains(&matt), "{case}: {alpha}, {wo:?}: {matt}");
    }
}

#[test]
fn nan_in_a_direction_or_a_surface_is_never_hidden() {
    let (lost, up) = (Direction::spherical(f32::NAN, 0.0), Direction::NORMAL);
    for (wo, wi) in [(lost, up), (up, lost)] {
        assert!(Lambert(0.5).f(wo, wi).is_nan());
        assert!(OrenNayar::new(0.5, 0.5).f(wo, wi).is_nan());
        assert!(facets(0.5, 1.0).f(wo, wi).is_nan());
        assert!(Smooth(1.0).f(wo, wi).is_nan());
    }
    assert!(facets(f32::NAN, 1.0).f(up, up).is_nan());
    assert!(OrenNayar::new(0.5, f32::NAN).f(up, up).is_nan());
    assert!(rho_hd(&facets(0.5, 1.0), lost, &VisibleNormals::<4, 4>).is_nan());
    assert!(Dielectric::new(f32::NAN).reflectance(0.5).is_nan());
    assert!(Dielectric::new(1.5).reflectance(f32::NAN).is_nan());
    assert!(Conductor::new(0.2, f32::NAN).reflectance(0.5).is_nan());
    assert!(Conductor::new(f32::NAN, 3.0).reflectance(0.5).is_nan());
    assert!(GaussLegendre::<4, 4>.integrate(|w| if w.cos_theta() > 0.5 { f32::NAN } else { 1.0 }).is_nan());
}
