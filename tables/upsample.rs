//! The constants of the module `upsample`: small tables that `tests/upsample/tables.rs` makes from the CIE's
//! tables, and the curves of Smits. Their rows are numbers without wavelengths.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// The file, the name of the constant, the number of rows and of columns, whether a wavelength comes before
/// the columns, and the documentation.
const MATRICES: &[(&str, &str, usize, usize, bool, &str)] = &[
    ("responses", "RESPONSES", 3, 3, false, "Narrow responses as mixtures of x-bar, y-bar, z-bar."),
    ("start_linear", "START_LINEAR", 3, 3, false, "x^2, x, 1 of the curve for each monomial of degree 1."),
    ("start_cubic", "START_CUBIC", 13, 3, false, "x^2, x, 1 of the curve for each odd monomial up to 3."),
    ("start_quintic", "START_QUINTIC", 34, 3, false, "x^2, x, 1 of the curve for each odd monomial up to 5."),
    ("basis", "BASIS", 81, 2, true, "Red and green at 380, 385, .. 780 nm; blue is what they leave of 1."),
    ("smits1999_10bin", "SMITS", 10, 7, true, "White, cyan, magenta, yellow, red, green, blue in 10 bins."),
];

/// The Rust source of every table.
pub fn source(folder: &Path) -> Result<String, String> {
    let mut text = String::new();
    for (file, name, rows, columns, wavelengths, docs) in MATRICES {
        let path = folder.join(file).with_extension("csv");
        let table = read(&path, *columns, *wavelengths)?;
        if table.len() != *rows {
            return Err(format!(
                "{}: the file has {} rows where it must have {rows}; restore it from the repository",
                path.display(),
                table.len()
            ));
        }
        let _ = writeln!(text, "/// {docs}\npub(super) const {name}: [[f32; {columns}]; {rows}] = [");
        for row in table {
            let _ = writeln!(text, "    {row:?},");
        }
        let _ = writeln!(text, "];");
    }
    Ok(text)
}

fn read(path: &Path, columns: usize, wavelengths: bool) -> Result<Vec<Vec<f32>>, String> {
    let text = fs::read_to_string(path).map_err(|e| {
        format!("{}: the file cannot be read ({e}); restore it from the repository", path.display())
    })?;
    let mut rows = Vec::new();
    let lines = text.lines().enumerate().filter(|(_, line)| !line.starts_with('#'));
    // The first line is the heading.
    for (index, line) in lines.skip(1) {
        let place = format!("{}:{}", path.display(), index + 1);
        let at = |what: &str| format!("{place}: {what}; restore the file from the repository");
        let cells: Result<Vec<f32>, _> =
            line.split(',').skip(usize::from(wavelengths)).map(|cell| cell.trim().parse::<f32>()).collect();
        let cells = cells.map_err(|_| at("a cell is not a number"))?;
        if cells.len() != columns || !cells.iter().all(|cell| cell.is_finite()) {
            return Err(at("the row does not have the finite numbers that the heading names"));
        }
        rows.push(cells);
    }
    Ok(rows)
}
