//! Writes a reading as a report for people.

use crate::failure::{printable, shown};
use crate::measure::facts::{self, Fact};
use crate::measure::level::Kind;
use crate::measure::reading::{Bench, Note, Reading};
use crate::output::Report;
use std::path::Path;

const WIDTH: usize = 92;
/// The lengths of the longest names of a spectrum and of a file, in characters.
pub const NAME: usize = 70;
const FILE: usize = 200;

/// Returns the report of a reading, with terminal escapes for colors if `truecolor`.
pub fn report(bench: &Bench, reading: &Reading, picture: Option<&Path>, truecolor: bool) -> String {
    let mut report = Report::new(22, truecolor);
    report.line(title(bench, reading));
    report.plot(&reading.curve());
    if let (true, Some(srgb)) = (truecolor, reading.srgb) {
        let patch = report.patch(srgb.map(|c| (c * 255.0).round() as u8), 16);
        report.line(format_args!("  {patch}\n  {patch}\n"));
    }
    rows(&mut report, &facts::facts(reading));
    if let Some(path) = picture {
        report.path("picture", path);
    }
    if let Some(comparison) = &reading.compare {
        report.line(format_args!("\n  minus {}", shown(&comparison.to, NAME)));
        rows(&mut report, &facts::differences(comparison));
    }
    notes(&mut report, &reading.notes);
    report.into_text()
}

fn title(bench: &Bench, reading: &Reading) -> String {
    let (name, file) = (shown(&reading.name, NAME), shown(&reading.file, FILE));
    let kind = match reading.kind {
        Kind::Surface => format!("reflectance under {}", shown(&bench.room.light.name, NAME)),
        kind => format!("light, {}", kind.unit()),
    };
    let read = reading
        .origin
        .as_ref()
        .map_or(String::new(), |origin| format!("  read from {}\n", shown(origin, FILE)));
    let rule = reading.rule.map_or("", |rule| rule.name());
    format!("{name}   ({file}: {kind}; {}; {rule} to 1 nm)\n{read}", bench.eye.title)
}

fn rows(report: &mut Report, facts: &[Fact]) {
    facts.iter().for_each(|fact| report.row(&fact.label, &fact.value));
}

/// Writes the notes, where those with the same text share a line, and breaks lines at words.
fn notes(report: &mut Report, notes: &[Note]) {
    let mut grouped: Vec<(String, &str)> = Vec::new();
    for note in notes {
        match grouped.last_mut() {
            Some((keys, text)) if *text == note.text => *keys += &format!(", {}", note.key),
            _ => grouped.push((note.key.clone(), &note.text)),
        }
    }
    report.line("");
    for (k, (keys, text)) in grouped.iter().enumerate() {
        let mut line = format!("  {}", if k == 0 { "notes  " } else { "       " });
        for word in printable(&format!("{keys}: {text}")).split(' ') {
            if line.len() + word.len() > WIDTH {
                report.line(line.trim_end());
                line = " ".repeat(11);
            }
            line += word;
            line.push(' ');
        }
        report.line(line.trim_end());
    }
    report.line("");
}
