//! What goes wrong in f32 if it is written naively, at the tolerance that the stable form holds: solid angles
//! and form factors of what is small, far, huge, edge-on or nothing at all.
#![cfg(feature = "libm")]

use model::allowed::check;
use model::check::{Check, EPS};
use model::geometry::{self as exact, gauss, wide};
use model::noise::Noise;
use nanospectra::math::{Fast, Portable};
use nanospectra::radiometry::form_factor::{coaxial_disks, to_disk, to_sphere};
use nanospectra::radiometry::solid_angle::{
    WHOLE_SPHERE, cone, disk, disk_off_axis, rectangle, sphere, triangle, triangle_with,
};
use nanospectra::radiometry::{Candela, DiskSource, Nit, PointSource, SphereSource};
use std::f64::consts::PI;

/// The relative error in units of rounding.
fn compare(check: &mut Check, place: &str, got: f32, exact: f64) {
    check.value(
        &format!("{place}: {got:e} for {exact:e}"),
        (f64::from(got) - exact).abs() / (exact * EPS),
        0.0,
    );
}

/// `n` numbers from `low` to `high`, equally spaced in the logarithm.
fn sweep(low: f64, high: f64, n: usize) -> impl Iterator<Item = f32> {
    (0..n).map(move |k| (low * (high / low).powf(k as f64 / (n - 1) as f64)) as f32)
}

/// 1e-3..=1e3, evenly in the logarithm.
fn length(noise: &mut Noise) -> f32 {
    10f32.powf(3.0 * noise.offset())
}

#[test]
fn narrow_cones_keep_their_solid_angle() {
    let mut check = check("cones, in eps");
    for angle in sweep(1e-12, PI, 100_000) {
        compare(&mut check, &format!("{angle} rad"), cone(angle), exact::cone(angle.into()));
    }
    for angle in [4.65e-3, 1e-4] {
        compare(&mut check, &format!("{angle} rad"), cone(angle), exact::cone(angle.into()));
    }
    check.tight(100_002);
    assert_eq!(1.0 - 1e-4f32.cos(), 0.0, "the naive form loses it all");
    assert_eq!((cone(0.0), cone(3.2)), (0.0, WHOLE_SPHERE));
}

#[test]
fn far_spheres_keep_their_solid_angle() {
    let mut check = check("spheres, in eps");
    let mut noise = Noise(8);
    for ratio in sweep(1e-12, 1.0, 100_000) {
        let radius = 1.0 + noise.offset().abs();
        let distance = (radius / ratio).max(radius);
        let place = format!("{radius} m at {distance} m");
        compare(&mut check, &place, sphere(radius, distance), exact::sphere(radius.into(), distance.into()));
    }
    let [radius, distance] = [1.136_706_4, 514.607];
    compare(
        &mut check,
        "the worst found",
        sphere(radius, distance),
        exact::sphere(radius.into(), distance.into()),
    );
    check.tight(100_001);
    // The sun, and a ten thousandth of a radian.
    for (radius, distance) in [(6.957e8f32, 1.496e11), (1.0, 1e4), (4.65e-3, 1.0), (1e-4, 1.0)] {
        let exact = exact::sphere(radius.into(), distance.into());
        assert!((f64::from(sphere(radius, distance)) / exact - 1.0).abs() < 4.0 * EPS, "{radius} {distance}");
    }
    assert_eq!((sphere(1.0, 1.0), sphere(1.0, 0.5)), (std::f32::consts::TAU, WHOLE_SPHERE));
}

#[test]
fn far_coaxial_disks_keep_their_form_factor() {
    let mut check = check("coaxial disks, in eps");
    let mut noise = Noise(9);
    for ratio in sweep(1e-8, 1e3, 100_000) {
        let [r1, r2] = [0, 1].map(|_| ratio * (1.0 + noise.offset().abs()));
        let place = format!("{r1} m and {r2} m");
        compare(
            &mut check,
            &place,
            coaxial_disks(r1, r2, 1.0),
            exact::coaxial_disks(r1.into(), r2.into(), 1.0),
        );
    }
    check.tight(100_000);
    // Touching: all of the smaller one's light, and of the larger one's what its area gets.
    assert_eq!((coaxial_disks(1.0, 2.0, 0.0), coaxial_disks(2.0, 1.0, 0.0)), (1.0, 0.25));
    assert_eq!((coaxial_disks(1.0, 0.0, 0.0), coaxial_disks(0.0, 0.0, 0.0)), (0.0, 0.0));
}

