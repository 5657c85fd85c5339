//! What goes wrong at surfaces in f32 if it is written naively: Fresnel's equations for media that hardly
//! differ or hardly let light in, microfacets of a mirror's smoothness, grazing light.

use model::allowed::{Singles, check};
use model::check::{Check, EPS};
use model::csv::golden;
use model::fresnel::{absorbed, amplitudes, reflectances, unpolarized};
use model::surface;
use nanospectra::geometry::{Direction, GaussLegendre, Hemisphere};
use nanospectra::matter::scattering::rho_hd;
use nanospectra::matter::{
    Brdf, Components, Conductor, Dielectric, Lambert, Microfacet, OrenNayar, Reflector, TrowbridgeReitz,
    VisibleNormals,
};

/// Both components against the model's, in units of rounding.
fn compare(check: &mut Check, place: &str, got: Components, (s, p): (f64, f64)) {
    for (name, got, exact) in [("s", got.s, s), ("p", got.p, p)] {
        let error = (f64::from(got) - exact).abs() / (exact * EPS);
        check.value(&format!("{place} {name}: {got:e} for {exact:e}"), error, 0.0);
    }
}

fn index(eta: f32, k: f32) -> [f64; 2] {
    [f64::from(eta), f64::from(k)]
}

#[test]
fn fresnel_agrees_with_the_golden() {
    let (mut reflected, mut entering, mut compared) =
        (check("Fresnel reflectances, golden 10"), check("Fresnel, what enters, golden 10"), 0);
    for row in golden("10_fresnel").rows() {
        let [n1, n2, k2, theta] = row.numbers(["n1", "n2", "k2", "theta_deg"]);
        // What f32 makes of the angle counts most near Brewster's, where R for p is 1e-6 and less.
        let (eta, k, cos_i) = ((n2 / n1) as f32, (k2 / n1) as f32, theta.to_radians().cos() as f32);
        let metal = Conductor::new(eta, k);
        let glass = Dielectric::new(eta);
        let pairs =
            [(metal.fresnel(cos_i), metal.entering(cos_i)), (glass.fresnel(cos_i), glass.entering(cos_i))];
        for (got, enters) in pairs.into_iter().take(if k2 == 0.0 { 2 } else { 1 }) {
            reflected.cells(row, ["Rs", "Rp", "R_unpol"], [got.s, got.p, got.unpolarized()].map(f64::from));
            entering.cells(row, ["Ts", "Tp"], [enters.s, enters.p].map(f64::from));
            compared += 1;
        }
    }
    assert!(compared > 180, "{compared}");
    reflected.tight(3 * compared);
    entering.tight(2 * compared);
}

#[test]
fn fresnel_holds_for_media_that_hardly_differ() {
    // Rows 14 and 15, and around them.
    let mut check = check("Fresnel of nearly equal media, s, in eps");
    for eta in [1.000_001f32, 1.000_01, 1.0001, 1.001, 1.01, 1.5, 2.4, 4.0] {
        for step in 1..=1000 {
            let cos_i = 1e-3 * step as f32;
            let got = Dielectric::new(eta).fresnel(cos_i);
            let (s, _) = reflectances(index(eta, 0.0), cos_i.into());
            let error = (f64::from(got.s) - s).abs() / (s * EPS);
            check.value(&format!("{eta}, {cos_i}: {:e} for {s:e}", got.s), error, 0.0);
        }
    }
    check.tight_over_all();
    let mut check = model::allowed::check("Fresnel, rows 14 and 15, in eps");
    for (eta, cos_i) in [(1.0001f32, 0.5f32), (1.000_001, 1e-3)] {
        let exact = reflectances(index(eta, 0.0), cos_i.into());
        compare(&mut check, &format!("{eta}, {cos_i}"), Dielectric::new(eta).fresnel(cos_i), exact);
    }
    check.tight(4);
}

