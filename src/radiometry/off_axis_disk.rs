//! Computes the solid angle of a disk from any point, by a short sum or, near the rim, an elliptic integral.

use crate::geometry::vec3::to_unity;
use crate::math::sqrt;
use core::f32::consts::{FRAC_PI_2, PI, TAU};

/// The cosines of the odd multiples of 1/64 turn, up to a quarter turn.
const COSINES: [f32; 8] = [
    0.995_184_73,
    0.956_940_34,
    0.881_921_26,
    0.773_010_45,
    0.634_393_28,
    0.471_396_74,
    0.290_284_68,
    0.098_017_14,
];

/// Returns the solid angle of a disk for a point that may lie beside the disk's axis.
///
/// `distance_m` is the distance from the plane of the disk, and `offset_m` that from its axis. For a point in
/// the plane the result is the limit from above: 2 pi on the disk, pi on its rim and 0 outside. For points on
/// the axis [`disk`](crate::radiometry::solid_angle::disk) is faster.
///
/// # Accuracy
/// The relative error is at most 1.3e-6 while no length is more than 1e15 times another.
///
/// # Cost
/// The function takes 18 or 19 square roots, or up to 10 near the rim.
///
/// # Reference
/// Away from the rim it sums the boundary integral, whose terms have the same sign; since the integrand is
/// periodic, 16 equal steps of a half turn bring the sum to 1e-8. Near the rim it follows Paxton 1959, with
/// one complete elliptic integral by Bulirsch 1969.
///
/// # Example
/// ```
/// use nanospectra::radiometry::solid_angle::{disk, disk_off_axis};
/// assert!((disk_off_axis(1.0, 2.0, 0.0) - disk(1.0, 2.0)).abs() < 1e-6);
/// // Half a radius above the rim.
/// assert!((disk_off_axis(1.0, 0.5, 1.0) - 1.768_723).abs() < 1e-6);
/// ```
#[must_use]
pub fn disk_off_axis(radius_m: f32, distance_m: f32, offset_m: f32) -> f32 {
    let k = to_unity([radius_m, distance_m, offset_m]);
    let [r, h, offset] = [radius_m, distance_m, offset_m].map(|x| (x * k).abs());
    let (inside, across) = (r - offset, r + offset);
    // The distances to the nearest and to the farthest point of the rim.
    let near = sqrt(h * h + inside * inside);
    let far = sqrt(h * h + across * across);
    if far == 0.0 {
        0.0
    } else if near < 0.27 * far {
        beside_rim(r, h, inside, across, near / far, far)
    } else if inside >= 0.0 {
        // Sum over the angle about the foot of the perpendicular: 1 - cos of the angle from there to the rim.
        let nearest = near * near;
        around(|cos| {
            let (slant, lever) =
                (sqrt(nearest + 2.0 * offset * r * (1.0 - cos)), inside + offset * (1.0 - cos));
            r * lever / (slant * (slant + h))
        })
    } else {
        // Sum over the angle about the disk's center: the integral along the radius at that angle.
        let (nearest, center) = (near * near, h * h + offset * offset);
        let axis = sqrt(center);
        let toward = h * h - offset * inside;
        around(|cos| {
            let slant = sqrt(nearest + 2.0 * offset * r * (1.0 - cos));
            h * r * r / (slant * (axis * slant + toward + offset * r * (1.0 - cos)))
        })
    }
}

/// Returns twice the integral over half a turn of a function of the cosine of the angle.
fn around(f: impl Fn(f32) -> f32) -> f32 {
    COSINES.iter().fold(0.0, |sum, cos| sum + (f(*cos) + f(-cos))) * (TAU / 16.0)
}

/// Returns the solid angle near the rim, where `kc` = near / far is below 0.27.
fn beside_rim(r: f32, h: f32, inside: f32, across: f32, kc: f32, far: f32) -> f32 {
    if h == 0.0 || kc == 0.0 {
        return in_plane(inside);
    }
    // The integral of (across cos^2 + inside sin^2) / ((across^2 cos^2 + inside^2 sin^2) root(..)).
    let slope = inside / across;
    let elliptic = if slope == 0.0 { cel(kc, 1.0, 1.0, 1.0) } else { cel(kc, slope.abs(), 1.0, slope) };
    in_plane(inside) - 4.0 * r * h / (across * far) * elliptic
}

/// Returns the solid angle just above the plane of the disk.
fn in_plane(inside: f32) -> f32 {
    if inside > 0.0 {
        TAU
    } else if inside == 0.0 {
        PI
    } else {
        0.0
    }
}

/// Returns Bulirsch's complete elliptic integral.
///
/// It is the integral over a quarter turn of (a cos^2 + b sin^2) / ((cos^2 + root_p^2 sin^2) sqrt(cos^2 +
/// kc^2 sin^2)). Each step squares the error, and 6 steps suffice for any f32 `kc`.
fn cel(kc: f32, root_p: f32, a: f32, b: f32) -> f32 {
    let (mut p, mut a, mut b, mut qc, mut e, mut em) = (root_p, a, b / root_p, kc, kc, 1.0);
    for _ in 0..8 {
        let (f, g) = (a, e / p);
        a += b / p;
        b = 2.0 * (b + f * g);
        p += g;
        let last = em;
        em += qc;
        if (last - qc).abs() <= last * 2e-4 {
            break;
        }
        qc = 2.0 * sqrt(e);
        e = qc * em;
    }
    FRAC_PI_2 * (b + a * em) / (em * (em + p))
}
