//! Lights by name or from a file.

use crate::args::Eye;
use crate::failure::Failure;
use crate::input;
use nanospectra::{Fine, Interpolation, Power, light as cie};
use std::path::Path;

/// The light under which surfaces are seen.
pub struct Illuminant {
    pub name: String,
    pub power: Fine<Power>,
}

/// A CIE illuminant by its name, or else the one light in a file.
pub fn find(light: &Path, by: Interpolation, eye: Eye) -> Result<Illuminant, Failure> {
    let name = light.to_string_lossy().to_uppercase();
    if let Some(power) = cie::named(&name, by) {
        return Ok(Illuminant { name, power });
    }
    if light.as_os_str() != "-" && !light.exists() {
        return Err(Failure::of(
            format_args!("--light {}", light.display()),
            "neither a CIE illuminant nor a file; use E, A, C, D50, D55, D65, D75, ID50, ID65, FL1..FL12, \
             FL3.1..FL3.15, HP1..HP5, LED-B1..LED-B5, LED-BH1, LED-RGB1, LED-V1, LED-V2, L41 or a file's name",
        ));
    }
    let source = input::read_one(light, "--light")?;
    let power = source.light(by)?.power;
    if eye.observer().sees(&power)[1] <= 0.0 {
        return Err(source.invisible(eye));
    }
    Ok(Illuminant { name: source.name, power })
}
