//! Light that matter has changed in wavelength.

use crate::grid::by_fields;
use crate::matter::{Donaldson, Dye, Phosphor};
use crate::observer::Path;
use crate::path::{Effects, Filter, Intensity, Plain, Price, Priced, Stokes, StokesPath, Surface};
use crate::spectrum::{Power, Spectrum};
use core::marker::PhantomData;

/// Light that can make matter glow: power on the grid of the matter. Glowing matter emits unpolarized light, and a
/// surface that glows scatters what it reflects.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot make matter fluoresce",
    label = "no light of `Power` in {N} bins of `{G}`",
    note = "an eye that has the light folded in cannot see fluorescence any more, since each bin of light changes \
            many of the eye's: fold the matter in first, `eye.looking_at_dye(&dye).under(&lamp)`"
)]
pub trait Excites<const N: usize, G> {
    /// The light as plain power.
    type Light: Path<Power, N, G>;

    /// The light as plain power.
    fn into_light(self) -> Self::Light;
}

impl<P: Path<Power, N, G>, const N: usize, G> Excites<N, G> for Plain<Power, P> {
    type Light = P;

    #[inline]
    fn into_light(self) -> P {
        self.into_inner()
    }
}

impl<P: StokesPath<N, G>, const N: usize, G> Excites<N, G> for Stokes<P> {
    type Light = Intensity<P>;

    #[inline]
    fn into_light(self) -> Intensity<P> {
        self.ignoring_polarization().into_inner()
    }
}

/// Light `L` off (or through) a dye, which adds its own: `glow` times its emission.
#[derive(Clone, Copy, Debug)]
pub struct Glowing<L, D> {
    light: L,
    matter: D,
    glow: f32,
}

impl<L, D> Glowing<L, D> {
    #[inline]
    pub(crate) const fn new(light: L, matter: D, glow: f32) -> Self {
        Glowing { light, matter, glow }
    }

    /// What the matter absorbed to emit again: the number its emission is multiplied with.
    #[must_use]
    pub const fn glow(&self) -> f32 {
        self.glow
    }
}

impl<L: Priced, const N: usize, G> Priced for Glowing<L, &Dye<N, G>> {
    const PRICE: Price = L::PRICE.plus(Dye::<N, G>::PRICE).and_multiply_adds(L::AGAIN);
    const AGAIN: usize = L::AGAIN + 2 * N;
}

impl<L: Path<Power, N, G>, const N: usize, G> Path<Power, N, G> for Glowing<L, &Dye<N, G>> {
    #[inline]
    fn at(&self, k: usize) -> f32 {
        let (reflects, emits) = self.matter.at(k);
        self.light.at(k) * reflects + emits * self.glow
    }
}

impl<'m, L: Excites<N, G>, const N: usize, G> Surface<L> for &'m Dye<N, G> {
    type Leaving = Plain<Power, Glowing<L::Light, &'m Dye<N, G>>>;

    #[inline]
    fn reflect(self, light: L) -> Self::Leaving {
        let light = light.into_light();
        let glow = light.read(|bins| self.glow_of(bins));
        Plain::new(Glowing::new(light, self, glow))
    }
}

/// Plain light only: what a clear dye leaves of the polarization of light that goes through it is not in its numbers.
impl<Q, P, const N: usize, G> Filter<Plain<Q, P>> for &Dye<N, G>
where
    Plain<Q, P>: Excites<N, G>,
{
    type Leaving = <Self as Surface<Plain<Q, P>>>::Leaving;

    #[inline]
    fn transmit(self, light: Plain<Q, P>) -> Self::Leaving {
        self.reflect(light)
    }
}

impl<L: Priced, const N: usize, G> Priced for Glowing<L, &Phosphor<N, G>> {
    const PRICE: Price = L::PRICE.plus(Phosphor::<N, G>::PRICE);
    const AGAIN: usize = L::AGAIN + 2 * N;
}

impl<L: Path<Power, N, G>, const N: usize, G> Path<Power, N, G> for Glowing<L, &Phosphor<N, G>> {
    #[inline]
    fn at(&self, k: usize) -> f32 {
        let (reflects, emits) = self.matter.dye().at(k);
        self.light.at(k) * reflects + emits * self.glow
    }
}

impl<'m, L: Excites<N, G>, const N: usize, G> Surface<L> for &'m Phosphor<N, G> {
    type Leaving = Plain<Power, Glowing<L::Light, &'m Phosphor<N, G>>>;

    #[inline]
    fn reflect(self, light: L) -> Self::Leaving {
        Plain::new(Glowing::new(light.into_light(), self, self.glow()))
    }
}

/// Light off (or through) matter that moves it between bins: worked out, since every bin needs all of `L`.
pub struct Emitted<L, const N: usize, G> {
    bins: Spectrum<Power, N, G>,
    from: PhantomData<L>,
}

by_fields!([L, const N: usize, G] Emitted<L, N, G>, "Emitted": bins);

impl<L: Priced, const N: usize, G> Priced for Emitted<L, N, G> {
    const PRICE: Price = L::PRICE.plus(Price {
        effects: Effects::FLUORESCENCE,
        multiply_adds: N * (N + 1) / 2,
        bytes: 4 * (N * (N + 1) / 2),
    });
    const AGAIN: usize = 0;
}

impl<L: Priced, const N: usize, G> Path<Power, N, G> for Emitted<L, N, G> {
    #[inline]
    fn at(&self, k: usize) -> f32 {
        (&self.bins).at(k)
    }

    #[inline]
    fn read<R>(&self, reader: impl FnOnce(&[f32; N]) -> R) -> R {
        (&self.bins).read(reader)
    }
}

impl<L: Excites<N, G>, const N: usize, const P: usize, G> Surface<L> for &Donaldson<N, P, G> {
    type Leaving = Plain<Power, Emitted<L::Light, N, G>>;

    #[inline]
    fn reflect(self, light: L) -> Self::Leaving {
        let bins = light.into_light().read(|bins| self.applied(bins));
        Plain::new(Emitted { bins: Spectrum::unchecked(bins), from: PhantomData })
    }
}

/// Plain light only, as for a [`Dye`].
impl<Q, L, const N: usize, const P: usize, G> Filter<Plain<Q, L>> for &Donaldson<N, P, G>
where
    Plain<Q, L>: Excites<N, G>,
{
    type Leaving = <Self as Surface<Plain<Q, L>>>::Leaving;

    #[inline]
    fn transmit(self, light: Plain<Q, L>) -> Self::Leaving {
        self.reflect(light)
    }
}
