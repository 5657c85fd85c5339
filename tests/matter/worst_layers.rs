//! That the documented bounds of slabs, films, mirrors and air hold at the worst that a search finds.
#![cfg(feature = "libm")]

use model::film;
use model::fresnel;
use model::geometry::{gauss, integral};
use model::search::{Range::*, Worst, worst};
use nanospectra::math::Portable;
use nanospectra::matter::{
    Absorber, Layer, Medium, Mirror, PowerShares, Slab, Stack, ThinFilm, external_reflectance,
    internal_reflectance, internal_reflectance_fit, rayleigh_cross_section, stack_bins,
};
use nanospectra::{Bins, Spectrum};
use std::f64::consts::PI;

const STEPS: usize = 2000;

type One = Bins<500, 510>;

/// What a face reflects and what it lets in, of s and of p, and the cosine behind it, without cancellation.
fn face(n: f64, cos: f64) -> [[f64; 3]; 2] {
    if n == 1.0 {
        return [[0.0, 1.0, cos]; 2];
    }
    let square = (n - 1.0) * (n + 1.0) + cos * cos;
    if square <= 0.0 {
        return [[1.0, 0.0, 0.0]; 2];
    }
    let (g, sine2) = (square.sqrt(), (1.0 - cos) * (1.0 + cos));
    let s = (n - 1.0) * (n + 1.0) / (cos + g).powi(2);
    let p = s * if sine2 == 0.0 { 1.0 } else { (cos * g - sine2) / (cos * g + sine2) };
    let entering = [4.0 * cos * g / (cos + g).powi(2), 4.0 * cos * g * n * n / (n * n * cos + g).powi(2)];
    [[s * s, entering[0], g / n], [p * p, entering[1], g / n]]
}

/// The reflected, transmitted and absorbed shares of unpolarized light, by the sums of the geometric series.
fn slab([index, per_m, thickness, cos]: [f32; 4]) -> [f64; 3] {
    let [n, sigma, d, cos] = [index, per_m, thickness, cos].map(f64::from);
    let mut all = [0.0; 3];
    for [r, entering, cos_inside] in face(n, cos) {
        if entering == 0.0 {
            all[0] += 0.5;
            continue;
        }
        let tau = sigma * d / cos_inside;
        let (passed, lost) = ((-tau).exp(), -(-tau).exp_m1());
        // 1 - R tau, and 1 - (R tau)^2.
        let (once, twice) = (entering + r * lost, (entering + r * lost) * (1.0 + r * passed));
        all[0] += 0.5 * (r + entering * entering * passed * passed * r / twice);
        all[1] += 0.5 * entering * entering * passed / twice;
        all[2] += 0.5 * entering * lost / once;
    }
    all
}

#[test]
fn slabs_are_as_exact_as_promised() {
    let found = |[index, per_m, thickness, cos]: [f32; 4]| {
        let absorber = Absorber::<1, One>::from_per_m([per_m]).expect("a coefficient");
        let slab = Slab { index: Spectrum::flat(index), absorber, thickness_m: thickness };
        [slab.reflectance(cos)[0], slab.transmittance(cos)[0], slab.absorbed(cos)[0]].map(f64::from)
    };
    let off = |at: [f32; 4]| {
        let (found, exact) = (found(at), slab(at));
        [0, 1, 2].map(|k: usize| (found[k] - exact[k]).abs())
    };
    let [per_m, thick] = [Sizes(1e-6, 1e6), Sizes(1e-6, 1.0)];
    let dense = [Sizes(1.0, 30.0), per_m, thick, Even(0.0, 1.0)];
    worst(1, STEPS, dense, |at| off(at)[0].max(off(at)[1]))
        .is_what_is_promised("slabs, reflected and transmitted", 5e-7);
    worst(2, STEPS, [Sizes(1.0, 30.0), per_m, thick, Sizes(1e-8, 1.0)], |at| off(at)[2])
        .is_what_is_promised("slabs, absorbed", 2.5e-7);
    worst(3, STEPS, dense, |at| (found(at).iter().sum::<f64>() - 1.0).abs())
        .is_what_is_promised("slabs, all shares", 6e-7);
    // A gap, beside its critical angle.
    worst(4, STEPS, [Sizes(0.3, 1.0), per_m, thick, Even(0.0, 1.0)], |at| {
        off(at).into_iter().fold(0.0, f64::max)
    })
    .is_what_is_promised("gaps", 3e-3);
}

