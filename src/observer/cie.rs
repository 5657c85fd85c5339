//! The standard observers of the CIE, as constants that the build script makes from the files in
//! `tables/cmf`. It writes `observers.rs` into the build directory, which this file includes.

use crate::grid::{Bands, Grid, Nodes};
use crate::math::const_for;
use crate::observer::{Curve, FineObserver, Observer};
use crate::spectrum::{Interpolation, Power, Spectrum};

/// The maximum luminous efficacy Km (at 555 nm), in lm/W, which converts a sum of power times V(lambda) to
/// lumens.
///
/// SI defines 683 lm/W at 540 THz, which is 555.017 nm in air. V(lambda) is scaled to 1 at 555 nm, where
/// CIE 18:2019 therefore gives 683.002 lm/W.
///
/// # Example
/// ```
/// use nanospectra::observer::{CIE_1931, KM};
/// use nanospectra::{Fine, FineObserver, Power};
///
/// // With this factor Y is in lm for a spectrum in W/nm.
/// static LUMENS: FineObserver<3> = CIE_1931.scaled(KM as f64);
/// let mut laser = Fine::<Power>::flat(0.0);
/// assert_eq!(laser.add_line(555.0, 1.0), 0.0); // 1 W, nothing outside the grid
/// let [_, lumens, _] = LUMENS.sees(&laser);
/// assert!((lumens - 683.0).abs() < 0.01);
/// ```
pub const KM: f32 = 683.002;

/// The maximum luminous efficacy for scotopic vision, in lm/W, which converts a sum of power times V'(lambda)
/// to scotopic lumens.
///
/// It is 683 lm/W divided by V' at 540 THz, rounded to 1700. See the [example](KM#example) of `KM`.
///
/// # Reference
/// CIE 18:2019.
pub const KM_SCOTOPIC: f32 = 1700.0;

/// A standard observer together with the name by which users choose it. See the [example](named).
#[derive(Clone, Copy, Debug)]
pub struct NamedObserver {
    /// The name that users type, such as `"1931"` or `"2015-10"`.
    pub name: &'static str,
    /// The title that reports show, such as `"CIE 1931, 2°"`.
    pub title: &'static str,
    /// The color-matching functions, which see X, Y and Z.
    pub functions: &'static FineObserver<3>,
}

/// Makes [`ALL`] from the list that the build script writes next to the tables.
macro_rules! by_name {
    ($($name:literal $title:literal $functions:ident,)*) => {
        /// Lists all standard observers that users can choose by name, that of 1931 first.
        ///
        /// A program that reads this static contains the tables of all of them, 23 KB.
        ///
        /// ```
        /// use nanospectra::observer;
        ///
        /// let titles = observer::ALL.each_ref().map(|observer| observer.title);
        /// assert_eq!(titles, ["CIE 1931, 2°", "CIE 1964, 10°", "CIE 2015, 2°", "CIE 2015, 10°"]);
        /// ```
        pub static ALL: [NamedObserver; [$($name),*].len()] =
            [$(NamedObserver { name: $name, title: $title, functions: &$functions }),*];
    };
}

include!(concat!(env!("OUT_DIR"), "/observers.rs"));

/// Returns the standard observer that has this name, or `None` if no observer of [`ALL`] has it.
///
/// ```
/// # use nanospectra::observer::{self, CIE_1964};
/// assert_eq!(observer::named("1964").map(|observer| observer.functions), Some(&CIE_1964));
/// assert!(observer::named("1932").is_none());
/// ```
#[must_use]
pub fn named(name: &str) -> Option<&'static NamedObserver> {
    ALL.iter().find(|observer| observer.name == name)
}

