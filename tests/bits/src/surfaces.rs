//! Geometry, surfaces, films and volumes.

use super::hash::{Hash, Random};
use nanospectra::geometry::{Cosine, Direction, Frame};
use nanospectra::matter::{
    Absorber, Brdf, Burley, BurleyFit, Conductor, Dielectric, Dipole, Glass, Layer, Medium, Microfacet,
    N_BK7, OrenNayar, PowerShares, Slab, Stack, ThinFilm, TrowbridgeReitz, VisibleNormals,
    rayleigh_cross_section, scattering,
};
use nanospectra::radiometry::{form_factor, solid_angle};
use nanospectra::{Reflectance, Spectrum};

pub fn run(report: &mut impl FnMut(&str, u32)) {
    report("geometry", Hash::of(geometry));
    report("surfaces", Hash::of(surfaces));
    report("films", Hash::of(films));
    report("volumes", Hash::of(volumes));
}

fn geometry(hash: &mut Hash) {
    let mut random = Random(0x5eed_9e00);
    for _ in 0..64 {
        let [a, b, c] = random.bins::<3>().map(|unit| 0.01 + 3.0 * unit);
        hash.all(&[solid_angle::cone(a), solid_angle::sphere(a, a + b), solid_angle::disk_off_axis(a, b, c)]);
        hash.one(solid_angle::triangle([0.0; 3], [random.bins(), random.bins(), [a, b, c]]));
        hash.all(&[solid_angle::rectangle(a, b, c), form_factor::coaxial_disks(a, b, c)]);
        hash.all(&[
            form_factor::parallel_rectangles(a, b, c),
            form_factor::perpendicular_rectangles(a, b, c),
        ]);
        let direction = Direction::spherical(a, b);
        hash.all(&direction.to_array());
        hash.all(&[direction.theta_rad(), direction.phi_rad()]);
        hash.all(&direction.refracted(0.5 + c).map_or([0.0; 3], Direction::to_array));
        let (normal, tangent) = ([a - 1.5, b - 1.5, c - 1.5], [c, a, -b]);
        for frame in [Frame::from_normal(normal), Frame::with_tangent(normal, tangent)].into_iter().flatten()
        {
            frame.axes().iter().for_each(|axis| hash.all(axis));
            hash.all(&frame.to_world(direction));
            hash.all(&frame.towards(normal, tangent).map_or([0.0; 3], Direction::to_array));
        }
    }
}

fn surfaces(hash: &mut Hash) {
    let mut random = Random(0x5eed_5f0f);
    for _ in 0..32 {
        let [cosine, turns, share, eta, k] = random.bins();
        let (glass, metal) = (Dielectric::new(0.5 + 2.0 * eta), Conductor::new(2.0 * eta, 6.0 * k));
        for side in [glass.fresnel(cosine), metal.fresnel(cosine), metal.entering(cosine)] {
            hash.all(&[side.s, side.p]);
        }
        let turned = metal.amplitudes(cosine).retardation();
        hash.all(&[turned.re, turned.im, N_BK7.index(300.0 + 700.0 * share).unwrap_or(0.0)]);
        let (wo, wi) = (Direction::from_cosine(cosine, turns), Direction::from_cosine(share, k));
        let rough = Microfacet { facets: TrowbridgeReitz::new(0.02 + share), boundary: metal };
        hash.all(&[rough.f(wo, wi), OrenNayar::new(share, k).f(wo, wi)]);
        hash.one(scattering::rho_hd(&rough, wo, &VisibleNormals::<4, 4>));
        hash.one(scattering::rho_hd(&OrenNayar::new(share, k), wo, &Cosine::<4, 8>));
    }
}

fn films(hash: &mut Hash) {
    let mut random = Random(0x5eed_f115);
    for _ in 0..8 {
        let [cosine, thickness, index, metal, k] = random.bins();
        for reach in [1e2, 1e4, 1e6] {
            let film = ThinFilm::new([1.0, 1.2 + index, 1.5 * metal + 0.8], reach * thickness);
            let bins: Reflectance<16> = film.reflectance(cosine);
            hash.all(bins.values());
        }
        let layer = |n: f32, nm: f32| Layer { medium: Medium { n, k: 0.1 * k }, thickness_nm: nm };
        let stack = Stack {
            incident: 1.0,
            layers: [layer(1.3 + index, 300.0 * thickness), layer(1.4 + metal, 200.0)],
            substrate: Medium { n: 1.5, k: 3.0 * metal },
        };
        let PowerShares { reflected, transmitted, absorbed } =
            PowerShares::mean(stack.at(400.0 + 300.0 * k, cosine));
        hash.all(&[reflected, transmitted, absorbed]);
    }
}

fn volumes(hash: &mut Hash) {
    let mut random = Random(0x5eed_0701);
    for _ in 0..16 {
        let plate = Reflectance::<16>::from_bins(random.bins());
        let [path, r, nm] = random.bins();
        if let Ok(wine) = Absorber::from_transmittance(&plate, 0.01 + path) {
            hash.all(wine.transmittance(r).values());
            hash.all(wine.absorbed(r).values());
            let window = Slab { index: Spectrum::flat(1.0 + nm), absorber: wine, thickness_m: path };
            let [s, p] = window.components(r, |shares| shares.transmitted);
            hash.all(s.values());
            hash.all(p.values());
            hash.all(window.reflectance(r).values());
            hash.all(window.absorbed(r).values());
        }
        hash.one(rayleigh_cross_section(300.0 + 700.0 * nm, 360.0));
        let skin = Burley::from_mean_free_path(plate, random.bins(), BurleyFit::Diffuse);
        hash.all(skin.times_radius(r).values());
        hash.all(skin.within(r).values());
        let milk: Dipole<16> = Dipole::new(random.bins(), random.bins(), 1.0 + path);
        hash.all(milk.reflectance().values());
        hash.all(milk.profile(r).values());
    }
}
