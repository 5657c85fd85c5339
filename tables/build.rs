//! Turns the CSV files beside this script into Rust constants.
//!
//! Every file is read strictly: a wrong cell stops the build with file, line and what to do.
//! Nothing here calls a platform math function (exp and pow differ in the last bit between
//! platforms); the transcendental tables, the Planckian locus and its lights, are made in `locus.rs` and
//! `reference.rs` from the four operations alone.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs};

mod fixed_locus;
mod locus;
mod reference;
mod table;
mod upsample;

use table::Table;

/// An XYZ observer, cone set or luminous efficiency: one static with a row for each column,
/// padded with zeros to the CIE grid of 360..=830 nm.
const OBSERVERS: &[(&str, &str, &str)] = &[
    ("CIE_1931", "cie_1931_2deg_xyz_1nm", "x-bar, y-bar, z-bar"),
    ("CIE_1964", "cie_1964_10deg_xyz_1nm", "x-bar, y-bar, z-bar of the 10 degree field"),
    ("CIE_2015_2", "cie_2015_2deg_xyz_1nm", "x-bar, y-bar, z-bar made from the cone fundamentals"),
    ("CIE_2015_10", "cie_2015_10deg_xyz_1nm", "x-bar, y-bar, z-bar made from the cone fundamentals"),
    ("V_PHOTOPIC", "v_photopic_1nm", "V(lambda)"),
    ("V_SCOTOPIC", "v_scotopic_1nm", "V'(lambda)"),
    ("ALPHA_OPIC", "alpha_opic_s026_1nm", "S-cone, M-cone, L-cone, rhodopsin, melanopsin"),
];

/// Cone fundamentals: published every 5 nm, kept so.
const CONES: &[(&str, &str)] =
    &[("LMS_2_5NM", "cie_2006_2deg_lms_5nm_official"), ("LMS_10_5NM", "cie_2006_10deg_lms_5nm_official")];

/// Illuminants: one static for each column, on the published grid. The suffix goes after the
/// column's name: `FL11` is the official 5 nm table, `FL11_1NM` the other one.
const ILLUMINANTS: &[(&str, &str)] = &[
    ("A_1nm", ""),
    ("C_5nm", ""),
    ("D50_1nm", ""),
    ("D55_5nm", ""),
    ("D65_1nm", ""),
    ("D75_5nm", ""),
    ("ID50_5nm", ""),
    ("ID65_5nm", ""),
    ("FL_5nm", ""),
    ("FL_1nm", "_1NM"),
    ("HP_5nm", ""),
    ("LED_5nm", ""),
    ("LED_1nm", "_1NM"),
    ("L41_1nm", ""),
];

/// What daylight is made of; no illuminants themselves.
const DAYLIGHT: &str = "daylight_components_5nm";

/// Sample sets: one static array for each file.
const SAMPLES: &[(&str, &str, &str)] = &[
    ("", "TCS14_5NM", "cri_tcs14_5nm"),
    ("", "TCS15_5NM", "cri_tcs15_5nm"),
    ("pub", "CES", "cie224_ces99_1nm"),
];

fn main() {
    println!("cargo::rerun-if-changed=tables");
    if let Err(message) = generate() {
        // One line in cargo's output, which fails the build; exiting with an error too would add four.
        println!("cargo::error={message}");
    }
}

