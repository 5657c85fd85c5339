//! The share that a boundary reflects at an angle, as a number or a spectrum: the factor that mirrors and
//! microfacets apply.

use crate::geometry::Integrand;
use crate::grid::Bands;
use crate::matter::surface::fresnel::{Conductor, Dielectric};
use crate::spectrum::{Factor, RefractiveIndex, Spectrum};

/// A smooth boundary that reflects a share of unpolarized light, depending on the angle of incidence.
///
/// [`Dielectric`], [`Conductor`] and a film on a grid
/// ([`ThinFilm::on_grid`](crate::matter::ThinFilm::on_grid)) are boundaries. A plain number or a
/// [`Reflectance`](crate::Reflectance) is one that does not depend on the angle, such as 1.0 for the perfect
/// mirror. [`Microfacet`](crate::matter::Microfacet) and [`Smooth`](crate::matter::Smooth) make surfaces of
/// them.
///
/// # Example
///
/// ```
/// use nanospectra::{Bins, Nodes, matter::{Dielectric, Glass, N_BK7, Reflector}};
/// // A face of a window reflects 4.2 % in the visible range, and a little more in blue.
/// let Some(eta) = N_BK7.indices::<31, Nodes<400, 700>>() else { return };
/// let r = Dielectric::new(eta).reflectance(1.0);
/// assert!((r.values()[0] - 0.0440).abs() < 1e-4 && (r.values()[30] - 0.0417).abs() < 1e-4);
/// ```
pub trait Reflector {
    /// The type of the reflectance: a number, or a spectrum that holds one for each bin.
    type Value: Integrand;

    /// Computes the reflectance for unpolarized light, 0..=1.
    ///
    /// `cos_i` is the cosine of the angle of incidence; below 0 or above 1 it counts as the nearer end, and
    /// NaN gives NaN. See the [example](Reflector#example).
    fn reflectance(&self, cos_i: f32) -> Self::Value;
}

impl Reflector for f32 {
    type Value = f32;

    #[inline]
    fn reflectance(&self, cos_i: f32) -> f32 {
        if cos_i.is_nan() { cos_i } else { *self }
    }
}

impl<const N: usize, G: Bands> Reflector for Spectrum<Factor, N, G> {
    type Value = Self;

    #[inline]
    fn reflectance(&self, cos_i: f32) -> Self {
        if cos_i.is_nan() { *self * cos_i } else { *self }
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
