//! Unpolarized light on its way, with one number for each bin.

use crate::observer::Stimulus;
use crate::path::on_its_way::on_its_way;
use crate::path::{Filter, Natural, Stokes, Surface};
use crate::price::{Price, Priced};
use crate::spectrum::{Factor, Power, Spectrum};
use core::marker::PhantomData;

impl<Q, const N: usize, G> Priced for Spectrum<Q, N, G> {
    const PRICE: Price = Price::light(N);
}

/// A path stage in which each bin of light `L` is multiplied by a factor `F` of a filter or surface.
///
/// [`Plain::through`] and [`Plain::onto`] make it of a spectrum of factors. Its bins are computed when they
/// are read.
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

/// Unpolarized light that has passed through the stages `P` of a path, one number of the quantity `Q` for
/// each bin.
///
/// `light.through(&filter)` and `light.onto(&surface)` make it. Go on with [`through`](Self::through) and
/// [`onto`](Self::onto), and show it to an observer ([`Observer::sees`](crate::Observer::sees)) or
/// [collect](Self::collected) it to a spectrum. Apart from fluorescence, nothing is computed before that.
///
/// `Q` is [`Power`] for a path that starts with a light. For a path that starts with a reflectance it is
/// [`Factor`]; an observer sees such a path if a light has been folded into it
/// ([`Observer::under`](crate::Observer::under)).
///
/// # Example
/// ```
/// use nanospectra::{Light, Reflectance};
/// let (sun, glass, paper) = (Light::<31>::flat(1.0), Reflectance::flat(0.5), Reflectance::flat(0.8));
/// let path = sun.through(&glass).onto(&paper).through(&glass);
/// let reflected: Light<31> = path.collected();
/// assert!((reflected.values()[0] - 0.5 * 0.8 * 0.5).abs() < 1e-7);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Plain<Q, P>(P, PhantomData<Q>);

on_its_way! { [Q, P] Plain<Q, P>, |path| Plain(path, PhantomData) }

impl<Q, P> Plain<Q, P> {
    /// Computes all bins once and returns them as a spectrum, for light that is read more than once.
    ///
    /// See the [example](#example).
    #[must_use]
    #[inline]
    pub fn collected<const N: usize, G>(&self) -> Spectrum<Q, N, G>
    where
        P: Stimulus<Q, N, G>,
    {
        self.0.read(|light| *light)
    }
}

impl<P> Plain<Power, P> {
    /// Returns the same light, which is unpolarized so far, as Stokes vectors, so that mirrors, polarizers
    /// and retarders can follow.
    ///
    /// See the [example](Stokes#example).
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
    /// Starts a [path](crate::path) with this light and the filter that it goes through first.
    ///
    /// See the [example](crate::path#example).
    #[must_use]
    #[inline]
    pub fn through<'a, F: Filter<Plain<Q, &'a Self>>>(&'a self, filter: F) -> F::Leaving {
        filter.transmit(Plain::new(self))
    }

    /// Starts a [path](crate::path) with this light and the surface that it falls on first.
    ///
    /// See the [example](crate::path#example).
    #[must_use]
    #[inline]
    pub fn onto<'a, S: Surface<Plain<Q, &'a Self>>>(&'a self, surface: S) -> S::Leaving {
        surface.reflect(Plain::new(self))
    }
}

impl<const N: usize, G> Spectrum<Power, N, G> {
    /// Starts a [path](crate::path) of polarized light with this unpolarized light.
    ///
    /// See the [example](Stokes#example).
    #[must_use]
    #[inline]
    pub fn polarized(&self) -> Stokes<Natural<&Self>> {
        Stokes::new(Natural(self))
    }
}
