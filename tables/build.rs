//! Turns the CSV files beside this script into Rust constants.
//!
//! Every file is read strictly: a wrong cell stops the build with a message that names the file, the line and
//! what to do. Nothing here calls a math function of the platform, because exp and pow differ in the last bit
//! between platforms. Tables that need such functions, the Planckian locus and its lights, are made in
//! `locus.rs` and `reference.rs` from the four basic operations alone.

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

/// XYZ observers. Each makes one static with three rows, padded with zeros to the CIE grid of 360..=830 nm.
/// The columns are the constant, the file, the name that users type and the title for reports; the last two
/// make `observer::ALL`.
const OBSERVERS: &[(&str, &str, &str, &str)] = &[
    ("CIE_1931", "cie_1931_2deg_xyz_1nm", "1931", "CIE 1931, 2°"),
    ("CIE_1964", "cie_1964_10deg_xyz_1nm", "1964", "CIE 1964, 10°"),
    ("CIE_2015_2", "cie_2015_2deg_xyz_1nm", "2015-2", "CIE 2015, 2°"),
    ("CIE_2015_10", "cie_2015_10deg_xyz_1nm", "2015-10", "CIE 2015, 10°"),
];

/// Luminous efficiencies and the alpha-opic functions. Each makes one static, with a row for each column of
/// the file. The columns here are the constant, the file, what its rows are and its documentation.
const RESPONSES: &[(&str, &str, &str, &str)] = &[
    (
        "V_PHOTOPIC",
        "v_photopic_1nm",
        "The only row is V(lambda), which is",
        "Weighs a light by V(lambda), the luminous efficiency of the eye in daylight (photopic vision).\n\n\
         Times [`KM`] the result is in lumens for a light in W/nm.",
    ),
    (
        "V_SCOTOPIC",
        "v_scotopic_1nm",
        "The only row is V'(lambda), which is",
        "Weighs a light by V'(lambda), the luminous efficiency of the eye in the dark (scotopic vision).\n\n\
         Times [`KM_SCOTOPIC`] the result is in scotopic lumens for a light in W/nm.",
    ),
    (
        "ALPHA_OPIC",
        "alpha_opic_s026_1nm",
        "The rows are those of S-cones, M-cones, L-cones, rhodopsin and melanopsin, which are",
        "Reports how a light excites the five kinds of receptors of the eye, by the alpha-opic functions of CIE S 026.\n\n\
         [`AlphaOpic`](crate::radiometry::AlphaOpic) gives these numbers with their units.",
    ),
];

/// Cone fundamentals. They are published every 5 nm, and kept so.
const CONES: &[(&str, &str)] =
    &[("LMS_2_5NM", "cie_2006_2deg_lms_5nm_official"), ("LMS_10_5NM", "cie_2006_10deg_lms_5nm_official")];

/// Illuminants. Each column of a file makes one static, on the published grid. The columns here are the file,
/// a suffix of the constants (`FL11` is the official 5 nm table, `FL11_1NM` the other one), and what the
/// lights are: each kind is named once, with the last column of the file that is of this kind.
const ILLUMINANTS: &[(&str, &str, Kinds)] = &[
    ("A_1nm", "", &[("A", "a tungsten filament lamp")]),
    ("C_5nm", "", &[("C", "a filtered tungsten lamp that imitates daylight,")]),
    ("D50_1nm", "", &[("D50", "daylight")]),
    ("D55_5nm", "", &[("D55", "daylight")]),
    ("D65_1nm", "", &[("D65", "daylight")]),
    ("D75_5nm", "", &[("D75", "daylight")]),
    ("ID50_5nm", "", &[("ID50", "daylight behind window glass")]),
    ("ID65_5nm", "", &[("ID65", "daylight behind window glass")]),
    ("FL_5nm", "", FLUORESCENT),
    ("FL_1nm", "_1NM", FLUORESCENT),
    (
        "HP_5nm",
        "",
        &[
            ("HP1", "a high-pressure sodium lamp"),
            ("HP2", "a color-enhanced high-pressure sodium lamp"),
            ("HP5", "a high-pressure metal halide lamp"),
        ],
    ),
    ("LED_5nm", "", LEDS),
    ("LED_1nm", "_1NM", LEDS),
    ("L41_1nm", "", &[("L41", "the white LED by which photometers are calibrated,")]),
];

