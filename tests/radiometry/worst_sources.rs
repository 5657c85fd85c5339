//! That the documented bounds of polygons and triangles hold at the worst that a search finds, and those of
//! disks beside their rims.
#![cfg(feature = "libm")]

use model::geometry::{self as exact, Point, wide};
use model::search::{Range, Range::*, Worst, units, worst};
use nanospectra::radiometry::form_factor::{to_disk, to_polygon};
use nanospectra::radiometry::solid_angle::{disk_off_axis, triangle};
use nanospectra::radiometry::{Nit, RectangleSource};
use std::f64::consts::PI;

const STEPS: usize = 8000;
const ANY: Range = Even(-1.0, 1.0);

/// A parallelogram whose middle is at a distance of 1 from a receiver.
struct View {
    corner: [f32; 3],
    edges: [[f32; 3]; 2],
    normal: [f32; 3],
    /// The cosine of the direction to its middle from its front.
    facing: f64,
    /// The sine of the angle between its edges.
    sine: f64,
    area: f64,
}

impl View {
    fn of(middle: [f32; 3], edges: [[f32; 3]; 2], lengths: [f32; 2], normal: [f32; 3]) -> Option<View> {
        if [middle, edges[0], edges[1], normal].iter().any(|v| exact::length(wide(*v)) < 0.1) {
            return None;
        }
        let [mut u, mut v] = [0, 1].map(|k| exact::times(exact::unit(wide(edges[k])), lengths[k].into()));
        let middle = exact::unit(wide(middle));
        if exact::dot(exact::cross(u, v), middle) > 0.0 {
            (u, v) = (v, u);
        }
        let narrow = |p: Point| p.map(|x| x as f32);
        let front = exact::cross(u, v);
        let area = exact::length(front);
        Some(View {
            corner: narrow(exact::minus(middle, exact::times(exact::plus(u, v), 0.5))),
            edges: [narrow(u), narrow(v)],
            normal: narrow(exact::unit(wide(normal))),
            facing: -exact::dot(front, middle) / area,
            sine: area / f64::from(lengths[0]) / f64::from(lengths[1]),
            area,
        })
    }

    fn corners(&self) -> [[f32; 3]; 4] {
        let sum = |a: [f32; 3], b: [f32; 3]| std::array::from_fn(|i| a[i] + b[i]);
        let ([u, v], a) = (self.edges, self.corner);
        [a, sum(a, u), sum(sum(a, u), v), sum(a, v)]
    }

    /// The height of the lowest corner above the receiver's horizon.
    fn lowest(&self) -> f64 {
        let heights = self.corners().map(|corner| exact::dot(wide(self.normal), wide(corner)));
        heights.into_iter().fold(f64::INFINITY, f64::min)
    }

    /// What was found, and what is right.
    fn factors(&self) -> [f64; 2] {
        let panel = RectangleSource { corner_m: self.corner, edges_m: self.edges, radiance: Nit::from(1.0) };
        let found = to_polygon([0.0; 3], self.normal, &self.corners());
        let lit = panel.irradiance([0.0; 3], self.normal).value().0;
        assert!((lit - std::f32::consts::PI * found).abs() <= 2e-7 * lit, "{lit} {found}");
        [found.into(), exact::to_polygon(wide(self.normal), &self.corners().map(wide))]
    }
}

/// The worst parallelogram, of an edge of this length and another one so many times as long.
fn parallelograms(seed: u64, length: Range, times: Range, error: impl Fn(View) -> f64) -> Worst<14> {
    let ranges = [ANY, ANY, ANY, ANY, ANY, ANY, ANY, ANY, ANY, ANY, ANY, ANY, length, times];
    worst(seed, STEPS, ranges, |[a, b, c, d, e, f, g, h, i, j, k, l, length, times]| {
        View::of([a, b, c], [[d, e, f], [g, h, i]], [length, times * length], [j, k, l]).map_or(-1.0, &error)
    })
}

