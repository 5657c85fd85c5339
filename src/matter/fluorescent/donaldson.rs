//! Fluorescent matter of any kind, by its bispectral matrix.

use crate::grid::{Bands, Bins, Grid, by_fields};
use crate::math::const_for;
use crate::matter::fluorescent::dye::{FluorescenceError, ROUNDING, wavelength};
use crate::matter::{Dye, Effect, Foldable};
use crate::price::{Effects, Price, Priced};
use crate::spectrum::{Factor, Power, Spectrum};
use crate::sum::rows;
use core::array::from_ref;
use core::marker::PhantomData;

/// Fluorescent matter of any kind: which share of the light of bin `i` leaves in bin `k`, for all `k >= i`
/// (Donaldson's bispectral radiance factors, packed). The diagonal is the ordinary reflectance.
///
/// `P` is the number of pairs, `N * (N + 1) / 2`: `Donaldson<31, 496>`. Any other does not pass
/// `cargo build`.
///
/// # Cost
/// `P` multiply-adds and `4 P` bytes: at 31 bins light off a matrix to XYZ takes 4900 instructions on a
/// Cortex-M4F. Folded into the eye it takes none: a static scene with a vest in it is 327, as any other.
///
/// # Reference
/// R. Donaldson, "Spectrophotometry of fluorescent pigments", Brit. J. Appl. Phys. 5 (1954).
pub struct Donaldson<const N: usize, const P: usize, G = Bins<380, 730>> {
    /// For bin 0 what it becomes in bins 0, 1, .. N - 1; for bin 1 in 1, .. N - 1; and so on.
    columns: [f32; P],
    grid: PhantomData<fn() -> G>,
}

by_fields!([const N: usize, const P: usize, G] Donaldson<N, P, G>, "Donaldson": columns);

impl<const N: usize, const P: usize, G: Bands> Donaldson<N, P, G> {
    const NONE: Self = {
        assert!(P == N * (N + 1) / 2, "a Donaldson matrix of N bins has N * (N + 1) / 2 pairs");
        Donaldson { columns: [0.0; P], grid: PhantomData }
    };

    /// Fluorescent matter from a measured matrix: `matrix[k][i]` is the share of the light of bin `i` that
    /// leaves in bin `k`, as power per nm in and out.
    ///
    /// # Errors
    /// Values that are negative or not finite; any below the diagonal's wavelength (`k < i`) other than zero;
    /// light of one bin that leaves with more energy, or as more photons, than it came.
    ///
    /// ```
    /// use nanospectra::matter::{Donaldson, FluorescenceError};
    /// use nanospectra::{Bins, Light};
    ///
    /// // 300, 400 and 500 nm: half of the first comes back in the second.
    /// type Grid = Bins<250, 550>;
    /// let matrix = [[0.1, 0.0, 0.0], [0.5, 0.2, 0.0], [0.0, 0.0, 0.3]];
    /// let paper = Donaldson::<3, 6, Grid>::new(&matrix)?;
    /// let leaving = Light::<3, Grid>::flat(1.0).onto(&paper).collected();
    /// assert_eq!(leaving.values(), &[0.1, 0.7, 0.3]);
    ///
    /// // 0.8 of the energy at 400 nm would be 1.07 photons for each one at 300 nm.
    /// let matrix = [[0.0, 0.0, 0.0], [0.8, 0.2, 0.0], [0.0, 0.0, 0.3]];
    /// assert_eq!(Donaldson::<3, 6, Grid>::new(&matrix), Err(FluorescenceError::Photons { bin: 0 }));
    /// # Ok::<(), FluorescenceError>(())
    /// ```
    pub const fn new(matrix: &[[f32; N]; N]) -> Result<Self, FluorescenceError>
    where
        G: Grid,
    {
        let mut packed = Self::NONE;
        let mut next = 0;
        const_for!(0..N, |i| {
            let (mut energy, mut photons) = (0.0, 0.0);
            const_for!(0..N, |k| {
                let share = matrix[k][i];
                if !(0.0 <= share && share < f32::INFINITY) {
                    return Err(FluorescenceError::OutOfRange { bin: i });
                }
                if k >= i {
                    packed.add(next, share);
                    next += 1;
                } else if share != 0.0 {
                    return Err(FluorescenceError::AntiStokes { from: i, to: k });
                }
                energy += share as f64;
                photons += share as f64 * wavelength::<N, G>(k) / wavelength::<N, G>(i);
            });
            if energy > 1.0 + ROUNDING {
                return Err(FluorescenceError::Energy { bin: i });
            }
            if photons > 1.0 + ROUNDING {
                return Err(FluorescenceError::Photons { bin: i });
            }
        });
        Ok(packed)
    }

