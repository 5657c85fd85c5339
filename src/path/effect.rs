//! Fluorescent matter and effects of a user's own as surfaces and filters of a path, for every [`Effect`].

use crate::grid::{Bins, by_fields};
use crate::matter::{Donaldson, Dye, Effect, Foldable, Glows, Phosphor};
use crate::observer::Stimulus;
use crate::path::{
    Filter, IgnoringPolarization, IntoPart, Part, Plain, Price, Priced, Stokes, StokesPath, Surface,
};
use crate::spectrum::{Power, Spectrum};
use core::marker::PhantomData;

/// Types of light that can make matter fluoresce: paths of power on the grid of the matter.
///
/// Plain and polarized light implement it. What leaves the matter counts as unpolarized. There is nothing to
/// call here: [`Plain::onto`] and [`Stokes::onto`] use this trait to accept fluorescent matter; see the
/// [example](Dye) of a dye.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot make matter fluoresce",
    label = "no light of `Power` in {N} bins of `{G}`",
    note = "an eye that has the light folded in cannot see fluorescence any more, since each bin of light \
            changes many of the eye's: fold the matter in first, `eye.looking_at_dye(&dye).under(&lamp)`"
)]
pub trait Excites<const N: usize, G> {
    /// The path that gives the same light as plain power, one number for each bin.
    type Light: Stimulus<Power, N, G>;

    /// Returns the light as plain power, without its polarization if it has any.
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

/// A path stage in which light `L` has met matter `M` that emits one spectrum, whatever light excites it.
///
/// [`Plain::onto`] and [`Plain::through`] make it of a [`Dye`] or a [`Phosphor`]. How much the matter emits
/// is computed when the stage is made; the bins are computed when they are read.
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

/// The light is read only once, since what a phosphor emits at an instant does not depend on the light of
/// that instant.
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

/// A path stage in which light `L` has met matter `M` that moves light from any bin to any other.
///
/// [`Plain::onto`] and [`Plain::through`] make it of a [`Donaldson`] matrix or of an effect of your own
/// ([`Own`]). All bins are computed when the stage is made, since each depends on all of `L`.
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

/// Wraps an [`Effect`] of your own, so that it can stand in a path or in a [`Scene`](crate::path::Scene).
///
/// Make it by [`Own::new`], and let light fall on it or go through it. If the matter has a price
/// ([`Priced`]), the path has one. For a scene, and to fold the effect into an observer, the matter has to be
/// linear in the light, which it says by implementing [`Foldable`].
///
/// # Example
/// ```
/// use nanospectra::matter::{Effect, Foldable};
/// use nanospectra::observer::CIE_1931;
/// use nanospectra::path::Own;
/// use nanospectra::{Curve, Light, Observer, Power};
///
/// /// An ink that absorbs half of the light and emits a tenth of what it absorbs evenly over all bins.
/// struct Ink;
///
/// impl Effect<31> for Ink {
///     fn leaving(&self, light: &Light<31>) -> Light<31> {
///         let absorbed: f32 = light.values().iter().map(|power| 0.5 * power).sum();
///         *light * 0.5 + Light::flat(0.1 * absorbed / 31.0)
///     }
/// }
///
/// impl Foldable<31> for Ink {}
///
/// static EYE: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);
/// let sun = Light::flat(1.0);
/// let [_, y, _] = EYE.sees(sun.onto(Own::new(&Ink)));
/// // Of flat light half is reflected, and a tenth of the other half is emitted.
/// assert!((y / EYE.sees(&sun)[1] - 0.55).abs() < 1e-6);
/// // The same by an observer that the ink is folded into.
/// assert!((y - EYE.looking_at_matter(&Ink).sees(&sun)[1]).abs() < 1e-4);
/// ```
#[derive(Debug)]
pub struct Own<'m, M: ?Sized, const N: usize, G = Bins<380, 730>>(pub(super) &'m M, PhantomData<G>);

impl<M: ?Sized, const N: usize, G> Clone for Own<'_, M, N, G> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: ?Sized, const N: usize, G> Copy for Own<'_, M, N, G> {}

impl<'m, M: Effect<N, G> + ?Sized, const N: usize, G> Own<'m, M, N, G> {
    /// Wraps a reference to `matter` as a part of a path. See the [example](#example).
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

/// Only plain light can go through it. An effect does not say how much of the polarization of light is left
/// behind clear matter.
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

/// Makes references to fluorescent matter of this crate surfaces, filters and parts of scenes, without
/// [`Own`]. (An implementation for all `&M` would take the grids out of the compiler's messages about
/// spectra.)
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
