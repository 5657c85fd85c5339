//! That the documented bounds hold at the worst directions, sizes and places that a search finds, and that
//! the rules of the hemisphere add up.
#![cfg(feature = "libm")]

use model::geometry as exact;
use model::search::{Range::*, units, worst};
use nanospectra::geometry::{Cosine, Direction, Frame, GaussLegendre, Hemisphere, Uniform};
use nanospectra::radiometry::form_factor::{
    coaxial_disks, parallel_rectangles, perpendicular_rectangles, to_disk, to_sphere,
};
use nanospectra::radiometry::solid_angle::{cone, disk, disk_off_axis, rectangle, sphere};
use nanospectra::radiometry::{Candela, DiskSource, Nit, PointSource, SphereSource};
use std::f64::consts::{PI, TAU};

const STEPS: usize = 2000;

fn relative(got: f32, exact: f64) -> f64 {
    ((f64::from(got) - exact) / exact).abs()
}

/// The largest error of a component.
fn apart(got: [f32; 3], exact: [f64; 3]) -> f64 {
    got.into_iter().zip(exact).map(|(got, exact)| (f64::from(got) - exact).abs()).fold(0.0, f64::max)
}

/// What a rule makes of the solid angle, the projected solid angle, and the powers of the cosine.
fn sums(rule: &impl Hemisphere, what: &str, exact_up_to: i32) {
    let sum = |f: fn(f64, f64, f64) -> f64| {
        rule.nodes()
            .map(|node| {
                f(node.solid_angle_sr.into(), node.projected_sr.into(), node.direction.cos_theta().into())
            })
            .sum::<f64>()
    };
    let (all, projected) = (sum(|all, _, _| all), sum(|_, projected, _| projected));
    assert!((all / TAU - 1.0).abs() < 4e-7, "{what}: all solid angles are {all}");
    assert!((projected / PI - 1.0).abs() < 4e-7, "{what}: all projected solid angles are {projected}");
    for power in 0..=exact_up_to {
        let moment: f64 = rule
            .nodes()
            .map(|node| f64::from(node.solid_angle_sr) * f64::from(node.direction.cos_theta()).powi(power))
            .sum();
        let exact = TAU / f64::from(power + 1);
        assert!((moment / exact - 1.0).abs() < 1e-6, "{what}: power {power} is {moment} for {exact}");
    }
}

/// The sums of the midpoint rules are exact, and Gauss's are exact for polynomials up to the degree 2 MU - 1.
#[test]
fn every_rule_covers_the_hemisphere_once() {
    sums(&Uniform::<1, 1>, "uniform 1", 1);
    sums(&Uniform::<7, 3>, "uniform 7", 1);
    sums(&Uniform::<64, 5>, "uniform 64", 1);
    sums(&Cosine::<1, 1>, "cosine 1", 0);
    sums(&Cosine::<8, 8>, "cosine 8", 0);
    sums(&Cosine::<16, 16>, "cosine 16", 0);
    sums(&Cosine::<64, 64>, "cosine 64", 0);
    sums(&Cosine::<1000, 1>, "cosine 1000", 0);
    sums(&GaussLegendre::<1, 1>, "Gauss 1", 1);
    sums(&GaussLegendre::<2, 3>, "Gauss 2", 3);
    sums(&GaussLegendre::<8, 8>, "Gauss 8", 15);
    sums(&GaussLegendre::<32, 32>, "Gauss 32", 63);
    // Each piece of the cosine's rule lies between the circles of latitude that its node is between.
    for (ring, node) in Cosine::<8, 1>.nodes().enumerate() {
        let [low, high] = [ring, ring + 1].map(|k| (k as f64 / 8.0).sqrt());
        assert!(relative(node.solid_angle_sr, TAU * (high - low)) < 3e-7, "{ring}: {node:?}");
        assert!((low..high).contains(&f64::from(node.direction.cos_theta())), "{ring}: {node:?}");
    }
}

