//! What is written about each row by hand: `claims.csv` for the rows that are computed, and `rules.csv` for
//! rules of behavior.

use serde::Deserialize;
use serde::de::DeserializeOwned;

/// What one row of the table claims, or one part of a row.
#[derive(Clone, Deserialize)]
pub struct Claim {
    /// Number of the row, and the letter of its part.
    pub row: String,
    pub what: String,
    pub inputs: String,
    /// How errors are measured.
    pub measured: String,
    /// The error that the crate's form may have, as a multiple of the unit that the judge uses.
    pub limit: f64,
    /// The name of that unit in the table.
    unit: String,
    pub naive: Naive,
    /// The test that holds the crate's form to the limit, as `file::name`.
    pub test: String,
}

/// Whether the textbook's form stays within the limit.
#[derive(Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Naive {
    Fails,
    Holds,
}

/// A rule of behavior, and the test that holds it.
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
    /// Splits the name of the row into its number and the letter of its part.
    pub fn place(&self) -> (u8, &str) {
        let digits = self.row.trim_end_matches(|c: char| c.is_ascii_alphabetic());
        (digits.parse().unwrap_or(0), &self.row[digits.len()..])
    }

    /// Writes the limit with its unit.
    pub fn tolerance(&self) -> String {
        match (self.limit, self.unit.as_str()) {
            (limit, "") if limit > 0.0 && limit < 0.01 => format!("{limit:e}"),
            (limit, "") => format!("{limit}"),
            (1.0, unit) => unit.to_string(),
            (limit, unit) => format!("{limit} {unit}"),
        }
    }
}
