//! Directions at a point of a surface, in the surface's own frame.

use crate::math::{Math, cos_turns, sin_turns, sqrt};
use core::ops::Neg;

/// A direction at a surface, held as a unit vector whose z axis is the surface's normal.
///
/// The x and y axes lie in the plane of the surface. Make a direction from angles with
/// [`spherical`](Self::spherical), from any vector with [`from_vector`](Self::from_vector), or from world
/// coordinates with [`Frame::towards`](crate::geometry::Frame::towards).
///
/// All directions point away from the surface, including those of arriving light: by convention, `wi` points
/// to where light comes from, and `wo` to where it goes.
///
/// # Example
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::geometry::Direction;
///
/// let w = Direction::spherical(0.5, 2.0); // zenith angle theta and azimuth phi, in radians
/// assert!((w.cos_theta() - 0.877_583).abs() < 1e-6); // the cosine of theta, not of phi
/// assert!((w.y() / w.x() + 2.185_04).abs() < 1e-5); // the tangent of phi
/// assert!((w.theta_rad() - 0.5).abs() < 1e-6 && (w.phi_rad() - 2.0).abs() < 1e-6);
///
/// // A mirror sends light from 30 degrees to 30 degrees on the other side of the normal.
/// let wi = Direction::spherical(0.523_598_8, 0.0);
/// let wo = wi.mirrored();
/// assert!((wi.dot(wo) - 0.5).abs() < 1e-6); // they are 60 degrees apart
/// assert_eq!(wi.halfway(wo), Some(Direction::NORMAL));
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Direction {
    x: f32,
    y: f32,
    z: f32,
}

impl Direction {
    /// The direction that points along the surface's normal, to the zenith. See the [example](Self#example).
    pub const NORMAL: Direction = Direction { x: 0.0, y: 0.0, z: 1.0 };

    /// Returns the direction of a vector of any length other than 0.
    ///
    /// Returns `None` if the length is 0, or if a component is not finite.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::geometry::Direction;
    /// let w = Direction::from_vector([3.0, 0.0, 4.0]);
    /// assert!(w.is_some_and(|w| (w.x() - 0.6).abs() < 1e-7 && (w.cos_theta() - 0.8).abs() < 1e-7));
    /// assert_eq!(Direction::from_vector([0.0; 3]), None);
    /// ```
    #[must_use]
    pub fn from_vector(vector: [f32; 3]) -> Option<Self> {
        let size =
            vector.iter().fold(0.0, |size: f32, part| if part.abs() > size { part.abs() } else { size });
        if size == 0.0 || !vector.iter().all(|part| part.is_finite()) {
            return None;
        }
        // Divide, because the inverse of a subnormal size is infinite.
        let [x, y, z] = vector.map(|part| part / size);
        Some(Self::scaled([x, y, z], 1.0 / sqrt(x * x + y * y + z * z)))
    }

    /// Returns the direction that has this zenith angle and this azimuth, both in radians.
    ///
    /// `theta_rad` is measured from the normal: 0 is the zenith, pi / 2 the horizon and pi the nadir.
    /// `phi_rad` is measured around the normal, from x towards y. See the [example](Self#example).
    ///
    /// # Accuracy
    /// Components are within 6e-7 for azimuths of 0..=2 pi. Near the zenith, where x and y are small, their
    /// error is at most 6e-7 times the sine of the zenith angle.
    #[must_use]
    pub fn spherical(theta_rad: f32, phi_rad: f32) -> Self {
        const TURNS: f32 = 0.5 * core::f32::consts::FRAC_1_PI;
        let (theta, phi) = (theta_rad * TURNS, phi_rad * TURNS);
        Self::around(sin_turns(theta), cos_turns(theta), phi)
    }

    /// Returns the direction whose zenith angle has this cosine, with the azimuth in turns.
    ///
    /// The cosine is limited to -1..=1. One turn of azimuth is a full circle, so that 0.25 points along y.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::geometry::Direction;
    /// let [x, y, z] = Direction::from_cosine(0.6, 0.25).to_array();
    /// assert!(x.abs() < 1e-6 && (y - 0.8).abs() < 1e-6 && z == 0.6);
    /// ```
    #[must_use]
    pub fn from_cosine(cos_theta: f32, phi_turns: f32) -> Self {
        let cos_theta = if cos_theta.abs() > 1.0 { 1.0f32.copysign(cos_theta) } else { cos_theta };
        let sine = sqrt((1.0 - cos_theta) * (1.0 + cos_theta));
        Self::around(sine, cos_theta, phi_turns)
    }

    /// The direction of this zenith angle and azimuth. If the azimuth is NaN all components are, for a
    /// surface may read only one of them.
    #[inline]
    fn around(sine: f32, cosine: f32, phi_turns: f32) -> Self {
        let x = sine * cos_turns(phi_turns);
        Direction { x, y: sine * sin_turns(phi_turns), z: cosine - 0.0 * x.abs() }
    }

    pub(crate) const fn unit(x: f32, y: f32, z: f32) -> Self {
        Direction { x, y, z }
    }

    fn scaled([x, y, z]: [f32; 3], k: f32) -> Self {
        Direction { x: x * k, y: y * k, z: z * k }
    }

    /// Returns the component along x, which lies in the plane of the surface. See the
    /// [example](Self#example).
    #[must_use]
    pub const fn x(self) -> f32 {
        self.x
    }

    /// Returns the component along y, which lies in the plane of the surface. See the
    /// [example](Self#example).
    #[must_use]
    pub const fn y(self) -> f32 {
        self.y
    }

