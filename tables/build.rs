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
mod lights;
mod locus;
mod reference;
mod table;
mod upsample;

use table::Table;

/// An XYZ observer: one static with three rows, padded with zeros to the CIE grid of 360..=830 nm. With the
/// name that users type and the title for reports, which make `observer::ALL`.
const OBSERVERS: &[(&str, &str, &str, &str)] = &[
    ("CIE_1931", "cie_1931_2deg_xyz_1nm", "1931", "CIE 1931, 2°"),
    ("CIE_1964", "cie_1964_10deg_xyz_1nm", "1964", "CIE 1964, 10°"),
    ("CIE_2015_2", "cie_2015_2deg_xyz_1nm", "2015-2", "CIE 2015, 2°"),
    ("CIE_2015_10", "cie_2015_10deg_xyz_1nm", "2015-10", "CIE 2015, 10°"),
];

/// Luminous efficiencies and the alpha-opic functions: likewise, with a row for each column.
const RESPONSES: &[(&str, &str, &str)] = &[
    ("V_PHOTOPIC", "v_photopic_1nm", "V(lambda)"),
    ("V_SCOTOPIC", "v_scotopic_1nm", "V'(lambda)"),
    ("ALPHA_OPIC", "alpha_opic_s026_1nm", "S-cone, M-cone, L-cone, rhodopsin, melanopsin"),
];

/// Cone fundamentals: published every 5 nm, kept so.
const CONES: &[(&str, &str)] =
    &[("LMS_2_5NM", "cie_2006_2deg_lms_5nm_official"), ("LMS_10_5NM", "cie_2006_10deg_lms_5nm_official")];

/// Illuminants: one static for each column, on the published grid. The suffix goes after the column's name:
/// `FL11` is the official 5 nm table, `FL11_1NM` the other one. What a light is stands with the last column
/// that is of this kind.
const ILLUMINANTS: &[(&str, &str, Kinds)] = &[
    ("A_1nm", "", &[("A", "a tungsten filament lamp")]),
    ("C_5nm", "", &[("C", "daylight as a filtered tungsten lamp gives it")]),
    ("D50_1nm", "", &[("D50", "daylight")]),
    ("D55_5nm", "", &[("D55", "daylight")]),
    ("D65_1nm", "", &[("D65", "daylight")]),
    ("D75_5nm", "", &[("D75", "daylight")]),
    ("ID50_5nm", "", &[("ID50", "daylight indoors, behind a window")]),
    ("ID65_5nm", "", &[("ID65", "daylight indoors, behind a window")]),
    ("FL_5nm", "", FLUORESCENT),
    ("FL_1nm", "_1NM", FLUORESCENT),
    (
        "HP_5nm",
        "",
        &[
            ("HP1", "a high-pressure sodium lamp"),
            ("HP2", "a high-pressure sodium lamp of enhanced color"),
            ("HP5", "a high-pressure metal halide lamp"),
        ],
    ),
    ("LED_5nm", "", LEDS),
    ("LED_1nm", "_1NM", LEDS),
    ("L41_1nm", "", &[("L41", "a white LED, the reference for calibrating photometers")]),
];

type Kinds = &'static [(&'static str, &'static str)];

const FLUORESCENT: Kinds = &[
    ("FL6", "a fluorescent lamp, standard"),
    ("FL9", "a fluorescent lamp, broad-band"),
    ("FL12", "a fluorescent lamp, narrow-band"),
    ("FL3.3", "a fluorescent lamp, standard halophosphate"),
    ("FL3.6", "a fluorescent lamp, DeLuxe"),
    ("FL3.11", "a fluorescent lamp, three-band"),
    ("FL3.14", "a fluorescent lamp, multi-band"),
    ("FL3.15", "a fluorescent lamp that simulates D65"),
];
const LEDS: Kinds = &[
    ("LED-B5", "a blue LED with a phosphor"),
    ("LED-BH1", "a blue LED with a phosphor beside a red LED"),
    ("LED-RGB1", "red, green and blue LEDs"),
    ("LED-V2", "a violet LED with phosphors"),
];

