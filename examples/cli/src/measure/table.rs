//! Writes all readings as one table in CSV.

use crate::failure::Failure;
use crate::measure::json;
use crate::measure::reading::{Bench, Reading};
use crate::output::table::cell;
use serde_json::Value;

/// Returns the table, with a row for each reading, and a column for each number that one of them has.
///
/// A column is named after the path of its number in the report in JSON. A number that a reading has not is an
/// empty cell.
pub fn csv(bench: &Bench, readings: &[Reading]) -> Result<String, Failure> {
    let rows: Vec<Vec<(String, String)>> = readings
        .iter()
        .map(|reading| {
            let mut cells = Vec::new();
            flatten("", &json::object(bench, reading), &mut cells);
            cells
        })
        .collect();
    let mut heading: Vec<&str> = Vec::new();
    let mut known = std::collections::HashSet::new();
    for (key, _) in rows.iter().flatten() {
        if known.insert(key.as_str()) {
            heading.push(key);
        }
    }
    let mut table = heading.iter().map(|key| cell(key)).collect::<Vec<_>>().join(",") + "\n";
    for row in &rows {
        let row: std::collections::HashMap<&str, &str> =
            row.iter().map(|(key, value)| (key.as_str(), value.as_str())).collect();
        let cells: Vec<&str> = heading.iter().map(|key| row.get(key).copied().unwrap_or("")).collect();
        table += &(cells.join(",") + "\n");
    }
    Ok(table)
}

/// Adds the cells of a value, each with the path of its key.
fn flatten(path: &str, value: &Value, cells: &mut Vec<(String, String)>) {
    let below = |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
    match value {
        Value::Object(object) => object.iter().for_each(|(key, value)| flatten(&below(key), value, cells)),
        // The notes are sentences, of which there are many or few.
        Value::Array(notes) if path == "notes" => {
            let notes: Vec<&str> = notes.iter().filter_map(Value::as_str).collect();
            cells.push((path.to_owned(), cell(&notes.join("; "))));
        }
        Value::Array(values) => {
            values
                .iter()
                .enumerate()
                .for_each(|(k, value)| flatten(&below(&(k + 1).to_string()), value, cells));
        }
        Value::Null => cells.push((path.to_owned(), String::new())),
        Value::String(text) => cells.push((path.to_owned(), cell(text))),
        other => cells.push((path.to_owned(), other.to_string())),
    }
}
