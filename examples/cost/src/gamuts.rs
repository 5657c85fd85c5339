//! How much of wide gamuts surfaces can have: by sigmoids, and by any spectrum at all.

use crate::report::{Cell, Column, Table};
use model::linear::{Matrix3, apply};
use model::rgb;
use model::solid::Solid;
use nanospectra::color::transfer::{SrgbTransfer, Transfer};
use nanospectra::color::{AcesCg, Bt2020, DisplayP3, ProPhoto, Rgb, RgbSpace};
use nanospectra::light::D65;
use nanospectra::observer::CIE_1931;
use nanospectra::upsample::{Sigmoid, Status, Viewing};
use nanospectra::{Curve, Factor, Grid, Nodes, Observer};

/// The colors along an edge of the cubes.
const EDGE: u8 = 17;

pub fn table() -> Table {
    Table {
        id: "gamuts",
        title: "How much of wide gamuts surfaces can have".into(),
        about: format!(
            "The percentage of a cube of {EDGE}^3 colors, encoded by the sRGB curve, under D65, which is also the \
             white of all four spaces here. A sigmoid: the status is exact, so that it comes within 0.002 \
             CIEDE2000. Any spectrum: the color is in the solid of object colors, without any tolerance, on the \
             same bands, or on 151 bands, every 3 nm from 380 to 830 nm."
        ),
        columns: vec![
            Column::key("space", "space"),
            Column::figure("sigmoid_31_percent", "31 bands: a sigmoid, %"),
            Column::figure("any_31_percent", "any spectrum"),
            Column::figure("sigmoid_81_percent", "81 bands: a sigmoid, %"),
            Column::figure("any_81_percent", "any spectrum"),
            Column::figure("any_percent", "every 3 nm: any spectrum, %"),
        ],
        rows: vec![
            row::<DisplayP3>("Display P3"),
            row::<Bt2020>("BT.2020"),
            row::<AcesCg>("ACEScg"),
            row::<ProPhoto>("ProPhoto RGB"),
        ],
    }
}

fn row<S: RgbSpace>(space: &str) -> Vec<Cell> {
    let [sigmoid_31, any_31] = shares::<31, Nodes<400, 700>, S>(true);
    let [sigmoid_81, any_81] = shares::<81, Nodes<380, 780>, S>(true);
    let [_, any] = shares::<151, Nodes<380, 830>, S>(false);
    let mut row = vec![Cell::key(space)];
    row.extend([sigmoid_31, any_31, sigmoid_81, any_81, any].map(Cell::figure));
    row
}

/// Returns the percentages of the cube that have a sigmoid, which are only counted if `with_sigmoids` is set,
/// and those that have any spectrum.
fn shares<const N: usize, G: Grid, S: RgbSpace>(with_sigmoids: bool) -> [f64; 2] {
    let eye: Observer<3, N, Factor, G> = CIE_1931.under(&D65.fine()).fold(Curve::Step).with_white_y(1.0);
    let sigmoid: Sigmoid<N, G, S> = Sigmoid::new(&Viewing::new(&eye));
    let [x, y, z] = eye.weights().map(|row| row.map(f64::from));
    let bands: Vec<[f64; 3]> = (0..N).map(|k| [x[k], y[k], z[k]]).collect();
    let (solid, to_xyz) = (Solid::new(&bands), rgb_to_xyz::<S>(&bands));
    let levels = || (0..EDGE).map(|k| SrgbTransfer::decode(f32::from(k) / f32::from(EDGE - 1)));
    let (mut by_sigmoid, mut by_any, mut all) = (0, 0, 0);
    for [r, g, b] in levels().flat_map(|r| levels().flat_map(move |g| levels().map(move |b| [r, g, b]))) {
        by_any += i32::from(solid.contains(apply(to_xyz, [r, g, b].map(f64::from))));
        by_sigmoid +=
            i32::from(with_sigmoids && sigmoid.reflectance(Rgb::new(r, g, b)).status == Status::Exact);
        all += 1;
    }
    [by_sigmoid, by_any].map(|count| 100.0 * f64::from(count) / f64::from(all))
}

/// Returns the matrix from linear RGB to X, Y and Z, in f64, with the white that the bands add up to.
fn rgb_to_xyz<S: RgbSpace>(bands: &[[f64; 3]]) -> Matrix3 {
    let [x, y, z] = [0, 1, 2].map(|c| bands.iter().map(|band| band[c]).sum::<f64>());
    let white = [x / (x + y + z), y / (x + y + z)];
    rgb::RgbSpace { name: "under D65", primaries: S::PRIMARIES, white }
        .rgb_to_xyz()
        .map(|row| row.map(|v| y * v))
}