#[test]
fn beyond_the_critical_angle_all_is_reflected_and_just_below_nearly_so() {
    let mut check = check("Fresnel just below the critical angle");
    for (eta, steps) in [(1.0f32 / 1.5, 3000), (0.999, 400)] {
        let critical = (1.0 - f64::from(eta).powi(2)).sqrt();
        for step in 1..=steps {
            let cos_i = (critical * (1.0 + 1e-4 * f64::from(step))) as f32;
            let got = Dielectric::new(eta).fresnel(cos_i);
            let (s, p) = reflectances(index(eta, 0.0), cos_i.into());
            check.add("s", got.s, s);
            check.add("p", got.p, p);
            let beyond = (critical * (1.0 - 1e-4 * f64::from(step).min(9999.0))) as f32;
            assert_eq!(Dielectric::new(eta).fresnel(beyond), Components::both(1.0), "{eta}, {beyond}");
            assert_eq!(Dielectric::new(eta).entering(beyond), Components::both(0.0), "{eta}, {beyond}");
        }
    }
    check.tight_over_all();
}

#[test]
fn no_boundary_reflects_nothing_and_grazing_light_is_all_reflected() {
    // Row 17: equal media first, the limit at grazing incidence depends on the path to it.
    for cos_i in [0.0, 1e-30, 1e-3, 1.0, 2.0, -1.0] {
        assert_eq!(Dielectric::new(1.0).fresnel(cos_i), Components::both(0.0), "{cos_i}");
        assert_eq!(Dielectric::new(1.0).amplitudes(cos_i).power(), Components::both(0.0), "{cos_i}");
        assert_eq!(Conductor::new(1.0, 0.0).fresnel(cos_i), Components::both(0.0), "{cos_i}");
    }
    for eta in [0.0, 0.5, 0.999_999_94, 1.000_000_1, 1.5, 1e10, 3e38] {
        assert_eq!(Dielectric::new(eta).fresnel(0.0), Components::both(1.0), "{eta}");
        assert_eq!(Conductor::new(eta, 1e-3).fresnel(0.0), Components::both(1.0), "{eta}");
    }
}

#[test]
fn metals_reflect_and_absorb_right_down_to_the_best_of_mirrors() {
    let (mut reflected, mut p, mut share) = (
        check("Fresnel of metals, s, in eps"),
        check("Fresnel of metals, p"),
        check("Fresnel of metals, absorbed, in eps"),
    );
    let mut compared = 0;
    let metals =
        [(0.01, 20.0), (0.2, 1e-4), (0.05, 3.32), (1.15, 2.56), (3.5, 0.01), (1.01, 1e-3), (40.0, 60.0)];
    for (eta, k) in metals {
        for step in 1..=1000 {
            let cos_i = 1e-3 * step as f32;
            // Below its critical angle, (0.2, 1e-4) is as badly conditioned as any glass.
            if k < 1e-3 && (0.9..0.999).contains(&cos_i) {
                continue;
            }
            let metal: Conductor = Conductor::new(eta, k);
            let (got, enters) = (metal.fresnel(cos_i), metal.entering(cos_i));
            let (s64, p64) = reflectances(index(eta, k), cos_i.into());
            let (s_in, p_in) = absorbed(index(eta, k), cos_i.into());
            let add = |check: &mut Check, got: f32, exact: f64| {
                let error = (f64::from(got) - exact).abs() / (exact * EPS);
                check.value(&format!("{eta} + {k}i, {cos_i}: {got:e} for {exact:e}"), error, 0.0);
            };
            add(&mut reflected, got.s, s64);
            // Rows 18 and 20 ask for more.
            let units = (f64::from(got.s) - s64).abs() / (s64 * EPS);
            assert!((eta, k) != (0.01, 20.0) || units <= 4.0, "row 18, {cos_i}: {units}");
            assert!((eta, k) != (0.2, 1e-4) || units <= 8.0, "row 20, {cos_i}: {units}");
            // Beside the angle where p is least it is as with Brewster's.
            p.add(&format!("{eta} + {k}i, {cos_i}"), got.p, p64);
            add(&mut share, enters.s, s_in);
            add(&mut share, enters.p, p_in);
            compared += 1;
        }
    }
    reflected.tight(compared);
    p.tight(compared);
    share.tight(2 * compared);
}

