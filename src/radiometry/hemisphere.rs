//! Integrals over the hemisphere above a surface, by fixed nodes.

use crate::grid::Grid;
use crate::math::sqrt;
use crate::radiometry::Direction;
use crate::radiometry::gauss_legendre::nodes_and_weights;
use crate::spectrum::Spectrum;
use core::f32::consts::{PI, TAU};
use core::ops::{Add, Mul};

/// What can be integrated: a number, or a spectrum, for which every wavelength is integrated at once.
pub trait Integrand: Copy + Add<Output = Self> + Mul<f32, Output = Self> {
    /// Nothing.
    const ZERO: Self;

    /// Adds `value`; `lost` keeps what rounding took from the sum, for the next addition (Kahan's summation).
    fn accumulate(&mut self, lost: &mut Self, value: &Self);

    /// The largest number of it; NaN if there is one.
    fn peak(&self) -> f32;

    /// The largest difference to another, without its sign; NaN if there is one.
    fn distance(&self, other: &Self) -> f32;
}

impl Integrand for f32 {
    const ZERO: Self = 0.0;

    fn accumulate(&mut self, lost: &mut Self, value: &Self) {
        let value = value - *lost;
        let sum = *self + value;
        *lost = (sum - *self) - value;
        *self = sum;
    }

    fn peak(&self) -> f32 {
        *self
    }

    fn distance(&self, other: &Self) -> f32 {
        (self - other).abs()
    }
}

impl<Q, const N: usize, G: Grid> Integrand for Spectrum<Q, N, G> {
    const ZERO: Self = Spectrum::from_bins([0.0; N]);

    fn accumulate(&mut self, lost: &mut Self, value: &Self) {
        let sums = self.values_mut().iter_mut().zip(lost.values_mut());
        sums.zip(value.values()).for_each(|((sum, lost), value)| sum.accumulate(lost, value));
    }

    fn peak(&self) -> f32 {
        Spectrum::peak(self)
    }

    fn distance(&self, other: &Self) -> f32 {
        let differences = self.values().iter().zip(other.values()).map(|(a, b)| (a - b).abs());
        differences.fold(0.0, |most, d| if d <= most || most.is_nan() { most } else { d })
    }
}

/// A sum of thousands of equal terms: plain addition would be off by as many roundings, all in one direction.
pub(crate) struct Total<V> {
    pub(crate) sum: V,
    lost: V,
}

impl<V: Integrand> Total<V> {
    pub(crate) const fn new() -> Self {
        Total { sum: V::ZERO, lost: V::ZERO }
    }

    pub(crate) fn add(&mut self, value: V) {
        self.sum.accumulate(&mut self.lost, &value);
    }
}

/// A direction that stands for a piece of the hemisphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// Where the piece is.
    pub direction: Direction,
    /// Its solid angle, in sr: 2 pi for all pieces together.
    pub solid_angle_sr: f32,
    /// Its projected solid angle, in sr: times the cosine of the zenith angle; pi for all together.
    pub projected_sr: f32,
}

/// A rule that divides the hemisphere into pieces: [`Uniform`], [`Cosine`], [`GaussLegendre`].
///
/// `MU` rings, each of `PHI` pieces at equal azimuths. No rule has a node on the horizon or the zenith.
///
/// ```
/// # use nanospectra::radiometry::{Direction, GaussLegendre, Hemisphere};
/// // The irradiance under a sky that is three times as bright at the zenith as at the horizon (CIE overcast):
/// // 7 pi / 9 of the zenith's radiance.
/// let sky = |w: Direction| (1.0 + 2.0 * w.cos_theta()) / 3.0;
/// let e = GaussLegendre::<4, 1>.integrate_projected(sky);
/// assert!((e - 2.443_461).abs() < 1e-6);
/// ```
pub trait Hemisphere {
    /// The pieces.
    fn nodes(&self) -> impl Iterator<Item = Node>;

    /// The integral of `f` over solid angle.
    fn integrate<V: Integrand>(&self, mut f: impl FnMut(Direction) -> V) -> V {
        let mut total = Total::new();
        self.nodes().for_each(|node| total.add(f(node.direction) * node.solid_angle_sr));
        total.sum
    }

    /// The integral of `f` over projected solid angle, that is of `f` times the cosine: irradiance from radiance.
    fn integrate_projected<V: Integrand>(&self, mut f: impl FnMut(Direction) -> V) -> V {
        let mut total = Total::new();
        self.nodes().for_each(|node| total.add(f(node.direction) * node.projected_sr));
        total.sum
    }
}

/// Pieces of equal solid angle, by the midpoint rule: the plainest rule there is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Uniform<const MU: usize, const PHI: usize>;

/// Pieces of equal projected solid angle: each is an equal share of what a matt surface reflects.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cosine<const MU: usize, const PHI: usize>;

/// Gauss's nodes in the cosine of the zenith angle, equal azimuths: the rule for what is smooth.
///
/// # Accuracy
/// 8 rings integrate Fresnel's reflectance of glass to 2e-8 (`tests/matter/hard_cases_surfaces.rs`), and rough
/// microfacets (alpha from 0.5, up to 70 degrees from the normal) to 4e-4 with 8 x 32 nodes. Not for gloss: at
/// alpha = 0.05 even 32 x 32 nodes can miss three quarters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GaussLegendre<const MU: usize, const PHI: usize>;

impl<const MU: usize, const PHI: usize> Hemisphere for Uniform<MU, PHI> {
    fn nodes(&self) -> impl Iterator<Item = Node> {
        let rings = (0..MU).map(|ring| ((ring as f32 + 0.5) / MU as f32, 1.0 / MU as f32));
        rings.flat_map(|(cosine, share)| ring::<PHI>(cosine, TAU * share, TAU * share * cosine))
    }
}

impl<const MU: usize, const PHI: usize> Hemisphere for Cosine<MU, PHI> {
    fn nodes(&self) -> impl Iterator<Item = Node> {
        let rings = (0..MU).map(|ring| (sqrt((ring as f32 + 0.5) / MU as f32), 1.0 / MU as f32));
        rings.flat_map(|(cosine, share)| ring::<PHI>(cosine, PI * share / cosine, PI * share))
    }
}

impl<const MU: usize, const PHI: usize> GaussLegendre<MU, PHI> {
    /// Cosine and share of each ring.
    const RINGS: [(f32, f32); MU] = nodes_and_weights();
}

impl<const MU: usize, const PHI: usize> Hemisphere for GaussLegendre<MU, PHI> {
    fn nodes(&self) -> impl Iterator<Item = Node> {
        let rings = const { &Self::RINGS }.iter();
        rings.flat_map(|(cosine, share)| ring::<PHI>(*cosine, TAU * share, TAU * share * cosine))
    }
}

/// `PHI` nodes at equal azimuths, half a step off the x axis, that share out a ring's solid angles.
fn ring<const PHI: usize>(cosine: f32, solid_angle_sr: f32, projected_sr: f32) -> impl Iterator<Item = Node> {
    let share = 1.0 / PHI as f32;
    (0..PHI).map(move |k| Node {
        direction: Direction::from_cosine(cosine, (k as f32 + 0.5) * share),
        solid_angle_sr: solid_angle_sr * share,
        projected_sr: projected_sr * share,
    })
}
