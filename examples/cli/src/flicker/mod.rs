//! The command `flicker`, which computes how visible the flicker of a light is from the waveform of a
//! photodiode.

mod args;
pub mod measures;

pub use args::Args;

use crate::failure::{Failure, short, shown};
use crate::input::lines;
use crate::input::stream::Stream;
use crate::output::json::{line, single};
use crate::output::number::{fixed, shortest, significant};
use crate::output::terminal;
use measures::At;
use serde_json::{Value, json};

/// The longest name of a file in a report, in characters.
const NAME: usize = 60;

/// What is known of a waveform.
struct Waveform {
    file: String,
    readings: usize,
    rate_hz: f32,
    pst_lm: Result<f32, String>,
    flicker: Vec<At>,
}

pub fn run(args: &Args) -> Result<(), Failure> {
    args.check()?;
    let text = Stream::open(&args.file)?;
    let values = readings(&text)?;
    let second = measures::first_second(&values, args.rate_hz);
    let waveform = Waveform {
        readings: values.len(),
        rate_hz: args.rate_hz,
        pst_lm: measures::pst_lm(&values, args.rate_hz),
        flicker: args.flicker_hz.iter().map(|hz| measures::at(second, args.rate_hz, *hz)).collect(),
        file: text.file,
    };
    terminal::print(&if args.json { waveform.json() } else { waveform.text() })
}

/// Reads the readings, one in each row. The first row may be a heading.
fn readings(text: &Stream) -> Result<Vec<f32>, Failure> {
    let mut values = Vec::new();
    let (mut rows, mut is_first) = (text.rows()?, true);
    while let Some((row, number)) = rows.next()? {
        let at = |what: String| Failure::at(&text.file, number, what);
        lines::check(row).map_err(at)?;
        let cell = row.trim();
        let value = cell.parse::<f32>().ok().filter(|value| value.is_finite());
        match value {
            Some(value) => values.push(value),
            None if is_first && !cell.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)) => {}
            None => {
                let what = "is not one number; give one reading in each row";
                return Err(at(format!("'{}' {what}", short(cell))));
            }
        }
        is_first = false;
    }
    if values.is_empty() {
        return Err(Failure::at(&text.file, 1, "there are no readings in the file; give one in each row"));
    }
    Ok(values)
}

/// Returns a measure, or why it is unknown.
pub fn known(number: &Result<f32, String>) -> String {
    match number {
        Ok(number) => fixed(*number, 3),
        Err(why) => format!("unknown ({why})"),
    }
}

impl Waveform {
    fn text(&self) -> String {
        let (name, rate) = (shown(&self.file, NAME), fixed(self.rate_hz, 1));
        let mut text = format!("{name}: {} readings, {rate} per second\n", self.readings);
        text += &format!("  Pst LM {}\n", known(&self.pst_lm));
        for at in &self.flicker {
            let hz = shortest(at.frequency_hz);
            text += &match &at.found {
                Ok((flicker, amplitude)) => format!(
                    "  {hz} Hz: mean {}, percent flicker {} %, flicker index {}, amplitude {} of the mean, SVM {}\n",
                    significant(flicker.mean, 5),
                    fixed(flicker.percent, 1),
                    fixed(flicker.index, 3),
                    fixed(*amplitude, 3),
                    known(&at.svm),
                ),
                Err(why) => format!("  {hz} Hz: {why}\n"),
            };
        }
        text
    }

    fn json(&self) -> String {
        let flicker = |at: &At| {
            let found = at.found.as_ref().ok();
            let mut object = json!({
                "frequency_hz": single(at.frequency_hz),
                "mean": found.map(|(flicker, _)| single(flicker.mean)),
                "percent": found.map(|(flicker, _)| single(flicker.percent)),
                "index": found.map(|(flicker, _)| single(flicker.index)),
                "amplitude": found.map(|(_, amplitude)| single(*amplitude)),
                "svm": at.svm.as_ref().ok().map(|svm| single(*svm)),
            });
            if let Err(why) = &at.found {
                object["note"] = json!(why);
            }
            object
        };
        let object = json!({
            "kind": "waveform",
            "file": self.file,
            "readings": self.readings,
            "rate_hz": single(self.rate_hz),
            "pst_lm": self.pst_lm.as_ref().ok().map(|severity| single(*severity)),
            "flicker": self.flicker.iter().map(flicker).collect::<Value>(),
            "notes": measures::unknown(&self.pst_lm, &self.flicker),
        });
        line(object, |_| None)
    }
}