#[test]
fn metals_of_any_index_stay_finite() {
    // Row 19, and far beyond.
    let got = Conductor::new(0.2, 1e10).entering(1.0);
    assert!((f64::from(got.s) / 8e-21 - 1.0).abs() < 1e-6, "{got:?}");
    let parts = [0.0, 1e-40, 1e-20, 1e-3, 1.0, 1.000_000_1, 1e3, 1e10, 1e19, 1e20, 3e38, -1.0];
    for (eta, k) in parts.iter().flat_map(|eta| parts.iter().map(move |k| (*eta, *k))) {
        for cos_i in [0.0, 1e-40, 1e-20, 1e-10, 1e-3, 0.5, 1.0] {
            let (metal, glass) = (Conductor::new(eta, k), Dielectric::new(eta));
            for shares in
                [metal.fresnel(cos_i), metal.entering(cos_i), glass.fresnel(cos_i), glass.entering(cos_i)]
            {
                for share in [shares.s, shares.p] {
                    assert!((0.0..=1.0).contains(&share), "{eta} + {k}i, {cos_i}: {shares:?}");
                }
            }
            for amplitudes in [metal.amplitudes(cos_i), glass.amplitudes(cos_i)] {
                let power = amplitudes.power();
                assert!(
                    power.s <= 1.000_001 && power.p <= 1.000_001,
                    "{eta} + {k}i, {cos_i}: {amplitudes:?}"
                );
            }
        }
    }
}

#[test]
fn amplitudes_have_the_phases_of_the_textbook() {
    let mut check = check("Fresnel amplitudes");
    let media = [(1.5, 0.0), (1.0 / 1.5, 0.0), (0.05, 3.32), (1.15, 2.56), (3.5, 0.01), (1.000_1, 0.0)];
    for (eta, k) in media {
        for step in 0..=1000 {
            let cos_i = 1e-3 * step as f32;
            // Within a thousandth of the critical angle the phase turns by degrees for one last place.
            if k == 0.0 && eta < 1.0 && (f64::from(cos_i) - (1.0 - f64::from(eta * eta)).sqrt()).abs() < 2e-3
            {
                continue;
            }
            let (s, p) = amplitudes(index(eta, k), cos_i.into());
            let mut both = vec![Conductor::new(eta, k).amplitudes(cos_i)];
            both.extend((k == 0.0).then(|| Dielectric::new(eta).amplitudes(cos_i)));
            for got in both {
                let place = format!("{eta} + {k}i, {cos_i}");
                for (got, exact) in [(got.s.re, s[0]), (got.s.im, s[1]), (got.p.re, p[0]), (got.p.im, p[1])] {
                    check.add(&place, got, exact);
                }
            }
        }
    }
    check.tight_over_all();
}

#[test]
fn two_reflections_in_a_fresnel_rhomb_are_a_quarter_wave() {
    // n = 1.51: 45 degrees at 54.62 (Born and Wolf give 54 deg 37').
    let cos_i = 54.617f64.to_radians().cos() as f32;
    let once = Dielectric::new(1.0 / 1.51).amplitudes(cos_i).retardation();
    assert!((once.power() - 1.0).abs() < 1e-6);
    let degrees = f64::from(once.im).atan2(f64::from(once.re)).to_degrees();
    assert!((degrees + 45.0).abs() < 5e-3, "{degrees}");
}

#[test]
fn eight_rings_give_the_diffuse_reflectance_of_glass() {
    // Row 53: 0.0917780 for n = 1.5.
    let mut check = check("diffuse reflectance of glass, 8 rings");
    let glass = Dielectric::new(1.5f32);
    let flux = GaussLegendre::<8, 1>.integrate_projected(|w| glass.reflectance(w.cos_theta()));
    let steps = 200_000;
    let cosines = (0..steps).map(|k| (f64::from(k) + 0.5) / f64::from(steps));
    let exact: f64 = cosines.map(|c| 2.0 * c * unpolarized([1.5, 0.0], c)).sum::<f64>() / f64::from(steps);
    assert!((exact - 0.091_778_0).abs() < 1e-7, "{exact}");
    check.add("n = 1.5", flux / std::f32::consts::PI, exact);
    check.tight(1);
}

/// Zenith angles of 0 to 1 times the horizon's, in the plane of x.
fn tilted(cos_theta: f32) -> Direction {
    Direction::from_cosine(cos_theta, 0.0)
}

