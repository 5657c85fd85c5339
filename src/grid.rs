//! What the numbers of a spectrum belong to: bands of any kind, and those that lie at wavelengths.

/// What the N numbers of a spectrum belong to: the bins of a [`Grid`] of wavelengths, or red, green and blue
/// ([`RgbBands`](crate::color::RgbBands)).
///
/// What needs no wavelengths asks for no more than this: arithmetic, [`flat`](crate::Spectrum::flat), BRDFs,
/// radiometry, paths, observers. Code that is generic over it, or written against an alias, is a spectral
/// renderer or an RGB one:
///
/// ```
/// use nanospectra::color::{RgbBands, Srgb};
/// use nanospectra::{Bands, Light, Reflectance};
///
/// fn twice_off<const N: usize, G: Bands>(light: Light<N, G>, wall: Reflectance<N, G>) -> Light<N, G> {
///     light * wall * wall
/// }
/// let spectral = twice_off(Light::<31>::flat(1.0), Reflectance::flat(0.5));
/// let rgb = twice_off(Light::<3, RgbBands<Srgb>>::flat(1.0), Reflectance::flat(0.5));
/// assert_eq!((spectral.peak(), rgb.peak()), (0.25, 0.25));
/// ```
///
/// Bands of your own are a type with [`Grid`], or an RGB space of your own in `RgbBands`: there is no other
/// kind.
#[diagnostic::on_unimplemented(
    message = "`{Self}` says nothing of what the numbers of a spectrum belong to",
    note = "use `Bins`, `Nodes`, a type with `Grid`, or `RgbBands` for red, green and blue"
)]
pub trait Bands: Copy + 'static {
    /// What they are.
    #[doc(hidden)]
    const KIND: Kind;
}

/// The two kinds of bands.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// Bins of wavelengths: `FIRST`, `LAST` and `CENTERED` of the grid.
    Wavelengths { first: f64, last: f64, centered: bool },
    /// So many colors, at no wavelengths.
    Colors(usize),
}

impl<G: Grid> Bands for G {
    const KIND: Kind = Kind::Wavelengths { first: G::FIRST, last: G::LAST, centered: G::CENTERED };
}

/// A range of wavelengths, in nm, divided into equal bins; a type, so that spectra on
/// different grids cannot be mixed.
///
/// Use [`Bins`] or [`Nodes`]; a range that is not whole nanometers brings its own type:
///
/// ```
/// # use nanospectra::{Grid, Light};
/// /// A mini-spectrometer whose pixels are centered on 317.4..=881.2 nm.
/// #[derive(Clone, Copy, Debug)]
/// struct MyChip;
/// impl Grid for MyChip {
///     const FIRST: f64 = 317.4;
///     const LAST: f64 = 881.2;
///     const CENTERED: bool = true;
/// }
/// let dark = Light::<288, MyChip>::flat(0.0);
/// assert_eq!(dark.iter().next(), Some((317.4, 0.0)));
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no wavelengths",
    label = "no grid of wavelengths",
    note = "samples, lines, tables, glass, films, dyes and `center_nm` mean wavelengths, and red, green and blue have \
            none: work the matter out on a grid (`Bins`, `Nodes`) and take its color, `Light::from_rgb(color)` and \
            `Reflectance::from_rgb(color)`, or use a grid for the whole program"
)]
pub trait Grid: Copy + 'static {
    /// The first edge, or the center of the first bin if [`CENTERED`](Grid::CENTERED), in nm.
    const FIRST: f64;
    /// The last edge, or the center of the last bin if [`CENTERED`](Grid::CENTERED), in nm.
    const LAST: f64;
    /// Whether `FIRST` and `LAST` are centers of bins (an instrument's) or edges.
    const CENTERED: bool;
}

/// N equal bins between two edges, in nm: `Light<60, Bins<400, 700>>` has bins 5 nm wide.
#[derive(Clone, Copy, Debug)]
pub struct Bins<const START: u16, const END: u16>;

/// N equal bins centered on `FIRST`..=`LAST`, in nm: what instruments and CIE tables report.
/// `Light<81, Nodes<380, 780>>` is a 5 nm instrument; its outer edges are 377.5 and 782.5 nm.
#[derive(Clone, Copy, Debug)]
pub struct Nodes<const FIRST: u16, const LAST: u16>;

