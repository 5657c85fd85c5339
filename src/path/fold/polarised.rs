//! An observer that asks how light is polarised: what folds mirrors, polarisers and retarders.

use crate::grid::{Bins, by_fields};
use crate::matter::{Mirror, Mueller, Polariser, Retarder};
use crate::observer::Observer;
use crate::spectrum::{Factor, Spectrum};
use core::marker::PhantomData;

/// An observer behind matter that polarises: for each channel and bin one weight for each of I, Q, U and V.
///
/// From [`Observer::polarised`] back along the path, to the point where the light is unpolarised:
/// [`unpolarised_light`](Self::unpolarised_light) makes it an [`Observer`] again, and polarisation costs nothing.
pub struct PolarisedObserver<const C: usize, const N: usize, Q = Factor, G = Bins<380, 730>>(
    [[[f32; 4]; N]; C],
    PhantomData<(Q, G)>,
);

by_fields!([const C: usize, const N: usize, Q, G] PolarisedObserver<C, N, Q, G>, "PolarisedObserver": 0);

impl<const C: usize, const N: usize, Q, G> Observer<C, N, Q, G> {
    /// Starts folding polarising elements in front of this observer, which itself responds equally to all polarisations.
    #[must_use]
    pub const fn polarised(&self) -> PolarisedObserver<C, N, Q, G> {
        let mut weights = [[[0.0; 4]; N]; C];
        let mut c = 0;
        while c < C {
            let mut k = 0;
            while k < N {
                weights[c][k][0] = self.0[c][k];
                k += 1;
            }
            c += 1;
        }
        PolarisedObserver(weights, PhantomData)
    }

    /// This observer behind a polariser: asked how the light is polarised from there on.
    #[must_use]
    pub const fn through_polariser(&self, polariser: &Polariser<N, G>) -> PolarisedObserver<C, N, Q, G> {
        self.polarised().through_polariser(polariser)
    }

    /// This observer behind a retarder. A retarder alone changes no reading; between polarisers or mirrors it does.
    #[must_use]
    pub const fn through_retarder(&self, retarder: &Retarder<N, G>) -> PolarisedObserver<C, N, Q, G> {
        self.polarised().through_retarder(retarder)
    }

    /// This observer looking into a mirror: asked how the light is polarised from there on.
    #[must_use]
    pub const fn looking_at_mirror(&self, mirror: &Mirror<N, G>) -> PolarisedObserver<C, N, Q, G> {
        self.polarised().looking_at_mirror(mirror)
    }
}

impl<const C: usize, const N: usize, Q, G> PolarisedObserver<C, N, Q, G> {
    /// Behind a polariser.
    #[must_use]
    pub const fn through_polariser(&self, polariser: &Polariser<N, G>) -> Self {
        self.behind(polariser.mueller())
    }

    /// Behind a retarder.
    #[must_use]
    pub const fn through_retarder(&self, retarder: &Retarder<N, G>) -> Self {
        self.behind(retarder.mueller())
    }

    /// Looking into a mirror.
    #[must_use]
    pub const fn looking_at_mirror(&self, mirror: &Mirror<N, G>) -> Self {
        self.behind(mirror.mueller())
    }

    /// Behind coloured glass, which dims I, Q, U and V alike.
    #[must_use]
    pub const fn through(&self, filter: &Spectrum<Factor, N, G>) -> Self {
        let mut weights = self.0;
        let mut c = 0;
        while c < C {
            let mut k = 0;
            while k < N {
                let mut i = 0;
                while i < 4 {
                    weights[c][k][i] *= filter.0[k];
                    i += 1;
                }
                k += 1;
            }
            c += 1;
        }
        PolarisedObserver(weights, PhantomData)
    }

    /// Looking at what sends or scatters unpolarised light (a lamp, a matt surface): an [`Observer`] again.
    #[must_use]
    pub const fn unpolarised_light(&self) -> Observer<C, N, Q, G> {
        let mut weights = [[0.0; N]; C];
        let mut c = 0;
        while c < C {
            let mut k = 0;
            while k < N {
                weights[c][k] = self.0[c][k][0];
                k += 1;
            }
            c += 1;
        }
        Observer::unchecked(weights)
    }

    const fn behind(&self, element: &Mueller<N, G>) -> Self {
        let mut weights = self.0;
        let mut c = 0;
        while c < C {
            let mut k = 0;
            while k < N {
                weights[c][k] = element.fold(k, weights[c][k]);
                k += 1;
            }
            c += 1;
        }
        PolarisedObserver(weights, PhantomData)
    }
}
