//! Reads CGATS.17 and its kin, such as `.sp`, `.ti3` and `.ccss` of ArgyllCMS.

mod fields;
mod units;

use super::contents::{Contents, NANOMETERS, Spectrum};
use crate::grid::Said;
use crate::refusal::{Note, Refusal};
use crate::text::lines::{Line, lines};
use crate::text::number::{Cell, Decimal, cell};
use fields::Fields;

/// Returns whether a text has the keywords of CGATS.
pub fn is_cgats(text: &str) -> bool {
    let first = text.split_whitespace().next().unwrap_or("");
    first.starts_with("CGATS")
        || matches!(first, "SPECT" | "CTI3" | "CCSS")
        || lines(text).any(|line| line.text.trim_start().starts_with("BEGIN_DATA_FORMAT"))
}

/// Reads the tables of a file.
pub fn read(text: &str) -> Result<Contents, Refusal> {
    let mut reader =
        Reader { kind: text.split_whitespace().next().unwrap_or("").into(), ..Reader::default() };
    for line in lines(text) {
        reader.line(line)?;
    }
    match reader.state {
        State::Header => {}
        State::Format => return Err(cut(reader.begin, "END_DATA_FORMAT")),
        State::Data => return Err(cut(reader.begin, "END_DATA")),
    }
    if reader.contents.grids.is_empty() {
        let what = match &reader.fields {
            None => {
                "the file has no BEGIN_DATA_FORMAT, which names its fields; save or export it again".into()
            }
            Some(_) => format!(
                "the fields are {}, and none is a wavelength such as SPEC_380; export the file with spectral values",
                listed(&reader.first)
            ),
        };
        return Err(Refusal { line: reader.format_line, ..Refusal::of(what) });
    }
    Ok(reader.contents)
}

fn cut(line: usize, end: &str) -> Refusal {
    Refusal::at(line, format!("what begins here has no {end}, so the file was cut; save or export it again"))
}

