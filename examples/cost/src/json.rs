//! The report as JSON, and what is on record.

use crate::report::{Cell, Kind, Table};
use nanospectra_cli::failure::Failure;
use serde_json::{Map, Value, json};

/// What `--json` wrote when figures were last recorded.
const RECORD: &str = include_str!("../data/cost.json");
/// Where that is in the repository.
pub const PLACE: &str = "examples/cost/data/cost.json";

/// Of each table its columns and its rows; each row an object by column, `null` for what was not measured.
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

/// The record with the tables of the report in place of those that it had.
pub fn updated(mut record: Value, report: &Value) -> Value {
    for (id, table) in report["tables"].as_object().into_iter().flatten() {
        record["tables"][id] = table.clone();
    }
    record
}

/// The report as a file, a row a line.
pub fn text(report: &Value) -> String {
    let pretty = serde_json::to_string_pretty(report).unwrap_or_default();
    // Rows on one line each: a changed figure is one line of a diff.
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

/// The report on record.
pub fn recorded() -> Result<Value, Failure> {
    serde_json::from_str(RECORD).map_err(|error| {
        Failure::of(PLACE, format_args!("{error}; write {{ \"tables\": {{}} }} into it and run with --bless"))
    })
}
