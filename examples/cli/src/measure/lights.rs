//! Finds lights by name or in a file.

use crate::failure::Failure;
use crate::input::illuminants;
use crate::measure::args::{Args, Between};
use crate::measure::input;
use crate::measure::level::Kind;
use nanospectra::observer::NamedObserver;
use nanospectra::{Fine, Interpolation, Power, light::NAMES_IN_BRIEF};
use nanospectra_files::Options;
use std::path::Path;

/// A light under which surfaces are seen.
pub struct Illuminant {
    pub name: String,
    pub power: Fine<Power>,
}

/// Returns the CIE illuminant of this name, or else the only light in the file of this name.
pub fn find(light: &Path, args: &Args, eye: &NamedObserver) -> Result<Illuminant, Failure> {
    let by = args.interpolation;
    // As the other commands read the tables of the CIE.
    let rule = if by == Between::Sprague { Interpolation::Sprague } else { Interpolation::Linear };
    if let Some((name, power)) = illuminants::find(&light.to_string_lossy(), rule) {
        return Ok(Illuminant { name, power });
    }
    if light.as_os_str() != "-" && !light.exists() {
        let what =
            format!("this is neither a CIE illuminant nor a file; use {NAMES_IN_BRIEF} or a file's name");
        return Err(Failure::of(format_args!("--light {}", light.display()), what));
    }
    let source = input::read_one(light, "--light", args, &Options::default())?;
    if source.kind == Kind::Surface {
        return Err(source.wrong("this is a reflectance, where --light takes a light; name another file"));
    }
    let power = source.light(by)?.power;
    if eye.functions.sees(&power)[1] <= 0.0 {
        return Err(source.invisible(eye));
    }
    Ok(Illuminant { name: source.name, power })
}
