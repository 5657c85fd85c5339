//! Chooses the columns that are axes, and their units.

use crate::grid::{Column, Grid, Said};
use crate::options::{Choice, Options};
use crate::refusal::{Note, Refusal, Setting};
use crate::unit::{AxisUnit, names_axis};

/// An axis and the columns that belong to it.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    pub column: usize,
    pub unit: AxisUnit,
    pub values: Vec<usize>,
}

/// The wavelengths in nm that are taken for such if nothing is said: from the shortest ultraviolet of
/// spectrometers to the end of their near infrared.
const LIKELY: std::ops::RangeInclusive<f64> = 150.0..=3500.0;

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

/// Returns the place of a chosen column.
pub fn chosen(grid: &Grid, choice: &Choice) -> Result<usize, Refusal> {
    let count = grid.columns.len();
    match choice {
        Choice::Number(number) if (1..=count).contains(number) => Ok(number - 1),
        Choice::Number(number) => {
            Err(Refusal::of(format!("there is no column {number}; the table has {count}"))
                .settled_by(Setting::Column))
        }
        Choice::Name(wanted) => {
            let is_it =
                |column: &Column| column.name.as_deref().is_some_and(|name| name.trim() == wanted.trim());
            let mut found = (0..count).filter(|place| is_it(&grid.columns[*place]));
            match (found.next(), found.next()) {
                (Some(place), None) => Ok(place),
                (Some(_), Some(_)) => {
                    Err(Refusal::of(format!("several columns are named '{wanted}'; give a number"))
                        .settled_by(Setting::Column))
                }
                _ => {
                    let names: Vec<&str> =
                        grid.columns.iter().filter_map(|column| column.name.as_deref()).collect();
                    let known = if names.is_empty() {
                        "none has a name".into()
                    } else {
                        format!("there are {}", names.join(", "))
                    };
                    Err(Refusal::of(format!("no column is named '{wanted}'; {known}"))
                        .settled_by(Setting::Column))
                }
            }
        }
    }
}

fn axis_columns(grid: &Grid, options: &Options, notes: &mut Vec<Note>) -> Result<Vec<usize>, Refusal> {
    let columns = &grid.columns;
    if let Some(choice) = &options.axis_column {
        return Ok(vec![chosen(grid, choice)?]);
    }
    if grid.transposed || grid.is_known {
        return Ok(vec![0]);
    }
    let is_named = |column: &Column| {
        column.name.as_deref().is_some_and(names_axis)
            || column
                .unit
                .as_ref()
                .is_some_and(|said| AxisUnit::in_heading(&said.text).is_some() && names_or_bare(said))
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
        return Ok(vec![first]);
    }
    match rising.iter().find(|place| is_likely(&columns[**place])) {
        Some(&place) => {
            notes.push(Note::assumed(
                format!(
                    "column {} has the wavelengths, and column {} only counts the rows",
                    place + 1,
                    first + 1
                ),
                Some(Setting::Column),
            ));
            Ok(vec![place])
        }
        None => Err(Refusal::at(
            grid.lines.first().copied().unwrap_or(1),
            format!("column {} counts the rows, and no other column has wavelengths", first + 1),
        )
        .settled_by(Setting::Column)),
    }
}

/// Returns whether a cell of units has nothing beside the unit of an axis, or is a label such as `380nm`.
fn names_or_bare(said: &Said) -> bool {
    !said.text.contains('/') && !said.text.contains("-1")
        || said.text.starts_with(|c: char| c.is_ascii_digit())
}

fn is_empty(column: &Column) -> bool {
    column.missing() == column.values.len()
}

fn is_likely(column: &Column) -> bool {
    column.values.iter().all(|value| value.is_nan() || LIKELY.contains(value)) && !column.counts()
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
