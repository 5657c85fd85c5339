//! Brings other arrangements of columns to an axis with curves beside it.

mod bands;
mod folded;
mod long;

use crate::grid::Grid;
use crate::refusal::Note;

/// Returns grids that have one axis each, and says what was assumed.
pub fn arrange(grid: Grid, notes: &mut Vec<Note>) -> Vec<Grid> {
    if grid.transposed || grid.is_known {
        return vec![grid];
    }
    match folded::unfold(&grid, notes).or_else(|| bands::join(&grid, notes)) {
        Some(grid) => vec![grid],
        None => long::split(&grid, notes).unwrap_or_else(|| vec![grid]),
    }
}
