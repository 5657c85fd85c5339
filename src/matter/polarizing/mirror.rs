//! Mirrors of glass, water and metal at one angle of incidence.

use crate::grid::{Bins, by_fields};
use crate::math::{const_for, sqrt_by_digits};
use crate::matter::polarizing::mueller::along_and_across;
use crate::matter::{Conductor, Mueller};
use crate::spectrum::{Factor, RefractiveIndex, Spectrum};

/// A smooth surface that mirrors light at one angle of incidence, and thereby polarizes it.
///
/// Make it by [`dielectric`](Self::dielectric) for glass or water, by [`conductor`](Self::conductor) for a
/// metal, or by [`new`](Self::new) from known reflectances. Its axis is the direction *across* the plane of
/// incidence (s, parallel to the surface).
///
/// # Example
///
/// ```
/// use nanospectra::{Bins, Light, matter::Mirror};
///
/// // Two parallel panes of glass at Brewster's angle (56.31 degrees). The second one reflects twice the
/// // share that it would reflect of unpolarized light.
/// let pane = Mirror::<1, Bins<500, 600>>::dielectric(&[1.5], 0.554_700_2, 0.0);
/// let sun = Light::<1, Bins<500, 600>>::flat(1.0);
/// let [intensity, ..] = sun.polarized().onto(&pane).onto(&pane).stokes_at(0);
/// assert!((intensity - 0.010_941).abs() < 1e-6);
/// let plain = pane.ignoring_polarization();
/// assert!((sun.onto(&plain).onto(&plain).collected().values()[0] - 0.005_471).abs() < 1e-6);
/// ```
///
/// # Accuracy
/// 9e-7 of the incident light for a dielectric, and 1.8e-6 for a metal up to 89 degrees. Beyond the critical
/// angle of an index n below 1 it is 3e-7 times (1 - n^2) / (sin^2 - n^2), where sin is the sine of the angle
/// of incidence: beside the critical angle this ratio is large (searched in `tests/matter/worst_layers.rs`).
///
/// # Cost
/// 16 bytes for each bin and 8 more. Light off two mirrors to XYZ takes 800 instructions at 31 bins on a
/// Cortex-M4F. Combined with the observer while compiling, by
/// [`looking_at_mirror`](crate::path::PolarizedObserver::looking_at_mirror), they take none.
pub struct Mirror<const N: usize, G = Bins<380, 730>>(Mueller<N, G>);

by_fields!([const N: usize, G] Mirror<N, G>, "Mirror": 0);

impl<const N: usize, G> Mirror<N, G> {
    /// Makes a mirror of a transparent medium, such as glass, water or varnish.
    ///
    /// * `eta`: the refractive index in each bin, relative to the medium that the light comes from.
    /// * `cos_incidence`: the cosine of the angle of incidence, 0..=1.
    /// * `s_axis_turns`: the direction across the plane of incidence, in turns from the reference direction
    ///   of the light.
    ///
    /// Total reflection (`eta` below 1) has the right phase. An `eta` of 1 reflects nothing at any angle, nor
    /// is light from behind (`cos_incidence` below 0) reflected. A cosine above 1 counts as 1, an `eta` below
    /// 0 as 0, and one above 1e15 as 1e15. See the [example](#example).
    #[must_use]
    pub const fn dielectric(eta: &[f32; N], cos_incidence: f32, s_axis_turns: f32) -> Self {
        let mut elements = [[0.0; 4]; N];
        const_for!(0..N, |k| elements[k] = dielectric(eta[k], cos_incidence));
        Mirror(Mueller::new(elements, s_axis_turns))
    }

