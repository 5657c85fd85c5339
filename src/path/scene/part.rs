//! What a scene is made of.

use crate::grid::Bins;
use crate::matter::{Foldable, Mueller};
use crate::path::{Own, Price};
use crate::spectrum::{Factor, Spectrum};

/// What light can meet in a [`Scene`](crate::path::scene::Scene), by reference.
///
/// All but the first two come [from a reference](IntoPart), so `scene.push(&vest)` is enough. A spectrum of
/// factors has to say which it is: light behind a filter stays polarized, light off a matt surface does not.
#[derive(Clone, Copy)]
#[non_exhaustive]
pub enum Part<'a, const N: usize, G = Bins<380, 730>> {
    /// Colored glass, a dyed liquid: dims all polarizations alike.
    Filter(&'a Spectrum<Factor, N, G>),
    /// A matt surface: what it scatters back is unpolarized.
    Surface(&'a Spectrum<Factor, N, G>),
    /// A surface or a filter that fluoresces: a dye, a Donaldson matrix, an effect of your own in [`Own`].
    /// What leaves it counts as unpolarized, also behind clear matter.
    Effect(&'a (dyn Foldable<N, G> + Sync)),
    /// A mirror, a polarizer or a retarder, by its Mueller matrix.
    Polarizing {
        /// What bills call it.
        name: &'static str,
        /// What it does.
        mueller: &'a Mueller<N, G>,
    },
}

impl<const N: usize, G> Part<'_, N, G> {
    /// Its name, for bills: `"filter"`, `"dye"`, ..
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Part::Filter(_) => "filter",
            Part::Surface(_) => "surface",
            Part::Effect(matter) => matter.name(),
            Part::Polarizing { name, .. } => name,
        }
    }

    /// The price of working it out once, for light that is not followed as Stokes vectors.
    #[must_use]
    pub fn price(&self) -> Price {
        match self {
            Part::Filter(_) | Part::Surface(_) => Price::factor(N),
            Part::Effect(matter) => matter.price(),
            Part::Polarizing { .. } => Mueller::<N, G>::PRICE_OF_NATURAL,
        }
    }

    /// The factors that remain of it if its effect is left out: the reflectance of a dye without the glow,
    /// the diagonal of a matrix, the share of unpolarized light that a mirror passes on.
    #[must_use]
    pub fn without_effect(&self) -> Spectrum<Factor, N, G> {
        match self {
            Part::Filter(factors) | Part::Surface(factors) => **factors,
            Part::Effect(matter) => matter.without_effect(),
            Part::Polarizing { mueller, .. } => mueller.ignoring_polarization(),
        }
    }

    /// Whether one number for each bin does not describe what it does.
    pub(super) const fn polarizes(&self) -> bool {
        matches!(self, Part::Polarizing { .. })
    }
}

impl<const N: usize, G> core::fmt::Debug for Part<'_, N, G> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_tuple("Part").field(&self.name()).field(&self.price()).finish()
    }
}

/// What can be pushed into a [`Scene`](crate::path::scene::Scene): a [`Part`], or a reference that says which
/// it is.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say what it is in a scene of {N} bins of `{G}`",
    label = "no part of a scene",
    note = "write `Part::Filter(&glass)` or `Part::Surface(&paper)`; `&Dye`, `&Donaldson`, `&Phosphor`, `&Mirror`, `&Polarizer` \
            and `&Retarder` are parts by themselves, an effect of your own is one in `Own::new(&ink)`; all lie on one grid"
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

impl<'a, M: Foldable<N, G> + Sync, const N: usize, G> IntoPart<'a, N, G> for Own<'a, M, N, G> {
    fn into_part(self) -> Part<'a, N, G> {
        Part::Effect(self.0)
    }
}