#[test]
fn the_density_of_facets_holds_at_its_peak_however_sharp() {
    // Row 21, and the slopes of the peak.
    let mut check = check("density of facets, in eps");
    for alpha in [1e-4f32, 1e-3, 1e-2, 0.1, 0.5, 1.0] {
        for step in 0..=400 {
            let theta = alpha * 10f32.powf(0.01 * (step - 200) as f32);
            if theta > 1.5 {
                continue;
            }
            let wm = Direction::spherical(theta, 0.7);
            let exact = surface::ggx_d(alpha.into(), as_f64(wm));
            let error = (f64::from(TrowbridgeReitz::new(alpha).d(wm)) - exact).abs() / (exact * EPS);
            check.value(&format!("{alpha}, {theta}"), error, 0.0);
        }
    }
    check.tight_over_all();
}

#[test]
fn no_roughness_makes_facets_infinite() {
    // Row 22: a mirror's facets are as those of 1e-4; NaN is never hidden.
    for alpha in [0.0, -1.0, 1e-30, f32::NEG_INFINITY] {
        let facets = TrowbridgeReitz::new(alpha);
        assert_eq!(facets, TrowbridgeReitz::new(1e-4));
        assert!((facets.d(Direction::NORMAL) / 3.183_099e7 - 1.0).abs() < 1e-6);
    }
    assert_eq!(TrowbridgeReitz::new(f32::INFINITY).alpha(), 1.0);
    assert!(TrowbridgeReitz::new(f32::NAN).d(Direction::NORMAL).is_nan());
    assert_eq!(TrowbridgeReitz::new(0.1).d(tilted(-0.5)), 0.0);
}

#[test]
fn grazing_light_leaves_brdfs_finite_and_light_from_below_gives_nothing() {
    // Rows 23 and 24.
    for alpha in [1.0, 0.1, 1e-2, 1e-4] {
        let facets = Microfacet { facets: TrowbridgeReitz::new(alpha), boundary: 1.0 };
        let matt = OrenNayar::new(0.9, alpha);
        for (o, i) in [(1e-6, 1e-6), (1e-6, 1.0), (1e-20, 1e-20), (1e-40, 0.5), (1e-6, 1e-20), (1e-38, 1e-38)]
        {
            for turns in [0.0, 0.25, 0.5, 0.500_01] {
                let (wo, wi) = (tilted(o), Direction::from_cosine(i, turns));
                let (rough, flat) = (facets.f(wo, wi), matt.f(wo, wi));
                assert!(rough.is_finite() && rough >= 0.0, "{alpha}, {o}, {i}, {turns}: {rough}");
                assert!(flat.is_finite() && flat >= 0.0, "{alpha}, {o}, {i}, {turns}: {flat}");
                assert_eq!(facets.f(wo, -wi), 0.0);
                assert_eq!(facets.f(-wo, wi), 0.0);
                assert_eq!((matt.f(wo, -wi), matt.f(-wo, wi)), (0.0, 0.0));
            }
        }
        assert_eq!(facets.f(tilted(0.0), tilted(0.5)), 0.0);
    }
}

#[test]
fn oren_and_nayar_without_roughness_are_lambert_to_the_bit() {
    for albedo in [0.0f32, 0.1, 0.18, 0.5, 0.9, 1.0] {
        let (flat, matt) = (OrenNayar::new(albedo, 0.0), Lambert(albedo));
        for k in 0..2000 {
            let wo = Direction::from_cosine((0.5 + (k % 40) as f32) / 40.0, 0.0);
            let wi = Direction::from_cosine((0.5 + (k / 40) as f32) / 50.0, 0.017 * k as f32);
            assert_eq!(flat.f(wo, wi).to_bits(), matt.f(wo, wi).to_bits(), "{albedo}, {k}");
        }
    }
}

fn as_f64(w: Direction) -> surface::Vector {
    w.to_array().map(f64::from)
}

/// Roughness 1 to 1e-4, and directions from the normal to grazing, densely where the rules are worst, and the
/// worst that searches of the three rules have found: at normal incidence, where a ring of nodes has just
/// fallen below the horizon.
fn gloss() -> impl Iterator<Item = (f32, f32)> {
    let cosines = (1..=49).step_by(2).chain([42, 50]).map(|c| (c as f32 / 50.0).powi(2));
    let alphas = (0..=20).chain([25, 30, 40]).map(|a| 10f32.powf(-0.1 * a as f32));
    let worst = [0.2246, 0.1689, 0.134].map(|alpha| (alpha, 1.0));
    alphas.flat_map(move |alpha| cosines.clone().map(move |cosine| (alpha, cosine))).chain(worst)
}

