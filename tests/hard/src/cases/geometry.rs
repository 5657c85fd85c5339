//! Rows 7 to 13: solid angles and form factors of shapes that are small, far, huge or without area.

use super::Cases;
use super::noise::Noise;
use super::textbook::{acos, atan, cos, tan};
use core::f32::consts::{PI, TAU};
use nanospectra::math::sqrt;
use nanospectra::radiometry::form_factor::coaxial_disks;
use nanospectra::radiometry::solid_angle::{cone, sphere, triangle};

pub fn rows(cases: &mut impl Cases) {
    cases.row(
        "7",
        &[[1e-4], [4.65e-3], [0.03], [0.5], [1.571_373_7], [3.0]],
        |&[half]| [TAU * (1.0 - cos(half))],
        |&[half]| [cone(half)],
    );
    cases.row("8", &SPHERES, naive_sphere, |&[radius, distance]| [sphere(radius, distance)]);
    cases.row("9", &DISKS, naive_disks, |&[r1, r2]| [coaxial_disks(r1, r2, 1.0)]);
    let small = small();
    cases.row("10", &small, |corners| [van_oosterom(corners, atan2)], ours_triangle);
    cases.row("11a", &small, lhuilier, ours_triangle);
    cases.row("11b", &small, girard, ours_triangle);
    cases.row("12", &huge(), |corners| [van_oosterom(corners, |y, x| atan(y / x))], ours_triangle);
    cases.row("13", &DEGENERATE, girard, ours_triangle);
}

/// Radius and distance of spheres: the sun, a ten thousandth of a radian, and near ones.
const SPHERES: [[f32; 2]; 8] = [
    [6.957e8, 1.496e11],
    [1.0, 1e4],
    [4.65e-3, 1.0],
    [1e-4, 1.0],
    [0.1, 1.0],
    [1.0, 2.0],
    [1.0, 1.001],
    [1.136_706_4, 514.607],
];

/// The radii of pairs of disks at a distance of 1.
const DISKS: [[f32; 2]; 8] = [
    [3.389_908e-4, 1.402_434_3e-3],
    [0.1, 0.1],
    [0.01, 0.01],
    [1e-3, 1e-3],
    [0.013, 0.007],
    [0.1, 0.01],
    [1.0, 0.5],
    [3.0, 1.0],
];

type Corners = [f32; 9];

/// Returns triangles of a thousandth to a millionth at a distance of about 1, ten of each size.
fn small() -> [Corners; 40] {
    let mut noise = Noise(10);
    let mut all = [[0.0; 9]; 40];
    for (some, size) in all.chunks_mut(10).zip([1e-3, 1e-4, 1e-5, 1e-6]) {
        for corners in some {
            let place = [noise.offset(), noise.offset(), 0.5 + noise.share()];
            for corner in corners.chunks_mut(3) {
                corner.iter_mut().zip(place).for_each(|(x, place)| *x = place + size * noise.offset());
            }
        }
    }
    all
}

/// Returns triangles around the observer, who is nearly in their plane.
fn huge() -> [Corners; 7] {
    let (mut height, mut noise) = (1.0, Noise(12));
    [(); 7].map(|()| {
        height *= 0.1;
        let (x, y) = (0.2 * noise.offset(), 0.2 * noise.offset());
        [1.0 + x, y, height, -0.7 + x, 0.9 + y, height, -0.8 + x, -1.1 + y, height]
    })
}

/// Triangles without area, with the observer on a vertex, and with the observer in their plane.
const DEGENERATE: [Corners; 6] = [
    [0.3, -0.2, 1.0, 0.3, -0.2, 1.0, 0.3, -0.2, 1.0],
    [0.3, -0.2, 1.0, 0.3, -0.2, 1.0, 1.3, 0.1, 1.0],
    [1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 4.0, 4.0, 4.0],
    [0.0, 0.0, 0.0, 1.0, 0.3, 0.0, 0.1, 1.1, 0.0],
    [1.0, 2.0, 0.0, 3.0, 2.0, 0.0, 2.0, 4.0, 0.0],
    [-1.0, -1.0, 0.0, 2.0, -1.0, 0.0, 0.0, 2.0, 0.0],
];

fn naive_sphere(&[radius, distance]: &[f32; 2]) -> [f32; 1] {
    let sine = radius / distance;
    [TAU * (1.0 - sqrt(1.0 - sine * sine))]
}

fn naive_disks(&[r1, r2]: &[f32; 2]) -> [f32; 1] {
    let sum = 1.0 + (1.0 + r2 * r2) / (r1 * r1);
    let ratio = r2 / r1;
    [0.5 * (sum - sqrt(sum * sum - 4.0 * ratio * ratio))]
}

fn points(corners: &Corners) -> [[f32; 3]; 3] {
    let [a, b, c, d, e, f, g, h, i] = *corners;
    [[a, b, c], [d, e, f], [g, h, i]]
}

fn ours_triangle(corners: &Corners) -> [f32; 1] {
    [triangle([0.0; 3], points(corners))]
}

fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn atan2(y: f32, x: f32) -> f32 {
    use nanospectra::math::{Libm, Math};
    Libm::atan2(y, x)
}

/// Computes the formula of Van Oosterom and Strackee as published, with the given arc tangent.
fn van_oosterom(corners: &Corners, arc_tangent: fn(f32, f32) -> f32) -> f32 {
    let [a, b, c] = points(corners);
    let [la, lb, lc] = [a, b, c].map(|v| sqrt(dot(v, v)));
    let volume = dot(a, cross(b, c));
    let volume = if volume < 0.0 { -volume } else { volume };
    2.0 * arc_tangent(volume, la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la)
}

/// Returns the sides of the triangle on the unit sphere.
fn sides(corners: &Corners) -> [f32; 3] {
    let [a, b, c] = points(corners).map(|v| {
        let length = sqrt(dot(v, v));
        v.map(|x| x / length)
    });
    [acos(dot(b, c)), acos(dot(c, a)), acos(dot(a, b))]
}

fn lhuilier(corners: &Corners) -> [f32; 1] {
    let [a, b, c] = sides(corners);
    let s = 0.5 * (a + b + c);
    let product = tan(0.5 * s) * tan(0.5 * (s - a)) * tan(0.5 * (s - b)) * tan(0.5 * (s - c));
    [4.0 * atan(sqrt(product))]
}

/// Returns the sum of the angles less pi.
fn girard(corners: &Corners) -> [f32; 1] {
    let [a, b, c] = sides(corners);
    let angle = |across: f32, p: f32, q: f32| {
        let sines = sqrt((1.0 - cos(p) * cos(p)) * (1.0 - cos(q) * cos(q)));
        acos((cos(across) - cos(p) * cos(q)) / sines)
    };
    [angle(a, b, c) + angle(b, c, a) + angle(c, a, b) - PI]
}
