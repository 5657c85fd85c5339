//! Computes form factors between coaxial disks, and from a point to a disk that is parallel to its surface.

use crate::geometry::vec3::to_unity;
use crate::math::sqrt;

/// Returns the form factor from a disk of `radius_1_m` to one of `radius_2_m` on the same axis.
///
/// The disks face each other at `distance_m`.
///
/// # Accuracy
/// The relative error is at most 7 units of 2^-24, also where F is tiny. (The textbook formula is a
/// difference that has no digit left for disks of a hundredth of a radian.)
///
/// # Example
/// ```
/// use nanospectra::radiometry::form_factor::coaxial_disks;
/// // For equal disks one radius apart it is (3 - sqrt 5) / 2.
/// assert!((coaxial_disks(1.0, 1.0, 1.0) - 0.381_966).abs() < 1e-7);
/// ```
#[must_use]
pub fn coaxial_disks(radius_1_m: f32, radius_2_m: f32, distance_m: f32) -> f32 {
    let k = to_unity([radius_1_m, radius_2_m, distance_m]);
    let [r1, r2, d] = [radius_1_m, radius_2_m, distance_m].map(|x| (x * k).abs());
    // The squares of the longest and of the shortest distance from rim to rim.
    let across = d * d + (r1 + r2) * (r1 + r2);
    let along = d * d + (r1 - r2) * (r1 - r2);
    let sum = d * d + r1 * r1 + r2 * r2;
    if sum == 0.0 {
        return 0.0;
    }
    2.0 * r2 * r2 / (sum + sqrt(along) * sqrt(across))
}

/// Returns the form factor from a point to a disk whose plane is parallel to the surface at the point.
///
/// `distance_m` is the distance between the two planes, and `offset_m` the distance of the disk's center from
/// the normal through the point.
///
/// # Accuracy
/// The relative error is at most 8e-7 while no length is more than 1e15 times another. Beyond that, the
/// result for a point beside the rim may be half of what it should be.
///
/// # Example
/// ```
/// use nanospectra::radiometry::form_factor::to_disk;
/// // On the axis it is r^2 / (r^2 + d^2).
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
        // The point lies in the disk's plane, on its rim. A disk of radius 0 has no form factor.
        if r == 0.0 { 0.0 } else { 0.5 }
    } else if beyond < 0.0 {
        0.5 * (root - beyond) / root
    } else {
        2.0 * (r * h / root) * (r * h / (root + beyond))
    }
}
