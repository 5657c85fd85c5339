//! Boundaries and films over whole ranges of what they are made of, at the errors that their documentation
//! names.
#![cfg(feature = "libm")]

use model::allowed::{Singles, check};
use model::check::Check;
use model::film::{self, C};
use model::fresnel::{absorbed, reflectances};
use nanospectra::matter::{Conductor, Dielectric, Layer, Medium, Stack, ThinFilm};

/// The unit of rounding: half the distance between 1 and the next f32.
const EPS: f64 = 1.0 / 16_777_216.0;

/// Numbers without a pattern.
struct Noise(u64);

impl Noise {
    /// 0..1.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / 9_007_199_254_740_992.0
    }

    fn between(&mut self, low: f64, high: f64) -> f32 {
        (low + (high - low) * self.next()) as f32
    }

    /// Evenly in the logarithm.
    fn decades(&mut self, low: f64, high: f64) -> f32 {
        (low * (high / low).powf(self.next())) as f32
    }
}

/// How many cases: the models are slow in a debug build.
fn cases(n: usize) -> usize {
    if cfg!(debug_assertions) { n / 10 } else { n }
}

fn in_eps(check: &mut Check, place: &str, got: f32, exact: f64) {
    check.value(place, (f64::from(got) - exact).abs() / (exact * EPS), 0.0);
}

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
        in_eps(&mut s_check, &format!("{eta}, {cos_i}"), got.s, s);
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
            in_eps(&mut straight, &format!("{eta} s"), got.s, exact);
            in_eps(&mut straight, &format!("{eta} p"), got.p, exact);
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
        let sine2 = f64::from(eta).powi(2) * noise.next();
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
        in_eps(&mut reflected, &place, metal.fresnel(cos_i).s, s);
        p_check.add(&place, metal.fresnel(cos_i).p, p);
        in_eps(&mut share, &place, metal.entering(cos_i).s, s_in);
        in_eps(&mut share, &place, metal.entering(cos_i).p, p_in);
    }
    reflected.tight(n);
    p_check.tight(n);
    share.tight(2 * n);
    // Nearly clear and thinner than what is before it: as ill-conditioned near its critical angle as any glass.
    for _ in 0..cases(20_000) {
        let (eta, k, cos_i) = (noise.decades(0.05, 1.0), noise.decades(1e-6, 1e-2), noise.between(1e-3, 1.0));
        let (s, p) = reflectances([eta.into(), k.into()], cos_i.into());
        let got = Conductor::new(eta, k).fresnel(cos_i);
        for (got, exact) in [(got.s, s), (got.p, p)] {
            assert!((f64::from(got) - exact).abs() < 3e-5, "{eta} + {k}i, {cos_i}: {got} for {exact}");
        }
    }
}

#[test]
fn films_of_any_kind_share_out_light_as_the_matrix_does() {
    let (mut film_check, mut stack_check) = (check("any film"), check("any stack of eight layers"));
    let mut noise = Noise(4);
    let n = cases(100_000);
    for case in 0..n {
        // From the visible, on anything; the worst known ones first.
        let drawn = [1.0, noise.decades(1.2, 2.6), noise.decades(1.0, 4.0)];
        let (d, nm, cos) =
            (noise.decades(1.0, 2000.0), noise.between(380.0, 780.0), noise.between(0.05, 1.0));
        let (indices, d, nm, cos) = if case == 0 {
            ([1.0, 1.294_696_5, 3.789_530_8], 709.01, 764.5964, 0.05634)
        } else {
            (drawn, d, nm, cos)
        };
        let exact = film::airy(indices.map(f64::from), d.into(), nm.into(), cos.into());
        for (shares, exact) in ThinFilm::new(indices, d).at(nm, cos).into_iter().zip(exact) {
            let place = format!("{indices:?}, {d} nm, {nm} nm, cos {cos}");
            film_check.add(&place, shares.reflected, exact);
            film_check.add(&place, shares.transmitted, 1.0 - exact);
        }
    }
    film_check.tight(4 * n);
    for case in 0..n {
        let layers: [Layer; 8] = std::array::from_fn(|_| {
            let k = if noise.next() < 0.5 { 0.0 } else { noise.decades(1e-4, 0.3) };
            let medium = Medium { n: noise.decades(1.2, 2.6), k };
            Layer { medium, thickness_nm: noise.decades(1.0, 700.0) }
        });
        let substrate = Medium { n: noise.decades(1.0, 4.0), k: 0.0 };
        let (nm, cos) = (noise.between(380.0, 780.0), noise.between(0.05, 1.0));
        let mut drawn = (Stack { incident: 1.0, layers, substrate }, nm, cos);
        if case == 0 {
            let [first, rest @ ..] = &mut drawn.0.layers;
            *first = Layer { medium: Medium { n: 2.2454, k: 0.0022 }, thickness_nm: 333.55 };
            rest.iter_mut().for_each(|layer| layer.thickness_nm = 0.0);
            drawn = (Stack { substrate: Medium { n: 1.005, k: 0.0 }, ..drawn.0 }, 675.44, 0.1085);
        }
        let (stack, nm, cos) = drawn;
        let index = |m: Medium| C(m.n.into(), m.k.into());
        let layers: Vec<_> = stack.layers.iter().map(|l| (index(l.medium), l.thickness_nm.into())).collect();
        let exact = film::stack(1.0, &layers, index(stack.substrate), nm.into(), cos.into());
        for (shares, [r, t]) in stack.at(nm, cos).into_iter().zip(exact) {
            let place = format!("{stack:?}, {nm} nm, cos {cos}");
            stack_check.add(&place, shares.reflected, r);
            stack_check.add(&place, shares.transmitted, t);
        }
    }
    stack_check.tight(4 * n);
}
