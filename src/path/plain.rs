//! Light with one number for each bin.

use crate::observer::Path;
use crate::path::{Filter, Natural, Stokes, Surface};
use crate::price::{Price, Priced};
use crate::spectrum::{Factor, Power, Spectrum};
use core::marker::PhantomData;

impl<Q, const N: usize, G> Priced for Spectrum<Q, N, G> {
    const PRICE: Price = Price::light(N);
}

/// Light `L` dimmed by the factors `F` of a filter or surface; worked out when it is read.
#[derive(Clone, Copy, Debug)]
pub struct Times<L, F> {
    light: L,
    factors: F,
}

impl<L, F> Times<L, F> {
    #[inline]
    pub(super) const fn new(light: L, factors: F) -> Self {
        Times { light, factors }
    }
}

impl<L: Priced, const N: usize, G> Priced for Times<L, &Spectrum<Factor, N, G>> {
    const PRICE: Price = L::PRICE.plus(Price::factor(N));
    const AGAIN: usize = L::AGAIN + N;
}

impl<Q, L: Path<Q, N, G>, const N: usize, G> Path<Q, N, G> for Times<L, &Spectrum<Factor, N, G>> {
    #[inline]
    fn at(&self, k: usize) -> f32 {
        self.light.at(k) * self.factors.at(k)
    }
}

/// Light on its way: the quantity `Q`, by way of the stages in `P`. Nothing is worked out before it is read.
///
/// `Q` is [`Power`] for a path that starts with a light. One that starts with a reflectance has `Factor`, and is for
/// an eye that has the light folded in.
#[derive(Clone, Copy, Debug)]
pub struct Plain<Q, P>(P, PhantomData<Q>);

impl<Q, P> Plain<Q, P> {
    /// Light by way of `path`: to begin with something other than a spectrum.
    #[must_use]
    #[inline]
    pub const fn new(path: P) -> Self {
        Plain(path, PhantomData)
    }

    /// The path by itself: for those who write a [`Surface`] or a [`Filter`].
    #[must_use]
    #[inline]
    pub fn into_inner(self) -> P {
        self.0
    }

    /// This light behind a filter.
    #[must_use]
    #[inline]
    pub fn through<F: Filter<Self>>(self, filter: F) -> F::Leaving {
        filter.transmit(self)
    }

    /// What a surface sends back of this light.
    #[must_use]
    #[inline]
    pub fn onto<S: Surface<Self>>(self, surface: S) -> S::Leaving {
        surface.reflect(self)
    }

    /// All bins worked out, to be read more than once.
    #[must_use]
    #[inline]
    pub fn collected<const N: usize, G>(&self) -> Spectrum<Q, N, G>
    where
        P: Path<Q, N, G>,
    {
        self.0.read(|bins| Spectrum::unchecked(*bins))
    }

    /// What evaluating this path once costs.
    #[must_use]
    pub const fn price(&self) -> Price
    where
        P: Priced,
    {
        P::PRICE
    }

    /// This path, if it takes at most `MULTIPLY_ADDS` multiplications; a longer one does not compile (it is
    /// `cargo build` that says so, and `cargo check` does not).
    ///
    /// ```
    /// # use nanospectra::{Light, Reflectance};
    /// # let (sun, paper) = (Light::<31>::flat(1.0), Reflectance::flat(0.8));
    /// let path = sun.onto(&paper).within::<31>();
    /// ```
    /// ```compile_fail,E0080
    /// # use nanospectra::{Light, Reflectance};
    /// # let (sun, paper) = (Light::<31>::flat(1.0), Reflectance::flat(0.8));
    /// let path = sun.onto(&paper).within::<30>();
    /// ```
    #[must_use]
    #[inline]
    pub fn within<const MULTIPLY_ADDS: usize>(self) -> Self
    where
        P: Priced,
    {
        const { assert!(P::PRICE.multiply_adds <= MULTIPLY_ADDS, "this path takes more multiply-adds than it may") }
        self
    }
}

impl<P> Plain<Power, P> {
    /// The same light, followed as Stokes vectors from here on: so far it is unpolarized.
    #[must_use]
    #[inline]
    pub fn polarized(self) -> Stokes<Natural<P>> {
        Stokes::new(Natural::new(self.0))
    }
}

impl<Q, P: Priced> Priced for Plain<Q, P> {
    const PRICE: Price = P::PRICE;
    const AGAIN: usize = P::AGAIN;
}

impl<Q, P: Path<Q, N, G>, const N: usize, G> Path<Q, N, G> for Plain<Q, P> {
    #[inline]
    fn at(&self, k: usize) -> f32 {
        self.0.at(k)
    }

    #[inline]
    fn read<R>(&self, reader: impl FnOnce(&[f32; N]) -> R) -> R {
        self.0.read(reader)
    }
}

impl<Q, const N: usize, G> Spectrum<Q, N, G> {
    /// This light behind a filter: the beginning of a [path](crate::path).
    #[must_use]
    #[inline]
    pub fn through<'a, F: Filter<Plain<Q, &'a Self>>>(&'a self, filter: F) -> F::Leaving {
        filter.transmit(Plain::new(self))
    }

    /// What a surface sends back of this light: the beginning of a [path](crate::path).
    #[must_use]
    #[inline]
    pub fn onto<'a, S: Surface<Plain<Q, &'a Self>>>(&'a self, surface: S) -> S::Leaving {
        surface.reflect(Plain::new(self))
    }
}

impl<const N: usize, G> Spectrum<Power, N, G> {
    /// This light, followed as Stokes vectors from here on: so far it is unpolarized.
    #[must_use]
    #[inline]
    pub fn polarized(&self) -> Stokes<Natural<&Self>> {
        Stokes::new(Natural::new(self))
    }
}
