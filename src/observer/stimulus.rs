//! What an observer looks at.

use crate::spectrum::Spectrum;

/// What an observer of the quantity `Q` in `N` bins of the grid `G` can look at: a spectrum, or light on its
/// way along a [path](crate::path).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no stimulus of `{Q}` in {N} bins of `{G}`",
    label = "not what is read here",
    note = "an eye that has a light folded in (`under`) reads `Factor`, any other `Power`; all stages lie on one grid",
    note = "a spectrum is looked at by reference, `eye.sees(&lamp)`; of `Radiance` and its relatives the `.value()`",
    note = "polarized light becomes plain by `.ignoring_polarization()`",
    note = "fluorescent matter is seen in light, `eye.sees(lamp.onto(&dye))`, or folded in before the light: \
            `eye.looking_at_dye(&dye).under(&lamp)`"
)]
pub trait Stimulus<Q, const N: usize, G> {
    /// The value of bin `k`; NaN beyond the last.
    fn at(&self, k: usize) -> f32;

    /// Hands the values of all bins to `reader`: worked out in one pass, or, of a spectrum, where they lie.
    #[inline]
    fn read<R>(&self, reader: impl FnOnce(&Spectrum<Q, N, G>) -> R) -> R {
        let mut all = Spectrum::unchecked([0.0; N]);
        for (k, value) in all.0.iter_mut().enumerate() {
            *value = self.at(k);
        }
        reader(&all)
    }
}

impl<Q, const N: usize, G> Stimulus<Q, N, G> for &Spectrum<Q, N, G> {
    #[inline]
    fn at(&self, k: usize) -> f32 {
        self.0.get(k).copied().unwrap_or(f32::NAN)
    }

    #[inline]
    fn read<R>(&self, reader: impl FnOnce(&Spectrum<Q, N, G>) -> R) -> R {
        reader(self)
    }
}
