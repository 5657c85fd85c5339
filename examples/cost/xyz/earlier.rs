//! Against an earlier study of the same design: rows that differ, and what makes the difference.

use super::lamps::{CLASSES, Class};
use super::scheme::Scheme;
use super::see::{Outcome, RANGES};
use super::variant;
use super::world::World;
use crate::report::{Cell, Column, Table};
use model::fold::Reconstruction;
use nanospectra::Curve;

/// Its tables; the header says more.
const EARLIER: &str = include_str!("../data/earlier.csv");

/// What differs by more than this needs a cause.
const ALIKE: f64 = 0.10;
/// Half of the last digit that it gives.
const ROUNDED: f64 = 0.000_5;

/// What was changed, and the mean of each class that comes of it.
type Variant = (&'static str, [f64; CLASSES.len()]);

/// A mean of the earlier study beside ours.
struct Pair<'a> {
    outcome: &'a Outcome,
    class: usize,
    earlier: f64,
    ours: f64,
}

impl Pair<'_> {
    fn alike(&self, other: f64) -> bool {
        (other - self.earlier).abs() <= ALIKE * self.earlier + ROUNDED
    }

    fn percent(&self) -> f64 {
        100.0 * (self.ours / self.earlier - 1.0)
    }
}

/// Each mean that both studies have.
fn pairs(outcomes: &[Outcome]) -> Vec<Pair<'_>> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(EARLIER.as_bytes());
    let columns = reader.headers().cloned().unwrap_or_default();
    let mut pairs = Vec::new();
    for record in reader.records().flatten() {
        let cell = |name: &str| columns.iter().position(|column| column == name).and_then(|k| record.get(k));
        let number = |name: &str| cell(name)?.parse::<f64>().ok();
        let same = outcomes.iter().find(|outcome| {
            cell("range") == Some(outcome.range)
                && cell("scheme") == Some(outcome.scheme.name())
                && number("bands") == Some(outcome.bands as f64)
        });
        let Some(outcome) = same else { continue };
        for (k, (class, spread)) in CLASSES.iter().zip(&outcome.score.absolute).enumerate() {
            if let Some(earlier) = number(&format!("{}_mean", class.name())) {
                pairs.push(Pair { outcome, class: k, earlier, ours: spread.mean });
            }
        }
    }
    pairs
}

/// For each scheme, range and class, how many rows are as before, and the largest difference.
pub fn summary(outcomes: &[Outcome]) -> Table {
    let pairs = pairs(outcomes);
    let mut rows = Vec::new();
    let mut rest = &pairs[..];
    while let Some(first) = rest.first() {
        let same = |pair: &Pair| {
            pair.outcome.scheme == first.outcome.scheme && pair.outcome.range == first.outcome.range
        };
        let (group, others) = rest.split_at(rest.iter().take_while(|pair| same(pair)).count());
        rest = others;
        for (k, class) in CLASSES.into_iter().enumerate() {
            let of: Vec<&Pair> = group.iter().filter(|pair| pair.class == k).collect();
            let alike = of.iter().filter(|pair| pair.alike(pair.ours)).count();
            let worst = of
                .iter()
                .filter(|pair| !pair.alike(pair.ours))
                .map(|pair| pair.percent())
                .filter(|percent| percent.is_finite())
                .max_by(|a, b| a.abs().total_cmp(&b.abs()));
            rows.push(vec![
                Cell::key(first.outcome.range),
                Cell::key(first.outcome.scheme.name()),
                Cell::key(class.name()),
                Cell::key(if has_other_lamps(class) { "others" } else { "the same" }),
                Cell::figure(of.len() as f64),
                Cell::figure(alike as f64),
                worst.map_or(Cell::Nothing, Cell::figure),
            ]);
        }
    }
    Table {
        id: "earlier",
        title: "Against the earlier study: how many means are as they were".to_owned(),
        about: "Means of CIEDE2000 that differ by no more than 10 % and half of the last digit given. Its classes of \
            discharge lamps and of lines had other lamps in them, which are not in these tables."
            .to_owned(),
        columns: vec![
            Column::key("range", "range, nm"),
            Column::key("scheme", "scheme"),
            Column::key("class", "lamps"),
            Column::key("lamps", "which"),
            Column::figure("compared", "compared"),
            Column::figure("alike", "alike"),
            Column::figure("largest_percent", "largest %"),
        ],
        rows,
    }
}

