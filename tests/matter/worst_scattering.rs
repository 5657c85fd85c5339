//! That the documented bounds of rough surfaces, of what scatters and of what glows hold at the worst that a
//! search finds.
#![cfg(feature = "libm")]

use model::geometry::{gauss, integral};
use model::search::{Range::*, units, worst};
use model::surface;
use nanospectra::geometry::Direction;
use nanospectra::matter::{Brdf, Dipole, Dye, OrenNayar, Phosphor, internal_reflectance};
use nanospectra::{Bins, Light, Reflectance};
use std::f64::consts::PI;

const STEPS: usize = 2000;

type One = Bins<500, 510>;
type Two = Bins<400, 600>;

/// The model's formulas by the sines, which the square of the cosine would lose near the normal.
fn matt(albedo: f64, roughness: f64, directions: [Direction; 2]) -> f64 {
    let [wo, wi] = directions.map(|w| {
        let w = w.to_array().map(f64::from);
        w.map(|part| part / surface::dot(w, w).sqrt())
    });
    let (grazing, mean_lost) = (0.5 - 2.0 / (3.0 * PI), 2.0 / 3.0 - 28.0 / (15.0 * PI));
    let flat = 1.0 / (1.0 + grazing * roughness);
    let towards = wo[0] * wi[0] + wo[1] * wi[1];
    let shape = if towards > 0.0 { towards / wo[2].max(wi[2]) } else { towards };
    let mean = flat * (1.0 + mean_lost * roughness);
    let multiple = albedo * albedo * mean / (1.0 - albedo * (1.0 - mean));
    let lost = |w: surface::Vector| {
        let (sine, cosine) = (w[0].hypot(w[1]), w[2]);
        let cubes = cosine * (1.0 + sine + sine * sine) / (1.0 + sine);
        let gained = sine * (sine.atan2(cosine) - sine * cosine) + 2.0 / 3.0 * (sine * cubes - sine);
        grazing - gained / PI
    };
    let once = albedo * flat * (1.0 + roughness * shape);
    (once + multiple * flat * roughness * lost(wo) * lost(wi) / (grazing - mean_lost)) / PI
}

#[test]
fn rough_matt_surfaces_are_as_exact_as_promised() {
    let [share, turns, cosine] = [Even(0.0, 1.0), Even(0.0, 1.0), Sizes(1e-6, 1.0)];
    for (seed, cosine) in [(1, cosine), (2, Even(1e-6, 1.0))] {
        worst(seed, STEPS, [share, share, cosine, turns, cosine, turns], |[albedo, rough, o, at, i, to]| {
            let directions = [Direction::from_cosine(o, at), Direction::from_cosine(i, to)];
            let [wo, wi] = directions;
            let found = f64::from(OrenNayar::new(albedo, rough).f(wo, wi));
            let larger = f64::from(wo.cos_theta()).max(wi.cos_theta().into());
            (found - matt(albedo.into(), rough.into(), directions)).abs() * larger
        })
        .is_what_is_promised("rough matt surfaces, over the larger cosine", 1.5e-7);
    }
}

/// The mean of Fresnel's reflectance from inside, by reciprocity.
fn inside(nodes: &[(f64, f64)], eta: f64) -> f64 {
    let outside = integral(nodes, 0.0, 1.0, |t| {
        // Gathers at grazing angles.
        let cos = t.powi(3);
        let (sine2, excess) = ((1.0 - cos) * (1.0 + cos), (eta - 1.0) * (eta + 1.0));
        let g = (excess + cos * cos).sqrt();
        let s = excess / (cos + g).powi(2);
        let p = s * (cos * g - sine2) / (cos * g + sine2);
        (s * s + p * p) * cos * 3.0 * t * t
    });
    1.0 - (1.0 - outside) / (eta * eta)
}

