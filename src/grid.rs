//! Says which bands the numbers of a spectrum belong to: bins of a grid of wavelengths, or red, green and
//! blue.

/// Says what the `N` numbers of a spectrum belong to: the bins of a [`Grid`] of wavelengths, or red, green
/// and blue ([`RgbBands`](crate::color::RgbBands)).
///
/// Operations that need no wavelengths ask for no more than this trait: arithmetic,
/// [`flat`](crate::Spectrum::flat), BRDFs, radiometry, paths and observers. Code that is generic over
/// `Bands`, or that names its spectra by one alias, therefore works as a spectral renderer and as an RGB
/// renderer.
///
/// There are no other kinds of bands. For bands of your own implement [`Grid`] for a type, or use `RgbBands`
/// with an RGB space of your own.
///
/// # Example
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
#[diagnostic::on_unimplemented(
    message = "`{Self}` says nothing of what the numbers of a spectrum belong to",
    note = "use `Bins`, `Nodes`, a type with `Grid`, or `RgbBands` for red, green and blue"
)]
pub trait Bands: Copy + 'static {
    /// Which of the two kinds of bands these are.
    #[doc(hidden)]
    const KIND: Kind;
}

/// The two kinds of bands.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// Bins of wavelengths, described by `FIRST`, `LAST` and `CENTERED` of the grid.
    Wavelengths { first: f64, last: f64, centered: bool },
    /// This many colors, which have no wavelengths.
    Colors(usize),
}

impl<G: Grid> Bands for G {
    const KIND: Kind = Kind::Wavelengths { first: G::FIRST, last: G::LAST, centered: G::CENTERED };
}

/// Describes a range of wavelengths, in nm, that is divided into equal bins.
///
/// A grid is a type, so the compiler refuses to mix spectra on different grids. Use [`Bins`] or [`Nodes`] for
/// ranges of whole nanometers. For any other range implement this trait for a type of your own; nothing but
/// its three constants is needed.
///
/// # Example
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
    /// Where the grid begins, in nm: the lower edge of its first bin, or the center of that bin if
    /// [`CENTERED`](Grid::CENTERED) is true. See the [example](Grid#example).
    const FIRST: f64;
    /// Where the grid ends, in nm: the upper edge of its last bin, or the center of that bin if
    /// [`CENTERED`](Grid::CENTERED) is true. See the [example](Grid#example).
    const LAST: f64;
    /// Whether `FIRST` and `LAST` are centers of bins, as an instrument reports them, or edges of bins. See
    /// the [example](Grid#example).
    const CENTERED: bool;
}

/// A grid of `N` equal bins that lie between the edges `START` and `END`, in nm.
///
/// # Example
/// ```
/// # use nanospectra::{Bins, Light};
/// // 60 bins from 400 to 700 nm are 5 nm wide.
/// type Coarse = Light<60, Bins<400, 700>>;
/// assert_eq!((Coarse::WIDTH_NM, Coarse::edge_nm(0), Coarse::center_nm(0)), (5.0, 400.0, 402.5));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Bins<const START: u16, const END: u16>;

/// A grid of `N` equal bins whose centers run from `FIRST` to `LAST`, in nm, as instruments and CIE tables
/// report them.
///
/// # Example
/// ```
/// # use nanospectra::{Light, Nodes};
/// // An instrument that reports 380, 385, .. 780 nm; its first bin begins half a step below 380 nm.
/// type Instrument = Light<81, Nodes<380, 780>>;
/// assert_eq!((Instrument::center_nm(0), Instrument::center_nm(80)), (380.0, 780.0));
/// assert_eq!((Instrument::edge_nm(0), Instrument::edge_nm(81)), (377.5, 782.5));
/// ```
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

/// The layout of `N` bands of `G`. Each such pair is checked, and its wavelengths are computed, once while
/// code is generated.
pub(crate) struct Layout<G, const N: usize>(core::marker::PhantomData<G>);

impl<G: Bands, const N: usize> Layout<G, N> {
    /// Evaluating this constant stops the build if `G` cannot be divided into `N` bands.
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

    /// Width of a bin, in nm, as run-time code uses it.
    pub(crate) const STEP: f32 = Self::WIDTH as f32;

    /// Edge `k`, 0..=N, in nm. Both neighbors of an edge get it from here, so no gap opens between bins.
    pub(crate) const fn edge(k: usize) -> f32 {
        if k >= N { Self::END as f32 } else { Self::START as f32 + k as f32 * Self::STEP }
    }

    /// Edge `k`, 0..=N, in units of 2^-40 nm. Overlaps of bins are computed as differences of these, because
    /// in f32 an edge near 500 nm is off by up to 3e-5 nm, which is 4e-5 of a bin of 0.75 nm.
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

/// Implements `Clone`, `Copy`, `PartialEq` and `Debug` by these fields, for every grid. Derived
/// implementations would demand the same traits of the grid, which is only a name.
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
