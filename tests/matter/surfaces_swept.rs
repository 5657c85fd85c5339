//! Boundaries and films over whole ranges of what they are made of, at the errors that their documentation
//! names.
#![cfg(feature = "libm")]

use model::allowed::{Singles, check};
use model::check::Check;
use model::film::{self, C};
use model::fresnel::{absorbed, reflectances};
use model::noise::Noise;
use nanospectra::matter::{Conductor, Dielectric, Layer, Medium, Stack, ThinFilm};

#[test]
fn glasses_of_any_index_reflect_what_they_should() {
    let (mut s_check, mut p_check) =
        (check("Fresnel of any glass, s, in eps"), check("Fresnel of any glass, p"));
    let mut noise = Noise(1);
    let n = 200_000;
    for case in 0..n {
        let contrast = noise.decades(1e-6, 4.0);
        let cos_i = noise.between(1e-3, 1.0);
        // The worst known one first.
        let (eta, cos_i) = if case == 0 { (1.008_85, 0.997_14) } else { (1.0 + contrast, cos_i) };
        let (s, p) = reflectances([eta.into(), 0.0], cos_i.into());
        let got = Dielectric::new(eta).fresnel(cos_i);
        s_check.in_eps(&format!("{eta}, {cos_i}"), got.s, s);
        p_check.add(&format!("{eta}, {cos_i}"), got.p, p);
    }
    s_check.tight(n);
    p_check.tight(n);
}

#[test]
fn next_to_no_index_lets_in_next_to_no_light() {
    let mut straight = check("Fresnel of small indices, straight, entering, in eps");
    for step in 0..=400 {
        let eta = (1e-4 * 0.7e4f64.powf(f64::from(step) / 400.0)) as f32;
        let exact = 4.0 * f64::from(eta) / (1.0 + f64::from(eta)).powi(2);
        let (glass, metal) = (Dielectric::new(eta), Conductor::new(eta, 0.0));
        for got in [glass.entering(1.0), metal.entering(1.0)] {
            straight.in_eps(&format!("{eta} s"), got.s, exact);
            straight.in_eps(&format!("{eta} p"), got.p, exact);
        }
        for got in [glass.fresnel(1.0).s, glass.fresnel(1.0).p] {
            assert!((f64::from(got) - (1.0 - exact)).abs() < 1.2e-7, "{eta}: {got}");
        }
    }
    straight.tight(4 * 401);
    // At an angle, where light still gets in.
    let mut tilted = check("Fresnel of small indices");
    let mut noise = Noise(2);
    let (mut compared, n) = (0, 200_000);
    for _ in 0..n {
        let eta = noise.decades(1e-3, 0.7);
        let sine2 = f64::from(eta).powi(2) * noise.uniform();
        let cos_i = (1.0 - sine2).sqrt() as f32;
        let g2 = f64::from(eta).powi(2) - (1.0 - f64::from(cos_i).powi(2));
        if g2 < 1e-3 * f64::from(eta).powi(2) {
            continue;
        }
        let (s, p) = reflectances([eta.into(), 0.0], cos_i.into());
        let got = Dielectric::new(eta).fresnel(cos_i);
        tilted.add(&format!("{eta}, {cos_i} s"), got.s, s);
        tilted.add(&format!("{eta}, {cos_i} p"), got.p, p);
        compared += 2;
    }
    tilted.tight(compared);
}

#[test]
fn metals_of_any_index_reflect_and_absorb_what_they_should() {
    let (mut reflected, mut p_check, mut share) = (
        check("Fresnel of any metal, s, in eps"),
        check("Fresnel of any metal, p"),
        check("Fresnel of any metal, absorbed, in eps"),
    );
    let mut noise = Noise(3);
    let n = 200_000;
    for case in 0..n {
        // Transparent to opaque from n = 1 on; below it, metals that have no critical angle.
        let (eta, k) = if case % 2 == 0 {
            (noise.decades(1.0, 5.0), noise.decades(1e-3, 10.0))
        } else {
            (noise.decades(0.03, 0.5), noise.decades(1.5, 8.0))
        };
        let cos_i = noise.between(1e-3, 1.0);
        let place = format!("{eta} + {k}i, {cos_i}");
        let metal: Conductor = Conductor::new(eta, k);
        let index = [f64::from(eta), f64::from(k)];
        let (s, p) = reflectances(index, cos_i.into());
        let (s_in, p_in) = absorbed(index, cos_i.into());
        reflected.in_eps(&place, metal.fresnel(cos_i).s, s);
        p_check.add(&place, metal.fresnel(cos_i).p, p);
        share.in_eps(&place, metal.entering(cos_i).s, s_in);
        share.in_eps(&place, metal.entering(cos_i).p, p_in);
    }
    reflected.tight(n);
    p_check.tight(n);
    share.tight(2 * n);
    // Nearly clear and thinner than what is before it: as ill-conditioned near its critical angle as any
    // glass.
    for _ in 0..20_000 {
        let (eta, k, cos_i) = (noise.decades(0.05, 1.0), noise.decades(1e-6, 1e-2), noise.between(1e-3, 1.0));
        let (s, p) = reflectances([eta.into(), k.into()], cos_i.into());
        let got = Conductor::new(eta, k).fresnel(cos_i);
        for (got, exact) in [(got.s, s), (got.p, p)] {
            assert!((f64::from(got) - exact).abs() < 3e-5, "{eta} + {k}i, {cos_i}: {got} for {exact}");
        }
    }
}

