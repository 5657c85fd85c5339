//! What holds for every geometry: on points, sizes and tilts that nobody chose.
#![cfg(feature = "libm")]

use nanospectra::math::sqrt;
use nanospectra::radiometry::form_factor::{
    coaxial_disks, parallel_rectangles, perpendicular_rectangles, reciprocal, to_disk, to_polygon, to_sphere,
};
use nanospectra::radiometry::solid_angle::{cone, disk, disk_off_axis, rectangle, sphere, triangle};
use nanospectra::radiometry::{
    Candela, Energy, Exitance, Lumen, Luminous, Lux, Nit, PointSource, RectangleSource, SphereSource,
    SurfaceElement, SurfaceRadiance,
};
use proptest::prelude::*;

/// Any finite f32 at all: tiny, huge, negative; and often 0, 1, or the largest.
fn wild() -> impl Strategy<Value = f32> {
    use prop::num::f32::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    prop_oneof![
        4 => POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO,
        4 => -2.0f32..2.0,
        1 => prop::sample::select(vec![0.0, -0.0, 1.0, -1.0, f32::MAX, f32::MIN, f32::MIN_POSITIVE, 1e-45]),
    ]
}

fn size() -> impl Strategy<Value = f32> {
    (-3.0f32..3.0).prop_map(|exponent| 10f32.powf(exponent))
}

fn point() -> impl Strategy<Value = [f32; 3]> {
    prop::array::uniform3(-1.0f32..1.0)
}

fn near(a: f32, b: f32, share: f32) -> Result<(), TestCaseError> {
    prop_assert!((a - b).abs() <= share * b.abs(), "{a:e} and {b:e} differ by {:e}", a / b - 1.0);
    Ok(())
}

/// Everything that takes lengths, positions and cosines, of these numbers.
fn everything([a, b, c]: [f32; 3], points: [[f32; 3]; 5]) -> Vec<(&'static str, f32)> {
    let [p, q, r, s, n] = points;
    let piece = SurfaceElement { position_m: p, normal: n, area_m2: a.abs() };
    let (direction, dw) = piece.seen_from(q);
    let point = PointSource { position_m: p, intensity: Candela::from(b) };
    let globe = SphereSource { position_m: p, radius_m: a, radiance: Nit::from(b) };
    let panel = RectangleSource { corner_m: p, edges_m: [r, s], radiance: Nit::from(b) };
    let side = SurfaceRadiance::free_space(n, |w: [f32; 3]| Nit::from(w[0]));
    let lux = |e: Lux| e.value().0;
    vec![
        ("cone", cone(a)),
        ("sphere", sphere(a, b)),
        ("disk", disk(a, b)),
        ("disk off axis", disk_off_axis(a, b, c)),
        ("rectangle", rectangle(a, b, c)),
        ("triangle", triangle(p, [q, r, s])),
        ("coaxial disks", coaxial_disks(a, b, c)),
        ("parallel rectangles", parallel_rectangles(a, b, c)),
        ("perpendicular rectangles", perpendicular_rectangles(a, b, c)),
        ("to disk", to_disk(a, b, c)),
        ("to sphere", to_sphere(a, b, c)),
        ("to triangle", to_polygon(p, n, &[q, r, s])),
        ("to polygon", to_polygon(p, n, &[q, r, s, [a, b, c]])),
        ("reciprocal", reciprocal(a, b, c)),
        ("element", direction[0] + direction[1] + direction[2] + dw),
        ("point source", lux(point.irradiance(q, n))),
        ("sphere source", lux(globe.irradiance(q, n))),
        ("rectangle source", lux(panel.irradiance(q, n))),
        ("incident", side.incident(q).value().0),
        ("at distance", lux(Candela::from(a).at_distance(b, c))),
        ("intensity to radiance", Candela::from(a).radiance(b, c).value().0),
        ("irradiance to radiance", Lux::from(a).radiance(b, c).value().0),
        ("radiance to irradiance", lux(Nit::from(a).irradiance(b, c))),
        ("radiance to intensity", Nit::from(a).intensity(b, c).value().0),
        ("through form factor", lux(Nit::from(a).through_form_factor(b))),
        ("per area", lux(Lumen::from(a).irradiance(b)) + Lumen::from(a).exitance(b).value().0 * 0.0),
        ("per solid angle", Lumen::from(a).intensity(b).flux(c).value().0),
        ("mean flux", Energy::new(Luminous(a)).over(b).during(c).value().0),
        ("Lambert", Exitance::new(Luminous(a)).lambertian().exitance().value().0),
    ]
}

