//! Light as Stokes vectors.

use crate::matter::{Mirror, Mueller, Polarizer, Retarder};
use crate::observer::Path;
use crate::path::{Effects, Filter, Plain, Price, Priced, Surface, Times};
use crate::spectrum::{Factor, Power, Spectrum};

/// A path of Stokes vectors, in `N` bins of the grid `G`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no path of polarized light in {N} bins of `{G}`",
    note = "all stages lie on one grid"
)]
pub trait StokesPath<const N: usize, G> {
    /// The multiplications that one element after it takes.
    const TURNED: usize = Mueller::<N, G>::PRICE.multiply_adds;

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

/// Light on its way as Stokes vectors (I, Q, U, V), by way of the stages in `P`: radiometric, in the unit of the
/// light. Nothing is worked out before it is read, and then only what reaches the eye.
///
/// Directions across the beam are angles from a reference direction that the user chooses, counter-clockwise for who
/// looks at the source, along the *unfolded* path: what follows a mirror is named as it is seen in that mirror, as in
/// a drawing that is straightened out. Q > 0 along the reference, U > 0 at 45 degrees. So a mirror met at right
/// angles, which has no plane of incidence, leaves all four as they are but for its reflectance.
///
/// # Accuracy
/// 3e-7 of the light that meets it, for each element; I is at least the root of Q^2 + U^2 + V^2 to within that
/// (`tests/matter/polarization.rs`). Next to extinction, where a difference is left, that is more of what is left.
#[derive(Clone, Copy, Debug)]
pub struct Stokes<P>(P);

impl<P> Stokes<P> {
    /// Light by way of `path`: to begin with something other than unpolarized light.
    #[must_use]
    #[inline]
    pub const fn new(path: P) -> Self {
        Stokes(path)
    }

    /// The path by itself: for those who write a [`Surface`] or a [`Filter`].
    #[must_use]
    #[inline]
    pub fn into_inner(self) -> P {
        self.0
    }

    /// This light behind a filter. Colored glass dims I, Q, U and V alike.
    #[must_use]
    #[inline]
    pub fn through<F: Filter<Self>>(self, filter: F) -> F::Leaving {
        filter.transmit(self)
    }

    /// What a surface sends back of this light: Stokes light off a mirror, plain light off a matt surface.
    #[must_use]
    #[inline]
    pub fn onto<S: Surface<Self>>(self, surface: S) -> S::Leaving {
        surface.reflect(self)
    }

    /// The intensity alone: what an eye or a sensor reads, and the point from which polarization costs nothing any
    /// more. What comes after it treats the light as unpolarized.
    #[must_use]
    #[inline]
    pub fn ignoring_polarization(self) -> Plain<Power, Intensity<P>> {
        Plain::new(Intensity(self.0))
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

    /// What evaluating this path once costs.
    #[must_use]
    pub const fn price(&self) -> Price
    where
        P: Priced,
    {
        P::PRICE
    }

    /// This path, if it takes at most `MULTIPLY_ADDS` multiplications; a longer one does not compile (it is
    /// `cargo build` that says so).
    ///
    /// ```
    /// # use nanospectra::{Light, matter::Polarizer};
    /// # let (sun, sheet) = (Light::<31>::flat(1.0), Polarizer::ideal(0.0));
    /// let path = sun.polarized().through(&sheet).within::<{ 4 * 31 }>();
    /// ```
    /// ```compile_fail,E0080
    /// # use nanospectra::{Light, matter::Polarizer};
    /// # let (sun, sheet) = (Light::<31>::flat(1.0), Polarizer::ideal(0.0));
    /// let path = sun.polarized().through(&sheet).within::<{ 4 * 31 - 1 }>();
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

impl<P: Priced> Priced for Stokes<P> {
    const PRICE: Price = P::PRICE;
    const AGAIN: usize = P::AGAIN;
}

/// Unpolarized light as Stokes vectors: I, 0, 0, 0.
#[derive(Clone, Copy, Debug)]
pub struct Natural<P>(P);

impl<P> Natural<P> {
    #[inline]
    pub(super) const fn new(path: P) -> Self {
        Natural(path)
    }
}

impl<P: Priced> Priced for Natural<P> {
    const PRICE: Price = P::PRICE.plus(Price { effects: Effects::POLARIZATION, ..Price::NONE });
    const AGAIN: usize = P::AGAIN;
}

impl<P: Path<Power, N, G>, const N: usize, G> StokesPath<N, G> for Natural<P> {
    const TURNED: usize = Mueller::<N, G>::NATURAL;

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
    type Leaving = Plain<Power, Times<Intensity<P>, &'m Spectrum<Factor, N, G>>>;

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
    const PRICE: Price = L::PRICE.plus(Price { multiply_adds: L::TURNED, ..Mueller::<N, G>::PRICE });
    const AGAIN: usize = L::AGAIN + L::TURNED;
}

impl<L: StokesPath<N, G>, const N: usize, G> StokesPath<N, G> for Turned<L, &Mueller<N, G>> {
    #[inline]
    fn stokes_at(&self, k: usize) -> [f32; 4] {
        self.light.turned_at(k, self.element)
    }
}

impl<'m, L: Polarized<N, G>, const N: usize, G> Surface<L> for &'m Mirror<N, G> {
    type Leaving = Stokes<Turned<L::Light, &'m Mueller<N, G>>>;

    #[inline]
    fn reflect(self, light: L) -> Self::Leaving {
        Stokes(Turned { light: light.into_stokes(), element: self.mueller() })
    }
}

impl<'m, L: Polarized<N, G>, const N: usize, G> Filter<L> for &'m Polarizer<N, G> {
    type Leaving = Stokes<Turned<L::Light, &'m Mueller<N, G>>>;

    #[inline]
    fn transmit(self, light: L) -> Self::Leaving {
        Stokes(Turned { light: light.into_stokes(), element: self.mueller() })
    }
}

impl<'m, L: Polarized<N, G>, const N: usize, G> Filter<L> for &'m Retarder<N, G> {
    type Leaving = Stokes<Turned<L::Light, &'m Mueller<N, G>>>;

    #[inline]
    fn transmit(self, light: L) -> Self::Leaving {
        Stokes(Turned { light: light.into_stokes(), element: self.mueller() })
    }
}

/// The intensity of Stokes light.
#[derive(Clone, Copy, Debug)]
pub struct Intensity<P>(P);

impl<P: Priced> Priced for Intensity<P> {
    const PRICE: Price = P::PRICE;
    const AGAIN: usize = P::AGAIN;
}

impl<P: StokesPath<N, G>, const N: usize, G> Path<Power, N, G> for Intensity<P> {
    #[inline]
    fn at(&self, k: usize) -> f32 {
        let [intensity, ..] = self.0.stokes_at(k);
        intensity
    }
}
