//! Lists the choices that no other choice beats, by having a smaller error for no more instructions.

use super::lamps::{CLASSES, Class};
use super::price::Prices;
use super::see::Outcome;
use crate::report::{Cell, Column, Table};

/// A choice must have an error smaller by more than this share to be worth more instructions. Among the
/// smallest errors only the last digits differ.
const NEARER: f64 = 0.05;

/// Makes the table for each class of lamps, and for all classes but that of lines, as the mean of their
/// means.
pub fn table(outcomes: &[Outcome], prices: &Prices) -> Table {
    let mut rows = Vec::new();
    for (name, error) in classes() {
        let mut best = f64::INFINITY;
        let mut choices: Vec<(u32, f64, &Outcome)> = outcomes
            .iter()
            .filter_map(|outcome| {
                let price = prices.of(outcome.scheme, outcome.bands).m4f?;
                Some((price, error(outcome), outcome))
            })
            .collect();
        choices.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        for (price, error, outcome) in choices {
            if error < (1.0 - NEARER) * best {
                best = error;
                rows.push(vec![
                    Cell::key(&name),
                    Cell::key(outcome.range),
                    Cell::key(outcome.scheme.name()),
                    Cell::key(outcome.bands),
                    Cell::figure(f64::from(price)),
                    Cell::figure(outcome.scheme.bytes(outcome.bands) as f64),
                    Cell::figure(error),
                ]);
            }
        }
    }
    Table {
        id: "frontier",
        title: "What no other choice beats".to_owned(),
        about: "For each class of lamps, from few instructions to many: the choices whose mean CIEDE2000 is \
                smaller by more than 5 % than that of every choice that takes no more instructions on an \
                M4F. Lamps: the mean of all classes but lines."
            .to_owned(),
        columns: vec![
            Column::key("lamps", "lamps"),
            Column::key("range", "range, nm"),
            Column::key("scheme", "scheme"),
            Column::key("bands", "N"),
            Column::figure("m4f_instructions", "M4F"),
            Column::figure("constant_bytes", "bytes"),
            Column::figure("mean_de2000", "mean CIEDE2000"),
        ],
        rows,
    }
}

type Error = Box<dyn Fn(&Outcome) -> f64>;

fn classes() -> Vec<(String, Error)> {
    let all: Error = Box::new(|outcome: &Outcome| {
        let of_tables =
            CLASSES.iter().zip(&outcome.score.absolute).filter(|(class, _)| **class != Class::Lines);
        of_tables.map(|(_, spread)| spread.mean).sum::<f64>() / (CLASSES.len() - 1) as f64
    });
    let mut classes = vec![("lamps".to_owned(), all)];
    for (k, class) in CLASSES.into_iter().enumerate() {
        let one: Error = Box::new(move |outcome: &Outcome| {
            outcome.score.absolute.get(k).map_or(f64::INFINITY, |spread| spread.mean)
        });
        classes.push((class.name().to_owned(), one));
    }
    classes
}
