//! Reads a matrix to XYZ from a file, or fits one to patches in a file.

use crate::failure::Failure;
use crate::output::number::fixed;
use crate::sensor::cells::{Row, Table};
use nanospectra::color::Xyz;
use nanospectra::sensor::{BasicCounts, Calibration, Fit, FitError};
use std::path::Path;

const XYZ: [&str; 3] = ["x", "y", "z"];

/// A matrix and the line of the report about it.
pub struct Found<const C: usize> {
    pub matrix: Calibration<C>,
    pub said: String,
}

pub fn read<const C: usize>(path: &Path, channels: &[String]) -> Result<Found<C>, Failure> {
    let table = Table::read(path)?;
    let places: [usize; C] = table
        .places(channels)?
        .try_into()
        .map_err(|_| table.wrong("the table has another number of channels; check --sensor"))?;
    match XYZ.map(|name| table.place(name)) {
        [Some(x), Some(y), Some(z)] => patches(&table, places, [x, y, z]),
        _ => matrix(&table, places),
    }
}

/// Reads the matrix from the rows X, Y and Z.
fn matrix<const C: usize>(table: &Table, places: [usize; C]) -> Result<Found<C>, Failure> {
    let shape = "give three rows X, Y, Z (heading: row and the channels), or patches with columns X, Y, Z";
    let Some(name) = table.place("row") else {
        return Err(table.wrong(format_args!("this is neither a matrix nor patches; {shape}")));
    };
    let mut rows = [[0.0; C]; 3];
    for (row, wanted) in rows.iter_mut().zip(XYZ) {
        let is_wanted = |row: &Row| row.cells[name].eq_ignore_ascii_case(wanted);
        let found = table.rows()?.filter(|row| row.as_ref().is_ok_and(is_wanted));
        let found = found.take(2).collect::<Result<Vec<Row>, Failure>>()?;
        let [cells] = &found[..] else {
            let wanted = wanted.to_uppercase();
            return Err(table.wrong(format_args!("there is not exactly one row {wanted}; {shape}")));
        };
        for (value, place) in row.iter_mut().zip(places) {
            *value = table.number(cells, place)? as f32;
        }
    }
    for row in table.rows()? {
        let row = row?;
        if !XYZ.contains(&row.cells[name].to_lowercase().as_str()) {
            return Err(table.wrong_at(&row, format_args!("this row is none of X, Y, Z; {shape}")));
        }
    }
    Ok(Found { matrix: Calibration::from_rows(rows), said: format!("matrix of {}", table.file()) })
}

/// Fits the matrix to rows of basic counts and of the XYZ that they should give.
fn patches<const C: usize>(table: &Table, places: [usize; C], xyz: [usize; 3]) -> Result<Found<C>, Failure> {
    let mut fit = Fit::<C>::new();
    let mut all = Vec::new();
    for row in table.rows()? {
        let row = row?;
        let mut basic = [0.0; C];
        for (value, place) in basic.iter_mut().zip(places) {
            *value = table.number(&row, place)? as f32;
        }
        let mut target = [0.0; 3];
        for (value, place) in target.iter_mut().zip(xyz) {
            *value = table.number(&row, place)? as f32;
        }
        if target[1] <= 0.0 {
            return Err(table.wrong_at(&row, "Y is not above zero; leave out dark patches"));
        }
        let basic = BasicCounts::new(basic);
        fit.add_relative(&basic, Xyz::from(target));
        all.push((basic, target));
    }
    let wrong = |error: FitError| Failure::of(table.file(), format_args!("no matrix can be fitted; {error}"));
    let matrix = fit.solve().map_err(wrong)?;
    let percent = |share: f32| 100.0 * share;
    let [x, y, z] = fit.residual_rms().map(|share| fixed(percent(share), 2));
    let mut said = format!(
        "matrix fitted to {} patches of {}; root mean square errors relative to Y: \
         X {x} % Y {y} % Z {z} %",
        all.len(),
        table.file()
    );
    let mut sums = [0.0; 3];
    let unseen = all.iter().try_for_each(|(basic, target)| {
        let errors = fit.leave_one_out(basic, *target, 1.0 / target[1])?;
        for (sum, error) in sums.iter_mut().zip(errors) {
            *sum += (error / target[1]).powi(2);
        }
        Ok::<_, FitError>(())
    });
    said += &match unseen {
        Ok(()) => {
            let [x, y, z] = sums.map(|sum: f32| fixed(percent((sum / all.len() as f32).sqrt()), 2));
            format!("; on patches that were left out of the fit: X {x} % Y {y} % Z {z} %")
        }
        Err(error) => format!("; the error on patches that are left out is unknown: {error}"),
    };
    said += &format!("; condition number {}", fixed(fit.condition().map_err(wrong)?, 0));
    Ok(Found { matrix, said })
}
