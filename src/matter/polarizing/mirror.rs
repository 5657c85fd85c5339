//! Mirrors: glass, water and metal at one angle of incidence.

use crate::grid::{Bins, by_fields};
use crate::math::{const_for, sqrt_by_digits};
use crate::matter::polarizing::mueller::along_and_across;
use crate::matter::{Conductor, Mueller};
use crate::spectrum::{Factor, RefractiveIndex, Spectrum};

/// A smooth surface that mirrors the light at one angle of incidence; its axis is the direction *across* the
/// plane of incidence (s, parallel to the surface).
///
/// ```
/// use nanospectra::{Bins, Light, matter::Mirror};
///
/// // Two panes of glass at Brewster's angle (56.31 degrees), parallel: the second reflects twice what it would of
/// // unpolarized light.
/// let pane = Mirror::<1, Bins<500, 600>>::dielectric(&[1.5], 0.554_700_2, 0.0);
/// let sun = Light::<1, Bins<500, 600>>::flat(1.0);
/// let [intensity, ..] = sun.polarized().onto(&pane).onto(&pane).stokes_at(0);
/// assert!((intensity - 0.010_941).abs() < 1e-6);
/// let plain = pane.ignoring_polarization();
/// assert!((sun.onto(&plain).onto(&plain).collected().values()[0] - 0.005_471).abs() < 1e-6);
/// ```
///
/// # Accuracy
/// 8e-7 of the incident light, up to 89 degrees, and its phase 3e-7; beside the critical angle what the
/// rounding of the cosine costs (`tests/matter/polarization.rs`).
///
/// # Cost
/// 16 bytes for each bin and 8. Light off two mirrors to XYZ takes 800 instructions at 31 bins on a
/// Cortex-M4F; folded into the eye none.
pub struct Mirror<const N: usize, G = Bins<380, 730>>(Mueller<N, G>);

by_fields!([const N: usize, G] Mirror<N, G>, "Mirror": 0);

impl<const N: usize, G> Mirror<N, G> {
    /// The Mueller matrix.
    #[must_use]
    #[inline]
    pub const fn mueller(&self) -> &Mueller<N, G> {
        &self.0
    }

    /// A mirror of glass, water or varnish: `eta` is the index of refraction of each bin, relative to the
    /// medium the light comes from; `cos_incidence` 0..=1 is the cosine of the angle of incidence,
    /// `s_axis_turns` the direction across the plane of incidence, in turns from the reference direction of
    /// the light.
    ///
    /// Total reflection (`eta` below 1) has its phase. An `eta` of 1 is no surface, at any angle; light from
    /// behind (`cos_incidence` below 0) is not reflected. A cosine above 1 counts as 1, an `eta` above 1e15
    /// as that.
    #[must_use]
    pub const fn dielectric(eta: &[f32; N], cos_incidence: f32, s_axis_turns: f32) -> Self {
        let mut elements = [[0.0; 4]; N];
        const_for!(0..N, |k| elements[k] = dielectric(eta[k], cos_incidence));
        Mirror(Mueller::new(elements, s_axis_turns))
    }

