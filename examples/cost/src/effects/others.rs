//! Effects that programs often leave out without saying so.

use super::scenes::LAMPS;
use crate::cells::{RANGE, range};
use crate::report::{Cell, Column, Table};
use model::delta_e::de2000;
use model::lab::lab;
use nanospectra::color::Xyz;
use nanospectra::light;
use nanospectra::matter::{CES, Dielectric, Glass, Mirror, N_SF11, Polarizer};
use nanospectra::observer::CIE_1931;
use nanospectra::path::{IntoPart, Scene};
use nanospectra::sensor::DeadTime;
use nanospectra::{Curve, Light, Nodes, Observer, Power, Reflectance};

type Grid = Nodes<380, 780>;
const N: usize = 81;

pub fn table() -> Table {
    let mut columns = vec![Column::key("effect", "left out"), Column::key("case", "where")];
    columns.extend(RANGE);
    columns.push(Column::figure("more_multiply_adds", "more multiply-adds"));
    let rooms = Rooms::new();
    Table {
        id: "effects-others",
        title: "Effects that are easily forgotten".into(),
        about: format!(
            "CIEDE2000 between the color with the effect and without it, on {N} bands, over {}. The white is \
             that of the bare lamp. The counter sees the 99 samples under each lamp; its X, Y and Z of white \
             are right, since it was calibrated on white.",
            LAMPS.join(", ")
        ),
        columns,
        rows: rooms.rows(),
    }
}

/// The lamps, and the eye that looks.
struct Rooms {
    eye: Observer<3, N, Power, Grid>,
    lamps: Vec<Light<N, Grid>>,
}

impl Rooms {
    fn new() -> Self {
        let named = LAMPS.iter().filter_map(|name| light::named(name));
        Rooms { eye: CIE_1931.fold(Curve::Spline), lamps: named.map(|lamp| lamp.resample()).collect() }
    }

    /// Returns the difference between two factors under each lamp, and that one costs no more than the other.
    fn between(&self, with: &Reflectance<N, Grid>, without: &Reflectance<N, Grid>) -> (Vec<f64>, Cell) {
        let of_lamp = |lamp: &Light<N, Grid>| {
            let white = self.eye.sees(lamp).map(f64::from);
            let [one, other] =
                [with, without].map(|share| lab(self.eye.sees(lamp.through(share)).map(f64::from), white));
            de2000(one, other)
        };
        (self.lamps.iter().map(of_lamp).collect(), Cell::count(Some(0)))
    }

    fn rows(&self) -> Vec<Vec<Cell>> {
        let mut rows = Vec::new();
        let mut add = |effect: &str, case: &str, (differences, more): (Vec<f64>, Cell)| {
            let mut row = vec![Cell::key(effect), Cell::key(case)];
            row.extend(range(&differences));
            row.push(more);
            rows.push(row);
        };
        // Both mirrors stand at Brewster's angle for n = 1.5. The second is parallel to the first, or turned
        // by a quarter about the ray.
        let cos = 1.0 / 3.25_f32.sqrt();
        for (case, turns) in [("two panes in parallel, 56 degrees", 0.0), ("two panes, crossed", 0.25)] {
            let [first, second] = [0.0, turns].map(|axis| Mirror::dielectric(&[1.5; N], cos, axis));
            add("polarization", case, self.without_polarization(&first, &second));
        }
        let sheet = Polarizer::ideal(0.0);
        add("polarization", "two sheets in parallel", self.without_polarization(&sheet, &sheet));
        // Light passes both faces. The index is that of each wavelength, or that of the d line everywhere.
        let n_d = N_SF11.index(587.56).unwrap_or(1.0);
        for (degrees, cos) in [(0, 1.0), (60, 0.5)] {
            let face = |eta: f32| 1.0 - Dielectric::new(eta).fresnel(cos).unpolarized();
            let with = Reflectance::at_centers(|nm| face(N_SF11.index(nm).unwrap_or(n_d)));
            let without = Reflectance::flat(face(n_d));
            let case = format!("into N-SF11 and out again, {degrees} degrees");
            add("dispersion", &case, self.between(&(with * with), &(without * without)));
        }
        for degrees in [30u8, 60, 80] {
            let [with, without] = [f32::from(degrees).to_radians().cos(), 1.0].map(|cos| {
                let face = Reflectance::flat(1.0 - Dielectric::new(1.5).fresnel(cos).unpolarized());
                face * face
            });
            let case = format!("through a pane, {degrees} degrees");
            add("Fresnel at an angle", &case, self.between(&with, &without));
        }
        for percent in [1u8, 5, 20] {
            let case = format!("a counter, {percent} % of the time busy at white");
            add("dead time", &case, (self.dead_time(f32::from(percent) / 100.0), Cell::Nothing));
        }
        rows
    }

    fn without_polarization<'a, P: IntoPart<'a, N, Grid>>(&self, first: P, second: P) -> (Vec<f64>, Cell) {
        let mut scene: Scene<N, 2, Grid> = Scene::new();
        // The scene has room for two parts, so neither is refused.
        let _ = scene.push(first).and_then(|()| scene.push(second));
        let without = scene.leaving_out(0).leaving_out(1);
        let difference = |lamp| f64::from(scene.difference(&without, &self.eye, lamp));
        let more = scene.price().multiply_adds - without.price().multiply_adds;
        (self.lamps.iter().map(difference).collect(), Cell::count(u32::try_from(more).ok()))
    }

    /// Returns the errors of three channels that count X, Y and Z. None of them corrects for its dead time,
    /// and each is scaled so that white is right.
    fn dead_time(&self, busy: f32) -> Vec<f64> {
        let of_lamp = |lamp: &Light<N, Grid>| {
            let white = self.eye.sees(lamp);
            // White arrives at such a rate that the counter is busy for this share of the time.
            let counter = DeadTime::new(busy / (1.0 - busy));
            let counted =
                |channel: f32, white: f32| counter.counted(channel / white) / counter.counted(1.0) * white;
            let samples = CES.iter().map(|sample| {
                let sample: Reflectance<N, Grid> = sample.resample();
                let seen = self.eye.sees(lamp.onto(&sample));
                let Xyz { x, y, z } = Xyz::from(seen);
                let [wx, wy, wz] = white;
                let read = [counted(x, wx), counted(y, wy), counted(z, wz)];
                let white = white.map(f64::from);
                de2000(lab(seen.map(f64::from), white), lab(read.map(f64::from), white))
            });
            samples.collect::<Vec<f64>>()
        };
        self.lamps.iter().flat_map(of_lamp).collect()
    }
}
