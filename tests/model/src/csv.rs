//! CSV tables: `#` header lines, one line of column names, then rows. A blank cell counts as zero,
//! as in the CIE tables. Whatever is wrong is reported with file and line.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Mutex;

pub struct Table {
    pub file: String,
    columns: Vec<String>,
    /// Line number in the file, and the cells.
    rows: Vec<(usize, Vec<String>)>,
}

/// One row, able to say where it stands.
#[derive(Clone, Copy)]
pub struct Row<'a> {
    table: &'a Table,
    line: usize,
    cells: &'a [String],
}

/// A golden by its name without folder and extension: `golden("03_cri")`.
pub fn golden(name: &str) -> &'static Table {
    cached(&format!("tests/data/{name}.csv"))
}

/// A measured table by its path below `tables/`; what the crate does not ship lies below
/// `tests/data/`.
pub fn table(path: &str) -> &'static Table {
    let shipped = format!("tables/{path}");
    if root().join(&shipped).exists() { cached(&shipped) } else { cached(&format!("tests/data/{path}")) }
}

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// Each file is read once per process and kept until it ends.
fn cached(file: &str) -> &'static Table {
    static READ: Mutex<BTreeMap<String, &'static Table>> = Mutex::new(BTreeMap::new());
    let mut read = READ.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    read.entry(file.to_string()).or_insert_with(|| Box::leak(Box::new(Table::read(file))))
}

impl Table {
    fn read(file: &str) -> Table {
        let text =
            std::fs::read_to_string(root().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"));
        let mut lines = text
            .lines()
            .enumerate()
            .map(|(index, line)| (index + 1, line))
            .filter(|(_, line)| !line.starts_with('#') && !line.trim().is_empty());
        let cells = |line: &str| -> Vec<String> { line.split(',').map(str::to_string).collect() };
        let (_, names) = lines.next().unwrap_or_else(|| panic!("{file}: no line of column names"));
        let columns = cells(names);
        let rows = lines
            .map(|(number, line)| {
                let row = cells(line);
                assert_eq!(row.len(), columns.len(), "{file}:{number}: cells in the row");
                (number, row)
            })
            .collect();
        Table { file: file.to_string(), columns, rows }
    }

    pub fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.rows.iter().map(|(line, cells)| Row { table: self, line: *line, cells })
    }

    pub fn len(&self) -> usize {
        self.rows.len()
    }

    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Column names after the first, which is the key or the wavelength.
    pub fn names(&self) -> &[String] {
        &self.columns[1..]
    }

    pub fn column(&self, name: &str) -> Vec<f64> {
        let index = self.index(name);
        self.rows().map(|row| row.number_at(index)).collect()
    }

    fn index(&self, column: &str) -> usize {
        self.columns
            .iter()
            .position(|name| name == column)
            .unwrap_or_else(|| panic!("{}: no column {column}", self.file))
    }

    /// The first row whose `column` reads `text`.
    pub fn find(&self, column: &str, text: &str) -> Row<'_> {
        self.rows()
            .find(|row| row.text(column) == text)
            .unwrap_or_else(|| panic!("{}: no row with {column} = {text}", self.file))
    }
}

impl<'a> Row<'a> {
    /// File and line, and the first cell, which is the key in every golden that has one.
    pub fn place(&self) -> String {
        format!("{}:{} [{}]", self.table.file, self.line, self.cells[0])
    }

    pub fn text(&self, column: &str) -> &'a str {
        self.cells[self.table.index(column)].trim()
    }

    /// The number in a cell; a blank is zero, `nan` is NaN.
    pub fn number(&self, column: &str) -> f64 {
        self.number_at(self.table.index(column))
    }

    fn number_at(&self, index: usize) -> f64 {
        match self.cells[index].trim() {
            "" => 0.0,
            text => text.parse().unwrap_or_else(|_| {
                let column = &self.table.columns[index];
                panic!("{}: {column} = {text} is no number", self.place())
            }),
        }
    }

    pub fn numbers<const N: usize>(&self, columns: [&str; N]) -> [f64; N] {
        columns.map(|column| self.number(column))
    }

    /// No number was published here: blank or `nan`.
    pub fn is_missing(&self, column: &str) -> bool {
        matches!(self.text(column), "" | "nan")
    }
}
