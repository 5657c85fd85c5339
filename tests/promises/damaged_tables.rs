//! A damaged table stops the build with one line: file, line, what is wrong, what to do.

use crate::programs::Package;
use std::path::Path;

/// The crate's build script and tables, and nothing to compile: the same script at a fraction of the cost.
const MANIFEST: &str = "[package]\nname = \"damaged\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\
                        build = \"tables/build.rs\"\n\n[workspace]\n";

const CMF: &str = "tables/cmf/cie_1931_2deg_xyz_1nm.csv";
const FL: &str = "tables/illuminants/FL_5nm.csv";
const CES: &str = "tables/samples/cie224_ces99_1nm.csv";

fn shipped(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// A copy of the tables folder that can be damaged.
fn copy() -> Package {
    let package = Package::new("damaged", MANIFEST);
    package.write("src/lib.rs", "");
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for folder in ["tables", "tables/cmf", "tables/illuminants", "tables/samples", "tables/upsample"] {
        for entry in std::fs::read_dir(root.join(folder)).expect("a folder of tables") {
            let path = entry.expect("an entry").path();
            if path.is_file() {
                let path = path.strip_prefix(root).expect("below the root").to_str().expect("a plain name");
                package.write(path, &shipped(path));
            }
        }
    }
    package
}

/// The lines of a table: first and last of the data, counted from 1 as editors do.
struct Lines(Vec<String>);

impl Lines {
    fn of(path: &str) -> Lines {
        Lines(shipped(path).lines().map(str::to_string).collect())
    }

    /// The line number of the row of this wavelength.
    fn row(&self, nm: u32) -> usize {
        let start = format!("{nm},");
        1 + self.0.iter().position(|line| line.starts_with(&start)).expect("a row of this wavelength")
    }

    fn at(&mut self, line: usize) -> &mut String {
        &mut self.0[line - 1]
    }

    /// Another text in cell `index` of a line.
    fn set(&mut self, line: usize, index: usize, text: &str) {
        let mut cells: Vec<&str> = self.0[line - 1].split(',').collect();
        cells[index] = text;
        self.0[line - 1] = cells.join(",");
    }

    fn text(&self) -> String {
        self.0.join("\n") + "\n"
    }
}

/// Builds with one damaged file and returns cargo's one line about it; the file is whole again afterwards.
fn complaint(package: &Package, path: &str, damaged: &Lines) -> String {
    assert_ne!(damaged.text(), shipped(path), "nothing was damaged");
    package.write(path, &damaged.text());
    let output = package.cargo(&["check"]);
    package.write(path, &shipped(path));
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!output.status.success(), "{path}: a damaged table was built");
    assert!(!text.contains("panicked"), "{path}: a panic is no message:\n{text}");
    let mut about = text.lines().filter(|line| line.starts_with("error:") && line.contains(".csv"));
    let line = about.next().unwrap_or_else(|| panic!("no line about {path}:\n{text}")).to_string();
    assert_eq!(about.next(), None, "more than one line:\n{text}");
    line
}

#[test]
fn a_damaged_table_stops_the_build_with_file_line_and_advice() {
    let package = copy();
    let whole = package.cargo(&["check"]);
    assert!(whole.status.success(), "{}", String::from_utf8_lossy(&whole.stderr));

    let mut missing = Vec::new();
    let mut says = |path: &str, damaged: &Lines, line: Option<usize>, words: &[&str]| {
        let found = complaint(&package, path, damaged);
        let place = line.map_or(format!("{path}:"), |line| format!("{path}:{line}: "));
        for part in [place.as_str()].iter().chain(words).filter(|part| !found.contains(**part)) {
            missing.push(format!("'{part}' is not in: {found}"));
        }
    };
    let damaged = |path: &str, nm: u32, damage: &dyn Fn(&mut Lines, usize)| {
        let mut lines = Lines::of(path);
        let line = lines.row(nm);
        damage(&mut lines, line);
        (lines, line)
    };

    let (lines, line) = damaged(CMF, 555, &|t, line| t.set(line, 2, "1.0.0"));
    says(CMF, &lines, Some(line), &["'1.0.0' is not a number", "correct it"]);

    let (lines, line) = damaged(FL, 400, &|t, line| t.set(line, 3, ""));
    says(FL, &lines, Some(line), &["empty cell", "fill it"]);

    let (lines, line) = damaged(CES, 500, &|t, line| t.set(line, 99, "NaN"));
    says(CES, &lines, Some(line), &["NaN", "finite", "correct it"]);

    let (lines, line) = damaged(FL, 780, &|t, line| t.at(line).push_str(",1"));
    says(FL, &lines, Some(line), &["29 cells", "28", "complete the row"]);

    let (lines, line) = damaged(CMF, 400, &|t, line| t.set(line, 0, "400.5"));
    says(CMF, &lines, Some(line), &["'400.5'", "whole number", "correct it"]);

    // A row that is missing is noticed where the next one stands.
    let (lines, line) = damaged(CMF, 600, &|t, line| drop(t.0.remove(line - 1)));
    says(CMF, &lines, Some(line), &["601 nm follows 599 nm", "1 nm", "complete"]);

    let (lines, line) = damaged(FL, 500, &|t, line| t.0.swap(line - 1, line));
    says(FL, &lines, Some(line), &["505 nm follows 495 nm", "5 nm", "sort"]);

    let (lines, line) = damaged(CES, 700, &|t, line| t.0.insert(line, t.0[line - 1].clone()));
    says(CES, &lines, Some(line + 1), &["700 nm follows 700 nm", "1 nm"]);

    let (lines, line) = damaged(CMF, 555, &|t, line| t.set(line, 2, "10"));
    says(CMF, &lines, Some(line), &["10", "decimal point"]);

    let (lines, line) = damaged(CES, 555, &|t, line| t.set(line, 1, "-0.1"));
    says(CES, &lines, Some(line), &["-0.1", "decimal point"]);

    // What is missing at an end has no line of its own: the header says where the table should end.
    let (lines, _) = damaged(CMF, 830, &|t, line| drop(t.0.remove(line - 1)));
    says(CMF, &lines, None, &["360-829", "range_nm"]);

    let mut lines = Lines::of(FL);
    lines.0.retain(|line| !line.starts_with("# license:"));
    says(FL, &lines, None, &["'# license:'", "add it"]);

    let mut lines = Lines::of(FL);
    lines.0.retain(|line| line.starts_with('#'));
    says(FL, &lines, None, &["no data rows", "restore"]);

    assert!(missing.is_empty(), "{}", missing.join("\n"));

    // A table that no list names would be nowhere.
    package.write("tables/illuminants/NEW_5nm.csv", &shipped(FL));
    let output = package.cargo(&["check"]);
    let text = String::from_utf8_lossy(&output.stderr);
    assert!(text.contains("NEW_5nm.csv: the file is in no list of tables/build.rs; add a row"), "{text}");
}
