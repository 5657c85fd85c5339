//! This example computes the color of a fluorescent vest in daylight, and in the headlamps of a car, as its
//! driver sees it through tinted glass. A fluorescent surface is a part of the light's path like any other.
//! The example is for everyone who assesses safety clothing, signs or papers with optical brighteners.
//!
//! `cargo run --release --example vest_behind_glass`

use nanospectra::color::Xyz;
use nanospectra::light::{D65, LED_B3};
use nanospectra::matter::{Dye, FluorescenceError};
use nanospectra::observer::CIE_1931;
use nanospectra::{Curve, Light, Observer, Power, Reflectance};

/// The eye on 31 bands over 380..730 nm, which is the default range.
static EYE: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);

/// A smooth step that rises from 0 to 1 around `at_nm`.
fn rise(nm: f32, at_nm: f32, width_nm: f32) -> f32 {
    1.0 / (1.0 + ((at_nm - nm) / width_nm).exp())
}

/// A fluorescent yellow fabric. Its numbers are invented, after the shape that spectra of such fabrics have.
fn vest(quantum_yield: f32) -> Result<Dye<31>, FluorescenceError> {
    let reflects = Reflectance::averaged(|nm| 0.06 + 0.74 * rise(nm, 508.0, 8.0));
    let absorbs = Reflectance::averaged(|nm| 0.9 * rise(-nm, -487.0, 7.0) * rise(nm, 395.0, 5.0));
    let emits = Light::averaged(|nm| {
        if nm > 470.0 { (-0.5 * (((nm - 470.0) / 45.0).ln() / 0.45).powi(2)).exp() } else { 0.0 }
    });
    Dye::new(&reflects, &absorbs, &emits, quantum_yield)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (glowing, faded) = (vest(0.85)?, vest(0.0)?);
    let daylight: Light<31> = D65.resample();
    let headlamp: Light<31> = LED_B3.resample();
    let windscreen = Reflectance::averaged(|nm| 0.75 - 0.1 * rise(nm, 600.0, 40.0)); // transmittance

    // The luminance factor compares the vest with a perfect white in the same place. With fluorescence it may
    // be above 1.
    let [_, white, _] = EYE.sees(&daylight);
    let in_daylight = Xyz::from(EYE.sees(daylight.onto(&glowing))).scaled(1.0 / white);
    let without_dye = Xyz::from(EYE.sees(daylight.onto(&faded))).scaled(1.0 / white);
    let xy = in_daylight.xy().ok_or("dark")?;
    println!("in daylight: luminance factor {:.2}, x {:.3}, y {:.3}", in_daylight.y, xy.x, xy.y);
    println!("without its glow: luminance factor {:.2}", without_dye.y);

    let [_, white, _] = EYE.sees(headlamp.through(&windscreen));
    let from_the_car = Xyz::from(EYE.sees(headlamp.onto(&glowing).through(&windscreen))).scaled(1.0 / white);
    println!("in LED headlamps, through the windscreen: luminance factor {:.2}", from_the_car.y);

    // EN ISO 20471 requires that fluorescent yellow has a luminance factor above 0.70 and a chromaticity
    // within these corners, both under D65.
    let corners = [[0.387, 0.610], [0.356, 0.494], [0.398, 0.452], [0.460, 0.540]];
    let inside = (0..4).all(|k| {
        let ([x0, y0], [x1, y1]) = (corners[k], corners[(k + 1) % 4]);
        (x1 - x0) * (xy.y - y0) - (y1 - y0) * (xy.x - x0) > 0.0
    });
    assert!(in_daylight.y > 0.70 && inside);
    Ok(())
}
