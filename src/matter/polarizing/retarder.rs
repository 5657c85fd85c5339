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
    /// The error is 0.7 r^2 + 1.4e-6 w of the incident light, whatever its polarization. Here r is half the
    /// width of the bin over its center, and w the number of waves, counted up to 1 / (6 r): the first term
    /// comes from the width, the second from rounding. This makes 1.6e-4 in 31 bins of the default grid, and
    /// 6e-4 in 16 bins, for path differences up to 1 mm. It is measured against the exact mean over each bin
    /// of a light that has the same power at every wavelength (`tests/matter/worst_matter.rs`).
    #[must_use]
    pub const fn from_path_difference(path_difference_nm: f32, axis_turns: f32) -> Self
    where
        G: Grid,
    {
        let mut elements = [[0.0; 4]; N];
        const_for!(0..N, |k| {
            let center = Spectrum::<Factor, N, G>::center_nm(k);
            elements[k] = mean_over_bin(path_difference_nm / center, 0.5 * Layout::<G, N>::STEP / center);
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

/// The elements for a bin that reaches from 1 - `reach` to 1 + `reach` of its center, where the retardance is
/// `turns`.
///
/// With the wavelength l in units of the center, s = 1 / l is 1 / (1 - reach^2) in the middle of its range,
/// and the mean of e^(2 pi i turns s) over l is a mean over s with the weight s^-2. The weight is expanded
/// in Legendre's polynomials, the first two of which bring the spherical Bessel functions j0 and j1.
const fn mean_over_bin(turns: f32, reach: f32) -> [f32; 4] {
    let inner = (1.0 - reach) * (1.0 + reach);
    let middle = turns / inner;
    let half = core::f32::consts::TAU * (middle * reach);
    if inner <= 0.0 || half.is_infinite() {
        // A bin that reaches to no wavelength, or has more waves than can be counted, mixes all phases.
        return [1.0, 0.0, 0.0 * turns, 0.0 * turns];
    }
    let [j0, j1] = bessel(half, middle * reach);
    let (c, s, tilt) = (cos_turns(middle), sin_turns(middle), -2.0 * reach * j1);
    // The mean is (j0 + i tilt) (c + i s).
    [1.0, 0.0, j0 * c - tilt * s, j0 * s + tilt * c]
}

/// The spherical Bessel functions j0 and j1 of an angle, which is given in radians and in turns.
const fn bessel(angle: f32, turns: f32) -> [f32; 2] {
    if angle.abs() < 0.3 {
        // The differences below would cancel.
        let square = angle * angle;
        let j0 = 1.0 - square * (1.0 / 6.0 - square / 120.0);
        return [j0, angle * (1.0 / 3.0 - square * (1.0 / 30.0 - square / 840.0))];
    }
    let j0 = sin_turns(turns) / angle;
    [j0, (j0 - cos_turns(turns)) / angle]
}
