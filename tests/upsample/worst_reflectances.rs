//! That the documented bounds of mixed paints, metamers, curves and fixed spectra hold at the worst that a
//! search finds.
#![cfg(feature = "libm")]

use crate::LIGHT;
use model::search::{Range::*, worst};
use nanospectra::color::{Rgb, Srgb};
use nanospectra::observer::CIE_1931;
use nanospectra::upsample::{Basis, CohenR, Shape, SigmoidReflectance, Smits, Viewing, kubelka_munk};
use nanospectra::{Bins, Curve, Light, Nodes, Observer, Power, Reflectance};

const STEPS: usize = 5000;

type One = Bins<500, 510>;
type Points = Nodes<400, 700>;
type Grid = Nodes<380, 780>;
static EYE: Observer<3, 81, Power, Grid> = CIE_1931.fold(Curve::Step);

#[test]
fn mixtures_are_as_exact_as_promised() {
    worst(1, STEPS, [Sizes(1e-20, 1.0), Sizes(1e-20, 1.0), Sizes(1e-6, 1e6)], |[a, b, share]| {
        let [one, other] = [a, b].map(Reflectance::<1, One>::flat);
        let ratio = |r: f32| (1.0 - f64::from(r)).powi(2) / (2.0 * f64::from(r));
        let k = (f64::from(share) * ratio(a) + ratio(b)) / (f64::from(share) + 1.0);
        let exact = 1.0 / (1.0 + k + (k * (k + 2.0)).sqrt());
        (f64::from(kubelka_munk(&[(share, &one), (1.0, &other)])[0]) / exact - 1.0).abs()
    })
    .is_what_is_promised("mixtures of two paints", 5e-7);
}

#[test]
fn metameric_blacks_are_as_dark_as_promised() {
    static R: CohenR<81, Power, Grid> = CohenR::new(&EYE);
    let [nm, wide] = [Even(380.0, 780.0), Sizes(2.0, 20.0)];
    worst(
        1,
        2000,
        [nm, wide, nm, wide, Even(0.0, 1.0), Even(0.0, 0.5)],
        |[a, wide_a, b, wide_b, share, flat]| {
            let band = |nm: f32, center: f32, width: f32| (-((nm - center) / width).powi(2)).exp();
            let lamp: Light<81, Grid> =
                Light::at_centers(|nm| band(nm, a, wide_a) + share * band(nm, b, wide_b) + flat.powi(3));
            let seen = |light: &Light<81, Grid>| {
                EYE.weights().each_ref().map(|row| {
                    row.iter()
                        .zip(light.values())
                        .map(|(w, v)| f64::from(*w) * f64::from(*v))
                        .sum::<f64>()
                        .abs()
                })
            };
            let most = |seen: [f64; 3]| seen.into_iter().fold(0.0, f64::max);
            most(seen(&R.black(&lamp))) / most(seen(&lamp))
        },
    )
    .is_what_is_promised("what is seen of a metameric black", 1e-6);
}

/// sigma(p), and 1 - sigma(p), without cancellation.
fn sigmoid(p: f64) -> [f64; 2] {
    let h = 1.0f64.hypot(p);
    let tail = 0.5 / (h * (h + p.abs()));
    if p < 0.0 { [tail, 1.0 - tail] } else { [1.0 - tail, tail] }
}

#[test]
fn curves_are_as_exact_as_promised() {
    worst(1, STEPS, [Sizes(1e-6, 1e17), Even(-1.0, 1.0)], |[size, sign]| {
        let p = size.copysign(sign);
        (f64::from(Shape { q: [0.0, 0.0, p] }.at(580.0)) / sigmoid(p.into())[0] - 1.0).abs()
    })
    .is_what_is_promised("sigmoids", 3.4e-7);
    // Relative, or of a complement absolute, over 1 and the sizes of the three terms.
    for (what, complement, size) in
        [("as it is", false, 5.0), ("as it is", false, 50.0), ("1 minus", true, 5.0)]
    {
        let q = Even(-size, size);
        let found =
            worst(2, STEPS, [q, q, q, Sizes(1e-9, 1.0), Even(360.0, 830.0)], |[q0, q1, q2, scale, nm]| {
                let [a, b, c, s] = [q0, q1, q2, scale].map(f64::from);
                let x = (f64::from(nm) - 580.0) / 200.0;
                let [curve, rest] = sigmoid((a * x + b) * x + c);
                let exact = if complement { 1.0 - s + s * rest } else { s * curve };
                let found = SigmoidReflectance { shape: Shape { q: [q0, q1, q2] }, scale, complement }.at(nm);
                let off = (f64::from(found) - exact).abs() / if complement { 1.0 } else { exact };
                off / (1.0 + (a * x * x).abs() + (b * x).abs() + c.abs())
            });
        println!("{what}, up to {size}: {:.2e} at {:?}", found.error, found.at);
        assert!(found.error <= 3.5e-7, "{what}: {found:?}");
        if size == 5.0 && !complement {
            found.is_what_is_promised("curves as they are stored", 3.5e-7);
        }
    }
}

#[test]
fn fixed_spectra_have_the_colors_that_are_promised() {
    fn basis<const N: usize, G: nanospectra::Grid>() -> f64 {
        let viewing: Viewing<N, G> = Viewing::new(&CIE_1931.under(&LIGHT).fold(Curve::Step));
        let basis = Basis::new(&viewing);
        let found = worst(1, STEPS, [Even(0.0, 1.0); 3], |[r, g, b]| {
            let back = viewing.rgb(&basis.reflectance(Rgb::<Srgb>::new(r, g, b))).to_array();
            back.into_iter()
                .zip([r, g, b])
                .map(|(back, asked)| f64::from((back - asked).abs()))
                .fold(0.0, f64::max)
        });
        println!("{N} bands: {:.2e} at {:?}", found.error, found.at);
        found.error
    }
    let most =
        [basis::<16, Points>(), basis::<31, Points>(), basis::<81, Grid>()].into_iter().fold(0.0, f64::max);
    assert!((5e-7..=1e-6).contains(&most), "{most:.2e}");
    let viewing: Viewing<81, Grid> = Viewing::new(&CIE_1931.under(&LIGHT).fold(Curve::Step));
    let smits = Smits::<81, Grid>::new();
    worst(2, 500, [Even(0.0, 1.0); 3], |[r, g, b]| {
        let rgb = Rgb::<Srgb>::new(r, g, b);
        viewing.delta_e(rgb, &smits.reflectance(rgb)).into()
    })
    .is_what_is_promised("Smits' spectra, CIEDE2000", 2.1);
    worst(3, 500, [Even(0.0, 1.0); 3], |[r, g, b]| {
        smits.reflectance(Rgb::<Srgb>::new(r, g, b)).values().iter().copied().fold(0.0, f32::max).into()
    })
    .is_what_is_promised("the highest of Smits' values", 1.015);
}
