//! Splits long tables, whose rows say to which spectrum they belong.

use crate::grid::{Column, Grid};
use crate::refusal::{Note, Setting};
use crate::unit::names_axis;

/// The fewest samples of a spectrum in a long table.
const FEWEST: usize = 3;

/// The fewest samples of a spectrum if nothing but the wavelengths says where it begins.
const FEWEST_AGAIN: usize = 20;

/// Splits a grid such as `lamp, nm, value`, where the same wavelengths come once for each lamp.
pub fn split(grid: &Grid, notes: &mut Vec<Note>) -> Option<Vec<Grid>> {
    let axis = grid.columns.iter().position(|column| {
        let is_named = column.labeled || column.name.as_deref().is_some_and(names_axis);
        column.texts == 0 && !column.is_monotone() && is_named
    })?;
    let wavelengths = &grid.columns[axis].values;
    let candidates = (0..grid.columns.len()).filter(|place| *place != axis);
    let labeled = candidates
        .filter_map(|place| Some((place, groups(&grid.columns[place])?)))
        .find(|(_, groups)| groups.iter().all(|(_, rows)| is_spectrum(wavelengths, rows)));
    let Some((label, rows)) = labeled else { return again(grid, axis, notes) };
    let title = grid.columns[label].title();
    notes.push(Note::assumed(
        format!("{title} says to which of {} spectra a row belongs", rows.len()),
        Some(Setting::Column),
    ));
    let values = grid.columns.iter().enumerate().filter(|(place, column)| {
        *place != label && *place != axis && column.texts == 0 && column.missing() < column.values.len()
    });
    let places: Vec<usize> = values.map(|(place, _)| place).collect();
    let pick = |place: usize, rows: &[usize]| {
        let column: &Column = &grid.columns[place];
        column.with(rows.iter().map(|row| column.values[*row]).collect())
    };
    let one = |(name, rows): (String, Vec<usize>)| {
        let named = |place: &usize| {
            let column = pick(*place, &rows);
            let own = column.name.clone().filter(|_| places.len() > 1);
            Column {
                name: Some(own.map_or(name.clone(), |own| format!("{name} {own}"))),
                unit: unit(&column),
                ..column
            }
        };
        Grid {
            columns: std::iter::once(pick(axis, &rows)).chain(places.iter().map(named)).collect(),
            lines: rows.iter().map(|row| grid.lines[*row]).collect(),
            unit: grid.unit.clone(),
            axis: grid.axis.clone(),
            ..Grid::default()
        }
    };
    Some(rows.into_iter().map(one).collect())
}

/// Splits a grid whose wavelengths begin anew, such as that of a meter that writes steps of 5 nm and then of 1 nm.
fn again(grid: &Grid, axis: usize, notes: &mut Vec<Note>) -> Option<Vec<Grid>> {
    let wavelengths = &grid.columns[axis].values;
    let mut ends: Vec<usize> =
        (1..wavelengths.len()).filter(|row| wavelengths[*row] <= wavelengths[row - 1]).collect();
    ends.push(wavelengths.len());
    let mut from = 0;
    let mut grids = Vec::new();
    for end in ends {
        let rows: Vec<usize> = (from..end).collect();
        if rows.len() < FEWEST_AGAIN || !is_spectrum(wavelengths, &rows) {
            return None;
        }
        grids.push(Grid {
            columns: grid
                .columns
                .iter()
                .map(|column| column.with(column.values[from..end].to_vec()))
                .collect(),
            lines: grid.lines[from..end].to_vec(),
            unit: grid.unit.clone(),
            axis: grid.axis.clone(),
            ..Grid::default()
        });
        from = end;
    }
    let line = grids.get(1)?.lines.first()?;
    let what =
        format!("the wavelengths begin anew in line {line}, so that there are {} spectra", grids.len());
    notes.push(Note::assumed(what, Some(Setting::Column)));
    Some(grids)
}

/// Returns what the heading of a column says of its unit, since its name gives way to that of a spectrum.
fn unit(column: &Column) -> Option<crate::grid::Said> {
    column.unit.clone().or_else(|| {
        let text = column.name.clone()?;
        Some(crate::grid::Said { text, line: column.heading })
    })
}

/// Returns the rows that have the same word or number in a column, in the order of the file.
fn groups(column: &Column) -> Option<Vec<(String, Vec<usize>)>> {
    let count = column.values.len();
    let name = |row: usize| match column.words.of(row) {
        Some(word) => Some(word.to_owned()),
        None => column.values.get(row).filter(|value| !value.is_nan()).map(f64::to_string),
    };
    let mut places = std::collections::HashMap::new();
    let mut groups: Vec<(String, Vec<usize>)> = Vec::new();
    for row in 0..count {
        let name = name(row)?;
        let place = *places.entry(name.clone()).or_insert_with(|| {
            groups.push((name, Vec::new()));
            groups.len() - 1
        });
        groups[place].1.push(row);
        if groups.len() * FEWEST > count {
            return None;
        }
    }
    (groups.len() > 1).then_some(groups)
}

fn is_spectrum(wavelengths: &[f64], rows: &[usize]) -> bool {
    let mut steps = rows.windows(2).map(|pair| wavelengths[pair[1]] - wavelengths[pair[0]]);
    let mut again = steps.clone();
    rows.len() >= FEWEST && (steps.all(|step| step > 0.0) || again.all(|step| step < 0.0))
}
