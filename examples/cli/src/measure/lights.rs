//! Lights by name or from a file.

use crate::failure::Failure;
use crate::input::illuminants;
use crate::measure::args::Eye;
use crate::measure::input;
use nanospectra::{Fine, Interpolation, Power};
use std::path::Path;

/// The light under which surfaces are seen.
pub struct Illuminant {
    pub name: String,
    pub power: Fine<Power>,
}

/// A CIE illuminant by its name, or else the one light in a file.
pub fn find(light: &Path, by: Interpolation, eye: Eye) -> Result<Illuminant, Failure> {
    if let Some((name, power)) = illuminants::find(&light.to_string_lossy(), by) {
        return Ok(Illuminant { name, power });
    }
    if light.as_os_str() != "-" && !light.exists() {
        let what =
            format!("neither a CIE illuminant nor a file; use {}, L41 or a file's name", illuminants::NAMES);
        return Err(Failure::of(format_args!("--light {}", light.display()), what));
    }
    let source = input::read_one(light, "--light")?;
    let power = source.light(by)?.power;
    if eye.observer().sees(&power)[1] <= 0.0 {
        return Err(source.invisible(eye));
    }
    Ok(Illuminant { name: source.name, power })
}
