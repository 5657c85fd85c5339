//! Fluorescent matter folded into the eye that looks at it.

use crate::math::const_for;
use crate::matter::{Donaldson, Dye, Foldable};
use crate::observer::Observer;
use crate::spectrum::Power;

impl<const C: usize, const N: usize, G> Observer<C, N, Power, G> {
    /// This observer turned to a dye: it then reads the light that falls there. Put it `under` a light after
    /// that, never before: a light that is folded in cannot make anything glow.
    ///
    /// Computes in f64, for `const` use, as [`scaled`](Observer::scaled).
    #[must_use]
    pub const fn looking_at_dye(&self, dye: &Dye<N, G>) -> Self {
        let mut weights = self.0;
        const_for!(0..C, |c| weights[c] = dye.transposed_in_f64(&self.0[c]));
        Self::unchecked(weights)
    }

    /// This observer turned to fluorescent matter of any kind; as [`looking_at_dye`](Self::looking_at_dye).
    #[must_use]
    pub const fn looking_at_donaldson<const P: usize>(&self, matter: &Donaldson<N, P, G>) -> Self {
        let mut weights = self.0;
        const_for!(0..C, |c| weights[c] = matter.transposed_in_f64(&self.0[c]));
        Self::unchecked(weights)
    }

    /// This observer turned to matter of any kind that folds, an effect of your own included. Computes in
    /// f32, at run time.
    #[must_use]
    pub fn looking_at_matter<M: Foldable<N, G> + ?Sized>(&self, matter: &M) -> Self {
        let mut weights = self.0;
        weights.iter_mut().for_each(|row| *row = matter.transposed(row));
        Self::unchecked(weights)
    }
}
