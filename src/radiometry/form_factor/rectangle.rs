//! Computes form factors between opposite rectangles, and between rectangles that meet at an edge.

use crate::geometry::vec3::to_unity;
use crate::math::Math;
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::sqrt;
use crate::radiometry::carried::ratio;
use crate::radiometry::form_factor::quadrature::unit_interval;
use core::f32::consts::FRAC_1_PI;

/// Returns the form factor from one rectangle to an equal one directly opposite.
///
/// # Accuracy
/// The relative error is at most 6e-7 (searched for sides of 0.02 to 1000 times the distance).
///
/// # Reference
/// Howell's catalog, C-11. Where a side is shorter than 1.4 distances, the integral along that side is
/// used instead of the closed form.
///
/// # Example
/// ```
/// use nanospectra::radiometry::form_factor::parallel_rectangles;
/// // Between opposite faces of a cube the catalog gives 0.199825.
/// assert!((parallel_rectangles(1.0, 1.0, 1.0) - 0.199_825).abs() < 1e-6);
/// ```
#[cfg(feature = "libm")]
#[must_use]
pub fn parallel_rectangles(width_m: f32, height_m: f32, distance_m: f32) -> f32 {
    parallel_rectangles_with::<Portable>(width_m, height_m, distance_m)
}

/// The length of the shorter side, in distances, up to which the integral is exact to 1e-9. The terms of the
/// closed form cancel there.
const SHORT: f32 = 1.4;

/// Does the same as [`parallel_rectangles`] with a math backend of your choice.
#[must_use]
pub fn parallel_rectangles_with<M: Math>(width_m: f32, height_m: f32, distance_m: f32) -> f32 {
    // Divide the sides by the distance. Beyond 1e9 distances a side counts as infinite.
    let [width, height] = [width_m, height_m].map(|side| {
        let side = ratio(side, distance_m).abs();
        if side > 1e9 { 1e9 } else { side }
    });
    let (x, y) = if width < height { (width, height) } else { (height, width) };
    if x <= SHORT {
        // The factor is 2 / (pi x) times the integral of (x - u) atan(y / p) / p^3 over u = 0..x, with
        // p^2 = 1 + u^2.
        let integral = unit_interval(|t| {
            let p2 = 1.0 + (x * t) * (x * t);
            let p = sqrt(p2);
            (1.0 - t) * M::atan2(y, p) / (p2 * p)
        });
        return 2.0 * FRAC_1_PI * x * integral;
    }
    // The terms of one side and the slant over the other. All is divided by that other side, so that nothing
    // overflows.
    let slanted = |x: f32, y: f32| {
        let slant = sqrt(1.0 + y * y);
        (slant * M::atan2(x, slant) - M::atan2(x, 1.0)) / y
    };
    let log = ln_1p::<M>((x / sqrt(1.0 + x * x + y * y)) * (x * (y / sqrt(1.0 + x * x + y * y)) * y));
    2.0 * FRAC_1_PI * (0.5 * log / x / y + slanted(x, y) + slanted(y, x))
}

/// Returns the form factor from the first to the second of two rectangles that meet at a right angle.
///
/// `edge_m` is the length of their common edge. `width_1_m` and `width_2_m` are their sides perpendicular to
/// that edge.
///
/// # Accuracy
/// The relative error is at most 6e-7 (searched for sides of 0.001 to 1000 times the edge).
///
/// # Reference
/// Howell's catalog, C-14. Differences of arc tangents and of logarithms are taken before rounding.
///
/// # Example
/// ```
/// use nanospectra::radiometry::form_factor::perpendicular_rectangles;
/// // Between adjacent faces of a cube it is (1 - 0.199825) / 4, since four faces share what does not reach
/// // the opposite one.
/// assert!((perpendicular_rectangles(1.0, 1.0, 1.0) - 0.200_044).abs() < 1e-6);
/// ```
#[cfg(feature = "libm")]
#[must_use]
pub fn perpendicular_rectangles(width_1_m: f32, width_2_m: f32, edge_m: f32) -> f32 {
    perpendicular_rectangles_with::<Portable>(width_1_m, width_2_m, edge_m)
}

/// The square of the width, relative to the longest side, below which a strip has no area.
const NEGLIGIBLE: f32 = 1e-30;

/// The distance, in lengths of the other sides, beyond which the far end of a rectangle does not count.
const FAR: f32 = 1e7;

/// The length of the edge, in widths of the rectangles, beyond which the ends of the edge do not count.
const ENDLESS: f32 = 1e9;

/// Does the same as [`perpendicular_rectangles`] with a math backend of your choice.
#[must_use]
pub fn perpendicular_rectangles_with<M: Math>(width_1_m: f32, width_2_m: f32, edge_m: f32) -> f32 {
    let [w, h, l] = [width_1_m, width_2_m, edge_m].map(f32::abs);
    // Work with the larger and the smaller rectangle, whose exchange is the same in both directions.
    let (large, small) = if w < h { (h, w) } else { (w, h) };
    let end = FAR * if small < l { l } else { small };
    let large = if large > end { end } else { large };
    let l = if l > ENDLESS * large { ENDLESS * large } else { l };
    let k = to_unity([large, small, l]);
    let [w, large, small, l] = [w, large, small, l].map(|x| x * k);
    let (w2, h2, l2) = (large * large, small * small, l * l);
    let all = l2 + (w2 + h2);
    let nothing = 0.0 * all; // 0, or NaN if a side is NaN
    if l2 < NEGLIGIBLE {
        return nothing;
    }
    if h2 < NEGLIGIBLE {
        // A narrow strip along the edge sees the other rectangle with half of its hemisphere.
        return nothing + if w > small { 0.5 * small / w } else { 0.5 };
    }
    let diagonal2 = w2 + h2;
    let diagonal = sqrt(diagonal2);
    let longer = h2 / (diagonal + large);
    // This is large atan(l / large) - diagonal atan(l / diagonal).
    let arcs = large * M::atan2(l * longer, diagonal * large + l2) - longer * M::atan2(l, diagonal);
    // The logarithm of 1 - (l2 / (l2 + h2)) (w2 / diagonal2). The product is near 1 for a short side and near
    // 0 for a long one.
    let rest = (l2 / (l2 + h2)) * (w2 / diagonal2);
    let short_log = if rest > 0.5 { M::ln((h2 / (l2 + h2)) * (all / diagonal2)) } else { ln_1p::<M>(-rest) };
    let logs = l2 * ln_1p::<M>(w2 / l2 * (h2 / all))
        + w2 * ln_1p::<M>(-(l2 / (l2 + w2)) * (h2 / diagonal2))
        + h2 * short_log;
    let exchanged = l * (small * M::atan2(l, small) + arcs) + 0.25 * logs;
    FRAC_1_PI * ratio(exchanged, w * l)
}

/// Returns ln(1 + x) for x > -1 without loss near 0, since the rounding of 1 + x cancels.
fn ln_1p<M: Math>(x: f32) -> f32 {
    let y = 1.0 + x;
    if y == 1.0 { x } else { M::ln(y) * (x / (y - 1.0)) }
}
