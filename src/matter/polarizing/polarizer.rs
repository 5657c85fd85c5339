//! Polarizers, which are sheets that let light of one polarization through.

use crate::grid::{Bins, by_fields};
use crate::math::const_for;
use crate::matter::Mueller;
use crate::matter::polarizing::mueller::along_and_across;
use crate::spectrum::{Factor, Spectrum};

/// A sheet that lets light through that is polarized along its axis, and stops light polarized across it.
///
/// Make it by [`ideal`](Self::ideal), or from measured transmittances by [`new`](Self::new).
///
/// # Example
///
/// ```
/// use nanospectra::matter::Polarizer;
/// use nanospectra::{Light, Reflectance};
///
/// // Two perfect sheets at 30 degrees: half of the light gets through the first, and by Malus's law
/// // cos^2(30 degrees) of that through the second.
/// let (first, second) = (Polarizer::<31>::ideal(0.0), Polarizer::ideal(30.0 / 360.0));
/// let lamp = Light::flat(1.0);
/// let [i, ..] = lamp.polarized().through(&first).through(&second).stokes_at(0);
/// assert!((i - 0.5 * 0.75).abs() < 1e-6);
///
/// // A real sheet passes 80 % along its axis and 2 % across it: 41 % of unpolarized light.
/// let real = Polarizer::new(&Reflectance::<31>::flat(0.8), &Reflectance::flat(0.02), 0.0);
/// let [i, q, ..] = Light::flat(1.0).polarized().through(&real).stokes_at(0);
/// assert!((i - 0.41).abs() < 1e-6 && (q - 0.39).abs() < 1e-6);
/// ```
pub struct Polarizer<const N: usize, G = Bins<380, 730>>(Mueller<N, G>);

by_fields!([const N: usize, G] Polarizer<N, G>, "Polarizer": 0);

impl<const N: usize, G> Polarizer<N, G> {
    /// Makes a perfect polarizer, which passes all light along its axis and none across it.
    ///
    /// `axis_turns` is the angle of the axis, in turns from the reference direction of the light. See the
    /// [example](#example).
    #[must_use]
    pub const fn ideal(axis_turns: f32) -> Self {
        Polarizer(Mueller::new([[0.5, 0.5, 0.0, 0.0]; N], axis_turns))
    }

    /// Makes a real polarizer from its transmittances for light polarized along its axis and across it.
    ///
    /// Both are 0..=1; a negative one counts as 0. The axis is as for [`ideal`](Self::ideal). See the
    /// [example](#example).
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

    /// Returns the Mueller matrix of this polarizer, one for each bin.
    #[must_use]
    #[inline]
    pub const fn mueller(&self) -> &Mueller<N, G> {
        &self.0
    }
}
