//! Every public function of `radiometry`, on numbers of any bits: none panics, finite numbers give a number,
//! and solid angles and form factors stay within what geometry allows.
#![cfg(feature = "libm")]

use nanospectra::math::{Fast, Portable};
use nanospectra::observer::{V_PHOTOPIC, V_SCOTOPIC};
use nanospectra::radiometry::form_factor::*;
use nanospectra::radiometry::solid_angle::*;
use nanospectra::radiometry::*;
use nanospectra::{Fine, Power};
use proptest::prelude::*;
use std::f32::consts::PI;

/// Numbers of any bits, and often of a size that is in use, or an edge.
fn bits() -> impl Strategy<Value = f32> {
    let edges =
        vec![0.0, -0.0, 1.0, -1.0, f32::MAX, f32::MIN, f32::MIN_POSITIVE, 1e-45, f32::INFINITY, f32::NAN];
    prop_oneof![4 => any::<u32>().prop_map(f32::from_bits), 4 => -2.0f32..2.0, 1 => prop::sample::select(edges)]
}

fn point() -> impl Strategy<Value = [f32; 3]> {
    prop::array::uniform3(bits())
}

/// How often each test draws: 2,000 times, or as NANOSPECTRA_RUNS says.
fn runs() -> ProptestConfig {
    let runs = std::env::var("NANOSPECTRA_RUNS").ok().and_then(|runs| runs.parse().ok());
    ProptestConfig { cases: runs.unwrap_or(2_000), ..ProptestConfig::default() }
}

/// Fails for what is outside of `low..=high`, or NaN of finite numbers.
fn within(what: &str, value: f32, [low, high]: [f32; 2], finite: bool) -> Result<(), TestCaseError> {
    prop_assert!(!finite || !value.is_nan(), "{what} is NaN");
    prop_assert!(value.is_nan() || (low..=high).contains(&value), "{what} is {value:e}");
    Ok(())
}

proptest! {
    #![proptest_config(runs())]

    #[test]
    fn solid_angles_and_form_factors_of_any_bits(
        [a, b, c] in point(), p in point(), corners in prop::array::uniform4(point()), normal in point(),
    ) {
        let [q, r, s, t] = corners;
        let cos = c.clamp(-1.0, 1.0);
        let finite = [[a, b, c], p, q, r, s, t, normal].iter().flatten().all(|number| number.is_finite());
        let sphere_of = 4.0 * PI * 1.000_001;
        let angles = [
            ("cone", cone(a)), ("sphere", sphere(a, b)), ("disk", disk(a, b)),
            ("disk off axis", disk_off_axis(a, b, c)), ("rectangle", rectangle(a, b, c)),
            ("rectangle", rectangle_with::<Fast>(a, b, c)),
        ];
        for (what, angle) in angles {
            within(what, angle, [0.0, sphere_of], finite)?;
        }
        for angle in [triangle(p, [q, r, s]), triangle_with::<Portable>(p, [q, r, s])] {
            within("triangle", angle, [-sphere_of, sphere_of], finite)?;
        }
        let factors = [
            ("coaxial disks", coaxial_disks(a, b, c)), ("to disk", to_disk(a, b, c)), ("to sphere", to_sphere(a, b, cos)),
            ("to sphere", to_sphere_with::<Fast>(a, b, cos)), ("parallel", parallel_rectangles(a, b, c)),
            ("parallel", parallel_rectangles_with::<Fast>(a, b, c)),
            ("perpendicular", perpendicular_rectangles(a, b, c)),
            ("perpendicular", perpendicular_rectangles_with::<Fast>(a, b, c)),
            ("to polygon", to_polygon(p, normal, &[q, r, s])), ("to polygon", to_polygon(p, normal, &[])),
            ("to polygon", to_polygon_with::<Fast>(p, normal, &[q, r, s, t])),
        ];
        for (what, factor) in factors {
            let most = if what == "to polygon" { 1.0 } else { 1.000_001 };
            within(what, factor, [0.0, most], finite)?;
        }
        within("reciprocal", reciprocal(a, b, c), [f32::NEG_INFINITY, f32::INFINITY], finite)?;
    }

    #[test]
    fn sources_and_relations_of_any_bits([a, b, c] in point(), corners in prop::array::uniform4(point()), n in point()) {
        let [p, q, r, s] = corners;
        let finite = [[a, b, c], p, q, r, s, n].iter().flatten().all(|number| number.is_finite());
        let (direction, angle) = SurfaceElement { position_m: p, normal: n, area_m2: a }.seen_from(q);
        let point = PointSource { position_m: p, intensity: Candela::from(b) };
        let globe = SphereSource { position_m: p, radius_m: a, radiance: Nit::from(b) };
        let disk = DiskSource { radius_m: a, radiance: Nit::from(b) };
        let panel = RectangleSource { corner_m: p, edges_m: [r, s], radiance: Nit::from(b) };
        let side = SurfaceRadiance::free_space(n, |w: [f32; 3]| Nit::from(w[0]));
        let numbers = [
            angle, direction[0], direction[1], direction[2], point.irradiance(q, n).value().0,
            globe.irradiance(q, n).value().0, globe.irradiance_with::<Fast>(q, n).value().0,
            disk.irradiance(a, c).value().0, panel.irradiance(q, n).value().0,
            panel.irradiance_with::<Fast>(q, n).value().0, side.incident(q).value().0, side.exitant(q).value().0,
            Energy::new(Luminous(a)).over(b).during(c).value().0, Lumen::from(a).irradiance(b).flux(c).value().0,
            Lumen::from(a).exitance(b).flux(c).value().0, Lumen::from(a).intensity(b).flux(c).value().0,
            Candela::from(a).at_distance(b, c).value().0, Candela::from(a).radiance(b, c).value().0,
            Lux::from(a).radiance(b, c).value().0, Lux::from(a).as_exitance().lambertian().exitance().value().0,
            Nit::from(a).irradiance(b, c).value().0, Nit::from(a).through_form_factor(b).value().0,
            Nit::from(a).intensity(b, c).value().0,
        ];
        for (k, number) in numbers.into_iter().enumerate() {
            within(&format!("number {k}"), number, [f32::NEG_INFINITY, f32::INFINITY], finite)?;
        }
    }

    #[test]
    fn lights_of_any_bits(knots in prop::array::uniform16(bits()), start in 0usize..456) {
        let mut values = [1.0f32; 471];
        values[start..start + knots.len()].copy_from_slice(&knots);
        let light = Fine::<Power>::from_bins(values);
        let _ = (illuminance(&light), scotopic_illuminance(&light), ppfd(&light), AlphaOpic::new(&light).edi().to_array());
        // A ratio of what is seen is a number, whatever the light.
        for share in [luminous_efficacy(&light), AlphaOpic::der(&light).map(|der| der.melanopic)] {
            prop_assert!(knots.iter().any(|knot| knot.abs() > 1e30 || knot.is_nan()) || share.is_none_or(|share| share.is_finite()));
        }
        let lit = Irradiance::new(light);
        let _ = (lit.radiant().value().0, lit.luminous_by(&V_PHOTOPIC).value().0, lit.scotopic_by(&V_SCOTOPIC).value().0);
        let _ = (lit.luminous().value().0, lit.scotopic().value().0);
    }
}
