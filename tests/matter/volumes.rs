//! Absorbers, air, and light that goes under the skin: closed forms, goldens, published values.
#![cfg(feature = "libm")]

use model::allowed::{Singles, check};
use model::check::EPS;
use model::csv::golden;
use nanospectra::Reflectance;
use nanospectra::matter::{
    Absorber, AbsorberError, Burley, BurleyFit, Dipole, air_refractivity, burley_distance,
    external_reflectance, internal_reflectance, internal_reflectance_fit, king_factor,
    rayleigh_cross_section, rayleigh_per_m, rayleigh_phase,
};
use std::f64::consts::PI;

fn absorber<const N: usize>(per_m: [f32; N]) -> Absorber<N> {
    Absorber::from_per_m(per_m).expect("coefficients")
}

#[test]
fn transmittance_is_beer_and_lamberts() {
    let mut check = check("transmittance, in (tau + 1) eps");
    for step in 0..=860 {
        let sigma = (1e-6 * 10f64.powf(0.01 * f64::from(step))) as f32;
        for path in [0.01f32, 1.0, 0.37] {
            let tau = f64::from(sigma) * f64::from(path);
            let exact = (-tau).exp();
            if exact < 1e-37 {
                continue;
            }
            let got = f64::from(absorber([sigma]).transmittance(path).values()[0]);
            check.value(&format!("tau {tau}"), (got - exact).abs() / (exact * (tau + 1.0) * EPS), 0.0);
        }
    }
    check.tight_over_more_than(2000);
}

#[test]
fn two_lengths_absorb_as_one_and_a_mixture_in_any_order() {
    let (one, other) = (absorber([0.0, 0.3, 7.0, 40.0]), absorber([1e-5, 2.0, 0.0, 11.0]));
    let (first, second, both) = (one.transmittance(0.7), one.transmittance(1.1), one.transmittance(1.8));
    for ((a, b), (ab, sigma)) in
        first.values().iter().zip(second.values()).zip(both.values().iter().zip(one.per_m()))
    {
        assert!((a * b - ab).abs() <= ab * (3.0 + 1.8 * sigma) * 1.2e-7, "{a} {b} {ab}");
    }
    assert_eq!((one + other).per_m(), (other + one).per_m());
    assert_eq!((one + other).transmittance(0.5), (other + one).transmittance(0.5));
    assert_eq!(one.times(2.0).transmittance(0.7), one.transmittance(1.4));
}

#[test]
fn the_ends_of_absorption_are_defined() {
    let of = absorber([0.0, 1.0, 1e30, f32::INFINITY]);
    assert_eq!(of.transmittance(0.0).values(), &[1.0; 4]);
    assert_eq!(of.absorbed(0.0).values(), &[0.0; 4]);
    assert_eq!(of.transmittance(104.0).values(), &[1.0, 0.0, 0.0, 0.0]);
    assert_eq!(of.absorbed(f32::INFINITY).values(), &[0.0, 1.0, 1.0, 1.0]);
    assert_eq!(of.transmittance(f32::INFINITY).values(), &[1.0, 0.0, 0.0, 0.0]);
    for path in [-1.0, f32::NAN] {
        assert!(of.transmittance(path).values().iter().all(|t| t.is_nan()), "{path} m");
        assert!(of.times(path).per_m().iter().all(|t| t.is_nan()), "{path} m");
    }
    for bad in [-1e-30, f32::NAN, f32::NEG_INFINITY] {
        let error = Absorber::<3>::from_per_m([0.0, 1.0, bad]).map(|_| ());
        assert_eq!(error, Err(AbsorberError::OutOfRange { bin: 2 }));
    }
    let plate =
        |t| Absorber::<2>::from_transmittance(&Reflectance::from_bins([0.5, t]), 1e-3).map(|a| *a.per_m());
    for bad in [1.01, -0.1, f32::NAN] {
        assert_eq!(plate(bad), Err(AbsorberError::OutOfRange { bin: 1 }));
    }
    assert_eq!(plate(0.0).map(|p| p[1]), Ok(f32::INFINITY));
    assert_eq!(plate(1.0).map(|p| p[1].to_bits()), Ok(0), "clear is +0");
    for bad in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        let glass = Absorber::<1>::from_transmittance(&Reflectance::flat(0.5), bad).map(|_| ());
        assert_eq!(glass, Err(AbsorberError::Amount));
        assert_eq!(Absorber::<1>::from_molar([1.0], bad).map(|_| ()), Err(AbsorberError::Amount));
    }
    assert!(AbsorberError::Amount.to_string().contains("concentration"));
    assert!(AbsorberError::OutOfRange { bin: 7 }.to_string().contains("bin 7"));
}

