//! What a choice is off by, lamp by lamp and kind by kind.

use super::lamps::{CLASSES, Class};
use super::world::{CES, FILTERS, Lamp, TWO_BOUNCES, World};
use model::chromaticity::uv1976;
use model::delta_e::de2000;
use model::lab::lab;
use nanospectra::color::Xyz;

/// What is nearer to 0 is rounding below the range of the crate: averages of a tail of 1e-42 may be -1e-45.
const NEGATIVE: f64 = -1e-30;

/// Abs(Duv) of light that passes for white.
const WHITE: f64 = 0.02;

/// XYZ under one lamp, as a choice has them.
pub struct Seen {
    pub white: [f64; 3],
    /// Of each surface of each set that was looked at.
    pub sets: Vec<Vec<[f64; 3]>>,
}

/// CIEDE2000 over lamps and surfaces.
#[derive(Clone, Copy, Default)]
pub struct Spread {
    pub mean: f64,
    pub p95: f64,
    pub max: f64,
}

impl Spread {
    fn of(mut errors: Vec<f64>) -> Self {
        errors.sort_by(f64::total_cmp);
        let (Some(max), Some(p95)) = (errors.last(), errors.get(errors.len() * 95 / 100)) else {
            return Spread::default();
        };
        Spread { mean: errors.iter().sum::<f64>() / errors.len() as f64, p95: *p95, max: *max }
    }
}

/// What a choice is off by.
#[derive(Default)]
pub struct Score {
    /// Of each class, the samples, to the truth's white.
    pub absolute: [Spread; CLASSES.len()],
    /// Mean with each color seen from its own white, which hides the error of the light itself.
    pub own_white: [f64; CLASSES.len()],
    /// The light's own color, tabulated lamps and then lines.
    pub light: [LightError; 2],
    /// Of each class, two bounces.
    pub two_bounces: [Spread; CLASSES.len()],
    /// Filters under tabulated lamps, if looked at: how far off, and percent that are negative in X, Y or Z.
    pub filters: Vec<(Spread, f64)>,
}

/// The worst that happens to white.
#[derive(Clone, Copy, Default)]
pub struct LightError {
    pub percent_y: f64,
    pub uv: f64,
    /// Of lamps that are white; infinite if one has no CCT any more.
    pub mired: f64,
}

/// Of the lamps in the order of the world.
pub fn score(world: &World, seen: &[Seen]) -> Score {
    let pairs: Vec<(&Lamp, &Seen)> = world.lamps.iter().zip(seen).collect();
    let of = |class: Class| pairs.iter().filter(move |(lamp, _)| lamp.class == class);
    let absolute = |lamp: &Lamp, seen: &Seen, set: usize| -> Vec<f64> {
        let (truth, seen) = (lamp.truth.get(set), seen.sets.get(set));
        let pairs = truth.into_iter().flatten().zip(seen.into_iter().flatten());
        pairs.map(|(truth, xyz)| de2000(*truth, lab(*xyz, lamp.white))).collect()
    };
    let spread =
        |class, set| Spread::of(of(class).flat_map(|(lamp, seen)| absolute(lamp, seen, set)).collect());
    let own = |class| {
        let errors = of(class).flat_map(|(lamp, seen)| own_white(lamp, seen)).collect();
        Spread::of(errors).mean
    };
    let tabulated = || pairs.iter().filter(|(lamp, _)| lamp.class != Class::Lines);
    // Where filters were not looked at there is nothing to say about them.
    let looked_at = seen.first().map_or(0, |seen| seen.sets.len());
    let filters = (FILTERS..looked_at).map(|set| {
        let errors = tabulated().flat_map(|(lamp, seen)| absolute(lamp, seen, set)).collect();
        let all: Vec<&[f64; 3]> = tabulated().filter_map(|(_, seen)| seen.sets.get(set)).flatten().collect();
        let negative = all.iter().filter(|xyz| xyz.iter().any(|value| *value < NEGATIVE)).count();
        (Spread::of(errors), 100.0 * negative as f64 / all.len().max(1) as f64)
    });
    Score {
        absolute: CLASSES.map(|class| spread(class, CES)),
        own_white: CLASSES.map(own),
        light: [
            tabulated().map(|(lamp, seen)| LightError::of(lamp, seen)).fold(LightError::default(), worse),
            of(Class::Lines)
                .map(|(lamp, seen)| LightError::of(lamp, seen))
                .fold(LightError::default(), worse),
        ],
        two_bounces: CLASSES.map(|class| spread(class, TWO_BOUNCES)),
        filters: filters.collect(),
    }
}

fn own_white(lamp: &Lamp, seen: &Seen) -> Vec<f64> {
    let pairs = lamp.truth.iter().zip(&seen.sets).take(1).flat_map(|(truth, seen)| truth.iter().zip(seen));
    pairs.map(|(truth, xyz)| de2000(*truth, lab(*xyz, seen.white))).collect()
}

impl LightError {
    fn of(lamp: &Lamp, seen: &Seen) -> Self {
        let ([u, v], [true_u, true_v]) = (uv1976(seen.white), uv1976(lamp.white));
        LightError {
            percent_y: (100.0 * (seen.white[1] / lamp.white[1] - 1.0)).abs(),
            uv: (u - true_u).hypot(v - true_v),
            mired: match (cct(seen.white), cct(lamp.white)) {
                (Some((seen, _)), Some((truth, duv))) if duv.abs() < WHITE => {
                    (1e6 / seen - 1e6 / truth).abs()
                }
                (None, Some((_, duv))) if duv.abs() < WHITE => f64::INFINITY,
                _ => 0.0,
            },
        }
    }
}

fn worse(one: LightError, two: LightError) -> LightError {
    LightError {
        percent_y: one.percent_y.max(two.percent_y),
        uv: one.uv.max(two.uv),
        mired: one.mired.max(two.mired),
    }
}

/// By the crate, which is within 0.009 mired.
fn cct(xyz: [f64; 3]) -> Option<(f64, f64)> {
    let (cct_k, duv) = Xyz::from(xyz.map(|value| value as f32)).uv1960()?.cct().near()?;
    Some((f64::from(cct_k), f64::from(duv)))
}
