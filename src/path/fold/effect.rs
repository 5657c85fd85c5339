//! Folds fluorescent matter into the observer that looks at it.

use crate::math::const_for;
use crate::matter::{Donaldson, Dye, Foldable};
use crate::observer::Observer;
use crate::spectrum::Power;

impl<const C: usize, const N: usize, G> Observer<C, N, Power, G> {
    /// Folds a fluorescent dye into this observer, which then reads the light that falls on the dye.
    ///
    /// Fold a lamp in ([`under`](Observer::under)) after the dye and not before it: an observer with a lamp
    /// in it reads reflectances, and it would not know how much of the lamp's light the dye absorbs.
    ///
    /// Computes in f64, for `const` use, as [`scaled`](Observer::scaled) does. See the
    /// [example](crate::path#folding-a-path-into-an-observer).
    #[must_use]
    pub const fn looking_at_dye(&self, dye: &Dye<N, G>) -> Self {
        let mut weights = self.0;
        const_for!(0..C, |c| weights[c] = dye.transposed_in_f64(&self.0[c]));
        Self::unchecked(weights)
    }

    /// Folds fluorescent matter that is described by a Donaldson matrix into this observer.
    ///
    /// It is used as [`looking_at_dye`](Self::looking_at_dye) is, and computes in f64 as that does.
    #[must_use]
    pub const fn looking_at_donaldson<const P: usize>(&self, matter: &Donaldson<N, P, G>) -> Self {
        let mut weights = self.0;
        const_for!(0..C, |c| weights[c] = matter.transposed_in_f64(&self.0[c]));
        Self::unchecked(weights)
    }

    /// Folds matter of any kind that is linear in the light, such as an effect of your own, into this
    /// observer.
    ///
    /// Computes in f32, at run time. See the [example](crate::path::Own#example).
    #[must_use]
    pub fn looking_at_matter<M: Foldable<N, G> + ?Sized>(&self, matter: &M) -> Self {
        let mut weights = self.0;
        weights.iter_mut().for_each(|row| *row = matter.transposed(row));
        Self::unchecked(weights)
    }
}
