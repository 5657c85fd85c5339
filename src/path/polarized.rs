//! Polarized light on its way, as Stokes vectors.

use crate::matter::{Mirror, Mueller, Polarizer, Retarder};
use crate::observer::Stimulus;
use crate::path::on_its_way::on_its_way;
use crate::path::{Effects, Filter, IntoPart, Part, Plain, Price, Priced, Surface, Times};
use crate::spectrum::{Factor, Power, Spectrum};

/// Types of stages that give a Stokes vector for each of `N` bins of the grid `G`.
///
/// Implement it for a source of polarized light of your own, and start a path with it by [`Stokes::new`].
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no path of polarized light in {N} bins of `{G}`",
    note = "all stages lie on one grid"
)]
pub trait StokesPath<const N: usize, G> {
    /// How much one mirror, polarizer or retarder adds to the price of the path.
    const TURNED: Price = Mueller::<N, G>::PRICE;

    /// Returns the Stokes parameters I, Q, U and V of bin `k`, which are NaN beyond the last bin.
    fn stokes_at(&self, k: usize) -> [f32; 4];

    /// Returns the Stokes parameters of bin `k` after the light has met the mirror, polarizer or retarder
    /// with this Mueller matrix.
    #[inline]
    fn turned_at(&self, k: usize, element: &Mueller<N, G>) -> [f32; 4] {
        element.turn(k, self.stokes_at(k))
    }
}

/// Types of light whose polarization is known, as mirrors, polarizers and retarders need it.
///
/// [`Stokes`] light implements it. There is nothing to call here: mirrors, polarizers and retarders accept
/// the light that implements it; see the [example](Stokes#example).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not polarized light in {N} bins of `{G}`",
    label = "needs polarized light",
    note = "write `light.polarized()` first, where the light is still unpolarized",
    note = "or leave the effect out by name: `.onto(&mirror.ignoring_polarization())`"
)]
pub trait Polarized<const N: usize, G> {
    /// The type of the stages, which give Stokes vectors.
    type Light: StokesPath<N, G>;

    /// Returns the stages, which give Stokes vectors.
    fn into_stokes(self) -> Self::Light;
}

impl<P: StokesPath<N, G>, const N: usize, G> Polarized<N, G> for Stokes<P> {
    type Light = P;

    #[inline]
    fn into_stokes(self) -> P {
        self.0
    }
}

/// Polarized light that has passed through the stages `P` of a path, one Stokes vector (I, Q, U, V) in the
/// unit of the light for each bin.
///
/// `light.polarized()` makes it. Go on with [`through`](Self::through) and [`onto`](Self::onto), and make it
/// plain again by [`ignoring_polarization`](Self::ignoring_polarization) for an observer. Apart from
/// fluorescence, nothing is computed before it is read.
///
/// Angles of polarization are measured from a reference direction across the beam, which you choose,
/// counterclockwise as seen by somebody who looks towards the source. Light along the reference has Q > 0,
/// and light at 45 degrees to it U > 0. A mirror does not turn the reference: whatever follows a mirror is
/// described as it is seen in that mirror, so a mirror at normal incidence dims all four numbers alike.
///
/// # Example
/// ```
/// use nanospectra::matter::Polarizer;
/// use nanospectra::{Bins, Light};
///
/// type Grid = Bins<400, 700>;
/// // Two ideal polarizers at an angle of 45 degrees (an eighth of a turn).
/// let (first, second) = (Polarizer::<3, Grid>::ideal(0.0), Polarizer::ideal(0.125));
/// let lamp = Light::<3, Grid>::flat(1.0);
/// let light = lamp.polarized().through(&first).through(&second);
/// // The first passes half of the light, and by Malus's law the second passes cos^2(45 degrees) of that.
/// let [i, q, u, v] = light.stokes_at(0);
/// assert!((i - 0.25).abs() < 1e-6 && q.abs() < 1e-6 && (u - 0.25).abs() < 1e-6 && v.abs() < 1e-6);
/// let seen: Light<3, Grid> = light.ignoring_polarization().collected();
/// assert!((seen.values()[0] - 0.25).abs() < 1e-6);
/// ```
///
/// # Accuracy
/// Each mirror, polarizer or retarder adds an error of 3e-7 of the light that meets it. I is not smaller than
/// the root of Q^2 + U^2 + V^2 by more than that (`tests/matter/polarization.rs`). Where almost all light is
/// extinguished, the same error is a larger part of what remains.
#[derive(Clone, Copy, Debug)]
pub struct Stokes<P>(P);

on_its_way! { [P] Stokes<P>, |path| Stokes(path) }

impl<P> Stokes<P> {
    /// Returns the intensity alone, as an observer or a sensor reads it.
    ///
    /// Stages that follow treat the light as unpolarized. See the [example](#example).
    #[must_use]
    #[inline]
    pub fn ignoring_polarization(self) -> Plain<Power, IgnoringPolarization<P>> {
        Plain::new(IgnoringPolarization(self.0))
    }

    /// Returns the Stokes parameters I, Q, U and V of bin `k`, which are NaN beyond the last bin.
    ///
    /// See the [example](#example).
    #[must_use]
    #[inline]
    pub fn stokes_at<const N: usize, G>(&self, k: usize) -> [f32; 4]
    where
        P: StokesPath<N, G>,
    {
        self.0.stokes_at(k)
    }
}