/// The sum of the sizes of the determinant's terms over its value.
fn condition([a, b, c]: [[f32; 3]; 3]) -> f64 {
    let (a, u, v) = (wide(a), exact::minus(wide(b), wide(a)), exact::minus(wide(c), wide(a)));
    let sizes = [u, v, a].map(|side| side.map(f64::abs));
    let [u_size, v_size, a_size] = sizes;
    let permanent = (0..3).map(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a_size[i] * (u_size[j] * v_size[k] + u_size[k] * v_size[j])
    });
    permanent.sum::<f64>() / exact::dot(a, exact::cross(u, v)).abs()
}

#[test]
fn small_triangles_keep_their_solid_angle() {
    let mut plain = check("small triangles");
    let mut conditioned = check("small triangles, in eps times their condition");
    let nodes = gauss(8);
    let mut noise = Noise(10);
    for size in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6f32] {
        for _ in 0..1000 {
            let direction = exact::unit(wide(noise.point())).map(|x| x as f32);
            let corners = [0, 1, 2].map(|_| {
                let offset = noise.point();
                std::array::from_fn(|i| direction[i] + size * offset[i])
            });
            let exact = exact::small_triangle(&nodes, corners.map(wide));
            let condition = condition(corners);
            let got = triangle([0.0; 3], corners);
            // At 1e-6 the corners lie on a lattice of six steps, and some triangles have no area.
            if condition < 1e4 {
                let place = format!("{corners:?}: {got:e} for {exact:e}");
                let error = f64::from(got) / exact - 1.0;
                plain.value(&place, error, 0.0);
                conditioned.value(&place, error / ((1.0 + condition) * EPS), 0.0);
            }
        }
    }
    plain.tight_over_more_than(5900);
    conditioned.tight_over_more_than(5900);
}

#[test]
fn huge_triangles_fill_the_hemisphere() {
    let mut check = check("huge triangles, in eps");
    let mut noise = Noise(12);
    for height in [1e-1f32, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
        for _ in 0..100 {
            // Around the observer at no less than a fifth of the size.
            let [x, y] = [0, 1].map(|_| 0.2 * noise.offset());
            let corners = [[1.0 + x, y, height], [-0.7 + x, 0.9 + y, height], [-0.8 + x, -1.1 + y, height]];
            compare(
                &mut check,
                &format!("{corners:?}"),
                triangle([0.0; 3], corners),
                exact::triangle(corners.map(wide)),
            );
        }
    }
    check.tight_over_all();
}

#[test]
fn triangles_with_opposite_vertices_lose_a_little_more() {
    let mut check = check("triangles of opposite vertices, in eps times their conditions");
    let mut noise = Noise(15);
    let count = 100_000;
    for case in 0..count {
        let [a, c] = [0, 1].map(|_| exact::unit(wide(noise.point())));
        // Opposite up to a tenth, in other lengths.
        let tilt = 0.1 * f64::from(noise.offset());
        let b = exact::plus(exact::times(a, -1.0), exact::times(exact::unit(wide(noise.point())), tilt));
        let drawn =
            [a, b, c].map(|corner| exact::times(corner, length(&mut noise).sqrt().into()).map(|x| x as f32));
        let worst = [[0.6295, -0.2622, 0.0515], [-0.9653, 0.3820, -0.0202], [-0.9356, -0.1962, 0.1194]];
        let corners = if case == 0 { worst } else { drawn };
        let exact = exact::triangle(corners.map(wide));
        let (got, condition) = (triangle([0.0; 3], corners), condition(corners));
        let [a, b, c] = corners.map(|corner| exact::unit(wide(corner)));
        let opposite = [(a, b), (b, c), (c, a)].into_iter().filter(|(a, b)| exact::dot(*a, *b) < 0.0);
        let sine = opposite.map(|(a, b)| exact::length(exact::cross(a, b))).fold(1.0, f64::min);
        let error = (f64::from(got) / exact - 1.0) / ((1.0 + condition + 1.0 / sine) * EPS);
        check.value(&format!("{corners:?}: {got:e} for {exact:e}"), error, 0.0);
    }
    check.tight(count);
}

