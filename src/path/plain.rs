//! Light with one number for each bin.

use crate::observer::Stimulus;
use crate::path::on_its_way::on_its_way;
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
    pub(super) light: L,
    pub(super) factors: F,
}

impl<L: Priced, const N: usize, G> Priced for Times<L, &Spectrum<Factor, N, G>> {
    const PRICE: Price = L::PRICE.plus(Price::factor(N));
    const AGAIN: usize = L::AGAIN + N;
}

impl<Q, L: Stimulus<Q, N, G>, const N: usize, G> Stimulus<Q, N, G> for Times<L, &Spectrum<Factor, N, G>> {
    #[inline]
    fn at(&self, k: usize) -> f32 {
        self.light.at(k) * self.factors.at(k)
    }
}

/// Light on its way: the quantity `Q`, by way of the stages in `P`. Nothing is worked out before it is read.
///
/// `Q` is [`Power`] for a path that starts with a light, and `Factor` for one that starts with a reflectance,
/// which is for an eye that has the light folded in.
#[derive(Clone, Copy, Debug)]
pub struct Plain<Q, P>(P, PhantomData<Q>);

impl<Q, P> Plain<Q, P> {
    /// Works out all bins, once, to a spectrum that can be read more than once.
    #[must_use]
    #[inline]
    pub fn collected<const N: usize, G>(&self) -> Spectrum<Q, N, G>
    where
        P: Stimulus<Q, N, G>,
    {
        self.0.read(|light| *light)
    }
}

on_its_way! { [Q, P] Plain<Q, P>, |path| Plain(path, PhantomData) }

impl<P> Plain<Power, P> {
    /// The same light, followed as Stokes vectors from here on: so far it is unpolarized.
    #[must_use]
    #[inline]
    pub fn polarized(self) -> Stokes<Natural<P>> {
        Stokes::new(Natural(self.0))
    }
}

impl<Q, P: Stimulus<Q, N, G>, const N: usize, G> Stimulus<Q, N, G> for Plain<Q, P> {
    #[inline]
    fn at(&self, k: usize) -> f32 {
        self.0.at(k)
    }

    #[inline]
    fn read<R>(&self, reader: impl FnOnce(&Spectrum<Q, N, G>) -> R) -> R {
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
        Stokes::new(Natural(self))
    }
}
