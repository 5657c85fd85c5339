//! Matter that treats directions across the beam differently: mirrors, polarizers, retarders.

use crate::grid::{Bins, Grid, Layout, by_fields};
use crate::math::{cos_turns, sin_turns, sqrt_by_digits};
use crate::matter::Conductor;
use crate::price::{Effects, Price, Priced};
use crate::spectrum::{Factor, Index, Spectrum};
use core::marker::PhantomData;

/// What all of them are in their own axes, for each bin: the Mueller matrix
/// `[[a, b, 0, 0], [b, a, 0, 0], [0, 0, c, s], [0, 0, -s, c]]`; and the direction of their first axis.
pub struct Mueller<const N: usize, G = Bins<380, 730>> {
    /// a, b, c, s.
    elements: [[f32; 4]; N],
    /// Cosine and sine of twice the angle of the axis.
    cos: f32,
    sin: f32,
    grid: PhantomData<G>,
}

by_fields!([const N: usize, G] Mueller<N, G>, "Mueller": elements, cos, sin);

impl<const N: usize, G> Mueller<N, G> {
    const fn new(elements: [[f32; 4]; N], axis_turns: f32) -> Self {
        // (From 2^23 on these are whole turns, doubled or not; doubled, the largest would be infinite.)
        let twice = if axis_turns.abs() > 1e30 { axis_turns } else { 2.0 * axis_turns };
        let (cos, sin) = (cos_turns(twice), sin_turns(twice));
        Mueller { elements, cos, sin, grid: PhantomData }
    }

    /// What becomes of a Stokes vector in bin `k`; NaN beyond the last.
    #[must_use]
    #[inline]
    pub fn turn(&self, k: usize, [i, q, u, v]: [f32; 4]) -> [f32; 4] {
        let [a, b, c, s] = self.elements.get(k).copied().unwrap_or([f32::NAN; 4]);
        let (q, u) = (self.cos * q + self.sin * u, self.cos * u - self.sin * q);
        let (i, q) = (a * i + b * q, b * i + a * q);
        let (u, v) = (c * u + s * v, c * v - s * u);
        [i, self.cos * q - self.sin * u, self.sin * q + self.cos * u, v]
    }

    /// The multiplications of [`turn_natural`](Self::turn_natural) in all bins.
    pub(crate) const NATURAL: usize = 4 * N;

    /// What becomes of unpolarized light in bin `k`: a quarter of the work, since no compiler may leave out a product
    /// with zero.
    #[inline]
    pub(crate) fn turn_natural(&self, k: usize, intensity: f32) -> [f32; 4] {
        let [a, b, ..] = self.elements.get(k).copied().unwrap_or([f32::NAN; 4]);
        let polarized = b * intensity;
        [a * intensity, self.cos * polarized, self.sin * polarized, 0.0]
    }

    /// The share of unpolarized light that leaves: the effect left out, by name.
    #[must_use]
    pub const fn ignoring_polarization(&self) -> Spectrum<Factor, N, G> {
        let mut values = [0.0; N];
        let mut k = 0;
        while k < N {
            values[k] = self.elements[k][0];
            k += 1;
        }
        Spectrum::unchecked(values)
    }

    /// What becomes of the row of an observer that looks at it: the transpose of [`turn`](Self::turn).
    pub(crate) const fn fold(&self, k: usize, [i, q, u, v]: [f32; 4]) -> [f32; 4] {
        let [a, b, c, s] = self.elements[k];
        let (q, u) = (self.cos * q + self.sin * u, self.cos * u - self.sin * q);
        let (i, q) = (a * i + b * q, b * i + a * q);
        let (u, v) = (c * u - s * v, c * v + s * u);
        [i, self.cos * q - self.sin * u, self.sin * q + self.cos * u, v]
    }
}

impl<const N: usize, G> Priced for Mueller<N, G> {
    const PRICE: Price = Price { effects: Effects::POLARIZATION, multiply_adds: 16 * N, bytes: 16 * N + 8 };
}

