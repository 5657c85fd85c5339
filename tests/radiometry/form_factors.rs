//! Form factors against textbook formulas in f64, and solid angles against the sum of their elements.
#![cfg(feature = "libm")]

use model::allowed::{Singles, check};
use model::geometry::{self as exact, gauss, wide};
use model::noise::Noise;
use nanospectra::math::Fast;
use nanospectra::radiometry::SurfaceElement;
use nanospectra::radiometry::form_factor::{
    parallel_rectangles, parallel_rectangles_with, perpendicular_rectangles, reciprocal, to_polygon,
    to_sphere,
};
use nanospectra::radiometry::solid_angle::{disk_off_axis, sphere, triangle};
use std::f64::consts::PI;

#[test]
fn opposite_rectangles_keep_their_form_factor() {
    let mut check = check("opposite rectangles");
    for a in 0..60 {
        for b in 0..60 {
            // 0.02 to 1000 times the distance; below, f64 has not enough digits for the textbook's formula.
            let [a, b] = [a, b].map(|k| (0.02 * 10f64.powf(f64::from(k) * 0.08)) as f32);
            let exact = exact::parallel_rectangles(a.into(), b.into(), 1.0);
            check.add(&format!("{a} x {b}"), parallel_rectangles(a, b, 1.0), exact);
        }
    }
    check.tight_over_all();
    // Far away the product of the areas over pi d^2, and touching all of it.
    assert!((parallel_rectangles(1e-6, 2e-6, 1.0) / (2e-12 / std::f32::consts::PI) - 1.0).abs() < 1e-6);
    assert_eq!((parallel_rectangles(1.0, 2.0, 0.0), parallel_rectangles(0.0, 1.0, 1.0)), (1.0, 0.0));
    let fast = parallel_rectangles_with::<Fast>(2.0, 3.0, 1.0);
    assert!((fast / parallel_rectangles(2.0, 3.0, 1.0) - 1.0).abs() < 2e-6);
}

#[test]
fn rectangles_at_a_right_angle_keep_their_form_factor() {
    let mut check = check("rectangles at a right angle");
    for a in 0..60 {
        for b in 0..60 {
            let [a, b] = [a, b].map(|k| (0.001 * 10f64.powf(f64::from(k) * 0.1)) as f32);
            let exact = exact::perpendicular_rectangles(a.into(), b.into(), 1.0);
            check.add(&format!("{a} x {b}"), perpendicular_rectangles(a, b, 1.0), exact);
        }
    }
    check.tight_over_all();
    // From any face of a box all light arrives on the other five.
    for [x, y, z] in [[1.0f32, 1.0, 1.0], [4.0, 3.0, 2.5], [0.1, 20.0, 1.0]] {
        let sides = perpendicular_rectangles(x, z, y) + perpendicular_rectangles(y, z, x);
        let all = parallel_rectangles(x, y, z) + 2.0 * sides;
        assert!((all - 1.0).abs() < 2e-6, "{x} {y} {z}: {all}");
    }
    // To a strip along the edge goes what its area gets from half of what it sees.
    let strip = reciprocal(perpendicular_rectangles(1e-4, 1.0, 1.0), 1e-4, 1.0);
    assert!((strip / perpendicular_rectangles(1.0, 1e-4, 1.0) - 1.0).abs() < 3e-6, "{strip}");
}

/// A quadrilateral of this size about a place, facing the origin, not too slender.
fn quadrilateral(noise: &mut Noise, middle: [f32; 3], size: f32) -> [[f32; 3]; 4] {
    loop {
        let [u, v] = [noise.point(), noise.point()].map(wide);
        let area = exact::length(exact::cross(u, v));
        if area < 0.4 * exact::length(u) * exact::length(v) {
            continue;
        }
        let facing = exact::dot(exact::cross(u, v), exact::unit(wide(middle)));
        if facing.abs() < 0.3 * area {
            continue;
        }
        let (u, v) = if facing < 0.0 { (u, v) } else { (v, u) };
        return [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(s, t)| std::array::from_fn(|i| middle[i] + 0.5 * size * (s * u[i] + t * v[i]) as f32));
    }
}

