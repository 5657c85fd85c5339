//! Polarizers: sheets that let light of one polarization through.

use crate::grid::{Bins, by_fields};
use crate::math::const_for;
use crate::matter::Mueller;
use crate::matter::polarizing::mueller::along_and_across;
use crate::spectrum::{Factor, Spectrum};

/// A sheet that lets light through along one axis, its own, and not across it.
pub struct Polarizer<const N: usize, G = Bins<380, 730>>(Mueller<N, G>);

by_fields!([const N: usize, G] Polarizer<N, G>, "Polarizer": 0);

impl<const N: usize, G> Polarizer<N, G> {
    /// The Mueller matrix.
    #[must_use]
    #[inline]
    pub const fn mueller(&self) -> &Mueller<N, G> {
        &self.0
    }

    /// A perfect polarizer, which passes all light along its axis and none across it; the axis is in turns
    /// from the reference direction.
    #[must_use]
    pub const fn ideal(axis_turns: f32) -> Self {
        Polarizer(Mueller::new([[0.5, 0.5, 0.0, 0.0]; N], axis_turns))
    }

    /// A real polarizer, from its transmittances for light along its axis and across it, 0..=1 (below: 0);
    /// the axis as for [`ideal`](Self::ideal).
    #[must_use]
    pub const fn new(
        along: &Spectrum<Factor, N, G>,
        across: &Spectrum<Factor, N, G>,
        axis_turns: f32,
    ) -> Self {
        let mut elements = [[0.0; 4]; N];
        const_for!(0..N, |k| {
            let [a, b, both] = along_and_across(along.0[k], across.0[k]);
            elements[k] = [a, b, both, 0.0];
        });
        Polarizer(Mueller::new(elements, axis_turns))
    }
}
