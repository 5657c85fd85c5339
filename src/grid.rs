//! Where the bands of a spectrum lie: N equal bins tile a range of wavelengths.

/// A range of wavelengths, in nm, divided into equal bins; a type, so that spectra on
/// different grids cannot be mixed.
///
/// Use [`Bins`] or [`Nodes`]; a range that is not whole nanometers brings its own type:
///
/// ```
/// # use nanospectra::{Grid, Light};
/// /// A mini-spectrometer whose pixels are centerd on 317.4..=881.2 nm.
/// #[derive(Clone, Copy, Debug)]
/// struct MyChip;
/// impl Grid for MyChip {
///     const FIRST: f64 = 317.4;
///     const LAST: f64 = 881.2;
///     const CENTERD: bool = true;
/// }
/// let dark = Light::<288, MyChip>::flat(0.0);
/// assert_eq!(dark.iter().next(), Some((317.4, 0.0)));
/// ```
pub trait Grid: Copy + 'static {
    /// The first edge, or the center of the first bin if [`CENTERD`](Grid::CENTERD), in nm.
    const FIRST: f64;
    /// The last edge, or the center of the last bin if [`CENTERD`](Grid::CENTERD), in nm.
    const LAST: f64;
    /// Whether `FIRST` and `LAST` are centers of bins (an instrument's) or edges.
    const CENTERD: bool;
}

/// N equal bins between two edges, in nm: `Light<60, Bins<400, 700>>` has bins 5 nm wide.
#[derive(Clone, Copy, Debug)]
pub struct Bins<const START: u16, const END: u16>;

/// N equal bins centerd on `FIRST`..=`LAST`, in nm: what instruments and CIE tables report.
/// `Light<81, Nodes<380, 780>>` is a 5 nm instrument; its outer edges are 377.5 and 782.5 nm.
#[derive(Clone, Copy, Debug)]
pub struct Nodes<const FIRST: u16, const LAST: u16>;

impl<const START: u16, const END: u16> Grid for Bins<START, END> {
    const FIRST: f64 = START as f64;
    const LAST: f64 = END as f64;
    const CENTERD: bool = false;
}

impl<const FIRST: u16, const LAST: u16> Grid for Nodes<FIRST, LAST> {
    const FIRST: f64 = FIRST as f64;
    const LAST: f64 = LAST as f64;
    const CENTERD: bool = true;
}

/// The wavelengths of `N` bins on the grid `G`, worked out once, when code is generated.
pub(crate) struct Layout<G, const N: usize>(core::marker::PhantomData<G>);

impl<G: Grid, const N: usize> Layout<G, N> {
    /// Width of a bin, in nm.
    pub(crate) const WIDTH: f64 = {
        assert!(N >= 1, "a spectrum needs at least one band");
        assert!(G::FIRST >= 0.0 && G::FIRST < G::LAST, "a grid must end above its start");
        assert!(G::LAST <= 1e6, "a grid must end below a millimeter");
        let width = if G::CENTERD {
            assert!(N >= 2, "one band has no spacing: use Bins for it");
            (G::LAST - G::FIRST) / (N - 1) as f64
        } else {
            (G::LAST - G::FIRST) / N as f64
        };
        assert!(width * 1e6 >= G::LAST, "bins this narrow have edges that f32 cannot tell apart");
        width
    };

    /// The lower edge of the first bin, in nm.
    pub(crate) const START: f64 = if G::CENTERD { G::FIRST - Self::WIDTH / 2.0 } else { G::FIRST };

    /// The upper edge of the last bin, in nm.
    pub(crate) const END: f64 = if G::CENTERD { G::LAST + Self::WIDTH / 2.0 } else { G::LAST };

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

/// `Clone`, `Copy`, `PartialEq` and `Debug` by these fields, whatever the grid: derived, they would ask it of the
/// grid too, which is only a name.
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
