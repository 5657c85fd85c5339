//! What the numbers of a spectrum mean.

/// What a spectrum's averages are averages of: [`Power`] or [`Factor`].
///
/// An observer carries the quantity it reads, so a lamp cannot be shown to an eye that already
/// has the light folded in. [`PerBin`] is none: nothing can look at it, interpolate or resample it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a spectral quantity: use `Power` or `Factor`",
    note = "what is counted `PerBin` becomes `Power` by `density()`"
)]
pub trait Quantity: sealed::Sealed + Copy + 'static {
    /// What a spectrum of this quantity is outside its data: a light is taken to end there, a factor or an
    /// index of refraction to stay what it was at the nearest wavelength.
    const OUTSIDE: Outside;
}

/// Spectral power (flux, irradiance, radiance ..) for each nanometer; relative or in W/nm, W/m2/nm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Power;

/// A share without a unit: reflectance, transmittance, radiance factor; 0..=1 for passive matter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Factor;

/// A refractive index, or the extinction coefficient beside it; relative to the medium light comes from. What
/// [`Dielectric`](crate::matter::Dielectric) and [`Conductor`](crate::matter::Conductor) make reflectances
/// from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RefractiveIndex;

/// What a bin holds in all, and not for each nanometer: the counts of a spectrometer's pixels, which already
/// sum up what falls on their width. Made by
/// [`PixelWavelengths::rebinned`](crate::sensor::PixelWavelengths::rebinned).
///
/// Taken for a density, pixels of a grating that widen towards the blue are 24 % wrong in blue over red.
/// [`density`](crate::Spectrum::density) divides by the width of the bins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PerBin;

/// What a spectrum is where it has no data. Its quantity decides ([`Quantity::OUTSIDE`]); methods whose names
/// end in `_outside` take another choice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Outside {
    /// Nothing: what a light is taken for.
    Zero,
    /// What the nearest sample says: what reflectances and refractive indices are taken for.
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
