//! Light that matter has moved between bins: every [`Effect`] as a surface and as a filter.

use crate::grid::{Bins, by_fields};
use crate::matter::{Donaldson, Dye, Effect, Foldable, Glows, Phosphor};
use crate::observer::Stimulus;
use crate::path::{
    Filter, IgnoringPolarization, IntoPart, Part, Plain, Price, Priced, Stokes, StokesPath, Surface,
};
use crate::spectrum::{Power, Spectrum};
use core::marker::PhantomData;

/// Light that can make matter glow: power on the grid of the matter. What leaves the matter counts as
/// unpolarized.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot make matter fluoresce",
    label = "no light of `Power` in {N} bins of `{G}`",
    note = "an eye that has the light folded in cannot see fluorescence any more, since each bin of light changes \
            many of the eye's: fold the matter in first, `eye.looking_at_dye(&dye).under(&lamp)`"
)]
pub trait Excites<const N: usize, G> {
    /// The light as plain power.
    type Light: Stimulus<Power, N, G>;

    /// The light as plain power.
    fn into_light(self) -> Self::Light;
}

impl<P: Stimulus<Power, N, G>, const N: usize, G> Excites<N, G> for Plain<Power, P> {
    type Light = P;

    #[inline]
    fn into_light(self) -> P {
        self.into_inner()
    }
}

impl<P: StokesPath<N, G>, const N: usize, G> Excites<N, G> for Stokes<P> {
    type Light = IgnoringPolarization<P>;

    #[inline]
    fn into_light(self) -> IgnoringPolarization<P> {
        self.ignoring_polarization().into_inner()
    }
}

/// Light `L` after matter `M` that adds its own: `glow` times its emission.
#[derive(Clone, Copy, Debug)]
pub struct Glowing<L, M> {
    light: L,
    matter: M,
    glow: f32,
}

impl<'m, L, M> Glowing<L, &'m M> {
    #[inline]
    fn new<const N: usize, G>(light: L, matter: &'m M) -> Self
    where
        L: Stimulus<Power, N, G>,
        M: Glows<N, G>,
    {
        let glow = light.read(|light| matter.glow_in(light));
        Glowing { light, matter, glow }
    }
}

impl<L: Priced, const N: usize, G> Priced for Glowing<L, &Dye<N, G>> {
    const PRICE: Price = L::PRICE.plus(Dye::<N, G>::PRICE).and_multiply_adds(L::AGAIN);
    const AGAIN: usize = L::AGAIN + Dye::<N, G>::AGAIN;
}

/// The light is read once: the glow is there without it.
impl<L: Priced, const N: usize, G> Priced for Glowing<L, &Phosphor<N, G>> {
    const PRICE: Price = L::PRICE.plus(Phosphor::<N, G>::PRICE);
    const AGAIN: usize = L::AGAIN + Phosphor::<N, G>::AGAIN;
}

impl<L: Stimulus<Power, N, G>, M: Glows<N, G>, const N: usize, G> Stimulus<Power, N, G> for Glowing<L, &M> {
    #[inline]
    fn at(&self, k: usize) -> f32 {
        self.matter.leaving_bin(k, self.light.at(k), self.glow)
    }
}

/// Light `L` after matter `M` that moves it between bins. All bins are worked out at once, since each needs
/// all of `L`.
pub struct Affected<L, M, const N: usize, G> {
    light: Spectrum<Power, N, G>,
    from: PhantomData<(L, M)>,
}

by_fields!([L, M, const N: usize, G] Affected<L, M, N, G>, "Affected": light);

impl<'m, L: Stimulus<Power, N, G>, M: Effect<N, G> + ?Sized, const N: usize, G> Affected<L, &'m M, N, G> {
    #[inline]
    fn new(light: L, matter: &'m M) -> Self {
        Affected { light: light.read(|light| matter.leaving(light)), from: PhantomData }
    }
}

impl<L: Priced, M: Priced, const N: usize, G> Priced for Affected<L, M, N, G> {
    const PRICE: Price = L::PRICE.plus(M::PRICE);
    const AGAIN: usize = 0;
}

impl<L, M, const N: usize, G> Stimulus<Power, N, G> for Affected<L, M, N, G> {
    #[inline]
    fn at(&self, k: usize) -> f32 {
        (&self.light).at(k)
    }

