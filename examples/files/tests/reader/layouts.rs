//! Files as instruments, programs and people write them, all of them invented, and all of the same lamp.

/// A layout: its name, its bytes, and what the reader has to find in it.
pub struct Layout {
    pub name: &'static str,
    pub bytes: Vec<u8>,
    /// The names of the curves.
    pub names: &'static [Option<&'static str>],
    /// What one of the lamp's numbers is, in the unit of the quantity.
    pub factor: f64,
    /// The unit as it is written, or nothing if nothing is said.
    pub unit: Option<&'static str>,
    /// Words that the notes must have.
    pub notes: &'static [&'static str],
}

/// The first and the last wavelength of the lamp, in nm.
pub const FIRST: u32 = 380;
pub const LAST: u32 = 780;

/// The lamp, which has four digits.
pub fn lamp(nm: u32) -> f64 {
    let hump = |at: f64, width: f64| (-((f64::from(nm) - at) / width).powi(2)).exp();
    ((hump(450.0, 15.0) + 0.7 * hump(590.0, 70.0)) * 1e4).round() / 1e4
}

/// Returns rows of the lamp, each ended by `end`.
fn rows(end: &str, row: impl Fn(u32, f64) -> String) -> String {
    (FIRST..=LAST).map(|nm| row(nm, lamp(nm)) + end).collect()
}

fn comma(value: f64) -> String {
    value.to_string().replace('.', ",")
}

fn plain(end: &str) -> String {
    rows(end, |nm, value| format!("{nm},{value}"))
}

