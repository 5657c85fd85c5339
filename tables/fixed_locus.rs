//! The Planckian locus for arithmetic in integers: knots with unit tangents, and two parabolas for each
//! segment.
//!
//! The parabolas correct the straight segments. They are fitted here to the locus itself, by least squares
//! over the length of a segment and |Duv| <= 0.05, for the formulas of `src/sensor/fixed/cct.rs`.

use crate::locus::{KNOTS, knot};
use crate::table::Table;
use std::fmt::Write as _;

/// The Rust source of `FIXED_LOCUS: [Knot; KNOTS]`.
pub fn source(cmf: &Table) -> String {
    let mut text = format!("static FIXED_LOCUS: [Knot; {KNOTS}] = [\n");
    for k in 0..KNOTS {
        let from = Point::at(f64::from(k), cmf);
        let (bulge, sagitta) = if k + 1 < KNOTS {
            fit(k, from, Point::at(f64::from(k + 1), cmf), cmf)
        } else {
            ([0.0; 2], [0.0; 2])
        };
        let scaled = |[a, b]: [f64; 2], scale: f64| [(a * scale).round() as i16, (b * scale).round() as i16];
        let [u, v] = from.place.map(|x| (x * f64::from(1 << 20)).round() as i32);
        let _ = writeln!(
            text,
            "    Knot {{ u: {u}, v: {v}, tangent: {:?}, bulge: {:?}, sagitta: {:?} }},",
            scaled(from.tangent, f64::from(1 << 14)),
            scaled(bulge, f64::from(1 << 15)),
            scaled(sagitta, 64.0)
        );
    }
    text + "];\n"
}

/// A point of the locus and its unit tangent.
#[derive(Clone, Copy)]
struct Point {
    place: [f64; 2],
    tangent: [f64; 2],
}

impl Point {
    fn at(k: f64, cmf: &Table) -> Self {
        // Knots lie at 17 k + 11/256 k^3 mired, from 0 to 1002, which are whole numbers of 256ths.
        let [u, v, du, dv] = knot(k * (17.0 + 11.0 / 256.0 * k * k), cmf);
        let length = (du * du + dv * dv).sqrt();
        Point { place: [u, v], tangent: [du / length, dv / length] }
    }

    fn along(&self, p: [f64; 2]) -> f64 {
        (p[0] - self.place[0]) * self.tangent[0] + (p[1] - self.place[1]) * self.tangent[1]
    }

    fn across(&self, p: [f64; 2]) -> f64 {
        (p[1] - self.place[1]) * self.tangent[0] - (p[0] - self.place[0]) * self.tangent[1]
    }
}

/// The two coefficients of the parabola, and of the sagitta, for the segment after knot `k`.
fn fit(k: u32, from: Point, to: Point, cmf: &Table) -> ([f64; 2], [f64; 2]) {
    let (mut bulge, mut sagitta) = (Pair::default(), Pair::default());
    for i in 0..=16 {
        let s = f64::from(i) / 16.0;
        let here = Point::at(f64::from(k) + s, cmf);
        for j in -5..=5 {
            let duv = f64::from(j) / 100.0;
            let [du, dv] = here.tangent;
            let p = [here.place[0] - duv * dv, here.place[1] + duv * du];
            let (d0, d1) = (from.along(p), to.along(p));
            let r = d0 / (d0 - d1);
            let mean = from.across(p) + r * (to.across(p) - from.across(p));
            bulge.add([r * (1.0 - r), r * (1.0 - r) * duv], s - r);
            sagitta.add([d0 * d1, d0 * d1 * mean], duv - mean);
        }
    }
    (bulge.solve(), sagitta.solve())
}

/// A fit of two coefficients by least squares.
#[derive(Default)]
struct Pair {
    squares: [f64; 3],
    products: [f64; 2],
}

impl Pair {
    fn add(&mut self, [a, b]: [f64; 2], y: f64) {
        self.squares[0] += a * a;
        self.squares[1] += a * b;
        self.squares[2] += b * b;
        self.products[0] += a * y;
        self.products[1] += b * y;
    }

    fn solve(&self) -> [f64; 2] {
        let ([aa, ab, bb], [ay, by]) = (self.squares, self.products);
        let det = aa * bb - ab * ab;
        [(ay * bb - by * ab) / det, (by * aa - ay * ab) / det]
    }
}