#[test]
fn directions_are_as_exact_as_promised() {
    let (half_turn, turn) = (std::f32::consts::PI, std::f32::consts::TAU);
    let spherical = |theta: f32, phi: f32| {
        let (t, p) = (f64::from(theta), f64::from(phi));
        (Direction::spherical(theta, phi), [t.sin() * p.cos(), t.sin() * p.sin(), t.cos()])
    };
    worst(1, STEPS, [Even(0.0, half_turn), Even(0.0, turn)], |[theta, phi]| {
        let (got, exact) = spherical(theta, phi);
        apart(got.to_array(), exact)
    })
    .is_what_is_promised("directions of two angles", 6e-7);
    worst(2, STEPS, [Sizes(1e-12, 1.5), Even(0.0, turn)], |[theta, phi]| {
        let (got, [x, y, _]) = spherical(theta, phi);
        apart([got.x(), got.y(), 0.0], [x, y, 0.0]) / f64::from(theta).sin()
    })
    .is_what_is_promised("the same near the zenith, over the sine", 6e-7);
    let parts = |theta: f32, phi: f32| {
        let direction = Direction::spherical(theta, phi);
        (direction, direction.to_array().map(f64::from))
    };
    worst(3, STEPS, [Sizes(1e-12, 3.1), Even(0.0, turn)], |[theta, phi]| {
        let (got, [x, y, z]) = parts(theta, phi);
        relative(got.theta_rad(), x.hypot(y).atan2(z))
    })
    .is_what_is_promised("zenith angles", 2.5e-7);
    worst(4, STEPS, [Sizes(1e-3, 3.1), Even(0.0, 6.2)], |[theta, phi]| {
        let (got, [x, y, _]) = parts(theta, phi);
        let exact = y.atan2(x).rem_euclid(TAU);
        if exact == 0.0 { -1.0 } else { relative(got.phi_rad(), exact) }
    })
    .is_what_is_promised("azimuths", 1.4e-7);
    worst(5, STEPS, [Even(0.0, 1.57), Even(0.0, turn), Sizes(0.1, 10.0)], |[theta, phi, eta]| {
        let (got, [x, y, _]) = parts(theta, phi);
        let eta64 = f64::from(eta);
        let sine = x.hypot(y) / eta64;
        if sine > std::f64::consts::FRAC_1_SQRT_2 {
            return -1.0;
        }
        let refracted = got.refracted(eta).expect("far from the critical angle");
        apart(refracted.to_array(), [-x / eta64, -y / eta64, -(1.0 - sine * sine).sqrt()])
    })
    .is_what_is_promised("refracted directions", 7e-7);
}

#[test]
fn frames_are_as_exact_as_promised() {
    let skew = |frame: Frame| {
        let axes = frame.axes().map(exact::wide);
        let pairs = (0..3).flat_map(|i| (0..3).map(move |j| (i, j)));
        pairs
            .map(|(i, j)| match exact::dot(axes[i], axes[j]) {
                _ if i == j => (exact::length(axes[i]) - 1.0).abs(),
                dot => dot.abs(),
            })
            .fold(0.0, f64::max)
    };
    worst(1, STEPS, [Even(-1.0, 1.0); 3], |normal| Frame::from_normal(normal).map_or(-1.0, skew))
        .is_what_is_promised("axes of a normal", 2e-7);
    worst(2, STEPS, [Even(-1.0, 1.0); 6], |[a, b, c, d, e, f]| {
        Frame::with_tangent([a, b, c], [d, e, f]).map_or(-1.0, skew)
    })
    .is_what_is_promised("axes of a normal and a tangent", 2e-7);
    worst(3, STEPS, [Even(-1.0, 1.0); 6], |[a, b, c, d, e, f]| {
        let vector = exact::wide([d, e, f]);
        match Frame::from_normal([a, b, c]).and_then(|frame| Some((frame, frame.to_local([d, e, f])?))) {
            Some((frame, local)) => apart(frame.to_world(local), exact::unit(vector)),
            None => -1.0,
        }
    })
    .is_what_is_promised("vectors there and back", 4e-7);
}

