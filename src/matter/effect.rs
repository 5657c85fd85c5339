//! What matter does to light whose bins it mixes and, transposed, to an eye that looks backwards.

use crate::grid::Bins;
use crate::price::{Effects, Price};
use crate::spectrum::{Factor, Power, Spectrum};
use crate::sum::rows;
use core::array::from_ref;

/// Matter that moves light from one bin to another, which a factor for each bin cannot express. What leaves
/// it counts as unpolarized.
///
/// [`Dye`](crate::matter::Dye), [`Donaldson`](crate::matter::Donaldson) and
/// [`Phosphor`](crate::matter::Phosphor) stand in a [path](crate::path) by themselves, an effect of your own
/// does in [`Own`](crate::path::Own):
///
/// ```
/// use nanospectra::matter::{Dye, Effect};
/// use nanospectra::path::Own;
/// use nanospectra::{Light, Reflectance};
///
/// /// A dye that glows no more than so much, however bright the light.
/// struct Saturating {
///     dye: Dye<31>,
///     most: f32,
/// }
///
/// impl Effect<31> for Saturating {
///     fn leaving(&self, light: &Light<31>) -> Light<31> {
///         let share = (self.most / self.dye.glow_under(light)).min(1.0);
///         let dull = *light * self.dye.reflectance();
///         dull + (self.dye.leaving(light) - dull) * share
///     }
/// }
///
/// # let gray = Reflectance::flat(0.4);
/// # let dye = Dye::new(&gray, &gray, &Light::flat(1.0), 0.9).unwrap();
/// let (sun, paint) = (Light::flat(1.0), Saturating { dye, most: 10.0 });
/// let glow = |light: Light<31>| light.onto(Own::new(&paint)).collected() - light.onto(&dye.reflectance()).collected();
/// assert!((glow(sun).power() - 10.0).abs() < 1e-4 && (glow(sun * 2.0).power() - 10.0).abs() < 1e-4);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say what it does to light in {N} bins of `{G}`",
    label = "no effect on this light",
    note = "implement `matter::Effect` for it: what leaves when light comes"
)]
pub trait Effect<const N: usize, G = Bins<380, 730>> {
    /// What leaves the matter when `light` meets it, in all bins.
    fn leaving(&self, light: &Spectrum<Power, N, G>) -> Spectrum<Power, N, G>;
}

/// An [`Effect`] that emits one spectrum, however it was excited: what leaves each bin needs the light of
/// that bin and one number, the glow. So a path works out a [`Dye`](crate::matter::Dye) and a
/// [`Phosphor`](crate::matter::Phosphor) bin by bin; an effect of your own needs no more than [`Effect`], and
/// is worked out in all bins at once.
pub trait Glows<const N: usize, G = Bins<380, 730>>: Effect<N, G> {
    /// The factor by which the emission is multiplied, under this light.
    fn glow_in(&self, light: &Spectrum<Power, N, G>) -> f32;

    /// What leaves in bin `k`, of what comes in that bin and with that glow; NaN beyond the last.
    fn leaving_bin(&self, k: usize, incoming: f32, glow: f32) -> f32;
}

/// What leaves in all bins.
#[inline]
pub(super) fn glowing<const N: usize, G>(
    matter: &impl Glows<N, G>,
    light: &Spectrum<Power, N, G>,
) -> Spectrum<Power, N, G> {
    let glow = matter.glow_in(light);
    let mut leaving = *light;
    for (k, value) in leaving.0.iter_mut().enumerate() {
        *value = matter.leaving_bin(k, *value, glow);
    }
    leaving
}

/// An [`Effect`] that is linear in the light (twice the light makes twice as much leave, and none makes
/// none), so that it folds into the eye that looks at it: by
/// [`Observer::looking_at_matter`](crate::Observer::looking_at_matter), and in a
/// [`Scene`](crate::path::Scene).
///
/// `impl Foldable<31> for Ink {}` is enough: all functions follow from [`Effect::leaving`]. Write those that
/// your matter has a shorter way for.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not fold into an eye of {N} bins of `{G}`",
    label = "not known to be linear in the light",
    note = "if twice the light makes twice as much leave, write `impl Foldable<{N}, {G}> for ..` beside its `Effect`"
)]
pub trait Foldable<const N: usize, G = Bins<380, 730>>: Effect<N, G> {
    /// The weights that light has before it meets the matter, for an eye that gives these weights to what
    /// leaves: the transpose of [`leaving`](Effect::leaving). As it stands it asks what leaves of light in
    /// one bin after the other, at `N` times the cost; it is meaningless for matter that is not linear, and
    /// NaN where that is.
    fn transposed(&self, weights: &[f32; N]) -> [f32; N] {
        let mut before = [0.0; N];
        for (k, before) in before.iter_mut().enumerate() {
            [*before] = rows(from_ref(weights), &self.leaving(&light_in_bin(k)).0);
        }
        before
    }

    /// What remains of it if its effect is left out: as it stands the share of each bin's light that leaves
    /// in that bin.
    fn without_effect(&self) -> Spectrum<Factor, N, G> {
        let mut shares = [0.0; N];
        for (k, share) in shares.iter_mut().enumerate() {
            *share = self.leaving(&light_in_bin(k)).0.get(k).copied().unwrap_or(f32::NAN);
        }
        Spectrum::unchecked(shares)
    }

    /// Its name in [bills](crate::path::Scene::bill).
    fn name(&self) -> &'static str {
        "effect"
    }

    /// What [`leaving`](Effect::leaving) costs, for [bills](crate::path::Scene::bill): as it stands an
    /// estimate, the work of a full matrix and the size of the value. If your matter is
    /// [`Priced`](crate::path::Priced), return its `PRICE`.
    fn price(&self) -> Price {
        Price { effects: Effects::FLUORESCENCE, multiply_adds: N * N, bytes: size_of_val(self) }
    }
}

fn light_in_bin<const N: usize, G>(k: usize) -> Spectrum<Power, N, G> {
    let mut bins = [0.0; N];
    bins.iter_mut().skip(k).take(1).for_each(|bin| *bin = 1.0);
    Spectrum::unchecked(bins)
}