/// The worst error of a mean over 1 to 22 nm, of films of 1 nm to 0.1 mm between these media.
fn means(seed: u64, indices: [f32; 3], cosines: [f32; 2]) -> Worst<4> {
    let (nodes, wide) = (gauss(12), indices.map(f64::from));
    let ranges = [Sizes(1.0, 1e5), Even(380.0, 730.0), Sizes(1.0, 22.0), Even(cosines[0], cosines[1])];
    worst(seed, 300, ranges, |[thickness, low, width, cos]| {
        let high = low + width;
        let [from, to] = [low, high].map(f64::from);
        let fringes = 2.0 * wide[1] * f64::from(thickness) * (1.0 / from - 1.0 / to);
        let panels = 1 + (6.0 * fringes) as usize;
        let piece = (to - from) / panels as f64;
        let mut exact = [0.0; 2];
        for panel in 0..panels {
            for (x, weight) in &nodes {
                let nm = from + piece * (panel as f64 + x);
                let shares = film::airy(wide, thickness.into(), nm, cos.into());
                exact.iter_mut().zip(shares).for_each(|(sum, share)| *sum += weight * share / panels as f64);
            }
        }
        let found = ThinFilm::new(indices, thickness).between_with::<Portable>(low, high, cos);
        let off = found.into_iter().zip(exact).map(|(found, exact)| {
            let [r, t] = [found.reflected, found.transmitted].map(f64::from);
            (r - exact).abs().max((t - (1.0 - exact)).abs())
        });
        off.fold(0.0, |most, off| if off > most || off.is_nan() { off } else { most })
    })
}

#[test]
fn means_over_bins_are_as_exact_as_promised() {
    means(1, [1.0, 1.33, 1.0], [0.6, 1.0]).is_what_is_promised("means of soap", 5e-6);
    let lens = means(1, [1.0, 1.38, 1.52], [0.6, 1.0]);
    assert!(lens.error < 5e-6, "{lens:?}");
    means(1, [1.0, 2.4, 1.52], [0.4, 1.0]).is_what_is_promised("means of titania on glass", 1.5e-5);
    means(1, [1.0, 1.33, 1.0], [0.08, 0.2]).is_what_is_promised("means of soap, grazing", 3e-5);
    means(2, [4.0, 1.0, 4.0], [0.99, 1.0]).is_what_is_promised("means of a Fabry-Perot gap", 3e-5);
}

/// The worst error of a mean over 20 nm of four clear layers on glass or the like, read in so many panels for
/// each fringe.
fn stacks(seed: u64, panels: f64, indices: [f32; 2], cosines: [f32; 2]) -> Worst<10> {
    let (nodes, index) = (gauss(12), Even(indices[0], indices[1]));
    let (thick, cos) = (Even(0.0, 1000.0), Even(cosines[0], cosines[1]));
    let ranges = [index, index, index, index, thick, thick, thick, thick, index, cos];
    worst(seed, 100, ranges, |[a, b, c, d, e, f, g, h, substrate, cos]| {
        let layers = [(a, e), (b, f), (c, g), (d, h)];
        let wide = layers.map(|(n, d)| (film::C(n.into(), 0.0), f64::from(d)));
        let fringes = wide.iter().map(|(n, d)| 2.0 * n.0 * d * (1.0 / 500.0 - 1.0 / 520.0)).sum::<f64>();
        let pieces = 1 + (40.0 * fringes) as usize;
        let mut exact = [0.0; 2];
        for piece in 0..pieces {
            for (x, weight) in &nodes {
                let nm = 500.0 + 20.0 * (piece as f64 + x) / pieces as f64;
                let both = film::stack(1.0, &wide, film::C(substrate.into(), 0.0), nm, cos.into());
                exact.iter_mut().zip(both).for_each(|(sum, [r, _])| *sum += weight * r / pieces as f64);
            }
        }
        let layers = layers.map(|(n, thickness_nm)| Layer { medium: Medium { n, k: 0.0 }, thickness_nm });
        let stack = Stack { incident: 1.0, layers, substrate: Medium { n: substrate, k: 0.0 } };
        let panels = (panels * fringes).ceil() as u16;
        let reflected = |shares: PowerShares| shares.reflected;
        let found = stack_bins::<4, 1, Bins<500, 520>>(|_| stack, cos, panels, reflected);
        let off = |k: usize| (f64::from(found[k][0]) - exact[k]).abs();
        off(0).max(off(1))
    })
}

#[test]
fn means_of_stacks_are_as_exact_as_promised() {
    let ([glass, any], [steep, all]) = ([[1.3, 2.4], [1.0, 4.0]], [[0.5, 1.0], [0.05, 1.0]]);
    stacks(4, 10.0, glass, steep).is_what_is_promised("means of glasses, ten panels a fringe", 2.5e-6);
    stacks(1, 10.0, any, all).is_what_is_promised("means of any stack, ten panels a fringe", 0.03);
    stacks(1, 100.0, any, all).is_what_is_promised("means of any stack, a hundred", 7e-6);
}

/// The worst error of a component of light that a mirror of these elements reflects.
fn reflected(mirror: &Mirror<1, One>, [a, b, c, s]: [f64; 4]) -> f64 {
    let lights = [[1.0, 1.0, 0.0, 0.0], [1.0, -1.0, 0.0, 0.0], [1.0, 0.0, 1.0, 0.0], [1.0, 0.0, 0.0, 1.0]];
    let mut most = 0.0f64;
    for light in lights {
        let [i, q, u, v] = light;
        let exact = [a * i + b * q, b * i + a * q, c * u + s * v, c * v - s * u];
        for (got, exact) in mirror.mueller().turn(0, light.map(|x| x as f32)).into_iter().zip(exact) {
            let off = (f64::from(got) - exact).abs();
            most = if off > most || off.is_nan() { off } else { most };
        }
    }
    most
}

