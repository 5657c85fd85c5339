//! The quantities of radiometry, their relations, and sources of simple shapes.
#![cfg(feature = "libm")]

use nanospectra::light::{D65, FL11};
use nanospectra::observer::{V_PHOTOPIC, V_SCOTOPIC};
use nanospectra::radiometry::solid_angle::{WHOLE_SPHERE, cone};
use nanospectra::radiometry::{
    Candela, DiskSource, Energy, Exitance, Flux, Intensity, Irradiance, Lumen, Luminous, Lux, Nit,
    PointSource, Radiance, Radiant, RectangleSource, Scotopic, SphereSource, SurfaceRadiance, Talbot,
    illuminance, scotopic_illuminance,
};
use nanospectra::{Bins, Curve, Fine, Light, Observer, Power, Reflectance};
use std::f64::consts::PI;

#[test]
fn lumens_are_watts_by_683_and_the_eye() {
    // 1 W at the peak of vision, in every quantity.
    let mut green = Fine::flat(0.0);
    assert_eq!(green.add_line(555.0, 1.0), 0.0);
    assert_eq!(Energy::new(green).luminous(), Talbot::from(683.002));
    assert_eq!(Flux::new(green).luminous(), Lumen::from(683.002));
    assert_eq!(Intensity::new(green).luminous(), Candela::from(683.002));
    assert_eq!(Irradiance::new(green).luminous(), Lux::from(683.002));
    assert_eq!(Exitance::new(green).luminous(), Exitance::from(683.002));
    assert_eq!(Radiance::new(green).luminous(), Nit::from(683.002));
    assert_eq!(Flux::new(green).radiant(), Flux::new(Radiant(1.0)));
    let mut blue_green = Fine::flat(0.0);
    assert_eq!(blue_green.add_line(507.0, 1.0), 0.0);
    assert_eq!(Flux::new(blue_green).scotopic(), Flux::new(Scotopic(1700.0)));

    // The same numbers as the functions for bare spectra.
    for lamp in [FL11.fine(), D65.fine()] {
        let e = Irradiance::new(lamp);
        assert_eq!(e.luminous().value().0, illuminance(&lamp));
        assert_eq!(e.scotopic().value().0, scotopic_illuminance(&lamp));
        assert_eq!(e.radiant().value().0, lamp.power());
    }
}

#[test]
fn folded_eyes_of_any_size_count_the_same_lumens() {
    fn lumens<const N: usize>() -> Lumen {
        let v: Observer<1, N, Power> = V_PHOTOPIC.fold(Curve::Step);
        Flux::new(Light::<N>::flat(0.01)).luminous_by(&v)
    }
    // A flat light reads the same through every fold; what lies beyond 380..=730 nm is in the end bins.
    let whole = Flux::new(Fine::flat(0.01)).luminous().value().0;
    for lm in [lumens::<1>(), lumens::<2>(), lumens::<16>(), lumens::<31>(), lumens::<81>()] {
        assert!((lm.value().0 / whole - 1.0).abs() < 6e-7, "{lm}, {whole}");
    }
    let v: Observer<1, 16, Power, Bins<360, 830>> = V_SCOTOPIC.fold(Curve::Spline);
    let scotopic = Radiance::new(Light::<16, Bins<360, 830>>::flat(0.01)).scotopic_by(&v);
    let whole = Radiance::new(Fine::flat(0.01)).scotopic();
    assert!((scotopic.value().0 / whole.value().0 - 1.0).abs() < 6e-7, "{scotopic} {whole}");
}

#[test]
fn quantities_say_their_unit() {
    let spectral = <Irradiance<Light<16>>>::UNIT;
    let units = [<Irradiance<Radiant>>::UNIT, Lux::UNIT, <Irradiance<Scotopic>>::UNIT, spectral];
    assert_eq!(units, ["W/m2", "lx", "scotopic lx", "W/(m2 nm)"]);
    assert_eq!([Talbot::UNIT, Lumen::UNIT, Candela::UNIT, Nit::UNIT], ["lm s", "lm", "cd", "cd/m2"]);
    assert_eq!([<Exitance<Luminous>>::UNIT, <Exitance<Radiant>>::UNIT], ["lm/m2", "W/m2"]);
    assert_eq!(Lux::from(1.0 / 3.0).to_string(), format!("{} lx", 1.0f32 / 3.0));
    assert_eq!(format!("{:.1}", Energy::new(Radiant(2.25))), "2.2 J");
    assert_eq!(std::mem::size_of::<Irradiance<Light<16>>>(), 64);
}

#[test]
fn quantities_add_and_scale_like_what_they_carry() {
    let (a, b) = (Lux::from(3.0), Lux::from(1.5));
    assert_eq!((a + b, a - b, a * 2.0, a / 2.0), (4.5.into(), 1.5.into(), 6.0.into(), 1.5.into()));
    assert_eq!([a, b, b].into_iter().sum::<Lux>(), Lux::from(6.0));
    assert_eq!(Vec::<Lux>::new().into_iter().sum::<Lux>(), Lux::NONE);
    assert!(b < a);
    // A spectrum as a whole, and through a filter.
    let e = Irradiance::new(Light::<16>::flat(2.0));
    let halved = Irradiance::new(Light::flat(1.0));
    assert_eq!((e / 2.0, e * Reflectance::flat(0.5), e - halved), (halved, halved, halved));
}