type Kinds = &'static [(&'static str, &'static str)];

const FLUORESCENT: Kinds = &[
    ("FL6", "a standard fluorescent lamp"),
    ("FL9", "a broad-band fluorescent lamp"),
    ("FL12", "a three-band fluorescent lamp"),
    ("FL3.3", "a standard halophosphate fluorescent lamp"),
    ("FL3.6", "a DeLuxe fluorescent lamp"),
    ("FL3.11", "a three-band fluorescent lamp"),
    ("FL3.14", "a multi-band fluorescent lamp"),
    ("FL3.15", "a fluorescent lamp that simulates D65,"),
];
const LEDS: Kinds = &[
    ("LED-B5", "a blue LED with a phosphor,"),
    ("LED-BH1", "a lamp of a blue LED with a phosphor and a red LED,"),
    ("LED-RGB1", "a lamp of red, green and blue LEDs,"),
    ("LED-V2", "a violet LED with phosphors,"),
];

/// The components of daylight, which are no illuminants themselves.
const COMPONENTS: (&str, Kinds) = (
    "daylight_components_5nm",
    &[
        ("S0", "the mean of daylight,"),
        ("S1", "the first component of daylight, which varies from yellow to blue,"),
        ("S2", "the second component of daylight, which varies from pink to green,"),
    ],
);

/// Sample sets. Each file makes one static array. The columns are the visibility, the constant, the file and
/// the documentation.
const SAMPLES: &[(&str, &str, &str, &str)] = &[
    ("", "TCS14_5NM", "cri_tcs14_5nm", "Holds the test color samples 1 to 14 as tabulated."),
    ("", "TCS15_5NM", "cri_tcs15_5nm", "Holds test color sample 15 as tabulated."),
    (
        "pub",
        "CES",
        "cie224_ces99_1nm",
        "Holds the reflectances of the 99 color evaluation samples of CIE 224:2017, which ANSI/IES TM-30-18 uses \
         too.\n\n\
         A program that reads this static contains all samples, 159 KB.\n\n\
         # Example\n\
         ```\n\
         use nanospectra::matter::CES;\n\n\
         // 99 samples from 380 to 780 nm; the first one reflects 63.6 % at 380 nm.\n\
         assert_eq!((CES.len(), CES[0].values()[0]), (99, 0.6359));\n\
         ```",
    ),
];