/// Lamps that were not the same ones.
fn has_other_lamps(class: Class) -> bool {
    matches!(class, Class::Hid | Class::Lines)
}

/// Every row that differs although the lamps are the same, and why.
pub fn rows(outcomes: &[Outcome], world: &World) -> Table {
    let pairs = pairs(outcomes);
    let different = pairs.iter().filter(|pair| {
        !pair.alike(pair.ours) && CLASSES.get(pair.class).is_some_and(|class| !has_other_lamps(*class))
    });
    // Variants of one choice serve all its classes, which follow each other.
    let mut last: Option<(&Outcome, Vec<Variant>)> = None;
    let mut rows = Vec::new();
    for pair in different {
        if last.as_ref().is_none_or(|(outcome, _)| !std::ptr::eq(*outcome, pair.outcome)) {
            last = Some((pair.outcome, variants(pair.outcome, world)));
        }
        let variants = last.iter().flat_map(|(_, variants)| variants);
        let found: Vec<(&str, f64)> =
            variants.filter_map(|(name, means)| Some((*name, *means.get(pair.class)?))).collect();
        let cause = found.iter().find(|(_, mean)| pair.alike(*mean));
        let (name, mean) = cause.or(found.last()).copied().unwrap_or(("", f64::NAN));
        rows.push(vec![
            Cell::key(pair.outcome.range),
            Cell::key(pair.outcome.scheme.name()),
            Cell::key(pair.outcome.bands),
            Cell::key(CLASSES.get(pair.class).map_or("", |class| class.name())),
            Cell::figure(pair.earlier),
            Cell::figure(pair.ours),
            if pair.earlier > 0.0 { Cell::figure(pair.percent()) } else { Cell::Nothing },
            Cell::figure(mean),
            Cell::key(if cause.is_some() { name } else { "NOT FOUND" }),
        ]);
    }
    Table {
        id: "earlier-rows",
        title: "Against the earlier study: the rows that moved, and what moved them".to_owned(),
        about: "Each choice again in f64 with one thing changed after the other, until the earlier mean comes out."
            .to_owned(),
        columns: vec![
            Column::key("range", "range, nm"),
            Column::key("scheme", "scheme"),
            Column::key("bands", "N"),
            Column::key("class", "lamps"),
            Column::figure("earlier", "earlier"),
            Column::figure("ours", "ours"),
            Column::figure("percent", "%"),
            Column::figure("variant", "with the cause"),
            Column::key("cause", "cause"),
        ],
        rows,
    }
}

/// What the earlier study did otherwise, the smallest change first.
fn variants(outcome: &Outcome, world: &World) -> Vec<Variant> {
    let Some(range) = RANGES.iter().find(|range| range.name == outcome.range) else { return Vec::new() };
    let run = |how| variant::means(world, range, outcome.bands, outcome.scheme, how);
    match outcome.scheme {
        Scheme::Folded(Curve::Step) => vec![("summed every 0.1 nm, not 1 nm", run(Reconstruction::Step))],
        Scheme::Folded(Curve::Parabola) | Scheme::Eye => {
            vec![("summed every 0.1 nm, not 1 nm", run(Reconstruction::Parabola))]
        }
        Scheme::Folded(Curve::Spline) => vec![
            ("summed every 0.1 nm, not 1 nm", run(Reconstruction::Spline)),
            ("that, and not-a-knot ends of the spline", run(Reconstruction::SplineNotAKnot)),
        ],
        Scheme::Points | Scheme::Averages | Scheme::Tails | Scheme::Rgb => Vec::new(),
    }
}
