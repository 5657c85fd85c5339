//! The trait of what an observer can look at.

use crate::spectrum::Spectrum;

/// Something that an observer of the quantity `Q` in `N` bins of the grid `G` can look at: a reference to a
/// spectrum, or light on its way along a [path](crate::path).
///
/// [`Observer::sees`](crate::Observer::sees) takes every type that implements this trait. Implement it for
/// light of your own, whose values are computed when they are read.
///
/// # Example
/// ```
/// use nanospectra::observer::Stimulus;
/// use nanospectra::{Bins, Light, Observer, Power};
///
/// /// Light that rises by 1 from bin to bin.
/// struct Ramp;
///
/// impl Stimulus<Power, 4, Bins<400, 700>> for Ramp {
///     fn at(&self, k: usize) -> f32 {
///         if k < 4 { k as f32 } else { f32::NAN }
///     }
/// }
///
/// let meter = Observer::<1, 4, Power, Bins<400, 700>>::from_weights([[1.0; 4]]);
/// assert_eq!(meter.sees(Ramp), [6.0]); // 0 + 1 + 2 + 3
/// assert_eq!(meter.sees(&Light::flat(1.0)), [4.0]);
/// ```
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
    /// Returns the value of bin `k`, or NaN beyond the last bin. See the [example](Stimulus#example).
    fn at(&self, k: usize) -> f32;

    /// Calls `reader` with the values of all bins, as a spectrum.
    ///
    /// The provided method computes them in one pass by [`at`](Self::at). For a reference to a spectrum
    /// nothing is copied.
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