    /// A mirror of metal: `eta` and `k` are the parts of its index in each bin, relative to the medium the
    /// light comes from; angles as for [`dielectric`](Self::dielectric).
    ///
    /// ```
    /// # use nanospectra::{Light, Spectrum, matter::Mirror};
    /// let (eta, k) = (Spectrum::flat(0.05), Spectrum::flat(3.3)); // silver, nearly
    /// let silver = Mirror::<31>::conductor(&eta, &k, 0.5, 0.0);
    /// let [i, q, ..] = Light::flat(1.0).polarized().onto(&silver).stokes_at(0);
    /// assert!(i > 0.97 && q > 0.005); // s is reflected better than p
    /// ```
    #[must_use]
    pub fn conductor(
        eta: &Spectrum<RefractiveIndex, N, G>,
        k: &Spectrum<RefractiveIndex, N, G>,
        cos_incidence: f32,
        s_axis_turns: f32,
    ) -> Self {
        let mut elements = [[0.0; 4]; N];
        for (element, (eta, k)) in elements.iter_mut().zip(eta.0.iter().zip(&k.0)) {
            if cos_incidence < 0.0 {
                continue;
            }
            let amplitudes = Conductor::new(*eta, *k).amplitudes(cos_incidence);
            let (power, turned) = (amplitudes.power(), amplitudes.retardation());
            // Total reflection is rounded to as much as 1 + 1.2e-6.
            let most = if power.p > power.s { power.p } else { power.s };
            let scale = if most > 1.0 { 1.0 / most } else { 1.0 };
            // Along the unfolded path s and p agree at right angles, where Fresnel's p is turned round.
            let (a, b) = (0.5 * (power.s + power.p), 0.5 * (power.s - power.p));
            *element = [scale * a, scale * b, scale * -turned.re, scale * -turned.im];
        }
        Mirror(Mueller::new(elements, s_axis_turns))
    }

    /// A mirror of known reflectances (a stack of films, a measured mirror), from those across the plane of
    /// incidence (s) and in it (p), 0..=1 (below: 0), and the cosine and sine of the phase of s against p,
    /// whose squares add up to 1. That phase is 0 at right angles (where many textbooks have half a turn);
    /// the s axis as for [`dielectric`](Self::dielectric).
    #[must_use]
    pub const fn new(
        s: &Spectrum<Factor, N, G>,
        p: &Spectrum<Factor, N, G>,
        phase: &[[f32; 2]; N],
        s_axis_turns: f32,
    ) -> Self {
        let mut elements = [[0.0; 4]; N];
        const_for!(0..N, |k| {
            let ([a, b, both], [cos, sin]) = (along_and_across(s.0[k], p.0[k]), phase[k]);
            elements[k] = [a, b, both * cos, both * sin];
        });
        Mirror(Mueller::new(elements, s_axis_turns))
    }

    /// Its reflectance for unpolarized light.
    #[must_use]
    pub const fn ignoring_polarization(&self) -> Spectrum<Factor, N, G> {
        self.0.ignoring_polarization()
    }
}

/// a, b, c, s of a dielectric surface.
const fn dielectric(eta: f32, cos: f32) -> [f32; 4] {
    if cos < 0.0 || eta == 1.0 {
        return if cos.is_nan() { [f32::NAN; 4] } else { [0.0; 4] };
    }
    // Squares stay in range up to here, and no matter comes near.
    let eta = if eta > 1e15 { 1e15 } else { eta };
    let cos = if cos > 1.0 { 1.0 } else { cos };
    // As differences of squares, and the ratio of both amplitudes rather than both: nothing cancels.
    let excess = (eta - 1.0) * (eta + 1.0);
    let sin_2 = (1.0 - cos) * (1.0 + cos);
    let g_2 = excess + cos * cos;
    if g_2 < 0.0 {
        // Total: both amplitudes of size 1, p against s turned by -e^(-2 i phi) with tan(phi) = cos g /
        // sin^2.
        let g = sqrt_by_digits(-g_2);
        let (far, near) = (sin_2 * sin_2, cos * cos * -g_2);
        let c = (near - far) / (near + far);
        let s = 2.0 * sin_2 * cos * g / (near + far);
        return [1.0, 0.0, c, s];
    }
    let g = sqrt_by_digits(g_2);
    let s_amplitude = excess / ((cos + g) * (cos + g));
    let both = cos * g + sin_2;
    // Nothing is left of both only at right angles, where s and p are one.
    let p_over_s = if both == 0.0 { 1.0 } else { (cos * g - sin_2) / both };
    let s = s_amplitude * s_amplitude;
    let p = s * p_over_s * p_over_s;
    [0.5 * (s + p), 0.5 * (s - p), s * p_over_s, 0.0]
}