/// Returns the layouts that need no option.
pub fn all() -> Vec<Layout> {
    let one = |name, text: String| Layout {
        name,
        bytes: text.into_bytes(),
        names: &[Some("lamp")],
        factor: 1.0,
        unit: None,
        notes: &[],
    };
    let latin = |text: String| text.chars().map(|c| c as u8).collect::<Vec<u8>>();
    let utf16 = |text: String, mark: &[u8], bytes: fn(u16) -> [u8; 2]| {
        [mark, &text.encode_utf16().flat_map(bytes).collect::<Vec<u8>>()].concat()
    };
    let heading = |text: &str| text.to_owned();
    let bare = |layout: Layout| Layout { names: &[None], ..layout };
    let assumed = |layout: Layout| Layout { names: &[None], notes: &["the axis is in nm"], ..layout };
    vec![
        one("comma", heading("nm,lamp\n") + &plain("\n")),
        one("crlf and bom", heading("\u{feff}nm,lamp\r\n") + &plain("\r\n")),
        one("cr", heading("nm,lamp\r") + &plain("\r")),
        one("zeros at the end", heading("nm,lamp\n") + &plain("\n") + &"\0".repeat(200)),
        one("trailing separators", heading("nm,lamp,,\n") + &plain(",,\n")),
        one("comments of all kinds", heading("# a\n; b\n% c\n! d\nnm,lamp\n# e\n") + &plain("\n")),
        one("footer", heading("nm,lamp\n") + &plain("\n") + ">>>>>End Spectral Data<<<<<\n"),
        one("sep", heading("sep=;\nnm;lamp\n") + &rows("\n", |nm, value| format!("{nm};{value}"))),
        one(
            "bars",
            heading("| nm | lamp |\n|---:|:--|\n") + &rows("\n", |nm, value| format!("| {nm} | {value} |")),
        ),
        one(
            "quotes",
            heading("\"nm\", \"lamp\"\n") + &rows("\n", |nm, value| format!("\"{nm}\", \"{value}\"")),
        ),
        one("comma and tab", heading("nm,\tlamp\n") + &rows("\n", |nm, value| format!("{nm},\t{value}"))),
        one(
            "fixed width",
            heading("  nm        lamp\n") + &rows("\n", |nm, value| format!("{nm:>6}{value:>12.6}")),
        ),
        one(
            "exponents of Fortran",
            heading("nm lamp\n") + &rows("\n", |nm, value| format!("{nm}.D0 {value:.4}D+00")),
        ),
        one(
            "descending",
            heading("nm,lamp\n")
                + &(FIRST..=LAST).rev().map(|nm| format!("{nm},{}\n", lamp(nm))).collect::<String>(),
        ),
        one(
            "decimal comma and semicolon",
            heading("nm;lamp\n") + &rows("\n", |nm, value| format!("{nm};{}", comma(value))),
        ),
        assumed(one("decimal comma and tab", rows("\n", |nm, value| format!("{nm},0\t{}", comma(value))))),
        assumed(one("decimal comma and blanks", rows("\n", |nm, value| format!("{nm} {}", comma(value))))),
        assumed(one("no heading", plain("\n"))),
        one(
            "groups of digits",
            heading("nm;lamp\n")
                + &rows("\n", |nm, value| format!("{nm};{}{value:06.4}", "1,000".replace("1,000", ""))),
        ),
        bare(one(
            "unit behind the wavelength",
            heading("Model,X\nCCT,3000\n") + &rows("\n", |nm, value| format!("{nm}nm\t{value}")),
        )),
        bare(one(
            "words around the wavelength",
            heading("Ev,100\n") + &rows("\n", |nm, value| format!("Spectral Data {nm}[nm],{value}")),
        )),
        Layout {
            factor: 1e-3,
            unit: Some("mW/m2/nm"),
            ..bare(one(
                "unit of the value behind the wavelength",
                rows("\n", |nm, value| format!("{nm}(mW/m2/nm),{value}")),
            ))
        },
        Layout {
            notes: &["counts the rows", "axis is in nm"],
            ..one(
                "row names of R",
                heading("\"wavelength\",\"lamp\"\n")
                    + &rows("\n", |nm, value| format!("\"{}\",{nm},{value}", nm - 379)),
            )
        },
        Layout {
            notes: &["counts the rows", "axis is in nm"],
            ..one(
                "index of pandas",
                heading(",wavelength,lamp\n") + &rows("\n", |nm, value| format!("{},{nm},{value}", nm - 380)),
            )
        },
        Layout {
            notes: &["'Pixel' only counts the rows"],
            ..one(
                "pixels",
                heading("Pixel,Wavelength (nm),lamp\n")
                    + &rows("\n", |nm, value| format!("{},{nm},{value}", nm - 379)),
            )
        },
        Layout {
            names: &[Some("lamp"), Some("other")],
            ..one(
                "an axis for each",
                heading("nm,lamp,nm,other\n") + &rows("\n", |nm, value| format!("{nm},{value},{nm},{value}")),
            )
        },
        Layout {
            notes: &["samples of a spectrum", "axis is in nm"],
            ..assumed(one(
                "two samples in a row",
                (FIRST..LAST)
                    .step_by(2)
                    .map(|nm| format!("{nm} {} {} {}\n", lamp(nm), nm + 1, lamp(nm + 1)))
                    .collect::<String>()
                    + &format!("{LAST} {}\n", lamp(LAST)),
            ))
        },
        Layout {
            names: &[Some("lamp"), Some("other")],
            notes: &["'name' says to which of 2 spectra"],
            ..one(
                "long",
                heading("name,wavelength_nm,value\n")
                    + &rows("\n", |nm, value| format!("lamp,{nm},{value}"))
                    + &rows("\n", |nm, value| format!("other,{nm},{value}")),
            )
        },
        Layout {
            names: &[Some("1"), Some("2")],
            notes: &["axis is in nm"],
            ..one(
                "numbers for names",
                heading("wavelength,1,2\n") + &rows("\n", |nm, value| format!("{nm},{value},{value}")),
            )
        },
        Layout {
            notes: &["is the same everywhere"],
            ..one(
                "a constant before the axis",
                heading("id,nm,lamp\n") + &rows("\n", |nm, value| format!("157,{nm},{value}")),
            )
        },
        Layout {
            names: &[None, None],
            notes: &["the wavelengths begin anew"],
            ..one("twice", {
                let once = rows("\n", |nm, value| format!("Spectral Data {nm}[nm],{value}"));
                "Ev,100\n".to_owned() + &once + &once
            })
        },
        Layout {
            names: &[Some("lamp"), Some("other")],
            notes: &["each row is a spectrum", "axis is in nm"],
            ..one("transposed", {
                let row = |cell: &dyn Fn(u32) -> String| {
                    (FIRST..=LAST).map(cell).collect::<Vec<_>>().join(",") + "\n"
                };
                let values = row(&|nm| lamp(nm).to_string());
                "name,".to_owned() + &row(&|nm| nm.to_string()) + "lamp," + &values + "other," + &values
            })
        },
        Layout {
            names: &[Some("lamp")],
            notes: &["each row is a spectrum"],
            ..one("transposed with words", {
                let row = |cell: &dyn Fn(u32) -> String| {
                    (FIRST..=LAST).map(cell).collect::<Vec<_>>().join("\t") + "\n"
                };
                "sample\t".to_owned()
                    + &row(&|nm| format!("{nm} nm"))
                    + "lamp\t"
                    + &row(&|nm| lamp(nm).to_string())
            })
        },
        Layout {
            bytes: latin(
                heading("Wellenlänge [nm];Bestrahlungsstärke [µW/cm²/nm]\n")
                    + &rows("\n", |nm, value| format!("{nm};{}", comma(value))),
            ),
            names: &[Some("Bestrahlungsstärke [µW/cm²/nm]")],
            factor: 0.01,
            unit: Some("uW/cm2/nm"),
            notes: &["Windows-1252"],
            ..one("latin", String::new())
        },
        Layout {
            bytes: utf16(
                heading("nm\tlamp\r\n") + &rows("\r\n", |nm, value| format!("{nm}\t{value}")),
                &[0xff, 0xfe],
                u16::to_le_bytes,
            ),
            ..one("utf-16", String::new())
        },
        Layout {
            bytes: utf16(
                heading("nm\tlamp\n") + &rows("\n", |nm, value| format!("{nm}\t{value}")),
                &[],
                u16::to_be_bytes,
            ),
            ..one("utf-16 without a mark", String::new())
        },
        Layout {
            names: &[Some("E")],
            factor: 1e-3,
            unit: Some("mW/m2/nm"),
            ..one(
                "preamble and a line of units",
                heading(
                    "Title of it all\nDate: 2024-01-05\nIntegration time [ms]; 48,06\n\nWave;E\n[nm];[mW/m2/nm]\n",
                ) + &rows("\n", |nm, value| format!("{nm};{value}")),
            )
        },
        Layout {
            names: &[Some("R")],
            factor: 0.01,
            unit: Some("percent"),
            ..one(
                "unit among the facts",
                heading(
                    "X Units: Wavelength (micrometers)\nY Units: Reflectance (percent)\nFirst X Value: .38\num,R\n",
                ) + &rows("\n", |nm, value| format!("{},{value}", f64::from(nm) / 1000.0)),
            )
        },
        Layout {
            names: &[Some("E (W/m2/um)")],
            factor: 1e-3,
            unit: Some("mW/m2/nm"),
            ..one(
                "angstroms",
                heading("wavelength_angstrom,E (W/m2/um)\n")
                    + &rows("\n", |nm, value| format!("{},{value}", nm * 10)),
            )
        },
        Layout {
            names: &[Some("Transmittance")],
            factor: 1.0,
            unit: Some("transmittance"),
            ..one(
                "wavenumbers",
                heading("Wavenumber (cm-1),Transmittance\n")
                    + &rows("\n", |nm, value| format!("{},{value}", 1e7 / f64::from(nm))),
            )
        },
    ]
}
