//! Directions at a surface, integrals over the hemisphere, refraction and the glasses that refract.
#![cfg(feature = "libm")]

use model::allowed::{Singles, check};
use nanospectra::geometry::{Cosine, Direction, GaussLegendre, Hemisphere, Node, Uniform};
use nanospectra::matter::{Cauchy, FUSED_SILICA, Glass, N_BK7, N_SF11, Sellmeier};
use nanospectra::{Bins, Light, Nodes};
use std::f32::consts::{FRAC_PI_2, PI, TAU};

fn length(w: Direction) -> f64 {
    w.to_array().iter().map(|part| f64::from(*part).powi(2)).sum::<f64>().sqrt()
}

#[test]
fn theta_is_the_zenith_angle_and_phi_the_azimuth() {
    let mut check = check("spherical coordinates");
    for (theta, phi) in (0..=200).flat_map(|j| (0..=100).map(move |k| (j, k))) {
        let (theta, phi) = (theta as f32 * (PI / 200.0), phi as f32 * (TAU / 100.0));
        let (t, p) = (f64::from(theta), f64::from(phi));
        let w = Direction::spherical(theta, phi);
        let exact = [t.sin() * p.cos(), t.sin() * p.sin(), t.cos()];
        check.add_all(&format!("{theta}, {phi}"), w.to_array(), exact);
        assert!((length(w) - 1.0).abs() < 4e-7);
    }
    check.tight_over_all();
    // The other way round, as some textbooks have it in places, theta = pi/2 would be the y axis.
    assert!(Direction::spherical(FRAC_PI_2, 0.0).x() > 0.999_999);
    assert_eq!(Direction::spherical(0.0, 1.0), Direction::NORMAL);
}

#[test]
fn angles_come_back_from_directions_near_the_poles_too() {
    let (mut zenith, mut azimuth) = (check("zenith angles"), check("azimuths"));
    for step in -150..=0 {
        for phi in [0.01f32, 1.0, 2.0, 3.0, 4.0, 5.0, 6.2] {
            let theta = 1.5 * 10f32.powf(0.1 * step as f32);
            let w = Direction::spherical(theta, phi);
            let [x, y, z] = w.to_array().map(f64::from);
            zenith.add(&format!("{theta}, {phi}"), w.theta_rad(), x.hypot(y).atan2(z));
            azimuth.add(
                &format!("{theta}, {phi}"),
                w.phi_rad(),
                y.atan2(x).rem_euclid(std::f64::consts::TAU),
            );
            assert!((w.theta_rad() / theta - 1.0).abs() < 6e-7, "{theta}: {}", w.theta_rad());
        }
    }
    zenith.tight_over_all();
    azimuth.tight_over_all();
    assert_eq!((Direction::NORMAL.theta_rad(), Direction::NORMAL.phi_rad()), (0.0, 0.0));
    assert_eq!((-Direction::NORMAL).theta_rad(), PI);
    assert_eq!((-Direction::NORMAL).phi_rad(), 0.0, "minus zero has no azimuth");
}

#[test]
fn vectors_of_any_length_have_a_direction_and_nothing_has_none() {
    for size in [1e-45f32, 1e-38, 1e-20, 1.0, 1e20, 1e38] {
        let w = Direction::from_vector([3.0 * size, 0.0, 3.0 * size]).expect("a vector");
        assert!((length(w) - 1.0).abs() < 2e-7 && w.x() == w.cos_theta(), "{size}: {w:?}");
    }
    assert_eq!(Direction::from_vector([0.0, -0.0, 0.0]), None);
    assert_eq!(Direction::from_vector([f32::NAN, 0.0, 1.0]), None);
    assert_eq!(Direction::from_vector([0.0, f32::INFINITY, 1.0]), None);
    assert!(Direction::spherical(f32::NAN, 0.0).cos_theta().is_nan());
}

#[test]
fn facets_reflect_to_the_other_side_of_their_normal() {
    let (wi, wm) = (Direction::spherical(0.4, 1.0), Direction::spherical(0.3, 4.0));
    let wo = wi.reflected(wm);
    assert!((wo.dot(wm) - wi.dot(wm)).abs() < 2e-7 && (length(wo) - 1.0).abs() < 4e-7);
    let again = wi.halfway(wo).expect("not opposite");
    assert!(again.to_array().iter().zip(wm.to_array()).all(|(a, b)| (a - b).abs() < 3e-7));
    assert_eq!(wi.mirrored(), wi.reflected(Direction::NORMAL));
    assert_eq!(Direction::NORMAL.halfway(-Direction::NORMAL), None);
}

