//! Reads measured responsivities from a file.

use crate::failure::Failure;
use crate::sensor::cells::Table;
use crate::sensor::chip::{BINS, Grid};
use nanospectra::{Light, SamplesError};
use std::path::Path;

/// Returns the weights of each channel on the bins, which are the means of its curve times their width.
pub fn read(path: &Path, channels: &[String]) -> Result<Vec<[f32; BINS]>, Failure> {
    let table = Table::read(path)?;
    let nm = table.place("nm").or_else(|| table.place("wavelength_nm")).ok_or_else(|| {
        table.wrong("there is no column 'nm'; begin the heading with it, and give wavelengths in nm")
    })?;
    let places = table.places(channels)?;
    let row = |place: usize| {
        let mut lines = Vec::new();
        let mut samples = Vec::new();
        for row in table.rows()? {
            let row = row?;
            let (nm, value) = (table.number(&row, nm)? as f32, table.number(&row, place)? as f32);
            if value < 0.0 {
                let name = &table.heading[place];
                let what = format!("'{name}' is {value}, which is not a responsivity; give 0 or more");
                return Err(table.wrong_at(&row, what));
            }
            lines.push(row.line);
            samples.push((nm, value));
        }
        let curve = Light::<BINS, Grid>::from_samples(&samples).map_err(|error| match error {
            SamplesError::TooFew { .. } => table.wrong("one wavelength is not a curve; add rows"),
            SamplesError::NotIncreasing { index } => {
                let line = lines.get(index).copied().unwrap_or(table.line);
                Failure::at(table.file(), line, "nm is not above that of the row before; sort the rows")
            }
            other => table.wrong(format_args!("{other}; correct it")),
        })?;
        if curve.iter().all(|(_, value)| value <= 0.0) {
            return Err(table.wrong(format!(
                "'{}' sees nothing between 300 and 1000 nm; check that the wavelengths are in nm",
                table.heading[place]
            )));
        }
        let width = Light::<BINS, Grid>::edge_nm(1) - Light::<BINS, Grid>::edge_nm(0);
        Ok(curve.values().map(|value| value * width))
    };
    places.into_iter().map(row).collect()
}
