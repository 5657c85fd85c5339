//! Solid angles and form factors in f64: textbook formulas where f64 has digits to spare, integrals
//! elsewhere.

use std::f64::consts::PI;

pub type Point = [f64; 3];

pub fn minus(a: Point, b: Point) -> Point {
    std::array::from_fn(|i| a[i] - b[i])
}

pub fn plus(a: Point, b: Point) -> Point {
    std::array::from_fn(|i| a[i] + b[i])
}

pub fn times(a: Point, k: f64) -> Point {
    a.map(|x| x * k)
}

pub fn dot(a: Point, b: Point) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

pub fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn length(a: Point) -> f64 {
    dot(a, a).sqrt()
}

pub fn unit(a: Point) -> Point {
    times(a, 1.0 / length(a))
}

pub fn wide(a: [f32; 3]) -> Point {
    a.map(f64::from)
}

/// Gauss and Legendre's nodes and weights on 0..1, by Newton's method.
pub fn gauss(n: usize) -> Vec<(f64, f64)> {
    (0..n)
        .map(|k| {
            let mut x = (PI * (k as f64 + 0.75) / (n as f64 + 0.5)).cos();
            let mut slope = 1.0;
            for _ in 0..50 {
                let (mut p, mut last) = (1.0, 0.0);
                for j in 0..n {
                    let j = j as f64;
                    (p, last) = (((2.0 * j + 1.0) * x * p - j * last) / (j + 1.0), p);
                }
                slope = n as f64 * (x * p - last) / (x * x - 1.0);
                x -= p / slope;
            }
            (0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect()
}

pub fn integral(nodes: &[(f64, f64)], from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    nodes.iter().map(|(x, weight)| weight * f(from + (to - from) * x)).sum::<f64>() * (to - from)
}

/// Of a function of the place, over a triangle, by nodes squeezed towards one corner.
pub fn over_triangle(nodes: &[(f64, f64)], [p, q, r]: [Point; 3], f: impl Fn(Point) -> f64) -> f64 {
    let area = length(cross(minus(q, p), minus(r, p)));
    let at = |x: f64, y: f64| plus(p, plus(times(minus(q, p), x * (1.0 - y)), times(minus(r, p), x * y)));
    area * integral(nodes, 0.0, 1.0, |x| x * integral(nodes, 0.0, 1.0, |y| f(at(x, y))))
}

pub fn cone(half_angle: f64) -> f64 {
    4.0 * PI * (half_angle / 2.0).sin().powi(2)
}

pub fn sphere(radius: f64, distance: f64) -> f64 {
    cone((radius / distance).asin())
}

pub fn disk(radius: f64, distance: f64) -> f64 {
    cone(radius.atan2(distance))
}

/// The boundary integral in so many steps that the nearness of the rim does not count.
pub fn disk_off_axis(radius: f64, distance: f64, offset: f64) -> f64 {
    let near = distance.hypot(offset - radius);
    let far = distance.hypot(offset + radius);
    let steps = (40.0 * far / near) as usize + 200;
    let term = |k: usize| {
        let angle = 2.0 * PI * (k as f64 + 0.5) / steps as f64;
        let slant = (near * near + 4.0 * offset * radius * (angle / 2.0).sin().powi(2)).sqrt();
        radius * (radius - offset * angle.cos()) / (slant * (slant + distance))
    };
    (0..steps).map(term).sum::<f64>() * 2.0 * PI / steps as f64
}

pub fn rectangle(width: f64, height: f64, distance: f64) -> f64 {
    4.0 * (width * height
        / ((width * width + 4.0 * distance * distance) * (height * height + 4.0 * distance * distance))
            .sqrt())
    .asin()
}

/// Van Oosterom and Strackee, as published.
pub fn triangle([a, b, c]: [Point; 3]) -> f64 {
    let [la, lb, lc] = [a, b, c].map(length);
    let below = la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la;
    2.0 * dot(a, cross(b, c)).abs().atan2(below)
}

/// The integral of cos / r^2 over a triangle that is small against its distance.
pub fn small_triangle(nodes: &[(f64, f64)], corners: [Point; 3]) -> f64 {
    let [p, q, r] = corners;
    let normal = unit(cross(minus(q, p), minus(r, p)));
    over_triangle(nodes, corners, |x| dot(x, normal).abs() / dot(x, x).powf(1.5))
}

pub fn coaxial_disks(r1: f64, r2: f64, distance: f64) -> f64 {
    let sum = r1 * r1 + r2 * r2 + distance * distance;
    // 1 - root(1 - x^2) as a squared sine
    let half = (2.0 * r1 * r2 / sum).asin() / 2.0;
    sum / (r1 * r1) * half.sin().powi(2)
}

pub fn to_disk(radius: f64, distance: f64, offset: f64) -> f64 {
    let z = distance * distance + radius * radius + offset * offset;
    0.5 * (1.0 - (z - 2.0 * radius * radius) / (z * z - 4.0 * radius * radius * offset * offset).sqrt())
}

/// Where it is cut by the horizon, slices at equal height: height times width.
pub fn to_sphere(nodes: &[(f64, f64)], radius: f64, distance: f64, cos: f64) -> f64 {
    let (size, zenith) = ((radius / distance).asin(), cos.acos());
    if zenith + size <= PI / 2.0 {
        return cos * (radius / distance).powi(2);
    }
    if zenith - size >= PI / 2.0 {
        return 0.0;
    }
    let (cos_size, sin) = (size.cos(), (1.0 - cos * cos).sqrt());
    let slice = |z: f64| {
        let half_width = ((cos_size - z * cos) / ((1.0 - z * z).sqrt() * sin)).clamp(-1.0, 1.0).acos();
        2.0 * half_width * z
    };
    // The highest point of the outline. Below it the width changes like a root: equal steps of an angle.
    // Above it, if the zenith is covered, slices are whole circles.
    let top = (zenith - size).cos();
    let cap = if zenith < size { PI * (1.0 - top * top) } else { 0.0 };
    (cap + integral(nodes, 0.0, PI / 2.0, |t| slice(top * t.sin()) * top * t.cos())) / PI
}

/// Lambert's formula for the part above the horizon of a polygon given relative to the point.
pub fn to_polygon(normal: Point, corners: &[Point]) -> f64 {
    let mut above = Vec::new();
    for (k, p) in corners.iter().enumerate() {
        let q = corners[(k + 1) % corners.len()];
        let (hp, hq) = (dot(normal, *p), dot(normal, q));
        if hp >= 0.0 {
            above.push(*p);
        }
        if hp * hq < 0.0 {
            above.push(plus(*p, times(minus(q, *p), hp / (hp - hq))));
        }
    }
    let mut sum = 0.0;
    for (k, p) in above.iter().enumerate() {
        let q = above[(k + 1) % above.len()];
        let plane = cross(*p, q);
        let size = length(plane);
        if size > 0.0 {
            sum -= dot(normal, plane) / size * size.atan2(dot(*p, q));
        }
    }
    (sum / (2.0 * PI)).max(0.0)
}

pub fn parallel_rectangles(width: f64, height: f64, distance: f64) -> f64 {
    let (x, y) = (width / distance, height / distance);
    let (sx, sy) = ((1.0 + x * x).sqrt(), (1.0 + y * y).sqrt());
    let log = (sx * sx * sy * sy / (1.0 + x * x + y * y)).sqrt().ln();
    2.0 / (PI * x * y)
        * (log + x * sy * (x / sy).atan() + y * sx * (y / sx).atan() - x * x.atan() - y * y.atan())
}

pub fn perpendicular_rectangles(width_1: f64, width_2: f64, edge: f64) -> f64 {
    let (w, h) = (width_1 / edge, width_2 / edge);
    let (w2, h2) = (w * w, h * h);
    let both = w2 + h2;
    let log = ((1.0 + w2) * (1.0 + h2) / (1.0 + both)).ln()
        + w2 * (w2 * (1.0 + both) / ((1.0 + w2) * both)).ln()
        + h2 * (h2 * (1.0 + both) / ((1.0 + h2) * both)).ln();
    let arcs = w * (1.0 / w).atan() + h * (1.0 / h).atan() - both.sqrt() * (1.0 / both.sqrt()).atan();
    (arcs + 0.25 * log) / (PI * w)
}
