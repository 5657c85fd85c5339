//! Fresnel's equations: what a smooth boundary reflects and lets in, for one wavelength.

use crate::math::Complex;
use crate::math::{at_least, at_most, sqrt};

/// A pair of numbers that holds one for each polarization, such as the two reflectances of a boundary.
///
/// [`unpolarized`](Self::unpolarized) makes one number of both. See the [example](Dielectric#example).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Components {
    /// The number that belongs to the field at right angles to the plane of incidence (German: senkrecht).
    pub s: f32,
    /// The number that belongs to the field in the plane of incidence (parallel).
    pub p: f32,
}

impl Components {
    /// Returns the mean of both, which holds for unpolarized light. See the [example](Dielectric#example).
    #[must_use]
    pub const fn unpolarized(self) -> f32 {
        0.5 * (self.s + self.p)
    }

    /// Makes a pair that has the same number for both polarizations.
    #[must_use]
    pub const fn both(value: f32) -> Self {
        Components { s: value, p: value }
    }
}

/// Up to here squares of indices and their inverses stay in the range of f32; no real matter comes near.
const LARGEST_INDEX: f32 = 1e15;

/// A smooth boundary to a transparent medium: glass, water, or air as seen from within them.
///
/// [`fresnel`](Self::fresnel) gives the reflectances for both polarizations, and
/// [`reflectance`](crate::matter::Reflector::reflectance) that for unpolarized light. `V` is the type of the
/// relative refractive index eta = n2 / n1, where light comes from medium 1: `f32`, or a
/// [`Spectrum`](crate::Spectrum) of [`RefractiveIndex`](crate::RefractiveIndex) for a glass that disperses.
///
/// # Example
///
/// ```
/// use nanospectra::matter::Dielectric;
/// let glass = Dielectric::new(1.5);
/// // ((1.5 - 1) / (1.5 + 1))^2 = 4 % are reflected at normal incidence, and 96 % enter.
/// assert!((glass.fresnel(1.0).unpolarized() - 0.04).abs() < 1e-8);
/// assert!((glass.entering(1.0).unpolarized() - 0.96).abs() < 1e-7);
/// // At Brewster's angle, 56.31 degrees, no p polarized light is reflected.
/// let brewster = glass.fresnel(0.554_700_2);
/// assert!((brewster.s - 0.147_929).abs() < 1e-6 && brewster.p < 1e-12);
/// // From within the glass, all light is reflected beyond 41.8 degrees.
/// assert_eq!(Dielectric::new(1.0 / 1.5).fresnel(0.7).unpolarized(), 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dielectric<V = f32> {
    /// The refractive index of the second medium relative to the one that light comes from, n2 / n1.
    pub eta: V,
}

/// A smooth boundary to an absorbing medium, above all a metal, whose relative refractive index is eta + i k.
///
/// [`fresnel`](Self::fresnel) gives the reflectances for both polarizations, and
/// [`reflectance`](crate::matter::Reflector::reflectance) that for unpolarized light. `V` is the type of both
/// parts of the index: `f32`, or a [`Spectrum`](crate::Spectrum) of
/// [`RefractiveIndex`](crate::RefractiveIndex).
///
/// # Example
///
/// ```
/// use nanospectra::matter::Conductor;
/// let copper_in_green = Conductor::new(1.15, 2.56);
/// // ((eta - 1)^2 + k^2) / ((eta + 1)^2 + k^2) is reflected at normal incidence, and the rest absorbed.
/// assert!((copper_in_green.fresnel(1.0).s - 0.588_407).abs() < 1e-6);
/// assert!((copper_in_green.entering(1.0).s - 0.411_593).abs() < 1e-6);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conductor<V = f32> {
    /// The real part of the index, relative to the medium that light comes from, n2 / n1.
    pub eta: V,
    /// The extinction coefficient k2 / n1, at least 0, which says how strongly the medium absorbs.
    pub k: V,
}

impl<V> Dielectric<V> {
    /// Makes a boundary from the relative refractive index n2 / n1, which is above 1 where light goes into
    /// glass and below 1 where it comes out. See the [example](#example).
    #[must_use]
    pub const fn new(eta: V) -> Self {
        Dielectric { eta }
    }
}

impl<V> Conductor<V> {
    /// Makes a boundary from the index `eta` + i `k`, relative to the transparent medium that light comes
    /// from. See the [example](#example).
    #[must_use]
    pub const fn new(eta: V, k: V) -> Self {
        Conductor { eta, k }
    }
}

