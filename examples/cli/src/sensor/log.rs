//! Reads a log of counts.

use crate::failure::{Failure, short};
use crate::sensor::args::Args;
use crate::sensor::cells::{self, Row, Table};
use crate::sensor::chip::Chip;
use nanospectra::sensor::Exposure;
use std::path::Path;

/// Simulated readings of known lamps. The header says how they were made.
const KNOWN_LAMPS: &str = include_str!("../../data/known_lamps.csv");

pub struct Log {
    pub file: String,
    /// The names of the channels, in the order of the counts.
    pub channels: Vec<String>,
    pub entries: Vec<Entry>,
}

/// One reading as the chip reported it.
pub struct Entry {
    pub line: usize,
    /// The time as it stands in the log, and in seconds if it is a number.
    pub time: Option<(String, Option<f64>)>,
    pub label: Option<String>,
    pub temperature_c: Option<f32>,
    pub settings: Vec<f64>,
    /// The exposure, which is `None` only in a dark log without exposures.
    pub exposure: Option<Exposure>,
    pub counts: Vec<f64>,
    /// The counts of the `dark_*` columns.
    pub dark: Option<Vec<f64>>,
    /// The names of the columns that are not used, which are the same for all entries.
    pub unused: Vec<String>,
}

/// Reads the log that the options name, or the bundled one.
pub fn read(args: &Args) -> Result<Log, Failure> {
    let table = match &args.log {
        Some(path) => cells::read(path)?,
        None => cells::parse("known_lamps.csv", KNOWN_LAMPS)?,
    };
    of(&table, args.sensor, channels(&table, args.sensor)?, true)
}

/// Reads a log of the dark, which has the same channels and perhaps no exposures.
pub fn read_dark(path: &Path, chip: Chip, channels: &[String]) -> Result<Log, Failure> {
    let table = cells::read(path)?;
    of(&table, chip, channels.to_vec(), chip.settings().iter().any(|name| table.place(name).is_some()))
}

/// Returns the channels, which are those of the chip, or all columns of a custom sensor that are nothing
/// else.
fn channels(table: &Table, chip: Chip) -> Result<Vec<String>, Failure> {
    if chip.0.is_some() {
        return Ok(chip.channels().iter().map(|name| (*name).to_owned()).collect());
    }
    let others = ["time", "label", "temperature_c"];
    let is_channel = |name: &&String| {
        !others.contains(&name.as_str())
            && !chip.settings().contains(&name.as_str())
            && !name.starts_with("dark_")
    };
    let channels: Vec<String> = table.heading.iter().filter(is_channel).cloned().collect();
    if channels.is_empty() {
        return Err(table.wrong("there is no channel; add a column of counts for each"));
    }
    Ok(channels)
}

fn of(table: &Table, chip: Chip, channels: Vec<String>, exposed: bool) -> Result<Log, Failure> {
    let names: Vec<&str> = channels.iter().map(String::as_str).collect();
    let settings = if exposed { table.places(&chip.settings())? } else { Vec::new() };
    let counts = table.places(&names)?;
    let dark_names: Vec<String> = channels.iter().map(|name| format!("dark_{name}")).collect();
    let dark = if table.heading.iter().any(|name| name.starts_with("dark_")) {
        Some(table.places(&dark_names.iter().map(String::as_str).collect::<Vec<_>>())?)
    } else {
        None
    };
    let [time, label, temperature] = ["time", "label", "temperature_c"].map(|name| table.place(name));
    let used: Vec<usize> = [&settings, &counts, dark.as_ref().unwrap_or(&Vec::new())]
        .into_iter()
        .flatten()
        .copied()
        .chain([time, label, temperature].into_iter().flatten())
        .collect();
    let unused: Vec<String> = (0..table.heading.len())
        .filter(|place| !used.contains(place))
        .map(|place| table.heading[place].clone())
        .collect();
    let entry = |row: &Row| {
        let values = settings.iter().map(|place| table.number(row, *place)).collect::<Result<Vec<_>, _>>()?;
        let exposure = if exposed { Some(exposure(table, row, chip, &settings, &values)?) } else { None };
        let time = time.map(|place| (row.cells[place].clone(), row.cells[place].parse::<f64>().ok()));
        Ok(Entry {
            line: row.line,
            time: time.map(|(text, seconds)| (text, seconds.filter(|seconds| seconds.is_finite()))),
            label: label.map(|place| row.cells[place].clone()),
            temperature_c: temperature
                .map(|place| table.number(row, place))
                .transpose()?
                .map(|celsius| celsius as f32),
            settings: values,
            exposure,
            counts: counted(table, row, chip, &counts)?,
            dark: dark.as_ref().map(|places| counted(table, row, Chip(None), places)).transpose()?,
            unused: unused.clone(),
        })
    };
    let entries = table.rows.iter().map(entry).collect::<Result<Vec<_>, Failure>>()?;
    Ok(Log { file: table.file.clone(), channels, entries })
}

fn exposure(
    table: &Table,
    row: &Row,
    chip: Chip,
    places: &[usize],
    values: &[f64],
) -> Result<Exposure, Failure> {
    chip.exposure(values).map_err(|(k, what)| {
        let name = &table.heading[places[k]];
        table.wrong_at(row, format!("'{}' is {}, {what}", short(name), values[k]))
    })
}

fn counted(table: &Table, row: &Row, chip: Chip, places: &[usize]) -> Result<Vec<f64>, Failure> {
    let count = |place: &usize| {
        let (count, name) = (table.number(row, *place)?, &table.heading[*place]);
        let wrong = |what: &str| table.wrong_at(row, format!("'{}' is {count}, {what}", short(name)));
        if count < 0.0 {
            return Err(wrong(
                "which is not a count; give raw counts, and those in the dark in dark_ columns",
            ));
        }
        if chip.counts_are_whole() && count.fract() != 0.0 {
            return Err(wrong("which is not a whole count; give raw counts, not basic or scaled ones"));
        }
        if count > chip.largest_count() {
            return Err(wrong("which is more than the chip can count; correct it, or remove the row"));
        }
        Ok(count)
    };
    places.iter().map(count).collect()
}
