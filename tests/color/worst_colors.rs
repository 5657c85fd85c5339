//! That the documented bounds of color spaces and differences hold at the worst colors that a search finds.
#![cfg(feature = "libm")]

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

/// The difference of chroma and the square of that of hue, without cancellation.
fn polar([one, two]: Pair) -> (f64, f64) {
    let (c1, c2) = (one[1].hypot(one[2]), two[1].hypot(two[2]));
    let (da, db) = (two[1] - one[1], two[2] - one[2]);
    let chroma = ((one[1] + two[1]) * da + (one[2] + two[2]) * db) / (c1 + c2);
    let (cross, dot) = (one[1] * db - one[2] * da, one[1] * two[1] + one[2] * two[2]);
    let hue = if dot > 0.0 { cross * cross / (0.5 * (c1 * c2 + dot)) } else { 2.0 * (c1 * c2 - dot) };
    (chroma, hue)
}

fn hue(color: [f64; 3]) -> f64 {
    reference::hue_degrees(color[1], color[2])
}

/// CIE94 with a kL, K1 and K2.
fn de94(pair: Pair, [kl, k1, k2]: [f64; 3]) -> f64 {
    let ((chroma, hue), c1) = (polar(pair), pair[0][1].hypot(pair[0][2]));
    let lightness = (pair[1][0] - pair[0][0]) / kl;
    (lightness.powi(2) + (chroma / (1.0 + k1 * c1)).powi(2) + hue / (1.0 + k2 * c1).powi(2)).sqrt()
}

/// CMC, or nothing beside the steps that the formula has.
fn de_cmc(pair: Pair, l: f64) -> Option<f64> {
    let [one, two] = pair;
    let ((chroma, hue2), c1, h1) = (polar(pair), one[1].hypot(one[2]), hue(one));
    if (h1 - 164.0).abs() < 1e-3 || (h1 - 345.0).abs() < 1e-3 || (one[0] - 16.0).abs() < 1e-3 {
        return None;
    }
    let t = if (164.0..345.0).contains(&h1) {
        0.56 + (0.2 * (h1 + 168.0).to_radians().cos()).abs()
    } else {
        0.36 + (0.4 * (h1 + 35.0).to_radians().cos()).abs()
    };
    let f = (c1.powi(4) / (c1.powi(4) + 1900.0)).sqrt();
    let sl = if one[0] < 16.0 { 0.511 } else { 0.040975 * one[0] / (1.0 + 0.01765 * one[0]) };
    let sc = 0.0638 * c1 / (1.0 + 0.0131 * c1) + 0.638;
    let sh = sc * (f * t + 1.0 - f);
    Some((((two[0] - one[0]) / (l * sl)).powi(2) + (chroma / sc).powi(2) + hue2 / (sh * sh)).sqrt())
}

/// CIEDE2000, or nothing beside opposite hues, where the formula has a step.
fn de2000(pair: Pair) -> Option<f64> {
    let saturation = |c: f64| (c.powi(7) / (c.powi(7) + 25f64.powi(7))).sqrt();
    let mean = 0.5 * pair.iter().map(|color| color[1].hypot(color[2])).sum::<f64>();
    let stretched = pair.map(|[l, a, b]| [l, a * (1.5 - 0.5 * saturation(mean)), b]);
    let [one, two] = stretched;
    let (h1, h2) = (hue(one), hue(two));
    let apart = (h1 - h2).abs();
    if (apart - 180.0).abs() < 0.01 {
        return None;
    }
    let h = match 0.5 * (h1 + h2) {
        h if apart < 180.0 => h,
        h if h < 180.0 => h + 180.0,
        h => h - 180.0,
    };
    let (l, c) = (0.5 * (one[0] + two[0]) - 50.0, 0.5 * (one[1].hypot(one[2]) + two[1].hypot(two[2])));
    let cos = |degrees: f64| degrees.to_radians().cos();
    let t = 1.0 - 0.17 * cos(h - 30.0) + 0.24 * cos(2.0 * h) + 0.32 * cos(3.0 * h + 6.0)
        - 0.20 * cos(4.0 * h - 63.0);
    let turned = 60.0 * (-((h - 275.0) / 25.0).powi(2)).exp();
    let (chroma, hue2) = polar(stretched);
    let clockwise = one[1] * (two[2] - one[2]) < one[2] * (two[1] - one[1]);
    let lightness = (two[0] - one[0]) / (1.0 + 0.015 * l * l / (20.0 + l * l).sqrt());
    let chroma = chroma / (1.0 + 0.045 * c);
    let hue = if clockwise { -hue2.sqrt() } else { hue2.sqrt() } / (1.0 + 0.015 * c * t);
    let rotation = -2.0 * saturation(c) * turned.to_radians().sin();
    Some((lightness * lightness + chroma * chroma + hue * hue + rotation * chroma * hue).sqrt())
}

#[test]
fn differences_are_as_exact_as_promised() {
    let length = |[one, two]: Pair| (0..3).map(|k| (two[k] - one[k]).powi(2)).sum::<f64>().sqrt();
    difference("cie76", 2.3e-7, cie76, |pair| Some(length(pair)));
    let (print, cloth) = ([1.0, 0.045, 0.015], [2.0, 0.048, 0.014]);
    let arts = |x, y| cie94(x, y, Cie94Weights::GraphicArts);
    difference("cie94 for graphic arts", 6e-7, arts, |pair| Some(de94(pair, print)));
    let textiles = |x, y| cie94(x, y, Cie94Weights::Textiles);
    difference("cie94 for textiles", 6e-7, textiles, |pair| Some(de94(pair, cloth)));
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
