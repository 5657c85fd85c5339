//! Rows 46 to 48: the phase of thick films, the reflectance of the thinnest, and fringes finer than a bin.

use super::Cases;
use super::textbook::cos;
use core::f32::consts::PI;
use nanospectra::light::D65;
use nanospectra::math::cos_turns;
use nanospectra::matter::{PowerShares, ThinFilm};
use nanospectra::observer::CIE_1931;
use nanospectra::{Curve, Observer, Reflectance};

pub fn rows(cases: &mut impl Cases) {
    cases.row("46", &PHASES, naive_phase, phase);
    cases.row("47", &THINNEST, naive_airy, airy);
    cases.row("48", &[[1e6], [1.0003e6]], points, averaged);
}

/// Index, thickness and wavelength in nm of films in which the path of light is 10 um, 1 mm and 10 cm.
const PHASES: [[f32; 3]; 9] = [
    [1.0, 1e4, 555.1],
    [1.33, 7518.797, 420.7],
    [2.4, 4166.667, 701.3],
    [1.0, 1e6, 555.1],
    [1.33, 751_879.7, 420.7],
    [2.4, 416_666.7, 701.3],
    [1.0, 1e8, 555.1],
    [1.33, 75_187_970.0, 420.7],
    [2.4, 41_666_668.0, 701.3],
];

fn naive_phase(&[n, d, nm]: &[f32; 3]) -> [f32; 1] {
    [cos(4.0 * PI * n * d / nm)]
}

fn phase(&[n, d, nm]: &[f32; 3]) -> [f32; 1] {
    [cos_turns(ThinFilm::new([1.0, n, 1.0], d).phase_turns(nm, 1.0))]
}

/// Pairs of thickness and wavelength in nm for films of soap.
const THINNEST: [[f32; 2]; 7] = [
    [0.534_689_7, 646.5087],
    [1e-3, 550.0],
    [1e-3, 380.3],
    [0.1, 550.0],
    [0.1, 719.7],
    [1.0, 550.0],
    [100.0, 550.0],
];

const SOAP: [f32; 3] = [1.0, 1.33, 1.0];

fn naive_airy(&[d, nm]: &[f32; 2]) -> [f32; 1] {
    let r = (1.0 - SOAP[1]) / (1.0 + SOAP[1]);
    let (r2, cos) = (r * r, cos(4.0 * PI * SOAP[1] * d / nm));
    [2.0 * r2 * (1.0 - cos) / (1.0 + r2 * r2 - 2.0 * r2 * cos)]
}

fn airy(&[d, nm]: &[f32; 2]) -> [f32; 1] {
    let [s, _] = ThinFilm::new(SOAP, d).at(nm, 1.0);
    [s.reflected]
}

static EYE: Observer<3, 31> = CIE_1931.under(&D65.fine()).fold(Curve::Spline).with_white_y(100.0);

/// Returns XYZ of the film from its reflectance at the centers of 31 bins.
fn points(&[d]: &[f32; 1]) -> [f32; 3] {
    let film = ThinFilm::new(SOAP, d);
    EYE.sees(&Reflectance::<31>::at_centers(|nm| PowerShares::mean(film.at(nm, 1.0)).reflected))
}

/// Returns XYZ of the film from its mean reflectance over each of 31 bins.
fn averaged(&[d]: &[f32; 1]) -> [f32; 3] {
    let film: Reflectance<31> = ThinFilm::new(SOAP, d).reflectance(1.0);
    EYE.sees(&film)
}
