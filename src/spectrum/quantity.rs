//! The quantities that the numbers of a spectrum can mean.

/// Says which quantity the numbers of a spectrum are averages of: [`Power`], [`Factor`] or
/// [`RefractiveIndex`].
///
/// An observer carries the quantity that it reads in its type, so a lamp cannot be shown to an eye that
/// already includes a light. [`PerBin`] does not implement this trait, since totals of bins can be neither
/// interpolated nor resampled, and no observer reads them.
///
/// # Example
/// ```
/// use nanospectra::{Factor, Fine, Light, Outside, Power, Quantity, Reflectance};
///
/// // What lies beyond the data follows from the quantity: light ends, a reflectance goes on.
/// assert_eq!((Power::OUTSIDE, Factor::OUTSIDE), (Outside::Zero, Outside::Hold));
/// let (lamp, paint) = (Light::<16>::flat(1.0), Reflectance::<16>::flat(0.5));
/// let (lamp, paint): (Fine<Power>, Fine<Factor>) = (lamp.fine(), paint.fine());
/// assert_eq!((lamp.values()[470], paint.values()[470]), (0.0, 0.5)); // at 830 nm
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a spectral quantity: use `Power` or `Factor`",
    note = "what is counted `PerBin` becomes `Power` by `density()`"
)]
pub trait Quantity: sealed::Sealed + Copy + 'static {
    /// What a spectrum of this quantity is taken to be outside its data: a light ends there, and a factor or
    /// a refractive index keeps its value at the nearest wavelength. See the [example](Quantity#example).
    const OUTSIDE: Outside;
}

/// The quantity of light: power for each nanometer, such as flux, irradiance or radiance, which is relative
/// or in units such as W/nm or W/m2/nm. See the [example](Quantity#example).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Power;

/// The quantity of matter that reflects or transmits light: a factor without a unit, such as reflectance,
/// transmittance or radiance factor, which lies in 0..=1 for passive matter. See the
/// [example](Quantity#example).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Factor;

/// The quantity that [`Dielectric`](crate::matter::Dielectric) and [`Conductor`](crate::matter::Conductor)
/// make reflectances from: a refractive index, or the extinction coefficient beside it.
///
/// It is relative to the medium that the light comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RefractiveIndex;

/// The quantity of totals: each number is what its bin holds in all, and not for each nanometer.
///
/// Counts of a spectrometer's pixels are of this kind, because a pixel sums up all that falls on its width.
/// [`PixelWavelengths::rebinned`](crate::sensor::PixelWavelengths::rebinned) returns them, and
/// [`density`](crate::Spectrum::density) divides them by the width of the bins, which gives [`Power`]. (Taken
/// for a density, pixels of a grating that widen towards the blue are 24 % wrong in blue over red.) See the
/// [example](crate::Spectrum::density) of `density`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PerBin;

/// Says what a spectrum is taken to be where it has no data.
///
/// Usually its quantity decides ([`Quantity::OUTSIDE`]); methods whose names end in `_outside` take the
/// choice as an argument. See the [example](Quantity#example).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Outside {
    /// The spectrum is zero there, as is usual for a light.
    Zero,
    /// The spectrum keeps the value of the nearest sample, as is usual for reflectances and refractive
    /// indices.
    Hold,
}

impl Outside {
    /// The value beyond an end whose last value is `end`.
    pub(crate) const fn beyond(self, end: f32) -> f32 {
        match self {
            Outside::Zero => 0.0,
            Outside::Hold => end,
        }
    }
}

impl Quantity for Power {
    const OUTSIDE: Outside = Outside::Zero;
}

impl Quantity for Factor {
    const OUTSIDE: Outside = Outside::Hold;
}

impl Quantity for RefractiveIndex {
    const OUTSIDE: Outside = Outside::Hold;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Power {}
    impl Sealed for super::Factor {}
    impl Sealed for super::RefractiveIndex {}
}
