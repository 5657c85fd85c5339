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

#[cfg(test)]
#[cfg(feature = "libm")]
mod tests {
    extern crate std;

    use crate::color::{Cct, Xyz};
    use crate::light::{NAMES, named};
    use crate::observer::CIE_1931;
    use std::format;

    #[test]
    fn the_documentation_of_a_light_says_its_color() {
        let text = include_str!(concat!(env!("OUT_DIR"), "/illuminants.rs"));
        let mut lights = 0;
        for line in text.lines().filter(|line| line.contains(" K, x = ")) {
            let (name, rest) = line.trim_start_matches("/// CIE ").split_once(" every ").expect(line);
            let fine = named(&format!("{name}_1NM")).filter(|_| rest.starts_with("1 nm"));
            let xyz = Xyz::from(CIE_1931.sees(&fine.or_else(|| named(name)).expect(line)));
            let (Some(xy), Some(Cct::Near { cct_k, .. })) = (xyz.xy(), xyz.cct()) else { panic!("{line}") };
            let found = format!("; {cct_k:.0} K, x = {:.4}, y = {:.4}.", xy.x, xy.y);
            assert!(line.ends_with(&found), "{line} {found}");
            lights += 1;
        }
        // Equal energy has no table.
        assert_eq!(lights, NAMES.len() - 1);
    }
}
