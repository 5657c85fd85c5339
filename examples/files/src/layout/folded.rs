//! Unfolds tables that have several samples of the same spectrum in a row, to save paper.

use crate::grid::{Column, Grid};
use crate::refusal::{Note, Setting};

/// The fewest rows of which equal steps are no accident.
const FEWEST: usize = 4;

/// Unfolds a grid such as `380 0.1 381 0.2`, or one whose second half continues the first.
///
/// The wavelengths of all parts together must be one axis in equal steps, which no values are by accident.
pub fn unfold(grid: &Grid, notes: &mut Vec<Note>) -> Option<Grid> {
    let count = grid.columns.len();
    let rows = grid.lines.len();
    if rows < FEWEST {
        return None;
    }
    let widths = (2..=count / 2).filter(|width| count.is_multiple_of(*width));
    for width in widths {
        let parts: Vec<&[Column]> = grid.columns.chunks(width).collect();
        if !have_same_names(&parts) {
            continue;
        }
        let by_row: Vec<(usize, usize)> =
            (0..rows).flat_map(|row| (0..parts.len()).map(move |part| (part, row))).collect();
        let by_part: Vec<(usize, usize)> =
            (0..parts.len()).flat_map(|part| (0..rows).map(move |row| (part, row))).collect();
        let order = [by_row, by_part].into_iter().find(|order| is_regular(&parts, order));
        if let Some(order) = order {
            let axes: Vec<String> = parts.iter().map(|part| part[0].place.to_string()).collect();
            notes.push(Note::assumed(
                format!(
                    "columns {} are one axis, so that each row has {} samples of a spectrum",
                    axes.join(", "),
                    parts.len()
                ),
                Some(Setting::Column),
            ));
            // The last rows of the last part may be empty.
            let filled = order.iter().rposition(|(part, row)| !parts[*part][0].values[*row].is_nan());
            return Some(in_order(grid, &parts, &order[..filled.map_or(0, |last| last + 1)]));
        }
    }
    None
}

/// Returns whether the parts have no names, or the same names each.
fn have_same_names(parts: &[&[Column]]) -> bool {
    parts.iter().all(|part| {
        part.iter().zip(parts[0]).all(|(column, first)| column.name.is_none() || column.name == first.name)
    })
}

/// Returns whether the first columns of the parts, in this order, increase in equal steps.
fn is_regular(parts: &[&[Column]], order: &[(usize, usize)]) -> bool {
    let axis: Vec<f64> = order.iter().map(|(part, row)| parts[*part][0].values[*row]).collect();
    let filled = axis.iter().rposition(|value| !value.is_nan()).map_or(0, |last| last + 1);
    let axis = &axis[..filled];
    if axis.len() <= order.len() - order.len() / parts.len() {
        return false;
    }
    let step = axis[1] - axis[0];
    step != 0.0 && axis.windows(2).all(|pair| ((pair[1] - pair[0]) / step - 1.0).abs() < 1e-3)
}

fn in_order(grid: &Grid, parts: &[&[Column]], order: &[(usize, usize)]) -> Grid {
    let column = |place: usize| Column {
        texts: parts.iter().map(|part| part[place].texts).sum(),
        text: parts.iter().find_map(|part| part[place].text.clone()),
        ..parts[0][place].with(order.iter().map(|(part, row)| parts[*part][place].values[*row]).collect())
    };
    Grid {
        columns: (0..parts[0].len()).map(column).collect(),
        lines: order.iter().map(|(_, row)| grid.lines[*row]).collect(),
        unit: grid.unit.clone(),
        axis: grid.axis.clone(),
        ..Grid::default()
    }
}
