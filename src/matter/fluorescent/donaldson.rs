//! Fluorescent matter of any kind, described by its bispectral matrix.

use crate::grid::{Bands, Bins, Grid, by_fields};
use crate::math::const_for;
use crate::matter::fluorescent::dye::{FluorescenceError, ROUNDING, wavelength};
use crate::matter::{Dye, Effect, Foldable};
use crate::price::{Effects, Price, Priced};
use crate::spectrum::{Factor, Power, Spectrum};
use crate::sum::rows;
use core::array::from_ref;
use core::marker::PhantomData;

/// Fluorescent matter of any kind, described by the share of the light of each bin that leaves in each bin.
///
/// It is made by [`new`](Self::new) from a measured matrix of Donaldson's bispectral radiance factors. The
/// diagonal of the matrix is the ordinary reflectance, and only the pairs `k >= i` are stored, because light
/// of bin `i` leaves at its own wavelength or a longer one. If your matter emits one spectrum however it is
/// excited, a [`Dye`] is smaller and faster.
///
/// `P` is the number of stored pairs, `N * (N + 1) / 2`, as in `Donaldson<31, 496>`. Any other number is
/// refused by `cargo build`.
///
/// # Example
///
/// ```
/// use nanospectra::matter::Donaldson;
/// use nanospectra::{Bins, Light, Reflectance};
///
/// // A surface that does not fluoresce: its reflectance lies on the diagonal.
/// type Grid = Bins<400, 700>;
/// let gray = Donaldson::<3, 6, Grid>::from_reflectance(&Reflectance::flat(0.5));
/// let leaving = Light::from_bins([1.0, 2.0, 4.0]).onto(&gray).collected();
/// assert_eq!(leaving.values(), &[0.5, 1.0, 2.0]);
/// ```
///
/// # Cost
/// `P` multiply-adds and `4 P` bytes: at 31 bins light off a matrix to XYZ takes 4900 instructions on a
/// Cortex-M4F. Combined with the observer while compiling, by
/// [`looking_at_donaldson`](crate::Observer::looking_at_donaldson), it takes none: a static scene with a vest
/// in it takes 327, as many as any other.
///
/// # Reference
/// R. Donaldson, "Spectrophotometry of fluorescent pigments", Brit. J. Appl. Phys. 5 (1954).
pub struct Donaldson<const N: usize, const P: usize, G = Bins<380, 730>> {
    /// The shares of the light of bin 0 that leave in bins 0, 1, .. N - 1; of bin 1 in bins 1, .. N - 1; and
    /// so on.
    columns: [f32; P],
    grid: PhantomData<fn() -> G>,
}

by_fields!([const N: usize, const P: usize, G] Donaldson<N, P, G>, "Donaldson": columns);

impl<const N: usize, const P: usize, G: Bands> Donaldson<N, P, G> {
    const NONE: Self = {
        assert!(P == N * (N + 1) / 2, "a Donaldson matrix of N bins has N * (N + 1) / 2 pairs");
        Donaldson { columns: [0.0; P], grid: PhantomData }
    };

    /// Makes fluorescent matter from a measured matrix.
    ///
    /// `matrix[k][i]` is the share of the light of bin `i` that leaves in bin `k`, where both are power per
    /// nm. The energy of each bin is added up in f64.
    ///
    /// # Errors
    /// * [`FluorescenceError::OutOfRange`]: a share is negative or not finite.
    /// * [`FluorescenceError::AntiStokes`]: a share is not zero although light would leave at a shorter
    ///   wavelength than it came with (`k < i`).
    /// * [`FluorescenceError::Energy`], [`FluorescenceError::Photons`]: the light of a bin leaves with more
    ///   energy, or as more photons, than it came with.
    ///
    /// # Example
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

    /// Makes the matrix of a surface that does not fluoresce, which has its reflectance on the diagonal. See
    /// the [example](#example).
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

    /// Makes the matrix of a dye, but leaves out what the dye emits at shorter wavelengths than it absorbs.
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
    /// Adds to the share of a pair. The index is always below `P`; testing it here keeps a panic out of the
    /// program.
    const fn add(&mut self, pair: usize, share: f32) {
        if pair < P {
            self.columns[pair] += share;
        }
    }

    /// For each bin of light, the shares that leave in all bins: zero in those of shorter wavelengths.
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
                // (The test is for the same reason as in `add`.)
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

    /// The ordinary reflectance, which is the diagonal of the matrix.
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
