//! Converts between world coordinates and the directions in a surface's frame that a BRDF takes.

use crate::geometry::Direction;
use crate::geometry::vec3::{cross, difference, dot, scaled, to_unity, unit};

/// The right-handed frame of a surface in the world, which converts world vectors to [`Direction`]s and back.
///
/// Its z axis is the normal, and its x and y axes lie in the surface. Positions and vectors of the world are
/// `[f32; 3]`. Start with [`from_normal`](Self::from_normal), then ask for the directions of lamp and camera
/// with [`towards`](Self::towards).
///
/// # Accuracy
/// Axes have length 1 and right angles to within 2e-7, and each component of a direction that is converted
/// there and back is within 4e-7 (`tests/radiometry/worst_directions.rs`).
///
/// # Example
/// ```
/// use nanospectra::matter::{Brdf, Conductor, Microfacet, TrowbridgeReitz};
/// use nanospectra::geometry::{Direction, Frame};
/// use nanospectra::radiometry::{Intensity, PointSource, Radiance, Radiant};
///
/// // A lamp of 2 W/sr, a tilted plate of rough copper (in green light), and a camera.
/// let lamp = PointSource { position_m: [0.0, 1.0, 2.0], intensity: Intensity::new(Radiant(2.0)) };
/// let (camera_m, point_m, normal) = ([1.0, 0.0, 2.0], [0.0; 3], [0.0, 0.5, 2.0]);
/// let copper =
///     Microfacet { facets: TrowbridgeReitz::new(0.3), boundary: Conductor { eta: 1.15, k: 2.56 } };
///
/// let Some(frame) = Frame::from_normal(normal) else { return };
/// let ways = (frame.towards(point_m, camera_m), frame.towards(point_m, lamp.position_m));
/// let (Some(wo), Some(wi)) = ways else { return };
/// let arriving = lamp.irradiance(point_m, normal); // in W/m2, with the cosine included
/// let seen = Radiance::new(arriving.value() * copper.f(wo, wi));
/// assert_eq!(format!("{arriving:.4}"), "0.3905 W/m2"); // 2 / 5 times the cosine 4.5 / sqrt(5 * 4.25)
/// assert_eq!(format!("{seen:.4}"), "0.0975 W/(m2 sr)");
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Frame {
    /// The x, y and z axes of the surface in world coordinates.
    axes: [[f32; 3]; 3],
}

/// The angle in radians between tangent and normal below which the tangent cannot orient the frame.
const LEAST_ANGLE: f32 = 1e-5;

impl Frame {
    /// Returns a frame around a normal of any length other than 0.
    ///
    /// Returns `None` if the length is 0, or if a component is not finite. The rotation of x and y about the
    /// normal is arbitrary, and it jumps where the normal's z changes its sign. This matters only for
    /// anisotropic surfaces, such as brushed or woven ones: use [`with_tangent`](Self::with_tangent) for
    /// them.
    ///
    /// # Reference
    /// T. Duff et al., "Building an orthonormal basis, revisited", JCGT 6 (2017).
    ///
    /// # Example
    /// ```
    /// # use nanospectra::geometry::{Direction, Frame};
    /// let floor = Frame::from_normal([0.0, 0.0, 9.0]);
    /// assert_eq!(floor.and_then(|floor| floor.to_local([0.0, 0.0, 0.2])), Some(Direction::NORMAL));
    /// assert_eq!(Frame::from_normal([0.0; 3]), None);
    /// ```
    #[must_use]
    pub fn from_normal(normal: [f32; 3]) -> Option<Self> {
        let normal @ [x, y, z] = axis(normal)?;
        // Compare instead of reading the sign bit, so that 0 and -0 give the same frame.
        let sign = if z < 0.0 { -1.0 } else { 1.0 };
        let a = -x / (sign + z);
        Self::around(normal, [1.0 + sign * (x * a), sign * (y * a), -sign * x])
    }

