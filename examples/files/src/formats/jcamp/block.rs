//! One block of a file: labels, and the data of one curve.

use super::compressed;
use super::points::{self, Points};
use crate::formats::contents::{Spectrum, TWICE, highest, part};
use crate::grid::Said;
use crate::refusal::{Note, Refusal, Setting};
use crate::text::lines::Line;
use crate::unit::{AxisUnit, Quantity, Unit};
use std::ops::Range;

/// A block, from its title to its end.
#[derive(Default)]
pub struct Block {
    /// The labels, with their values and their lines.
    labels: Vec<(String, String, usize)>,
    /// The label of the data, with its value and its line.
    data: Option<(String, String, usize)>,
    /// The places of the lines of the data.
    rows: Range<usize>,
    /// Whether the data go on in the next line.
    goes_on: bool,
}

/// The labels of data that are curves.
const CURVES: [&str; 2] = ["XYDATA", "XYPOINTS"];

/// The labels of data that are none, with what they hold.
const OTHERS: [(&str, &str); 5] = [
    ("PEAKTABLE", "a table of peaks"),
    ("PEAKASSIGNMENTS", "a table of peaks"),
    ("NTUPLES", "a table of several variables (NTUPLES)"),
    ("RADATA", "an interferogram"),
    ("ASSIGNMENTS", "a table of peaks"),
];

/// Words of DATA TYPE that tell that the axis is no wavelength of light.
const NO_LIGHT: [&str; 10] =
    ["NMR", "MASS", "RAMAN", "CHROMATO", "NEUTRON", "EPR", "ESR", "MOBILITY", "FID", "INTERFEROGRAM"];

impl Block {
    /// Takes the label of a line, at its place among the lines.
    pub fn state(&mut self, name: String, value: &str, line: usize, place: usize) {
        let is_curve = CURVES.contains(&name.as_str());
        self.goes_on = is_curve && self.data.as_ref().is_none_or(|data| !CURVES.contains(&data.0.as_str()));
        if self.goes_on {
            self.rows = place + 1..place + 1;
        }
        let is_other = OTHERS.iter().any(|(other, _)| *other == name);
        if self.goes_on || (is_other && self.data.is_none()) {
            self.data = Some((name, value.to_owned(), line));
        } else {
            self.labels.push((name, value.to_owned(), line));
        }
    }

    /// Takes a line without a label.
    pub fn goes_on(&mut self, place: usize) {
        if self.goes_on {
            self.rows.end = place + 1;
        }
    }

    pub fn has_data(&self) -> bool {
        self.data.is_some()
    }

    pub fn value(&self, name: &str) -> Option<&str> {
        self.label(name).map(|(value, _)| value)
    }

    fn label(&self, name: &str) -> Option<(&str, usize)> {
        let found = self.labels.iter().find(|label| label.0 == name && !label.1.is_empty());
        found.map(|label| (label.1.as_str(), label.2))
    }

