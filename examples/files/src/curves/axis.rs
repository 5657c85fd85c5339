//! Chooses the columns that are axes, and their units.

use super::choice;
use crate::grid::{Column, Grid};
use crate::options::Options;
use crate::refusal::{Note, Refusal, Setting};
use crate::unit::{AxisUnit, LIKELY, Unit, names_axis};

/// An axis and the columns that belong to it.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    pub column: usize,
    pub unit: AxisUnit,
    pub values: Vec<usize>,
}

/// The highest first wavelength, in nm, of what is taken for nm.
const HIGHEST_FIRST: f64 = 1500.0;

/// The fewest rows of which a column beside another one is taken for the axis.
const FEWEST: usize = 4;

/// Finds the axes of a grid, and says what was assumed.
pub fn find(grid: &Grid, options: &Options, notes: &mut Vec<Note>) -> Result<Vec<Axis>, Refusal> {
    let columns = axis_columns(grid, options, notes)?;
    let mut axes = Vec::new();
    for (place, &column) in columns.iter().enumerate() {
        let end = columns.get(place + 1).copied().unwrap_or(grid.columns.len());
        let start = if place == 0 { 0 } else { column };
        let values = (start..end).filter(|other| !columns.contains(other)).collect();
        let unit = unit(&grid.columns[column], grid, options, notes)?;
        axes.push(Axis { column, unit, values });
    }
    Ok(axes)
}

fn axis_columns(grid: &Grid, options: &Options, notes: &mut Vec<Note>) -> Result<Vec<usize>, Refusal> {
    let columns = &grid.columns;
    if let Some(choice) = &options.axis_column {
        let found = choice::in_grid(grid, choice);
        return found.map(|place| vec![place]).ok_or_else(|| choice::unknown(&[grid], choice));
    }
    if grid.transposed || grid.is_known || grid.edges.is_some() {
        return Ok(vec![0]);
    }
    let is_named = |column: &Column| {
        column.labeled
            || column.name.as_deref().is_some_and(names_axis)
            || column.unit.as_ref().is_some_and(|said| is_of_axis(&said.text))
    };
    let named: Vec<usize> = (0..columns.len())
        .filter(|place| is_named(&columns[*place]) && !is_empty(&columns[*place]))
        .collect();
    if let Some(&first) = named.first() {
        return Ok(if named.len() == 1 { vec![first] } else { named });
    }
    let rising: Vec<usize> = (0..columns.len()).filter(|place| columns[*place].is_monotone()).collect();
    let Some(&first) = rising.first() else {
        return Err(Refusal::at(
            grid.lines.first().copied().unwrap_or(1),
            "no column has wavelengths in increasing or decreasing order",
        )
        .settled_by(Setting::Column));
    };
    if !columns[first].counts() {
        let own = own_axes(columns, first);
        if own.len() > 1 {
            let places: Vec<String> = own.iter().map(|place| columns[*place].place.to_string()).collect();
            notes.push(Note::assumed(
                format!("each spectrum has an axis of its own, in columns {}", places.join(", ")),
                Some(Setting::Column),
            ));
        }
        return Ok(own);
    }
    // A column of another name holds something else.
    let may_be_axis = |place: &&usize| {
        let column = &columns[**place];
        is_likely(column) && column.name.is_none() && column.values.len() >= FEWEST
    };
    match rising.iter().find(may_be_axis) {
        Some(&place) => {
            notes.push(Note::assumed(
                format!(
                    "{} has the wavelengths, and {} only counts the rows",
                    columns[place].title(),
                    columns[first].title()
                ),
                Some(Setting::Column),
            ));
            Ok(vec![place])
        }
        None => Err(Refusal::at(
            grid.lines.first().copied().unwrap_or(1),
            format!("{} counts the rows, and no other column has wavelengths", columns[first].title()),
        )
        .settled_by(Setting::Column)),
    }
}

/// Returns the axes of columns without names: the first one, and those at equal distances that are like it.
fn own_axes(columns: &[Column], first: usize) -> Vec<usize> {
    let alone = vec![first];
    if columns.iter().any(|column| column.name.is_some()) {
        return alone;
    }
    let is_axis = |column: &Column| column.is_monotone() && is_likely(column) && column.is_regular();
    let Some(second) = (first + 2..columns.len()).find(|place| is_axis(&columns[*place])) else {
        return alone;
    };
    let all: Vec<usize> = (first..columns.len()).step_by(second - first).collect();
    let fits = (columns.len() - first).is_multiple_of(second - first);
    if fits && all.iter().all(|place| is_axis(&columns[*place])) { all } else { alone }
}

/// Returns whether a cell of units has that of an axis and nothing else.
fn is_of_axis(said: &str) -> bool {
    AxisUnit::in_heading(said).is_some() && Unit::in_heading(said).is_none()
}

fn is_empty(column: &Column) -> bool {
    column.missing() == column.values.len()
}

/// Returns whether the numbers are wavelengths in nm rather than anything else. Those in angstrom begin higher.
fn is_likely(column: &Column) -> bool {
    let low = column.values.iter().copied().fold(f64::INFINITY, f64::min);
    let fits = column.values.iter().all(|value| value.is_nan() || LIKELY.contains(value));
    fits && low <= HIGHEST_FIRST && !column.counts()
}

/// Returns the unit of an axis: what the user says, what the file says, or nm if the numbers allow nothing else.
fn unit(column: &Column, grid: &Grid, options: &Options, notes: &mut Vec<Note>) -> Result<AxisUnit, Refusal> {
    let said = column.unit.as_ref().and_then(|said| AxisUnit::in_heading(&said.text));
    let said = said.or_else(|| column.name.as_deref().and_then(AxisUnit::in_heading));
    let said = said.or_else(|| grid.axis.as_ref().and_then(|said| AxisUnit::in_heading(&said.text)));
    match (options.axis, said) {
        (Some(wanted), Some(said)) if wanted != said => {
            let what = format!(
                "the file says that the axis is in {}, and the option says {}",
                said.sign(),
                wanted.sign()
            );
            Err(Refusal::of(what).settled_by(Setting::AxisUnit))
        }
        (Some(wanted), _) => Ok(wanted),
        (None, Some(said)) => {
            if said != AxisUnit::Nanometer {
                notes.push(Note::stated(format!("the axis is in {}", said.sign())));
            }
            Ok(said)
        }
        (None, None) if is_likely(column) => {
            notes.push(Note::assumed("the axis is in nm", Some(Setting::AxisUnit)));
            Ok(AxisUnit::Nanometer)
        }
        (None, None) => {
            let low = column.values.iter().copied().fold(f64::INFINITY, f64::min);
            let high = column.values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let what = format!(
                "the unit of the axis is not stated, and {low} to {high} are not wavelengths of light in nm"
            );
            Err(Refusal::of(what).settled_by(Setting::AxisUnit))
        }
    }
}
