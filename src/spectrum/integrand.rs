//! Integrals over directions whose integrand is a spectrum: every band is integrated in the same pass.

use crate::geometry::Integrand;
use crate::grid::Bands;
use crate::spectrum::Spectrum;

impl<Q, const N: usize, G: Bands> Integrand for Spectrum<Q, N, G> {
    const ZERO: Self = Spectrum::from_bins([0.0; N]);

    fn accumulate(&mut self, lost: &mut Self, value: &Self) {
        let sums = self.values_mut().iter_mut().zip(lost.values_mut());
        sums.zip(value.values()).for_each(|((sum, lost), value)| sum.accumulate(lost, value));
    }

    fn map(self, f: impl Fn(f32) -> f32) -> Self {
        self.each(f)
    }

    fn peak(&self) -> f32 {
        Spectrum::peak(self)
    }

    fn distance(&self, other: &Self) -> f32 {
        let differences = self.values().iter().zip(other.values()).map(|(a, b)| (a - b).abs());
        differences.fold(0.0, |most, d| if d <= most || most.is_nan() { most } else { d })
    }
}