#[test]
fn nan_in_any_argument_stays_nan() {
    type Of3 = fn(f32, f32, f32) -> f32;
    let (up, triangle_of) = ([0.0, 0.0, 1.0], [[1.0, 0.0, 1.0], [0.0, 1.0, 1.0], [0.0, 0.0, 1.0]]);
    // How many numbers it takes, and from them.
    let functions: [(&str, usize, Of3); 20] = [
        ("cone", 1, |a, _, _| cone(a)),
        ("sphere", 2, |a, b, _| sphere(a, b)),
        ("disk", 2, |a, b, _| disk(a, b)),
        ("disk off axis", 3, disk_off_axis),
        ("rectangle", 3, rectangle),
        ("coaxial disks", 3, coaxial_disks),
        ("parallel rectangles", 3, parallel_rectangles),
        ("perpendicular rectangles", 3, perpendicular_rectangles),
        ("to disk", 3, to_disk),
        ("to sphere", 3, to_sphere),
        ("reciprocal", 3, reciprocal),
        ("at distance", 3, |a, b, c| Candela::from(a).at_distance(b, c).value().0),
        ("intensity to radiance", 3, |a, b, c| Candela::from(a).radiance(b, c).value().0),
        ("irradiance to radiance", 3, |a, b, c| Lux::from(a).radiance(b, c).value().0),
        ("radiance to irradiance", 3, |a, b, c| Nit::from(a).irradiance(b, c).value().0),
        ("radiance to intensity", 3, |a, b, c| Nit::from(a).intensity(b, c).value().0),
        ("through form factor", 2, |a, b, _| Nit::from(a).through_form_factor(b).value().0),
        ("flux to irradiance", 2, |a, b, _| Lumen::from(a).irradiance(b).value().0),
        ("energy to flux", 2, |a, b, _| Energy::new(Luminous(a)).over(b).value().0),
        ("element", 1, |a, _, _| {
            SurfaceElement { position_m: [0.0; 3], normal: [0.0, 0.0, 1.0], area_m2: a }.seen_from([1.0; 3]).1
        }),
    ];
    // Beside NaN small, equal and no sizes, where results are decided and not computed.
    for (what, arguments, f) in functions {
        for others in [[1.0f32, 2.0, 0.5], [2.0, 1.0, 0.5], [1.0, 1.0, 1.0], [1.0, 0.0, 0.5], [0.0, 1.0, 1.0]]
        {
            for k in 0..arguments {
                let mut numbers = others;
                numbers[k] = f32::NAN;
                let [a, b, c] = numbers;
                assert!(f(a, b, c).is_nan(), "{what} of {numbers:?}");
            }
        }
    }
    for k in 0..3 {
        let nan = |mut point: [f32; 3]| {
            point[k] = f32::NAN;
            point
        };
        let [p, q, r] = triangle_of;
        assert!(triangle(nan([0.0; 3]), triangle_of).is_nan() && triangle([0.0; 3], [p, nan(q), r]).is_nan());
        for [from, normal] in [[nan([0.0; 3]), up], [[0.0; 3], nan(up)]] {
            assert!(to_polygon(from, normal, &triangle_of).is_nan());
            let point = PointSource { position_m: p, intensity: Candela::from(1.0) };
            let globe = SphereSource { position_m: p, radius_m: 0.1, radiance: Nit::from(1.0) };
            let panel = RectangleSource { corner_m: p, edges_m: [q, r], radiance: Nit::from(1.0) };
            let all = [
                point.irradiance(from, normal),
                globe.irradiance(from, normal),
                panel.irradiance(from, normal),
            ];
            assert!(all.iter().all(|lux| lux.value().0.is_nan()), "{all:?}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: if cfg!(debug_assertions) { 5_000 } else { 100_000 },
        ..ProptestConfig::default()
    })]

    #[test]
    fn finite_numbers_never_give_nan(
        numbers in prop::array::uniform3(wild()),
        points in prop::array::uniform5(prop::array::uniform3(wild())),
    ) {
        for (what, value) in everything(numbers, points) {
            prop_assert!(!value.is_nan(), "{what} of {numbers:?} {points:?}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 2_000,
        ..ProptestConfig::default()
    })]

    #[test]
    fn what_one_sends_the_other_the_other_sends_back(r1 in size(), r2 in size(), d in size(), l in size()) {
        near(reciprocal(coaxial_disks(r1, r2, d), r1 * r1, r2 * r2), coaxial_disks(r2, r1, d), 1e-6)?;
        let (there, back) = (perpendicular_rectangles(r1, r2, l), perpendicular_rectangles(r2, r1, l));
        near(reciprocal(there, r1 * l, r2 * l), back, 1e-6)?;
        near(parallel_rectangles(r1, r2, d), parallel_rectangles(r2, r1, d), 1e-6)?;
    }

    #[test]
    fn a_triangle_is_the_sum_of_its_parts(p in point(), q in point(), r in point(), share in 0.1f32..0.9) {
        // Not too near to the observer's own plane, and split on the edge q r as exactly as f32 can.
        let up = |[x, y, z]: [f32; 3]| [x, y, z + 1.5];
        let (p, q, r) = (up(p), up(q), up(r));
        let cut: [f32; 3] = std::array::from_fn(|i| q[i] + share * (r[i] - q[i]));
        let whole = triangle([0.0; 3], [p, q, r]);
        let parts = triangle([0.0; 3], [p, q, cut]) + triangle([0.0; 3], [p, cut, r]);
        prop_assert!((whole - parts).abs() < 3e-6, "{whole} {parts}");
    }

    #[test]
    fn a_sphere_of_directions_is_divided_by_any_tetrahedron(a in point(), b in point(), c in point(), d in point()) {
        // Seen from its middle, the four faces of a tetrahedron are all directions.
        let middle: [f32; 3] = std::array::from_fn(|i| 0.25 * (a[i] + b[i] + c[i] + d[i]));
        let faces = [[a, b, c], [a, b, d], [a, c, d], [b, c, d]];
        let [u, v, w] = [b, c, d].map(|x| -> [f32; 3] { std::array::from_fn(|i| x[i] - a[i]) });
        let volume = u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2])
            + u[2] * (v[0] * w[1] - v[1] * w[0]);
        prop_assume!(volume.abs() > 1e-2);
        let sum: f32 = faces.into_iter().map(|face| triangle(middle, face)).sum();
        near(sum, 4.0 * std::f32::consts::PI, 1e-4)?;
    }

    #[test]
    fn form_factors_are_shares(a in size(), b in size(), c in size(), cos in -1.0f32..1.0) {
        let shares = [
            coaxial_disks(a, b, c), parallel_rectangles(a, b, c), perpendicular_rectangles(a, b, c), to_disk(a, b, c),
            to_sphere(a, b, cos),
        ];
        for share in shares {
            prop_assert!((0.0..=1.0 + 2e-6).contains(&share), "{share}: {a} {b} {c} {cos}");
        }
    }

    #[test]
    fn only_proportions_count(
        a in size(), b in size(), c in size(), points in prop::array::uniform5(point()), doublings in -60..=60,
    ) {
        // A power of two changes no digit.
        let k = 2f32.powi(doublings);
        let [p, q, r, s, n] = points;
        let scaled = |x: [f32; 3]| x.map(|x| x * k);
        prop_assert_eq!(sphere(a, b), sphere(a * k, b * k));
        prop_assert_eq!(disk(a, b), disk(a * k, b * k));
        prop_assert_eq!(disk_off_axis(a, b, c), disk_off_axis(a * k, b * k, c * k));
        prop_assert_eq!(rectangle(a, b, c), rectangle(a * k, b * k, c * k));
        prop_assert_eq!(coaxial_disks(a, b, c), coaxial_disks(a * k, b * k, c * k));
        prop_assert_eq!(to_disk(a, b, c), to_disk(a * k, b * k, c * k));
        prop_assert_eq!(parallel_rectangles(a, b, c), parallel_rectangles(a * k, b * k, c * k));
        prop_assert_eq!(perpendicular_rectangles(a, b, c), perpendicular_rectangles(a * k, b * k, c * k));
        prop_assert_eq!(triangle(p, [q, r, s]), triangle(scaled(p), [q, r, s].map(scaled)));
        prop_assert_eq!(to_polygon(p, n, &[q, r, s]), to_polygon(scaled(p), scaled(n), &[q, r, s].map(scaled)));
        let piece = |k: f32| SurfaceElement { position_m: q.map(|x| x * k), normal: n, area_m2: a * k * k };
        // (An area is a square: half the exponents.)
        let k = 2f32.powi(doublings / 2);
        prop_assert_eq!(piece(1.0).seen_from(p), piece(k).seen_from(p.map(|x| x * k)));
    }

    #[test]
    fn twice_the_distance_is_a_quarter_of_the_light(p in point(), n in point(), distance in size()) {
        let length = sqrt(p.iter().map(|x| x * x).sum());
        prop_assume!(length > 0.1);
        let lamp = |d: f32| PointSource { position_m: p.map(|x| x * d), intensity: Candela::from(100.0) };
        let (one, two) = (lamp(distance).irradiance([0.0; 3], n), lamp(2.0 * distance).irradiance([0.0; 3], n));
        prop_assert_eq!(one, two * 4.0);
    }

    #[test]
    fn a_far_surface_is_a_point(p in point(), r in 1e-3f32..3e-3, cos in 0.1f32..1.0) {
        let length = sqrt(p.iter().map(|x| x * x).sum());
        prop_assume!(length > 0.5);
        let area = std::f32::consts::PI * r * r;
        let small = 0.5 * (r / length) * (r / length) * 3.0;
        near(sphere(r, length), area / (length * length), small + 1e-6)?;
        near(disk(r, length), area / (length * length), small + 1e-6)?;
        near(to_sphere(r, length, cos) * std::f32::consts::PI, cos * sphere(r, length), small + 1e-6)?;
    }
}
