//! Tables that a page words itself. Only the counts of instructions and bytes are put into their cells.

use super::grouped;
use crate::counts::{self, Profile};
use nanospectra_cli::failure::Failure;

const M4F: &str = "thumbv7em-none-eabihf";
const BOARDS: [&str; 4] =
    [M4F, "thumbv8m.main-none-eabihf", "thumbv6m-none-eabi", "riscv32imac-unknown-none-elf"];

/// The counts that a cell shows with " / " between them: of each the target, the profile, and which count of
/// the row it is.
type Cell = &'static [(&'static str, Profile, usize)];

struct Table {
    name: &'static str,
    /// The cells that are filled, each with its column, counted from 0.
    cells: &'static [(usize, Cell)],
    /// The rows that are filled: the label in the first column, the names of the counts on record, and their
    /// unit.
    rows: &'static [(&'static str, &'static [&'static str], &'static str)],
}

use Profile::{Release, Small};

const TABLES: [Table; 3] = [
    Table {
        name: "counts",
        cells: &[
            (1, &[(BOARDS[0], Release, 0), (BOARDS[0], Small, 0)]),
            (2, &[(BOARDS[1], Release, 0), (BOARDS[1], Small, 0)]),
            (3, &[(BOARDS[2], Release, 0), (BOARDS[2], Small, 0)]),
            (4, &[(BOARDS[3], Release, 0), (BOARDS[3], Small, 0)]),
        ],
        rows: &[
            ("counts to XYZ (`Meter`)", &["counts-xyz-meter"], "instructions"),
            ("XYZ to CCT and Duv", &["xyz-cct-duv"], "instructions"),
            ("XYZ to Lab (`Fast`)", &["xyz-lab-fast"], "instructions"),
            ("**counts to XYZ, CCT, Duv, Lab**", &["counts-f32"], "instructions"),
            ("its flash, tables included, bytes", &["counts_f32"], "bytes"),
            ("its stack, bytes", &["counts-f32"], "stack-bytes"),
            ("integers: counts to XYZ and lux", &["fixed-counts-xyz-lux"], "instructions"),
            ("**integers: counts to lux, CCT, Duv**", &["fixed-counts-cct-duv"], "instructions"),
            ("its flash, bytes", &["counts_fixed"], "bytes"),
            ("its stack, bytes", &["fixed-counts-cct-duv"], "stack-bytes"),
            ("integers: 81 bands of 16 bits to XYZ", &["fixed-xyz-81"], "instructions"),
        ],
    },
    Table {
        name: "paths",
        cells: &[(1, &[(M4F, Release, 0), (M4F, Release, 1)]), (2, &[(M4F, Small, 0), (M4F, Small, 1)])],
        rows: &[
            (
                "light onto paper: the path / a loop by hand",
                &["path-surface", "path-surface-by-hand"],
                "instructions",
            ),
            (
                "through glass onto paper: the path / by hand",
                &["path-glass-surface", "path-glass-surface-by-hand"],
                "instructions",
            ),
            ("onto a dye (fluorescence, rank one)", &["path-dye"], "instructions"),
            ("onto a Donaldson matrix (all pairs of bands)", &["path-donaldson"], "instructions"),
            ("off two mirrors, as Stokes vectors", &["path-two-mirrors"], "instructions"),
            ("**any of these, folded**", &["path-vest-folded"], "instructions"),
        ],
    },
    Table {
        name: "stack",
        cells: &[
            (1, &[(M4F, Release, 0), (M4F, Small, 0)]),
            (2, &[(BOARDS[2], Release, 0), (BOARDS[2], Small, 0)]),
        ],
        rows: &[
            ("TM-30 of a light (`tm30`)", &["tm30"], "stack-bytes"),
            ("CRI of a light (`cri`)", &["cri"], "stack-bytes"),
            ("an illuminant by its name (`light::named`)", &["light-named"], "stack-bytes"),
            ("an eye under a light, folded into 16 bands", &["under-fold-3x16"], "stack-bytes"),
            ("`Reconstruction::smooth`, 8 channels, 31 bins", &["smooth-8x31"], "stack-bytes"),
            ("the same, 81 bins", &["smooth-8x81"], "stack-bytes"),
            ("`nonnegative_spectrum`, 8 channels, 31 bins", &["nonnegative-8x31"], "stack-bytes"),
            ("the same on 81 bins", &["nonnegative-8x81"], "stack-bytes"),
            ("`Fit::solve`, 8 channels", &["fit-8-solve"], "stack-bytes"),
            ("`Fit::solve`, 18 channels", &["fit-18-solve"], "stack-bytes"),
            ("a sigmoid of a color (`Sigmoid::reflectance`)", &["upsample-reflectance"], "stack-bytes"),
            ("`Sigmoid::desaturated`", &["upsample-desaturated"], "stack-bytes"),
            ("a film on 31 bands", &["film-reflectance-31"], "stack-bytes"),
            ("a scene folded, 31 bands", &["scene-fold-3x31"], "stack-bytes"),
            ("a scene within a budget, 31 bands", &["scene-within-budget-31"], "stack-bytes"),
        ],
    },
];

/// Returns the table of this name with the counts on record in it. Other rows stay as they are.
pub fn table(page: &str, name: &str, old: &str) -> Result<String, Failure> {
    let spec = TABLES.iter().find(|table| table.name == name);
    let spec = spec.ok_or_else(|| Failure::of(page, format_args!("{name} is no table; see its marks")))?;
    let mut rows = spec.rows.iter();
    let mut next = rows.next();
    let mut out = String::new();
    for line in old.lines() {
        let mut cells: Vec<String> =
            line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect();
        if let Some((label, counted, unit)) = next
            && cells.first().is_some_and(|cell| cell == label)
        {
            for (column, parts) in spec.cells {
                let parts: Vec<String> = parts.iter().filter_map(|part| count(part, counted, unit)).collect();
                if let Some(cell) = cells.get_mut(*column) {
                    *cell = parts.join(" / ");
                }
            }
            next = rows.next();
            out += &format!("| {} |\n", cells.join(" | "));
        } else {
            out += &format!("{line}\n");
        }
    }
    match next {
        None => Ok(out),
        Some((label, ..)) => {
            Err(Failure::of(page, format_args!("the table {name} has no row {label}; write it in its place")))
        }
    }
}

/// Returns one count of a cell, or `None` if the row has no such count.
fn count((board, profile, which): &(&str, Profile, usize), counted: &[&str], unit: &str) -> Option<String> {
    let what = counted.get(*which)?;
    let count = if unit == "bytes" {
        // The flash of an image is its code and its tables.
        ["code", "tables"]
            .into_iter()
            .map(|part| counts::recorded(board, *profile, &format!("{what}-{part}"), unit))
            .sum::<Option<u32>>()?
    } else {
        counts::recorded(board, *profile, what, unit)?
    };
    Some(grouped(count))
}