#[test]
fn solid_angles_are_as_exact_as_promised() {
    worst(1, STEPS, [Even(1e-10, std::f32::consts::PI)], |[angle]| {
        units(cone(angle), exact::cone(angle.into()))
    })
    .is_what_is_promised("cones, in units", 4.0);
    // These are written so that f64 does not cancel.
    worst(2, STEPS, [Sizes(1e-6, 1e6), Sizes(1e-6, 1e6)], |[radius, distance]| {
        let (r, d) = (f64::from(radius), f64::from(distance));
        if d < r {
            return -1.0;
        }
        units(sphere(radius, distance), TAU * r * r / (d * (d + ((d - r) * (d + r)).sqrt())))
    })
    .is_what_is_promised("spheres, in units", 6.0);
    worst(3, STEPS, [Sizes(1e-6, 1e6), Sizes(1e-6, 1e6)], |[radius, distance]| {
        let (r, d) = (f64::from(radius), f64::from(distance));
        let slant = r.hypot(d);
        units(disk(radius, distance), TAU * r * r / (slant * (slant + d)))
    })
    .is_what_is_promised("disks, in units", 7.0);
    worst(4, STEPS, [Sizes(1e-5, 1e5); 3], |[width, height, distance]| {
        let [a, b, d] = [0.5 * width, 0.5 * height, distance].map(f64::from);
        units(rectangle(width, height, distance), 4.0 * (a * b).atan2(d * (a * a + b * b + d * d).sqrt()))
    })
    .is_what_is_promised("rectangles, in units", 6.0);
    let nodes = exact::gauss(30);
    worst(5, STEPS / 4, [Sizes(1e-3, 1e3); 3], |[radius, distance, offset]| {
        let [r, d, o] = [radius, distance, offset].map(f64::from);
        let exact = if o > 2.0 * r {
            // The elements of the disk, since the boundary integral would cancel.
            let element = |x: f64, angle: f64| {
                let distance2 = d * d + o * o + x * x - 2.0 * o * x * angle.cos();
                d * x / distance2.powf(1.5)
            };
            2.0 * exact::integral(&nodes, 0.0, r, |x| exact::integral(&nodes, 0.0, PI, |a| element(x, a)))
        } else if d.hypot(o + r) < 300.0 * d.hypot(o - r) {
            exact::disk_off_axis(r, d, o)
        } else {
            // Beside the rim the model takes too many steps for a search.
            return -1.0;
        };
        relative(disk_off_axis(radius, distance, offset), exact)
    })
    .is_what_is_promised("disks off their axis", 1.3e-6);
}

