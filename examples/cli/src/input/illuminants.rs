//! The illuminants of the CIE by their names.

use nanospectra::{Fine, Interpolation, Power, light};

/// An illuminant with its name as the CIE writes it, whatever the case of `name`.
pub fn find(name: &str, by: Interpolation) -> Option<(String, Fine<Power>)> {
    let name = name.to_uppercase();
    light::interpolated(&name, by).map(|power| (name, power))
}