    /// Returns the cosine of the zenith angle, which is the component along the normal.
    ///
    /// It is negative below the surface. See the [example](Self#example).
    #[must_use]
    pub const fn cos_theta(self) -> f32 {
        self.z
    }

    /// Returns the sine of the zenith angle, 0..=1.
    ///
    /// It is computed from x and y, and therefore keeps its digits near the zenith and the nadir.
    #[must_use]
    pub fn sin_theta(self) -> f32 {
        sqrt(self.x * self.x + self.y * self.y)
    }

    /// Returns the components along x, y and the normal, in this order. See the
    /// [example](Self::from_cosine).
    #[must_use]
    pub const fn to_array(self) -> [f32; 3] {
        [self.x, self.y, self.z]
    }

    /// Returns the zenith angle in radians, which lies within 0..=pi. See the [example](Self#example).
    ///
    /// # Accuracy
    /// The relative error is at most 2.5e-7, also near the zenith.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn theta_rad(self) -> f32 {
        self.theta_rad_with::<crate::math::Portable>()
    }

    /// Does the same as [`theta_rad`](Self::theta_rad) with a math backend of your choice.
    #[must_use]
    pub fn theta_rad_with<M: Math>(self) -> f32 {
        M::atan2(self.sin_theta(), self.z)
    }

    /// Returns the azimuth in radians, which runs from x towards y within 0..=2 pi.
    ///
    /// At the zenith and at the nadir, where there is no azimuth, it returns 0. See the
    /// [example](Self#example).
    ///
    /// # Accuracy
    /// The relative error is at most 1.4e-7, to which the rounding of x and y adds.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn phi_rad(self) -> f32 {
        self.phi_rad_with::<crate::math::Portable>()
    }

    /// Does the same as [`phi_rad`](Self::phi_rad) with a math backend of your choice.
    #[must_use]
    pub fn phi_rad_with<M: Math>(self) -> f32 {
        // Adding 0 turns -0 into 0. Otherwise the azimuth of a pole could be pi.
        let angle = M::atan2(self.y + 0.0, self.x + 0.0);
        if angle < 0.0 { angle + core::f32::consts::TAU } else { angle }
    }

    /// Returns the cosine of the angle between two directions. See the [example](Self#example).
    #[must_use]
    pub const fn dot(self, other: Self) -> f32 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// Returns where a mirror in the plane of the surface sends light that comes from this direction. See the
    /// [example](Self#example).
    #[must_use]
    pub const fn mirrored(self) -> Self {
        Direction { x: -self.x, y: -self.y, z: self.z }
    }

    /// Returns where a small facet with the normal `wm` sends light that comes from this direction.
    ///
    /// # Example
    /// ```
    /// # #[cfg(feature = "libm")] {
    /// # use nanospectra::geometry::Direction;
    /// // Light from the zenith meets a facet tilted by 0.3 rad, and leaves at twice that angle.
    /// let wo = Direction::NORMAL.reflected(Direction::spherical(0.3, 1.0));
    /// assert!((wo.theta_rad() - 0.6).abs() < 1e-6);
    /// # }
    /// ```
    #[must_use]
    pub fn reflected(self, wm: Self) -> Self {
        let k = 2.0 * self.dot(wm);
        Direction { x: k * wm.x - self.x, y: k * wm.y - self.y, z: k * wm.z - self.z }
    }

    /// Returns the direction halfway between two: the normal of the facet that mirrors one into the other.
    ///
    /// Returns `None` for opposite directions. See the [example](Self#example).
    #[must_use]
    pub fn halfway(self, other: Self) -> Option<Self> {
        Self::from_vector([self.x + other.x, self.y + other.y, self.z + other.z])
    }

    /// Returns where light from this direction goes when it is refracted at the surface, by Snell's law.
    ///
    /// `eta` is the refractive index of the far side over that of this side. Returns `None` where all light
    /// is reflected (total internal reflection), and for an `eta` of 0 or less. Glass with dispersion
    /// refracts each wavelength into another direction, so call this once for each index instead of averaging
    /// directions. What refraction does to the radiance is computed by
    /// [`Dielectric::entering`](crate::matter::Dielectric::entering).
    ///
    /// # Accuracy
    /// Components are within 7e-7 while the refracted angle is below 45 degrees. At larger angles the
    /// rounding of this direction adds to that, most of all near grazing.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::geometry::Direction;
    /// let wi = Direction::spherical(0.523_598_8, 0.0); // 30 degrees
    /// let wt = wi.refracted(1.5);
    /// assert!(wt.is_some_and(|wt| (wt.x() + 1.0 / 3.0).abs() < 1e-6 && wt.cos_theta() < 0.0)); // 0.5 / 1.5
    /// assert_eq!(Direction::spherical(0.8, 0.0).refracted(1.0 / 1.5), None); // 45.8 degrees, within glass
    /// ```
    #[must_use]
    pub fn refracted(self, eta: f32) -> Option<Self> {
        let (x, y) = (-self.x / eta, -self.y / eta);
        // The square of the refracted cosine, from the cosine or from the sines of this side, whichever loses
        // fewer digits by subtraction.
        let square = if eta > 0.7 {
            let (difference, cosine) = ((eta - 1.0) / eta, self.z / eta);
            difference * ((eta + 1.0) / eta) + cosine * cosine
        } else {
            1.0 - (x * x + y * y)
        };
        if eta <= 0.0 || square <= 0.0 {
            return None;
        }
        let cosine = sqrt(square);
        Some(Direction { x, y, z: if self.z < 0.0 { cosine } else { -cosine } })
    }
}

impl Neg for Direction {
    type Output = Self;
    /// Returns the opposite direction.
    fn neg(self) -> Self {
        Direction { x: -self.x, y: -self.y, z: -self.z }
    }
}