#[test]
fn snell_bends_every_wavelength_by_its_own_index() {
    let mut check = check("refracted directions");
    for eta in [1.0 / 1.5f32, 0.9, 1.0, 1.000_1, 1.333, 1.5, 2.4, 1e6] {
        for step in 0..150 {
            let theta = 0.01 * step as f32;
            let wi = Direction::spherical(theta, 0.6);
            let [x, y, _] = wi.to_array().map(f64::from);
            let sine = x.hypot(y) / f64::from(eta);
            if sine > 0.7 {
                assert!(sine < 1.000_001 || wi.refracted(eta).is_none(), "{eta}, {theta}");
                continue;
            }
            let exact = [-x / f64::from(eta), -y / f64::from(eta), -(1.0 - sine * sine).sqrt()];
            let wt = wi.refracted(eta).expect("below the critical angle");
            check.add_all(&format!("{eta}, {theta}"), wt.to_array(), exact);
            let from_below = (-wi).refracted(eta).expect("the same from below");
            assert_eq!(from_below, -wt);
        }
    }
    check.tight_over_all();
    for eta in [0.0, -1.5, 1e-30] {
        assert_eq!(Direction::spherical(0.5, 0.0).refracted(eta), None);
    }
    assert!(Direction::NORMAL.refracted(f32::NAN).is_some_and(|wt| wt.cos_theta().is_nan()));
    // A prism's spectrum: blue is bent more.
    let eta = N_SF11.indices::<3, Bins<400, 700>>().expect("no resonance");
    let bent = eta.values().map(|eta| Direction::spherical(1.0, 0.0).refracted(eta).expect("into glass").x());
    assert!(bent.is_sorted_by(|a, b| a > b && a - b > 1e-3), "{bent:?}");
}

#[test]
fn glasses_have_the_indices_of_their_data_sheets() {
    let (mut indices, mut numbers, mut compared) = (check("indices of glasses"), check("Abbe's numbers"), 0);
    let model = |glass: &Sellmeier, nm: f64| -> f64 {
        let square = nm * nm * 1e-6;
        let terms = glass.b.iter().zip(&glass.c);
        (1.0 + terms.map(|(b, c)| f64::from(*b) * square / (square - f64::from(*c))).sum::<f64>()).sqrt()
    };
    for (glass, n_d, abbe) in
        [(N_BK7, 1.516_80, 64.17), (N_SF11, 1.784_72, 25.68), (FUSED_SILICA, 1.458_46, 67.82)]
    {
        for nm in 380..=1000 {
            let got = glass.index(nm as f32).expect("transparent");
            indices.add(&format!("{nm} nm"), got, model(&glass, nm.into()));
            compared += 1;
        }
        let d = glass.index(587.5618).expect("transparent");
        assert!((d - n_d).abs() < 6e-6, "{n_d}: {d}");
        let [d, f, c] = [587.5618f32, 486.1327, 656.2725].map(|nm| model(&glass, nm.into()));
        let got = glass.abbe_number().expect("transparent");
        numbers.add(&format!("{abbe}"), got, (d - 1.0) / (f - c));
        assert!((got - abbe).abs() < 0.01, "{abbe}: {got}");
    }
    indices.tight(compared);
    numbers.tight(3);
}

/// Three indices in the visible do not hold six coefficients, so these are compared with the published ones,
/// and indices far from the visible too.
#[test]
fn glasses_have_their_published_coefficients() {
    // Schott's data sheets.
    let bk7 = [[1.039_612_12, 0.231_792_344, 1.010_469_45], [0.006_000_698_67, 0.020_017_914_4, 103.560_653]];
    let sf11 = [[1.737_596_95, 0.313_747_346, 1.898_781_01], [0.013_188_707, 0.062_306_814_2, 155.236_29]];
    assert_eq!([N_BK7.b, N_BK7.c], bk7);
    assert_eq!([N_SF11.b, N_SF11.c], sf11);
    // Malitson has the wavelengths of the resonances, in um, and not their squares.
    let malitson = [0.068_404_3f64, 0.116_241_4, 9.896_161].map(|um| (um * um) as f32);
    assert_eq!([FUSED_SILICA.b, FUSED_SILICA.c], [[0.696_166_3, 0.407_942_6, 0.897_479_4], malitson]);
    // His table I, from the ultraviolet to the infrared.
    for (nm, n) in [
        (213.856, 1.534_307),
        (404.656, 1.469_618),
        (1013.98, 1.450_242),
        (2325.42, 1.432_928),
        (3706.7, 1.399_389),
    ] {
        let found = FUSED_SILICA.index(nm).expect("transparent");
        assert!((found - n).abs() < 1e-6, "{nm} nm: {found}, published {n}");
    }
}