/// Reports the responses of the long, middle and short wavelength cones by the CIE 2006 cone fundamentals for
/// a field of 2 degrees.
///
/// This is the official 5 nm table, interpolated to 1 nm by Sprague's method. Negative overshoot beside the
/// end of the S cone's table is set to zero.
///
/// ```
/// use nanospectra::observer::CIE_2006_LMS_2;
/// use nanospectra::{Fine, Power};
///
/// // A line at 440 nm, where the S cone responds most, and one at 650 nm, where it does not respond at all.
/// let line_at = |nm| {
///     let mut line = Fine::<Power>::flat(0.0);
///     assert_eq!(line.add_line(nm, 1.0), 0.0);
///     line
/// };
/// let [l, m, s] = CIE_2006_LMS_2.sees(&line_at(440.0));
/// assert!(s > m && m > l);
/// let [l, m, s] = CIE_2006_LMS_2.sees(&line_at(650.0));
/// assert!(l > m && m > s && s == 0.0);
/// ```
///
/// # Accuracy
/// The XYZ functions that CIE 170-2 makes of them are within 2e-3 of its own at 1 nm, whose peaks are 1 to 2
/// (`tests/spectrum/eyes_and_samples.rs`).
///
/// # Reference
/// CIE 170-1:2006; CC BY-SA 4.0. The numbers are those of `tables/cmf/cie_2006_2deg_lms_5nm_official.csv`,
/// from which `tables/build.rs` makes a constant.
pub static CIE_2006_LMS_2: FineObserver<3> = cones(&LMS_2_5NM);

/// Reports the responses of the long, middle and short wavelength cones by the CIE 2006 cone fundamentals for
/// a field of 10 degrees.
///
/// It is made as [`CIE_2006_LMS_2`] is; see the [example](CIE_2006_LMS_2) there.
///
/// # Reference
/// CIE 170-1:2006; CC BY-SA 4.0. The numbers are those of `tables/cmf/cie_2006_10deg_lms_5nm_official.csv`,
/// from which `tables/build.rs` makes a constant.
pub static CIE_2006_LMS_10: FineObserver<3> = cones(&LMS_10_5NM);

/// Provides the CIE 1931 standard observer for `N` bands of any kind: for every [`Grid`], and for red, green
/// and blue.
///
/// Code that is generic over the bands needs this bound to call [`Observer::standard`]; see the
/// [example](Observer::standard) there. You need not implement it.
pub trait StandardObserver<const N: usize>: Bands {
    /// The weights of X, Y and Z that [`Observer::standard`] uses.
    const STANDARD: [[f32; N]; 3];
}

impl<const N: usize, G: Grid> StandardObserver<N> for G {
    const STANDARD: [[f32; N]; 3] = CIE_1931.fold::<N, G>(Curve::Step).with_white_y(100.0).0;
}

impl<const N: usize, G: StandardObserver<N>> Observer<3, N, Power, G> {
    /// Returns the CIE 1931 standard observer for these bands, under one name for spectra and for RGB.
    ///
    /// Y is 100 for the constant spectrum 1, and for [`Light::from_rgb`](crate::Spectrum::from_rgb) of white.
    /// On a grid this is [`CIE_1931`] folded by [`Curve::Step`], for relative lights. For lights in W, or for
    /// a curve that is better for surfaces, [`fold`](Observer::fold) [`CIE_1931`] yourself. For
    /// [`RgbBands`](crate::color::RgbBands) it is the matrix of the RGB space, which is exact for the color
    /// of a light; products of colors are as far off as `RgbBands` says.
    ///
    /// ```
    /// # use nanospectra::color::{RgbBands, Srgb};
    /// # use nanospectra::{Light, Observer, Power};
    /// static EYE: Observer<3, 31, Power> = Observer::standard();
    /// static EYE_OF_RGB: Observer<3, 3, Power, RgbBands<Srgb>> = Observer::standard();
    /// let ([_, y, _], [_, y_of_rgb, _]) = (EYE.sees(&Light::flat(1.0)), EYE_OF_RGB.sees(&Light::flat(1.0)));
    /// assert!((y - 100.0).abs() < 1e-4 && (y_of_rgb - 100.0).abs() < 1e-4);
    /// ```
    #[must_use]
    pub const fn standard() -> Self {
        Observer::unchecked(G::STANDARD)
    }
}

const fn cones(table: &[Spectrum<Power, 89, Nodes<390, 830>>; 3]) -> FineObserver<3> {
    let mut rows = [[0.0; 471]; 3];
    const_for!(0..3, |c| {
        let fine: Spectrum<Power, 471, Nodes<360, 830>> = table[c].interpolate(Interpolation::Sprague);
        const_for!(0..471, |k| {
            let value = fine.values()[k];
            rows[c][k] = if value < 0.0 { 0.0 } else { value };
        });
    });
    Observer::from_rows(rows)
}