/// What a film or a stack reflects and transmits, beside the model.
fn shares_of_a_film(check: &mut Check, indices: [f32; 3], d: f32, nm: f32, cos: f32) {
    let exact = film::airy(indices.map(f64::from), d.into(), nm.into(), cos.into());
    for (shares, exact) in ThinFilm::new(indices, d).at(nm, cos).into_iter().zip(exact) {
        let place = format!("{indices:?}, {d} nm, {nm} nm, cos {cos}");
        check.add(&place, shares.reflected, exact);
        check.add(&place, shares.transmitted, 1.0 - exact);
    }
}

fn shares_of_a_stack(check: &mut Check, layers: [Layer; 8], substrate: f32, nm: f32, cos: f32) {
    let stack = Stack { incident: 1.0, layers, substrate: Medium { n: substrate, k: 0.0 } };
    let index = |m: Medium| C(m.n.into(), m.k.into());
    let layers: Vec<_> = stack.layers.iter().map(|l| (index(l.medium), l.thickness_nm.into())).collect();
    let exact = film::stack(1.0, &layers, index(stack.substrate), nm.into(), cos.into());
    for (shares, [r, t]) in stack.at(nm, cos).into_iter().zip(exact) {
        let place = format!("{stack:?}, {nm} nm, cos {cos}");
        check.add(&place, shares.reflected, r);
        check.add(&place, shares.transmitted, t);
    }
}

fn layer([n, k, thickness_nm]: [f32; 3]) -> Layer {
    Layer { medium: Medium { n, k }, thickness_nm }
}

/// Films and stacks of the visible, on anything: always the same ones.
#[test]
fn films_of_any_kind_share_out_light_as_the_matrix_does() {
    let (mut film_check, mut stack_check) = (check("any film"), check("any stack of eight layers"));
    let mut noise = Noise(4);
    let n = 100_000;
    shares_of_a_film(&mut film_check, [1.0, 1.294_696_5, 3.789_530_8], 709.01, 764.5964, 0.05634);
    for _ in 1..n {
        let indices = [1.0, noise.decades(1.2, 2.6), noise.decades(1.0, 4.0)];
        let (d, nm, cos) =
            (noise.decades(1.0, 2000.0), noise.between(380.0, 780.0), noise.between(0.05, 1.0));
        shares_of_a_film(&mut film_check, indices, d, nm, cos);
    }
    film_check.tight(4 * n);
    let mut one_layer = [layer([1.5, 0.0, 0.0]); 8];
    one_layer[0] = layer([2.2454, 0.0022, 333.55]);
    shares_of_a_stack(&mut stack_check, one_layer, 1.005, 675.44, 0.1085);
    for _ in 1..n {
        let layers = std::array::from_fn(|_| {
            let k = if noise.uniform() < 0.5 { 0.0 } else { noise.decades(1e-4, 0.3) };
            layer([noise.decades(1.2, 2.6), k, noise.decades(1.0, 700.0)])
        });
        let substrate = noise.decades(1.0, 4.0);
        let (nm, cos) = (noise.between(380.0, 780.0), noise.between(0.05, 1.0));
        shares_of_a_stack(&mut stack_check, layers, substrate, nm, cos);
    }
    stack_check.tight(4 * n);
}

/// The worst that climbing from random starts has found within the ranges that the documentation names. (Runs
/// of the search end at different places for stacks and beside the critical angle: there may be worse.)
#[test]
fn the_worst_films_and_stacks_are_off_by_what_the_documentation_says() {
    for (what, indices, d, nm, cos) in [
        ("worst film in air", [1.0, 1.081_923_8, 3.998_127], 2685.1775, 1480.6917, 0.05),
        (
            "worst film in air, cosines from 0.2",
            [1.0, 1.370_248_3, 3.966_476_4],
            107.85084,
            414.0549,
            0.200_001_45,
        ),
        (
            "worst film beside its critical angle",
            [3.339_379, 1.201_182_2, 3.999_902_5],
            70_786_060.0,
            393.18265,
            0.933_068_63,
        ),
    ] {
        let mut check = check(what);
        shares_of_a_film(&mut check, indices, d, nm, cos);
        check.tight(4);
    }
    let mut check = check("worst stack of eight layers");
    let resonant = [
        [2.560_941_7, 0.0, 698.9868],
        [1.581_801_3, 0.0, 606.169_74],
        [2.478_885_7, 0.000_396_934_5, 14.883_172],
        [1.481_729_4, 0.0, 699.990_05],
        [2.598_445_4, 0.0, 140.015_27],
        [1.200_000_5, 0.0, 40.304_043],
        [2.265_228_5, 0.0, 65.437_744],
        [1.423_129_9, 0.0, 3.645_877_1],
    ];
    shares_of_a_stack(&mut check, resonant.map(layer), 1.000_013_6, 386.675_57, 0.05);
    check.tight(4);
}