#[test]
fn triangles_without_a_view_are_zero() {
    let (a, b, c) = ([0.3, -0.2, 1.0], [1.3, 0.1, 1.0], [0.4, 0.9, 1.0]);
    let origin = [0.0; 3];
    for corners in [[a, a, a], [a, a, b], [a, b, a], [b, a, a]] {
        assert_eq!(triangle(origin, corners), 0.0, "no area: {corners:?}");
    }
    assert_eq!(triangle(origin, [[1.0, 1.0, 1.0], [2.0, 2.0, 2.0], [4.0, 4.0, 4.0]]), 0.0, "edge-on line");
    for vertex in [a, b, c] {
        assert_eq!(triangle(vertex, [a, b, c]), 0.0, "from a vertex");
    }
    // In its plane, outside and on it.
    assert_eq!(triangle([5.0, 5.0, 1.0], [a, b, c]), 0.0);
    assert_eq!(triangle([0.6, 0.2, 1.0], [a, b, c]), 0.0);
    // A hair above it is half of all directions.
    let above = triangle([0.6, 0.2, 1.0 + 1e-6], [a, b, c]);
    assert!((above - std::f32::consts::TAU).abs() < 1e-4, "{above}");
    assert_eq!(triangle(origin, [origin; 3]), 0.0);
    assert!(triangle([f32::NAN, 0.0, 0.0], [a, b, c]).is_nan());
}

#[test]
fn disks_keep_their_solid_angle_on_and_off_their_axis() {
    let mut on = check("disks, in eps");
    for distance in sweep(1e-6, 1e9, 50_000) {
        compare(&mut on, &format!("{distance} m"), disk(1.0, distance), exact::disk(1.0, distance.into()));
    }
    let mut noise = Noise(13);
    for _ in 0..100_000 {
        let [radius, distance] = [0, 1].map(|_| length(&mut noise));
        let place = format!("{radius} m at {distance} m");
        compare(&mut on, &place, disk(radius, distance), exact::disk(radius.into(), distance.into()));
    }
    on.tight(150_000);

    let mut off = check("disks off their axis");
    for distance in sweep(1e-3, 1e4, 60) {
        for offset in sweep(1e-3, 1e2, 120).chain([0.97, 0.999, 0.99999, 1.0, 1.00001, 1.001, 1.03]) {
            let exact = exact::disk_off_axis(1.0, distance.into(), offset.into());
            off.value(
                &format!("{distance} m away, {offset} m beside"),
                disk_off_axis(1.0, distance, offset).into(),
                exact,
            );
        }
    }
    off.tight_over_all();
    // Half a radius above the disk, from its axis to two radii beside it: the integral by 15 digits
    // elsewhere.
    let table = [
        3.473_259_414_8,
        3.418_442_766_5,
        3.243_542_075_5,
        2.918_516_654_1,
        2.412_246_238_8,
        1.768_723_094_5,
        1.166_141_223_8,
        0.742_891_316_6,
        0.484_128_782_5,
        0.328_701_360_9,
        0.232_419_623_5,
    ];
    for (k, expected) in table.into_iter().enumerate() {
        let got = f64::from(disk_off_axis(1.0, 0.5, 0.2 * k as f32));
        assert!((got / expected - 1.0).abs() < 5e-7, "{got} for {expected}");
    }
    // In its plane, and nothing.
    let tau = std::f32::consts::TAU;
    for (offset, expected) in [(0.0, tau), (0.5, tau), (0.99, tau), (1.0, tau / 2.0), (1.01, 0.0), (7.0, 0.0)]
    {
        assert!((disk_off_axis(1.0, 0.0, offset) - expected).abs() < 1e-6, "{offset}");
    }
    assert_eq!(disk_off_axis(0.0, 0.0, 0.0) + disk_off_axis(0.0, 1.0, 1.0) + disk(0.0, 0.0), 0.0);
}

#[test]
fn rectangles_keep_their_solid_angle() {
    let mut check = check("rectangles, in eps");
    let mut count = 0;
    for width in sweep(1e-5, 1e3, 150) {
        for height in sweep(1e-5, 1e3, 150) {
            let exact = exact::rectangle(width.into(), height.into(), 1.0);
            compare(&mut check, &format!("{width} x {height}"), rectangle(width, height, 1.0), exact);
            count += 1;
        }
    }
    let mut noise = Noise(14);
    for _ in 0..200_000 {
        let [width, height, distance] = [0, 1, 2].map(|_| length(&mut noise));
        let exact = exact::rectangle(width.into(), height.into(), distance.into());
        let place = format!("{width} x {height} at {distance}");
        compare(&mut check, &place, rectangle(width, height, distance), exact);
        count += 1;
    }
    check.tight(count);
    // Two triangles are a rectangle.
    let [p, q, r, s] = [[-1.0, -0.5, 2.0], [1.0, -0.5, 2.0], [1.0, 0.5, 2.0], [-1.0, 0.5, 2.0]];
    let two = triangle([0.0; 3], [p, q, r]) + triangle([0.0; 3], [p, r, s]);
    assert!((two / rectangle(2.0, 1.0, 2.0) - 1.0).abs() < 3e-7, "{two}");
    assert_eq!((rectangle(0.0, 0.0, 0.0), rectangle(1.0, 1.0, 0.0)), (0.0, std::f32::consts::TAU));
}

