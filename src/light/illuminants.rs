//! The CIE illuminants on the grids on which they were published, as constants that the build script makes
//! from the files in `tables/illuminants`. It writes `illuminants.rs` into the build directory, which this
//! file includes.
//!
//! A static takes flash only in a program that reads it. For sums at 1 nm bring a table to the CIE's grid by
//! [`Spectrum::fine`].

#![expect(clippy::approx_constant, reason = "measured numbers that happen to look like 1/pi")]

use crate::grid::Nodes;
use crate::spectrum::{Fine, Interpolation, Power, Spectrum};

/// Makes the lists of names, [`named`] and [`interpolated`] from the list that the build script writes next
/// to the tables.
macro_rules! by_name {
    ($brief:literal; $($name:literal => $table:ident,)*) => {
        /// Lists the names of all illuminants that [`named`] knows, with `"E"` for equal energy first.
        ///
        /// Names that end in `_1NM` are the CIE's second tables of the same lamps, every nanometer.
        ///
        /// ```
        /// # use nanospectra::light;
        /// assert!(light::NAMES.contains(&"FL3.1"));
        /// assert!(light::NAMES.iter().all(|name| light::named(name).is_some()));
        /// ```
        pub const NAMES: &[&str] = &["E", $($name),*];

        /// Lists the names of [`NAMES`] in few words, such as `FL1..FL12`, for the help or a message of a
        /// program.
        ///
        /// The second tables, whose names end in `_1NM`, are left out.
        ///
        /// ```
        /// assert!(nanospectra::light::NAMES_IN_BRIEF.starts_with("E, A, C, D50"));
        /// ```
        pub const NAMES_IN_BRIEF: &str = $brief;

        /// Returns the illuminant of this name on the CIE's 1 nm grid, or `None` if there is none.
        ///
        /// Names are `"D65"`, `"FL3.1"`, `"LED-B3"`, `"FL11_1NM"`, `"E"` for equal energy, and so on;
        /// [`NAMES`] has them all. The light is zero outside its table.
        ///
        /// A program that calls this function contains every table, 80 KB. A program that names a static
        /// contains that one alone.
        ///
        /// ```
        /// # use nanospectra::light;
        /// assert!(light::named("LED-B3").is_some());
        /// assert!(light::named("moonlight").is_none());
        /// ```
        ///
        /// # Cost
        /// On a Cortex-M4F it takes 5,740 bytes of stack at opt-level 3, and 5,840 at "s".
        #[must_use]
        pub fn named(name: &str) -> Option<Fine<Power>> {
            interpolated(name, Interpolation::Linear)
        }

        /// Returns the illuminant of this name as [`named`] does, interpolated between the rows of its table
        /// as `by` says.
        ///
        /// ```
        /// # use nanospectra::{Interpolation, light};
        /// let smooth = light::interpolated("FL11", Interpolation::Sprague);
        /// assert_eq!(smooth, Some(light::FL11.interpolate(Interpolation::Sprague)));
        /// ```
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
