//! What a boundary reflects at an angle: the factor in front of mirrors and microfacets, as numbers or
//! spectra.

use crate::geometry::Integrand;
use crate::grid::Bands;
use crate::matter::surface::fresnel::{Conductor, Dielectric};
use crate::spectrum::{Factor, RefractiveIndex, Spectrum};

/// The share of unpolarized light that a smooth boundary reflects at a cosine of incidence.
///
/// A plain number or a [`Reflectance`](crate::Reflectance) is one that does not depend on the angle: 1.0 for
/// the perfect mirror.
///
/// ```
/// # use nanospectra::{Bins, Nodes, matter::{Dielectric, Glass, N_BK7, Reflector}};
/// // A face of a window: 4.2 % in the visible, a little more in blue.
/// let Some(eta) = N_BK7.indices::<31, Nodes<400, 700>>() else { return };
/// let r = Dielectric::new(eta).reflectance(1.0);
/// assert!((r.values()[0] - 0.0440).abs() < 1e-4 && (r.values()[30] - 0.0417).abs() < 1e-4);
/// ```
pub trait Reflector {
    /// A number, or a spectrum.
    type Value: Integrand;

    /// The reflectance, 0..=1, at the cosine of the angle of incidence (below 0 and above 1: the nearer end).
    fn reflectance(&self, cos_i: f32) -> Self::Value;
}

impl Reflector for f32 {
    type Value = f32;

    #[inline]
    fn reflectance(&self, _: f32) -> f32 {
        *self
    }
}

impl<const N: usize, G: Bands> Reflector for Spectrum<Factor, N, G> {
    type Value = Self;

    #[inline]
    fn reflectance(&self, _: f32) -> Self {
        *self
    }
}

impl Reflector for Dielectric {
    type Value = f32;

    fn reflectance(&self, cos_i: f32) -> f32 {
        self.fresnel(cos_i).unpolarized()
    }
}

impl Reflector for Conductor {
    type Value = f32;

    fn reflectance(&self, cos_i: f32) -> f32 {
        self.fresnel(cos_i).unpolarized()
    }
}

impl<const N: usize, G: Bands> Reflector for Dielectric<Spectrum<RefractiveIndex, N, G>> {
    type Value = Spectrum<Factor, N, G>;

    fn reflectance(&self, cos_i: f32) -> Self::Value {
        Spectrum::from_bins(self.eta.values().map(|eta| Dielectric::new(eta).reflectance(cos_i)))
    }
}

impl<const N: usize, G: Bands> Reflector for Conductor<Spectrum<RefractiveIndex, N, G>> {
    type Value = Spectrum<Factor, N, G>;

    fn reflectance(&self, cos_i: f32) -> Self::Value {
        let mut shares = Spectrum::from_bins(*self.eta.values());
        for (share, k) in shares.values_mut().iter_mut().zip(self.k.values()) {
            *share = Conductor::new(*share, *k).reflectance(cos_i);
        }
        shares
    }
}
