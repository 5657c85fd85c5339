//! Compares methods for the correlated color temperature: that of the crate, and those that others use.

mod printed;

use crate::cells::{beaten, bytes, in_order, mean, priced, with_price};
use crate::clock::nanoseconds;
use crate::report::{Cell, Column, Table};
use model::cct::uv_at;
use nanospectra::color::{Cct, Uv1960};
use nanospectra_hard::yardstick::cct::{ISOTHERMS, LOCUS, mccamy, ohno, robertson};
use printed::Printed;
use std::hint::black_box;

struct Method {
    name: &'static str,
    word: &'static str,
    bytes: usize,
    cct_k: Box<dyn Fn([f32; 2]) -> Option<f32>>,
}

fn methods() -> Vec<Method> {
    let own = |[u, v]: [f32; 2]| Uv1960 { u, v }.cct().near().map(|(cct_k, _)| cct_k);
    // McCamy's formula takes x and y.
    let by_xy = |[u, v]: [f32; 2]| {
        let below = 2.0 * u - 8.0 * v + 4.0;
        Some(mccamy([3.0 * u / below, 2.0 * v / below]))
    };
    let printed = |name, percent| {
        let table = Printed::new(percent);
        Method { name, word: "", bytes: table.bytes(), cct_k: Box::new(move |uv| table.cct_k(uv)) }
    };
    vec![
        Method { name: "this crate", word: "cct-duv", bytes: Cct::TABLE_BYTES, cct_k: Box::new(own) },
        Method { name: "McCamy", word: "cct-mccamy", bytes: 0, cct_k: Box::new(by_xy) },
        Method {
            name: "Robertson",
            word: "cct-robertson",
            bytes: size_of_val(&ISOTHERMS),
            cct_k: Box::new(|uv| robertson(uv).map(|[cct_k, _]| cct_k)),
        },
        Method {
            name: "Ohno, without cancellation",
            word: "cct-ohno",
            bytes: size_of_val(&LOCUS),
            cct_k: Box::new(|uv| ohno(uv).map(|[cct_k, _]| cct_k)),
        },
        printed("Ohno as printed, 1 %", 1.0),
        printed("Ohno as printed, 0.25 %", 0.25),
    ]
}

/// The limits of the parts of the plane, in K and in Duv.
const TEMPERATURES: [f64; 9] =
    [1000.0, 1667.0, 2500.0, 4000.0, 6500.0, 10_000.0, 25_000.0, 100_000.0, 1_000_000.0];
const DUVS: [f64; 4] = [0.0, 0.005, 0.02, 0.05];

/// A part of the plane, with points on a lattice in it that has its corners and edges.
struct Band {
    kelvins: [f64; 2],
    duvs: [f64; 2],
    points: Vec<Point>,
}

/// A point by its reciprocal temperature in mired and its distance from the locus.
#[derive(Clone, Copy)]
struct Point {
    mired: f64,
    duv: f64,
}

impl Point {
    /// Returns the error of a method in mired, or `None` if it has no answer.
    fn error(self, method: &Method) -> Option<f64> {
        let uv = uv_at(1e6 / self.mired, self.duv).map(|part| part as f32);
        Some((1e6 / f64::from((method.cct_k)(uv)?) - self.mired).abs()).filter(|error| error.is_finite())
    }
}

/// What is found of a method in a part of the plane.
struct Errors {
    /// The errors in mired at the points for which the method has an answer.
    of_points: Vec<f64>,
    /// The largest error, which is searched for from the worst points.
    largest: f64,
}

impl Band {
    fn new(kelvins: [f64; 2], duvs: [f64; 2]) -> Self {
        let [cold, hot] = kelvins.map(|kelvin| 1e6 / kelvin);
        let points = (0..=40).flat_map(|k| {
            let mired = between([hot, cold], f64::from(k) / 40.0);
            (0..=10).flat_map(move |k| {
                let duv = between(duvs, f64::from(k) / 10.0);
                [duv, -duv].map(|duv| Point { mired, duv })
            })
        });
        Band { kelvins, duvs, points: points.collect() }
    }

    fn errors(&self, method: &Method) -> Errors {
        let mut found: Vec<(Point, f64)> =
            self.points.iter().filter_map(|point| Some((*point, point.error(method)?))).collect();
        let of_points = found.iter().map(|(_, error)| *error).collect();
        found.sort_by(|(_, a), (_, b)| b.total_cmp(a));
        let largest = found.iter().take(3).map(|worst| self.worst_near(*worst, method)).fold(0.0, f64::max);
        Errors { of_points, largest }
    }

    /// Climbs from a point to the largest error around it: steps in four directions, which become shorter
    /// where none of them leads further up.
    fn worst_near(&self, (mut at, mut largest): (Point, f64), method: &Method) -> f64 {
        let [cold, hot] = self.kelvins.map(|kelvin| 1e6 / kelvin);
        let (mut along, mut across) = ((cold - hot) / 40.0, (self.duvs[1] - self.duvs[0]) / 10.0);
        for _ in 0..12 {
            for (mireds, duvs) in [(along, 0.0), (-along, 0.0), (0.0, across), (0.0, -across)] {
                let side = if at.duv < 0.0 { -1.0 } else { 1.0 };
                let duv = side * (side * at.duv + duvs).clamp(self.duvs[0], self.duvs[1]);
                let next = Point { mired: (at.mired + mireds).clamp(hot, cold), duv };
                if let Some(error) = next.error(method).filter(|error| *error > largest) {
                    (at, largest) = (next, error);
                }
            }
            (along, across) = (along / 2.0, across / 2.0);
        }
        largest
    }

