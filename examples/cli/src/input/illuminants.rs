//! Finds the illuminants of the CIE by their names.

use nanospectra::{Fine, Interpolation, Power, light};

/// Returns an illuminant, with its name as the CIE writes it. The case of `name` does not matter.
pub fn find(name: &str, by: Interpolation) -> Option<(String, Fine<Power>)> {
    let name = name.to_uppercase();
    light::interpolated(&name, by).map(|power| (name, power))
}