#[test]
fn the_chemists_absorbance_is_decadic() {
    // Absorbance 2 in 1 cm lets a hundredth through, half a cuvette a tenth.
    let dye = Absorber::<1>::from_molar([4e4], 5e-5).expect("a dye");
    assert!((dye.transmittance(0.01).values()[0] - 0.01).abs() < 1e-8);
    assert!((dye.transmittance(0.005).values()[0] - 0.1).abs() < 5e-8);
}

#[test]
fn air_scatters_as_bodhaine_says() {
    let mut sigma = check("Rayleigh cross-section, golden 10");
    let mut index = check("refractivity of air, golden 10");
    let mut king = check("King factor, golden 10");
    let mut rows = 0;
    for row in golden("10_rayleigh").rows() {
        let [nm, co2] = row.numbers(["lambda_nm", "co2_ppm"]);
        // What the rounding of the wavelength costs is not the formula's: four times as much in its fourth
        // power.
        let (nm32, co2) = (nm as f32, co2 as f32);
        let place = row.place();
        sigma.add(&place, rayleigh_cross_section(nm32, co2), 1e27 * row.number("sigma_Ns_paper"));
        // The golden has n; its 13 decimals leave 10 digits of n - 1.
        index.add(&place, air_refractivity(nm32), row.number("n_300") - 1.0);
        king.add(&place, king_factor(nm32, co2), row.number("F_air"));
        rows += 1;
    }
    sigma.tight(rows);
    index.tight(rows);
    king.tight(rows);
    assert!((rayleigh_cross_section(550.0, 300.0) - 4.510).abs() < 5e-4);
}

#[test]
fn a_kilometer_of_air_takes_blue_from_the_beam() {
    let air = Absorber::<31>::air();
    // The middle bin lies around 555 nm: the golden's cross-section times its molecules.
    let green = air.per_m()[15];
    assert!((green - 4.346_987e-27 * 2.546_899e21).abs() < 1e-8, "{green}");
    assert!((rayleigh_per_m(550.0) - 1.149e-5).abs() < 1e-8);
    let km = air.transmittance(1e3);
    assert!(km.values().windows(2).all(|pair| pair[0] < pair[1]), "red comes through best");
    let (blue, red) = (air.per_m()[0], air.per_m()[30]);
    // 385.6 and 724.4 nm: a little more than the fourth power.
    assert!((12.5..13.6).contains(&(blue / red)), "{}", blue / red);
}

#[test]
fn what_air_scatters_goes_somewhere() {
    for king in [1.0f32, 1.0488, 1.3] {
        // 2 pi times the integral over the cosine, by a rule that is exact for parabolas.
        let at = |cos: f32| f64::from(rayleigh_phase(cos, king));
        let sum = 2.0 * PI * (at(-1.0) + 4.0 * at(0.0) + at(1.0)) / 3.0;
        assert!((sum - 1.0).abs() < 2e-7, "{king}: {sum}");
        // Depolarization: (1 + rho) for unpolarized light at right angles over along it, by Bucholtz' table
        // 1.06.
        assert!(at(0.0) < at(1.0) && at(1.0) == at(-1.0));
    }
    let rho = 6.0 * 0.0488 / (7.0 * 1.0488 + 3.0f64);
    let expected = (1.0 + rho / (2.0 - rho) * 3.0) / (2.0 + 2.0 * rho / (2.0 - rho));
    let ratio = f64::from(rayleigh_phase(0.0, 1.0488) / rayleigh_phase(1.0, 1.0488));
    assert!((ratio - expected).abs() < 1e-6, "{ratio} {expected}");
}

/// Burley's cumulative, in f64.
fn cumulative(x: f64) -> f64 {
    -0.25 * (-x).exp_m1() - 0.75 * (-x / 3.0).exp_m1()
}