#[test]
fn form_factors_are_as_exact_as_promised() {
    worst(1, STEPS, [Sizes(1e-4, 1e4); 3], |[r1, r2, distance]| {
        let [a, b, d] = [r1, r2, distance].map(f64::from);
        let root = d.hypot(a - b) * d.hypot(a + b);
        units(coaxial_disks(r1, r2, distance), 2.0 * b * b / (d * d + a * a + b * b + root))
    })
    .is_what_is_promised("coaxial disks, in units", 7.0);
    let disk = |radius: f32, distance: f32, offset: f32| {
        let [r, h, o] = [radius, distance, offset].map(f64::from);
        let root = h.hypot(r - o) * h.hypot(r + o);
        let beyond = h * h - (r - o) * (r + o);
        if beyond < 0.0 { 0.5 * (root - beyond) / root } else { 2.0 * r * h / root * r * h / (root + beyond) }
    };
    worst(2, STEPS, [Sizes(1e-3, 1e3); 3], |[r, h, o]| relative(to_disk(r, h, o), disk(r, h, o)))
        .is_what_is_promised("form factors to disks", 8e-7);
    worst(3, STEPS, [Sizes(1e-3, 1e3); 3], |[r, h, o]| {
        let source = DiskSource { radius_m: r, radiance: Nit::from(3.0) };
        relative(source.irradiance(h, o).value().0, 3.0 * PI * disk(r, h, o))
    })
    .is_what_is_promised("irradiance of disks", 1e-6);
    let nodes = exact::gauss(60);
    // The inner integral where the closed form would cancel in f64 too.
    let opposite = |width: f64, height: f64| {
        let (x, y) = (width.min(height), width.max(height));
        if x > 3.0 {
            return exact::parallel_rectangles(x, y, 1.0);
        }
        let inner = |t: f64| {
            let p = (1.0 + x * t * x * t).sqrt();
            (1.0 - t) * (y / p).atan() / p.powi(3)
        };
        2.0 * x / PI * exact::integral(&nodes, 0.0, 1.0, inner)
    };
    worst(
        4,
        STEPS / 2,
        [Sizes(0.02, 1e3), Sizes(0.02, 1e3), Sizes(0.1, 10.0)],
        |[width, height, distance]| {
            let (w, h, d) = (f64::from(width), f64::from(height), f64::from(distance));
            relative(parallel_rectangles(width, height, distance), opposite(w / d, h / d))
        },
    )
    .is_what_is_promised("opposite rectangles", 6e-7);
    worst(5, STEPS, [Sizes(1e-3, 1e3), Sizes(1e-3, 1e3), Sizes(0.5, 2.0)], |[a, b, edge]| {
        let exact = exact::perpendicular_rectangles(a.into(), b.into(), edge.into());
        relative(perpendicular_rectangles(a, b, edge), exact)
    })
    .is_what_is_promised("rectangles at a right angle", 6e-7);
    worst(6, STEPS / 4, [Sizes(1e-3, 1.0), Even(0.0, 1.0)], |[radius, cos]| {
        relative(to_sphere(radius, 1.0, cos), exact::to_sphere(&nodes, radius.into(), 1.0, cos.into()))
    })
    .is_what_is_promised("form factors to spheres", 1e-6);
    worst(7, STEPS / 4, [Sizes(1e-3, 1.0), Even(-1.0, 0.0)], |[radius, depth]| {
        let (r, cos) = (f64::from(radius), depth * radius);
        let exact = exact::to_sphere(&nodes, r, 1.0, cos.into());
        (f64::from(to_sphere(radius, 1.0, cos)) - exact).abs() / (r * r)
    })
    .is_what_is_promised("form factors to setting spheres", 1.4e-7);
}

#[test]
fn sources_are_as_exact_as_promised() {
    let seen = |position: [f32; 3], normal: [f32; 3]| {
        let (way, normal) = (exact::wide(position), exact::wide(normal));
        let (distance, length) = (exact::length(way), exact::length(normal));
        (distance, exact::dot(way, normal) / distance / length)
    };
    worst(1, STEPS, [Even(-1.0, 1.0); 6], |[a, b, c, d, e, f]| {
        let (distance, cos) = seen([a, b, c], [d, e, f]);
        let lamp = PointSource { position_m: [a, b, c], intensity: Candela::from(1.0) };
        let got = f64::from(lamp.irradiance([0.0; 3], [d, e, f]).value().0);
        (got * distance * distance - cos.max(0.0)).abs() * 16_777_216.0
    })
    .is_what_is_promised("irradiance of points, in units of that at normal incidence", 8.0);
    let nodes = exact::gauss(60);
    let ranges =
        [Even(-1.0, 1.0), Even(-1.0, 1.0), Even(0.5, 1.0), Even(-1.0, 1.0), Even(-1.0, 1.0), Even(-1.0, 1.0)];
    let sphere = |share: f32, [a, b, c, d, e, f]: [f32; 6]| {
        let (distance, cos) = seen([a, b, c], [d, e, f]);
        let radius_m = (f64::from(share) * distance) as f32;
        let sine = f64::from(radius_m) / distance;
        if sine >= 1.0 {
            return -1.0;
        }
        let lamp = SphereSource { position_m: [a, b, c], radius_m, radiance: Nit::from(1.0) };
        let got = f64::from(lamp.irradiance([0.0; 3], [d, e, f]).value().0) / PI;
        let error = got - exact::to_sphere(&nodes, radius_m.into(), distance, cos.clamp(-1.0, 1.0));
        error.abs() / (sine * sine) * (1.0 - sine * sine).sqrt()
    };
    let [a, b, c, d, e, f] = ranges;
    worst(2, STEPS / 4, [Even(0.001, 0.9999), a, b, c, d, e, f], |[share, a, b, c, d, e, f]| {
        sphere(share, [a, b, c, d, e, f])
    })
    .is_what_is_promised("irradiance of spheres, of that at normal incidence, times the cosine", 7e-7);
}
