//! Compares methods for the correlated color temperature: that of the crate, and those that others use.

mod printed;

use crate::cells::{beaten, bytes, in_order, largest, mean, priced, with_price};
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

/// A part of the plane, with points in it: the mired of each, and its u and v.
struct Band {
    kelvins: [f64; 2],
    duvs: [f64; 2],
    points: Vec<(f64, [f32; 2])>,
}

impl Band {
    fn new(kelvins: [f64; 2], duvs: [f64; 2]) -> Self {
        // The points are the centers of 40 by 10 cells above the locus, and of as many below it.
        let middle = |[from, to]: [f64; 2], k: u32, cells: u32| {
            from + (to - from) * (f64::from(k) + 0.5) / f64::from(cells)
        };
        let points = (0..40).flat_map(|k| {
            let mired = middle(kelvins.map(|kelvin| 1e6 / kelvin), k, 40);
            (0..20).map(move |k| {
                let duv = middle(duvs, k / 2, 10) * if k % 2 == 0 { 1.0 } else { -1.0 };
                (mired, uv_at(1e6 / mired, duv).map(|part| part as f32))
            })
        });
        Band { kelvins, duvs, points: points.collect() }
    }

    /// Returns the errors in mired of the points for which the method has an answer.
    fn errors(&self, method: &Method) -> Vec<f64> {
        let error = |(mired, uv): &(f64, [f32; 2])| {
            Some((1e6 / f64::from((method.cct_k)(*uv)?) - mired).abs()).filter(|error| error.is_finite())
        };
        self.points.iter().filter_map(error).collect()
    }

    /// Whether lamps for rooms lie in this part.
    fn is_usual(&self) -> bool {
        self.kelvins[0] >= 2500.0 && self.kelvins[1] <= 10_000.0 && self.duvs[1] <= 0.02
    }
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
    let of = |method: &Method| -> (Vec<f64>, Vec<f64>) {
        let errors = |usual: bool| {
            let bands = bands.iter().filter(|band| !usual || band.is_usual());
            bands.flat_map(|band| band.errors(method)).collect()
        };
        (errors(true), errors(false))
    };
    let errors: Vec<_> = methods.iter().map(of).collect();
    let most = |errors: &[f64]| errors.iter().copied().fold(0.0, f64::max);
    let choices: Vec<(f64, f64)> =
        errors.iter().zip(methods).map(|((usual, _), method)| (most(usual), method.bytes as f64)).collect();
    let all: usize = bands.iter().map(|band| band.points.len()).sum();
    let rows = methods.iter().zip(errors).zip(beaten(&choices)).map(|((method, (usual, plane)), beaten)| {
        let row = vec![
            Cell::key(method.name),
            largest(usual),
            Cell::figure(mean(&plane)),
            Cell::figure(most(&plane)),
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
             to a million, with |Duv| up to 0.05. Lamps: from 2500 K to 10 000 K, with |Duv| up to 0.02. \
             Beaten by: how many methods whose tables are no larger have a smaller largest error for lamps."
        ),
        columns,
        rows: rows.collect(),
    }
}

fn by_band(methods: &[Method], bands: &[Band]) -> Table {
    let mut rows = Vec::new();
    for band in bands {
        let errors: Vec<Vec<f64>> = methods.iter().map(|method| band.errors(method)).collect();
        let worst =
            |errors: &Vec<f64>| errors.iter().copied().max_by(f64::total_cmp).unwrap_or(f64::INFINITY);
        let choices: Vec<(f64, f64)> =
            errors.iter().map(worst).zip(methods.iter().map(|method| method.bytes as f64)).collect();
        for ((method, errors), beaten) in methods.iter().zip(errors).zip(beaten(&choices)) {
            let unanswered = 100.0 * (1.0 - errors.len() as f64 / band.points.len() as f64);
            rows.push(vec![
                Cell::key(method.name),
                Cell::key(format!("{}..{}", band.kelvins[0], band.kelvins[1])),
                Cell::key(format!("{}..{}", band.duvs[0], band.duvs[1])),
                if errors.is_empty() { Cell::Nothing } else { Cell::figure(mean(&errors)) },
                largest(errors),
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