    /// Whether lamps for rooms lie in this part.
    fn is_usual(&self) -> bool {
        self.kelvins[0] >= 2500.0 && self.kelvins[1] <= 10_000.0 && self.duvs[1] <= 0.02
    }
}

fn between([from, to]: [f64; 2], share: f64) -> f64 {
    from + (to - from) * share
}

pub fn tables(runs: usize) -> Vec<Table> {
    let bands: Vec<Band> = TEMPERATURES
        .windows(2)
        .flat_map(|kelvins| {
            DUVS.windows(2).map(move |duvs| Band::new([kelvins[0], kelvins[1]], [duvs[0], duvs[1]]))
        })
        .collect();
    let methods = methods();
    vec![summary(&methods, &bands, runs), by_band(&methods, &bands)]
}

fn summary(methods: &[Method], bands: &[Band], runs: usize) -> Table {
    let columns = with_price(vec![
        Column::key("method", "method"),
        Column::figure("max_mired_of_lamps", "lamps: max, mired"),
        Column::figure("mean_mired", "plane: mean"),
        Column::figure("max_mired", "max"),
        Column::figure("unanswered_percent", "no answer, %"),
        Column::figure("bytes", "bytes"),
        Column::figure("beaten_by", "beaten by"),
    ]);
    /// The largest error of lamps, the errors of all points, and the largest in the plane.
    struct Found {
        of_lamps: f64,
        plane: Vec<f64>,
        largest: f64,
    }
    let of = |method: &Method| {
        let mut found = Found { of_lamps: 0.0, plane: Vec::new(), largest: 0.0 };
        for band in bands {
            let errors = band.errors(method);
            if band.is_usual() {
                found.of_lamps = found.of_lamps.max(errors.largest);
            }
            found.largest = found.largest.max(errors.largest);
            found.plane.extend(errors.of_points);
        }
        found
    };
    let found: Vec<Found> = methods.iter().map(of).collect();
    let choices: Vec<(f64, f64)> =
        found.iter().zip(methods).map(|(found, method)| (found.of_lamps, method.bytes as f64)).collect();
    let all: usize = bands.iter().map(|band| band.points.len()).sum();
    let rows = methods.iter().zip(found).zip(beaten(&choices)).map(|((method, found), beaten)| {
        let Found { of_lamps, plane, largest } = found;
        let row = vec![
            Cell::key(method.name),
            Cell::figure(of_lamps),
            Cell::figure(mean(&plane)),
            Cell::figure(largest),
            Cell::figure(100.0 * (1.0 - plane.len() as f64 / all as f64)),
            bytes(method.bytes),
            beaten,
        ];
        priced(row, method.word, nanoseconds(runs, || (method.cct_k)(black_box([0.2, 0.31]))))
    });
    Table {
        id: "cct",
        title: "Correlated color temperature, by method".into(),
        about: format!(
            "The errors in f32 against the nearest point of the locus in f64, at {all} points: from 1000 K \
             to a million, with |Duv| up to 0.05, corners and edges included. The largest are searched for \
             from there. Lamps: from 2500 K to 10 000 K, with |Duv| up to 0.02. Beaten by: how many methods whose tables are no larger have a smaller largest error for lamps."
        ),
        columns,
        rows: rows.collect(),
    }
}

fn by_band(methods: &[Method], bands: &[Band]) -> Table {
    let mut rows = Vec::new();
    for band in bands {
        let errors: Vec<Errors> = methods.iter().map(|method| band.errors(method)).collect();
        let worst =
            |errors: &Errors| if errors.of_points.is_empty() { f64::INFINITY } else { errors.largest };
        let choices: Vec<(f64, f64)> =
            errors.iter().map(worst).zip(methods.iter().map(|method| method.bytes as f64)).collect();
        for ((method, errors), beaten) in methods.iter().zip(errors).zip(beaten(&choices)) {
            let Errors { of_points, largest } = errors;
            let unanswered = 100.0 * (1.0 - of_points.len() as f64 / band.points.len() as f64);
            rows.push(vec![
                Cell::key(method.name),
                Cell::key(format!("{}..{}", band.kelvins[0], band.kelvins[1])),
                Cell::key(format!("{}..{}", band.duvs[0], band.duvs[1])),
                if of_points.is_empty() { Cell::Nothing } else { Cell::figure(mean(&of_points)) },
                if of_points.is_empty() { Cell::Nothing } else { Cell::figure(largest) },
                Cell::figure(unanswered),
                beaten,
            ]);
        }
    }
    in_order(&mut rows, methods.iter().map(|method| method.name));
    Table {
        id: "cct-bands",
        title: "Correlated color temperature, by method and place".into(),
        about: "The same errors by temperature and by distance from the locus. Beaten by: how many methods \
                whose tables are no larger have a smaller largest error here."
            .into(),
        columns: vec![
            Column::key("method", "method"),
            Column::key("kelvin", "K"),
            Column::key("duv", "|Duv|"),
            Column::figure("mean_mired", "mean, mired"),
            Column::figure("max_mired", "max"),
            Column::figure("unanswered_percent", "no answer, %"),
            Column::figure("beaten_by", "beaten by"),
        ],
        rows,
    }
}
