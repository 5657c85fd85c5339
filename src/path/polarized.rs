//! Light as Stokes vectors.

use crate::matter::{Mirror, Mueller, Polarizer, Retarder};
use crate::observer::Stimulus;
use crate::path::on_its_way::on_its_way;
use crate::path::{Effects, Filter, IntoPart, Part, Plain, Price, Priced, Surface, Times};
use crate::spectrum::{Factor, Power, Spectrum};

/// A path of Stokes vectors, in `N` bins of the grid `G`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no path of polarized light in {N} bins of `{G}`",
    note = "all stages lie on one grid"
)]
pub trait StokesPath<const N: usize, G> {
    /// What one element after it costs.
    const TURNED: Price = Mueller::<N, G>::PRICE;

    /// I, Q, U and V of bin `k`; NaN beyond the last.
    fn stokes_at(&self, k: usize) -> [f32; 4];

    /// The same after an element.
    #[inline]
    fn turned_at(&self, k: usize, element: &Mueller<N, G>) -> [f32; 4] {
        element.turn(k, self.stokes_at(k))
    }
}

/// Light whose polarization is known: what mirrors, polarizers and retarders need.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not polarized light in {N} bins of `{G}`",
    label = "needs polarized light",
    note = "write `light.polarized()` first, where the light is still unpolarized",
    note = "or leave the effect out by name: `.onto(&mirror.ignoring_polarization())`"
)]
pub trait Polarized<const N: usize, G> {
    /// The path of Stokes vectors.
    type Light: StokesPath<N, G>;

    /// The path of Stokes vectors.
    fn into_stokes(self) -> Self::Light;
}

impl<P: StokesPath<N, G>, const N: usize, G> Polarized<N, G> for Stokes<P> {
    type Light = P;

    #[inline]
    fn into_stokes(self) -> P {
        self.0
    }
}

/// Light on its way as Stokes vectors (I, Q, U, V) in the unit of the light, by way of the stages in `P`.
/// Nothing is worked out before it is read.
///
/// Directions across the beam are angles from a reference direction that the user chooses, counterclockwise
/// for who looks at the source. The path is *unfolded*: what follows a mirror is named as it is seen in that
/// mirror. Q > 0 along the reference, U > 0 at 45 degrees. So a mirror met at right angles only dims all
/// four.
///
/// # Accuracy
/// 3e-7 of the light that meets it, for each element; I is at least the root of Q^2 + U^2 + V^2 to within
/// that (`tests/matter/polarization.rs`). Next to extinction, where a difference is left, that is more of
/// what is left.
#[derive(Clone, Copy, Debug)]
pub struct Stokes<P>(P);

impl<P> Stokes<P> {
    /// The intensity alone, as an eye or a sensor reads it. What comes after this treats the light as
    /// unpolarized.
    #[must_use]
    #[inline]
    pub fn ignoring_polarization(self) -> Plain<Power, IgnoringPolarization<P>> {
        Plain::new(IgnoringPolarization(self.0))
    }

    /// I, Q, U and V of bin `k`; NaN beyond the last.
    #[must_use]
    #[inline]
    pub fn stokes_at<const N: usize, G>(&self, k: usize) -> [f32; 4]
    where
        P: StokesPath<N, G>,
    {
        self.0.stokes_at(k)
    }
}

on_its_way! { [P] Stokes<P>, |path| Stokes(path) }

/// Unpolarized light as Stokes vectors: I, 0, 0, 0.
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

/// Stokes light `L` dimmed by the factors `F` of a filter, all four numbers alike.
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

/// Colored glass: it dims all polarizations alike.
impl<'m, P: StokesPath<N, G>, const N: usize, G> Filter<Stokes<P>> for &'m Spectrum<Factor, N, G> {
    type Leaving = Stokes<Dimmed<P, &'m Spectrum<Factor, N, G>>>;

    #[inline]
    fn transmit(self, light: Stokes<P>) -> Self::Leaving {
        Stokes(Dimmed { light: light.0, factors: self })
    }
}

/// A matt surface: what it scatters back has forgotten how it was polarized.
impl<'m, P: StokesPath<N, G>, const N: usize, G> Surface<Stokes<P>> for &'m Spectrum<Factor, N, G> {
    type Leaving = Plain<Power, Times<IgnoringPolarization<P>, &'m Spectrum<Factor, N, G>>>;

    #[inline]
    fn reflect(self, light: Stokes<P>) -> Self::Leaving {
        self.reflect(light.ignoring_polarization())
    }
}

/// Stokes light `L` after the element `M`.
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

/// What can be done with an element of a Mueller matrix: light falls on it or goes through it, and a scene
/// holds it.
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

/// The intensity of Stokes light `P`, its polarization ignored.
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
