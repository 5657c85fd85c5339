//! The schemes, ranges and numbers of bands that a report compares. The advice, the chart and the tables of
//! the README are made from them.

use crate::counts::Core;
use serde_json::Value;

/// The classes of lamps, as the columns of the report name them.
pub const CLASSES: [&str; 6] = ["smooth", "halophosphate", "triphosphor", "led", "hid", "lines"];

/// A scheme on a range with a number of bands: its CIEDE2000 for each class of lamps, and what it costs.
pub struct Choice {
    /// The range in nm, or `-` for a scheme of RGB colors.
    pub range: String,
    pub scheme: String,
    pub bands: u32,
    pub mean: [f64; CLASSES.len()],
    pub p95: [f64; CLASSES.len()],
    pub max: [f64; CLASSES.len()],
    m4f: Option<f64>,
    m0: Option<f64>,
    /// The bytes of its constants, and of each surface.
    pub constants: f64,
    pub surface: f64,
}

impl Choice {
    /// Returns the instructions on a core, if they were counted.
    pub fn instructions(&self, core: Core) -> Option<f64> {
        match core {
            Core::M4F => self.m4f,
            Core::M0 => self.m0,
        }
    }

    /// Returns the mean over all classes but that of spectral lines, which are no lamps for rooms.
    pub fn of_lamps(&self) -> f64 {
        let lamps = &self.mean[..CLASSES.len() - 1];
        lamps.iter().sum::<f64>() / lamps.len() as f64
    }

    /// Whether this is the choice of the given scheme, range and number of bands.
    pub fn is(&self, range: &str, scheme: &str, bands: u32) -> bool {
        self.range == range && self.scheme == scheme && self.bands == bands
    }

    /// Returns the choice in words.
    pub fn name(&self) -> String {
        match self.range.as_str() {
            "-" => self.scheme.clone(),
            range => format!("{}, N = {}, {range} nm", self.scheme, self.bands),
        }
    }
}

/// Returns every choice of a report; none if the report does not have the table.
pub fn choices(report: &Value) -> Vec<Choice> {
    let spreads = rows(report, "xyz-spread");
    rows(report, "xyz")
        .iter()
        .filter_map(|row| {
            let spread = spreads.iter().find(|spread| {
                ["range", "scheme", "bands"].iter().all(|key| text(spread, key) == text(row, key))
            })?;
            let each = |row: &Value, ending: &str| {
                CLASSES.map(|class| number(row, &format!("{class}{ending}")).unwrap_or(f64::INFINITY))
            };
            Some(Choice {
                range: text(row, "range").to_owned(),
                scheme: text(row, "scheme").to_owned(),
                bands: text(row, "bands").parse().ok()?,
                mean: each(row, ""),
                p95: each(spread, "_p95"),
                max: each(spread, "_max"),
                m4f: number(row, "m4f_instructions"),
                m0: number(row, "m0_instructions"),
                constants: number(row, "constant_bytes")?,
                surface: number(row, "surface_bytes")?,
            })
        })
        .collect()
}

/// Returns the rows of a table; none if the report does not have it.
pub fn rows<'a>(report: &'a Value, table: &str) -> &'a [Value] {
    report["tables"][table]["rows"].as_array().map_or(&[], |rows| rows)
}

/// Returns a cell of a row as text; empty if it is none.
pub fn text<'a>(row: &'a Value, column: &str) -> &'a str {
    row[column].as_str().unwrap_or("")
}

/// Returns a cell of a row as a number, or `None` if it was not measured.
pub fn number(row: &Value, column: &str) -> Option<f64> {
    row[column].as_f64()
}