#[test]
fn every_backend_has_the_same_geometry() {
    let corners = [[0.1, 0.2, 1.0], [0.4, -0.1, 1.1], [0.3, 0.5, 0.9]];
    let (portable, fast) = (triangle([0.0; 3], corners), triangle_with::<Fast>([0.0; 3], corners));
    assert_eq!(portable, triangle_with::<Portable>([0.0; 3], corners));
    assert!((portable / fast - 1.0).abs() < 3e-7, "{portable} {fast}");
}

#[test]
fn disks_and_spheres_keep_their_form_factor_from_a_point() {
    let mut disks = check("form factor to disks");
    for distance in sweep(1e-2, 1e3, 100) {
        for offset in sweep(1e-2, 1e2, 100).chain([0.99, 1.0, 1.01]) {
            let exact = exact::to_disk(1.0, distance.into(), offset.into());
            if exact > 1e-7 {
                let place = format!("{distance} m away, {offset} m beside");
                disks.value(&place, to_disk(1.0, distance, offset).into(), exact);
            }
        }
    }
    disks.tight_over_more_than(5000);
    assert_eq!((to_disk(1.0, 0.0, 0.5), to_disk(1.0, 0.0, 1.0), to_disk(1.0, 0.0, 2.0)), (1.0, 0.5, 0.0));

    let (mut up, mut down) = (check("form factor to spheres"), check("form factor to setting spheres"));
    let nodes = gauss(60);
    let (mut ups, mut downs) = (0, 0);
    for distance in [1.0f32, 1.001, 1.1, 1.5, 2.0, 5.0, 20.0, 215.0, 1e4] {
        // The whole range, and finely about the horizon.
        let (sin, angles) = (1.0 / distance, 400);
        for k in 0..=angles {
            let x = 2.0 * k as f32 / angles as f32 - 1.0;
            for cos in [x, sin * x] {
                let exact = exact::to_sphere(&nodes, 1.0, distance.into(), cos.into());
                let (got, place) = (to_sphere(1.0, distance, cos), format!("{distance} m away, cos {cos}"));
                if cos >= 0.0 {
                    up.value(&place, got.into(), exact);
                    ups += 1;
                } else {
                    // In units of the whole sphere's.
                    let whole = f64::from(sin * sin);
                    down.value(&place, f64::from(got) / whole, exact / whole);
                    downs += 1;
                }
            }
        }
    }
    up.tight(ups);
    down.tight(downs);
}

#[test]
fn sources_light_a_point_as_their_form_factors_say() {
    let mut noise = Noise(4);
    let nodes = gauss(60);
    let mut points = check("irradiance of points, of that at normal incidence, in eps");
    let mut spheres = check("irradiance of spheres, of that at normal incidence");
    let mut disks = check("irradiance of disks");
    for k in 0..20_000 {
        let (place, normal, to) = (noise.point(), noise.point(), noise.point());
        let way = exact::minus(wide(to), wide(place));
        let (distance, cos) = (exact::length(way), exact::dot(exact::unit(way), exact::unit(wide(normal))));
        let at = format!("{k}: {place:?} {normal:?} {to:?}");
        let lamp = PointSource { position_m: to, intensity: Candela::from(1000.0) };
        let all = 1000.0 / (distance * distance);
        let got = f64::from(lamp.irradiance(place, normal).value().0);
        points.value(&at, got / (all * EPS), cos.max(0.0) / EPS);
        let radius_m = (0.01 + 0.9 * f64::from(k) / 20_000.0) * distance;
        let globe = SphereSource { position_m: to, radius_m: radius_m as f32, radiance: Nit::from(1000.0) };
        let radius = f64::from(globe.radius_m);
        let got = f64::from(globe.irradiance(place, normal).value().0) / (1000.0 * PI);
        let whole = (radius / distance).powi(2);
        spheres.value(&at, got / whole, exact::to_sphere(&nodes, radius, distance, cos) / whole);
        let disk = DiskSource { radius_m: globe.radius_m, radiance: Nit::from(1000.0) };
        let exact = 1000.0 * PI * exact::to_disk(radius, f64::from(to[0].abs()), f64::from(place[0].abs()));
        disks.value(&at, disk.irradiance(to[0].abs(), place[0].abs()).value().0.into(), exact);
    }
    [points, spheres, disks].into_iter().for_each(|check| check.tight(20_000));
}
