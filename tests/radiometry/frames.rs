//! Where a surface lies in the world: axes at right angles for every normal, and the way there and back.

use model::allowed::check;
use model::noise::Noise;
use nanospectra::geometry::{Direction, Frame};
use nanospectra::matter::{Brdf, Conductor, Microfacet, TrowbridgeReitz};
use nanospectra::radiometry::{Intensity, PointSource, Radiant, SurfaceElement};

/// Normals of all kinds: random, at the poles and beside them, on the seam, huge and tiny.
fn normals() -> Vec<[f32; 3]> {
    let mut random = Noise(5);
    let mut normals: Vec<[f32; 3]> = (0..20_000).map(|_| random.point()).collect();
    for step in 0..=37 {
        let tilt = 10f32.powi(-step);
        for z in [1.0, -1.0, tilt, -tilt] {
            normals.extend([[tilt, 0.0, z], [0.0, -tilt, z], [tilt, 0.7 * tilt, z], [0.3, 1.0, tilt * z]]);
        }
        normals.push([0.2 * tilt, -0.6 * tilt, 0.4 * tilt]);
    }
    for k in 0..3 {
        for size in [1.0, -1.0, f32::MAX, -1e-45] {
            let mut axis = [0.0; 3];
            axis[k] = size;
            normals.push(axis);
            normals.push(axis.map(|x| if x == 0.0 { -0.0 } else { x }));
        }
    }
    normals
}

fn dot(a: [f32; 3], b: [f32; 3]) -> f64 {
    a.into_iter().zip(b).map(|(a, b)| f64::from(a) * f64::from(b)).sum()
}

fn unit(a: [f32; 3]) -> [f64; 3] {
    let a = a.map(f64::from);
    let length = a.iter().map(|x| x * x).sum::<f64>().sqrt();
    a.map(|x| x / length)
}

fn determinant([[a, b, c], y, z]: [[f32; 3]; 3]) -> f64 {
    let minor = |i: usize, j: usize| f64::from(y[i]) * f64::from(z[j]) - f64::from(y[j]) * f64::from(z[i]);
    f64::from(a) * minor(1, 2) - f64::from(b) * minor(0, 2) + f64::from(c) * minor(0, 1)
}

#[test]
fn axes_are_of_length_one_and_at_right_angles() {
    let (mut angles, mut lengths, mut along) =
        (check("right angles of frames"), check("lengths of axes"), check("normals of frames"));
    let (mut random, mut frames) = (Noise(7), 0);
    for normal in normals() {
        let tangent = random.point();
        let both = [Frame::from_normal(normal), Frame::with_tangent(normal, tangent)];
        for (name, frame) in ["normal", "tangent"].into_iter().zip(both) {
            let axes @ [x, y, z] = frame.unwrap_or_else(|| panic!("no frame by {name}: {normal:?}")).axes();
            let place = format!("{name} {normal:?}");
            for (a, b) in [(x, y), (y, z), (z, x)] {
                angles.value(&place, dot(a, b), 0.0);
            }
            for axis in axes {
                lengths.value(&place, dot(axis, axis).sqrt(), 1.0);
            }
            for (got, exact) in z.into_iter().zip(unit(normal)) {
                along.value(&place, f64::from(got), exact);
            }
            assert!((determinant(axes) - 1.0).abs() < 6e-7, "left-handed: {place}");
            frames += 1;
        }
        let [x, y, _] = both[1].map(Frame::axes).expect("seen above");
        assert!(dot(x, tangent) > 0.0 && dot(y, tangent).abs() < 4e-7, "{normal:?}, {tangent:?}");
    }
    angles.tight(3 * frames);
    lengths.tight(3 * frames);
    along.tight(3 * frames);
}

#[test]
fn directions_come_back_from_the_world() {
    let (mut there, mut compared, mut random) = (check("directions by way of the world"), 0, Noise(9));
    for normal in normals() {
        let (frame, w) = (Frame::from_normal(normal).expect("a frame"), random.point());
        let w = Direction::from_vector(w).expect("a direction");
        let back = frame.to_local(frame.to_world(w)).expect("a direction");
        for (got, exact) in back.to_array().into_iter().zip(w.to_array()) {
            there.value(&format!("{normal:?}"), f64::from(got), f64::from(exact));
        }
        compared += 3;
        let [zenith, n] = [frame.to_world(Direction::NORMAL), frame.axes()[2]];
        assert_eq!(zenith, n);
    }
    there.tight(compared);
}

