//! What a smooth boundary reflects and lets in: Fresnel's equations for one wavelength.

use crate::math::Complex;
use crate::math::{at_least, at_most, sqrt};

/// One number for each polarization.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Components {
    /// The field at right angles to the plane of incidence (senkrecht).
    pub s: f32,
    /// The field within the plane of incidence (parallel).
    pub p: f32,
}

impl Components {
    /// The same for both.
    #[must_use]
    pub const fn both(value: f32) -> Self {
        Components { s: value, p: value }
    }

    /// The mean: what holds for unpolarized light.
    #[must_use]
    pub const fn unpolarized(self) -> f32 {
        0.5 * (self.s + self.p)
    }
}

/// Squares of indices and their inverses stay in range up to here; no matter comes near.
const LARGEST_INDEX: f32 = 1e15;

/// A boundary to a transparent medium: glass, water, and air as seen from within them.
///
/// `V` is the relative refractive index eta = n2 / n1, where light comes from medium 1: an `f32`, or a
/// [`Spectrum`](crate::Spectrum) of [`RefractiveIndex`](crate::RefractiveIndex) for a glass that disperses.
///
/// ```
/// # use nanospectra::matter::Dielectric;
/// let glass = Dielectric::new(1.5);
/// assert!((glass.fresnel(1.0).s - 0.04).abs() < 1e-8); // 4 % at normal incidence
/// let brewster = glass.fresnel(0.554_700_2); // 56.31 degrees
/// assert!((brewster.s - 0.147_929).abs() < 1e-6 && brewster.p < 1e-12);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dielectric<V = f32> {
    /// The relative refractive index n2 / n1.
    pub eta: V,
}

/// A boundary to an absorbing medium, a metal above all, of complex relative index eta + i k.
///
/// `V` is `f32`, or a [`Spectrum`](crate::Spectrum) of [`RefractiveIndex`](crate::RefractiveIndex).
///
/// ```
/// # use nanospectra::matter::Conductor;
/// let copper_in_green = Conductor::new(1.15, 2.56);
/// assert!((copper_in_green.fresnel(1.0).s - 0.588_407).abs() < 1e-6);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conductor<V = f32> {
    /// The real part n2 / n1.
    pub eta: V,
    /// The extinction coefficient k2 / n1, at least 0.
    pub k: V,
}

impl<V> Dielectric<V> {
    /// `eta` is n2 / n1: above 1 going into glass, below 1 coming out of it.
    #[must_use]
    pub const fn new(eta: V) -> Self {
        Dielectric { eta }
    }
}

impl<V> Conductor<V> {
    /// The index is `eta` + i `k`, relative to the (transparent) medium the light comes from.
    #[must_use]
    pub const fn new(eta: V, k: V) -> Self {
        Conductor { eta, k }
    }
}

impl Dielectric {
    /// The shares of power reflected, 0..=1, at the cosine of the angle of incidence.
    ///
    /// A cosine outside 0..=1 counts as the nearer end, an index below 0 as 0. Beyond the critical angle all
    /// is reflected. Equal media (`eta` = 1) reflect nothing, at grazing incidence too.
    ///
    /// # Accuracy
    /// For s 14 units of 2^-24, relative, however little the media differ
    /// (`tests/matter/hard_cases_surfaces.rs`), and for p 4e-7 absolute. Below the critical angle the
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

    /// The shares of power that enter the second medium, by formulas that hold where 1 - R is all rounding.
    ///
    /// Radiance is per solid angle, which refraction changes: in the second medium it is eta^2 times this
    /// share of what arrived.
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

    /// The amplitudes of the reflected field over the incoming one; complex beyond the critical angle.
    #[must_use]
    pub fn amplitudes(&self, cos_i: f32) -> Amplitudes {
        let Setup { cosine, sine2, scale, contrast, root2, .. } = Setup::of(self.eta, cos_i);
        let size = sqrt(root2.abs());
        let root = if root2 < 0.0 { Complex::new(0.0, size) } else { Complex::new(size, 0.0) };
        reflect(cosine, sine2, scale, Complex { re: contrast, im: 0.0 }, root)
    }

