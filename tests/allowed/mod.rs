//! The one table of what the crate may be off by, against f64 references.
//!
//! Each entry is used by one test, which fails when an error is larger than allowed, and also when the
//! largest error is less than half of what is allowed: then the entry claims too little.

use crate::model::check::Check;

/// (what, absolute, relative): |got - expected| <= absolute + relative * |expected|.
const ALLOWED: &[(&str, f64, f64)] = &[
    ("XYZ of lights, linear to 1 nm", 0.0, 3.7e-7),
    ("XYZ of lights, Sprague to 1 nm, zero outside", 0.0, 4e-7),
    ("XYZ of lights, Sprague to 1 nm, held outside", 0.0, 4e-7),
    ("xy of lights", 1.2e-7, 0.0),
    ("interpolation, linear", 0.0, 1.2e-7),
    ("interpolation, Sprague", 2.4e-8, 1.2e-7),
    ("CCT of the grid, mired", 1.8e-2, 0.0),
    ("Duv of the grid", 2.5e-7, 0.0),
    ("CCT of lights, mired", 1.5e-3, 0.0),
    ("Duv of lights", 2.5e-7, 0.0),
    ("CCT hotter than the grid, mired", 2.0e-3, 0.0),
    ("Duv hotter than the grid", 2.3e-8, 0.0),
    ("Ra", 3.4e-4, 0.0),
    ("R1 to R15", 1.6e-3, 0.0),
    ("Rf", 1.3e-4, 0.0),
    ("Rg", 1.3e-4, 0.0),
    ("Rf of samples", 1.9e-3, 0.0),
    ("Rf of hue bins", 5.9e-4, 0.0),
    ("chroma shift", 4.7e-6, 0.0),
    ("hue shift", 5.9e-6, 0.0),
    ("daylight chromaticity", 1.1e-7, 0.0),
    ("daylight spectrum", 0.0, 2.0e-6),
    ("luminous efficacy", 0.0, 4.3e-7),
    ("scotopic over photopic", 0.0, 3.4e-7),
    ("alpha-opic ratios", 0.0, 4.2e-7),
    ("photons of 400 to 700 nm", 0.0, 2.4e-7),
    ("dominant wavelength, nm", 2.4e-3, 0.0),
    ("excitation purity", 3.9e-7, 0.0),
    ("surfaces under lights", 0.0, 3.2e-7),
    ("black body exitance", 0.0, 1.1e-7),
    ("black body peak", 0.0, 5.3e-8),
    ("sums of the 1 nm functions", 0.0, 6.5e-9),
    ("peaks of the 1 nm functions", 0.0, 6e-8),
    ("sums of the cones, brought to 1 nm", 0.0, 1.9e-5),
    ("xy of lamps against CIE 15, 5 nm sums", 5.3e-5, 0.0),
    ("xy of illuminants against CIE 15, 5 nm sums", 5.1e-6, 0.0),
    ("xy of illuminants, 1 nm sums", 1.5e-5, 0.0),
    ("CCT of lamps against CIE 15", 6.0, 0.0),
    ("Ra of lamps against CIE 15", 0.54, 0.0),
    ("xy of 1 nm lamps against their 5 nm tables", 2.3e-4, 0.0),
    ("xy of equal energy", 4.6e-5, 0.0),
    ("cones to XYZ, 2 degrees", 1.8e-3, 0.0),
    ("cones to XYZ, 10 degrees", 2.0e-3, 0.0),
    ("alpha-opic cones against the 10 degree cones", 9.2e-4, 0.0),
    ("rhodopsin's function against V'", 5.1e-4, 0.0),
];

/// A check with the allowance of this name.
pub fn check(what: &'static str) -> Check {
    let (_, absolute, relative) = ALLOWED
        .iter()
        .find(|entry| entry.0 == what)
        .unwrap_or_else(|| panic!("no entry '{what}' in tests/allowed"));
    Check::new(what, *absolute, *relative)
}
