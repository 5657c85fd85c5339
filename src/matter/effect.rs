//! The traits of matter that mixes the bins of light, and how an observer that looks at it is transformed.

use crate::grid::Bins;
use crate::price::{Effects, Price};
use crate::spectrum::{Factor, Power, Spectrum};
use crate::sum::rows;
use core::array::from_ref;

/// Matter that moves light from one bin to another, which a factor for each bin cannot express.
///
/// Implement it for an effect of your own: [`leaving`](Self::leaving) is its only function. What leaves such
/// matter counts as unpolarized. [`Dye`](crate::matter::Dye), [`Donaldson`](crate::matter::Donaldson) and
/// [`Phosphor`](crate::matter::Phosphor) can be put into a [path](crate::path) directly; wrap an effect of
/// your own in [`Own`](crate::path::Own).
///
/// # Example
///
/// ```
/// use nanospectra::matter::{Dye, Effect};
/// use nanospectra::path::Own;
/// use nanospectra::{Light, Reflectance};
///
/// /// A dye whose glow does not exceed `most`, however bright the light is.
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
/// let glow = |light: Light<31>| {
///     light.onto(Own::new(&paint)).collected() - light.onto(&dye.reflectance()).collected()
/// };
/// assert!((glow(sun).power() - 10.0).abs() < 1e-4 && (glow(sun * 2.0).power() - 10.0).abs() < 1e-4);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say what it does to light in {N} bins of `{G}`",
    label = "no effect on this light",
    note = "implement `matter::Effect` for it: what leaves when light comes"
)]
pub trait Effect<const N: usize, G = Bins<380, 730>> {
    /// Returns the light that leaves the matter, in all bins, when `light` falls on it. See the
    /// [example](Effect#example).
    fn leaving(&self, light: &Spectrum<Power, N, G>) -> Spectrum<Power, N, G>;
}

/// An [`Effect`] that emits the same spectrum whatever excites it, such as a dye.
///
/// What leaves in a bin then depends only on the light in that bin and on one number, the glow, which
/// multiplies the emission spectrum. This lets a path compute a [`Dye`](crate::matter::Dye) and a
/// [`Phosphor`](crate::matter::Phosphor) bin by bin, without a copy of the spectrum. An effect of your own
/// need not implement this trait: [`Effect`] is enough, and is computed in all bins at once.
///
/// # Example
///
/// ```
/// use nanospectra::matter::{Dye, Glows};
/// use nanospectra::{Bins, Light, Reflectance};
///
/// // Bins at 450, 550 and 650 nm: half of the blue light is absorbed, and all that is emitted is green.
/// type Grid = Bins<400, 700>;
/// let dye = Dye::new(
///     &Reflectance::<3, Grid>::from_bins([0.1, 0.8, 0.8]),
///     &Reflectance::from_bins([0.5, 0.0, 0.0]),
///     &Light::from_bins([0.0, 1.0, 0.0]),
///     0.88,
/// )?;
/// // Of the 100 nm of blue light 0.5 * 0.88 * 450 / 550 of the power is emitted again.
/// let glow = dye.glow_in(&Light::flat(1.0));
/// assert!((glow - 36.0).abs() < 1e-4);
/// // In the green bin 0.8 is reflected, and the glow is spread over 100 nm.
/// assert!((dye.leaving_bin(1, 1.0, glow) - (0.8 + 0.36)).abs() < 1e-6);
/// # Ok::<(), nanospectra::matter::FluorescenceError>(())
/// ```
pub trait Glows<const N: usize, G = Bins<380, 730>>: Effect<N, G> {
    /// Returns the factor by which the emission spectrum is multiplied under this light. See the
    /// [example](Glows#example).
    fn glow_in(&self, light: &Spectrum<Power, N, G>) -> f32;

    /// Computes the light that leaves in bin `k`, from the light that comes in that bin and the glow.
    ///
    /// The result is NaN where `k` is not below `N`. See the [example](Glows#example).
    fn leaving_bin(&self, k: usize, incoming: f32, glow: f32) -> f32;
}

/// The light that leaves in all bins.
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