#[test]
fn polygons_are_as_exact_as_promised() {
    let relative = |view: &View| {
        let [found, exact] = view.factors();
        (found / exact - 1.0).abs()
    };
    let moderate = |view: View| {
        let counts = view.facing > 0.3 && view.sine > 0.4 && view.lowest() > 0.1;
        if counts { relative(&view) } else { -1.0 }
    };
    let anywhere = |view: View| {
        let [found, exact] = view.factors();
        let counts = view.facing > 0.3 && view.sine > 0.4;
        if counts { (found - exact).abs() / view.area * PI } else { -1.0 }
    };
    // All sizes, and those at which the sum of angles begins, where it is least exact.
    let (all, edge, times) = (Sizes(1e-5, 3.0), Sizes(0.1, 0.15), Sizes(1.0, 3.0));
    let everywhere = [parallelograms(3, all, times, moderate), parallelograms(5, all, times, anywhere)];
    assert!(everywhere[0].error <= 6e-5 && everywhere[1].error <= 7e-6, "{everywhere:?}");
    parallelograms(3, edge, times, moderate).is_what_is_promised("polygons above the horizon", 6e-5);
    parallelograms(5, edge, times, anywhere)
        .is_what_is_promised("polygons anywhere, of the whole straight ahead", 7e-6);
    let slender = |view: View| {
        let counts = view.facing > 0.2 && view.sine > 0.9 && view.lowest() > 0.1;
        if counts { relative(&view) } else { -1.0 }
    };
    parallelograms(2, Sizes(0.015, 0.03), Even(19.9, 20.0), slender)
        .is_what_is_promised("slender polygons above the horizon", 4e-4);
}

/// The condition of a triangle's determinant, the least sine of two vertices more than a right angle apart,
/// and the solid angle.
fn solid_angle(from: [f32; 3], vertices: [[f32; 3]; 3]) -> (f64, f64, f64) {
    let [a, b, c] = vertices.map(|vertex| exact::minus(wide(vertex), wide(from)));
    let (u, v) = (exact::minus(b, a), exact::minus(c, a));
    let determinant = exact::dot(a, exact::cross(u, v)).abs();
    let [u, v, sizes] = [u, v, a].map(|side| side.map(f64::abs));
    let terms = (0..3).map(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        sizes[i] * (u[j] * v[k] + u[k] * v[j])
    });
    let [la, lb, lc] = [a, b, c].map(exact::length);
    let below = la * lb * lc + exact::dot(a, b) * lc + exact::dot(a, c) * lb + exact::dot(b, c) * la;
    let sine = [(a, b, la * lb), (b, c, lb * lc), (a, c, la * lc)]
        .into_iter()
        .filter(|(p, q, _)| exact::dot(*p, *q) < 0.0)
        .map(|(p, q, lengths)| exact::length(exact::cross(p, q)) / lengths)
        .fold(1.0, f64::min);
    (terms.sum::<f64>() / determinant, sine, 2.0 * determinant.atan2(below))
}

