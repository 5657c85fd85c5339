//! Lists the cases in which a choice that costs more, or sounds better, has a larger error.

use super::lamps::CLASSES;
use super::range_place;
use super::scheme::Scheme;
use super::see::{Outcome, RANGES};
use crate::report::{Cell, Column, Table};
use nanospectra::Curve;

/// Cases with a smaller ratio of the errors than this are not listed.
const RATIO: f64 = 1.1;
/// Errors below this, in CIEDE2000, are smaller than that of the sum at 1 nm, and are not listed.
const FLOOR: f64 = 0.01;

/// A reason to expect a smaller error from one of two choices.
struct Belief {
    name: &'static str,
    /// Whether a smaller error is expected from the first.
    better: fn(&Outcome, &Outcome) -> bool,
}

const BELIEFS: [Belief; 5] = [
    Belief {
        name: "more bands",
        better: |one, two| one.scheme == two.scheme && one.range == two.range && one.bands > two.bands,
    },
    Belief {
        name: "a wider range",
        better: |one, two| {
            one.scheme == two.scheme
                && one.bands == two.bands
                && range_place(one.range) > range_place(two.range)
        },
    },
    Belief {
        name: "a smoother curve",
        better: |one, two| {
            let smoother = matches!(
                (one.scheme, two.scheme),
                (Scheme::Folded(Curve::Parabola | Curve::Spline), Scheme::Folded(Curve::Step))
                    | (Scheme::Folded(Curve::Spline), Scheme::Folded(Curve::Parabola))
                    | (Scheme::Eye, Scheme::Tails)
            );
            smoother && one.bands == two.bands && one.range == two.range
        },
    },
    Belief {
        name: "the light folded in",
        better: |one, two| {
            let folded = matches!(
                (one.scheme, two.scheme),
                (Scheme::Folded(_), Scheme::Points | Scheme::Averages | Scheme::Tails | Scheme::Eye)
            );
            folded && one.bands == two.bands && one.range == two.range
        },
    },
    Belief {
        name: "tails in the end bins",
        better: |one, two| {
            (one.scheme, two.scheme) == (Scheme::Tails, Scheme::Averages)
                && one.bands == two.bands
                && one.range == two.range
        },
    },
];

pub fn table(outcomes: &[Outcome]) -> Table {
    let mut rows = Vec::new();
    for belief in &BELIEFS {
        let mut schemes: Vec<Scheme> = outcomes.iter().map(|outcome| outcome.scheme).collect();
        schemes.sort_by_key(|scheme| scheme.place());
        schemes.dedup();
        for scheme in schemes {
            for range in RANGES {
                let of_choice = |one: &&Outcome| one.scheme == scheme && one.range == range;
                let ones: Vec<&Outcome> = outcomes.iter().filter(of_choice).collect();
                rows.extend((0..CLASSES.len()).filter_map(|k| worst(&ones, outcomes, belief, k)));
            }
        }
    }
    Table {
        id: "losses",
        title: "Where more is worse".to_owned(),
        about: format!(
            "For each scheme, range and class of lamps the worst case, by the mean CIEDE2000. The first \
             choice has more bands, a wider range, or a scheme that should be more exact at the same bands \
             and range, and has a larger error. Ratios below {RATIO} and errors below {FLOOR} are not \
             listed."
        ),
        columns: vec![
            Column::key("more", "more"),
            Column::key("lamps", "lamps"),
            Column::key("choice", "is worse"),
            Column::key("than", "than"),
            Column::figure("mean_de2000", "CIEDE2000"),
            Column::figure("than_mean_de2000", "than"),
            Column::figure("ratio", "ratio"),
        ],
        rows,
    }
}

/// Finds among `ones` the choice that is worse than another by the largest ratio although it should be
/// better.
fn worst(ones: &[&Outcome], outcomes: &[Outcome], belief: &Belief, class: usize) -> Option<Vec<Cell>> {
    let error = |outcome: &Outcome| outcome.score.absolute.get(class).map_or(0.0, |spread| spread.mean);
    let ones = ones.iter().copied().filter(|one| error(one) > FLOOR);
    let pairs = ones.flat_map(|one| {
        let twos = outcomes.iter().filter(move |two| (belief.better)(one, two));
        twos.map(move |two| (one, two))
    });
    let ratio = |(one, two): &(&Outcome, &Outcome)| error(one) / error(two);
    let worst = pairs.max_by(|a, b| ratio(a).total_cmp(&ratio(b))).filter(|pair| ratio(pair) > RATIO)?;
    let name = |outcome: &Outcome| format!("{} {} N={}", outcome.scheme.name(), outcome.range, outcome.bands);
    let class = CLASSES.get(class)?;
    Some(vec![
        Cell::key(belief.name),
        Cell::key(class.name()),
        Cell::key(name(worst.0)),
        Cell::key(name(worst.1)),
        Cell::figure(error(worst.0)),
        Cell::figure(error(worst.1)),
        Cell::figure(ratio(&worst)),
    ])
}
