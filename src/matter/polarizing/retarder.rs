//! Retarders, which are plates that delay light of one polarization against the other.

use crate::grid::{Bands, Bins, Grid, Layout, by_fields};
use crate::math::{const_for, cos_turns, sin_turns};
use crate::matter::Mueller;
use crate::spectrum::{Factor, Spectrum};

/// A plate that delays light polarized across its fast axis against light polarized along it.
///
/// Make it by [`flat`](Self::flat) or, for a plate whose retardance depends on the wavelength as that of a
/// real one does, by [`from_path_difference`](Self::from_path_difference).
///
/// # Example
///
/// ```
/// use nanospectra::{Bins, Light};
/// use nanospectra::matter::{Polarizer, Retarder};
///
/// // A quarter-wave plate at 45 degrees behind a polarizer makes circularly polarized light: only V is left.
/// type Grid = Bins<545, 555>;
/// let sheet = Polarizer::<1, Grid>::ideal(0.0);
/// let quarter = Retarder::flat(0.25, 0.125);
/// let [i, q, u, v] = Light::flat(1.0).polarized().through(&sheet).through(&quarter).stokes_at(0);
/// assert!((i - 0.5).abs() < 1e-6 && q.abs() < 1e-6 && u.abs() < 1e-6 && (v.abs() - 0.5).abs() < 1e-6);
/// // A path difference of 137.5 nm is a quarter of a wave at 550 nm.
/// let plate = Retarder::from_path_difference(137.5, 0.125);
/// let [_, _, _, same] = Light::flat(1.0).polarized().through(&sheet).through(&plate).stokes_at(0);
/// assert!((v - same).abs() < 1e-3);
/// ```
pub struct Retarder<const N: usize, G = Bins<380, 730>>(Mueller<N, G>);

by_fields!([const N: usize, G] Retarder<N, G>, "Retarder": 0);

impl<const N: usize, G> Retarder<N, G> {
    /// Makes a plate that has the same retardance in every bin.
    ///
    /// `retardance_turns` is in turns of phase, 0.25 for a quarter-wave plate. `axis_turns` is the angle of
    /// the fast axis, in turns from the reference direction of the light. See the [example](#example).
    #[must_use]
    pub const fn flat(retardance_turns: f32, axis_turns: f32) -> Self {
        let (c, s) = (cos_turns(retardance_turns), sin_turns(retardance_turns));
        Retarder(Mueller::new([[1.0, 0.0, c, s]; N], axis_turns))
    }
}

impl<const N: usize, G: Bands> Retarder<N, G> {
    /// Makes a plate that has the same path difference at all wavelengths, in nm: 137.5 for a quarter-wave
    /// plate at 550 nm.
    ///
    /// The mean effect over each bin is kept, so light behind a plate of many waves is nearly unpolarized. Do
    /// not chain plates that have the same axis and stand between the same sheets: make one plate of the sum
    /// of their path differences. See the [example](#example).
    ///
    /// # Accuracy
    /// The error is 5e-3 of the incident light in 31 bins of the default grid, and 1e-2 in 16 bins, for path
    /// differences up to 1 mm. It is measured against the exact mean over each bin of a light that has the
    /// same power at every wavelength (`tests/matter/polarization.rs`).
    #[must_use]
    pub const fn from_path_difference(path_difference_nm: f32, axis_turns: f32) -> Self
    where
        G: Grid,
    {
        let mut elements = [[0.0; 4]; N];
        const_for!(0..N, |k| {
            let center = Spectrum::<Factor, N, G>::center_nm(k);
            let (width, turns) = (Layout::<G, N>::STEP / center, path_difference_nm / center);
            // The mean of 1 / wavelength over the bin, and half of its change from edge to edge.
            let (mean, inner) = (turns + turns * (width * width / 12.0), 1.0 - 0.25 * width * width);
            let half = if inner > 0.0 { 0.5 * turns * width / inner } else { f32::INFINITY };
            let size = mean_of_waves(half);
            elements[k] = [1.0, 0.0, size * cos_turns(mean), size * sin_turns(mean)];
        });
        Retarder(Mueller::new(elements, axis_turns))
    }
}

impl<const N: usize, G> Retarder<N, G> {
    /// Returns the Mueller matrix of this plate, one for each bin.
    #[must_use]
    #[inline]
    pub const fn mueller(&self) -> &Mueller<N, G> {
        &self.0
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