#[test]
fn relations_lead_there_and_back() {
    let phi = Lumen::from(1200.0);
    assert_eq!(phi.during(60.0), Talbot::from(72_000.0));
    assert_eq!(phi.during(60.0).over(60.0), phi);
    assert_eq!(phi.irradiance(4.0), Lux::from(300.0));
    assert_eq!(phi.irradiance(4.0).flux(4.0), phi);
    assert_eq!(phi.exitance(4.0).flux(4.0), phi);
    assert_eq!(phi.intensity(2.0).flux(2.0), phi);
    let i = Candela::from(100.0);
    assert_eq!(i.at_distance(10.0, 1.0), Lux::from(1.0), "inverse square");
    // 100 cd from a tenth of a square meter at 60 degrees: 2000 cd/m2, and back by Lambert's cosine law.
    assert_eq!(i.radiance(0.1, 0.5), Nit::from(2000.0));
    assert_eq!(i.radiance(0.1, 0.5).intensity(0.1, 0.5), i);
    let l = Nit::from(1e4);
    assert_eq!(l.irradiance(0.01, 0.5), Lux::from(50.0));
    assert_eq!(l.irradiance(0.01, 0.5).radiance(0.01, 0.5), l);
    assert!((l.exitance().value().0 - 31_415.926).abs() < 0.01, "pi L");
    assert!((l.exitance().lambertian().value().0 - 1e4).abs() < 2e-3);
    // A small distant source is a point whose intensity is L A cos.
    let (far, area) = (100.0f32, 0.01);
    let by_radiance = l.irradiance(area * 0.5 / (far * far), 0.8);
    let by_intensity = l.intensity(area, 0.5).at_distance(far, 0.8);
    assert!((by_radiance.value().0 / by_intensity.value().0 - 1.0).abs() < 3e-7);
    // An isotropic source lights every sphere about it with all its flux.
    let e = phi.intensity(WHOLE_SPHERE).at_distance(3.0, 1.0);
    assert!((e.flux(WHOLE_SPHERE * 9.0).value().0 / 1200.0 - 1.0).abs() < 3e-7);
}

#[test]
fn the_cosine_counts_once() {
    // A beam of 1 W/m2 across the ray. A plate of 1 m2 at 60 degrees catches half a watt, and its irradiance
    // is that over its area: the cosine is in the flux, and not a second time in E = dPhi / dA.
    let beam = Irradiance::new(Radiant(1.0));
    let caught = beam.flux(0.5);
    assert_eq!(caught.irradiance(1.0), Irradiance::new(Radiant(0.5)));
    // The same by radiance: L cos dw.
    let (solid_angle, radiance) = (0.001, Radiance::new(Radiant(1000.0)));
    assert_eq!(radiance.irradiance(solid_angle, 1.0), beam);
    assert_eq!(radiance.irradiance(solid_angle, 0.5), caught.irradiance(1.0));
    // A uniform sky gives pi L: its cosine, over the hemisphere, integrates to pi and not to 2 pi.
    let steps = 20_000;
    let ring = |k: i32| {
        let cos = (k as f32 + 0.5) / steps as f32;
        radiance.irradiance(std::f32::consts::TAU / steps as f32, cos).value().0
    };
    let sky: f64 = (0..steps).map(|k| f64::from(ring(k))).sum();
    assert!((sky / (1000.0 * PI) - 1.0).abs() < 1e-6, "{sky}");
}

#[test]
fn nothing_comes_from_behind() {
    let (i, l) = (Candela::from(5.0), Nit::from(5.0));
    for cos in [0.0, -0.0, -1e-30, -0.5, -1.0] {
        assert_eq!(i.at_distance(1.0, cos), Lux::NONE, "{cos}");
        assert_eq!(i.radiance(1.0, cos), Nit::NONE, "{cos}");
        assert_eq!(l.irradiance(0.1, cos), Lux::NONE, "{cos}");
        assert_eq!(l.intensity(0.1, cos), Candela::NONE, "{cos}");
        assert_eq!(Lux::from(5.0).radiance(0.1, cos), Nit::NONE, "{cos}");
    }
    assert!(
        i.at_distance(1.0, f32::NAN).value().0.is_nan() && l.irradiance(f32::NAN, 1.0).value().0.is_nan()
    );
    // Too near to say: large, and of no light still none.
    assert_eq!(Candela::from(1.0).at_distance(0.0, 1.0), Lux::from(f32::MAX));
    assert_eq!(Candela::NONE.at_distance(0.0, 1.0), Lux::NONE);
}