    /// What s and p have in common, or what is reflected where there is nothing to work out.
    fn ratios(&self, cos_i: f32) -> Result<Ratios, Components> {
        // Before the test for total reflection, which at grazing incidence would also be true.
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

/// Of a dielectric: eta^2 - 1 and cos_i + g in units that cannot overflow, the power that enters, r_p / r_s.
struct Ratios {
    contrast: f32,
    sum: f32,
    entering: Components,
    crossed: f32,
}

/// Of a dielectric, with g = eta cos_t = sqrt(eta^2 - sin^2): indices times `scale`.
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
    /// The shares of power reflected, 0..=1, at the cosine of the angle of incidence.
    ///
    /// A cosine outside 0..=1 counts as the nearer end, a part of the index below 0 as 0.
    ///
    /// # Accuracy
    /// For s 14 units of 2^-24, relative, and for p 5e-7 absolute (`tests/matter/hard_cases_surfaces.rs`),
    /// but for media of n < 1 and k below 0.01: they have a critical angle, near which what f32 can say of
    /// the angle costs up to 3e-5. Within 0..=1 for every finite index.
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

    /// The shares of power that enter and are absorbed, by formulas that hold where 1 - R is all rounding
    /// (silver).
    ///
    /// # Accuracy
    /// 12 units of 2^-24, relative; by the cosine's rounding hundreds near a critical angle (n < 1, k below
    /// 0.01).
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

    /// The amplitudes of the reflected field over the incoming one.
    #[must_use]
    pub fn amplitudes(&self, cos_i: f32) -> Amplitudes {
        let Metal { cosine, sine2, scale, contrast, root } = Metal::of(self, cos_i);
        reflect(cosine, sine2, scale, contrast, root)
    }
}

/// Of a conductor, with g = sqrt((eta + i k)^2 - sin^2): indices times `scale`.
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
        // The part of the root that does not cancel first.
        let size = sqrt(square * square + 4.0 * (cross * cross));
        let large = sqrt(0.5 * (size + square.abs()));
        let small = if large == 0.0 { 0.0 } else { cross / large };
        let (re, im) = if square < 0.0 { (small, large) } else { (large, small) };
        Metal { cosine, sine2, scale, contrast, root: Complex { re, im } }
    }
}

/// eta^2 - k^2 - sin^2, the real part of g^2: from eta^2 - k^2 - 1 (`contrast`) or from the sine, where less
/// cancels.
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
        // No boundary: nothing, at grazing incidence too.
        let none = Complex { re: 0.0 * cosine, im: 0.0 };
        return Amplitudes { s: none, p: none };
    }
    let sum = root.plus(cosine * scale);
    if sum.power() < 1e-30 {
        // Grazing, where squares underflow.
        let all = Complex { re: -1.0, im: 0.0 };
        return Amplitudes { s: all, p: all };
    }
    let product = root.times(cosine);
    let s = contrast.over(sum).over(sum).times(-1.0);
    let both = product.plus(sine2 * scale);
    let crossed = if both.power() < 1e-30 {
        // Normal incidence on next to no index: p is as s.
        Complex { re: 1.0, im: 0.0 }
    } else {
        product.plus(-sine2 * scale).over(both)
    };
    Amplitudes { s, p: s.times(-1.0) * crossed }
}

/// The amplitudes of both components after reflection.
///
/// The time factor is exp(-i omega t). (s, p, direction of travel) is right-handed before and after: at
/// normal incidence p = -s, and so a mirror at normal incidence turns the hand.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Amplitudes {
    /// At right angles to the plane of incidence.
    pub s: Complex,
    /// Within the plane of incidence.
    pub p: Complex,
}

impl Amplitudes {
    /// The shares of power.
    #[must_use]
    pub fn power(self) -> Components {
        Components { s: self.s.power(), p: self.p.power() }
    }

    /// r_p times the conjugate of r_s: sqrt(R_s R_p) times the cosine (`re`) and sine (`im`) of the phase by
    /// which p is ahead of s: two of the four numbers of a mirror's Mueller matrix.
    ///
    /// ```
    /// # use nanospectra::matter::Dielectric;
    /// // A Fresnel rhomb of n = 1.51: 54.617 degrees retard by 45, and two such reflections by 90.
    /// let within = Dielectric::new(1.0 / 1.51).amplitudes(0.579_035).retardation();
    /// assert!((within.re.abs() - 0.707_107).abs() < 1e-4 && (within.im.abs() - 0.707_107).abs() < 1e-4);
    /// ```
    #[must_use]
    pub fn retardation(self) -> Complex {
        self.p * Complex { re: self.s.re, im: -self.s.im }
    }
}

/// What is reflected: near 1 the remainder of what enters is the better number.
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

/// A cosine of incidence within 0..=1; NaN stays.
pub(crate) fn cosine(cos_i: f32) -> f32 {
    at_most(at_least(cos_i, 0.0), 1.0)
}
