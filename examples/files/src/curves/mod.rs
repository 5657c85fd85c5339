//! Makes curves of columns.

mod axis;
mod values;

use crate::grid::Grid;
use crate::options::Options;
use crate::reading::Reading;
use crate::refusal::{Note, Refusal, Setting};
use axis::Axis;

/// Adds the curves of a grid to a reading.
pub fn add(grid: &Grid, options: &Options, reading: &mut Reading) -> Result<(), Refusal> {
    let axes = axis::find(grid, options, &mut reading.notes)?;
    if grid.transposed {
        reading.notes.push(Note::assumed(
            format!(
                "each row is a spectrum, and line {} has the wavelengths",
                grid.lines.first().unwrap_or(&1)
            ),
            None,
        ));
    }
    let chosen: Vec<usize> =
        options.columns.iter().map(|choice| axis::chosen(grid, choice)).collect::<Result<_, _>>()?;
    for axis in &axes {
        for &place in &axis.values {
            if chosen.is_empty() || chosen.contains(&place) {
                curve(grid, axis, place, !chosen.is_empty(), options, reading)?;
            }
        }
    }
    Ok(())
}

/// Adds the curve of one column, or says why it is left out.
fn curve(
    grid: &Grid,
    axis: &Axis,
    place: usize,
    wanted: bool,
    options: &Options,
    reading: &mut Reading,
) -> Result<(), Refusal> {
    let column = &grid.columns[place];
    let title = column.name.as_ref().map_or(format!("column {}", place + 1), |name| format!("'{name}'"));
    let left_out = |what: &str| Note::left_out(format!("{title} {what}"));
    let count = column.values.len();
    if column.missing() == count {
        let what = if column.texts > 0 { "holds words" } else { "is empty" };
        if wanted {
            return Err(Refusal::of(format!("{title} {what}")).settled_by(Setting::Column));
        }
        reading.notes.push(left_out(what));
        return Ok(());
    }
    if let Some(said) = &column.text {
        if column.texts * 2 > count && !wanted {
            reading.notes.push(left_out("holds words"));
            return Ok(());
        }
        let what = format!("{title} is '{}', which is not a number; correct it", said.text);
        return Err(Refusal::at(said.line, what).settled_by(Setting::Column));
    }
    if !wanted && !grid.is_known && column.counts() {
        reading.notes.push(left_out("only counts the rows"));
        return Ok(());
    }
    if !wanted && column.values.iter().all(|value| *value == 0.0 || value.is_nan()) {
        reading.notes.push(left_out("is zero everywhere"));
        return Ok(());
    }
    let curve = values::curve(grid, axis, place, &title, options, &mut reading.notes)?;
    reading.curves.push(curve);
    Ok(())
}