impl Dielectric {
    /// Computes the shares of power that are reflected, 0..=1, for s and p polarized light.
    ///
    /// `cos_i` is the cosine of the angle of incidence; outside 0..=1 it counts as the nearer end, and an
    /// index below 0 counts as 0. Beyond the critical angle all light is reflected. Equal media (`eta` = 1)
    /// reflect nothing, even at grazing incidence. See the [example](#example).
    ///
    /// # Accuracy
    /// For s 14 units of 2^-24, relative, however little the media differ
    /// (`tests/matter/hard_cases_surfaces.rs`), and for p 5.5e-7 absolute. Just below the critical angle the
    /// rounding of the cosine costs up to 1.2e-5.
    ///
    /// # Reference
    /// M. Born, E. Wolf, "Principles of Optics", section 1.5.
    #[must_use]
    pub fn fresnel(&self, cos_i: f32) -> Components {
        match self.ratios(cos_i) {
            Ok(Ratios { contrast, sum, entering, crossed }) => {
                let s = contrast / (sum * sum);
                let s = s * s;
                Components { s: rest(s, entering.s), p: rest(s * crossed * crossed, entering.p) }
            }
            Err(all) => all,
        }
    }

    /// Computes the shares of power that enter the second medium, for s and p polarized light.
    ///
    /// The formulas stay accurate where nearly all light is reflected and 1 - R would be rounding error.
    /// Radiance is per solid angle, which refraction changes: in the second medium it is eta^2 times this
    /// share of the radiance that arrived. See the [example](#example).
    #[must_use]
    pub fn entering(&self, cos_i: f32) -> Components {
        match self.ratios(cos_i) {
            Ok(ratios) => ratios.entering,
            Err(reflected) => Components { s: 1.0 - reflected.s, p: 1.0 - reflected.p },
        }
    }

    /// The cosine of the angle of refraction, 0..=1; 0 beyond the critical angle.
    pub(crate) fn cos_refracted(&self, cos_i: f32) -> f32 {
        let Setup { eta, scale, root2, .. } = Setup::of(self.eta, cos_i);
        if root2 <= 0.0 { 0.0 } else { at_most(sqrt(root2) / (eta * scale), 1.0) }
    }

    /// Computes the amplitudes of the reflected field relative to the incoming one, which are complex beyond
    /// the critical angle. See the [example](Amplitudes::retardation).
    #[must_use]
    pub fn amplitudes(&self, cos_i: f32) -> Amplitudes {
        let Setup { cosine, sine2, scale, contrast, root2, .. } = Setup::of(self.eta, cos_i);
        let size = sqrt(root2.abs());
        let root = if root2 < 0.0 { Complex::new(0.0, size) } else { Complex::new(size, 0.0) };
        reflect(cosine, sine2, scale, Complex { re: contrast, im: 0.0 }, root)
    }

    /// The intermediate values that s and p have in common, or what is reflected where nothing is to be
    /// computed.
    fn ratios(&self, cos_i: f32) -> Result<Ratios, Components> {
        // This comes before the test for total reflection, which at grazing incidence would also be true.
        if self.eta == 1.0 {
            return Err(Components::both(0.0 * cos_i));
        }
        let Setup { eta, cosine, sine2, scale, contrast, root2 } = Setup::of(self.eta, cos_i);
        if root2 <= 0.0 {
            return Err(Components::both(1.0));
        }
        let root = sqrt(root2);
        let sum = cosine * scale + root;
        let (product, square) = (cosine * root, sine2 * scale);
        let s = 4.0 * (cosine * scale) * root / (sum * sum);
        let ratio = eta * scale / (product + square);
        let crossed = (product - square) / (product + square);
        let entering = Components { s: at_most(s, 1.0), p: at_most(s * (ratio * ratio), 1.0) };
        Ok(Ratios { contrast, sum, entering, crossed })
    }
}

/// The intermediate values of a dielectric: eta^2 - 1 and cos_i + g in units that cannot overflow, the power
/// that enters, and r_p / r_s.
struct Ratios {
    contrast: f32,
    sum: f32,
    entering: Components,
    crossed: f32,
}

/// The quantities of a dielectric, with g = eta cos_t = sqrt(eta^2 - sin^2) and indices times `scale`.
struct Setup {
    eta: f32,
    cosine: f32,
    sine2: f32,
    scale: f32,
    contrast: f32,
    root2: f32,
}

