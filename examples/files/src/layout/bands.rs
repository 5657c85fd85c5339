//! Joins two columns with the edges of bands to one axis.

use crate::grid::Grid;
use crate::refusal::{Note, Setting};

/// The fewest rows of which touching bands are no accident.
const FEWEST: usize = 3;

/// Joins the first two columns of a grid such as `380 385 0.1`, where each band begins where the one before ends.
///
/// The values are averages over the bands, and the axis has their middles.
pub fn join(grid: &Grid, notes: &mut Vec<Note>) -> Option<Grid> {
    let [low, high, rest @ ..] = &grid.columns[..] else { return None };
    let touches = |pair: (&f64, &f64)| (pair.0 - pair.1).abs() <= 1e-6 * pair.0.abs();
    let is_band = !rest.is_empty()
        && low.values.len() >= FEWEST
        && low.is_monotone()
        && low.values.iter().zip(&high.values).all(|(low, high)| high > low)
        && low.values[1..].iter().zip(&high.values).all(touches);
    if !is_band {
        return None;
    }
    notes.push(Note::assumed(
        format!(
            "columns {} and {} are the edges of bands, over which the values are averages",
            low.place, high.place
        ),
        Some(Setting::Column),
    ));
    let middles = low.values.iter().zip(&high.values).map(|(low, high)| f64::midpoint(*low, *high)).collect();
    let axis = low.with(middles);
    Some(Grid {
        columns: std::iter::once(axis).chain(rest.iter().cloned()).collect(),
        edges: Some(low.values.iter().chain(high.values.last()).copied().collect()),
        ..grid.clone()
    })
}