/// A rectangle of this size about a place, facing the origin.
fn rectangle(noise: &mut Noise, middle: [f32; 3], [width, height]: [f32; 2]) -> [[f32; 3]; 4] {
    loop {
        let u = exact::unit(wide(noise.point()));
        let away = exact::unit(exact::cross(u, wide(noise.point())));
        if exact::dot(away, wide(middle)) > 0.2 {
            let (u, v) = (
                exact::times(u, 0.5 * f64::from(width)),
                exact::times(exact::cross(u, away), 0.5 * f64::from(height)),
            );
            return [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
                .map(|(s, t)| std::array::from_fn(|i| middle[i] + (s * u[i] + t * v[i]) as f32));
        }
    }
}

#[test]
fn slender_polygons_lose_digits() {
    let (mut check, mut compared) = (check("slender polygons above the horizon"), 0);
    let mut noise = Noise(2);
    for _ in 0..40_000 {
        let width = 10f32.powf(-2.5 + 1.5 * noise.offset());
        let middle = exact::unit(wide(noise.point())).map(|x| x as f32);
        let corners = rectangle(&mut noise, middle, [width, 20.0 * width]);
        let normal = exact::unit(wide(noise.point()));
        let exact = exact::to_polygon(normal, &corners.map(wide));
        if corners.iter().all(|corner| exact::dot(normal, wide(*corner)) > 0.1) {
            let got = to_polygon([0.0; 3], normal.map(|x| x as f32), &corners);
            check.add(&format!("{width}: {corners:?} {normal:?}"), got, exact);
            compared += 1;
        }
    }
    check.tight(compared);
}

#[test]
fn polygons_keep_their_form_factor_however_small_and_tilted() {
    let (mut up, mut cut) = (check("polygons above the horizon"), check("polygons cut by the horizon"));
    let (mut ups, mut cuts) = (0, 0);
    let mut noise = Noise(1);
    for around in [3.0, 1.0, 0.6, 0.4, 0.3, 0.2, 0.14, 0.1, 0.03, 1e-2, 1e-3, 1e-4f32] {
        for _ in 0..2000 {
            let size = around * (1.0 + 0.3 * noise.offset());
            let middle = exact::unit(wide(noise.point())).map(|x| x as f32);
            let corners = if noise.offset() < 0.0 {
                quadrilateral(&mut noise, middle, size)
            } else {
                rectangle(&mut noise, middle, [size; 2])
            };
            let normal = exact::unit(wide(noise.point()));
            let heights = corners.map(|corner| exact::dot(normal, wide(corner)));
            let exact = exact::to_polygon(normal, &corners.map(wide));
            let got = to_polygon([0.0; 3], normal.map(|x| x as f32), &corners);
            let place = format!("{size}: {got:e} for {exact:e}, {corners:?} {normal:?}");
            if heights.iter().all(|h| *h > 0.1) {
                up.add(&place, got, exact);
                ups += 1;
            } else if heights.iter().all(|h| *h < 0.0) {
                assert_eq!(got, 0.0, "{place}");
            } else {
                // In units of the factor of the whole, straight ahead.
                let whole = f64::from(size * size) / PI;
                cut.value(&place, f64::from(got) / whole, exact / whole);
                cuts += 1;
            }
        }
    }
    assert!(ups > 1000 && cuts > 500, "{ups} {cuts}");
    up.tight(ups);
    cut.tight(cuts);
}

#[test]
fn polygons_are_what_the_closed_forms_say() {
    // A square over its middle, from near and far: four times the textbook's corner.
    for half in [0.01f32, 0.5, 3.0, 100.0] {
        let corner = |x: f32, y: f32| [x * half, y * half, 1.0];
        let square = [corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)];
        let slant = f64::from(half).hypot(1.0);
        let exact = 4.0 / (PI * slant) * f64::from(half) * (f64::from(half) / slant).atan();
        let got = to_polygon([0.0; 3], [0.0, 0.0, 3.0], &square);
        assert!((f64::from(got) / exact - 1.0).abs() < 1e-6, "{half}: {got} {exact}");
        // Turned to the side, half of it has set.
        let sideways = to_polygon([0.0; 3], [1.0, 0.0, 0.0], &square);
        let exact = exact::to_polygon([1.0, 0.0, 0.0], &square.map(wide));
        assert!((f64::from(sideways) / exact - 1.0).abs() < 3e-6, "{half}: {sideways} {exact}");
        let mut behind = square;
        behind.reverse();
        assert_eq!(to_polygon([0.0; 3], [0.0, 0.0, 1.0], &behind), 0.0);
    }
    // An L, which is not convex, is its bounding square less a quarter.
    let l =
        [[0.0, 0.0], [0.0, 2.0], [1.0, 2.0], [1.0, 1.0], [2.0, 1.0], [2.0, 0.0]].map(|[x, y]| [x, y, 1.0]);
    let square = |x: f32, y: f32, w: f32| {
        to_polygon(
            [0.3, 0.2, 0.0],
            [0.1, 0.2, 1.0],
            &[[x, y, 1.0], [x, y + w, 1.0], [x + w, y + w, 1.0], [x + w, y, 1.0]],
        )
    };
    let got = to_polygon([0.3, 0.2, 0.0], [0.1, 0.2, 1.0], &l);
    assert!((got / (square(0.0, 0.0, 2.0) - square(1.0, 1.0, 1.0)) - 1.0).abs() < 2e-6, "{got}");
    // Too few vertices are none.
    for few in [&l[..0], &l[..1], &l[..2]] {
        assert_eq!(to_polygon([0.0; 3], [0.0, 0.0, 1.0], few), 0.0);
    }
    assert!(to_polygon([0.0; 3], [f32::NAN, 0.0, 1.0], &l).is_nan());
    assert!(to_polygon([0.0, 0.0, f32::NAN], [0.0, 0.0, 1.0], &l).is_nan());
}