impl<const START: u16, const END: u16> Grid for Bins<START, END> {
    const FIRST: f64 = START as f64;
    const LAST: f64 = END as f64;
    const CENTERED: bool = false;
}

impl<const FIRST: u16, const LAST: u16> Grid for Nodes<FIRST, LAST> {
    const FIRST: f64 = FIRST as f64;
    const LAST: f64 = LAST as f64;
    const CENTERED: bool = true;
}

/// The bands `G` when there are `N` of them: checked, and their wavelengths worked out, once, when code is
/// generated.
pub(crate) struct Layout<G, const N: usize>(core::marker::PhantomData<G>);

impl<G: Bands, const N: usize> Layout<G, N> {
    /// Naming it makes bands that cannot be `N` fail.
    pub(crate) const CHECKED: () = match G::KIND {
        Kind::Colors(count) => assert!(N == count, "red, green and blue are three bands"),
        Kind::Wavelengths { first, last, centered } => {
            assert!(N >= 1, "a spectrum needs at least one band");
            assert!(first >= 0.0 && first < last, "a grid must end above its start");
            assert!(last <= 1e6, "a grid must end below a millimeter");
            assert!(!centered || N >= 2, "one band has no spacing: use Bins for it");
            let width = (last - first) / (if centered { N - 1 } else { N }) as f64;
            assert!(width * 1e6 >= last, "bins this narrow have edges that f32 cannot tell apart");
        }
    };
}

impl<G: Grid, const N: usize> Layout<G, N> {
    /// Width of a bin, in nm.
    pub(crate) const WIDTH: f64 = {
        let () = Self::CHECKED;
        (G::LAST - G::FIRST) / (if G::CENTERED { N - 1 } else { N }) as f64
    };

    /// The lower edge of the first bin, in nm.
    pub(crate) const START: f64 = if G::CENTERED { G::FIRST - Self::WIDTH / 2.0 } else { G::FIRST };

    /// The upper edge of the last bin, in nm.
    pub(crate) const END: f64 = if G::CENTERED { G::LAST + Self::WIDTH / 2.0 } else { G::LAST };

    /// The width for run-time code.
    pub(crate) const STEP: f32 = Self::WIDTH as f32;

    /// Edge `k`, 0..=N, in nm: one function for both neighbors, so no gap opens between bins.
    pub(crate) const fn edge(k: usize) -> f32 {
        if k >= N { Self::END as f32 } else { Self::START as f32 + k as f32 * Self::STEP }
    }

    /// Edge `k`, 0..=N, in units of 2^-40 nm. Overlaps of bins are differences of these: in f32 an
    /// edge near 500 nm is off by up to 3e-5 nm, which is 4e-5 of a bin of 0.75 nm.
    pub(crate) const fn edge_units(k: usize) -> i64 {
        const UNITS: f64 = (1_i64 << 40) as f64;
        let (start, width) = const { ((Self::START * UNITS) as i64, (Self::WIDTH * UNITS + 0.5) as i64) };
        start + k as i64 * width
    }

    /// Center of the first bin, in nm.
    pub(crate) const FIRST_CENTER: f32 = (Self::START + Self::WIDTH / 2.0) as f32;

    /// Center of the last bin, in nm.
    pub(crate) const LAST_CENTER: f32 = (Self::END - Self::WIDTH / 2.0) as f32;

    /// Center of bin `k`, in nm; exact on whole-nanometer nodes.
    pub(crate) const fn center(k: usize) -> f32 {
        if k + 1 >= N { Self::LAST_CENTER } else { Self::FIRST_CENTER + k as f32 * Self::STEP }
    }
}

/// `Clone`, `Copy`, `PartialEq` and `Debug` by these fields, whatever the grid: derived, they would ask it of
/// the grid too, which is only a name.
macro_rules! by_fields {
    ([$($generics:tt)*] $type:ty, $name:literal: $($field:tt),+) => {
        impl<$($generics)*> Clone for $type {
            fn clone(&self) -> Self {
                *self
            }
        }

        impl<$($generics)*> Copy for $type {}

        impl<$($generics)*> PartialEq for $type {
            fn eq(&self, other: &Self) -> bool {
                $(self.$field == other.$field)&&+
            }
        }

        impl<$($generics)*> core::fmt::Debug for $type {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.debug_struct($name)$(.field(stringify!($field), &self.$field))+.finish()
            }
        }
    };
}
pub(crate) use by_fields;
