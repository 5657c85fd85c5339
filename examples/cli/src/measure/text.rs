//! A reading for people.

use crate::failure::printable;
use crate::measure::args::Unit;
use crate::measure::facts::{self, Fact};
use crate::measure::reading::{Bench, Note, Reading};
use crate::output::{plot, terminal};
use crate::usage::name_of;
use std::fmt::{self, Write};
use std::path::Path;

/// Where the values stand.
const INDENT: usize = 22;
const WIDTH: usize = 92;

/// The report; with escapes for colour if `truecolor`.
pub fn report(bench: &Bench, reading: &Reading, picture: Option<&Path>, truecolor: bool) -> String {
    let mut report = Report(String::new());
    // Writing to a String cannot fail.
    let _ = report.all(bench, reading, picture, truecolor);
    report.0
}

struct Report(String);

impl Report {
    fn all(
        &mut self,
        bench: &Bench,
        reading: &Reading,
        picture: Option<&Path>,
        truecolor: bool,
    ) -> fmt::Result {
        self.title(bench, reading)?;
        for line in plot::lines(&reading.curve, truecolor) {
            writeln!(self.0, "  {line}")?;
        }
        writeln!(self.0)?;
        if let (true, Some(srgb)) = (truecolor, reading.srgb) {
            let swatch = terminal::patch(srgb.map(|c| (c * 255.0).round() as u8), 16);
            writeln!(self.0, "  {swatch}\n  {swatch}\n")?;
        }
        self.rows(&facts::facts(bench, reading))?;
        if let Some(path) = picture {
            self.row("picture", path.display())?;
        }
        if let Some(comparison) = &reading.compare {
            writeln!(self.0, "\n  minus {}", printable(&comparison.to))?;
            self.rows(&facts::differences(comparison))?;
        }
        self.notes(&reading.notes)
    }

    fn title(&mut self, bench: &Bench, reading: &Reading) -> fmt::Result {
        let (name, file) = (printable(&reading.name), printable(&reading.file));
        let kind = match (&bench.room, bench.unit) {
            (Some(room), _) => format!("reflectance under {}", printable(&room.light.name)),
            (None, Unit::Relative) => "light, relative".into(),
            (None, Unit::Absolute) => "light, W/m2/nm".into(),
        };
        let between = name_of(bench.between);
        writeln!(self.0, "{name}   ({file}: {kind}; {}; {between} to 1 nm)\n", bench.eye.title())
    }

    /// Notes with the same text together, broken at words.
    fn notes(&mut self, notes: &[Note]) -> fmt::Result {
        let mut grouped: Vec<(String, &str)> = Vec::new();
        for note in notes {
            match grouped.last_mut() {
                Some((keys, text)) if *text == note.text => *keys += &format!(", {}", note.key),
                _ => grouped.push((note.key.clone(), &note.text)),
            }
        }
        writeln!(self.0)?;
        for (k, (keys, text)) in grouped.iter().enumerate() {
            let mut line = format!("  {}", if k == 0 { "notes  " } else { "       " });
            for word in printable(&format!("{keys}: {text}")).split(' ') {
                if line.len() + word.len() > WIDTH {
                    writeln!(self.0, "{}", line.trim_end())?;
                    line = " ".repeat(11);
                }
                line += word;
                line.push(' ');
            }
            writeln!(self.0, "{}", line.trim_end())?;
        }
        writeln!(self.0)
    }

    fn rows(&mut self, facts: &[Fact]) -> fmt::Result {
        facts.iter().try_for_each(|fact| self.row(&fact.label, &fact.value))
    }

    fn row(&mut self, label: &str, value: impl fmt::Display) -> fmt::Result {
        writeln!(self.0, "  {label:<INDENT$}{value}")
    }
}