#[test]
fn radiance_at_a_surface_is_a_limit_from_the_side_of_the_direction() {
    let l = |v: f32| Radiance::new(Radiant(v));
    // A mirror-like sheet: different light travels up and down, above and below it.
    let sheet = SurfaceRadiance {
        normal: [0.0, 0.0, 2.0],
        above: |[_, _, z]: [f32; 3]| l(if z > 0.0 { 1.0 } else { 2.0 }),
        below: |[_, _, z]: [f32; 3]| l(if z > 0.0 { 3.0 } else { 4.0 }),
    };
    let (up, down) = ([0.6, 0.0, 0.8], [0.6, 0.0, -0.8]);
    assert_eq!((sheet.exitant(up), sheet.incident(up)), (l(1.0), l(2.0)));
    assert_eq!((sheet.exitant(down), sheet.incident(down)), (l(4.0), l(3.0)));
    assert_eq!(sheet.incident([1.0, 0.0, 0.0]), Radiance::NONE);
    assert!(sheet.incident([f32::NAN, 0.0, 0.0]).value().0.is_nan());

    // In free space Lo(p, w) = Li(p, -w), whatever plane is laid through it.
    let field = |w: [f32; 3]| l(2.0 + w[0] + 0.5 * w[1] - 0.25 * w[2]);
    for normal in [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.3, -0.7, 0.1]] {
        let free = SurfaceRadiance::free_space(normal, field);
        for w in [up, down, [-0.6, 0.79, 0.1]] {
            assert_eq!(free.exitant(w), field(w));
            assert_eq!(free.exitant(w), free.incident(w.map(|x| -x)), "{normal:?} {w:?}");
        }
    }
}

#[test]
fn sources_give_what_their_shapes_say() {
    let l = Nit::from(1000.0);
    // A disk, a polygon of many corners, a sphere of the same outline and a point agree from far away.
    let (r, d) = (0.01f32, 10.0);
    let area = std::f32::consts::PI * r * r;
    let point = PointSource { position_m: [0.0, 0.0, d], intensity: l.intensity(area, 1.0) };
    let globe = SphereSource { position_m: [0.0, 0.0, d], radius_m: r, radiance: l };
    let disk = DiskSource { radius_m: r, radiance: l };
    let side = area.sqrt();
    let panel = RectangleSource {
        corner_m: [-0.5 * side, -0.5 * side, d],
        edges_m: [[0.0, side, 0.0], [side, 0.0, 0.0]],
        radiance: l,
    };
    let up = [0.0, 0.0, 1.0];
    let expected = point.irradiance([0.0; 3], up).value().0;
    for lux in [globe.irradiance([0.0; 3], up), disk.irradiance(d, 0.0), panel.irradiance([0.0; 3], up)] {
        assert!((lux.value().0 / expected - 1.0).abs() < 2e-6, "{lux} {expected}");
    }
    // Tilted: 60 degrees halve it, behind is nothing.
    let tilted = [0.75f32.sqrt(), 0.0, 0.5];
    for lux in [
        point.irradiance([0.0; 3], tilted),
        globe.irradiance([0.0; 3], tilted),
        panel.irradiance([0.0; 3], tilted),
    ] {
        assert!((lux.value().0 / expected - 0.5).abs() < 2e-6, "{lux} {expected}");
    }
    let down = [0.0, 0.0, -1.0];
    assert_eq!(point.irradiance([0.0; 3], down), Lux::NONE);
    assert_eq!(globe.irradiance([0.0; 3], down), Lux::NONE);
    assert_eq!(panel.irradiance([0.0; 3], down), Lux::NONE);
    assert_eq!(panel.irradiance([0.0, 0.0, 20.0], down), Lux::NONE, "from behind the panel");
    // Within a luminous sphere, every way: pi L.
    for normal in [up, down, tilted] {
        let inside = globe.irradiance([0.0, 0.001, d], normal).value().0;
        assert!((inside / (1000.0 * std::f32::consts::PI) - 1.0).abs() < 1e-6, "{inside}");
    }
    // What is spectral stays spectral, bin by bin.
    let spectral =
        SphereSource { radiance: Radiance::new(Light::<3>::from_bins([1000.0, 0.0, 500.0])), ..coded(globe) };
    let [a, b, c] = *spectral.irradiance([0.0; 3], up).value().values();
    assert_eq!((a, b, c), (globe.irradiance([0.0; 3], up).value().0, 0.0, 0.5 * a));
}

/// The same sphere, carrying a spectrum.
fn coded(globe: SphereSource<Luminous>) -> SphereSource<Light<3>> {
    let SphereSource { position_m, radius_m, .. } = globe;
    SphereSource { position_m, radius_m, radiance: Radiance::NONE }
}

#[test]
fn a_cone_of_sky_gives_its_form_factor() {
    // A Lambertian cap of half angle t about the zenith: E = pi L sin^2 t, here as rings of cones.
    let (l, half_angle) = (Radiance::new(Radiant(10.0)), 0.7f32);
    let steps = 2000;
    let mut e = Irradiance::NONE;
    for k in 0..steps {
        let [inner, outer] = [k, k + 1].map(|k| half_angle * k as f32 / steps as f32);
        e += l.irradiance(cone(outer) - cone(inner), (0.5 * (inner + outer)).cos());
    }
    let expected = 10.0 * PI * f64::from(half_angle).sin().powi(2);
    assert!((f64::from(e.value().0) / expected - 1.0).abs() < 1e-5, "{e} {expected}");
}