fn main() {
    println!("cargo::rerun-if-changed=tables");
    // With this, `src/lib.rs` builds for a processor whose results differ.
    println!("cargo::rustc-check-cfg=cfg(nanospectra_x87)");
    if let Err(message) = generate() {
        // This is one line in cargo's output, and it fails the build. An error code would add four lines to
        // it.
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
        let docs = format!(
            "Sees X, Y and Z of a light by the color-matching functions of {}.\n\n\
             See the [example](crate::observer#example).",
            title.replace(", ", " for a field of ")
        );
        observer(
            &mut text,
            constant,
            "The rows are x-bar, y-bar and z-bar, which are",
            &docs,
            &read("cmf", file)?,
        )?;
        let _ = writeln!(named, "    {name:?} {title:?} {constant},");
    }
    for (name, file, rows, docs) in RESPONSES {
        let docs = format!("{docs} See the [example](crate::observer#example).");
        observer(&mut text, name, rows, &docs, &read("cmf", file)?)?;
    }
    for (name, file) in CONES {
        sample_set(
            &mut text,
            "",
            name,
            "Power",
            "Holds cone fundamentals as tabulated.",
            &read("cmf", file)?,
        );
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
    for (visible, name, file, docs) in SAMPLES {
        let table = read("samples", file)?;
        table.demand_between(0.0, 1.5)?;
        sample_set(&mut text, visible, name, "Factor", docs, &table);
    }
    save(&out.join("samples.rs"), &text)?;

    save(&out.join("upsample.rs"), &upsample::source(&tables.join("upsample"))?)?;

    save(&out.join("fixed_locus.rs"), &fixed_locus::source(&cmf))?;
    save(&out.join("reference.rs"), &reference::source(&cmf))?;
    save(&out.join("locus.rs"), &locus::source(&cmf))
}

fn save(path: &Path, text: &str) -> Result<(), String> {
    fs::write(path, text).map_err(|e| format!("{}: the file cannot be written: {e}", path.display()))
}

/// Doc comments with the lines of `docs`.
fn comment(docs: &str) -> String {
    docs.lines().map(|line| format!("/// {line}").trim_end().to_owned() + "\n").collect()
}

/// Writes `pub static CIE_1931: FineObserver<3> = ..;`, with its documentation.
fn observer(text: &mut String, name: &str, rows: &str, docs: &str, table: &Table) -> Result<(), String> {
    table.demand_between(0.0, 3.0)?;
    table.demand_step(1)?;
    let channels = table.columns.len();
    let _ = writeln!(text, "{}///", comment(docs));
    let _ = writeln!(text, "/// {rows} zero where the CIE tabulates nothing.\n///");
    let _ = write!(text, "{}", comment(&table.reference("")));
    let _ = writeln!(text, "pub static {name}: FineObserver<{channels}> = Observer::from_rows([");
    for column in &table.columns {
        let _ = writeln!(text, "    {},", numbers(&table.on_cie_grid(column)?));
    }
    let _ = writeln!(text, "]);");
    Ok(())
}

/// Writes `pub static FL11: Spectrum<Power, 81, Nodes<380, 780>> = ..;` for a column, with its documentation,
/// and returns the name of the constant.
fn light(text: &mut String, table: &Table, column: &[f64], name: &str, suffix: &str, what: &str) -> String {
    let constant = name.replace(['-', '.'], "_") + suffix;
    let (grid, bands, step) = (table.grid(), column.len(), table.step());
    let _ = writeln!(text, "/// CIE {name} is {what} here in steps of {step} nm.\n///");
    if !suffix.is_empty() {
        let first = constant.trim_end_matches(suffix);
        let _ = writeln!(text, "/// It is the CIE's second table of this lamp, beside [`{first}`].\n///");
    }
    let _ = writeln!(text, "/// See the [example](crate::light#example).\n///");
    let _ = write!(text, "{}", comment(&table.reference(name)));
    let _ = writeln!(text, "pub static {constant}: Spectrum<Power, {bands}, {grid}> =");
    let _ = writeln!(text, "    Spectrum::from_bins({});", numbers(column));
    constant
}

/// Says what the light of a column is.
fn kind(kinds: Kinds, table: &Table, name: &str) -> Result<String, String> {
    let place = |name: &str| table.names.iter().position(|other| other == name);
    let kind = kinds.iter().find(|(last, _)| *last == name || place(last) >= place(name));
    let missing = || format!("tables/build.rs does not say what {name} is; add it to the kinds of its file");
    kind.map(|(_, what)| (*what).to_owned()).ok_or_else(missing)
}

/// Refuses a folder with a table that no list of this file names.
fn all_listed<'a>(folder: &Path, files: impl Iterator<Item = &'a str>) -> Result<(), String> {
    let files: Vec<&str> = files.collect();
    let unreadable = |e| format!("{}: the folder cannot be read: {e}", folder.display());
    for entry in fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        let name = path.file_stem().and_then(|name| name.to_str()).unwrap_or_default();
        if path.extension().is_some_and(|extension| extension == "csv") && !files.contains(&name) {
            return Err(format!("{}: the file is in no list of tables/build.rs; add a row", path.display()));
        }
    }
    Ok(())
}

/// Writes `pub static CES: [Spectrum<Factor, 401, Nodes<380, 780>>; 99] = ..;`, with its documentation.
fn sample_set(text: &mut String, visible: &str, name: &str, quantity: &str, docs: &str, table: &Table) {
    let (count, grid, bands) = (table.columns.len(), table.grid(), table.wavelengths.len());
    let _ = write!(text, "{}///\n{}", comment(docs), comment(&table.reference("")));
    let _ = writeln!(text, "{visible} static {name}: [Spectrum<{quantity}, {bands}, {grid}>; {count}] = [");
    for column in &table.columns {
        let _ = writeln!(text, "    Spectrum::from_bins({}),", numbers(column));
    }
    let _ = writeln!(text, "];");
}

/// An array literal of `f32` numbers, each with as many digits as are needed to get the same bits back.
fn numbers(values: &[f64]) -> String {
    let cells: Vec<String> = values.iter().map(|v| format!("{:?}", *v as f32)).collect();
    format!("[{}]", cells.join(", "))
}