#[test]
fn a_glass_has_no_index_at_a_resonance() {
    let resonant = Sellmeier { b: [1.0, 0.0, 0.0], c: [0.25, 0.02, 100.0] };
    assert_eq!(resonant.index(500.0), None, "infinite");
    assert_eq!(resonant.index(450.0), None, "n^2 below 0");
    assert!(resonant.index(600.0).is_some() && resonant.index(100.0).is_some());
    assert!(resonant.index(f32::NAN).is_some_and(f32::is_nan));
    for nm in [0.0, -500.0, f32::INFINITY] {
        assert_eq!(resonant.index(nm), None, "{nm}");
    }
    assert_eq!(resonant.indices::<31, Nodes<400, 700>>(), None);
    assert!(N_BK7.indices::<31, Nodes<400, 700>>().is_some());
    let cauchy = Cauchy { a: 1.5046, b: 0.0042, c: 0.0 };
    assert_eq!((cauchy.index(0.0), cauchy.index(-1.0), cauchy.index(1e-30)), (None, None, None));
    assert!(cauchy.index(f32::NAN).is_some_and(f32::is_nan));
}

/// Sum of both solid angles, in f64.
fn totals(nodes: impl Iterator<Item = Node>) -> [f64; 2] {
    nodes.fold([0.0, 0.0], |[all, projected], node| {
        assert!(node.direction.cos_theta() > 0.0 && (length(node.direction) - 1.0).abs() < 4e-7);
        [all + f64::from(node.solid_angle_sr), projected + f64::from(node.projected_sr)]
    })
}

#[test]
fn every_rule_divides_the_hemisphere_and_misses_nothing() {
    let (all, projected) = (std::f64::consts::TAU, std::f64::consts::PI);
    let gauss = totals(GaussLegendre::<8, 5>.nodes());
    assert!((gauss[0] / all - 1.0).abs() < 3e-7 && (gauss[1] / projected - 1.0).abs() < 3e-7, "{gauss:?}");
    let uniform = totals(Uniform::<9, 7>.nodes());
    assert!(
        (uniform[0] / all - 1.0).abs() < 3e-7 && (uniform[1] / projected - 1.0).abs() < 3e-7,
        "{uniform:?}"
    );
    let cosine = totals(Cosine::<9, 7>.nodes());
    assert!((cosine[1] / projected - 1.0).abs() < 3e-7, "{cosine:?}");
    assert_eq!(Cosine::<9, 7>.nodes().count(), 63);
}

#[test]
fn gauss_has_the_nodes_and_weights_of_the_tables() {
    let (mut nodes, mut weights) = (check("nodes of Gauss"), check("weights of Gauss"));
    // Abramowitz and Stegun, table 25.4, n = 8.
    let table = [
        (0.183_434_642_495_650, 0.362_683_783_378_362),
        (0.525_532_409_916_329, 0.313_706_645_877_887),
        (0.796_666_477_413_627, 0.222_381_034_453_374),
        (0.960_289_856_497_536, 0.101_228_536_290_376),
    ];
    let lower = table.iter().rev().map(|(x, w)| (-x, w));
    let exact: Vec<(f64, f64)> =
        lower.chain(table.iter().map(|(x, w)| (*x, w))).map(|(x, w)| (x, *w)).collect();
    for (node, (x, w)) in GaussLegendre::<8, 1>.nodes().zip(&exact) {
        nodes.add("n = 8", node.direction.cos_theta(), 0.5 * (1.0 + x));
        weights.add("n = 8", node.solid_angle_sr / TAU, 0.5 * w);
    }
    nodes.tight(8);
    weights.tight(8);
    // Exact up to the degree 2 N - 1, and for N = 1, 2, 3 too.
    fn power<const N: usize>(degree: i32) -> f32 {
        GaussLegendre::<N, 1>.integrate(|w| w.cos_theta().powi(degree)) * (degree + 1) as f32 / TAU
    }
    for (got, degree) in [(power::<1>(1), 1), (power::<2>(3), 3), (power::<3>(5), 5), (power::<64>(127), 127)]
    {
        assert!((got - 1.0).abs() < 3e-6, "{degree}: {got}");
    }
    assert!((power::<3>(6) - 1.0).abs() > 1e-3, "not beyond it");
}

#[test]
fn spectra_integrate_at_once_and_as_numbers_do() {
    let radiance = |w: Direction, k: usize| (1.0 + k as f32) * (1.0 + w.x() * w.cos_theta());
    let spectral = GaussLegendre::<8, 16>.integrate_projected(|w| {
        let mut light = Light::<16>::flat(0.0);
        light.values_mut().iter_mut().enumerate().for_each(|(k, value)| *value = radiance(w, k));
        light
    });
    for (k, value) in spectral.values().iter().enumerate() {
        let single = GaussLegendre::<8, 16>.integrate_projected(|w| radiance(w, k));
        assert_eq!(value.to_bits(), single.to_bits());
        assert!((single / (PI * (1.0 + k as f32)) - 1.0).abs() < 3e-7);
    }
    // A million equal pieces, where plain addition is off by 1e-3.
    let all = Uniform::<1000, 1000>.integrate(|_| 1.0f32);
    assert!((all / TAU - 1.0).abs() < 3e-7, "{all}");
}
