//! What the numbers of a spectrum mean.

/// What a spectrum's numbers are: [`Power`] or [`Factor`].
///
/// An observer carries the quantity it reads, so a lamp cannot be shown to an eye that already
/// has the light folded in.
#[diagnostic::on_unimplemented(message = "`{Self}` is not a spectral quantity: use `Power` or `Factor`")]
pub trait Quantity: sealed::Sealed + Copy + 'static {}

/// Spectral power (flux, irradiance, radiance ..) for each nanometre; relative or in W/nm, W/m2/nm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Power;

/// A share without a unit: reflectance, transmittance, radiance factor; 0..=1 for passive matter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Factor;

impl Quantity for Power {}
impl Quantity for Factor {}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Power {}
    impl Sealed for super::Factor {}
}
