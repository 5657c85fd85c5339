//! The illuminants of the CIE by their names.

use nanospectra::{Fine, Interpolation, Power, light};

/// Their names, for messages; L41 is one too.
pub const NAMES: &str = "E, A, C, D50, D55, D65, D75, ID50, ID65, FL1..FL12, FL3.1..FL3.15, HP1..HP5, LED-B1..LED-B5, \
                         LED-BH1, LED-RGB1, LED-V1, LED-V2";

/// An illuminant with its name as the CIE writes it, whatever the case of `name`.
pub fn find(name: &str, by: Interpolation) -> Option<(String, Fine<Power>)> {
    let name = name.to_uppercase();
    light::interpolated(&name, by).map(|power| (name, power))
}
