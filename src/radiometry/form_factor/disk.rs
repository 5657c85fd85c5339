//! Disks: to each other on one axis, and from a point that faces the disk's plane.

use crate::geometry::vec3::to_unity;
use crate::math::sqrt;

/// From a disk of `radius_1_m` to one of `radius_2_m`, both on one axis and facing each other.
///
/// # Accuracy
/// 6 units of 2^-24, relative, also where F is tiny (the textbook's difference has nothing left
/// at a hundredth of a radian).
///
/// ```
/// use nanospectra::radiometry::form_factor::coaxial_disks;
/// // Equal disks one radius apart: (3 - sqrt 5) / 2.
/// assert!((coaxial_disks(1.0, 1.0, 1.0) - 0.381_966).abs() < 1e-7);
/// ```
#[must_use]
pub fn coaxial_disks(radius_1_m: f32, radius_2_m: f32, distance_m: f32) -> f32 {
    let k = to_unity([radius_1_m, radius_2_m, distance_m]);
    let [r1, r2, d] = [radius_1_m, radius_2_m, distance_m].map(|x| (x * k).abs());
    // Squared distances from rim to rim, across and along.
    let across = d * d + (r1 + r2) * (r1 + r2);
    let along = d * d + (r1 - r2) * (r1 - r2);
    let sum = d * d + r1 * r1 + r2 * r2;
    if sum == 0.0 {
        return 0.0;
    }
    2.0 * r2 * r2 / (sum + sqrt(along) * sqrt(across))
}

/// From a point to a disk in a plane parallel to its own, at a distance, with the disk's center `offset_m`
/// beside the point's normal.
///
/// # Accuracy
/// 6e-7, relative.
///
/// ```
/// use nanospectra::radiometry::form_factor::to_disk;
/// // On the axis: r^2 / (r^2 + d^2).
/// assert_eq!(to_disk(1.0, 2.0, 0.0), 0.2);
/// ```
#[must_use]
pub fn to_disk(radius_m: f32, distance_m: f32, offset_m: f32) -> f32 {
    let k = to_unity([radius_m, distance_m, offset_m]);
    let [r, h, offset] = [radius_m, distance_m, offset_m].map(|x| (x * k).abs());
    let (inside, across) = (r - offset, r + offset);
    let root = sqrt(h * h + inside * inside) * sqrt(h * h + across * across);
    let beyond = h * h - inside * across;
    if root == 0.0 {
        // In the plane: on the rim, or nothing at no distance.
        if r == 0.0 { 0.0 } else { 0.5 }
    } else if beyond < 0.0 {
        0.5 * (root - beyond) / root
    } else {
        2.0 * (r * h / root) * (r * h / (root + beyond))
    }
}