/// A smooth surface that mirrors the light at one angle of incidence; its axis is the direction *across* the plane of
/// incidence (s, parallel to the surface).
///
/// ```
/// use nanospectra::matter::Mirror;
/// use nanospectra::{Bins, Light};
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
/// 8e-7 of the incident light, up to 89 degrees, and its phase 3e-7; beside the critical angle what the rounding of
/// the cosine costs (`tests/matter/polarization.rs`).
///
/// # Cost
/// 16 bytes for each bin and 8. Light off two mirrors to XYZ takes 800 instructions at 31 bins on a Cortex-M4F; folded into
/// the eye none.
pub struct Mirror<const N: usize, G = Bins<380, 730>>(Mueller<N, G>);

by_fields!([const N: usize, G] Mirror<N, G>, "Mirror": 0);

/// A sheet that lets light through along one axis, its own, and not across it.
pub struct Polarizer<const N: usize, G = Bins<380, 730>>(Mueller<N, G>);

by_fields!([const N: usize, G] Polarizer<N, G>, "Polarizer": 0);

/// A plate that delays light across its (fast) axis against light along it.
pub struct Retarder<const N: usize, G = Bins<380, 730>>(Mueller<N, G>);

by_fields!([const N: usize, G] Retarder<N, G>, "Retarder": 0);

impl<const N: usize, G> Mirror<N, G> {
    /// The Mueller matrix.
    #[must_use]
    #[inline]
    pub const fn mueller(&self) -> &Mueller<N, G> {
        &self.0
    }

    /// Glass, water, varnish: `eta` is the index of refraction of each bin, relative to the medium the light comes
    /// from; `cos_incidence` 0..=1 is the cosine of the angle of incidence, `s_axis_turns` the direction across the
    /// plane of incidence, in turns from the reference direction of the light.
    ///
    /// From within the denser medium (`eta` below 1) total reflection has its phase. At right angles the plane of
    /// incidence is undefined and does not matter. An `eta` of 1 is no surface, at any angle; light from behind
    /// (`cos_incidence` below 0) is not reflected. A cosine above 1 counts as 1, an `eta` above 1e15 as that.
    #[must_use]
    pub const fn dielectric(eta: &[f32; N], cos_incidence: f32, s_axis_turns: f32) -> Self {
        let mut elements = [[0.0; 4]; N];
        let mut k = 0;
        while k < N {
            elements[k] = dielectric(eta[k], cos_incidence);
            k += 1;
        }
        Mirror(Mueller::new(elements, s_axis_turns))
    }

    /// A metal: `eta` and `k` are the parts of its index in each bin, relative to the medium the light comes from; angles
    /// as for [`dielectric`](Self::dielectric).
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
        eta: &Spectrum<Index, N, G>,
        k: &Spectrum<Index, N, G>,
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

    /// From reflectances across the plane of incidence (s) and in it (p), 0..=1 (what is negative counts as 0), and the
    /// cosine and sine of the phase of s against p, whose squares add up to 1: a metal, a stack of films, a measured
    /// mirror. That phase is 0 for a mirror met at right angles (where many textbooks have half a turn); the s axis as
    /// for [`dielectric`](Self::dielectric).
    #[must_use]
    pub const fn new(
        s: &Spectrum<Factor, N, G>,
        p: &Spectrum<Factor, N, G>,
        phase: &[[f32; 2]; N],
        s_axis_turns: f32,
    ) -> Self {
        let mut elements = [[0.0; 4]; N];
        let mut k = 0;
        while k < N {
            let ([a, b, both], [cos, sin]) = (along_and_across(s.0[k], p.0[k]), phase[k]);
            elements[k] = [a, b, both * cos, both * sin];
            k += 1;
        }
        Mirror(Mueller::new(elements, s_axis_turns))
    }

    /// Its reflectance for unpolarized light: the effect left out, by name.
    #[must_use]
    pub const fn ignoring_polarization(&self) -> Spectrum<Factor, N, G> {
        self.0.ignoring_polarization()
    }
}

