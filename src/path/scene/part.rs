//! What a scene is made of.

use crate::grid::Bins;
use crate::matter::{Donaldson, Dye, Mirror, Mueller, Polarizer, Retarder, applied};
use crate::path::{Effects, Price, Priced, price_of};
use crate::spectrum::{Factor, Spectrum};
use core::marker::PhantomData;

/// What light can meet in a [`Scene`](crate::path::scene::Scene), by reference.
///
/// All but the first two come [from a reference](IntoPart), so `scene.push(&vest)` is enough. A spectrum of factors has
/// to say which it is: light behind a filter stays polarized, light off a matt surface does not.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum Part<'a, const N: usize, G = Bins<380, 730>> {
    /// Colored glass, a dyed liquid: dims all polarizations alike.
    Filter(&'a Spectrum<Factor, N, G>),
    /// A matt surface: what it scatters back is unpolarized.
    Surface(&'a Spectrum<Factor, N, G>),
    /// A surface or a filter that glows in one color. What leaves it counts as unpolarized, also behind clear matter.
    Dye(&'a Dye<N, G>),
    /// A surface or a filter that fluoresces in any way. What leaves it counts as unpolarized, as of a dye.
    Donaldson(Bispectral<'a, N, G>),
    /// A smooth surface at one angle of incidence.
    Mirror(&'a Mirror<N, G>),
    /// A sheet that lets one polarization through.
    Polarizer(&'a Polarizer<N, G>),
    /// A plate that delays one polarization.
    Retarder(&'a Retarder<N, G>),
}

/// A [`Donaldson`] matrix without the number of its pairs in the type: `Bispectral::from(&matrix)`.
#[derive(Clone, Copy, Debug)]
pub struct Bispectral<'a, const N: usize, G = Bins<380, 730>> {
    columns: &'a [f32],
    grid: PhantomData<G>,
}

impl<'a, const N: usize, G> Bispectral<'a, N, G> {
    /// The matrix times `light`.
    pub(super) fn applied(&self, light: &[f32; N]) -> [f32; N] {
        applied(self.columns, light)
    }

    /// Of each bin of light, what it becomes in all bins; zero in those of shorter waves.
    pub(super) fn columns(&self) -> impl Iterator<Item = [f32; N]> + use<'a, N, G> {
        let mut rest = self.columns;
        (0..N).map_while(move |i| {
            let (column, next) = rest.split_at_checked(N - i)?;
            rest = next;
            let mut bins = [0.0; N];
            bins.iter_mut().skip(i).zip(column).for_each(|(bin, share)| *bin = *share);
            Some(bins)
        })
    }

    /// The ordinary reflectance.
    fn diagonal(&self) -> Spectrum<Factor, N, G> {
        let mut values = [0.0; N];
        for (i, (value, column)) in values.iter_mut().zip(self.columns()).enumerate() {
            *value = column.get(i).copied().unwrap_or(f32::NAN);
        }
        Spectrum::unchecked(values)
    }
}

impl<const N: usize, G> Part<'_, N, G> {
    /// Its name, for bills: `"filter"`, `"dye"`, ..
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Part::Filter(_) => "filter",
            Part::Surface(_) => "surface",
            Part::Dye(_) => "dye",
            Part::Donaldson(_) => "donaldson",
            Part::Mirror(_) => "mirror",
            Part::Polarizer(_) => "polarizer",
            Part::Retarder(_) => "retarder",
        }
    }

    /// What it takes to work it out once for light that is not followed as Stokes vectors.
    #[must_use]
    pub fn price(&self) -> Price {
        match self {
            Part::Filter(_) | Part::Surface(_) => Price::factor(N),
            Part::Dye(dye) => price_of(*dye),
            Part::Donaldson(matter) => Price {
                effects: Effects::FLUORESCENCE,
                multiply_adds: matter.columns.len(),
                bytes: 4 * matter.columns.len(),
            },
            Part::Mirror(_) | Part::Polarizer(_) | Part::Retarder(_) => {
                Price { multiply_adds: Mueller::<N, G>::NATURAL, ..Mueller::<N, G>::PRICE }
            }
        }
    }

    /// What remains of it without its effect: the reflectance of a dye without the glow, the diagonal of a matrix,
    /// the share of unpolarized light that a mirror, a polarizer or a retarder passes on.
    #[must_use]
    pub fn without_effect(&self) -> Spectrum<Factor, N, G> {
        match self {
            Part::Filter(factors) | Part::Surface(factors) => **factors,
            Part::Dye(dye) => dye.reflectance(),
            Part::Donaldson(matter) => matter.diagonal(),
            Part::Mirror(mirror) => mirror.mueller().ignoring_polarization(),
            Part::Polarizer(polarizer) => polarizer.mueller().ignoring_polarization(),
            Part::Retarder(retarder) => retarder.mueller().ignoring_polarization(),
        }
    }

    /// Whether plain light cannot tell what it does.
    pub(super) const fn polarizes(&self) -> bool {
        matches!(self, Part::Mirror(_) | Part::Polarizer(_) | Part::Retarder(_))
    }
}

impl<'a, const N: usize, const P: usize, G> From<&'a Donaldson<N, P, G>> for Bispectral<'a, N, G> {
    fn from(matter: &'a Donaldson<N, P, G>) -> Self {
        Bispectral { columns: matter.columns(), grid: PhantomData }
    }
}

impl<'a, const N: usize, const P: usize, G> From<&'a Donaldson<N, P, G>> for Part<'a, N, G> {
    fn from(matter: &'a Donaldson<N, P, G>) -> Self {
        Part::Donaldson(matter.into())
    }
}

/// What can be pushed into a [`Scene`](crate::path::scene::Scene): a [`Part`], or a reference that says which it is.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say what it is in a scene of {N} bins of `{G}`",
    label = "no part of a scene",
    note = "write `Part::Filter(&glass)` or `Part::Surface(&paper)`; `&Dye`, `&Donaldson`, `&Mirror`, `&Polarizer` and \
            `&Retarder` are parts by themselves; all lie on one grid"
)]
pub trait IntoPart<'a, const N: usize, G> {
    /// The part.
    fn into_part(self) -> Part<'a, N, G>;
}

impl<'a, const N: usize, G> IntoPart<'a, N, G> for Part<'a, N, G> {
    fn into_part(self) -> Part<'a, N, G> {
        self
    }
}

impl<'a, const N: usize, const P: usize, G> IntoPart<'a, N, G> for &'a Donaldson<N, P, G> {
    fn into_part(self) -> Part<'a, N, G> {
        self.into()
    }
}

macro_rules! from_reference {
    ($($kind:ident)*) => {
        $(impl<'a, const N: usize, G> From<&'a $kind<N, G>> for Part<'a, N, G> {
            fn from(matter: &'a $kind<N, G>) -> Self {
                Part::$kind(matter)
            }
        }

        impl<'a, const N: usize, G> IntoPart<'a, N, G> for &'a $kind<N, G> {
            fn into_part(self) -> Part<'a, N, G> {
                Part::$kind(self)
            }
        })*
    };
}

from_reference! { Dye Mirror Polarizer Retarder }