    fn number(&self, name: &str) -> Result<Option<f64>, Refusal> {
        let Some((value, line)) = self.label(name) else { return Ok(None) };
        let text = value.split_whitespace().next().unwrap_or("");
        match text.replace(',', ".").parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(Some(number)),
            _ => Err(Refusal::at(line, format!("{name} is '{value}', which is not a number; correct it"))),
        }
    }

    /// Reads the spectrum of the block, if it has data.
    pub fn read(&self, lines: &[Line], notes: &mut Vec<Note>) -> Result<Option<Spectrum>, Refusal> {
        let Some((name, form, line)) = &self.data else { return Ok(None) };
        if let Some((_, what)) = OTHERS.iter().find(|(other, _)| other == name) {
            let what =
                format!("the data are {what}, which is no curve; export the spectrum itself as XYDATA");
            return Err(Refusal::at(*line, what));
        }
        let kind = self.value("DATATYPE").unwrap_or("").to_uppercase();
        if NO_LIGHT.iter().any(|word| kind.contains(word)) {
            let line = self.label("DATATYPE").map_or(*line, |label| label.1);
            let what = format!("the file holds '{kind}', whose axis is not the wavelength of light");
            return Err(Refusal::at(line, what));
        }
        let axis = self.axis()?;
        let rows = &lines[self.rows.clone()];
        let form: String = form.chars().filter(|c| !c.is_whitespace()).collect::<String>().to_uppercase();
        let points = if form.contains("X++(Y..Y)") || (form.is_empty() && name == "XYDATA") {
            self.steps(rows, *line)?
        } else if form.contains("XY..XY") || form.is_empty() {
            points::pairs(rows)?
        } else {
            let what =
                format!("the form {form} of the data is not known; export them as (X++(Y..Y)) or (XY..XY)");
            return Err(Refusal::at(*line, what));
        };
        let factor = self.number("YFACTOR")?.unwrap_or(1.0);
        let values: Vec<f64> = points.values.iter().map(|value| value * factor).collect();
        let mut places = points.places;
        if form.contains("XY..XY") {
            let factor = self.number("XFACTOR")?.unwrap_or(1.0);
            places.iter_mut().for_each(|place| *place *= factor);
        }
        self.check_count(values.len())?;
        let unit = self.unit(highest(&values), notes)?;
        let last = rows.last().map_or(*line, |row| row.number);
        let title = self.value("TITLE").map(str::to_owned);
        Ok(Some(Spectrum { name: title, axis, places, values, unit, lines: *line..=last }))
    }

    /// Reads data that state the first place of each line only.
    fn steps(&self, rows: &[Line], line: usize) -> Result<Points, Refusal> {
        let rows = compressed::decode(rows)?;
        let count: usize = rows.iter().map(|row| row.values.len()).sum();
        let factor = self.number("XFACTOR")?.unwrap_or(1.0);
        let (Some(first_row), Some(last_row)) = (rows.first(), rows.last()) else {
            return Err(Refusal::at(line, "there are no data below this line; export the file again"));
        };
        self.check_count(count)?;
        let first = self.number("FIRSTX")?.unwrap_or(first_row.place * factor);
        let intervals = count.max(2) as f64 - 1.0;
        let step = match (self.number("LASTX")?, self.number("DELTAX")?) {
            (Some(last), _) => (last - first) / intervals,
            (None, Some(step)) => step,
            (None, None) if last_row.index > 0 => (last_row.place * factor - first) / last_row.index as f64,
            (None, None) => {
                let what = "neither LASTX nor DELTAX is stated, so the steps are not known; add one of them";
                return Err(Refusal::at(line, what));
            }
        };
        for row in &rows {
            let expected = first + row.index as f64 * step;
            // Places may be rounded to whole numbers.
            let allowed = 1.5 * step.abs() + factor.abs() / 2.0;
            if (row.place * factor - expected).abs() > allowed {
                let what = format!(
                    "this line begins at {}, where FIRSTX, LASTX and NPOINTS lead to {expected}; points are missing \
                     above it, or one of the three is wrong",
                    row.place * factor
                );
                return Err(Refusal::at(row.line, what));
            }
        }
        let places = (0..count).map(|index| first + index as f64 * step).collect();
        Ok(Points { places, values: rows.into_iter().flat_map(|row| row.values).collect() })
    }

    fn check_count(&self, count: usize) -> Result<(), Refusal> {
        let Some(said) = self.number("NPOINTS")? else { return Ok(()) };
        if said == count as f64 {
            return Ok(());
        }
        let line = self.label("NPOINTS").map_or(1, |label| label.1);
        let what = format!(
            "NPOINTS says {said}, and there are {count} points; the file was cut or changed, so export it again"
        );
        Err(Refusal::at(line, what))
    }

    /// Returns what the axis is, in words of the file.
    fn axis(&self) -> Result<String, Refusal> {
        let Some((said, line)) = self.label("XUNITS") else { return Ok("wavelength".to_owned()) };
        // Hertz are those of magnetic resonance.
        if AxisUnit::in_heading(said).is_some_and(|unit| unit != AxisUnit::Hertz) {
            return Ok(said.to_owned());
        }
        let what =
            format!("XUNITS says '{said}', which is not a unit of wavelength; it takes NANOMETERS or 1/CM");
        Err(Refusal::at(line, what))
    }

    /// Returns what the values are, in words that state a unit.
    fn unit(&self, high: f64, notes: &mut Vec<Note>) -> Result<Option<Said>, Refusal> {
        let Some((said, line)) = self.label("YUNITS") else { return Ok(None) };
        let low = said.to_lowercase();
        if low.contains("kubelka") {
            let what = "the values are those of Kubelka and Munk, not reflectances; export the reflectances";
            return Err(Refusal::at(line, what));
        }
        let found = if low.contains("arbitrary") || low.contains("relative") {
            Some(Unit::RELATIVE)
        } else {
            Unit::parse(said).or_else(|| Unit::in_heading(said))
        };
        let text = match found {
            None => {
                let what = format!(
                    "the values are taken as they are, because YUNITS says '{said}', which is not known"
                );
                notes.push(Note::assumed(what, Some(Setting::Unit)));
                return Ok(None);
            }
            Some(unit) if unit.quantity == Quantity::Relative => "relative".to_owned(),
            Some(unit) if unit.factor == 1.0 && unit.quantity == Quantity::Reflectance => {
                part("reflectance", high, TWICE, notes)
            }
            Some(unit) if unit.factor == 1.0 && unit.quantity == Quantity::Transmittance => {
                part("transmittance", high, TWICE, notes)
            }
            Some(_) => said.to_owned(),
        };
        Ok(Some(Said { text, line }))
    }
}
