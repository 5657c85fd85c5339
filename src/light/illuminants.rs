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
        for line in text.lines().filter(|line| line.contains(" with a CCT of ")) {
            let (name, rest) = line.trim_start_matches("/// CIE ").split_once(" is ").expect(line);
            let fine = named(&format!("{name}_1NM")).filter(|_| rest.ends_with(" steps of 1 nm."));
            let xyz = Xyz::from(CIE_1931.sees(&fine.or_else(|| named(name)).expect(line)));
            let (Some(xy), Some(Cct::Near { cct_k, .. })) = (xyz.xy(), xyz.cct()) else { panic!("{line}") };
            let found = format!(" with a CCT of {cct_k:.0} K (x = {:.4}, y = {:.4}), here in", xy.x, xy.y);
            assert!(line.contains(&found), "{line} {found}");
            lights += 1;
        }
        // Equal energy has no table.
        assert_eq!(lights, NAMES.len() - 1);
    }
}
