//! What the table says of a row before it is computed: `claims.csv`, and `rules.csv` for behavior rather than
//! rounding.

use serde::Deserialize;
use serde::de::DeserializeOwned;

/// A row, or a part of one.
#[derive(Clone, Deserialize)]
pub struct Claim {
    /// Number of the row, and the letter of its part.
    pub row: String,
    pub what: String,
    pub inputs: String,
    /// How errors are measured.
    pub measured: String,
    /// What the crate's form may be off by: so many of the judge's units, and what they are called.
    pub limit: f64,
    unit: String,
    pub naive: Naive,
    /// The test that guards it, `file::name`.
    pub test: String,
}

/// What becomes of the textbook's form.
#[derive(Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Naive {
    Fails,
    Holds,
}

/// A rule of behavior, and the test that pins it.
#[derive(Deserialize)]
pub struct Rule {
    pub rule: String,
    pub test: String,
}

pub fn claims() -> Vec<Claim> {
    rows(include_str!("../../claims.csv"))
}

pub fn rules() -> Vec<Rule> {
    rows(include_str!("../../rules.csv"))
}

fn rows<T: DeserializeOwned>(text: &str) -> Vec<T> {
    csv::Reader::from_reader(text.as_bytes())
        .deserialize()
        .map(|row| row.expect("a row of this package"))
        .collect()
}

impl Claim {
    /// The number, and the letter of a part.
    pub fn place(&self) -> (u8, &str) {
        let digits = self.row.trim_end_matches(|c: char| c.is_ascii_alphabetic());
        (digits.parse().unwrap_or(0), &self.row[digits.len()..])
    }

    /// The limit in words.
    pub fn tolerance(&self) -> String {
        match (self.limit, self.unit.as_str()) {
            (limit, "") if limit > 0.0 && limit < 0.01 => format!("{limit:e}"),
            (limit, "") => format!("{limit}"),
            (1.0, unit) => unit.to_string(),
            (limit, unit) => format!("{limit} {unit}"),
        }
    }
}