#[test]
fn mirrors_are_as_exact_as_promised() {
    // s and p have the same sign at normal incidence.
    let elements = |eta: f32, k: f32, cos: f32| {
        let (s, p) = fresnel::amplitudes([eta.into(), k.into()], cos.into());
        let [a, b] = [s, p].map(fresnel::power);
        let both = fresnel::times(s, [p[0], -p[1]]);
        [0.5 * (a + b), 0.5 * (a - b), -both[0], both[1]]
    };
    let metals = [Even(0.05, 6.0), Even(0.05, 8.0), Even(0.0175, 1.0)];
    worst(1, STEPS, metals, |[eta, k, cos]| {
        let metal = Mirror::conductor(&Spectrum::flat(eta), &Spectrum::flat(k), cos, 0.0);
        reflected(&metal, elements(eta, k, cos))
    })
    .is_what_is_promised("mirrors of metal", 1.8e-6);
    worst(2, STEPS, [Sizes(1.000_001, 10.0), Even(0.0, 1.0)], |[eta, cos]| {
        reflected(&Mirror::dielectric(&[eta], cos, 0.0), elements(eta, 0.0, cos))
    })
    .is_what_is_promised("mirrors of glass", 9e-7);
    // Beyond the critical angle, over (1 - n^2) / (sin^2 - n^2).
    worst(3, STEPS, [Even(0.3, 0.95), Even(0.0, 1.0)], |[eta, cos]| {
        let [n, c] = [eta, cos].map(f64::from);
        let (excess, fading) = ((1.0 - n) * (1.0 + n), (1.0 - n) * (1.0 + n) - c * c);
        if fading < 1e-5 {
            return -1.0;
        }
        let phase = 2.0 * (c * fading.sqrt()).atan2((1.0 - c) * (1.0 + c));
        reflected(&Mirror::dielectric(&[eta], cos, 0.0), [1.0, 0.0, -phase.cos(), phase.sin()]) * fading
            / excess
    })
    .is_what_is_promised("total reflection, over its condition", 3e-7);
}

#[test]
fn air_and_diffuse_light_are_as_exact_as_promised() {
    worst(1, STEPS, [Even(200.0, 2000.0), Even(0.0, 1000.0)], |[nm, co2_ppm]| {
        let (um, co2) = (1e-3 * f64::from(nm), f64::from(co2_ppm));
        let v = 1.0 / (um * um);
        let refractivity = 1e-8 * (8060.51 + 2_480_990.0 / (132.274 - v) + 17_455.7 / (39.32957 - v));
        let n2 = (1.0 + refractivity * (1.0 + 0.54e-6 * (co2 - 300.0))).powi(2);
        let [nitrogen, oxygen] = [1.034 + 3.17e-4 * v, 1.096 + 1.385e-3 * v + 1.448e-4 * v * v];
        let king = (78.084 * nitrogen + 20.946 * oxygen + 0.934 + 1e-4 * co2 * 1.15)
            / (78.084 + 20.946 + 0.934 + 1e-4 * co2);
        // Lengths in cm.
        let share = (n2 - 1.0) / ((um * 1e-4).powi(2) * 2.546_899e19 * (n2 + 2.0));
        let exact = 1e27 * 24.0 * PI.powi(3) * share * share * king;
        (f64::from(rayleigh_cross_section(nm, co2_ppm)) / exact - 1.0).abs()
    })
    .is_what_is_promised("cross-section of air", 1.5e-6);
    let nodes = gauss(64);
    let inside = |eta: f32, mean: f64| 1.0 - (1.0 - mean) / f64::from(eta).powi(2);
    let mean = |eta: f32| {
        // Gathers at grazing angles.
        integral(&nodes, 0.0, 1.0, |t| {
            let cos = t.powi(3);
            let [[s, ..], [p, ..]] = face(eta.into(), cos);
            (s + p) * cos * 3.0 * t * t
        })
    };
    for (what, low, high, bound) in [("from 1.2 on", 1.2, 3.0, 3e-7), ("below 1.2", 1.0, 1.2, 1.1e-4)] {
        worst(2, 100, [Even(low, high)], |[eta]| {
            let exact = mean(eta);
            let [outside, inside] = [
                f64::from(external_reflectance(eta)) - exact,
                f64::from(internal_reflectance(eta)) - inside(eta, exact),
            ];
            outside.abs().max(inside.abs())
        })
        .is_what_is_promised(&format!("diffuse reflectance {what}"), bound);
    }
    let fit = |low: f32, high: f32| {
        worst(3, 100, [Even(low, high)], |[eta]| {
            (f64::from(internal_reflectance_fit(eta)) - inside(eta, mean(eta))).abs()
        })
    };
    fit(1.2, 1.7).is_what_is_promised("the fit from 1.2 to 1.7", 1e-3);
    fit(1.0, 1.2).is_what_is_promised("the fit below 1.2", 1.61e-3);
}