    /// Returns a frame around a normal whose x axis follows a tangent, such as the direction of brushing.
    ///
    /// The part of the tangent along the normal is ignored. Returns `None` if either vector has no length or
    /// is not finite, or if the tangent is within 1e-5 rad of the normal.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::geometry::Frame;
    /// let Some(wall) = Frame::with_tangent([0.0, -1.0, 0.0], [1.0, 0.0, 0.0]) else { return };
    /// assert_eq!(wall.axes(), [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]); // y is up
    /// ```
    #[must_use]
    pub fn with_tangent(normal: [f32; 3], tangent: [f32; 3]) -> Option<Self> {
        let normal = axis(normal)?;
        let leaning = within(normal, axis(tangent)?);
        if dot(leaning, leaning) < LEAST_ANGLE * LEAST_ANGLE {
            return None;
        }
        // Normalizing a short remainder also enlarges what rounding left along the normal. `around` removes
        // that once more.
        Self::around(normal, axis(leaning)?)
    }

    /// Returns the frame of a normal of length 1 and of a tangent nearly at right angles to it.
    ///
    /// The tangent is made orthogonal once more: without this, a normal whose length is 1e-7 off would leave
    /// an angle that is 3e-7 off.
    fn around(normal: [f32; 3], tangent: [f32; 3]) -> Option<Self> {
        let tangent = axis(within(normal, tangent))?;
        Some(Frame { axes: [tangent, axis(cross(normal, tangent))?, normal] })
    }

    /// Returns the x, y and z axes of the frame as unit vectors of the world, where z is the normal. See the
    /// [example](Self::with_tangent).
    #[must_use]
    pub const fn axes(self) -> [[f32; 3]; 3] {
        self.axes
    }

    /// Returns the direction, in this frame, of a world vector of any length other than 0.
    ///
    /// Returns `None` if the length is 0, or if a component is not finite. See the
    /// [example](Self::from_normal).
    #[must_use]
    pub fn to_local(self, vector: [f32; 3]) -> Option<Direction> {
        let vector = scaled(vector, to_unity(vector));
        Direction::from_vector(self.axes.map(|axis| dot(axis, vector)))
    }

    /// Returns the direction in which a target is seen from a point, both given as world positions in m.
    ///
    /// Returns `None` if both are at the same place. See the [example](Self#example).
    #[must_use]
    pub fn towards(self, point_m: [f32; 3], target_m: [f32; 3]) -> Option<Direction> {
        let k = to_unity(point_m.into_iter().chain(target_m));
        self.to_local(difference(scaled(target_m, k), scaled(point_m, k)))
    }

    /// Returns a direction of this frame as a unit vector of the world.
    ///
    /// # Example
    /// ```
    /// # use nanospectra::geometry::{Direction, Frame};
    /// let wall = Frame::from_normal([0.0, -2.0, 0.0]);
    /// let outwards = wall.map(|wall| wall.to_world(Direction::NORMAL));
    /// assert_eq!(outwards, Some([0.0, -1.0, 0.0]));
    /// ```
    #[must_use]
    pub fn to_world(self, direction: Direction) -> [f32; 3] {
        let [[tx, ty, tz], [bx, by, bz], [nx, ny, nz]] = self.axes;
        let w = direction.to_array();
        [dot([tx, bx, nx], w), dot([ty, by, ny], w), dot([tz, bz, nz], w)]
    }
}

/// Returns the part of a vector that is at right angles to a normal.
fn within(normal: [f32; 3], vector: [f32; 3]) -> [f32; 3] {
    difference(vector, scaled(normal, dot(vector, normal)))
}

/// Returns the vector of length 1 in this direction, or `None` if it has no length or is not finite.
fn axis(vector: [f32; 3]) -> Option<[f32; 3]> {
    let axis = unit(vector);
    (dot(axis, axis) > 0.5).then_some(axis)
}
