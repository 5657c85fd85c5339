//! The color of a light, for its documentation, and lists of names in few words.

use crate::locus::knot;
use crate::table::Table;

/// The Planckian locus from 1 to 900 mired, as points (mired, u, v).
pub struct Locus(Vec<[f64; 3]>);

impl Locus {
    pub fn new(cmf: &Table) -> Self {
        let point = |k: i32| {
            let mired = f64::from(1 + k);
            let [u, v, ..] = knot(mired, cmf);
            [mired, u, v]
        };
        Locus((0..900).map(point).collect())
    }

    /// Describes the color of a light, as in `" with a CCT of 4000 K (x = 0.3805, y = 0.3769),"`. The column
    /// is interpolated to 1 nm by straight lines and is zero outside, as in the library.
    pub fn describe(&self, table: &Table, column: &[f64], cmf: &Table) -> String {
        let (first, step) = (f64::from(table.wavelengths[0]), f64::from(table.step()));
        let power = |nm: u16| {
            let place = (f64::from(nm) - first) / step;
            let cell = place.max(0.0) as usize;
            match (column.get(cell), column.get(cell + 1)) {
                (Some(a), Some(b)) if place >= 0.0 => a + (b - a) * (place - cell as f64),
                (Some(a), None) if place == cell as f64 => *a,
                _ => 0.0,
            }
        };
        let light: Vec<f64> = cmf.wavelengths.iter().map(|nm| power(*nm)).collect();
        let sum = |row: &Vec<f64>| row.iter().zip(&light).map(|(weight, power)| weight * power).sum::<f64>();
        let [x, y, z] = [&cmf.columns[0], &cmf.columns[1], &cmf.columns[2]].map(sum);
        let kelvin = self.cct([4.0 * x, 6.0 * y].map(|part| part / (x + 15.0 * y + 3.0 * z)));
        let [x, y] = [x, y].map(|part| part / (x + y + z));
        format!(" with a CCT of {kelvin:.0} K (x = {x:.4}, y = {y:.4}),")
    }

    /// The temperature of the point of the locus nearest to (u, v), where the parabola through the squared
    /// distances of the nearest three points is lowest.
    fn cct(&self, [u, v]: [f64; 2]) -> f64 {
        let distance = |[_, u0, v0]: [f64; 3]| (u - u0) * (u - u0) + (v - v0) * (v - v0);
        let distances = |three: &[[f64; 3]]| [three[0], three[1], three[2]].map(distance);
        let nearest = self.0.windows(3).min_by(|a, b| distances(a)[1].total_cmp(&distances(b)[1]));
        nearest.map_or(f64::NAN, |three| {
            let [a, b, c] = distances(three);
            1e6 / (three[1][0] + (a - c) / (2.0 * (a - 2.0 * b + c)))
        })
    }
}

/// Lists names as in `A, D50, FL1..FL12`, where three or more names in a row that count up become a range.
pub fn in_brief(names: &[String]) -> String {
    let counted = |name: &str| {
        let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
        Some((stem.to_owned(), name[stem.len()..].parse::<u32>().ok()?))
    };
    let follows = |pair: &[String]| match (counted(&pair[0]), counted(&pair[1])) {
        (Some((a, i)), Some((b, j))) => a == b && j == i + 1,
        _ => false,
    };
    let mut parts = Vec::new();
    let mut rest = names;
    while let [first, ..] = rest {
        let run = 1 + rest.windows(2).take_while(|pair| follows(pair)).count();
        if run >= 3 {
            parts.push(format!("{first}..{}", rest[run - 1]));
        } else {
            parts.extend_from_slice(&rest[..run]);
        }
        rest = &rest[run..];
    }
    parts.join(", ")
}
