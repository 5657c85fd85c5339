//! Writes readings as a table for people.

use crate::failure::{Failure, shown};
use crate::flicker::known;
use crate::output::number::{self, fixed, shortest, signed};
use crate::output::plot::BLOCKS;
use crate::output::{Spool, terminal};
use crate::sensor::Report;
use crate::sensor::advice::Next;
use crate::sensor::json;
use crate::sensor::measure::{Color, Reading, Status};
use crate::sensor::runs::Run;
use nanospectra::color::Cct;

/// The lengths of the longest name and of the longest note, in characters.
const NAME: usize = 70;
const NOTE: usize = 600;

/// Prints the report, with the table, the runs and the notes. The readings are computed twice, since the
/// widths of the columns depend on all of them.
pub fn print(report: &Report) -> Result<(), Failure> {
    let mut layout = Layout::default();
    let (mut runs, mut later) = (report.runs(), Spool::new());
    let mut keep =
        |ended: Option<Run>| ended.map_or(Ok(()), |ended| later.add("stdout", flicker(&ended).as_bytes()));
    for reading in report.readings()? {
        let reading = reading?;
        layout.add(report, &reading);
        keep(runs.push(&reading))?;
    }
    keep(runs.end())?;
    let level = if layout.lux { "lux" } else { "Y (relative)" };
    let heading = ["line", "label", "exposure", level, "x, y", "CCT", "Duv", "PPFD", "spectrum", "next"];
    let heading = heading.map(str::to_owned);
    layout.widen(&heading);
    terminal::stream(|out| {
        out.write(&format!("{}\n", report.setup.chip.title()))?;
        for said in &report.colors {
            out.write(&format!("  {}\n", shown(said, NOTE)))?;
        }
        out.write("\n")?;
        out.write(&layout.line(&heading))?;
        for reading in report.readings()? {
            out.write(&layout.line(&row(&reading?)))?;
        }
        later.print(out)?;
        out.write(&layout.notes())
    })
}

/// What the table and the notes need to know of all readings.
#[derive(Default)]
struct Layout {
    lux: bool,
    /// The largest number of characters in each column. One that is empty in every row is left out.
    widths: [usize; 10],
    /// Each note once, as a pair of what it is about and its text.
    notes: Vec<(&'static str, String)>,
    /// The first and the last wavelength of a spectrum, in nm.
    ends_nm: Option<[f32; 2]>,
}

impl Layout {
    fn add(&mut self, report: &Report, reading: &Reading) {
        let color = reading.color.as_ref();
        self.lux |= color.is_some_and(|color| color.lux.is_some());
        for (width, cell) in self.widths.iter_mut().zip(row(reading)) {
            *width = cell.chars().count().max(*width);
        }
        let is_first = self.notes.is_empty();
        let shared = json::general(report.setup, reading).into_iter();
        let shared = shared.chain(report.unused().filter(|_| is_first));
        for note in shared.chain(reading.notes.iter().cloned()) {
            if !self.notes.contains(&note) {
                self.notes.push(note);
            }
        }
        let seen = color.and_then(|color| color.spectrum.as_deref());
        if let (None, Some([first, .., last])) = (self.ends_nm, seen) {
            self.ends_nm = Some([first.0, last.0]);
        }
    }

    /// Makes room for the heading above the columns that are not empty.
    fn widen(&mut self, heading: &[String; 10]) {
        for (width, title) in self.widths.iter_mut().zip(heading).filter(|(width, _)| **width > 0) {
            *width = title.chars().count().max(*width);
        }
    }

    fn line(&self, row: &[String; 10]) -> String {
        let cells = row.iter().zip(self.widths).filter(|(_, width)| *width > 0);
        let line: String = cells.map(|(cell, width)| format!("{cell:<width$}  ")).collect();
        format!("{}\n", line.trim_end())
    }

