//! Calls every run-time step of radiometry, matter and paths in one image.
//!
//! Like `no_panic`, it does not link if one of them can panic.
#![no_std]
#![no_main]

mod without_panic;

use core::hint::black_box;
use nanospectra::geometry::{Cosine, Direction, Frame, GaussLegendre, Uniform};
use nanospectra::matter::{
    Absorber, Brdf, Burley, BurleyFit, Cauchy, Conductor, Dielectric, Dipole, Donaldson, Dye, Glass, Lambert,
    Layer, Medium, Microfacet, Mirror, N_BK7, OrenNayar, Phosphor, Polarizer, Retarder, Slab, Smooth, Stack,
    ThinFilm, TrowbridgeReitz, VisibleNormals, external_reflectance, internal_reflectance,
    internal_transmittance, rayleigh_per_m, scattering, stack_bins,
};
use nanospectra::observer::{CIE_1931, Curve, Observer};
use nanospectra::path::{IntoPart, Part, Scene};
use nanospectra::radiometry::{
    DiskSource, PointSource, Radiance, RectangleSource, SphereSource, SurfaceElement, SurfaceRadiance,
    form_factor, solid_angle,
};
use nanospectra::sensor::{DeadTime, Nonlinearity};
use nanospectra::{Light, Power, Reflectance, Spectrum};
use nanospectra_firmware::vest::VEST;

static EYE: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);

#[nanospectra_firmware::entry]
fn main() -> ! {
    loop {
        paths();
        scenes();
        geometry();
        surfaces();
        films_and_volumes();
    }
}

/// Sends light along a path with every kind of matter.
fn paths() {
    let sun = Light::<31>::flat(black_box(1.0));
    let (gray, dye) = (Reflectance::flat(black_box(0.4)), black_box(&VEST));
    let matrix: Donaldson<31, 496> = Donaldson::from_dye(dye);
    let mut phosphor = Phosphor::new(*dye, black_box(1.0));
    phosphor.step(sun.through(&gray), black_box(0.1));
    black_box(EYE.sees(sun.through(&gray).onto(dye).onto(&matrix).onto(&phosphor)));
    let lake = Mirror::dielectric(&black_box([1.33; 31]), black_box(0.5), black_box(0.1));
    let (sheet, plate) = (Polarizer::new(&gray, &gray, black_box(0.2)), Retarder::flat(black_box(0.2), 0.1));
    let light = sun.polarized().onto(&lake).through(&plate).through(&gray).through(&sheet);
    black_box((light.stokes_at(black_box(7)), EYE.sees(light.onto(dye))));
    let coarse: Dye<16> = dye.resample();
    black_box(Light::<16>::flat(1.0).onto(&coarse).collected().values());
    black_box((
        DeadTime::new(black_box(1e-6)).arrived(1e5),
        Nonlinearity::new(black_box([-0.1])).map(|b| b.signal(0.5)),
    ));
}

/// Builds a scene at run time, follows light through it, folds it into an observer and leaves out effects.
fn scenes() {
    let (sun, gray) = (Light::<31>::flat(black_box(1.0)), Reflectance::flat(black_box(0.4)));
    let (matrix, sheet) = (Donaldson::<31, 496>::from_dye(&VEST), Polarizer::ideal(black_box(0.2)));
    let (lake, plate) = (Mirror::dielectric(&[1.33; 31], 0.5, 0.1), Retarder::flat(black_box(0.2), 0.1));
    let mut scene: Scene<31, 8> = Scene::new();
    let parts = [
        Part::Filter(&gray),
        Part::Surface(&gray),
        (&VEST).into_part(),
        (&matrix).into_part(),
        (&lake).into_part(),
    ];
    for part in parts.into_iter().chain([(&plate).into_part(), (&sheet).into_part()]) {
        black_box(scene.push(part).is_ok());
    }
    let scene = black_box(scene);
    black_box((scene.leaving(&sun).is_ok(), scene.fold(&EYE).is_ok(), scene.fold_polarized(&EYE).sees(&sun)));
    let found = scene.within_budget(&EYE, &sun, black_box(1.0));
    black_box((found.delta_e, found.scene.left_out().count(), found.scene.price(), scene.folded_price(3)));
}