#[test]
fn triangles_are_as_exact_as_promised() {
    // A condition that is infinite or NaN: no area, or no view of it.
    let off = |from: [f32; 3], vertices: [[f32; 3]; 3], share: fn(f64, f64) -> f64| {
        let (condition, sine, exact) = solid_angle(from, vertices);
        if condition < 1e5 { units(triangle(from, vertices), exact) / share(condition, sine) } else { -1.0 }
    };
    let ranges =
        [ANY, ANY, ANY, ANY, ANY, ANY, ANY, ANY, ANY, ANY, ANY, ANY, Sizes(1e-6, 1.0), Even(0.0, 1.0)];
    worst(1, STEPS, ranges, |[a, b, c, d, e, f, g, h, i, j, k, l, size, away]| {
        let from = [a, b, c].map(|x| away * x);
        let at = |[x, y, z]: [f32; 3]| [d + size * x, e + size * y, f + size * z];
        let vertices = [[g, h, i], [j, k, l], [g - j, h - k, i - l]].map(at);
        off(from, vertices, |condition, sine| if sine < 1.0 { f64::INFINITY } else { 1.0 + condition })
    })
    .is_what_is_promised("triangles seen within right angles, in units and conditions", 5.0);
    // Two vertices in nearly opposite directions, and the third one anywhere or in line with them too.
    let (few, all) = (Sizes(1e-4, 1.0), Even(0.2, 1.2));
    let ranges = [ANY, ANY, ANY, ANY, ANY, ANY, ANY, ANY, ANY, ANY, ANY, ANY, few, few, all, all];
    worst(2, STEPS, ranges, |[a, b, c, d, e, f, g, h, i, j, k, l, near, line, behind, beside]| {
        let from = [a, b, c];
        let at = |[x, y, z]: [f32; 3], along: f32, aside: f32, [p, q, r]: [f32; 3]| {
            [a + along * x + aside * p, b + along * y + aside * q, c + along * z + aside * r]
        };
        let way = [d, e, f];
        let vertices = [
            at(way, 1.0, 0.0, way),
            at(way, -behind, near, [g, h, i]),
            at(way, beside - 0.7, line, [j, k, l]),
        ];
        off(
            from,
            vertices,
            |condition, sine| {
                if sine < 1.0 { (1.0 + condition) / (sine * sine) } else { f64::INFINITY }
            },
        )
    })
    .is_what_is_promised("triangles of opposite vertices, in units, conditions and squared sines", 7.0);
}

/// The boundary integral in a variable that gathers at the rim, of terms of one sign.
fn beside_rim(nodes: &[(f64, f64)], [r, h, o]: [f64; 3]) -> f64 {
    let (inside, near2) = (r - o, h * h + (r - o) * (r - o));
    if near2 == 0.0 {
        return PI;
    }
    // angle = scale sinh(s): equal steps of s where the distance to the rim changes.
    let scale = (near2 / (r * o)).sqrt();
    let top = (PI / scale).asinh();
    let panels = 1 + (top / 1.2) as usize;
    let width = top / panels as f64;
    let piece = |s: f64| {
        let half = (0.5 * scale * s.sinh()).sin();
        let beyond = 2.0 * half * half;
        let slant = (near2 + 2.0 * o * r * beyond).sqrt();
        let of_angle = if inside >= 0.0 {
            r * (inside + o * beyond) / (slant * (slant + h))
        } else {
            // About the center of the disk: the integral along the radius.
            h * r * r / (slant * (h.hypot(o) * slant + (h * h - o * inside) + o * r * beyond))
        };
        of_angle * scale * s.cosh()
    };
    let panel = |k: usize| exact::integral(nodes, width * k as f64, width * (k + 1) as f64, piece);
    2.0 * (0..panels).map(panel).sum::<f64>()
}

#[test]
fn disks_beside_their_rims_are_as_exact_as_promised() {
    let nodes = exact::gauss(16);
    let relative = |got: f32, exact: f64| (f64::from(got) / exact - 1.0).abs();
    let size = Sizes(3e-8, 3e7);
    let solid = worst(1, STEPS / 16, [size, size, Even(-3.0, 3.0)], |[radius, h, near]| {
        let offset = radius + h * near;
        let exact = beside_rim(&nodes, [radius, h, offset].map(f64::from));
        if offset <= 0.0 { -1.0 } else { relative(disk_off_axis(radius, h, offset), exact) }
    });
    // (The search of all places finds what is nearer to the bound.)
    assert!(solid.error <= 1.3e-6, "{solid:?}");
    worst(2, STEPS, [size, size, Even(-3.0, 3.0)], |[radius, h, near]| {
        let offset = radius + h * near;
        let [r, h64, o] = [radius, h, offset].map(f64::from);
        let root = h64.hypot(r - o) * h64.hypot(r + o);
        let beyond = h64 * h64 - (r - o) * (r + o);
        let exact = if beyond < 0.0 {
            0.5 * (root - beyond) / root
        } else {
            2.0 * r * h64 / root * r * h64 / (root + beyond)
        };
        if offset < 0.0 { -1.0 } else { relative(to_disk(radius, h, offset), exact) }
    })
    .is_what_is_promised("form factors to disks, beside their rims", 8e-7);
}