impl Setup {
    fn of(eta: f32, cos_i: f32) -> Self {
        let cosine = cosine(cos_i);
        let eta = within_reach(eta);
        let scale = scale(eta);
        let sine2 = (1.0 - cosine) * (1.0 + cosine);
        let contrast = ((eta - 1.0) * scale) * ((eta + 1.0) * scale);
        let root2 = root_squared([eta, 0.0], contrast, cosine, scale);
        Setup { eta, cosine, sine2, scale, contrast, root2 }
    }
}

impl Conductor {
    /// Computes the shares of power that are reflected, 0..=1, for s and p polarized light.
    ///
    /// `cos_i` is the cosine of the angle of incidence; outside 0..=1 it counts as the nearer end, and a part
    /// of the index below 0 counts as 0. See the [example](#example).
    ///
    /// # Accuracy
    /// For s 14 units of 2^-24, relative, and for p 5e-7 absolute (`tests/matter/hard_cases_surfaces.rs`).
    /// Media of n < 1 and k below 0.01 are an exception: they have a critical angle, near which the rounding
    /// of the cosine costs up to 3e-5. Within 0..=1 for every finite index.
    ///
    /// # Reference
    /// M. Born, E. Wolf, "Principles of Optics", section 14.2.
    #[must_use]
    pub fn fresnel(&self, cos_i: f32) -> Components {
        let Metal { cosine, sine2, scale, contrast, root } = Metal::of(self, cos_i);
        if contrast.power() == 0.0 {
            return Components::both(0.0 * cos_i);
        }
        let entering = self.entering(cos_i);
        let (sum, product) = (root.plus(cosine * scale).power(), root.times(cosine));
        let s = contrast.power() / (sum * sum);
        let crossed = product.plus(-sine2 * scale).power() / product.plus(sine2 * scale).power();
        Components { s: rest(s, entering.s), p: rest(s * crossed, entering.p) }
    }

    /// Computes the shares of power that enter and are absorbed, for s and p polarized light.
    ///
    /// The formulas stay accurate where nearly all light is reflected, as by silver, and 1 - R would be
    /// rounding error. See the [example](#example).
    ///
    /// # Accuracy
    /// 12 units of 2^-24, relative. Near a critical angle (n < 1, k below 0.01) the rounding of the cosine
    /// makes that hundreds.
    #[must_use]
    pub fn entering(&self, cos_i: f32) -> Components {
        let Metal { cosine, sine2, scale, contrast, root } = Metal::of(self, cos_i);
        if contrast.power() == 0.0 {
            return Components::both(1.0 + 0.0 * cos_i);
        }
        let sum = root.plus(cosine * scale).power();
        let crossed = root.times(cosine).plus(sine2 * scale).power();
        let absorbed = 4.0 * (cosine * scale) * root.re;
        let s = if absorbed == 0.0 { 0.0 } else { absorbed / sum };
        let p = if crossed < 1e-30 { s } else { s * ((root.power() + sine2 * scale * scale) / crossed) };
        Components { s: at_most(s, 1.0), p: at_most(p, 1.0) }
    }

    /// Computes the amplitudes of the reflected field relative to the incoming one.
    #[must_use]
    pub fn amplitudes(&self, cos_i: f32) -> Amplitudes {
        let Metal { cosine, sine2, scale, contrast, root } = Metal::of(self, cos_i);
        reflect(cosine, sine2, scale, contrast, root)
    }
}

/// The quantities of a conductor, with g = sqrt((eta + i k)^2 - sin^2) and indices times `scale`.
struct Metal {
    cosine: f32,
    sine2: f32,
    scale: f32,
    contrast: Complex,
    root: Complex,
}

impl Metal {
    fn of(metal: &Conductor, cos_i: f32) -> Self {
        let cosine = cosine(cos_i);
        let sine2 = (1.0 - cosine) * (1.0 + cosine);
        let (n, k) = (within_reach(metal.eta), within_reach(metal.k));
        let scale = scale(if k > n { k } else { n });
        let (n1, k1) = (n * scale, k * scale);
        let cross = n1 * k1;
        let contrast = Complex { re: ((n - 1.0) * scale) * ((n + 1.0) * scale) - k1 * k1, im: 2.0 * cross };
        let square = root_squared([n, k], contrast.re, cosine, scale);
        // First the part of the root that does not cancel.
        let size = sqrt(square * square + 4.0 * (cross * cross));
        let large = sqrt(0.5 * (size + square.abs()));
        let small = if large == 0.0 { 0.0 } else { cross / large };
        let (re, im) = if square < 0.0 { (small, large) } else { (large, small) };
        Metal { cosine, sine2, scale, contrast, root: Complex { re, im } }
    }
}