/// What daylight is made of; no illuminants themselves.
const COMPONENTS: (&str, Kinds) = (
    "daylight_components_5nm",
    &[
        ("S0", "the mean of daylight"),
        ("S1", "the first component of daylight, from yellow to blue"),
        ("S2", "the second component of daylight, from pink to green"),
    ],
);

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

    let read = |folder: &str, file: &str| Table::read(&tables.join(folder).join(file).with_extension("csv"));
    let cmf = read("cmf", OBSERVERS[0].1)?;

    let (mut text, mut named) = (String::new(), String::new());
    for (constant, file, name, title) in OBSERVERS {
        observer(&mut text, constant, "x-bar, y-bar, z-bar", &read("cmf", file)?)?;
        let _ = writeln!(named, "    {name:?} {title:?} {constant},");
    }
    for (name, file, rows) in RESPONSES {
        observer(&mut text, name, rows, &read("cmf", file)?)?;
    }
    for (name, file) in CONES {
        sample_set(&mut text, "", name, "Power", &read("cmf", file)?);
    }
    text += &format!("by_name! {{\n{named}}}\n");
    save(&out.join("observers.rs"), &text)?;
    let responses = RESPONSES.iter().map(|row| row.1).chain(CONES.iter().map(|row| row.1));
    all_listed(&tables.join("cmf"), OBSERVERS.iter().map(|row| row.1).chain(responses))?;

    let (mut text, mut names, mut brief) = (String::new(), String::new(), Vec::new());
    let locus = lights::Locus::new(&cmf);
    for (file, suffix, kinds) in ILLUMINANTS {
        let table = read("illuminants", file)?;
        table.demand_between(0.0, 1e6)?;
        for (column, name) in table.columns.iter().zip(&table.names) {
            let color = locus.describe(&table, column, &cmf);
            let constant =
                light(&mut text, &table, column, name, suffix, &(kind(kinds, &table, name)? + &color));
            let _ = writeln!(names, "    \"{name}{suffix}\" => {constant},");
        }
        if suffix.is_empty() {
            brief.extend(table.names.clone());
        }
    }
    let (file, kinds) = COMPONENTS;
    let table = read("illuminants", file)?;
    for (column, name) in table.columns.iter().zip(&table.names) {
        light(&mut text, &table, column, name, "", &kind(kinds, &table, name)?);
    }
    text += &format!("by_name! {{\n    \"E, {}\";\n{names}}}\n", lights::in_brief(&brief));
    save(&out.join("illuminants.rs"), &text)?;
    all_listed(&tables.join("illuminants"), ILLUMINANTS.iter().map(|row| row.0).chain([file]))?;

    let mut text = String::new();
    for (visible, name, file) in SAMPLES {
        let table = read("samples", file)?;
        table.demand_between(0.0, 1.5)?;
        sample_set(&mut text, visible, name, "Factor", &table);
    }
    save(&out.join("samples.rs"), &text)?;

    save(&out.join("upsample.rs"), &upsample::source(&tables.join("upsample"))?)?;

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

/// `pub static FL11: Spectrum<Power, 81, Nodes<380, 780>> = ..;` for a column, whose constant it returns.
fn light(text: &mut String, table: &Table, column: &[f64], name: &str, suffix: &str, what: &str) -> String {
    let constant = name.replace(['-', '.'], "_") + suffix;
    let (grid, bands, step) = (table.grid(), column.len(), table.step());
    let _ = write!(text, "/// CIE {name} every {step} nm: {what}.\n///\n{}", table.docs());
    let _ = writeln!(text, "pub static {constant}: Spectrum<Power, {bands}, {grid}> =");
    let _ = writeln!(text, "    Spectrum::from_bins({});", numbers(column));
    constant
}

/// What the light of a column is.
fn kind(kinds: Kinds, table: &Table, name: &str) -> Result<String, String> {
    let place = |name: &str| table.names.iter().position(|other| other == name);
    let kind = kinds.iter().find(|(last, _)| *last == name || place(last) >= place(name));
    let missing = || format!("tables/build.rs does not say what {name} is; add it to its kinds");
    kind.map(|(_, what)| (*what).to_owned()).ok_or_else(missing)
}

/// Refuses a folder with a table that no list of this file names.
fn all_listed<'a>(folder: &Path, files: impl Iterator<Item = &'a str>) -> Result<(), String> {
    let files: Vec<&str> = files.collect();
    for entry in fs::read_dir(folder).map_err(|e| format!("{}: {e}", folder.display()))? {
        let path = entry.map_err(|e| format!("{}: {e}", folder.display()))?.path();
        let name = path.file_stem().and_then(|name| name.to_str()).unwrap_or_default();
        if path.extension().is_some_and(|extension| extension == "csv") && !files.contains(&name) {
            return Err(format!("{}: in no list of tables/build.rs; add a row", path.display()));
        }
    }
    Ok(())
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
