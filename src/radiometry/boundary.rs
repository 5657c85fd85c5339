//! Radiance at a surface: what arrives and what leaves, as limits from the one side and from the other.

use crate::geometry::vec3::{dot, scaled, to_unity};
use crate::radiometry::{Carried, Radiance};

/// The radiance at a point of a surface, a function of the direction in which the light travels. It is not
/// continuous there, and so has two limits: from above (the side to which the normal points) and from below.
///
/// Light that travels away from a side leaves it, light that travels towards it arrives; which limit counts
/// is thus decided by the side of the normal on which the direction lies. Directions, always away from the
/// surface, and normals are of any length.
///
/// ```
/// use nanospectra::radiometry::{Nit, SurfaceRadiance};
/// // A table under a bright ceiling, dark below. Above it, what travels down is the ceiling's, what travels up the
/// // table's.
/// let table = SurfaceRadiance {
///     normal: [0.0, 0.0, 1.0],
///     above: |[_, _, z]: [f32; 3]| Nit::from(if z < 0.0 { 300.0 } else { 90.0 }),
///     below: |_| Nit::from(2.0),
/// };
/// let up = [0.0, 0.6, 0.8];
/// assert_eq!((table.incident(up), table.exitant(up)), (Nit::from(300.0), Nit::from(90.0)));
/// assert_eq!(table.incident([0.0, 0.0, -1.0]), Nit::from(2.0));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SurfaceRadiance<A, B> {
    /// To the side called above.
    pub normal: [f32; 3],
    /// The limit from above: the radiance of light that travels in a direction.
    pub above: A,
    /// The limit from below.
    pub below: B,
}

impl<A: Clone> SurfaceRadiance<A, A> {
    /// An imagined surface in free space, where radiance is continuous and both limits are one. What leaves
    /// in a direction is then what arrives from the opposite one: Lo(p, w) = Li(p, -w).
    #[must_use]
    pub fn free_space(normal: [f32; 3], radiance: A) -> Self {
        SurfaceRadiance { normal, above: radiance.clone(), below: radiance }
    }
}

impl<A, B> SurfaceRadiance<A, B> {
    /// Li(p, w): the radiance that arrives from the direction `wi`, on the side of the surface where `wi`
    /// lies. Along the surface nothing arrives.
    #[must_use]
    pub fn incident<V: Carried>(&self, wi: [f32; 3]) -> Radiance<V>
    where
        A: Fn([f32; 3]) -> Radiance<V>,
        B: Fn([f32; 3]) -> Radiance<V>,
    {
        self.on_the_side_of(wi, scaled(wi, -1.0))
    }

    /// Lo(p, w): the radiance that leaves in the direction `wo`, from the side of the surface where `wo`
    /// lies. Along the surface nothing leaves.
    #[must_use]
    pub fn exitant<V: Carried>(&self, wo: [f32; 3]) -> Radiance<V>
    where
        A: Fn([f32; 3]) -> Radiance<V>,
        B: Fn([f32; 3]) -> Radiance<V>,
    {
        self.on_the_side_of(wo, wo)
    }

    fn on_the_side_of<V: Carried>(&self, w: [f32; 3], traveling: [f32; 3]) -> Radiance<V>
    where
        A: Fn([f32; 3]) -> Radiance<V>,
        B: Fn([f32; 3]) -> Radiance<V>,
    {
        let [w, normal] = [w, self.normal].map(|v| scaled(v, to_unity(v)));
        let cos = dot(w, normal);
        if cos > 0.0 {
            (self.above)(traveling)
        } else if cos < 0.0 {
            (self.below)(traveling)
        } else {
            Radiance::new(V::ZERO * cos)
        }
    }
}