#[test]
fn visible_normals_find_the_light_at_every_roughness() {
    // Row 52: the weak white furnace, and the reflectance of a perfect reflector against a converged
    // integral.
    let mut furnace = check("weak white furnace, visible normals");
    let mut coarse = check("reflectance of facets, 12 x 12 visible normals");
    let mut usual = check("reflectance of facets, 16 x 16 visible normals");
    let mut fine = check("reflectance of facets, 32 x 32 visible normals");
    let mut compared = 0;
    for (alpha, cosine) in gloss() {
        let place = format!("{alpha}, {cosine}");
        let facets = TrowbridgeReitz::new(alpha);
        let wo = tilted(cosine);
        // F = 1 and G1 alone: D G1 / (4 cos) of the crate over the solid angles that the model gives the
        // nodes.
        let (mut sum, mut shares) = (0.0, 0.0);
        for (wm, share) in VisibleNormals::<8, 16>.normals(facets, wo) {
            let of_model = surface::ggx_visible_d(alpha.into(), as_f64(wo), as_f64(wm));
            sum += f64::from(facets.visible_d(wo, wm)) / of_model * f64::from(share);
            shares += f64::from(share);
        }
        furnace.value(&place, sum, 1.0);
        assert!((0.98..=1.000_001).contains(&sum), "{place}: {sum}");
        // As a rule has it, where the density has canceled.
        assert!((0.999_999..=1.0).contains(&shares), "{place}: {shares}");

        let white = Microfacet { facets, boundary: 1.0 };
        let exact = surface::ggx_rho(alpha.into(), cosine.into(), 300);
        // The surface is the same from every side; the nodes are not.
        for wo in [wo, Direction::from_cosine(cosine, 0.13)] {
            for (check, got) in [
                (&mut coarse, rho_hd(&white, wo, &VisibleNormals::<12, 12>)),
                (&mut usual, rho_hd(&white, wo, &VisibleNormals::<16, 16>)),
                (&mut fine, rho_hd(&white, wo, &VisibleNormals::<32, 32>)),
            ] {
                check.add(&place, got, exact);
                assert!(got <= 1.0, "{place}: creates light, {got}");
            }
        }
        compared += 1;
    }
    furnace.tight(compared);
    coarse.tight(2 * compared);
    usual.tight(2 * compared);
    fine.tight(2 * compared);
}

#[test]
fn gauss_in_the_cosine_serves_rough_facets_and_misses_glossy_ones() {
    let mut rough = check("reflectance of rough facets, 8 x 32 of Gauss");
    let rho = |alpha, cosine| {
        let white = Microfacet { facets: TrowbridgeReitz::new(alpha), boundary: 1.0 };
        rho_hd(&white, tilted(cosine), &GaussLegendre::<8, 32>)
    };
    for (alpha, cosine) in [(1.0f32, 1.0f32), (1.0, 0.7), (1.0, 0.3), (0.5, 1.0), (0.5, 0.7), (0.5, 0.3)] {
        let exact = surface::ggx_rho(alpha.into(), cosine.into(), 700);
        rough.add(&format!("{alpha}, {cosine}"), rho(alpha, cosine), exact);
    }
    rough.tight(6);
    let glossy = Microfacet { facets: TrowbridgeReitz::new(0.05), boundary: 1.0 };
    let got = rho_hd(&glossy, tilted(0.1), &GaussLegendre::<32, 32>);
    let exact = surface::ggx_rho(0.05, 0.1, 300);
    assert!((f64::from(got) / exact - 1.0).abs() > 0.7, "row 52: {got} for {exact}");
}

#[test]
fn facets_as_rough_as_can_be_return_one_less_the_logarithm_of_two() {
    let mut check = check("1 - ln 2");
    let white = Microfacet { facets: TrowbridgeReitz::new(1.0), boundary: 1.0 };
    // At the normal nothing depends on azimuth, and the integrand has no kink within the hemisphere.
    let got = rho_hd(&white, Direction::NORMAL, &GaussLegendre::<16, 1>);
    check.add("alpha = 1", got, 1.0 - std::f64::consts::LN_2);
    check.tight(1);
}