#[test]
fn burleys_profile_holds_its_albedo() {
    let mut within = check("Burley within a distance, in eps");
    let mut profile = check("Burley times the radius, in (x + 4) eps");
    let (albedo, d) = ([0.1f32, 0.55, 0.99], [1e-5f32, 2e-3, 0.7]);
    let skin = Burley::<3>::new(Reflectance::from_bins(albedo), d);
    for step in 0..=400 {
        let r = (1e-9 * 10f64.powf(0.02 * f64::from(step))) as f32;
        let (inside, ring) = (skin.within(r), skin.times_radius(r));
        for k in 0..3 {
            let (a, d) = (f64::from(albedo[k]), f64::from(d[k]));
            let x = f64::from(r) / d;
            let exact = a * cumulative(x);
            let place = format!("r {r}, d {d}");
            within.in_eps(&place, inside.values()[k], exact);
            let exact = a * ((-x).exp() + (-x / 3.0).exp()) / (8.0 * PI * d);
            let error = if exact < 1e-36 { 0.0 } else { (f64::from(ring.values()[k]) - exact).abs() / exact };
            profile.value(&place, error / ((x + 4.0) * EPS), 0.0);
        }
    }
    within.tight_over_all();
    profile.tight_over_all();
    // All of it leaves somewhere: the integral of 2 pi r R(r), by midpoints in f64 of the crate's own
    // profile.
    let sum: f64 = (0..40_000)
        .map(|i| {
            let r = (f64::from(i) + 0.5) * 1e-3 * 2e-3;
            2.0 * PI * f64::from(skin.times_radius(r as f32).values()[1]) * 2e-6
        })
        .sum();
    assert!((sum / f64::from(albedo[1]) - 1.0).abs() < 2e-6, "{sum}");
    assert_eq!(skin.reflectance().values(), &albedo);
}

#[test]
fn burley_without_depth_is_lambert() {
    let paper = Burley::<2>::new(Reflectance::from_bins([0.3, 0.8]), [0.0, 1e-45]);
    for r in [1e-30, 1e-3, 1.0, f32::INFINITY] {
        assert_eq!(paper.within(r).values(), &[0.3, 0.8], "{r} m");
        assert_eq!(paper.times_radius(r).values(), &[0.0, 0.0], "{r} m");
    }
    assert_eq!(paper.within(0.0).values(), &[0.3, 0.0]);
    assert_eq!(paper.times_radius(0.0).values()[0], f32::INFINITY);
    assert!(
        paper.within(-1.0).values().iter().chain(paper.times_radius(f32::NAN).values()).all(|v| v.is_nan())
    );
    let none = Burley::<1>::new(Reflectance::flat(0.5), [-1.0]);
    assert!(none.within(1.0).values()[0].is_nan());
}

#[test]
fn the_fits_of_christensen_and_burley_are_theirs() {
    // By hand, at an albedo of 0.8 and 0.3.
    for (by, at_08, at_03) in [
        (BurleyFit::Beam, 1.05, 1.55 + 7.0 * 0.125),
        (BurleyFit::Diffuse, 1.1, 1.6 + 3.5 * 0.25),
        (BurleyFit::DiffusePath, 3.5 + 100.0 * 0.47f32.powi(4), 3.5 + 100.0 * 0.03f32.powi(4)),
    ] {
        assert!((by.scaling(0.8) - at_08).abs() < 1e-6, "{by:?}: {}", by.scaling(0.8));
        assert!((by.scaling(0.3) - at_03).abs() < 1e-6, "{by:?}: {}", by.scaling(0.3));
        let skin = Burley::<1>::from_mean_free_path(Reflectance::flat(0.8), [2e-3], by);
        assert!((skin.distance()[0] / (2e-3 / by.scaling(0.8)) - 1.0).abs() < 2e-7);
    }
}

#[test]
fn a_share_of_burleys_light_has_its_distance() {
    let mut check = check("Burley's distance of a share");
    for step in -300i32..=300 {
        // From 1e-6 of d to 12 d.
        let x = 3e-3 * 10f64.powf(0.012 * f64::from(step));
        let share = cumulative(x) as f32;
        if share >= 0.999 {
            continue;
        }
        // Back by bisection, in f64, of the share as f32 has it.
        let (mut low, mut high) = (0.5 * x, 2.0 * x);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if cumulative(middle) < f64::from(share) { low = middle } else { high = middle }
        }
        check.add(&format!("{x}"), burley_distance(share), low);
    }
    check.tight_over_all();
    assert_eq!((burley_distance(0.0), burley_distance(1.0)), (0.0, f32::INFINITY));
    assert!([-0.1, 1.1, f32::NAN].into_iter().all(|share| burley_distance(share).is_nan()));
}

