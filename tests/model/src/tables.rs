//! The measured world: lights, samples and observers, read from the CSVs.

use super::csv::{self, table};
use super::interpolation::{Interpolation, Outside, Samples};

/// One column of a table on a regular grid.
pub fn samples(file: &str, column: &str) -> Samples {
    let table = table(file);
    let nm = table.column("wavelength_nm");
    let step = nm[1] - nm[0];
    for pair in nm.windows(2) {
        assert_eq!(pair[1] - pair[0], step, "{file}: the step changes at {} nm", pair[0]);
    }
    Samples::new(nm[0], step, table.column(column))
}

/// A light source by the id the goldens use: `A`, `FL11`, `LED-B3@1nm`, `NIST_05`; `E` is flat.
pub fn source(id: &str) -> Samples {
    if id == "E" {
        return Samples::new(300.0, 1.0, vec![1.0; 531]);
    }
    let index = csv::table("spectra/sources_index.csv").find("id", id);
    let light = samples(index.text("file"), index.text("column"));
    assert_eq!(light.first, index.number("start_nm"), "{id}: first wavelength");
    assert_eq!(light.last(), index.number("end_nm"), "{id}: last wavelength");
    assert_eq!(light.step, index.number("step_nm"), "{id}: step");
    light
}

/// A reflectance sample as golden 04 names it: `TCS:TCS01`, `TCS15:TCS15`, `CES:CES42`, `VS:VS3`.
pub fn reflectance(name: &str) -> Samples {
    let (family, column) = name.split_once(':').unwrap_or_else(|| panic!("{name}: no family before a colon"));
    let file = match family {
        "TCS" => "samples/cri_tcs14_5nm.csv",
        "TCS15" => "samples/cri_tcs15_5nm.csv",
        "CES" => "samples/cie224_ces99_1nm.csv",
        "VS" => "samples/cqs_vs15_cie_5nm.csv",
        _ => panic!("{name}: unknown family of samples"),
    };
    samples(file, column)
}

/// The 15 test color samples of CIE 13.3, as published every 5 nm (TCS15 only 380 to 780 nm).
pub fn test_color_samples() -> Vec<Samples> {
    let mut all: Vec<Samples> =
        (1..=14).map(|k| samples("samples/cri_tcs14_5nm.csv", &format!("TCS{k:02}"))).collect();
    all.push(samples("samples/cri_tcs15_5nm.csv", "TCS15"));
    all
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Observer {
    Cie1931,
    Cie1964,
    Cie2015Deg2,
    Cie2015Deg10,
}

impl Observer {
    /// By the name the goldens use.
    pub fn named(name: &str) -> Observer {
        match name {
            "1931_2" => Observer::Cie1931,
            "1964_10" => Observer::Cie1964,
            "2015_2" => Observer::Cie2015Deg2,
            "2015_10" => Observer::Cie2015Deg10,
            _ => panic!("no observer called {name}"),
        }
    }

    /// The color-matching functions as published, on their own range.
    pub fn published(self) -> [Samples; 3] {
        let (file, columns) = match self {
            Observer::Cie1931 => ("cmf/cie_1931_2deg_xyz_1nm.csv", ["x_bar", "y_bar", "z_bar"]),
            Observer::Cie1964 => ("cmf/cie_1964_10deg_xyz_1nm.csv", ["x10_bar", "y10_bar", "z10_bar"]),
            Observer::Cie2015Deg2 => ("cmf/cie_2015_2deg_xyz_1nm.csv", ["xF_bar", "yF_bar", "zF_bar"]),
            Observer::Cie2015Deg10 => {
                ("cmf/cie_2015_10deg_xyz_1nm.csv", ["xF10_bar", "yF10_bar", "zF10_bar"])
            }
        };
        columns.map(|column| samples(file, column))
    }

    /// The color-matching functions at 360, 361, ..., 830 nm, zero where CIE tabulates nothing.
    pub fn on_cie_grid(self) -> [Vec<f64>; 3] {
        self.published().map(|row| row.on_cie_grid(Interpolation::Linear, Outside::Zero))
    }
}

/// A one-row function at 360, 361, ..., 830 nm, zero where CIE tabulates nothing.
pub fn function(file: &str, column: &str) -> Vec<f64> {
    samples(file, column).on_cie_grid(Interpolation::Linear, Outside::Zero)
}

/// The cie alpha-opic functions, in the order of CIE S 026.
pub const ALPHA_OPIC: [&str; 5] = ["s_sc", "s_mc", "s_lc", "s_rh", "s_mel"];

pub fn alpha_opic(column: &str) -> Vec<f64> {
    function("cmf/alpha_opic_s026_1nm.csv", column)
}