fn generate() -> Result<(), String> {
    let out = PathBuf::from(env::var_os("OUT_DIR").ok_or("OUT_DIR is not set: run through cargo")?);
    let tables = Path::new("tables");

    let mut text = String::new();
    for (name, file, rows) in OBSERVERS {
        let table = Table::read(&tables.join("cmf").join(file).with_extension("csv"))?;
        observer(&mut text, name, rows, &table)?;
    }
    for (name, file) in CONES {
        let table = Table::read(&tables.join("cmf").join(file).with_extension("csv"))?;
        sample_set(&mut text, "", name, "Power", &table);
    }
    save(&out.join("observers.rs"), &text)?;

    let (mut text, mut names) = (String::new(), String::new());
    for (file, suffix) in ILLUMINANTS {
        let table = Table::read(&tables.join("illuminants").join(file).with_extension("csv"))?;
        table.demand_between(0.0, 1e6)?;
        illuminants(&mut text, &mut names, suffix, &table);
    }
    let components = Table::read(&tables.join("illuminants").join(DAYLIGHT).with_extension("csv"))?;
    illuminants(&mut text, &mut String::new(), "", &components);
    text += &format!("by_name! {{\n{names}}}\n");
    save(&out.join("illuminants.rs"), &text)?;

    let mut text = String::new();
    for (visible, name, file) in SAMPLES {
        let table = Table::read(&tables.join("samples").join(file).with_extension("csv"))?;
        table.demand_between(0.0, 1.5)?;
        sample_set(&mut text, visible, name, "Factor", &table);
    }
    save(&out.join("samples.rs"), &text)?;

    save(&out.join("upsample.rs"), &upsample::source(&tables.join("upsample"))?)?;

    let cmf = Table::read(&tables.join("cmf/cie_1931_2deg_xyz_1nm.csv"))?;
    save(&out.join("fixed_locus.rs"), &fixed_locus::source(&cmf))?;
    save(&out.join("reference.rs"), &reference::source(&cmf))?;
    save(&out.join("locus.rs"), &locus::source(&cmf))
}

fn save(path: &Path, text: &str) -> Result<(), String> {
    fs::write(path, text).map_err(|e| format!("{}: cannot be written: {e}", path.display()))
}

/// `pub static CIE_1931: FineObserver<3> = ..;`
fn observer(text: &mut String, name: &str, rows: &str, table: &Table) -> Result<(), String> {
    table.demand_between(0.0, 3.0)?;
    table.demand_step(1)?;
    let channels = table.columns.len();
    let _ = writeln!(text, "{}///\n/// Rows: {rows}; zero where CIE tabulates nothing.", table.docs());
    let _ = writeln!(text, "pub static {name}: FineObserver<{channels}> = Observer::from_rows([");
    for column in &table.columns {
        let _ = writeln!(text, "    {},", numbers(&table.on_cie_grid(column)?));
    }
    let _ = writeln!(text, "]);");
    Ok(())
}

/// `pub static FL11: Spectrum<Power, 81, Nodes<380, 780>> = ..;` for each column, and its line in
/// the list of names.
fn illuminants(text: &mut String, names: &mut String, suffix: &str, table: &Table) {
    for (column, header) in table.columns.iter().zip(&table.names) {
        let name = header.replace(['-', '.'], "_") + suffix;
        let (grid, bands) = (table.grid(), column.len());
        let values = numbers(column);
        let _ = writeln!(text, "{}///\n/// This is {header}.", table.docs());
        let _ = writeln!(names, "    \"{header}{suffix}\" => {name},");
        let _ = writeln!(text, "pub static {name}: Spectrum<Power, {bands}, {grid}> =");
        let _ = writeln!(text, "    Spectrum::from_bins({values});");
    }
}

/// `pub static CES: [Spectrum<Factor, 401, Nodes<380, 780>>; 99] = ..;`
fn sample_set(text: &mut String, visible: &str, name: &str, quantity: &str, table: &Table) {
    let (count, grid, bands) = (table.columns.len(), table.grid(), table.wavelengths.len());
    let _ = write!(text, "{}", table.docs());
    let _ = writeln!(text, "{visible} static {name}: [Spectrum<{quantity}, {bands}, {grid}>; {count}] = [");
    for column in &table.columns {
        let _ = writeln!(text, "    Spectrum::from_bins({}),", numbers(column));
    }
    let _ = writeln!(text, "];");
}

/// An array literal of `f32`, each number with the digits that bring the same bits back.
fn numbers(values: &[f64]) -> String {
    let cells: Vec<String> = values.iter().map(|v| format!("{:?}", *v as f32)).collect();
    format!("[{}]", cells.join(", "))
}
