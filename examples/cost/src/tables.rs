//! Compares ways of storing the color-matching functions in fewer bytes.

use crate::cells::{COUNTED, DIFFERENCES, beaten, bytes, counted, in_order, mean, summary};
use crate::nanometers::{Light, Lit, NODES, for_y_100, nm, world};
use crate::report::{Cell, Column, Table};
use crate::xyz::lamps::CLASSES;
use model::delta_e::de2000;
use model::lab::lab;
use model::tables::Observer;
use nanospectra::math::Portable;
use nanospectra_hard::yardstick::lobes::color_matching;

pub fn tables(_: usize) -> Vec<Table> {
    let mut columns =
        vec![Column::key("table", "table"), Column::key("lamps", "lamps"), Column::figure("bytes", "bytes")];
    columns.extend(DIFFERENCES);
    columns.extend([
        Column::figure("own_white_mean_de2000", "own white: mean"),
        Column::figure("colorless_percent", "no color, %"),
        Column::figure("beaten_by", "beaten by"),
    ]);
    columns.extend(COUNTED);
    vec![Table {
        id: "tables",
        title: "Tables of the CIE 1931 functions".into(),
        about: "CIEDE2000 of the 99 samples against sums of the f64 functions over the same nanometers, \
                360..830 nm, so that only the errors of the table show. The first columns use the exact \
                white, the next one the table's own. No color: the percentage of colors whose white has no \
                X, Y or Z left. Beaten by: how many tables of no more bytes have a smaller mean. Integers \
                are shares of the largest value of their function. Instructions are those of x, y and z at \
                one wavelength."
            .into(),
        columns,
        rows: rows(),
    }]
}

/// The three functions at every nanometer, as a table of fewer bytes gives them.
struct Stored {
    name: &'static str,
    /// The name of its count on record.
    word: &'static str,
    bytes: usize,
    cmf: [Vec<f64>; 3],
}

fn stored(exact: &[Vec<f64>; 3]) -> Vec<Stored> {
    let every = |name, bits: usize, round: &dyn Fn(f64, f64) -> f64| {
        let cmf = exact.each_ref().map(|row| {
            let most = row.iter().copied().fold(0.0, f64::max);
            row.iter().map(|value| round(*value, most)).collect()
        });
        Stored { name, word: "", bytes: (3 * NODES * bits).div_ceil(8), cmf }
    };
    let whole = |steps: f64| move |value: f64, most: f64| (value / most * steps).round() / steps * most;
    let five = |name, first: usize, last: usize, bytes: usize, round: &dyn Fn(f64) -> f64| {
        let cmf = exact.each_ref().map(|row| every_5_nm(row, first - 360, last - 360, round));
        Stored { name, word: "", bytes: 3 * ((last - first) / 5 + 1) * bytes, cmf }
    };
    let lobes = || {
        let values = (0..NODES).map(|k| color_matching::<Portable>(nm(k) as f32));
        let row = |c: usize| values.clone().map(move |xyz| f64::from(xyz[c])).collect();
        // There are seven lobes of four numbers each.
        Stored { name: "seven lobes (Wyman)", word: "lobes-point", bytes: 7 * 4 * 4, cmf: [0, 1, 2].map(row) }
    };
    vec![
        every("f32", 32, &|value, _| single(value)),
        every("f16", 16, &|value, _| half(value)),
        every("u16", 16, &whole(65_535.0)),
        every("u12", 12, &whole(4095.0)),
        every("u8", 8, &whole(255.0)),
        five("f32, 5 nm", 360, 830, 4, &single),
        five("f32, 5 nm, 380..780", 380, 780, 4, &single),
        five("f16, 5 nm, 380..780", 380, 780, 2, &half),
        lobes(),
    ]
}

fn single(value: f64) -> f64 {
    f64::from(value as f32)
}

/// Rounds to binary16 of IEEE 754, which has 11 significant bits, and steps of 2^-24 below 2^-14.
fn half(value: f64) -> f64 {
    let exponent = (value.to_bits() >> 52) as i32 - 1023;
    let step = 2f64.powi(exponent.max(-14) - 10);
    (value / step).round_ties_even() * step
}

/// Takes every fifth value, interpolates linearly between them, and is zero beyond them.
fn every_5_nm(row: &[f64], first: usize, last: usize, round: &dyn Fn(f64) -> f64) -> Vec<f64> {
    let between = |k: usize| {
        let (from, t) = (k / 5 * 5, (k % 5) as f64 / 5.0);
        round(row[from]) * (1.0 - t) + row.get(from + 5).map_or(0.0, |next| t * round(*next))
    };
    (0..NODES).map(|k| if (first..=last).contains(&k) { between(k) } else { 0.0 }).collect()
}

/// A lamp and the samples under it as the exact functions see them.
struct Truth<'a> {
    light: &'a Light,
    scale: f64,
    white: [f64; 3],
    labs: Vec<[f64; 3]>,
}

fn rows() -> Vec<Vec<Cell>> {
    let (exact, world) = (Observer::Cie1931.on_cie_grid(), world());
    let truths: Vec<Truth> = world
        .lights
        .iter()
        .map(|light| {
            let scale = for_y_100(&exact, &light.power);
            let lit = Lit::new(&exact, &light.power, scale);
            let labs = world.ces.iter().map(|sample| lit.lab(sample)).collect();
            Truth { light, scale, white: lit.white, labs }
        })
        .collect();
    let stored = stored(&exact);
    let mut all = Vec::new();
    for class in CLASSES {
        let errors: Vec<Errors> = stored
            .iter()
            .map(|table| {
                let mut errors = Errors::default();
                for truth in truths.iter().filter(|truth| truth.light.class == class) {
                    errors.add(table, truth, &world.ces);
                }
                errors
            })
            .collect();
        let choices: Vec<(f64, f64)> = errors
            .iter()
            .zip(&stored)
            .map(|(errors, table)| (mean(&errors.absolute), table.bytes as f64))
            .collect();
        for ((table, errors), beaten) in stored.iter().zip(errors).zip(beaten(&choices)) {
            let mut row = vec![Cell::key(table.name), Cell::key(class.name()), bytes(table.bytes)];
            let none = 100.0 * errors.colorless / (errors.colorless + errors.absolute.len() as f64);
            let [own, ..] = summary(errors.own_white);
            row.extend(summary(errors.absolute));
            row.extend([own, Cell::figure(none), beaten]);
            row.extend(counted(table.word));
            all.push(row);
        }
    }
    in_order(&mut all, stored.iter().map(|table| table.name));
    all
}

#[derive(Default)]
struct Errors {
    absolute: Vec<f64>,
    own_white: Vec<f64>,
    colorless: f64,
}

impl Errors {
    fn add(&mut self, table: &Stored, truth: &Truth, ces: &[Vec<f64>]) {
        let lit = Lit::new(&table.cmf, &truth.light.power, truth.scale);
        let has_color = lit.white.iter().all(|part| *part > 0.0);
        for (sample, exact) in ces.iter().zip(&truth.labs) {
            if has_color && exact.iter().all(|part| part.is_finite()) {
                let seen = lit.sees(sample);
                self.absolute.push(de2000(*exact, lab(seen, truth.white)));
                self.own_white.push(de2000(*exact, lab(seen, lit.white)));
            } else {
                self.colorless += 1.0;
            }
        }
    }
}
