//! Computes the difference between two spectra: this one minus the reference.

use super::{Bench, Note, Reading};
use crate::measure::level::Kind;
use nanospectra::color::{Cie94Weights, Xyz, cie76, cie94, ciede2000, cmc};

/// The differences of a spectrum from the reference, with `None` where a number is not defined.
pub struct Comparison {
    /// The name of the reference.
    pub to: String,
    /// The difference, of one or more numbers, for each key of the report.
    pub differences: Vec<(&'static str, Option<Difference>)>,
}

/// A difference of one number, or of one for each coordinate.
pub enum Difference {
    One(f64),
    Each(Vec<f32>),
}

pub fn compare(bench: &Bench, this: &Reading, reference: &Reading) -> (Comparison, Vec<Note>) {
    let is_surface = this.kind == Kind::Surface;
    let mut differences = if is_surface { surfaces(this, reference) } else { lights(bench, this, reference) };
    differences.extend(chromaticity(this, reference));
    let y_ratio = (reference.raw_y != 0.0).then(|| Difference::One(this.raw_y / reference.raw_y));
    differences.push(("y_ratio", y_ratio));
    differences.push(("spectral_rms", spectral_rms(this, reference, !is_surface)));

    let is_finite = |difference: &Difference| match difference {
        Difference::One(value) => value.is_finite(),
        Difference::Each(values) => values.iter().all(|value| value.is_finite()),
    };
    for (_, value) in &mut differences {
        value.take_if(|difference| !is_finite(difference));
    }

    let note = |key: &str, text: &str| Note { key: format!("compare.{key}"), text: text.to_owned() };
    let missing = differences.iter().filter(|(_, value)| value.is_none());
    let mut notes: Vec<Note> =
        missing.map(|(key, _)| note(key, "it is not defined for these two spectra")).collect();
    if !is_surface && (this.kind == Kind::Relative || this.kind != reference.kind) {
        notes.push(note(
            "y_ratio",
            "the ratio of the numbers as read means something only if both have the same unit",
        ));
    }
    (Comparison { to: reference.name.clone(), differences }, notes)
}

type Row = (&'static str, Option<Difference>);

fn chromaticity(this: &Reading, reference: &Reading) -> Vec<Row> {
    let xy = this.xy.zip(reference.xy).map(|(a, b)| Difference::Each(vec![a.x - b.x, a.y - b.y]));
    let uv = this.uv1976.zip(reference.uv1976);
    let distance = uv.map(|(a, b)| one((a.u - b.u).hypot(a.v - b.v)));
    vec![("delta_xy", xy), ("delta_uv1976", distance)]
}

fn lights(bench: &Bench, this: &Reading, reference: &Reading) -> Vec<Row> {
    let seen = |reading: &Reading| {
        let seen = Xyz::from(bench.eye.functions.sees(&reading.curve()));
        seen.with_y(100.0)
    };
    let apart =
        seen(this).zip(seen(reference)).and_then(|(a, white)| Some((a.lab(white)?, white.lab(white)?)));
    let minus = |a: Option<f32>, b: Option<f32>| a.zip(b).map(|(a, b)| one(a - b));
    vec![
        ("delta_cct_k", minus(this.cct_k, reference.cct_k)),
        ("delta_duv", minus(this.duv, reference.duv)),
        ("delta_tm30_rf", minus(this.tm30_rf, reference.tm30_rf)),
        ("delta_e2000", apart.map(|(a, b)| one(ciede2000(a, b)))),
        ("delta_cri_ra", minus(this.cri_ra, reference.cri_ra)),
        ("delta_tm30_rg", minus(this.tm30_rg, reference.tm30_rg)),
    ]
}

fn surfaces(this: &Reading, reference: &Reading) -> Vec<Row> {
    let Some((a, b)) = this.lab.zip(reference.lab) else {
        let keys = ["delta_e2000", "delta_e94", "delta_e_cmc_2_1", "delta_e76", "delta_lab"];
        return keys.map(|key| (key, None)).into();
    };
    vec![
        ("delta_e2000", Some(one(ciede2000(a, b)))),
        ("delta_e94", Some(one(cie94(b, a, Cie94Weights::GraphicArts)))),
        ("delta_e_cmc_2_1", Some(one(cmc(b, a, 2.0, 1.0)))),
        ("delta_e76", Some(one(cie76(a, b)))),
        ("delta_lab", Some(Difference::Each(vec![a.l - b.l, a.a - b.a, a.b - b.b]))),
    ]
}

/// Returns the root mean square difference between the curves.
///
/// Lights are scaled to the same Y first, because their level depends on where the meter stood. The result is
/// then a share of the reference's root mean square.
fn spectral_rms(this: &Reading, reference: &Reading, lights: bool) -> Option<Difference> {
    let level = |reading: &Reading| if lights { reading.curve_y } else { 1.0 };
    let (a, b) = (level(this), level(reference));
    let (mut apart, mut own) = (0.0, 0.0);
    let (this, reference) = (this.curve(), reference.curve());
    for (x, y) in this.values().iter().zip(reference.values()) {
        apart += (f64::from(*x) / a - f64::from(*y) / b).powi(2);
        own += (f64::from(*y) / b).powi(2);
    }
    let whole = if lights { own } else { this.values().len() as f64 };
    (whole > 0.0).then(|| Difference::One((apart / whole).sqrt()))
}

fn one(value: f32) -> Difference {
    Difference::One(f64::from(value))
}