/// Computes quantities of radiometry, and the geometry between a source and a point.
fn geometry() {
    let [a, b, c] = black_box([1.0, 2.0, 0.5]);
    let [p, q, r, n] = black_box([[0.0, 0.0, 2.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.1, 1.0]]);
    black_box((solid_angle::cone(a), solid_angle::sphere(a, b), solid_angle::disk_off_axis(a, b, c)));
    black_box((
        solid_angle::disk(a, b),
        solid_angle::rectangle(a, b, c),
        solid_angle::triangle(n, [p, q, r]),
    ));
    black_box((form_factor::coaxial_disks(a, b, c), form_factor::parallel_rectangles(a, b, c)));
    black_box((form_factor::perpendicular_rectangles(a, b, c), form_factor::reciprocal(a, b, c)));
    let spectral = Radiance::new(Light::<31>::flat(b));
    let panel = RectangleSource { corner_m: p, edges_m: [q, r], radiance: spectral };
    let globe = SphereSource { position_m: p, radius_m: c, radiance: spectral };
    let lamp = PointSource { position_m: p, intensity: spectral.intensity(a, c) };
    let disk = DiskSource { radius_m: c, radiance: spectral };
    let together =
        panel.irradiance(n, n) + globe.irradiance(n, n) + lamp.irradiance(n, n) + disk.irradiance(a, b);
    black_box((together.radiant(), together.flux(a).during(b), together.as_exitance().lambertian()));
    black_box(SurfaceElement { position_m: p, normal: n, area_m2: a }.seen_from(q));
    black_box(SurfaceRadiance::free_space(n, |_| spectral).incident(q));
    for frame in [Frame::from_normal(n), Frame::with_tangent(n, q)].into_iter().flatten() {
        let towards = frame.towards(r, p).or(frame.to_local(q));
        black_box((towards.map(|wi| frame.to_world(wi)), frame.axes()));
    }
}

/// Computes surfaces for one wavelength and for all, in one direction and over the hemisphere.
fn surfaces() {
    let [cosine, alpha, turns] = black_box([0.7, 0.2, 0.3]);
    let (wo, wi) = (Direction::from_cosine(cosine, turns), Direction::spherical(alpha, cosine));
    black_box((
        wo.theta_rad(),
        wo.phi_rad(),
        wo.refracted(cosine),
        Direction::from_vector([cosine, alpha, turns]),
    ));
    let (glass, gold) = (Dielectric::new(1.0 + cosine), Conductor::new(alpha, 3.0 * cosine));
    black_box((glass.fresnel(cosine), glass.entering(cosine), glass.amplitudes(cosine)));
    black_box((gold.fresnel(cosine), gold.entering(cosine), gold.amplitudes(cosine).retardation()));
    black_box((
        N_BK7.index(600.0 * cosine),
        Cauchy { a: 1.0 + alpha, b: 4e-3, c: 0.0 }.index(600.0 * cosine),
    ));
    let paint = Reflectance::<31>::flat(cosine);
    black_box((
        scattering::rho_hd(&Lambert(paint), wo, &Cosine::<4, 8>),
        OrenNayar::new(paint, alpha).f(wo, wi),
    ));
    let rough = Microfacet { facets: TrowbridgeReitz::new(alpha), boundary: gold };
    black_box((rough.f(wo, wi), scattering::rho_hd(&rough, wo, &VisibleNormals::<8, 8>)));
    black_box(scattering::white_furnace(&rough, &GaussLegendre::<4, 8>, &VisibleNormals::<4, 4>));
    black_box((scattering::reciprocity(&rough, &Uniform::<4, 8>), Smooth(glass).0.fresnel(cosine)));
}

/// Computes interference, absorption and scattering.
fn films_and_volumes() {
    let [cosine, nm, share] = black_box([0.7, 550.0, 0.3]);
    let soap: Reflectance<31> = ThinFilm::new([1.0, 1.0 + share, 1.0], nm).reflectance(cosine);
    let stack = Stack {
        incident: 1.0,
        layers: [Layer { medium: Medium { n: 1.0 + share, k: 0.0 }, thickness_nm: nm }; 2],
        substrate: Medium { n: 1.5, k: share },
    };
    black_box((soap, stack.at(nm, cosine)));
    let bins: [Reflectance<31>; 2] = stack_bins(|_| stack, cosine, 2, |shares| shares.reflected);
    black_box((bins, external_reflectance(1.0 + share), internal_reflectance(1.0 + share)));
    if let Ok(wine) = Absorber::<31>::from_transmittance(&soap, share) {
        black_box((
            wine.transmittance(cosine),
            wine.absorbed(cosine),
            Absorber::<31>::air(),
            rayleigh_per_m(nm),
        ));
    }
    let index = Spectrum::flat(1.0 + share);
    black_box(internal_transmittance(&soap, &index).is_ok());
    if let Ok(window) = Slab::from_transmittance(&soap, index, share) {
        black_box((window.reflectance(cosine), window.transmittance(cosine), window.absorbed(cosine)));
        black_box(window.components(cosine, |shares| shares.transmitted));
    }
    let skin: Burley<31> = Burley::from_mean_free_path(soap, [share; 31], BurleyFit::Diffuse);
    let milk: Dipole<31> = Dipole::new([share; 31], [nm; 31], 1.0 + share);
    black_box((skin.times_radius(share), skin.within(share), milk.profile(share), milk.reflectance()));
}
