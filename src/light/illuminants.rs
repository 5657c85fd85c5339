//! CIE illuminants on the grid they were published on; constants made from `tables/illuminants`.
//!
//! A static costs flash only in a program that reads it. For 1 nm sums bring a table to the CIE
//! grid with [`Spectrum::interpolate`].

#![expect(clippy::approx_constant, reason = "measured numbers that happen to look like 1/pi")]

use crate::grid::Nodes;
use crate::spectrum::{Fine, Interpolation, Outside, Power, Spectrum};

/// Makes [`named`] from the list that the build script writes beside the tables.
macro_rules! by_name {
    ($($name:literal => $table:ident,)*) => {
        /// The illuminant of this name on the CIE's 1 nm grid, zero outside its table: `"D65"`, `"FL3.1"`,
        /// `"LED-B3"`, `"FL11_1NM"`, and `"E"` for equal energy.
        ///
        /// A program that calls this contains every table, 80 KB; one that names a static has that one.
        ///
        /// ```
        /// # use nanospectra::{Interpolation, light};
        /// assert!(light::named("LED-B3", Interpolation::Linear).is_some());
        /// assert!(light::named("moonlight", Interpolation::Linear).is_none());
        /// ```
        #[must_use]
        pub fn named(name: &str, by: Interpolation) -> Option<Fine<Power>> {
            match name {
                "E" => Some(Spectrum::flat(1.0)),
                $($name => Some($table.interpolate(by, Outside::Zero)),)*
                _ => None,
            }
        }
    };
}

include!(concat!(env!("OUT_DIR"), "/illuminants.rs"));
