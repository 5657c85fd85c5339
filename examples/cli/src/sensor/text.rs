//! Writes readings as a table for people.

use crate::failure::shown;
use crate::output::number::{self, fixed, shortest, signed};
use crate::output::plot::BLOCKS;
use crate::sensor::Report;
use crate::sensor::advice::Next;
use crate::sensor::json;
use crate::sensor::measure::{Color, Reading, Status};
use crate::sensor::runs::Run;
use nanospectra::color::Cct;

/// The lengths of the longest name and of the longest note, in characters.
const NAME: usize = 70;
const NOTE: usize = 600;

/// Returns the report, with the table, the runs and the notes.
pub fn report(report: &Report) -> String {
    let lux = report.readings.iter().any(|reading| reading.color.as_ref().is_some_and(|c| c.lux.is_some()));
    let level = if lux { "lux" } else { "Y (relative)" };
    let heading = ["line", "label", "exposure", level, "x, y", "CCT", "Duv", "PPFD", "spectrum", "next"];
    let rows: Vec<[String; 10]> = report.readings.iter().map(row).collect();
    let mut text = format!("{}\n", report.setup.chip.title());
    for said in &report.colors {
        text += &format!("  {}\n", shown(said, NOTE));
    }
    text += "\n";
    let all = || std::iter::once(heading.map(str::to_owned)).chain(rows.iter().cloned());
    // Leave out a column that is empty in every row.
    let widths: [usize; 10] = std::array::from_fn(|k| {
        let empty = rows.iter().all(|row| row[k].is_empty());
        if empty { 0 } else { all().map(|row| row[k].chars().count()).max().unwrap_or(0) }
    });
    for row in all() {
        let cells = row.iter().zip(widths).filter(|(_, width)| *width > 0);
        let line: String = cells.map(|(cell, width)| format!("{cell:<width$}  ")).collect();
        text += &format!("{}\n", line.trim_end());
    }
    for run in &report.runs {
        text += &flicker(run);
    }
    text + &notes(report)
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
        Ok(rate) => text += &format!(", {} per second\n", fixed(*rate, 1)),
        Err(why) => text += &format!("; the flicker is unknown: {why}\n"),
    }
    for at in &run.flicker {
        text += &match &at.found {
            Ok((flicker, amplitude)) => format!(
                "  {} Hz: mean {}, percent flicker {} %, flicker index {}, amplitude {} of the mean \
                 (readings show {} % of it{})\n",
                shortest(at.frequency_hz),
                significant(flicker.mean),
                fixed(flicker.percent, 1),
                fixed(flicker.index, 3),
                fixed(*amplitude, 3),
                fixed(100.0 * at.shown, 1),
                at.confused_with_hz.map_or(String::new(), |hz| format!(
                    "; the run is too short to distinguish it from {} Hz",
                    shortest(hz)
                ))
            ),
            Err(why) => format!("  {} Hz: {why}\n", shortest(at.frequency_hz)),
        };
    }
    text
}

/// Returns each note once.
fn notes(report: &Report) -> String {
    let mut notes: Vec<String> = Vec::new();
    for reading in &report.readings {
        let own = reading.notes.iter().cloned();
        for (key, text) in json::general(&report.setup, reading).into_iter().chain(own) {
            let note = format!("{key}: {text}");
            if !notes.contains(&note) {
                notes.push(note);
            }
        }
    }
    let seen = report.readings.iter().find_map(|reading| reading.color.as_ref()?.spectrum.as_ref());
    if let Some([first, .., last]) = seen.map(Vec::as_slice) {
        notes.push(format!(
            "spectrum: {} to {} nm in bins of 10 nm, relative to the largest",
            fixed(first.0, 0),
            fixed(last.0, 0)
        ));
    }
    if notes.is_empty() {
        return String::new();
    }
    let lines: String = notes.iter().map(|note| format!("  {}\n", shown(note, NOTE))).collect();
    format!("\nnotes\n{lines}")
}

fn significant(value: f32) -> String {
    number::significant(value, 5)
}