#[test]
fn one_normal_has_one_frame_whatever_its_length_and_signs_of_zero() {
    for [x, y] in [[0.6, 0.8], [-1.0, 0.0], [0.0, 1.0]] {
        let frames = [0.0, -0.0].map(|z| Frame::from_normal([x, y, z]));
        assert_eq!(frames[0], frames[1], "{x} {y}");
    }
    let [x, y, z] = [0.25, -0.5, 0.75];
    let one = Frame::from_normal([x, y, z]);
    for k in [2f32.powi(-100), 0.5, 2f32.powi(100)] {
        assert_eq!(Frame::from_normal([x * k, y * k, z * k]), one, "{k}");
    }
    // Straight up the frame is the world's own, straight down with y turned.
    let axes = |z| Frame::from_normal([0.0, 0.0, z]).map(Frame::axes);
    assert_eq!(axes(1.0), Some([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]));
    assert_eq!(axes(-1.0), Some([[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]]));
}

#[test]
fn what_is_no_frame_or_direction_is_none() {
    let (up, frame) = ([0.0, 0.0, 1.0], Frame::from_normal([0.1, 0.2, 0.3]).expect("a frame"));
    for bad in [[0.0, -0.0, 0.0], [f32::NAN, 0.0, 1.0], [0.0, f32::INFINITY, 1.0]] {
        assert_eq!(Frame::from_normal(bad), None);
        assert_eq!(Frame::with_tangent(bad, up), None);
        assert_eq!(Frame::with_tangent(up, bad), None);
        assert_eq!(frame.to_local(bad), None);
    }
    assert_eq!(Frame::with_tangent(up, [0.0, 0.0, -2.0]), None);
    assert_eq!(Frame::with_tangent(up, [1e-7, 0.0, 1.0]), None);
    assert!(
        Frame::with_tangent(up, [1e-3, 0.0, 1.0]).is_some_and(|frame| frame.axes()[0] == [1.0, 0.0, 0.0])
    );
    assert_eq!(frame.towards([1.0, 2.0, 3.0], [1.0, 2.0, 3.0]), None);
    for size in [1e-45f32, 1e-30, 1.0, 1e30, f32::MAX] {
        assert!(frame.to_local([0.0, size, 0.0]).is_some_and(|w| (w.sin_theta() - 0.845_154_3).abs() < 3e-7));
        assert!(frame.towards([0.0, -size, 0.0], [0.0, size, 0.0]).is_some(), "{size}");
    }
}

#[test]
fn cosines_are_those_of_the_sources() {
    let (point_m, normal) = ([0.3, -0.2, 0.7], [0.5, 0.1, 0.9]);
    let frame = Frame::from_normal(normal).expect("a frame");
    let mut random = Noise(11);
    let mut lit = 0;
    for _ in 0..1000 {
        let position_m = random.point().map(|x| 4.0 * x);
        let lamp = PointSource { position_m, intensity: Intensity::new(Radiant(3.0)) };
        let wi = frame.towards(point_m, position_m).expect("a direction");
        let squared: f32 = position_m.into_iter().zip(point_m).map(|(a, b)| (a - b) * (a - b)).sum();
        let by_frame = lamp.intensity.at_distance(squared.sqrt(), wi.cos_theta()).value().0;
        let got = lamp.irradiance(point_m, normal).value().0;
        assert!((got - by_frame).abs() <= 1e-6 * 3.0 / squared, "{position_m:?}: {got} {by_frame}");
        let (towards, _) = SurfaceElement { position_m, normal, area_m2: 1.0 }.seen_from(point_m);
        let by_element = frame.to_local(towards).expect("a direction");
        assert!(by_element.dot(wi) > 1.0 - 4e-7);
        lit += usize::from(got > 0.0);
    }
    assert!((300..700).contains(&lit), "{lit}");
}

#[test]
fn a_mirror_in_the_world_sends_light_where_it_should() {
    // A lamp and a camera on either side of a leaning mirror: only the halfway normal shows the lamp.
    let (lamp, camera) = ([2.0, 1.0, 2.0], [-2.0, 1.0, 2.0]);
    let polished = Microfacet { facets: TrowbridgeReitz::new(0.05), boundary: Conductor::new(0.2, 3.0) };
    let seen = |normal| {
        let frame = Frame::from_normal(normal).expect("a frame");
        let [wo, wi] = [camera, lamp].map(|at| frame.towards([0.0; 3], at).expect("a direction"));
        polished.f(wo, wi)
    };
    let (right, wrong) = (seen([0.0, 1.0, 2.0]), seen([0.0, 1.4, 2.0]));
    assert!(right > 40.0 && wrong < 0.05 * right, "{right} {wrong}");
}
