//! The lamps, classed by the kind of their spectra, since errors depend on the kind.

use model::planck::{C2_CIE, relative};
use model::tables::source;

/// A lamp as points (nm, power), which are joined by straight lines. Its power is zero outside them.
pub struct Lamp {
    pub name: String,
    pub class: Class,
    pub points: Vec<(f64, f64)>,
}

/// The kind of a lamp's spectrum.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Class {
    /// The spectra of incandescent lamps, daylight and black bodies, which have no peaks.
    Smooth,
    /// The spectra of fluorescent lamps with broad phosphors, under the lines of mercury.
    Halophosphate,
    /// The spectra of fluorescent lamps with three or five narrow phosphors.
    Triphosphor,
    Led,
    /// The spectra of discharges in sodium, mercury and metal halides.
    Hid,
    /// Spectral lines of their true width, which a table with steps of 5 nm does not show.
    Lines,
}

pub const CLASSES: [Class; 6] =
    [Class::Smooth, Class::Halophosphate, Class::Triphosphor, Class::Led, Class::Hid, Class::Lines];

impl Class {
    /// Returns the name that the tables and the command line use.
    pub fn name(self) -> &'static str {
        match self {
            Class::Smooth => "smooth",
            Class::Halophosphate => "halophosphate",
            Class::Triphosphor => "triphosphor",
            Class::Led => "led",
            Class::Hid => "hid",
            Class::Lines => "lines",
        }
    }
}

/// How many lamps each class has, which the guide to bands says.
const COUNTS: [usize; 6] = [10, 15, 12, 23, 10, 6];

/// The tabulated lamps of each class, by their names in `tests/data/spectra/sources_index.csv`.
const TABLES: [(Class, &str); 5] = [
    (Class::Smooth, "A C D50 D65 D75"),
    (Class::Halophosphate, "FL1 FL2 FL3 FL4 FL5 FL6 FL7 FL8 FL9 FL3.1 FL3.2 FL3.3 FL3.4 FL3.5 FL3.6"),
    (Class::Triphosphor, "FL10 FL11 FL12 FL3.7 FL3.8 FL3.9 FL3.10 FL3.11 FL3.12 FL3.13 FL3.14 FL3.15"),
    (
        Class::Led,
        "LED-B1 LED-B2 LED-B3 LED-B4 LED-B5 LED-BH1 LED-RGB1 LED-V1 LED-V2 NIST_11 NIST_12 NIST_14 \
        NIST_15 NIST_16 NIST_17 NIST_18 NIST_19 NIST_20 NIST_21 NIST_22 NIST_23 NIST_24 NIST_25",
    ),
    (Class::Hid, "HP1 HP2 HP3 HP4 HP5 NIST_03 NIST_05 NIST_06 NIST_07 NIST_09"),
];

/// The temperatures of the black bodies, in K.
const BLACK_BODIES: [f64; 5] = [2000.0, 2700.0, 4000.0, 6500.0, 10_000.0];

/// Spectral lines as (nm, relative power): a mercury lamp, the sodium doublet, three sets of lasers as they
/// are sold, and the phosphors of europium and terbium beside mercury. The powers are typical and not
/// measured.
const LINES: [(&str, &[(f64, f64)]); 6] = [
    ("mercury lamp", &MERCURY),
    ("sodium doublet", &[(588.995, 2.0), (589.592, 1.0)]),
    ("lasers 450 520 638", &[(450.0, 1.0), (520.0, 1.0), (638.0, 1.2)]),
    ("lasers 465 532 630", &[(465.0, 0.8), (532.0, 0.9), (630.0, 1.0)]),
    ("lasers 445 488 561 640", &[(445.0, 0.9), (488.0, 0.6), (561.0, 1.0), (640.0, 1.2)]),
    ("triphosphor by lines", &TRIPHOSPHOR),
];

const MERCURY: [(f64, f64); 6] =
    [(404.66, 0.41), (435.83, 0.74), (546.07, 1.0), (576.96, 0.28), (579.07, 0.29), (690.75, 0.01)];

#[rustfmt::skip]
const TRIPHOSPHOR: [(f64, f64); 18] = [
    (404.66, 0.05), (435.83, 0.25), (487.7, 0.20), (490.5, 0.15), (541.6, 0.55), (545.2, 1.0), (546.07, 0.45),
    (576.96, 0.06), (579.07, 0.06), (584.4, 0.18), (587.3, 0.22), (593.1, 0.15), (599.2, 0.12), (611.2, 1.1),
    (620.5, 0.08), (630.4, 0.15), (650.4, 0.06), (708.0, 0.12),
];

/// The full width of a line at half its height, in nm.
const LINE_WIDTH_NM: f64 = 0.5;

/// Returns all lamps, class by class.
pub fn all() -> Vec<Lamp> {
    let tables = TABLES.iter().flat_map(|&(class, ids)| {
        ids.split(' ').map(move |id| Lamp { name: id.to_owned(), class, points: source(id).points() })
    });
    let bodies = BLACK_BODIES.iter().map(|&kelvin| Lamp {
        name: format!("black body {kelvin} K"),
        class: Class::Smooth,
        points: (300..=830).map(f64::from).map(|nm| (nm, relative(nm, kelvin, C2_CIE))).collect(),
    });
    let lines = LINES.iter().map(|&(name, lines)| Lamp {
        name: name.to_owned(),
        class: Class::Lines,
        points: (0..=4700).map(|k| 360.0 + f64::from(k) / 10.0).map(|nm| (nm, of_lines(lines, nm))).collect(),
    });
    let lamps: Vec<Lamp> = tables.chain(bodies).chain(lines).collect();
    assert_eq!(CLASSES.map(|class| lamps.iter().filter(|lamp| lamp.class == class).count()), COUNTS);
    lamps
}

/// Returns the power of some lines at a wavelength. Each line is a Gaussian.
fn of_lines(lines: &[(f64, f64)], nm: f64) -> f64 {
    let height = |(at, power): &(f64, f64)| {
        let from = (nm - at) / LINE_WIDTH_NM;
        power / LINE_WIDTH_NM * (-4.0 * std::f64::consts::LN_2 * from * from).exp()
    };
    lines.iter().map(height).sum()
}
