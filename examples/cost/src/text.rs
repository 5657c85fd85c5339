//! Prints tables for a terminal.

use crate::report::{Cell, Kind, Table};

/// Returns a table as text with aligned columns.
pub fn table(table: &Table) -> String {
    let mut lines: Vec<Vec<String>> =
        vec![table.columns.iter().map(|column| column.heading.to_string()).collect()];
    lines.extend(table.rows.iter().map(|row| row.iter().map(cell).collect()));
    let widths: Vec<usize> = (0..table.columns.len())
        .map(|k| {
            lines.iter().filter_map(|line| line.get(k)).map(|text| text.chars().count()).max().unwrap_or(0)
        })
        .collect();
    let mut out = format!("\n{}\n{}\n\n", table.title, table.about);
    for line in &lines {
        let cells =
            line.iter().zip(&widths).zip(&table.columns).map(|((text, width), column)| match column.kind {
                Kind::Key => format!("{text:<width$}"),
                _ => format!("{text:>width$}"),
            });
        out += format!("  {}", cells.collect::<Vec<_>>().join("  ")).trim_end();
        out.push('\n');
    }
    out
}

fn cell(cell: &Cell) -> String {
    match cell {
        Cell::Key(name) => name.clone(),
        Cell::Figure(value) => figure(*value),
        Cell::Time(nanoseconds) => figure(*nanoseconds),
        Cell::Nothing => "-".to_owned(),
    }
}

/// Returns a number with three significant digits, and whole numbers with all their digits.
pub fn figure(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        size if !(1e-3..1e7).contains(&size) => format!("{value:.1e}"),
        size if size < 1.0 => format!("{value:.3}"),
        _ if value.fract() == 0.0 => format!("{value:.0}"),
        size if size < 10.0 => format!("{value:.2}"),
        size if size < 100.0 => format!("{value:.1}"),
        _ => format!("{value:.0}"),
    }
}