/// Returns a list of names that is short enough to be read.
fn listed(names: &[String]) -> String {
    match names.len() {
        0 => "none".into(),
        1..=6 => names.join(", "),
        count => format!("{} and {} more", names[..5].join(", "), count - 5),
    }
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum State {
    #[default]
    Header,
    Format,
    Data,
}

/// Something that the head of a table states.
struct Key {
    line: usize,
    name: String,
    value: String,
}

/// What has been read.
#[derive(Default)]
struct Reader {
    /// The first word of the file.
    kind: String,
    state: State,
    /// The line where the state began.
    begin: usize,
    /// The line and the fields of the first format.
    format_line: Option<usize>,
    first: Vec<String>,
    names: Vec<String>,
    fields: Option<Fields>,
    keys: Vec<Key>,
    /// The cells of a row that goes on in the next line, and the line where it began.
    row: Vec<String>,
    row_line: usize,
    spectra: Vec<Spectrum>,
    rows: usize,
    contents: Contents,
}

impl Reader {
    fn line(&mut self, line: Line) -> Result<(), Refusal> {
        if self.state == State::Data {
            return self.data(line);
        }
        let mut words = words(line.text);
        if self.state == State::Header {
            match words.first().map(String::as_str) {
                None => return Ok(()),
                Some("BEGIN_DATA_FORMAT") => {
                    words.remove(0);
                    (self.state, self.begin) = (State::Format, line.number);
                    self.names.clear();
                }
                Some("BEGIN_DATA") => {
                    let Some(fields) = self.fields.take() else {
                        let what = "the fields of the data are not named; BEGIN_DATA_FORMAT is missing";
                        return Err(Refusal::at(line.number, what));
                    };
                    let fields = fields.with_steps(&self.keys, &mut self.contents.notes);
                    (self.state, self.begin, self.fields) = (State::Data, line.number, Some(fields));
                    return Ok(());
                }
                Some("KEYWORD") => return Ok(()),
                Some(_) => {
                    let value = words[1..].join(" ");
                    self.contents.fact(line.number, &words[0], &value);
                    self.keys.push(Key { line: line.number, name: words.remove(0), value });
                    return Ok(());
                }
            }
        }
        for word in words {
            if word == "END_DATA_FORMAT" {
                if self.format_line.is_none() {
                    (self.format_line, self.first) = (Some(self.begin), self.names.clone());
                }
                self.state = State::Header;
                self.check_count(line.number)?;
                self.fields = Some(Fields::of(&self.names));
            } else {
                self.names.push(word);
            }
        }
        Ok(())
    }

    /// Refuses a format that has another number of fields than the file says.
    fn check_count(&self, line: usize) -> Result<(), Refusal> {
        let said = self.keys.iter().rev().find(|key| key.name == "NUMBER_OF_FIELDS");
        match said.and_then(|key| key.value.parse::<usize>().ok()) {
            Some(count) if count != self.names.len() => {
                let what = format!(
                    "NUMBER_OF_FIELDS says {count}, and {} fields are named; correct the one that is wrong",
                    self.names.len()
                );
                Err(Refusal::at(line, what))
            }
            _ => Ok(()),
        }
    }

    /// Reads a line of data: a row, a part of one, or several.
    fn data(&mut self, line: Line) -> Result<(), Refusal> {
        let text = line.text.trim();
        if text == "END_DATA" {
            return self.end(line.number);
        }
        if text.is_empty() || text.starts_with('#') {
            return Ok(());
        }
        // Names with blanks have no quotes in files whose cells are separated by tabs.
        let cells: Vec<&str> =
            line.text.trim_end().split('\t').map(|cell| cell.trim().trim_matches('"')).collect();
        if self.row.is_empty() && cells.len() == self.names.len() && cells.len() > 1 {
            return self.row(cells.into_iter().map(str::to_owned).collect(), line.number..=line.number);
        }
        for word in words(line.text) {
            if word == "END_DATA" {
                return self.end(line.number);
            }
            if self.row.is_empty() {
                self.row_line = line.number;
            }
            self.row.push(word);
            if self.row.len() == self.names.len() {
                let row = std::mem::take(&mut self.row);
                self.row(row, self.row_line..=line.number)?;
            }
        }
        Ok(())
    }

    fn row(&mut self, cells: Vec<String>, lines: std::ops::RangeInclusive<usize>) -> Result<(), Refusal> {
        self.rows += 1;
        let Some(fields) = self.fields.as_ref().filter(|fields| fields.has_spectra()) else { return Ok(()) };
        let number = |field: usize| {
            let text = cells[field].as_str();
            match cell(text, Decimal::Point) {
                Cell::Number(number) => Ok(number),
                Cell::Missing => Ok(f64::NAN),
                Cell::Text(_) => match cell(text, Decimal::Comma) {
                    Cell::Number(number) => Ok(number),
                    _ => Err(Refusal::at(
                        *lines.start(),
                        format!(
                            "'{text}' in the field {} of this row is not a number; names with blanks need quotes",
                            self.names[field]
                        ),
                    )),
                },
            }
        };
        let places = match &fields.pairs {
            Some(pairs) => pairs.iter().map(|pair| number(pair.0)).collect::<Result<_, _>>()?,
            None => fields.wavelengths.iter().map(|field| field.1).collect(),
        };
        let values: Vec<f64> = match &fields.pairs {
            Some(pairs) => pairs.iter().map(|pair| number(pair.1)).collect::<Result<_, _>>()?,
            None => fields.wavelengths.iter().map(|field| number(field.0)).collect::<Result<_, _>>()?,
        };
        let name = fields.names.iter().map(|field| cells[*field].trim()).find(|name| !name.is_empty());
        self.spectra.push(Spectrum {
            name: name.map(str::to_owned),
            axis: NANOMETERS.to_owned(),
            places,
            values,
            unit: None,
            lines,
        });
        Ok(())
    }

    /// Ends a table.
    fn end(&mut self, line: usize) -> Result<(), Refusal> {
        if !self.row.is_empty() {
            let what = format!(
                "the row that begins here has {} values where the format has {} fields; correct it",
                self.row.len(),
                self.names.len()
            );
            return Err(Refusal::at(self.row_line, what));
        }
        let said = self.keys.iter().rev().find(|key| key.name == "NUMBER_OF_SETS");
        if let Some(key) = said
            && let Ok(count) = key.value.parse::<usize>()
            && count > self.rows
        {
            let what =
                format!("NUMBER_OF_SETS says {count}, and there are {} rows before END_DATA", self.rows);
            return Err(Refusal::at(key.line, what + "; complete the file or correct the number"));
        }
        self.state = State::Header;
        self.rows = 0;
        let mut spectra = std::mem::take(&mut self.spectra);
        let keys = std::mem::take(&mut self.keys);
        let Some(fields) = &self.fields else { return Ok(()) };
        if spectra.is_empty() {
            if fields.has_spectra() {
                let what = "the table that ends in this line has no rows; export the file again";
                return Err(Refusal::at(line, what));
            }
            return Ok(());
        }
        if spectra.len() == 1
            && spectra[0].name.is_none()
            && let Some(key) = keys.iter().find(|key| key.name == "DESCRIPTOR")
        {
            spectra[0].name = Some(key.value.clone()).filter(|name| !name.is_empty());
        }
        if !fields.others.is_empty() {
            let what = format!("the fields {}, which are no wavelengths", listed(&fields.others));
            self.contents.notes.push(Note::left_out(what));
        }
        let scale = units::find(&self.kind, &keys, fields.scale, &spectra, &mut self.contents.notes)?;
        for mut spectrum in spectra {
            if scale.norm != 1.0 {
                spectrum.values.iter_mut().for_each(|value| *value /= scale.norm);
            }
            let line = *spectrum.lines.start();
            spectrum.unit = scale.unit.clone().map(|text| Said { text, line });
            self.contents.add(spectrum);
        }
        Ok(())
    }
}

/// Returns the words of a line, where quotes hold words together and `#` begins a remark.
fn words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut rest = line.trim();
    while let Some(first) = rest.chars().next() {
        if first == '#' {
            break;
        }
        let quoted = first == '"';
        let (start, end) = if quoted {
            (1, rest[1..].find('"').map_or(rest.len(), |end| end + 1))
        } else {
            (0, rest.find(char::is_whitespace).unwrap_or(rest.len()))
        };
        words.push(rest[start..end].trim().to_owned());
        rest = rest.get(end + usize::from(quoted)..).unwrap_or("").trim_start();
    }
    words
}

#[cfg(test)]
mod tests;
