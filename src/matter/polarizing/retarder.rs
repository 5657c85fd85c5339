//! Retarders: plates that delay light of one polarization against the other.

use crate::grid::{Bands, Bins, Grid, Layout, by_fields};
use crate::math::{const_for, cos_turns, sin_turns};
use crate::matter::Mueller;
use crate::spectrum::{Factor, Spectrum};

/// A plate that delays light across its (fast) axis against light along it.
pub struct Retarder<const N: usize, G = Bins<380, 730>>(Mueller<N, G>);

by_fields!([const N: usize, G] Retarder<N, G>, "Retarder": 0);

impl<const N: usize, G> Retarder<N, G> {
    /// The Mueller matrix.
    #[must_use]
    #[inline]
    pub const fn mueller(&self) -> &Mueller<N, G> {
        &self.0
    }

    /// A plate of the same retardance in every bin, in turns (a quarter for a quarter-wave plate); the fast
    /// axis in turns from the reference direction.
    #[must_use]
    pub const fn flat(retardance_turns: f32, axis_turns: f32) -> Self {
        let (c, s) = (cos_turns(retardance_turns), sin_turns(retardance_turns));
        Retarder(Mueller::new([[1.0, 0.0, c, s]; N], axis_turns))
    }
}

impl<const N: usize, G: Bands> Retarder<N, G> {
    /// A plate of one path difference, in nm: 137.5 for a quarter-wave plate at 550 nm.
    ///
    /// What is kept is the mean effect over each bin, so light behind a plate of many waves is as good as
    /// unpolarized. Plates with one axis between the same sheets are one plate of the sum of their path
    /// differences.
    ///
    /// # Accuracy
    /// Of the light that comes in, against the mean over each bin of light constant per nm: 5e-3 in 31 bins
    /// of the default grid, up to 1 mm of path difference, 1e-2 in 16 (`tests/matter/polarization.rs`).
    #[must_use]
    pub const fn from_path_difference(path_difference_nm: f32, axis_turns: f32) -> Self
    where
        G: Grid,
    {
        let mut elements = [[0.0; 4]; N];
        const_for!(0..N, |k| {
            let center = Spectrum::<Factor, N, G>::center_nm(k);
            let (width, turns) = (Layout::<G, N>::STEP / center, path_difference_nm / center);
            // The mean of 1 / wavelength over the bin, and half of what it changes by from edge to edge.
            let (mean, inner) = (turns + turns * (width * width / 12.0), 1.0 - 0.25 * width * width);
            let half = if inner > 0.0 { 0.5 * turns * width / inner } else { f32::INFINITY };
            let size = mean_of_waves(half);
            elements[k] = [1.0, 0.0, size * cos_turns(mean), size * sin_turns(mean)];
        });
        Retarder(Mueller::new(elements, axis_turns))
    }
}

/// The mean of the cosine over `half_turns` to either side of zero.
const fn mean_of_waves(half_turns: f32) -> f32 {
    if half_turns == 0.0 {
        1.0
    } else if half_turns.is_infinite() {
        0.0
    } else {
        sin_turns(half_turns) / (core::f32::consts::TAU * half_turns)
    }
}
