//! The eyes that CIE has tabulated, as published; constants made from the files in `tables/`.

use crate::grid::{Bands, Grid, Nodes};
use crate::math::const_for;
use crate::observer::{Curve, FineObserver, Observer};
use crate::spectrum::{Interpolation, Power, Spectrum};

/// Luminous efficacy of radiation at 555 nm, lm/W: times the sum of power and V(lambda).
///
/// SI defines 683 lm/W at 540 THz, which is 555.017 nm in air; V(lambda) is scaled to 1 at
/// 555 nm, where CIE 18:2019 therefore gives 683.002.
pub const KM: f32 = 683.002;

/// Luminous efficacy for scotopic vision, lm/W: times the sum of power and V'(lambda) (CIE 18:2019).
pub const KM_SCOTOPIC: f32 = 1700.0;

/// Color-matching functions with the name that users type.
#[derive(Clone, Copy, Debug)]
pub struct NamedObserver {
    /// What users type: `"1931"`, `"2015-10"`.
    pub name: &'static str,
    /// For reports: `"CIE 1931, 2°"`.
    pub title: &'static str,
    /// The functions themselves.
    pub functions: &'static FineObserver<3>,
}

/// Makes [`ALL`] from the list that the build script writes beside the tables.
macro_rules! by_name {
    ($($name:literal $title:literal $functions:ident,)*) => {
        /// All color-matching functions that users choose by name, that of 1931 first.
        ///
        /// A program that reads this contains the tables of all of them, 23 KB.
        pub static ALL: [NamedObserver; [$($name),*].len()] =
            [$(NamedObserver { name: $name, title: $title, functions: &$functions }),*];
    };
}

include!(concat!(env!("OUT_DIR"), "/observers.rs"));

/// The color-matching functions of this name, from [`ALL`].
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

/// CIE 2006 cone fundamentals, 2 degrees: long, middle and short wavelength cones.
///
/// The official 5 nm table, brought to 1 nm by Sprague's interpolation, negative overshoot beside
/// the end of the S cone set to zero.
///
/// # Accuracy
/// The XYZ functions that CIE 170-2 makes of them are within 2e-3 of its own at 1 nm, whose peaks are 1 to 2
/// (`tests/spectrum/eyes_and_samples.rs`).
///
/// # Reference
/// CIE 170-1:2006; CC BY-SA 4.0.
pub static CIE_2006_LMS_2: FineObserver<3> = cones(&LMS_2_5NM);

/// CIE 2006 cone fundamentals, 10 degrees; as [`CIE_2006_LMS_2`].
pub static CIE_2006_LMS_10: FineObserver<3> = cones(&LMS_10_5NM);

/// Bands that the CIE 1931 standard observer looks at, `N` of them: every [`Grid`], and red, green and blue.
pub trait StandardObserver<const N: usize>: Bands {
    /// The weights of X, Y and Z.
    const STANDARD: [[f32; N]; 3];
}

impl<const N: usize, G: Grid> StandardObserver<N> for G {
    const STANDARD: [[f32; N]; 3] = CIE_1931.fold::<N, G>(Curve::Step).with_white_y(100.0).0;
}

impl<const N: usize, G: StandardObserver<N>> Observer<3, N, Power, G> {
    /// The CIE 1931 standard observer, under one name for spectra and for RGB; Y = 100 for the constant
    /// spectrum 1 and for [`Light::from_rgb`](crate::Spectrum::from_rgb) of white.
    ///
    /// On a grid it is [`CIE_1931`] folded by [`Curve::Step`], for relative lights. (For lights in W, or a
    /// fold that is better for surfaces, fold [`CIE_1931`] yourself.) Of [`RgbBands`](crate::color::RgbBands)
    /// it is the matrix of the space: exact for the color of a light, and for products of colors as far off
    /// as `RgbBands` says.
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
