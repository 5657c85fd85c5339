//! The table of a CSV file, as the command measure reads it: one column beside the wavelengths.

use crate::failure::Failure;
use crate::input::table;
use std::path::Path;

/// (wavelength in nm, value): increasing, finite, two or more.
pub fn samples(path: &Path) -> Result<Vec<(f32, f32)>, Failure> {
    let (file, table) = table::read(path)?;
    let [column] = &table.columns[..] else {
        let what = format!(
            "{} columns of values where one is wanted; save that one to a file of its own",
            table.columns.len()
        );
        return Err(Failure::of(
            match &table.columns[0].name {
                Some(name) => format!("{file} ({name}, ..)"),
                None => file,
            },
            what,
        ));
    };
    let values = column.values.iter();
    Ok(table.wavelengths.iter().zip(values).map(|(nm, value)| (*nm as f32, *value as f32)).collect())
}
