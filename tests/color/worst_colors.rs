//! That the documented bounds of color spaces and differences hold at the worst colors that a search finds.
#![cfg(feature = "libm")]

use model::delta_e;
use model::dominant;
use model::lab as reference;
use model::search::{Range, Range::*, worst};
use model::tables::Observer;
use nanospectra::color::{
    Cie94Weights, Lab, Lch, Xy, Xyz, cie76, cie94, ciede2000, cmc, dominant_wavelength,
};
use nanospectra::observer::CIE_1931;

const STEPS: usize = 2000;

/// Two colors, somewhere, or the second one at this distance from the first.
type Pair = [[f64; 3]; 2];

const FAR: [Range; 7] = {
    let (l, ab) = (Even(0.0, 100.0), Even(-128.0, 128.0));
    [l, ab, ab, l, ab, ab, Even(0.0, 1.0)]
};
const NEAR: [Range; 7] = {
    let (l, ab, step) = (Even(0.0, 100.0), Even(-128.0, 128.0), Even(-1.0, 1.0));
    [l, ab, ab, step, step, step, Sizes(1e-5, 100.0)]
};
/// Near each other among the blues, where CIEDE2000 turns its ellipses.
const BLUE: [Range; 7] = {
    let step = Even(-1.0, 1.0);
    [
        Even(0.0, 100.0),
        Even(-5.0, 20.0),
        Even(-128.0, -20.0),
        Even(-0.01, 0.01),
        step,
        step,
        Sizes(1e-3, 100.0),
    ]
};

fn relative(got: f32, exact: f64) -> f64 {
    if exact == 0.0 { -1.0 } else { ((f64::from(got) - exact) / exact).abs() }
}

/// The worst relative error of a difference, of pairs far apart and near each other.
fn difference(what: &str, bound: f64, got: fn(Lab, Lab) -> f32, exact: impl Fn(Pair) -> Option<f64>) {
    let error = |[l, a, b, l2, a2, b2]: [f32; 6]| {
        let pair = [[l, a, b], [l2, a2, b2]];
        let [one, two] = pair.map(|[l, a, b]| Lab::new(l, a, b));
        exact(pair.map(|color| color.map(f64::from))).map_or(-1.0, |exact| relative(got(one, two), exact))
    };
    let far = worst(1, STEPS, FAR, |[l, a, b, l2, a2, b2, _]| error([l, a, b, l2, a2, b2]));
    let near =
        |[l, a, b, dl, da, db, size]: [f32; 7]| error([l, a, b, l + size * dl, a + size * da, b + size * db]);
    let near = [NEAR, BLUE].map(|ranges| worst(2, STEPS, ranges, near));
    let worse = near.into_iter().fold(far, |worse, near| if near.error > worse.error { near } else { worse });
    worse.is_what_is_promised(what, bound);
}

fn hue(color: [f64; 3]) -> f64 {
    reference::hue_degrees(color[1], color[2])
}

/// CMC, or nothing beside the steps that the formula has.
fn de_cmc([one, two]: Pair, l: f64) -> Option<f64> {
    let h = hue(one);
    let is_step = (h - 164.0).abs() < 1e-3 || (h - 345.0).abs() < 1e-3 || (one[0] - 16.0).abs() < 1e-3;
    (!is_step).then(|| delta_e::cmc(one, two, l, 1.0))
}

/// CIEDE2000, or nothing beside opposite hues, where the formula has a step.
fn de2000([one, two]: Pair) -> Option<f64> {
    let mean = 0.5 * (one[1].hypot(one[2]) + two[1].hypot(two[2]));
    let stretch = 1.5 - 0.5 * (mean.powi(7) / (mean.powi(7) + 25f64.powi(7))).sqrt();
    let [h1, h2] = [one, two].map(|[l, a, b]| hue([l, stretch * a, b]));
    let is_step = ((h1 - h2).abs() - 180.0).abs() < 0.01;
    (!is_step).then(|| delta_e::de2000(one, two))
}

#[test]
fn differences_are_as_exact_as_promised() {
    difference("cie76", 2.3e-7, cie76, |[one, two]| Some(delta_e::de76(one, two)));
    let arts = |x, y| cie94(x, y, Cie94Weights::GraphicArts);
    difference("cie94 for graphic arts", 6e-7, arts, |[one, two]| Some(delta_e::de94(one, two)));
    let textiles = |x, y| cie94(x, y, Cie94Weights::Textiles);
    difference("cie94 for textiles", 6e-7, textiles, |[one, two]| Some(delta_e::de94_textiles(one, two)));
    difference("CMC(2:1)", 7.5e-7, |x, y| cmc(x, y, 2.0, 1.0), |pair| de_cmc(pair, 2.0));
    difference("CMC(1:1)", 7.5e-7, |x, y| cmc(x, y, 1.0, 1.0), |pair| de_cmc(pair, 1.0));
    difference("CIEDE2000", 1.5e-6, ciede2000, de2000);
}

#[test]
fn polar_forms_are_as_exact_as_promised() {
    let sides = [Even(-128.0, 128.0), Even(-128.0, 128.0)];
    worst(1, STEPS, sides, |[a, b]| relative(Lab::new(50.0, a, b).chroma(), f64::from(a).hypot(b.into())))
        .is_what_is_promised("chromas", 1.2e-7);
    worst(2, STEPS, sides, |[a, b]| {
        let off = (f64::from(Lab::new(50.0, a, b).lch().h_deg) - hue([50.0, a.into(), b.into()])).abs();
        off.min(360.0 - off)
    })
    .is_what_is_promised("hues in degrees", 5e-5);
    worst(3, STEPS, [Sizes(1e-3, 200.0), Even(0.0, 360.0)], |[c, h_deg]| {
        let (got, hue) = (Lch { l: 50.0, c, h_deg }.lab(), f64::from(h_deg).to_radians());
        let [a, b] = [hue.cos(), hue.sin()].map(|part| part * f64::from(c));
        (f64::from(got.a) - a).abs().max((f64::from(got.b) - b).abs()) / f64::from(c)
    })
    .is_what_is_promised("a* and b* of a hue, per chroma", 3.5e-7);
}

