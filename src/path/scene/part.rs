//! The parts that a scene is made of.

use crate::grid::Bins;
use crate::matter::{Foldable, Mueller};
use crate::path::{Own, Price};
use crate::spectrum::{Factor, Spectrum};

/// A reference to matter that light can meet in a [`Scene`](crate::path::scene::Scene), which says what kind
/// of matter it is.
///
/// Most matter is a part [by itself](IntoPart), so `scene.push(&vest)` is enough. Only for a spectrum of
/// factors you have to say whether it is a [`Filter`](Self::Filter), behind which light stays polarized, or a
/// [`Surface`](Self::Surface), off which it does not. See the [example](crate::path::Scene#example).
#[derive(Clone, Copy)]
#[non_exhaustive]
pub enum Part<'a, const N: usize, G = Bins<380, 730>> {
    /// Colored glass, or a dyed liquid, which dims all polarizations alike.
    Filter(&'a Spectrum<Factor, N, G>),
    /// A matt surface, which scatters light back unpolarized.
    Surface(&'a Spectrum<Factor, N, G>),
    /// Matter that moves light between bins, as a dye, a Donaldson matrix or an effect of your own ([`Own`])
    /// does.
    ///
    /// What leaves it counts as unpolarized, even behind clear matter.
    Effect(&'a (dyn Foldable<N, G> + Sync)),
    /// A mirror, a polarizer or a retarder, which is described by its Mueller matrix.
    Polarizing {
        /// The name under which it stands in [bills](crate::path::Scene::bill).
        name: &'static str,
        /// The Mueller matrix that says what it does to light.
        mueller: &'a Mueller<N, G>,
    },
}

impl<const N: usize, G> Part<'_, N, G> {
    /// Returns the name that [bills](crate::path::Scene::bill) use for this kind of part, as `"filter"` or
    /// `"dye"`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Part::Filter(_) => "filter",
            Part::Surface(_) => "surface",
            Part::Effect(matter) => matter.name(),
            Part::Polarizing { name, .. } => name,
        }
    }

    /// Returns the price that is paid to compute all bins behind this part once, for unpolarized light.
    #[must_use]
    pub fn price(&self) -> Price {
        match self {
            Part::Filter(_) | Part::Surface(_) => Price::factor(N),
            Part::Effect(matter) => matter.price(),
            Part::Polarizing { .. } => Mueller::<N, G>::PRICE_OF_NATURAL,
        }
    }

    /// Returns the factors that remain if the effect of this part is left out.
    ///
    /// These are the reflectance of a dye without its fluorescence, the diagonal of a Donaldson matrix, or
    /// the share of unpolarized light that a mirror, polarizer or retarder passes on.
    #[must_use]
    pub fn without_effect(&self) -> Spectrum<Factor, N, G> {
        match self {
            Part::Filter(factors) | Part::Surface(factors) => **factors,
            Part::Effect(matter) => matter.without_effect(),
            Part::Polarizing { mueller, .. } => mueller.ignoring_polarization(),
        }
    }

    /// Returns whether this part polarizes light, so that one number for each bin does not describe what it
    /// does.
    pub(super) const fn polarizes(&self) -> bool {
        matches!(self, Part::Polarizing { .. })
    }
}

impl<const N: usize, G> core::fmt::Debug for Part<'_, N, G> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_tuple("Part").field(&self.name()).field(&self.price()).finish()
    }
}

/// Types that can be pushed into a [`Scene`](crate::path::scene::Scene): a [`Part`], a reference to matter
/// other than a spectrum, or an effect of your own in [`Own`].
///
/// There is nothing to call here; see the [example](crate::path::Scene#example) of a scene.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say what it is in a scene of {N} bins of `{G}`",
    label = "no part of a scene",
    note = "write `Part::Filter(&glass)` or `Part::Surface(&paper)`; `&Dye`, `&Donaldson`, `&Phosphor`, \
            `&Mirror`, `&Polarizer` and `&Retarder` are parts by themselves, an effect of your own is one in \
            `Own::new(&ink)`; all lie on one grid"
)]
pub trait IntoPart<'a, const N: usize, G> {
    /// Returns the part of a scene that this value stands for.
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
