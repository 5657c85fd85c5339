//! Finds the wavelengths among the fields of a table.

use super::Key;
use crate::refusal::Note;

/// What the fields of a table are.
pub struct Fields {
    /// The fields that hold the value at a wavelength in nm.
    pub wavelengths: Vec<(usize, f64)>,
    /// The fields of wavelengths and values, if each row states its own wavelengths.
    pub pairs: Option<Vec<(usize, usize)>>,
    /// The fields that name a row, the best one first.
    pub names: Vec<usize>,
    /// What the names of the fields say of the values: 100 for percent, 1 for parts of 1.
    pub scale: Option<f64>,
    /// The names of all other fields.
    pub others: Vec<String>,
    /// Whether the names state whole nm only.
    whole: bool,
}

/// What stands before the wavelength in the name of a field, without underscores.
const PREFIXES: [&str; 12] = [
    "",
    "SPEC",
    "SPECTRAL",
    "SPECTRAL_NM",
    "SPECTRAL_PCT",
    "SPECTRAL_DEC",
    "SPECTRUM",
    "NM",
    "R",
    "WL",
    "REFL",
    "LAMBDA",
];

impl Fields {
    /// Returns what fields of these names are.
    pub fn of(names: &[String]) -> Self {
        let mut fields = Fields {
            wavelengths: Vec::new(),
            pairs: pairs(names),
            names: Vec::new(),
            scale: None,
            others: Vec::new(),
            whole: true,
        };
        for wanted in ["SAMPLE_NAME", "SAMPLENAME", "SAMPLE_ID", "SAMPLEID", "SAMPLE_LOC"] {
            fields.names.extend(names.iter().position(|name| name.eq_ignore_ascii_case(wanted)));
        }
        for (place, name) in names.iter().enumerate() {
            let upper = name.to_ascii_uppercase();
            if upper.starts_with("SPECTRAL_PCT") {
                fields.scale = Some(100.0);
            } else if upper.starts_with("SPECTRAL_DEC") {
                fields.scale = Some(1.0);
            }
            if let Some(nm) = wavelength(&upper) {
                fields.whole &= !name.contains('.');
                fields.wavelengths.push((place, nm));
            } else if !upper.starts_with("SAMPLE") && !upper.starts_with("SPECTRAL_") && upper != "NM" {
                fields.others.push(name.clone());
            }
        }
        fields
    }

    pub fn has_spectra(&self) -> bool {
        self.wavelengths.len() > 1 || self.pairs.is_some()
    }

    /// Compares the wavelengths of the names with the steps that the head of the table states. Names are rounded to
    /// whole nm, so steps that agree with them are more exact; names that do not agree are right.
    pub fn with_steps(mut self, keys: &[Key], notes: &mut Vec<Note>) -> Self {
        let number = |name: &str| {
            let key = keys.iter().rev().find(|key| key.name == name)?;
            key.value.parse::<f64>().ok().filter(|number| number.is_finite())
        };
        let (Some(start), Some(end)) = (number("SPECTRAL_START_NM"), number("SPECTRAL_END_NM")) else {
            return self;
        };
        let (Some(first), Some(last)) = (self.wavelengths.first(), self.wavelengths.last()) else {
            return self;
        };
        let bands = number("SPECTRAL_BANDS").unwrap_or(self.wavelengths.len() as f64);
        let step = (end - start) / (self.wavelengths.len().max(2) - 1) as f64;
        let place = |index: usize| start + index as f64 * step;
        let agree = bands == self.wavelengths.len() as f64
            && self
                .wavelengths
                .iter()
                .enumerate()
                .all(|(index, field)| (place(index) - field.1).abs() <= 0.51);
        if !agree {
            notes.push(Note::assumed(
                format!(
                    "the wavelengths are those of the {} fields, from {} to {} nm, where SPECTRAL_START_NM, \
                     SPECTRAL_END_NM and SPECTRAL_BANDS say {bands} from {start} to {end} nm",
                    self.wavelengths.len(),
                    first.1,
                    last.1
                ),
                None,
            ));
        } else if self.whole {
            for (index, field) in self.wavelengths.iter_mut().enumerate() {
                field.1 = place(index);
            }
        }
        self
    }
}

/// Returns the fields of wavelengths with the field of the value behind each.
fn pairs(names: &[String]) -> Option<Vec<(usize, usize)>> {
    let is = |name: &String, wanted: &[&str]| wanted.iter().any(|other| name.eq_ignore_ascii_case(other));
    let pairs: Vec<(usize, usize)> = (1..names.len())
        .filter(|place| {
            is(&names[*place - 1], &["SPECTRAL_NM", "NM"])
                && is(&names[*place], &["SPECTRAL_PCT", "SPECTRAL_DEC"])
        })
        .map(|place| (place - 1, place))
        .collect();
    (pairs.len() > 1).then_some(pairs)
}

/// Returns the wavelength in a name such as `SPEC_380`, `SPECTRAL_NM380`, `nm380`, `R_380` or `380nm`.
fn wavelength(name: &str) -> Option<f64> {
    let name = name.trim_end_matches([']', ')']);
    let name = name.strip_suffix("NM").unwrap_or(name).trim_end_matches('_');
    let start = name.trim_end_matches(|c: char| c.is_ascii_digit() || c == '.').len();
    let prefix = name[..start].trim_end_matches(['_', '[', '(', '-']);
    let nm: f64 = name[start..].parse().ok()?;
    (PREFIXES.contains(&prefix) && (150.0..=3500.0).contains(&nm)).then_some(nm)
}