#[test]
fn elements_of_a_surface_add_up_to_its_solid_angle_and_form_factor() {
    // A sphere of radius 1 at distance 3, in rings and sectors; the receiver is tilted so that all of it is
    // up.
    let (radius, distance) = (1.0f64, 3.0);
    let normal = [0.6f32, 0.0, 0.8];
    let (mut solid_angle, mut factor) = (0.0, 0.0);
    let (rings, sectors) = (400, 64);
    for ring in 0..rings {
        let cos = 1.0 - 2.0 * (f64::from(ring) + 0.5) / f64::from(rings);
        for sector in 0..sectors {
            let (sin_phi, cos_phi) = (2.0 * PI * f64::from(sector) / f64::from(sectors)).sin_cos();
            let sin = (1.0 - cos * cos).sqrt();
            let normal_there = [sin * cos_phi, sin * sin_phi, cos];
            let piece = SurfaceElement {
                position_m: exact::plus([0.0, 0.0, distance], normal_there).map(|x| x as f32),
                normal: normal_there.map(|x| x as f32),
                area_m2: (4.0 * PI * radius / f64::from(rings * sectors)) as f32,
            };
            let (direction, dw) = piece.seen_from([0.0; 3]);
            solid_angle += f64::from(dw);
            factor += f64::from(dw) * exact::dot(wide(direction), wide(normal)) / PI;
        }
    }
    assert!((solid_angle / f64::from(sphere(1.0, 3.0)) - 1.0).abs() < 1e-4, "{solid_angle}");
    assert!((factor / f64::from(to_sphere(1.0, 3.0, 0.8)) - 1.0).abs() < 1e-4, "{factor}");

    // A triangle and a disk in Gauss points.
    let corners = [[0.5f32, -0.3, 1.0], [1.5, 0.4, 1.2], [0.2, 0.9, 0.8]];
    let [p, q, r] = corners.map(wide);
    let away = exact::unit(exact::cross(exact::minus(q, p), exact::minus(r, p)));
    let nodes = gauss(12);
    let seen = |normal: exact::Point, place: exact::Point| {
        let piece = SurfaceElement {
            position_m: place.map(|x| x as f32),
            normal: normal.map(|x| x as f32),
            area_m2: 1.0,
        };
        f64::from(piece.seen_from([0.0; 3]).1)
    };
    let toward = exact::times(away, -exact::dot(away, p).signum());
    let sum = exact::over_triangle(&nodes, [p, q, r], |place| seen(toward, place));
    assert!((sum / f64::from(triangle([0.0; 3], corners)) - 1.0).abs() < 1e-6, "{sum}");
    assert_eq!(seen(exact::times(toward, -1.0), p), 0.0, "from behind");
    let ring = |rho: f64| {
        let steps = 64;
        let at = |k: i32| {
            let (sin, cos) = (2.0 * PI * f64::from(k) / f64::from(steps)).sin_cos();
            seen([0.0, 0.0, -1.0], [0.4 + rho * cos, rho * sin, 1.5])
        };
        (0..steps).map(at).sum::<f64>() * 2.0 * PI / f64::from(steps) * rho
    };
    let sum = exact::integral(&nodes, 0.0, 1.0, ring);
    assert!((sum / f64::from(disk_off_axis(1.0, 1.5, 0.4)) - 1.0).abs() < 1e-6, "{sum}");
    // Its own place has no direction.
    let here = SurfaceElement { position_m: [1.0; 3], normal: [0.0, 0.0, 1.0], area_m2: 1.0 };
    assert_eq!(here.seen_from([1.0; 3]), ([0.0; 3], 0.0));
}
