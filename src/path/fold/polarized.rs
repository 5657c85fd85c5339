//! An observer that asks how light is polarized: what folds mirrors, polarizers and retarders.

use crate::grid::{Bins, by_fields};
use crate::math::const_for;
use crate::matter::{Mirror, Mueller, Polarizer, Retarder};
use crate::observer::Observer;
use crate::spectrum::{Factor, Spectrum};
use core::marker::PhantomData;

/// An observer behind matter that polarizes: for each channel and bin one weight for each of I, Q, U and V.
///
/// It leads from [`Observer::polarized`] back along the path to where the light is unpolarized: there
/// [`unpolarized_light`](Self::unpolarized_light) makes it an [`Observer`] again, and polarization costs
/// nothing.
pub struct PolarizedObserver<const C: usize, const N: usize, Q = Factor, G = Bins<380, 730>>(
    [[[f32; 4]; N]; C],
    PhantomData<(Q, G)>,
);

by_fields!([const C: usize, const N: usize, Q, G] PolarizedObserver<C, N, Q, G>, "PolarizedObserver": 0);

impl<const C: usize, const N: usize, Q, G> Observer<C, N, Q, G> {
    /// Starts folding polarizing elements in front of this observer, which itself responds equally to all
    /// polarizations.
    #[must_use]
    pub const fn polarized(&self) -> PolarizedObserver<C, N, Q, G> {
        let mut weights = [[[0.0; 4]; N]; C];
        const_for!(0..C, |c| const_for!(0..N, |k| weights[c][k][0] = self.0[c][k]));
        PolarizedObserver(weights, PhantomData)
    }
}

impl<const C: usize, const N: usize, Q, G> PolarizedObserver<C, N, Q, G> {
    /// This observer behind a polarizer.
    #[must_use]
    pub const fn through_polarizer(&self, polarizer: &Polarizer<N, G>) -> Self {
        self.behind(polarizer.mueller())
    }

    /// This observer behind a retarder, which alone changes no reading, but does between polarizers or
    /// mirrors.
    #[must_use]
    pub const fn through_retarder(&self, retarder: &Retarder<N, G>) -> Self {
        self.behind(retarder.mueller())
    }

    /// This observer looking into a mirror.
    #[must_use]
    pub const fn looking_at_mirror(&self, mirror: &Mirror<N, G>) -> Self {
        self.behind(mirror.mueller())
    }

    /// This observer behind colored glass, which dims I, Q, U and V alike.
    #[must_use]
    pub const fn through(&self, filter: &Spectrum<Factor, N, G>) -> Self {
        let mut weights = self.0;
        const_for!(0..C, |c| const_for!(0..N, |k| const_for!(0..4, |i| weights[c][k][i] *= filter.0[k])));
        PolarizedObserver(weights, PhantomData)
    }

    /// This observer looking at what sends or scatters unpolarized light, a lamp or a matt surface: an
    /// [`Observer`] again.
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
