//! A published table, whose file has header lines that begin with `#`, a row of names, and rows of a
//! wavelength and values.

use std::fs;
use std::path::{Path, PathBuf};

/// Smaller values are tails that no sensor sees, and are read as zero: as subnormals they would make sums 2.7
/// times slower on x86.
const TAIL: f64 = 1e-30;

pub struct Table {
    path: PathBuf,
    header: Vec<(String, String)>,
    pub names: Vec<String>,
    pub wavelengths: Vec<u16>,
    pub columns: Vec<Vec<f64>>,
    /// The line of each row in the file, counted from 1.
    lines: Vec<usize>,
}

impl Table {
    /// Reads and checks a file. The error names the file, the line, what is wrong and what to do.
    pub fn read(path: &Path) -> Result<Self, String> {
        let text = fs::read_to_string(path).map_err(|e| {
            format!("{}: the file cannot be read ({e}); restore it from the repository", path.display())
        })?;
        let mut table = Table {
            path: path.to_path_buf(),
            header: Vec::new(),
            names: Vec::new(),
            wavelengths: Vec::new(),
            columns: Vec::new(),
            lines: Vec::new(),
        };
        for (index, line) in text.lines().enumerate() {
            let at = |what: String| format!("{}:{}: {what}", path.display(), index + 1);
            if let Some(fact) = line.strip_prefix('#') {
                if let Some((key, value)) = fact.split_once(':') {
                    table.header.push((key.trim().to_owned(), value.trim().to_owned()));
                }
            } else if table.names.is_empty() {
                table.names = line.split(',').skip(1).map(str::to_owned).collect();
                table.columns = vec![Vec::new(); table.names.len()];
            } else {
                table.push(line).map_err(at)?;
                table.lines.push(index + 1);
            }
        }
        for fact in ["name", "source", "license", "range_nm", "step_nm"] {
            if table.fact(fact).is_none() {
                return Err(format!("{}: the header has no '# {fact}:' line; add it", path.display()));
            }
        }
        table.check_grid()?;
        Ok(table)
    }

    fn push(&mut self, line: &str) -> Result<(), String> {
        let cells: Vec<&str> = line.split(',').collect();
        if cells.len() != self.columns.len() + 1 {
            let (found, wanted) = (cells.len(), self.columns.len() + 1);
            return Err(format!(
                "the row has {found} cells where the heading has {wanted}; complete the row"
            ));
        }
        let nm: u16 = cells[0]
            .parse()
            .map_err(|_| format!("'{}' is not a whole number of nanometers; correct it", cells[0]))?;
        self.wavelengths.push(nm);
        let blank_is_zero = self.fact("note").is_some_and(|note| note.starts_with("blank = not tabulated"));
        for (column, cell) in self.columns.iter_mut().zip(&cells[1..]) {
            let value = match cell.trim() {
                "" if blank_is_zero => 0.0,
                "" => {
                    return Err(
                        "the row has an empty cell; fill it, or say in the header what blank means".into()
                    );
                }
                number => {
                    number.parse::<f64>().map_err(|_| format!("'{number}' is not a number; correct it"))?
                }
            };
            if !(value as f32).is_finite() {
                return Err(format!("{value} is not a finite number in f32; correct it"));
            }
            column.push(if value.abs() < TAIL { 0.0 } else { value });
        }
        Ok(())
    }

    /// Refuses a table whose wavelengths are not those that its header promises, with the same step
    /// throughout.
    fn check_grid(&self) -> Result<(), String> {
        let (first, last) = (self.wavelengths.first(), self.wavelengths.last());
        let (Some(&first), Some(&last)) = (first, last) else {
            return Err(format!(
                "{}: the file has no data rows; restore it from the repository",
                self.path.display()
            ));
        };
        if self.fact("range_nm") != Some(&format!("{first}-{last}")) {
            return Err(format!(
                "{}: the rows span {first}-{last} nm but the header's range_nm says otherwise; correct what is wrong",
                self.path.display()
            ));
        }
        self.demand_step(self.step())?;
        if self.fact("step_nm") != Some(&self.step().to_string()) {
            return Err(format!(
                "{}: the rows are {} nm apart but the header's step_nm says otherwise; correct what is wrong",
                self.path.display(),
                self.step()
            ));
        }
        Ok(())
    }

    /// The difference from one row to the next, in nm.
    pub fn step(&self) -> u16 {
        match self.wavelengths[..] {
            [a, b, ..] => b.saturating_sub(a),
            _ => 0,
        }
    }

    /// Refuses a table whose rows are not exactly `step` nm apart.
    pub fn demand_step(&self, step: u16) -> Result<(), String> {
        for (pair, line) in self.wavelengths.windows(2).zip(&self.lines[1..]) {
            if step == 0 || pair[1] != pair[0] + step {
                return Err(format!(
                    "{}:{line}: {} nm follows {} nm where the step should be {step} nm; sort or complete the rows",
                    self.path.display(),
                    pair[1],
                    pair[0]
                ));
            }
        }
        Ok(())
    }

    /// Refuses a table with a value outside `low..=high`, which is probably a slip of the decimal point.
    pub fn demand_between(&self, low: f64, high: f64) -> Result<(), String> {
        for (column, name) in self.columns.iter().zip(&self.names) {
            for ((value, nm), line) in column.iter().zip(&self.wavelengths).zip(&self.lines) {
                if !(low..=high).contains(value) {
                    return Err(format!(
                        "{}:{line}: {name} at {nm} nm is {value}, outside {low}..{high}; check the decimal point",
                        self.path.display()
                    ));
                }
            }
        }
        Ok(())
    }

    /// The grid as a type, such as `Nodes<380, 780>`.
    pub fn grid(&self) -> String {
        format!("Nodes<{}, {}>", self.wavelengths[0], self.wavelengths[self.wavelengths.len() - 1])
    }

    /// A column of a 1 nm table on 360..=830 nm, which is zero where the table has no row.
    pub fn on_cie_grid(&self, column: &[f64]) -> Result<Vec<f64>, String> {
        let mut wide = vec![0.0; 471];
        for ((value, nm), line) in column.iter().zip(&self.wavelengths).zip(&self.lines) {
            let slot = nm.checked_sub(360).and_then(|k| wide.get_mut(usize::from(k)));
            *slot.ok_or_else(|| {
                format!("{}:{line}: {nm} nm is outside 360..830 nm; remove the row", self.path.display())
            })? = *value;
        }
        Ok(wide)
    }

    /// The section of a documentation that says what the table is, who published it under which license, and
    /// in which file of this folder, and in which of its columns, the numbers stand.
    pub fn reference(&self, column: &str) -> String {
        let fact = |key| self.fact(key).unwrap_or_default();
        // (A header may have a remark behind the DOI.)
        let doi = self.fact("doi").and_then(|doi| doi.split(' ').next());
        let doi = doi.map_or(String::new(), |doi| format!(", doi {doi}"));
        let (license, _) = fact("license").split_once(" (").unwrap_or((fact("license"), ""));
        let of = if column.is_empty() { String::new() } else { format!("column `{column}` of ") };
        format!(
            "# Reference\n{}. Published in {}{doi}; {license}.\n\n\
             The numbers are those of {of}`{}`; `tables/build.rs` makes this static from that file.\n",
            fact("name"),
            fact("source"),
            self.path.display()
        )
    }

    fn fact(&self, key: &str) -> Option<&str> {
        self.header.iter().find(|(k, _)| k == key).map(|(_, v)| v.as_str())
    }
}