#[test]
fn dipoles_are_as_exact_as_promised() {
    let (nodes, sigma) = (gauss(40), Sizes(1e-6, 1e6));
    let mismatch = |eta: f32| {
        let inside = inside(&nodes, eta.into());
        (1.0 + inside) / (1.0 - inside)
    };
    for (what, eta, bound) in
        [("from 1.2 on", Even(1.2, 3.0), 5e-7), ("below 1.2", Even(1.000_001, 1.2), 2.5e-5)]
    {
        worst(1, STEPS / 2, [sigma, sigma, eta], |[absorption, scattering, eta]| {
            let [a, s] = [absorption, scattering].map(f64::from);
            let root = (3.0 * a / (a + s)).sqrt();
            let exact = 0.5 * s / (a + s) * (1.0 + (-4.0 / 3.0 * mismatch(eta) * root).exp()) * (-root).exp();
            let found = Dipole::<1, One>::new([absorption], [scattering], eta).reflectance()[0];
            (f64::from(found) - exact).abs()
        })
        .is_what_is_promised(&format!("reflectance of dipoles {what}"), bound);
    }
    worst(
        2,
        STEPS / 2,
        [sigma, sigma, Even(1.2, 3.0), Sizes(1e-9, 1e9)],
        |[absorption, scattering, eta, r]| {
            let [a, s, r64] = [absorption, scattering, r].map(f64::from);
            let extinction = a + s;
            let transport = (3.0 * a * extinction).sqrt();
            let source = |z: f64| {
                let d = r64.hypot(z);
                z * (1.0 + transport * d) * (-transport * d).exp() / (d * d * d)
            };
            // With the reflectance from inside as f32 has it.
            let inside = f64::from(internal_reflectance(eta));
            let image = (1.0 + 4.0 / 3.0 * (1.0 + inside) / (1.0 - inside)) / extinction;
            let exact = s / extinction / (4.0 * PI) * (source(1.0 / extinction) + source(image));
            let found = Dipole::<1, One>::new([absorption], [scattering], eta).profile(r)[0];
            if exact < 1e-37 * extinction.powi(2).max(1.0) || exact > 3e38 {
                return if found.is_nan() { f64::NAN } else { -1.0 };
            }
            units(found, exact) / (5.0 * transport * r64 + 20.0)
        },
    )
    .is_what_is_promised("profile of dipoles, in (5 path + 20) units", 1.0);
}

#[test]
fn afterglow_is_as_exact_as_promised() {
    let (reflects, absorbs) = (Reflectance::<2, Two>::flat(0.5), Reflectance::from_bins([0.5, 0.0]));
    let dye = || Dye::new(&reflects, &absorbs, &Light::from_bins([0.0, 1.0]), 0.9).expect("a dye");
    // 6e-8 of the glow that is left, times this and the number of lifetimes: in the dark, and under a light.
    for (what, lit, constant) in [("in the dark", 0.0, 2.0), ("under a light", 1.0, 5.0)] {
        for (seed, times) in [(1, Sizes(1e-9, 0.5)), (2, Sizes(0.5, 80.0)), (3, Sizes(1e-3, 1.0))] {
            let light = Sizes(1e-3, 1e3);
            let found = worst(
                seed,
                STEPS,
                [Sizes(1e-6, 1e6), times, light, light],
                |[life, times, before, after]| {
                    let mut paint = Phosphor::new(dye(), life);
                    paint.step(&Light::flat(before), f32::INFINITY);
                    let (glow, light) = (f64::from(paint.glow()), Light::flat(lit * after));
                    let target = f64::from(paint.dye().glow_under(&light));
                    paint.step(&light, life * times);
                    let times = f64::from(life * times) / f64::from(life);
                    let exact = glow * (-times).exp() - target * (-times).exp_m1();
                    (f64::from(paint.glow()) / exact - 1.0).abs() / 6e-8 / (constant + times)
                },
            );
            found.is_what_is_promised(&format!("afterglow {what}"), 1.0);
        }
    }
}