/// A path stage that gives unpolarized light as Stokes vectors, in which Q, U and V are zero.
///
/// [`Plain::polarized`] makes it.
#[derive(Clone, Copy, Debug)]
pub struct Natural<P>(pub(super) P);

impl<P: Priced> Priced for Natural<P> {
    const PRICE: Price = P::PRICE.plus(Price { effects: Effects::POLARIZATION, ..Price::NONE });
    const AGAIN: usize = P::AGAIN;
}

impl<P: Stimulus<Power, N, G>, const N: usize, G> StokesPath<N, G> for Natural<P> {
    const TURNED: Price = Mueller::<N, G>::PRICE_OF_NATURAL;

    #[inline]
    fn stokes_at(&self, k: usize) -> [f32; 4] {
        [self.0.at(k), 0.0, 0.0, 0.0]
    }

    #[inline]
    fn turned_at(&self, k: usize, element: &Mueller<N, G>) -> [f32; 4] {
        element.turn_natural(k, self.0.at(k))
    }
}

/// A path stage in which all four numbers of Stokes light `L` are multiplied by a factor `F` of a filter.
///
/// [`Stokes::through`] makes it of a spectrum of factors.
#[derive(Clone, Copy, Debug)]
pub struct Dimmed<L, F> {
    light: L,
    factors: F,
}

impl<L: Priced, const N: usize, G> Priced for Dimmed<L, &Spectrum<Factor, N, G>> {
    const PRICE: Price = L::PRICE.plus(Price::factor(N)).and_multiply_adds(3 * N);
    const AGAIN: usize = L::AGAIN + 4 * N;
}

impl<L: StokesPath<N, G>, const N: usize, G> StokesPath<N, G> for Dimmed<L, &Spectrum<Factor, N, G>> {
    #[inline]
    fn stokes_at(&self, k: usize) -> [f32; 4] {
        let factor = self.factors.at(k);
        self.light.stokes_at(k).map(|value| value * factor)
    }
}

/// Colored glass dims all polarizations alike.
impl<'m, P: StokesPath<N, G>, const N: usize, G> Filter<Stokes<P>> for &'m Spectrum<Factor, N, G> {
    type Leaving = Stokes<Dimmed<P, &'m Spectrum<Factor, N, G>>>;

    #[inline]
    fn transmit(self, light: Stokes<P>) -> Self::Leaving {
        Stokes(Dimmed { light: light.0, factors: self })
    }
}

/// A matt surface scatters light back unpolarized.
impl<'m, P: StokesPath<N, G>, const N: usize, G> Surface<Stokes<P>> for &'m Spectrum<Factor, N, G> {
    type Leaving = Plain<Power, Times<IgnoringPolarization<P>, &'m Spectrum<Factor, N, G>>>;

    #[inline]
    fn reflect(self, light: Stokes<P>) -> Self::Leaving {
        self.reflect(light.ignoring_polarization())
    }
}

/// A path stage in which Stokes light `L` has met a mirror, polarizer or retarder with Mueller matrix `M`.
///
/// [`Stokes::onto`] and [`Stokes::through`] make it.
#[derive(Clone, Copy, Debug)]
pub struct Turned<L, M> {
    light: L,
    element: M,
}

impl<L: StokesPath<N, G> + Priced, const N: usize, G> Priced for Turned<L, &Mueller<N, G>> {
    const PRICE: Price = L::PRICE.plus(L::TURNED);
    const AGAIN: usize = L::AGAIN + L::TURNED.multiply_adds;
}

impl<L: StokesPath<N, G>, const N: usize, G> StokesPath<N, G> for Turned<L, &Mueller<N, G>> {
    #[inline]
    fn stokes_at(&self, k: usize) -> [f32; 4] {
        self.light.turned_at(k, self.element)
    }
}

/// Makes references to matter with a Mueller matrix surfaces or filters of polarized light, and parts of
/// scenes.
macro_rules! elements {
    ($($element:ident, $name:literal: $kind:ident by $function:ident;)*) => {$(
        impl<'m, L: Polarized<N, G>, const N: usize, G> $kind<L> for &'m $element<N, G> {
            type Leaving = Stokes<Turned<L::Light, &'m Mueller<N, G>>>;

            #[inline]
            fn $function(self, light: L) -> Self::Leaving {
                Stokes(Turned { light: light.into_stokes(), element: self.mueller() })
            }
        }

        impl<'m, const N: usize, G> IntoPart<'m, N, G> for &'m $element<N, G> {
            fn into_part(self) -> Part<'m, N, G> {
                Part::Polarizing { name: $name, mueller: self.mueller() }
            }
        }
    )*};
}

elements! {
    Mirror, "mirror": Surface by reflect;
    Polarizer, "polarizer": Filter by transmit;
    Retarder, "retarder": Filter by transmit;
}

/// A path stage that gives the intensity of Stokes light `P` and ignores its polarization.
///
/// [`Stokes::ignoring_polarization`] makes it.
#[derive(Clone, Copy, Debug)]
pub struct IgnoringPolarization<P>(P);

impl<P: Priced> Priced for IgnoringPolarization<P> {
    const PRICE: Price = P::PRICE;
    const AGAIN: usize = P::AGAIN;
}

impl<P: StokesPath<N, G>, const N: usize, G> Stimulus<Power, N, G> for IgnoringPolarization<P> {
    #[inline]
    fn at(&self, k: usize) -> f32 {
        let [intensity, ..] = self.0.stokes_at(k);
        intensity
    }
}
