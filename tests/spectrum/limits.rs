//! What lies at the ends of ranges and beyond them: limits that are reached, and inputs that are held or
//! refused.
#![cfg(feature = "libm")]

use nanospectra::geometry::{Direction, GaussLegendre, Hemisphere, Uniform};
use nanospectra::matter::scattering::rho_hd;
use nanospectra::matter::{
    Brdf, Burley, Cauchy, Dipole, Glass, OrenNayar, external_reflectance, internal_reflectance,
};
use nanospectra::radiometry::form_factor::perpendicular_rectangles;
use nanospectra::radiometry::{Candela, Irradiance, Lux, Nit, PointSource, Radiance};
use nanospectra::{Light, Reflectance};
use std::f32::consts::PI;

#[test]
fn a_glass_that_does_not_disperse_has_no_abbe_number() {
    for a in [1.0, 1.5] {
        assert_eq!(Cauchy { a, b: 0.0, c: 0.0 }.abbe_number(), None);
    }
    assert_eq!(Cauchy { a: f32::NAN, b: 0.004, c: 0.0 }.abbe_number(), None);
    let (crown, inverted) = (Cauchy { a: 1.5, b: 0.004, c: 0.0 }, Cauchy { a: 1.5, b: -0.004, c: 0.0 });
    assert!(crown.abbe_number().is_some_and(|v| v > 60.0));
    assert!(inverted.abbe_number().is_some_and(|v| v < -60.0));
}

#[test]
fn a_cosine_beyond_one_is_the_pole() {
    for (cosine, pole) in [(1.000_000_1, 1.0), (3e38, 1.0), (f32::INFINITY, 1.0), (-1.000_000_1, -1.0)] {
        assert_eq!(Direction::from_cosine(cosine, 0.3).to_array(), [0.0, 0.0, pole], "{cosine}");
    }
    assert!(Direction::from_cosine(f32::NAN, 0.0).cos_theta().is_nan());
    assert!(Direction::from_cosine(f32::NAN, 0.0).x().is_nan());
}

#[test]
fn a_black_bin_of_skin_sends_nothing_back_wherever() {
    let skin = Burley::<2>::new(Reflectance::from_bins([0.0, 0.5]), [0.0, 0.0]);
    assert_eq!(skin.times_radius(0.0).values(), &[0.0, f32::INFINITY]);
    assert_eq!(skin.times_radius(1e-3).values(), &[0.0, 0.0]);
    assert_eq!(skin.within(0.0).values(), &[0.0, 0.5]);
}

#[test]
fn no_albedo_makes_a_matt_surface_create_light_or_darkness() {
    let rule = GaussLegendre::<16, 8>;
    for albedo in [1.0f32, 1.2, 20.0, 3e38, f32::INFINITY] {
        let matt = OrenNayar::new(albedo, 1.0);
        assert_eq!(matt, OrenNayar::new(1.0, 1.0), "{albedo}");
        assert!(rho_hd(&matt, Direction::NORMAL, &rule) <= 1.000_001, "{albedo}");
    }
    for albedo in [-1e-30f32, -20.0, f32::NEG_INFINITY] {
        assert_eq!(OrenNayar::new(albedo, 1.0).f(Direction::NORMAL, Direction::NORMAL), 0.0, "{albedo}");
    }
    let mixed = OrenNayar::new(Reflectance::<3>::from_bins([2.0, 0.5, f32::NAN]), 0.5);
    let seen = mixed.f(Direction::NORMAL, Direction::NORMAL);
    assert_eq!(seen.values()[0], OrenNayar::new(1.0, 0.5).f(Direction::NORMAL, Direction::NORMAL));
    assert!(seen.values()[2].is_nan());
}

#[test]
fn an_index_that_no_inside_has_is_nan_and_says_so() {
    let wrong = [-1.0, 0.0, 0.5, 0.999, 3.001, 1e20, f32::INFINITY, f32::NAN];
    for eta in wrong {
        assert!(external_reflectance(eta).is_nan() && internal_reflectance(eta).is_nan(), "{eta}");
        let dipoles =
            [Dipole::<2>::new([0.1; 2], [1.0, 0.0], eta), Dipole::new_by_fit([0.1; 2], [1.0, 0.0], eta)];
        for of in dipoles {
            for spectrum in
                [of.reflectance(), of.profile(1.0), of.profile(1e20), of.hemispherical_directional(0.5)]
            {
                assert!(spectrum.values().iter().all(|v| v.is_nan()), "{eta}: {spectrum:?}");
            }
        }
    }
    for step in 0..=2000 {
        let eta = 1.0 + 1e-3 * step as f32;
        let (outside, inside) = (external_reflectance(eta), internal_reflectance(eta));
        assert!((0.0..1.0).contains(&outside) && (0.0..1.0).contains(&inside), "{eta}: {outside} {inside}");
    }
    assert_eq!((external_reflectance(1.0), internal_reflectance(1.0)), (0.0, 0.0));
}