/// Half the sum, half the difference and the geometric mean of the powers along an axis and across it.
const fn along_and_across(along: f32, across: f32) -> [f32; 3] {
    let along = if along < 0.0 { 0.0 } else { along };
    let across = if across < 0.0 { 0.0 } else { across };
    let product = along * across;
    // One root where the product is in range.
    let both = if 1e-30 < product && product < 1e30 {
        sqrt_by_digits(product)
    } else {
        sqrt_by_digits(along) * sqrt_by_digits(across)
    };
    [0.5 * along + 0.5 * across, 0.5 * along - 0.5 * across, both]
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
        // Total: both amplitudes of size 1, p against s turned by -e^(-2 i phi) with tan(phi) = cos g / sin^2.
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

impl<const N: usize, G> Polarizer<N, G> {
    /// The Mueller matrix.
    #[must_use]
    #[inline]
    pub const fn mueller(&self) -> &Mueller<N, G> {
        &self.0
    }

    /// A perfect one: all light along the axis, none across it. The axis in turns from the reference direction.
    #[must_use]
    pub const fn ideal(axis_turns: f32) -> Self {
        Polarizer(Mueller::new([[0.5, 0.5, 0.0, 0.0]; N], axis_turns))
    }

    /// A real one: its transmittances for light along its axis and across it, 0..=1; what is negative counts as 0.
    #[must_use]
    pub const fn new(
        along: &Spectrum<Factor, N, G>,
        across: &Spectrum<Factor, N, G>,
        axis_turns: f32,
    ) -> Self {
        let mut elements = [[0.0; 4]; N];
        let mut k = 0;
        while k < N {
            let [a, b, both] = along_and_across(along.0[k], across.0[k]);
            elements[k] = [a, b, both, 0.0];
            k += 1;
        }
        Polarizer(Mueller::new(elements, axis_turns))
    }
}

impl<const N: usize, G> Retarder<N, G> {
    /// The Mueller matrix.
    #[must_use]
    #[inline]
    pub const fn mueller(&self) -> &Mueller<N, G> {
        &self.0
    }

    /// The same retardance in every bin, in turns (a quarter for a quarter-wave plate); the fast axis in turns from
    /// the reference direction.
    #[must_use]
    pub const fn flat(retardance_turns: f32, axis_turns: f32) -> Self {
        let (c, s) = (cos_turns(retardance_turns), sin_turns(retardance_turns));
        Retarder(Mueller::new([[1.0, 0.0, c, s]; N], axis_turns))
    }
}

impl<const N: usize, G: Grid> Retarder<N, G> {
    /// A plate of one path difference, in nm: 137.5 for a quarter-wave plate at 550 nm.
    ///
    /// Within a bin its retardance falls with the wavelength; what is kept is the mean effect over the bin, so light
    /// behind a plate of many waves is as good as unpolarized. Plates with one axis between the same sheets are one
    /// plate of the sum of their path differences: as two, each would take its mean.
    ///
    /// # Accuracy
    /// Of the light that comes in, against the mean over each bin of light constant per nm: 5e-3 in 31 bins of the
    /// default grid, up to 1 mm of path difference, 1e-2 in 16 (`tests/matter/polarization.rs`).
    #[must_use]
    pub const fn of_path_difference(path_difference_nm: f32, axis_turns: f32) -> Self {
        let mut elements = [[0.0; 4]; N];
        let mut k = 0;
        while k < N {
            let center = Spectrum::<Factor, N, G>::center_nm(k);
            let (width, turns) = (Layout::<G, N>::STEP / center, path_difference_nm / center);
            // The mean of 1 / wavelength over the bin, and half of what it changes by from edge to edge.
            let (mean, inner) = (turns + turns * (width * width / 12.0), 1.0 - 0.25 * width * width);
            let half = if inner > 0.0 { 0.5 * turns * width / inner } else { f32::INFINITY };
            let size = mean_of_waves(half);
            elements[k] = [1.0, 0.0, size * cos_turns(mean), size * sin_turns(mean)];
            k += 1;
        }
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
