//! Describes the radiance at a surface by its limits from both sides: what arrives and what leaves.

use crate::geometry::vec3::{dot, scaled, to_unity};
use crate::radiometry::{Carried, Radiance};

/// The radiance at a point of a surface, which tells arriving from leaving light on both of its sides.
///
/// Radiance is a function of the direction in which light travels. It is not continuous at a surface, and so
/// has two limits there: one from above, the side to which the normal points, and one from below. Make the
/// struct of two functions that return these limits, then ask for the radiance that arrives from a direction
/// with [`incident`](Self::incident) and for the radiance that leaves in a direction with
/// [`exitant`](Self::exitant).
///
/// Both take directions that point away from the surface. The side of the surface on which the direction lies
/// decides which limit counts. Directions and normals may have any length other than 0.
///
/// # Example
/// ```
/// use nanospectra::radiometry::{Nit, SurfaceRadiance};
/// // A table between a bright ceiling and a dark floor. Above the table, light that travels down comes
/// // from the ceiling, and light that travels up from the table.
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
    /// The surface's normal, which points to the side called above.
    pub normal: [f32; 3],
    /// A function that returns the radiance just above the surface of light that travels in a direction.
    ///
    /// See the [example](Self#example).
    pub above: A,
    /// A function that returns the radiance just below the surface of light that travels in a direction.
    ///
    /// See the [example](Self#example).
    pub below: B,
}

impl<A: Clone> SurfaceRadiance<A, A> {
    /// Returns the radiance at an imagined surface in free space, where both limits are the same.
    ///
    /// What leaves in a direction is then what arrives from the opposite one: Lo(p, w) = Li(p, -w).
    ///
    /// # Example
    /// ```
    /// # use nanospectra::radiometry::{Nit, SurfaceRadiance};
    /// // All light travels towards positive x.
    /// let beam = |[x, _, _]: [f32; 3]| if x > 0.0 { Nit::from(50.0) } else { Nit::NONE };
    /// let here = SurfaceRadiance::free_space([0.0, 0.0, 1.0], beam);
    /// let w = [0.6, 0.0, 0.8];
    /// assert_eq!(here.exitant(w), Nit::from(50.0));
    /// assert_eq!(here.incident(w.map(|x| -x)), here.exitant(w));
    /// ```
    #[must_use]
    pub fn free_space(normal: [f32; 3], radiance: A) -> Self {
        SurfaceRadiance { normal, above: radiance.clone(), below: radiance }
    }
}

impl<A, B> SurfaceRadiance<A, B> {
    /// Returns the radiance Li(p, wi) that arrives from the direction `wi`.
    ///
    /// It arrives on the side of the surface where `wi` lies. If `wi` lies in the surface, the result is 0.
    /// See the [example](Self#example).
    #[must_use]
    pub fn incident<V: Carried>(&self, wi: [f32; 3]) -> Radiance<V>
    where
        A: Fn([f32; 3]) -> Radiance<V>,
        B: Fn([f32; 3]) -> Radiance<V>,
    {
        self.on_the_side_of(wi, scaled(wi, -1.0))
    }

    /// Returns the radiance Lo(p, wo) that leaves in the direction `wo`.
    ///
    /// It leaves from the side of the surface where `wo` lies. If `wo` lies in the surface, the result is 0.
    /// See the [example](Self#example).
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