/// Fresnel's reflectance for unpolarized light from outside, textbook form.
fn fresnel(eta: f64, cos: f64) -> f64 {
    let inside = (1.0 - (1.0 - cos * cos) / (eta * eta)).sqrt();
    let s = (cos - eta * inside) / (cos + eta * inside);
    let p = (eta * cos - inside) / (eta * cos + inside);
    0.5 * (s * s + p * p)
}

/// Its mean over all directions, by many midpoints.
fn mean_fresnel(eta: f64) -> f64 {
    // In the cosine to the power of 1/3: nodes gather at grazing.
    let points = 20_000;
    (0..points)
        .map(|i| {
            let t = (f64::from(i) + 0.5) / f64::from(points);
            2.0 * t.powi(3) * fresnel(eta, t.powi(3)) * 3.0 * t * t / f64::from(points)
        })
        .sum()
}

#[test]
fn the_mean_of_fresnels_equations_is_exact_and_the_fit_is_the_papers() {
    let (mut outside, mut near) =
        (check("mean Fresnel reflectance"), check("mean Fresnel reflectance near 1"));
    for step in 0..=36 {
        let eta = (1.2 + 0.05 * f64::from(step)) as f32;
        outside.add(&format!("eta {eta}"), external_reflectance(eta), mean_fresnel(eta.into()));
    }
    outside.tight(37);
    for step in 0..=100 {
        let eta = (1.0 + 0.2 * 0.9f64.powi(step)) as f32;
        near.add(&format!("eta {eta}"), external_reflectance(eta), mean_fresnel(eta.into()));
    }
    near.tight(101);
    assert!((external_reflectance(1.5) - 0.091_778_0).abs() < 1e-6);
    assert!((internal_reflectance(1.5) - 0.596_346).abs() < 1e-6, "{}", internal_reflectance(1.5));
    assert!((internal_reflectance_fit(1.5) - 0.596_733).abs() < 5e-7);
    assert_eq!((external_reflectance(1.0), internal_reflectance(1.0)), (0.0, 0.0));
    for step in 0..=50 {
        let eta = 1.2 + 0.01 * step as f32;
        let off = internal_reflectance_fit(eta) - internal_reflectance(eta);
        assert!(off.abs() < 1e-3, "eta {eta}: {off}");
    }
    let at_one = internal_reflectance_fit(1.0);
    assert!((1.5e-3..1.6e-3).contains(&at_one), "{at_one}");
}

/// Jensen's dipole in f64: the profile, and its closed integral.
fn dipole(absorption: f64, scattering: f64, inside: f64, r: f64) -> [f64; 2] {
    let a = (1.0 + inside) / (1.0 - inside);
    let extinction = absorption + scattering;
    let albedo = scattering / extinction;
    let transport = (3.0 * absorption * extinction).sqrt();
    let (real, image) = (1.0 / extinction, (1.0 + 4.0 / 3.0 * a) / extinction);
    let source = |z: f64| {
        let d = r.hypot(z);
        z * (1.0 + transport * d) * (-transport * d).exp() / (d * d * d)
    };
    let root = (3.0 * (1.0 - albedo)).sqrt();
    let all = 0.5 * albedo * (1.0 + (-4.0 / 3.0 * a * root).exp()) * (-root).exp();
    [albedo / (4.0 * PI) * (source(real) + source(image)), all]
}

