//! Folds mirrors, polarizers and retarders into an observer.

use crate::grid::{Bins, by_fields};
use crate::math::const_for;
use crate::matter::{Mirror, Mueller, Polarizer, Retarder};
use crate::observer::Observer;
use crate::spectrum::{Factor, Spectrum};
use core::marker::PhantomData;

/// An observer that responds to the polarization of light, since matter that polarizes is folded into it.
///
/// It holds four weights for each channel and bin, one for each of the Stokes parameters I, Q, U and V. Start
/// it by [`Observer::polarized`], and fold in the mirrors, polarizers and retarders that the light meets, the
/// last one first. Where the light is still unpolarized, [`unpolarized_light`](Self::unpolarized_light) makes
/// it an [`Observer`] again, for which polarization costs nothing.
///
/// # Example
/// ```
/// use nanospectra::matter::Polarizer;
/// use nanospectra::{Bins, Light, Observer, Power};
///
/// type Grid = Bins<400, 700>;
/// static EYE: Observer<1, 3, Power, Grid> = Observer::from_rows([[0.1, 0.8, 0.3]]);
/// // Two ideal polarizers at an angle of 45 degrees pass a quarter of unpolarized light.
/// let (first, second) = (Polarizer::ideal(0.0), Polarizer::ideal(0.125));
/// let folded = EYE.polarized().through_polarizer(&second).through_polarizer(&first).unpolarized_light();
/// let lamp = Light::flat(1.0);
/// assert!((folded.sees(&lamp)[0] - 0.25 * EYE.sees(&lamp)[0]).abs() < 1e-6);
/// ```
pub struct PolarizedObserver<const C: usize, const N: usize, Q = Factor, G = Bins<380, 730>>(
    [[[f32; 4]; N]; C],
    PhantomData<(Q, G)>,
);

by_fields!([const C: usize, const N: usize, Q, G] PolarizedObserver<C, N, Q, G>, "PolarizedObserver": 0);

impl<const C: usize, const N: usize, Q, G> Observer<C, N, Q, G> {
    /// Starts folding polarizing elements in front of this observer, which itself responds equally to all
    /// polarizations.
    ///
    /// See the [example](PolarizedObserver#example).
    #[must_use]
    pub const fn polarized(&self) -> PolarizedObserver<C, N, Q, G> {
        let mut weights = [[[0.0; 4]; N]; C];
        const_for!(0..C, |c| const_for!(0..N, |k| weights[c][k][0] = self.0[c][k]));
        PolarizedObserver(weights, PhantomData)
    }
}

impl<const C: usize, const N: usize, Q, G> PolarizedObserver<C, N, Q, G> {
    /// Puts a polarizer in front of this observer. See the [example](#example).
    #[must_use]
    pub const fn through_polarizer(&self, polarizer: &Polarizer<N, G>) -> Self {
        self.behind(polarizer.mueller())
    }

    /// Puts a retarder in front of this observer.
    ///
    /// Alone a retarder changes no reading; between polarizers or mirrors it does.
    #[must_use]
    pub const fn through_retarder(&self, retarder: &Retarder<N, G>) -> Self {
        self.behind(retarder.mueller())
    }

    /// Lets this observer look into a mirror, at what the mirror reflects.
    ///
    /// See the [example](crate::path#folding-a-path-into-an-observer).
    #[must_use]
    pub const fn looking_at_mirror(&self, mirror: &Mirror<N, G>) -> Self {
        self.behind(mirror.mueller())
    }

    /// Puts colored glass in front of this observer, which dims I, Q, U and V alike.
    #[must_use]
    pub const fn through(&self, filter: &Spectrum<Factor, N, G>) -> Self {
        let mut weights = self.0;
        const_for!(0..C, |c| const_for!(0..N, |k| const_for!(0..4, |i| weights[c][k][i] *= filter.0[k])));
        PolarizedObserver(weights, PhantomData)
    }

    /// Returns the observer of the unpolarized light that enters here, from a lamp or from a matt surface.
    ///
    /// See the [example](#example).
    #[must_use]
    pub const fn unpolarized_light(&self) -> Observer<C, N, Q, G> {
        let mut weights = [[0.0; N]; C];
        const_for!(0..C, |c| const_for!(0..N, |k| weights[c][k] = self.0[c][k][0]));
        Observer::unchecked(weights)
    }

    pub(in crate::path) const fn behind(&self, element: &Mueller<N, G>) -> Self {
        let mut weights = self.0;
        const_for!(0..C, |c| const_for!(0..N, |k| weights[c][k] = element.fold(k, weights[c][k])));
        PolarizedObserver(weights, PhantomData)
    }
}