    #[inline]
    fn read<R>(&self, reader: impl FnOnce(&Spectrum<Power, N, G>) -> R) -> R {
        reader(&self.light)
    }
}

/// An [`Effect`] of your own as a part of a path, for light to fall on or to go through:
/// `sun.onto(Own::new(&ink))`. If the matter has a price ([`Priced`]), the path has one.
#[derive(Debug)]
pub struct Own<'m, M: ?Sized, const N: usize, G = Bins<380, 730>>(pub(super) &'m M, PhantomData<G>);

impl<M: ?Sized, const N: usize, G> Clone for Own<'_, M, N, G> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: ?Sized, const N: usize, G> Copy for Own<'_, M, N, G> {}

impl<'m, M: Effect<N, G> + ?Sized, const N: usize, G> Own<'m, M, N, G> {
    /// A part of a path that does to light what `matter` does.
    #[must_use]
    pub const fn new(matter: &'m M) -> Self {
        Own(matter, PhantomData)
    }
}

impl<'m, L: Excites<N, G>, M: Effect<N, G> + ?Sized, const N: usize, G> Surface<L> for Own<'m, M, N, G> {
    type Leaving = Plain<Power, Affected<L::Light, &'m M, N, G>>;

    #[inline]
    fn reflect(self, light: L) -> Self::Leaving {
        Plain::new(Affected::new(light.into_light(), self.0))
    }
}

/// Plain light only: what clear matter leaves of the polarization of light that goes through it is not in its
/// numbers.
impl<'m, Q, P, M: Effect<N, G> + ?Sized, const N: usize, G> Filter<Plain<Q, P>> for Own<'m, M, N, G>
where
    Plain<Q, P>: Excites<N, G>,
{
    type Leaving = <Self as Surface<Plain<Q, P>>>::Leaving;

    #[inline]
    fn transmit(self, light: Plain<Q, P>) -> Self::Leaving {
        self.reflect(light)
    }
}

/// Matter of this crate stands in a path by itself. (Were it implemented for all `&M`, the compiler's
/// messages about spectra would no longer name grids.)
macro_rules! by_themselves {
    ($([$($generics:tt)*] $matter:ty => $leaving:ident $(, $more:ident)*;)*) => {$(
        impl<'m, L: Excites<N, G>, $($generics)*> Surface<L> for &'m $matter {
            type Leaving = Plain<Power, $leaving<L::Light, &'m $matter $(, $more)*>>;

            #[inline]
            fn reflect(self, light: L) -> Self::Leaving {
                Plain::new($leaving::new(light.into_light(), self))
            }
        }

        impl<'m, Q, L, $($generics)*> Filter<Plain<Q, L>> for &'m $matter
        where
            Plain<Q, L>: Excites<N, G>,
        {
            type Leaving = <Self as Surface<Plain<Q, L>>>::Leaving;

            #[inline]
            fn transmit(self, light: Plain<Q, L>) -> Self::Leaving {
                self.reflect(light)
            }
        }

        impl<'m, $($generics)*> IntoPart<'m, N, G> for &'m $matter
        where
            $matter: Foldable<N, G>,
        {
            fn into_part(self) -> Part<'m, N, G> {
                Part::Effect(self)
            }
        }
    )*};
}

by_themselves! {
    [const N: usize, G] Dye<N, G> => Glowing;
    [const N: usize, G] Phosphor<N, G> => Glowing;
    [const N: usize, const P: usize, G] Donaldson<N, P, G> => Affected, N, G;
}
