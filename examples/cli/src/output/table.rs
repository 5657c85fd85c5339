//! Writes the cells of CSV.

/// Returns a name as a cell, in quotes where it needs them.
///
/// Spreadsheets take a text that begins with `=`, `+`, `-`, `@`, a tab or a carriage return for a formula,
/// even in quotes. Such a name gets an apostrophe in front, by which they know a text. Numbers are no names.
pub fn cell(name: &str) -> String {
    let guard = if name.starts_with(['=', '+', '-', '@', '\t', '\r']) { "'" } else { "" };
    let name = format!("{guard}{name}");
    if name.contains([',', ';', '"', '\t', '\r', '\n']) || name.trim() != name {
        format!("\"{}\"", name.replace('"', "\"\""))
    } else {
        name
    }
}
