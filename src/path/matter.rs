//! The traits of surfaces and filters, and spectra of factors as both.

use crate::observer::Stimulus;
use crate::path::{Plain, Times};
use crate::spectrum::{Factor, Spectrum};

/// Matter that light `L` can fall on and that reflects or re-emits it.
///
/// References to these types are surfaces: spectra of [`Factor`] (a reflectance),
/// [`Mirror`](crate::matter::Mirror), [`Dye`](crate::matter::Dye), [`Donaldson`](crate::matter::Donaldson)
/// and [`Phosphor`](crate::matter::Phosphor). An [`Effect`](crate::matter::Effect) of your own is one in
/// [`Own`](crate::path::Own). Call [`Plain::onto`] rather than this trait's function; see the
/// [example](crate::path#example).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no surface that `{L}` can fall on",
    label = "no surface for this light",
    note = "light falls on `&Reflectance`, `&Dye`, `&Donaldson`, `&Phosphor`, and, once `.polarized()`, on \
            `&Mirror`; on an effect of your own in `Own::new(&ink)`",
    note = "it goes through `&Polarizer` and `&Retarder`: `.through(..)`",
    note = "what is `Power` is light itself: it is applied once, as the start of the path"
)]
pub trait Surface<L> {
    /// The type of the light that leaves the surface.
    type Leaving;

    /// Returns the light that leaves the surface when `light` falls on it.
    fn reflect(self, light: L) -> Self::Leaving;
}

/// Matter that light `L` can go through and that absorbs, polarizes or re-emits it.
///
/// References to these types are filters: spectra of [`Factor`] (a transmittance),
/// [`Polarizer`](crate::matter::Polarizer), [`Retarder`](crate::matter::Retarder),
/// [`Dye`](crate::matter::Dye), [`Donaldson`](crate::matter::Donaldson) and
/// [`Phosphor`](crate::matter::Phosphor). An [`Effect`](crate::matter::Effect) of your own is one in
/// [`Own`](crate::path::Own). Call [`Plain::through`] rather than this trait's function; see the
/// [example](crate::path#example).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no filter that `{L}` can go through",
    label = "no filter for this light",
    note = "light goes through spectra of `Factor`, `&Dye`, `&Donaldson`, `&Phosphor`, and, once \
            `.polarized()`, through `&Polarizer` and `&Retarder`; through an effect of your own in \
            `Own::new(&ink)`",
    note = "it falls on `&Mirror`: `.onto(..)`",
    note = "what a dye leaves of polarization is not known: `.ignoring_polarization()` before \
            `.through(&dye)`",
    note = "what is `Power` is light itself: it is applied once, as the start of the path"
)]
pub trait Filter<L> {
    /// The type of the light that leaves the filter.
    type Leaving;

    /// Returns the light that leaves the filter when `light` enters it.
    fn transmit(self, light: L) -> Self::Leaving;
}

impl<'m, Q, P: Stimulus<Q, N, G>, const N: usize, G> Surface<Plain<Q, P>> for &'m Spectrum<Factor, N, G> {
    type Leaving = Plain<Q, Times<P, &'m Spectrum<Factor, N, G>>>;

    #[inline]
    fn reflect(self, light: Plain<Q, P>) -> Self::Leaving {
        Plain::new(Times { light: light.into_inner(), factors: self })
    }
}

impl<Q, P: Stimulus<Q, N, G>, const N: usize, G> Filter<Plain<Q, P>> for &Spectrum<Factor, N, G> {
    type Leaving = <Self as Surface<Plain<Q, P>>>::Leaving;

    #[inline]
    fn transmit(self, light: Plain<Q, P>) -> Self::Leaving {
        self.reflect(light)
    }
}