    /// Returns the notes with their heading.
    fn notes(&self) -> String {
        let mut notes: Vec<String> = self.notes.iter().map(|(key, text)| format!("{key}: {text}")).collect();
        if let Some([first, last]) = self.ends_nm {
            notes.push(format!(
                "spectrum: {} to {} nm in bins of 10 nm, relative to the largest",
                fixed(first, 0),
                fixed(last, 0)
            ));
        }
        if notes.is_empty() {
            return String::new();
        }
        let lines: String = notes.iter().map(|note| format!("  {}\n", shown(note, NOTE))).collect();
        format!("\nnotes\n{lines}")
    }
}

fn row(reading: &Reading) -> [String; 10] {
    let time = reading.entry.time.as_ref().map(|(text, _)| format!("t={text}"));
    let label = reading.entry.label.clone().or(time).unwrap_or_default();
    let next = |next: &Next| if next.same { "as it is".into() } else { next.settings.clone() };
    let mut row = [const { String::new() }; 10];
    row[0] = reading.entry.line.to_string();
    row[1] = shown(&label, NAME);
    row[2].clone_from(&reading.settings);
    row[9] = reading.next.as_ref().map_or_else(String::new, next);
    match (&reading.status, &reading.color) {
        (Status::Ok, Some(color)) => fill(&mut row, color),
        (Status::Negative, Some(color)) => {
            let [x, y, z] = color.xyz.to_array().map(significant);
            row[3] = format!("NEGATIVE: X {x} Y {y} Z {z}");
        }
        (Status::Saturated(channels), _) => {
            let channels: Vec<String> = channels.iter().map(|name| shown(name, NAME)).collect();
            row[3] = format!("SATURATED: {}", channels.join(" "));
        }
        _ => row[3] = "TOO DARK".into(),
    }
    row
}

fn fill(row: &mut [String; 10], color: &Color) {
    let (y, uncertainty) = match (color.lux, color.lux_uncertainty) {
        (Some(lux), Some(uncertainty)) => (lux, uncertainty),
        _ => (color.xyz.y, color.xyz_uncertainty.y),
    };
    row[3] = significant(y) + &within(100.0 * uncertainty / y, 2, "%");
    row[4] = color.xy.map_or_else(String::new, |p| number::all([p.x, p.y], 4, " "));
    match (color.cct, color.cct_uncertainty) {
        (Some(Cct::Near { cct_k, duv }), Some(of)) => {
            row[5] = fixed(cct_k, 0) + &within(of.cct_k.ceil(), 0, " K");
            row[6] = signed(duv, 4) + &within(of.duv, 4, "");
        }
        (Some(Cct::Near { cct_k, duv }), None) => {
            row[5] = fixed(cct_k, 0) + " K";
            row[6] = signed(duv, 4);
        }
        (Some(other), _) => row[5] = json::place(other).into(),
        (None, _) => {}
    }
    row[7] = color.ppfd.map_or_else(String::new, significant);
    row[8] = color.spectrum.as_ref().map_or_else(String::new, |bins| curve(bins));
}

/// Returns an uncertainty behind its number, or that it is unknown.
fn within(uncertainty: f32, decimals: usize, unit: &str) -> String {
    if uncertainty.is_finite() {
        format!(" ±{}{unit}", fixed(uncertainty, decimals))
    } else {
        format!("{unit} ±unknown")
    }
}

/// Draws a spectrum with block characters, where negative values are empty.
fn curve(bins: &[(f32, f32)]) -> String {
    let top = bins.iter().map(|bin| bin.1).fold(f32::MIN_POSITIVE, f32::max);
    bins.iter().map(|bin| BLOCKS[(8.0 * bin.1 / top).ceil().clamp(0.0, 8.0) as usize]).collect()
}

fn flicker(run: &Run) -> String {
    let name = run.label.as_deref().map_or("all".into(), |label| shown(label, NAME));
    let (from, to) = run.lines;
    let mut text = format!("\n{name}: {} readings, lines {from}..{to}", run.readings);
    match &run.rate_hz {
        Ok(rate) => text += &format!(", {} per second\n  Pst LM {}\n", fixed(*rate, 1), known(&run.pst_lm)),
        Err(why) => text += &format!("; the flicker is unknown: {why}\n"),
    }
    for at in &run.flicker {
        text += &match &at.flicker.found {
            Ok((flicker, amplitude)) => format!(
                "  {} Hz: mean {}, percent flicker {} %, flicker index {}, amplitude {} of the mean \
                 (readings show {} % of it{}), SVM {}\n",
                shortest(at.flicker.frequency_hz),
                significant(flicker.mean),
                fixed(flicker.percent, 1),
                fixed(flicker.index, 3),
                fixed(*amplitude, 3),
                fixed(100.0 * at.shown, 1),
                at.confused_with_hz.map_or(String::new(), |hz| format!(
                    "; the run is too short to distinguish it from {} Hz",
                    shortest(hz)
                )),
                known(&at.flicker.svm)
            ),
            Err(why) => format!("  {} Hz: {why}\n", shortest(at.flicker.frequency_hz)),
        };
    }
    text
}

fn significant(value: f32) -> String {
    number::significant(value, 5)
}