    /// Makes a mirror of metal from its complex refractive index `eta` + i `k` in each bin, relative to the
    /// medium that the light comes from.
    ///
    /// The angles are as for [`dielectric`](Self::dielectric).
    ///
    /// # Example
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
            // Rounding may bring total reflection to as much as 1 + 1.2e-6.
            let most = if power.p > power.s { power.p } else { power.s };
            let scale = if most > 1.0 { 1.0 / most } else { 1.0 };
            // Here s and p have the same sign at normal incidence, where Fresnel's p has the opposite one.
            let (a, b) = (0.5 * (power.s + power.p), 0.5 * (power.s - power.p));
            *element = [scale * a, scale * b, scale * -turned.re, scale * -turned.im];
        }
        Mirror(Mueller::new(elements, s_axis_turns))
    }

    /// Makes a mirror from known reflectances, for instance of a stack of films or a measured mirror.
    ///
    /// `s` and `p` are the reflectances across the plane of incidence and in it, 0..=1 (a negative one counts
    /// as 0). `phase` holds for each bin the cosine and the sine of the phase of s against p, whose squares
    /// add up to 1. This phase is 0 at normal incidence, where many textbooks have half a turn. The s axis is
    /// as for [`dielectric`](Self::dielectric).
    ///
    /// # Example
    ///
    /// ```
    /// use nanospectra::{Light, Reflectance, matter::Mirror};
    /// // A mirror that reflects 0.9 of s and 0.7 of p: 0.8 of unpolarized light.
    /// let (s, p) = (Reflectance::flat(0.9), Reflectance::flat(0.7));
    /// let mirror = Mirror::<31>::new(&s, &p, &[[1.0, 0.0]; 31], 0.0);
    /// let [i, q, ..] = Light::flat(1.0).polarized().onto(&mirror).stokes_at(0);
    /// assert!((i - 0.8).abs() < 1e-6 && (q - 0.1).abs() < 1e-6);
    /// ```
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

    /// Returns the reflectance that the mirror has for unpolarized light. See the [example](#example).
    #[must_use]
    pub const fn ignoring_polarization(&self) -> Spectrum<Factor, N, G> {
        self.0.ignoring_polarization()
    }

    /// Returns the Mueller matrix of this mirror, one for each bin.
    #[must_use]
    #[inline]
    pub const fn mueller(&self) -> &Mueller<N, G> {
        &self.0
    }
}

/// The elements a, b, c, s of the Mueller matrix of a dielectric surface.
const fn dielectric(eta: f32, cos: f32) -> [f32; 4] {
    if cos < 0.0 || eta == 1.0 {
        return if cos.is_nan() { [f32::NAN; 4] } else { [0.0; 4] };
    }
    // Squares stay in the range of f32 up to here, and no real matter comes near.
    let eta = if eta > 1e15 {
        1e15
    } else if eta < 0.0 {
        0.0
    } else {
        eta
    };
    let cos = if cos > 1.0 { 1.0 } else { cos };
    // Differences of squares, and the ratio of both amplitudes in place of the second one, do not cancel.
    let excess = (eta - 1.0) * (eta + 1.0);
    let sin_2 = (1.0 - cos) * (1.0 + cos);
    let g_2 = excess + cos * cos;
    if g_2 < 0.0 {
        // Total reflection: both amplitudes have the absolute value 1, and p over s is -e^(-2 i phi) with
        // tan(phi) = cos g / sin^2.
        let g = sqrt_by_digits(-g_2);
        let (far, near) = (sin_2 * sin_2, cos * cos * -g_2);
        let c = (near - far) / (near + far);
        let s = 2.0 * sin_2 * cos * g / (near + far);
        return [1.0, 0.0, c, s];
    }
    let g = sqrt_by_digits(g_2);
    let s_amplitude = excess / ((cos + g) * (cos + g));
    let both = cos * g + sin_2;
    // This is 0 only at normal incidence, where s and p are the same.
    let p_over_s = if both == 0.0 { 1.0 } else { (cos * g - sin_2) / both };
    let s = s_amplitude * s_amplitude;
    let p = s * p_over_s * p_over_s;
    [0.5 * (s + p), 0.5 * (s - p), s * p_over_s, 0.0]
}
