//! Reads a log of counts.

use crate::failure::{Failure, short};
use crate::sensor::args::Args;
use crate::sensor::cells::{Row, Table};
use crate::sensor::chip::Chip;
use nanospectra::sensor::Exposure;
use std::path::Path;

/// Simulated readings of known lamps. The header says how they were made.
const KNOWN_LAMPS: &str = include_str!("../../data/known_lamps.csv");

/// A log that has been checked. Its entries are read from its file when they are asked for.
pub struct Log {
    table: Table,
    chip: Chip,
    /// The names of the channels, in the order of the counts.
    pub channels: Vec<String>,
    /// The names of the columns that are not used, separated by commas, if there are some.
    pub unused: Option<String>,
    columns: Columns,
}

/// The places of the columns in the table.
struct Columns {
    time: Option<usize>,
    label: Option<usize>,
    temperature_c: Option<usize>,
    /// `None` in a dark log without exposures.
    settings: Option<Vec<usize>>,
    counts: Vec<usize>,
    dark: Option<Vec<usize>>,
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
}

/// Opens the log that the options name, or the bundled one, and checks every entry.
pub fn read(args: &Args) -> Result<Log, Failure> {
    let table = match &args.log {
        Some(path) => Table::read(path)?,
        None => Table::bundled("known_lamps.csv", KNOWN_LAMPS)?,
    };
    let channels = channels(&table, args.sensor)?;
    Log::of(table, args.sensor, channels, true)
}

/// Opens a log of the dark, which has the same channels and perhaps no exposures.
pub fn read_dark(path: &Path, chip: Chip, channels: &[String]) -> Result<Log, Failure> {
    let table = Table::read(path)?;
    let exposed = chip.settings().iter().any(|name| table.place(name).is_some());
    Log::of(table, chip, channels.to_vec(), exposed)
}

/// Returns the channels, which are those of the chip, or all columns of a custom sensor that are nothing
/// else.
fn channels(table: &Table, chip: Chip) -> Result<Vec<String>, Failure> {
    if chip.0.is_some() {
        return Ok(chip.channels().iter().map(|name| (*name).to_owned()).collect());
    }
    let others = ["time", "label", "temperature_c"];
    let settings = chip.settings();
    let is_channel =
        |name: &&str| !others.contains(name) && !settings.contains(name) && !name.starts_with("dark_");
    let names = table.heading.iter().map(|name| &**name);
    let channels: Vec<String> = names.filter(is_channel).map(str::to_owned).collect();
    if channels.is_empty() {
        return Err(table.wrong("there is no channel; add a column of counts for each"));
    }
    Ok(channels)
}

impl Log {
    fn of(table: Table, chip: Chip, channels: Vec<String>, exposed: bool) -> Result<Self, Failure> {
        let settings = exposed.then(|| table.places(&chip.settings())).transpose()?;
        let counts = table.places(&channels)?;
        let has_dark = table.heading.iter().any(|name| name.starts_with("dark_"));
        let dark_names = channels.iter().map(|name| format!("dark_{name}"));
        let dark = has_dark.then(|| table.places(&dark_names.collect::<Vec<_>>())).transpose()?;
        let [time, label, temperature_c] = ["time", "label", "temperature_c"].map(|name| table.place(name));
        let columns = Columns { time, label, temperature_c, settings, counts, dark };
        let unused = columns.unused(&table);
        let log = Log { table, chip, channels, unused, columns };
        log.entries()?.try_for_each(|entry| entry.map(|_| ()))?;
        Ok(log)
    }

    /// The name of the file, for messages.
    pub fn file(&self) -> &str {
        self.table.file()
    }

    /// Returns whether readings have their own counts in the dark.
    pub fn has_dark(&self) -> bool {
        self.columns.dark.is_some()
    }

    /// Reads the entries from the first one. One iterator is in use at a time.
    pub fn entries(&self) -> Result<impl Iterator<Item = Result<Entry, Failure>>, Failure> {
        Ok(self.table.rows()?.map(|row| self.entry(&row?)))
    }

    fn entry(&self, row: &Row) -> Result<Entry, Failure> {
        let (table, columns) = (&self.table, &self.columns);
        let cell = |place: usize| row.cells[place].to_owned();
        let seconds = |text: &str| text.parse().ok().filter(|seconds: &f64| seconds.is_finite());
        let (settings, exposure) = match &columns.settings {
            Some(places) => {
                let values =
                    places.iter().map(|place| table.number(row, *place)).collect::<Result<Vec<_>, _>>()?;
                let exposure = exposure(table, row, self.chip, places, &values)?;
                (values, Some(exposure))
            }
            None => (Vec::new(), None),
        };
        Ok(Entry {
            line: row.line,
            time: columns.time.map(|place| (cell(place), seconds(&row.cells[place]))),
            label: columns.label.map(cell),
            temperature_c: columns
                .temperature_c
                .map(|place| table.number(row, place))
                .transpose()?
                .map(|celsius| celsius as f32),
            settings,
            exposure,
            counts: counted(table, row, self.chip, &columns.counts)?,
            dark: columns.dark.as_ref().map(|places| counted(table, row, Chip(None), places)).transpose()?,
        })
    }
}

impl Columns {
    /// Returns the names of the columns that are not used, separated by commas.
    fn unused(&self, table: &Table) -> Option<String> {
        let mut is_used = vec![false; table.heading.len()];
        let several = [self.settings.as_ref(), Some(&self.counts), self.dark.as_ref()];
        let single = [self.time, self.label, self.temperature_c];
        let used = several.into_iter().flatten().flatten().copied().chain(single.into_iter().flatten());
        used.for_each(|place| is_used[place] = true);
        let columns = table.heading.iter().zip(is_used);
        let unused: Vec<&str> = columns.filter(|(_, used)| !used).map(|(name, _)| &**name).collect();
        (!unused.is_empty()).then(|| unused.join(", "))
    }
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
