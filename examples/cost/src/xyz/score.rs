//! Computes the errors of a choice from what it gives for each lamp.

use super::lamps::{CLASSES, Class};
use super::world::{CES, FILTERS, Lamp, TWO_BOUNCES, World};
use model::chromaticity::uv1976;
use model::delta_e::de2000;
use model::lab::lab;
use nanospectra::color::Xyz;

/// A result counts as negative below this. Nearer to zero are only roundings below the range of the crate:
/// the average of a tail of 1e-42 may be -1e-45.
const NEGATIVE: f64 = -1e-30;

/// The largest abs(Duv) of a light that counts as white.
const WHITE: f64 = 0.02;

/// XYZ under one lamp as a choice computes them.
pub struct Seen {
    pub white: [f64; 3],
    /// The XYZ of each surface, for each set of surfaces that was looked at.
    pub sets: Vec<Vec<[f64; 3]>>,
}

/// The mean, the 95th percentile and the largest CIEDE2000 over lamps and surfaces.
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

/// The errors of a choice.
#[derive(Default)]
pub struct Score {
    /// For each class of lamps the errors of the samples, with the exact white for all.
    pub absolute: [Spread; CLASSES.len()],
    /// For each class the mean error with the choice's own white, which hides the error of the light itself.
    pub own_white: [f64; CLASSES.len()],
    /// The errors of the color of the light itself, for tabulated lamps and for lines.
    pub light: [LightError; 2],
    /// For each class the errors of light that meets two surfaces.
    pub two_bounces: [Spread; CLASSES.len()],
    /// For each width of filters, if looked at under tabulated lamps, the errors, and the percentage of
    /// results that are negative in X, Y or Z.
    pub filters: Vec<(Spread, f64)>,
}

/// The largest errors of white.
#[derive(Clone, Copy, Default)]
pub struct LightError {
    pub percent_y: f64,
    pub uv: f64,
    /// The error of the color temperature of lamps that are white. It is infinite if one has lost its
    /// temperature.
    pub mired: f64,
}

/// Computes the errors. `seen` is in the order of the lamps of the world.
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
    // There are errors of filters only if filters were looked at.
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

/// Returns the color temperature and Duv by the crate, which is accurate to 0.009 mired.
fn cct(xyz: [f64; 3]) -> Option<(f64, f64)> {
    let (cct_k, duv) = Xyz::from(xyz.map(|value| value as f32)).uv1960()?.cct().near()?;
    Some((f64::from(cct_k), f64::from(duv)))
}