    /// The matrix of a surface that does not fluoresce: its reflectance on the diagonal.
    #[must_use]
    pub const fn from_reflectance(reflectance: &Spectrum<Factor, N, G>) -> Self {
        let mut packed = Self::NONE;
        let mut start = 0;
        const_for!(0..N, |i| {
            packed.add(start, reflectance.0[i]);
            start += N - i;
        });
        packed
    }

    /// The matrix of a dye, without what it emits at shorter waves than it absorbs.
    #[must_use]
    pub const fn from_dye(dye: &Dye<N, G>) -> Self {
        let mut packed = Self::from_reflectance(&dye.reflectance());
        let mut next = 0;
        const_for!(0..N, |i| {
            const_for!(i..N, |k| {
                packed.add(next, dye.emits[k] * dye.absorbs[i]);
                next += 1;
            });
        });
        packed
    }
}

impl<const N: usize, const P: usize, G> Donaldson<N, P, G> {
    /// Adds to a pair. (It is one of the `P`; saying so keeps the panic out of an image.)
    const fn add(&mut self, pair: usize, share: f32) {
        if pair < P {
            self.columns[pair] += share;
        }
    }

    /// Of each bin of light, what it becomes in all bins; zero in those of shorter waves.
    fn columns(&self) -> impl Iterator<Item = [f32; N]> {
        let mut rest = self.columns.as_slice();
        (0..N).map_while(move |i| {
            let (column, next) = rest.split_at_checked(N - i)?;
            rest = next;
            let mut bins = [0.0; N];
            bins.iter_mut().skip(i).zip(column).for_each(|(bin, share)| *bin = *share);
            Some(bins)
        })
    }

    /// [`Foldable::transposed`] in f64, for `const` use.
    pub(crate) const fn transposed_in_f64(&self, weights: &[f32; N]) -> [f32; N] {
        let mut before = [0.0; N];
        let mut next = 0;
        const_for!(0..N, |i| {
            let mut sum = 0.0;
            const_for!(i..N, |k| {
                // (As in `add`.)
                if next < P {
                    sum += weights[k] as f64 * self.columns[next] as f64;
                }
                next += 1;
            });
            before[i] = sum as f32;
        });
        before
    }
}

impl<const N: usize, const P: usize, G> Effect<N, G> for Donaldson<N, P, G> {
    #[inline]
    fn leaving(&self, light: &Spectrum<Power, N, G>) -> Spectrum<Power, N, G> {
        let mut leaving = [0.0; N];
        let mut columns = self.columns.as_slice();
        for (i, value) in light.0.iter().enumerate() {
            let Some((column, rest)) = columns.split_at_checked(N - i) else { break };
            for (out, share) in leaving.iter_mut().skip(i).zip(column) {
                *out += share * value;
            }
            columns = rest;
        }
        Spectrum::unchecked(leaving)
    }
}

impl<const N: usize, const P: usize, G> Foldable<N, G> for Donaldson<N, P, G> {
    fn transposed(&self, weights: &[f32; N]) -> [f32; N] {
        let mut before = [f32::NAN; N];
        for (before, column) in before.iter_mut().zip(self.columns()) {
            [*before] = rows(from_ref(weights), &column);
        }
        before
    }

    /// The ordinary reflectance: the diagonal.
    fn without_effect(&self) -> Spectrum<Factor, N, G> {
        let mut diagonal = [f32::NAN; N];
        for (k, (value, column)) in diagonal.iter_mut().zip(self.columns()).enumerate() {
            *value = column.get(k).copied().unwrap_or(f32::NAN);
        }
        Spectrum::unchecked(diagonal)
    }

    fn name(&self) -> &'static str {
        "donaldson"
    }

    fn price(&self) -> Price {
        Self::PRICE
    }
}

impl<const N: usize, const P: usize, G> Priced for Donaldson<N, P, G> {
    const PRICE: Price = Price { effects: Effects::FLUORESCENCE, multiply_adds: P, bytes: 4 * P };
}