/// The colors of the surface that reflects a share between two wavelengths, and another share elsewhere. With
/// shares of 0 and 1 these are the most saturated colors that there are.
struct Surfaces {
    /// Sums of the tristimulus values under D65, nanometer by nanometer.
    sums: Vec<[f64; 3]>,
}

impl Surfaces {
    fn under_d65() -> Self {
        let observer = Observer::Cie1931.on_cie_grid();
        let lamp: nanospectra::Fine<nanospectra::Power> = nanospectra::light::D65.fine();
        let mut sums = vec![[0.0; 3]];
        for (k, power) in lamp.values().iter().enumerate() {
            let last: [f64; 3] = sums[k];
            sums.push([0, 1, 2].map(|c| last[c] + f64::from(*power) * observer[c][k]));
        }
        let white = sums[471][1];
        sums.iter_mut().flatten().for_each(|sum| *sum *= 100.0 / white);
        Surfaces { sums }
    }

    fn up_to(&self, nm: f64) -> [f64; 3] {
        let (k, t) = ((nm - 360.0) as usize, (nm - 360.0).fract());
        let next = self.sums[(k + 1).min(471)];
        [0, 1, 2].map(|c| self.sums[k][c] + t * (next[c] - self.sums[k][c]))
    }

    fn color(&self, [from, to, inside, outside]: [f32; 4]) -> [f64; 3] {
        let [low, high] = [from, to].map(|nm| self.up_to(nm.into()));
        let (inside, outside, all) = (f64::from(inside), f64::from(outside), self.sums[471]);
        [0, 1, 2].map(|c| outside * all[c] + (inside - outside) * (high[c] - low[c]))
    }
}

#[test]
fn colors_of_surfaces_are_as_exact_as_promised() {
    let surfaces = Surfaces::under_d65();
    let white = surfaces.sums[471].map(|v| v as f32);
    let ranges = [Even(360.0, 830.0), Even(360.0, 830.0), Even(0.0, 1.0), Even(0.0, 1.0)];
    let apart = |got: Option<[f32; 3]>, exact: [f64; 3]| {
        got.map_or(f64::NAN, |got| {
            got.iter().zip(exact).map(|(got, exact)| (f64::from(*got) - exact).abs()).fold(0.0, f64::max)
        })
    };
    let xyz = |at: [f32; 4]| {
        let xyz = surfaces.color(at).map(|v| v as f32);
        (at[0] < at[1]).then_some((Xyz::new(xyz[0], xyz[1], xyz[2]), xyz.map(f64::from)))
    };
    let (white, white64) = (Xyz::new(white[0], white[1], white[2]), white.map(f64::from));
    worst(1, STEPS, ranges, |at| {
        let Some((color, exact)) = xyz(at) else { return -1.0 };
        apart(color.lab(white).map(|lab| [lab.l, lab.a, lab.b]), reference::lab(exact, white64))
    })
    .is_what_is_promised("Lab of surfaces", 9e-5);
    worst(2, STEPS, ranges, |at| {
        let Some((color, exact)) = xyz(at) else { return -1.0 };
        apart(color.luv(white).map(|luv| [luv.l, luv.u, luv.v]), reference::luv(exact, white64))
    })
    .is_what_is_promised("Luv of surfaces", 9e-5);
}

#[test]
fn dominant_wavelengths_are_as_exact_as_promised() {
    let locus = dominant::spectral_locus(Observer::Cie1931);
    let white = Xy::new(1.0 / 3.0, 1.0 / 3.0);
    // A light of this wavelength and this share of the way from the white.
    let found = |[nm, share]: [f32; 2]| {
        let (k, t) = ((nm - 360.0) as usize, f64::from((nm - 360.0).fract()));
        let [x, y] = [0, 1].map(|i| locus[k][i] + t * (locus[k + 1][i] - locus[k][i]));
        let part =
            |white: f32, pure: f64| (f64::from(white) + f64::from(share) * (pure - f64::from(white))) as f32;
        let sample = Xy::new(part(white.x, x), part(white.y, y));
        let wide = |xy: Xy| [f64::from(xy.x), f64::from(xy.y)];
        let exact = dominant::dominant(wide(sample), wide(white), &locus);
        Some((dominant_wavelength(sample, white, &CIE_1931)?, exact))
    };
    for (what, from, to, bound) in [
        ("dominant wavelength of 450 to 650 nm, in nm", 450.0, 650.0, 1.8e-4),
        ("dominant wavelength of 405 to 680 nm, in nm", 405.0, 680.0, 5.5e-4),
    ] {
        worst(1, STEPS / 10, [Even(from, to), Even(0.05, 1.0)], |at| {
            found(at).map_or(-1.0, |(found, exact)| (f64::from(found.nm) - exact.nm).abs())
        })
        .is_what_is_promised(what, bound);
    }
    worst(2, STEPS / 10, [Even(405.0, 680.0), Even(0.05, 1.0)], |at| {
        found(at).map_or(-1.0, |(found, exact)| (f64::from(found.purity) - exact.purity).abs())
    })
    .is_what_is_promised("purity", 6.4e-7);
}