#[test]
fn the_dipole_is_jensens_and_integrates_to_its_reflectance() {
    let (mut profile, mut all) = (check("dipole, in (2 path + 20) eps"), check("reflectance of the dipole"));
    // Per mm: skim milk and marble in red, ketchup in blue, and the extremes.
    let media = [(0.0014f32, 0.70f32), (0.0021, 2.19), (1.49, 0.03), (0.0, 1.0), (1e-6, 1e3), (40.0, 2.0)];
    let (mut points, mut media_compared) = (0, 0);
    for (absorption, scattering) in media {
        for eta in [1.0f32, 1.3, 1.5] {
            let of = Dipole::<1>::new([absorption], [scattering], eta);
            // The mismatch is compared by `mean_fresnel`; here it is taken as f32 has it.
            let inside = f64::from(internal_reflectance(eta));
            let [_, exact] = dipole(absorption.into(), scattering.into(), inside, 0.0);
            let place = format!("{absorption}, {scattering}, eta {eta}");
            all.add(&place, of.reflectance().values()[0], exact);
            media_compared += 1;
            for step in 0..60 {
                let r = if step == 0 { 0.0 } else { (1e-4 * 10f64.powf(0.1 * f64::from(step))) as f32 };
                let [exact, _] = dipole(absorption.into(), scattering.into(), inside, r.into());
                let path = (3.0 * f64::from(absorption * (absorption + scattering))).sqrt() * f64::from(r);
                if exact > 1e-36 {
                    let got = f64::from(of.profile(r).values()[0]);
                    profile.value(&place, (got - exact).abs() / (exact * (2.0 * path + 20.0) * EPS), 0.0);
                    points += 1;
                }
            }
        }
    }
    profile.tight(points);
    all.tight(media_compared);
    // The integral of 2 pi r R(r), in the logarithm of r.
    let milk = Dipole::<1>::new([0.0014], [0.70], 1.3);
    let sum: f64 = (0..8000)
        .map(|i| {
            let r = 1e-5 * 10f64.powf((f64::from(i) + 0.5) * 1e-3);
            2.0 * PI * r * r * f64::from(milk.profile(r as f32).values()[0]) * 1e-3 * std::f64::consts::LN_10
        })
        .sum();
    assert!((sum - f64::from(milk.reflectance().values()[0])).abs() < 2e-5, "{sum}");
}

#[test]
fn milk_and_marble_reflect_what_jensen_measured() {
    // Jensen et al. 2001, per mm and RGB: absorption, reduced scattering, diffuse reflectance.
    for (name, absorption, scattering, published) in [
        ("whole milk", [0.0011f32, 0.0024, 0.014], [2.55f32, 3.21, 3.77], [0.91f32, 0.88, 0.76]),
        ("marble", [0.0021, 0.0041, 0.0071], [2.19, 2.62, 3.00], [0.83, 0.79, 0.75]),
        ("ketchup", [0.061, 0.97, 1.45], [0.18, 0.07, 0.03], [0.16, 0.01, 0.00]),
    ] {
        let eta = if name == "marble" { 1.5 } else { 1.3 };
        let got = Dipole::<3>::new_by_fit(absorption, scattering, eta).reflectance();
        for (got, published) in got.values().iter().zip(published) {
            assert!((got - published).abs() < 0.012, "{name}: {got}, published {published}");
        }
    }
}

#[test]
fn nothing_comes_back_from_what_does_not_scatter() {
    let of = Dipole::<4>::new([0.0, 1.0, -1.0, f32::NAN], [0.0, 0.0, 1.0, 1.0], 1.4);
    let seen = [of.reflectance(), of.profile(1.0), of.hemispherical_directional(0.5)];
    for values in seen.map(|s| *s.values()) {
        assert_eq!(values[..2], [0.0, 0.0]);
        assert!(values[2].is_nan() && values[3].is_nan());
    }
    // What only scatters returns all; what scatters within nothing returns it at the spot: Lambert.
    let white = Dipole::<2>::new([0.0, 0.0], [1.0, 1e18], 1.4);
    assert_eq!(white.reflectance().values(), &[1.0, 1.0]);
    assert_eq!(white.profile(1e-3).values()[1], 0.0);
    assert!(white.profile(-1.0).values().iter().all(|v| v.is_nan()));
}

#[test]
fn the_surface_takes_its_share_on_the_way_in_and_out() {
    let milk = Dipole::<1>::new([0.0011], [2.55], 1.3);
    let inside = f64::from(milk.reflectance().values()[0]);
    for cos in [1.0f32, 0.5, 0.1] {
        let expected =
            inside * (1.0 - fresnel(1.3f32.into(), cos.into())) * (1.0 - mean_fresnel(1.3f32.into()));
        let got = f64::from(milk.hemispherical_directional(cos).values()[0]);
        assert!((got - expected).abs() < 1e-6, "cos {cos}: {got} {expected}");
    }
    assert_eq!(milk.hemispherical_directional(0.0).values(), &[0.0]);
}