#[test]
fn the_mean_reflectance_of_media_that_hardly_differ_is_off_by_the_grazing_angles() {
    let mut worst = 0.0f64;
    for step in 0..200 {
        let eta = 1.0 + 1e-5 * 10f32.powf(0.0215 * step as f32);
        // Points crowded at grazing angles.
        let steps = 20_000;
        let exact: f64 = (0..steps)
            .map(|k| {
                let u = (f64::from(k) + 0.5) / f64::from(steps);
                let (c, e) = (u * u, f64::from(eta));
                let g = (e * e - 1.0 + c * c).sqrt();
                let (s, p) = ((c - g) / (c + g), (e * e * c - g) / (e * e * c + g));
                (s * s + p * p) * 2.0 * u * c / f64::from(steps)
            })
            .sum();
        worst = worst.max((f64::from(external_reflectance(eta)) - exact).abs());
    }
    assert!((6e-5..1.1e-4).contains(&worst), "{worst:e}");
}

#[test]
fn a_lossless_dipole_misses_what_the_surface_takes_twice() {
    let white = Dipole::<1>::new([0.0], [1.0], 1.3);
    assert_eq!(white.reflectance().values(), &[1.0], "all that entered leaves");
    let body = GaussLegendre::<16, 1>.integrate_projected(|w| white.hemispherical_directional(w.cos_theta()))
        * (1.0 / PI);
    let gloss = external_reflectance(1.3);
    let all = body.values()[0] + gloss;
    assert!((all - 0.9426).abs() < 1e-4, "{all}");
    assert!((all - (1.0 - gloss * (1.0 - gloss))).abs() < 1e-6, "{all}");
    // As documented: divided by the mean share on the way out, nothing is missing.
    assert!((body.values()[0] / (1.0 - gloss) + gloss - 1.0).abs() < 1e-6);
}

#[test]
fn a_strip_along_an_edge_sees_the_wall_with_half_of_its_sky() {
    // However narrow, and whatever else is far longer.
    for width in [1e-6, 1e-10, 1e-14, 1e-15, 1e-16, 1e-20, 1e-30, 1e-44] {
        let there = perpendicular_rectangles(width, 1.0, 1.0);
        assert!((there - 0.5).abs() < 3.0 * width + 3e-7, "{width}: {there}");
        let back = perpendicular_rectangles(1.0, width, 1.0);
        assert!((back - 0.5 * width).abs() <= width * (3.0 * width + 3e-7), "{width}: {back}");
    }
    // Endless to two sides: by the crossed strings (1 + h - root(1 + h^2)) / 2.
    for edge in [1e9, 1e20, 3e38] {
        let endless = perpendicular_rectangles(1.0, 1.0, edge);
        assert!((endless - 0.292_893).abs() < 1e-6, "{edge}: {endless}");
    }
    // Endlessly high: as of ten million times the width.
    let high = perpendicular_rectangles(1.0, 1e6, 1.0);
    for height in [1e8, 1e15, 1e20, 3e38] {
        assert!((perpendicular_rectangles(1.0, height, 1.0) / high - 1.0).abs() < 1e-6, "{height}");
    }
    assert_eq!(perpendicular_rectangles(1.0, 1.0, 0.0), 0.0);
    assert!(perpendicular_rectangles(1e-20, 1.0, f32::NAN).is_nan());
    assert!(perpendicular_rectangles(1e-20, f32::NAN, 1.0).is_nan());
}

#[test]
fn far_lamps_keep_the_digits_of_their_light() {
    for (intensity, distance) in [(3e27f32, 2e19f32), (1e38, 1e20), (1.0, 1e10), (1e-30, 1e-25)] {
        let exact = f64::from(intensity) / f64::from(distance).powi(2);
        let near = |lux: Lux| (f64::from(lux.value().0) / exact - 1.0).abs() < 5e-7;
        let at = Candela::from(intensity).at_distance(distance, 1.0);
        assert!(near(at), "{intensity} cd at {distance} m: {at} for {exact:e}");
        let lamp = PointSource { position_m: [0.0, 0.0, distance], intensity: Candela::from(intensity) };
        let there = lamp.irradiance([0.0; 3], [0.0, 0.0, 1.0]);
        assert!(near(there), "{intensity} cd at {distance} m: {there} for {exact:e}");
        // At its own place it has no direction.
        assert_eq!(lamp.irradiance(lamp.position_m, [0.0, 0.0, 1.0]), Lux::NONE);
    }
}

#[test]
fn the_hemisphere_gathers_radiance_into_irradiance() {
    // The sky of a thousand rings, where plain addition would show: pi L.
    let even = Lux::gathered(&Uniform::<1000, 100>, |_| Nit::from(1000.0));
    assert!((even.value().0 / (1000.0 * PI) - 1.0).abs() < 3e-7, "{even}");
    // Brighter towards the zenith, in 16 bands: 2 pi / 3 of it.
    let bands = Light::<16>::from_bins(std::array::from_fn(|k| 1.0 + k as f32));
    let sky = |wi: Direction| Radiance::new(bands) * wi.cos_theta();
    let all: Irradiance<Light<16>> = Irradiance::gathered(&GaussLegendre::<4, 2>, sky);
    for (got, band) in all.value().values().iter().zip(bands.values()) {
        assert!((got / (band * 2.0 * PI / 3.0) - 1.0).abs() < 3e-7, "{got} {band}");
    }
    assert!(Lux::gathered(&GaussLegendre::<4, 2>, |_| Nit::from(f32::NAN)).value().0.is_nan());
}
