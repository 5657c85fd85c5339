//! Makes curves of columns.

mod axis;
mod choice;
mod values;

use crate::grid::{Grid, quoted};
use crate::options::Options;
use crate::reading::Reading;
use crate::refusal::{Note, Refusal, Setting};
use axis::Axis;
use values::Context;

/// Adds the curves of grids to a reading.
pub fn add(grids: &[Grid], options: &Options, reading: &mut Reading) -> Result<(), Refusal> {
    let chosen = choice::of(grids, &options.columns)?;
    let is_alone = grids.iter().map(|grid| grid.columns.len()).sum::<usize>() <= grids.len() + 1;
    let last = |grid: &Grid| grid.columns.iter().map(|column| column.place).max().unwrap_or(1);
    let last_known = grids.iter().filter(|grid| grid.is_known).map(last).max().unwrap_or(1);
    let mut refusals: Vec<(usize, Refusal)> = Vec::new();
    for (grid, chosen) in grids.iter().zip(chosen) {
        if chosen.is_empty() && !options.columns.is_empty() {
            continue;
        }
        let known = reading.notes.len();
        let axes = match axis::find(grid, options, &mut reading.notes) {
            Ok(axes) => axes,
            // Another table of the file may hold the spectrum.
            Err(refusal) if grids.len() > 1 => {
                reading.notes.truncate(known);
                refusals.push((grid.lines.len() * grid.columns.len(), refusal));
                continue;
            }
            Err(refusal) => return Err(refusal),
        };
        // What is zero everywhere is a channel that is off, unless it is all there is.
        let is_dark =
            |place: &usize| grid.columns[*place].values.iter().all(|value| *value == 0.0 || value.is_nan());
        let all_dark = axes.iter().flat_map(|axis| &axis.values).all(is_dark);
        if grid.transposed {
            let line = grid.lines.first().unwrap_or(&1);
            let what = format!("each row is a spectrum, and line {line} has the wavelengths");
            reading.notes.push(Note::assumed(what, None));
        }
        let context = Context {
            lines: grid.lines.as_slice().into(),
            last: if grid.is_known { last_known } else { last(grid) },
            labels: grid.columns.iter().find(|column| column.labeled).and_then(|column| column.unit.as_ref()),
        };
        for axis in &axes {
            for &place in &axis.values {
                if chosen.is_empty() || chosen.contains(&place) {
                    let wanted = !chosen.is_empty() || all_dark || is_alone;
                    curve(grid, axis, place, &context, wanted, options, reading)?;
                }
            }
        }
    }
    if reading.curves.is_empty() {
        // The reason of the largest table is the one that matters.
        return refusals
            .into_iter()
            .max_by_key(|(size, _)| *size)
            .map_or(Ok(()), |(_, refusal)| Err(refusal));
    }
    for (_, Refusal { line, what, .. }) in refusals {
        let line = line.map_or(String::new(), |line| format!(" in line {line}"));
        reading.notes.push(Note::left_out(format!("the table{line}, because {what}")));
    }
    Ok(())
}

/// Adds the curve of one column, or says why it is left out.
fn curve(
    grid: &Grid,
    axis: &Axis,
    place: usize,
    context: &Context,
    wanted: bool,
    options: &Options,
    reading: &mut Reading,
) -> Result<(), Refusal> {
    let column = &grid.columns[place];
    let title = column.title();
    let left_out = |what: &str| Note::left_out(format!("{title} {what}"));
    let count = column.values.len();
    if column.missing() == count {
        let what = if column.texts > 0 { "holds words" } else { "is empty" };
        if wanted && !options.columns.is_empty() {
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
        let what = format!("{title} is {}, which is not a number; correct it", quoted(&said.text));
        return Err(Refusal::at(said.line, what).settled_by(Setting::Column));
    }
    if !wanted && !grid.is_known && place < axis.column {
        let is_same = column.values.windows(2).all(|pair| pair[0] == pair[1]);
        let what = if column.counts() {
            Some("only counts the rows")
        } else {
            Some("is the same everywhere").filter(|_| is_same)
        };
        if let Some(what) = what {
            reading.notes.push(left_out(what));
            return Ok(());
        }
    }
    if !wanted && column.values.iter().all(|value| *value == 0.0 || value.is_nan()) {
        reading.notes.push(left_out("is zero everywhere"));
        return Ok(());
    }
    match values::curve(grid, axis, place, context, options, &mut reading.notes) {
        Ok(curve) => reading.curves.push(curve),
        // Of many spectra that have names of their own, one that is damaged spoils no other.
        Err(refusal) if !wanted && grid.is_known && refusal.setting.is_none() => {
            reading.notes.push(Note::left_out(refusal.to_string()));
        }
        Err(refusal) => return Err(refusal),
    }
    Ok(())
}
