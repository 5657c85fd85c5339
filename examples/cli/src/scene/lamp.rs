//! The lamp of a scene.

use crate::failure::{Failure, short};
use crate::input::{illuminants, table, text};
use crate::output::number;
use crate::scene::file::{self, Recipe};
use nanospectra::radiometry::illuminance;
use nanospectra::{Fine, Interpolation, Power, light};

/// A lamp: its name, its power on the 1 nm grid of the CIE, and the illuminance that it shall give.
pub struct Lamp {
    pub name: String,
    pub power: Fine<Power>,
    pub illuminance_lx: Option<f32>,
}

/// Finds the lamp of a scene.
pub fn of(recipe: &Recipe) -> Result<Lamp, Failure> {
    let at = &recipe.scene.lamp;
    let lamp = at.get_ref();
    let wrong = |what: String| recipe.wrong(at, what);
    let (name, power) = match (&lamp.cie, lamp.blackbody_k, &lamp.csv, &lamp.points) {
        (Some(name), None, None, None) => {
            let what =
                || format!("'{}' is not a CIE illuminant; use one of {}", short(name), light::NAMES_IN_BRIEF);
            illuminants::find(name, Interpolation::Linear).ok_or_else(|| wrong(what()))?
        }
        (None, Some(kelvin), None, None) => {
            if !(500.0..=1e6).contains(&kelvin) {
                let what = format!("blackbody_k = {kelvin} is out of range; give 500 to 1000000 K");
                return Err(wrong(what));
            }
            (
                format!("black body of {kelvin} K"),
                Fine::at_centers(|nm| light::blackbody_relative(nm, kelvin)),
            )
        }
        (None, None, Some(path), None) => {
            let samples = table::samples(&recipe.beside(path))?;
            (
                text::stem(path).unwrap_or_default(),
                fine(&samples).map_err(|what| Failure::of(path.display(), what))?,
            )
        }
        (None, None, None, Some(points)) => ("points".into(), fine(&file::pairs(points)).map_err(wrong)?),
        _ => {
            return Err(wrong(
                "a lamp is given in exactly one way; give one of cie, blackbody_k, csv, points".into(),
            ));
        }
    };
    let lux = illuminance(&power);
    if lux.is_nan() || lux <= 0.0 {
        return Err(wrong("nothing is visible of this lamp; give it power in 360..830 nm".into()));
    }
    // (A lamp may have any unit, since everything is compared with the lamp itself.)
    if !(1e-20..=1e20).contains(&lux) {
        return Err(wrong(format!(
            "the numbers of the lamp are out of range, since they make {} lx; give them in another unit",
            number::significant(lux, 3)
        )));
    }
    if let Some(asked) = lamp.illuminance_lx
        && !(1e-6..=1e9).contains(&asked)
    {
        return Err(wrong(format!(
            "illuminance_lx = {asked} is out of range; give 0.000001 to 1000000000 lux"
        )));
    }
    Ok(Lamp { name, power, illuminance_lx: lamp.illuminance_lx })
}

fn fine(samples: &[(f32, f32)]) -> Result<Fine<Power>, String> {
    if let Some((nm, value)) = samples.iter().find(|(_, value)| *value < 0.0) {
        return Err(format!("{value} at {nm} nm is not a power; give 0 or more"));
    }
    Fine::interpolated(samples, Interpolation::Linear)
        .map_err(|error| format!("{error}; give increasing wavelengths in nm"))
}
