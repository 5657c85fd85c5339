//! The report as JSON, and the report on record.

use crate::report::{Cell, Kind, Table};
use nanospectra_cli::failure::Failure;
use serde_json::{Map, Value, json};

/// The text of the record, as `--bless` last wrote it.
const RECORD: &str = include_str!("../data/cost.json");
/// Where the record is in the repository.
pub const PLACE: &str = "examples/cost/data/cost.json";

/// Makes the report: for each table its columns and its rows. A row is an object with a value for each
/// column, `null` where nothing was measured.
pub fn report(tables: &[Table]) -> Value {
    let tables: Map<String, Value> =
        tables.iter().map(|table| (table.id.to_owned(), of_table(table))).collect();
    json!({ "tables": tables })
}

fn of_table(table: &Table) -> Value {
    let rows: Vec<Value> = table
        .rows
        .iter()
        .map(|row| {
            let cells =
                table.columns.iter().zip(row).map(|(column, cell)| (column.id.to_string(), of_cell(cell)));
            Value::Object(cells.collect())
        })
        .collect();
    let of_kind = |kind| -> Vec<&str> {
        table.columns.iter().filter(|column| column.kind == kind).map(|column| &*column.id).collect()
    };
    json!({
        "title": table.title,
        "about": table.about,
        "keys": of_kind(Kind::Key),
        "figures": of_kind(Kind::Figure),
        "times": of_kind(Kind::Time),
        "rows": rows,
    })
}

fn of_cell(cell: &Cell) -> Value {
    match cell {
        Cell::Key(name) => json!(name),
        Cell::Figure(value) => json!(value),
        Cell::Time(nanoseconds) => json!((nanoseconds * 10.0).round() / 10.0),
        Cell::Nothing => Value::Null,
    }
}

/// Replaces the tables of the record that the report has too.
pub fn updated(mut record: Value, report: &Value) -> Value {
    for (id, table) in report["tables"].as_object().into_iter().flatten() {
        record["tables"][id] = table.clone();
    }
    record
}

/// The text of the file, with one row on each line.
pub fn text(report: &Value) -> String {
    let pretty = serde_json::to_string_pretty(report).unwrap_or_default();
    // With a row on one line, a changed figure changes one line of a diff.
    let mut out = String::with_capacity(pretty.len());
    let mut in_row = false;
    for line in pretty.lines() {
        let trimmed = line.trim_start();
        let depth = line.len() - trimmed.len();
        if depth == 10 && trimmed == "{" {
            in_row = true;
            out.push_str(line);
        } else if in_row {
            if depth == 10 {
                in_row = false;
                out.push_str(&format!(" {trimmed}\n"));
            } else {
                out.push_str(&format!(" {trimmed}"));
            }
        } else {
            out.push_str(line);
            out.push('\n');
        }
    }
    out
}

/// Reads the report on record.
pub fn recorded() -> Result<Value, Failure> {
    serde_json::from_str(RECORD).map_err(|error| {
        Failure::of(PLACE, format_args!("{error}; write {{ \"tables\": {{}} }} into it and run with --bless"))
    })
}