/// An [`Effect`] that is linear in the light, so that it can be combined with the observer that looks at it.
///
/// Linear means that twice the light makes twice as much leave, and that nothing leaves in the dark. Such
/// matter can be given to [`Observer::looking_at_matter`](crate::Observer::looking_at_matter) and be a part
/// of a [`Scene`](crate::path::Scene).
///
/// An empty `impl Foldable<31> for Ink {}` is enough, because all functions of this trait are provided and
/// follow from [`Effect::leaving`]. Write your own where your matter has a shorter way.
///
/// # Example
///
/// ```
/// use nanospectra::matter::{Effect, Foldable};
/// use nanospectra::path::Own;
/// use nanospectra::{Bins, Light, Observer, Power};
///
/// type Grid = Bins<400, 700>;
///
/// /// An ink that reflects half of the light, and turns a quarter of the blue into green.
/// struct Ink;
///
/// impl Effect<3, Grid> for Ink {
///     fn leaving(&self, light: &Light<3, Grid>) -> Light<3, Grid> {
///         let [blue, green, red] = *light.values();
///         Light::from_bins([0.5 * blue, 0.5 * green + 0.25 * blue, 0.5 * red])
///     }
/// }
///
/// impl Foldable<3, Grid> for Ink {
///     fn name(&self) -> &'static str {
///         "ink"
///     }
/// }
///
/// // A sensor for green: its weights before the ink tell that it also responds to blue light now.
/// let sensor = Observer::<1, 3, Power, Grid>::from_weights([[0.0, 1.0, 0.0]]);
/// let turned = sensor.looking_at_matter(&Ink);
/// assert_eq!(turned.weights(), &[Ink.transposed(&[0.0, 1.0, 0.0])]);
/// assert_eq!(turned.weights(), &[[0.25, 0.5, 0.0]]);
/// // Both directions give the same reading: 0.25 * 4 + 0.5 * 2.
/// let lamp = Light::from_bins([4.0, 2.0, 1.0]);
/// assert_eq!(turned.sees(&lamp), [2.0]);
/// assert_eq!(sensor.sees(lamp.onto(Own::new(&Ink))), [2.0]);
/// // Without the effect the ink is gray.
/// assert_eq!(Ink.without_effect().values(), &[0.5; 3]);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not fold into an eye of {N} bins of `{G}`",
    label = "not known to be linear in the light",
    note = "if twice the light makes twice as much leave, write `impl Foldable<{N}, {G}> for ..` beside its `Effect`"
)]
pub trait Foldable<const N: usize, G = Bins<380, 730>>: Effect<N, G> {
    /// Returns the weights that an observer gives to the light that falls on the matter, from the `weights`
    /// that it gives to the light that leaves.
    ///
    /// This is the transpose of [`leaving`](Effect::leaving). The provided function calls `leaving` for light
    /// in one bin after the other, which costs `N` times as much as one call. Its result means nothing for
    /// matter that is not linear, and is NaN where `leaving` is NaN. See the [example](Foldable#example).
    fn transposed(&self, weights: &[f32; N]) -> [f32; N] {
        let mut before = [0.0; N];
        for (k, before) in before.iter_mut().enumerate() {
            [*before] = rows(from_ref(weights), &self.leaving(&light_in_bin(k)).0);
        }
        before
    }

    /// Returns the plain reflectance that remains if the effect is left out.
    ///
    /// The provided function returns, for each bin, the share of its light that leaves in the same bin. See
    /// the [example](Foldable#example).
    fn without_effect(&self) -> Spectrum<Factor, N, G> {
        let mut shares = [0.0; N];
        for (k, share) in shares.iter_mut().enumerate() {
            *share = self.leaving(&light_in_bin(k)).0.get(k).copied().unwrap_or(f32::NAN);
        }
        Spectrum::unchecked(shares)
    }

    /// Returns the name under which the matter is listed in [bills](crate::path::Scene::bill). See the
    /// [example](Foldable#example).
    fn name(&self) -> &'static str {
        "effect"
    }

    /// Returns what one call of [`leaving`](Effect::leaving) costs, for [bills](crate::path::Scene::bill).
    ///
    /// The provided function returns an estimate: the work of a full matrix, and the size of the value. If
    /// your matter is [`Priced`](crate::path::Priced), return its `PRICE`.
    fn price(&self) -> Price {
        Price { effects: Effects::FLUORESCENCE, multiply_adds: N * N, bytes: size_of_val(self) }
    }
}

fn light_in_bin<const N: usize, G>(k: usize) -> Spectrum<Power, N, G> {
    let mut bins = [0.0; N];
    bins.iter_mut().skip(k).take(1).for_each(|bin| *bin = 1.0);
    Spectrum::unchecked(bins)
}
