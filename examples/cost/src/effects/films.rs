//! Compares thin films whose reflectance is read at points with films whose reflectance is averaged over the
//! bins.

use crate::cells::{TIME, beaten};
use crate::clock::nanoseconds;
use crate::nanometers::{Lit, NODES, for_y_100, nm, world};
use crate::report::{Cell, Column, Table};
use model::delta_e::de2000;
use model::film::{airy, mean};
use model::lab::lab;
use model::tables::Observer as Eye;
use nanospectra::light::D65;
use nanospectra::matter::ThinFilm;
use nanospectra::observer::CIE_1931;
use nanospectra::{Bins, Curve, Factor, Observer, Reflectance};
use std::hint::black_box;

/// The thicknesses of the films of soap in nm, and how many points in each nanometer show all their fringes.
const FILMS: [(f32, usize); 5] =
    [(300.0, 8), (2000.0, 8), (20_000.0, 16), (100_000.0, 64), (1_000_000.0, 512)];
const SOAP: f32 = 1.33;

pub fn table(runs: usize) -> Table {
    let mut rows = Vec::new();
    for (thickness_nm, points) in FILMS {
        let truth = Truth::new(thickness_nm, points);
        let looks = [of::<16>(&truth, runs), of::<31>(&truth, runs), of::<60>(&truth, runs)];
        for way in [0, 1] {
            let choices: Vec<(f64, f64)> =
                looks.iter().map(|look| (look.de2000[way], look.bands as f64)).collect();
            for (look, beaten) in looks.iter().zip(beaten(&choices)) {
                rows.push(vec![
                    Cell::key(thickness_nm),
                    Cell::key(WAYS[way]),
                    Cell::key(look.bands),
                    Cell::figure(look.de2000[way]),
                    beaten,
                    Cell::time(look.ns[way]),
                ]);
            }
        }
    }
    Table {
        id: "films",
        title: "A film of soap: its reflectance read at points, or averaged over bins".into(),
        about: "CIEDE2000 under D65, compared with many points in every nanometer, at normal incidence and \
                with a white mirror as white, in bins of 380..730 nm. Beaten by: how many smaller numbers of \
                bands have a smaller error in the same way. Times are those of a reflectance of so many \
                bands."
            .into(),
        columns: vec![
            Column::key("thickness_nm", "thickness, nm"),
            Column::key("way", "way"),
            Column::key("bands", "bands"),
            Column::figure("de2000", "CIEDE2000"),
            Column::figure("beaten_by", "beaten by"),
            TIME,
        ],
        rows,
    }
}

struct Truth {
    thickness_nm: f32,
    lab: [f64; 3],
    white: [f64; 3],
}

impl Truth {
    fn new(thickness_nm: f32, points: usize) -> Self {
        let (cmf, power) = (Eye::Cie1931.on_cie_grid(), &world().light("D65").power);
        let lit = Lit::new(&cmf, power, for_y_100(&cmf, power));
        let soap = [1.0, SOAP.into(), 1.0];
        let reflects = (0..NODES).map(|k| {
            let [s, p] =
                mean(nm(k) - 0.5, nm(k) + 0.5, points, |nm| airy(soap, thickness_nm.into(), nm, 1.0));
            0.5 * (s + p)
        });
        Truth { thickness_nm, lab: lit.lab(&reflects.collect::<Vec<f64>>()), white: lit.white }
    }
}

/// A film in a number of bands, by each of the two ways.
struct Look {
    bands: usize,
    de2000: [f64; 2],
    ns: [f64; 2],
}

const WAYS: [&str; 2] = ["points", "means"];

fn of<const N: usize>(truth: &Truth, runs: usize) -> Look {
    let eye: Observer<3, N, Factor, Bins<380, 730>> =
        CIE_1931.under(&D65.fine()).fold(Curve::Spline).with_white_y(100.0);
    let film = ThinFilm::new([1.0, SOAP, 1.0], truth.thickness_nm);
    let points = || -> Reflectance<N> {
        let film = black_box(film);
        Reflectance::at_centers(|nm| film.at(nm, 1.0).iter().map(|shares| 0.5 * shares.reflected).sum())
    };
    let means = || -> Reflectance<N> { black_box(film).reflectance(1.0) };
    let seen = |spectrum| lab(eye.sees(&spectrum).map(f64::from), truth.white);
    Look {
        bands: N,
        de2000: [points(), means()].map(|spectrum| de2000(truth.lab, seen(spectrum))),
        ns: [nanoseconds(runs, points), nanoseconds(runs, means)],
    }
}
