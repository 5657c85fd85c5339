//! Directions at a point of a surface, in the surface's own frame.

use crate::math::{Math, cos_turns, sin_turns, sqrt};
use core::ops::Neg;

/// A unit vector in the frame of a surface: z along its normal, x and y in its plane.
///
/// Directions point away from the surface, those of arriving light too: `wi` is where light comes from, `wo`
/// where it goes.
///
/// ```
/// # use nanospectra::geometry::Direction;
/// let w = Direction::spherical(0.5, 2.0); // zenith angle theta, azimuth phi
/// assert!((w.cos_theta() - 0.877_583).abs() < 1e-6); // the cosine of theta, not of phi
/// assert!((w.y() / w.x() + 2.185_04).abs() < 1e-5); // the tangent of phi
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Direction {
    x: f32,
    y: f32,
    z: f32,
}

impl Direction {
    /// Along the normal: the zenith.
    pub const NORMAL: Direction = Direction { x: 0.0, y: 0.0, z: 1.0 };

    /// The direction of a vector of any length but 0; `None` for that, and for what is not finite.
    #[must_use]
    pub fn from_vector(vector: [f32; 3]) -> Option<Self> {
        let size =
            vector.iter().fold(0.0, |size: f32, part| if part.abs() > size { part.abs() } else { size });
        if size == 0.0 || !vector.iter().all(|part| part.is_finite()) {
            return None;
        }
        // By division: the inverse of a subnormal size is infinite.
        let [x, y, z] = vector.map(|part| part / size);
        Some(Self::scaled([x, y, z], 1.0 / sqrt(x * x + y * y + z * z)))
    }

    /// From spherical coordinates: `theta_rad` from the normal (0 the zenith, pi/2 the horizon, pi the nadir)
    /// and `phi_rad` around it from x towards y.
    ///
    /// # Accuracy
    /// 4e-7 absolute for azimuths within 0..=2 pi; x and y to 4e-7 of the sine near the zenith.
    #[must_use]
    pub fn spherical(theta_rad: f32, phi_rad: f32) -> Self {
        const TURNS: f32 = 0.5 * core::f32::consts::FRAC_1_PI;
        let (theta, phi) = (theta_rad * TURNS, phi_rad * TURNS);
        let sine = sin_turns(theta);
        Direction { x: sine * cos_turns(phi), y: sine * sin_turns(phi), z: cos_turns(theta) }
    }

    /// From the cosine of the zenith angle, -1..=1 (outside: the nearer end), and the azimuth in turns.
    #[must_use]
    pub fn from_cosine(cos_theta: f32, phi_turns: f32) -> Self {
        let cos_theta = if cos_theta.abs() > 1.0 { 1.0f32.copysign(cos_theta) } else { cos_theta };
        let sine = sqrt((1.0 - cos_theta) * (1.0 + cos_theta));
        Direction { x: sine * cos_turns(phi_turns), y: sine * sin_turns(phi_turns), z: cos_theta }
    }

    pub(crate) const fn unit(x: f32, y: f32, z: f32) -> Self {
        Direction { x, y, z }
    }

    fn scaled([x, y, z]: [f32; 3], k: f32) -> Self {
        Direction { x: x * k, y: y * k, z: z * k }
    }

    /// The part along x, in the plane of the surface.
    #[must_use]
    pub const fn x(self) -> f32 {
        self.x
    }

    /// The part along y, in the plane of the surface.
    #[must_use]
    pub const fn y(self) -> f32 {
        self.y
    }

    /// The part along the normal, which is the cosine of the zenith angle; negative below the surface.
    #[must_use]
    pub const fn cos_theta(self) -> f32 {
        self.z
    }

    /// The sine of the zenith angle, 0..=1; from x and y, and so exact near the poles too.
    #[must_use]
    pub fn sin_theta(self) -> f32 {
        sqrt(self.x * self.x + self.y * self.y)
    }

    /// The parts along x, y and the normal.
    #[must_use]
    pub const fn to_array(self) -> [f32; 3] {
        [self.x, self.y, self.z]
    }

    /// The zenith angle, 0..=pi.
    ///
    /// # Accuracy
    /// 1.5e-7 relative, near the zenith as elsewhere.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn theta_rad(self) -> f32 {
        self.theta_rad_with::<crate::math::Portable>()
    }

    /// [`theta_rad`](Self::theta_rad) on another math backend.
    #[must_use]
    pub fn theta_rad_with<M: Math>(self) -> f32 {
        M::atan2(self.sin_theta(), self.z)
    }

    /// The azimuth from x towards y, 0..=2 pi; 0 at the poles.
    ///
    /// # Accuracy
    /// 7e-8 relative, but for what the rounding of x and y costs.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn phi_rad(self) -> f32 {
        self.phi_rad_with::<crate::math::Portable>()
    }

    /// [`phi_rad`](Self::phi_rad) on another math backend.
    #[must_use]
    pub fn phi_rad_with<M: Math>(self) -> f32 {
        // Zeros without sign, or the pole would have the azimuth pi.
        let angle = M::atan2(self.y + 0.0, self.x + 0.0);
        if angle < 0.0 { angle + core::f32::consts::TAU } else { angle }
    }

    /// The cosine of the angle between two directions.
    #[must_use]
    pub const fn dot(self, other: Self) -> f32 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// Where a mirror in the plane of the surface sends light that comes from here.
    #[must_use]
    pub const fn mirrored(self) -> Self {
        Direction { x: -self.x, y: -self.y, z: self.z }
    }

    /// Where a facet whose normal is `wm` sends light that comes from here.
    #[must_use]
    pub fn reflected(self, wm: Self) -> Self {
        let k = 2.0 * self.dot(wm);
        Direction { x: k * wm.x - self.x, y: k * wm.y - self.y, z: k * wm.z - self.z }
    }

    /// The normal of the facet that mirrors these two into each other; `None` for opposite directions.
    #[must_use]
    pub fn halfway(self, other: Self) -> Option<Self> {
        Self::from_vector([self.x + other.x, self.y + other.y, self.z + other.z])
    }

    /// Where light goes that comes from here and is refracted at the surface: Snell's law. For its radiance
    /// see [`Dielectric::entering`](crate::matter::Dielectric::entering).
    ///
    /// `eta` is the index of the far side over that of this side. `None` where all light is reflected, and
    /// for no index or a negative one. A glass that disperses has one direction for each wavelength: they do
    /// not average.
    ///
    /// # Accuracy
    /// 4e-7 absolute while the refracted angle is below 45 degrees; towards grazing the direction's rounding
    /// adds.
    ///
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
        // cos_t^2 from the cosine or the sines of this side, where less cancels.
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
    /// The opposite direction.
    fn neg(self) -> Self {
        Direction { x: -self.x, y: -self.y, z: -self.z }
    }
}