/// The real part of g^2, eta^2 - k^2 - sin^2, computed from eta^2 - k^2 - 1 (`contrast`) or from the sine,
/// whichever cancels less.
fn root_squared([n, k]: [f32; 2], contrast: f32, cosine: f32, scale: f32) -> f32 {
    if n > 0.7 {
        return contrast + (cosine * scale) * (cosine * scale);
    }
    let (n1, k1) = (n * scale, k * scale);
    (n1 - k1) * (n1 + k1) - (1.0 - cosine) * (1.0 + cosine) * scale * scale
}

/// r_s = -(eta^2 - 1) / (cos_i + g)^2 and r_p = -r_s (cos_i g - sin^2) / (cos_i g + sin^2).
fn reflect(cosine: f32, sine2: f32, scale: f32, contrast: Complex, root: Complex) -> Amplitudes {
    if contrast.power() == 0.0 {
        // Without a boundary nothing is reflected, not even at grazing incidence.
        let none = Complex { re: 0.0 * cosine, im: 0.0 };
        return Amplitudes { s: none, p: none };
    }
    let sum = root.plus(cosine * scale);
    if sum.power() < 1e-30 {
        // At grazing incidence squares underflow.
        let all = Complex { re: -1.0, im: 0.0 };
        return Amplitudes { s: all, p: all };
    }
    let product = root.times(cosine);
    let s = contrast.over(sum).over(sum).times(-1.0);
    let both = product.plus(sine2 * scale);
    let crossed = if both.power() < 1e-30 {
        // At normal incidence on an index close to 0, p is as s.
        Complex { re: 1.0, im: 0.0 }
    } else {
        product.plus(-sine2 * scale).over(both)
    };
    Amplitudes { s, p: s.times(-1.0) * crossed }
}

/// The complex amplitudes that both components of the field have after reflection, for an incoming one of 1.
///
/// They are returned by [`Dielectric::amplitudes`] and [`Conductor::amplitudes`]; see the
/// [example](Self::retardation). The time factor is exp(-i omega t). The axes s, p and the direction of
/// travel are right-handed before and after the reflection. At normal incidence p is therefore -s, and the
/// mirror reverses the handedness of circularly polarized light.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Amplitudes {
    /// The amplitude of the field that vibrates at right angles to the plane of incidence.
    pub s: Complex,
    /// The amplitude of the field that vibrates in the plane of incidence.
    pub p: Complex,
}

impl Amplitudes {
    /// Returns the shares of power that are reflected, the squares of the absolute amplitudes.
    #[must_use]
    pub fn power(self) -> Components {
        Components { s: self.s.power(), p: self.p.power() }
    }

    /// Returns r_p times the conjugate of r_s, which tells by which phase p is ahead of s.
    ///
    /// It is sqrt(R_s R_p) times the cosine (`re`) and the sine (`im`) of this phase. These are two of the
    /// four numbers of a mirror's [Mueller matrix](crate::matter::Mueller).
    ///
    /// # Example
    ///
    /// ```
    /// # use nanospectra::matter::Dielectric;
    /// // In a Fresnel rhomb of n = 1.51 a reflection at 54.617 degrees retards by 45 degrees.
    /// let within = Dielectric::new(1.0 / 1.51).amplitudes(0.579_035).retardation();
    /// assert!((within.re.abs() - 0.707_107).abs() < 1e-4 && (within.im.abs() - 0.707_107).abs() < 1e-4);
    /// ```
    #[must_use]
    pub fn retardation(self) -> Complex {
        self.p * Complex { re: self.s.re, im: -self.s.im }
    }
}

/// The share that is reflected; near 1 it is more accurate as the remainder of the share that enters.
fn rest(reflected: f32, entering: f32) -> f32 {
    if entering < 0.5 { 1.0 - entering } else { reflected }
}

fn within_reach(part: f32) -> f32 {
    at_most(at_least(part, 0.0), LARGEST_INDEX)
}

/// 1, or the inverse of an index whose fourth power might overflow.
fn scale(index: f32) -> f32 {
    if index > 1e6 { 1.0 / index } else { 1.0 }
}

/// The cosine of incidence clamped to 0..=1; NaN stays NaN.
pub(crate) fn cosine(cos_i: f32) -> f32 {
    at_most(at_least(cos_i, 0.0), 1.0)
}
