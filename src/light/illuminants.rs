//! CIE illuminants on the grid they were published on; constants made from `tables/illuminants`.
//!
//! A static costs flash only in a program that reads it. For 1 nm sums bring a table to the CIE
//! grid with [`Spectrum::fine`].

#![expect(clippy::approx_constant, reason = "measured numbers that happen to look like 1/pi")]

use crate::grid::Nodes;
use crate::spectrum::{Fine, Interpolation, Power, Spectrum};

/// Makes the lists of names, [`named`] and [`interpolated`] from the list that the build script writes beside
/// the tables.
macro_rules! by_name {
    ($brief:literal; $($name:literal => $table:ident,)*) => {
        /// The names of all illuminants that [`named`] knows, `"E"` for equal energy first. Those that end in
        /// `_1NM` are the CIE's second tables of the same lamps, every nanometer.
        ///
        /// ```
        /// # use nanospectra::light;
        /// assert!(light::NAMES.contains(&"FL3.1"));
        /// assert!(light::NAMES.iter().all(|name| light::named(name).is_some()));
        /// ```
        pub const NAMES: &[&str] = &["E", $($name),*];

        /// [`NAMES`] for a message, as `FL1..FL12`; without the second tables.
        ///
        /// ```
        /// assert!(nanospectra::light::NAMES_IN_BRIEF.starts_with("E, A, C, D50"));
        /// ```
        pub const NAMES_IN_BRIEF: &str = $brief;

        /// The illuminant of this name on the CIE's 1 nm grid, zero outside its table: `"D65"`, `"FL3.1"`,
        /// `"LED-B3"`, `"FL11_1NM"`, and `"E"` for equal energy. [`NAMES`] has them all.
        ///
        /// A program that calls this contains every table, 80 KB; one that names a static has that one.
        ///
        /// ```
        /// # use nanospectra::light;
        /// assert!(light::named("LED-B3").is_some());
        /// assert!(light::named("moonlight").is_none());
        /// ```
        #[must_use]
        pub fn named(name: &str) -> Option<Fine<Power>> {
            interpolated(name, Interpolation::Linear)
        }

        /// As [`named`], read between the rows of its table as `by` says.
        #[must_use]
        pub fn interpolated(name: &str, by: Interpolation) -> Option<Fine<Power>> {
            match name {
                "E" => Some(Spectrum::flat(1.0)),
                $($name => Some($table.interpolate(by)),)*
                _ => None,
            }
        }
    };
}

include!(concat!(env!("OUT_DIR"), "/illuminants.rs"));
