//! Compares methods that make a spectrum from RGB: how well the color is reproduced, how the spectrum looks
//! under other lamps, and how much of wide gamuts has one.

use crate::cells::{bytes as of_bytes, priced, with_price};
use crate::clock::nanoseconds;
use crate::gamuts;
use crate::report::{Cell, Column, Table};
use model::csv::table;
use model::delta_e::de2000;
use model::lab::lab;
use nanospectra::color::{EncodedRgb, Rgb, Srgb, Xyz};
use nanospectra::light::{A, D65, FL2, FL11, LED_B3};
use nanospectra::matter::CES;
use nanospectra::observer::CIE_1931;
use nanospectra::upsample::{
    Basis, CubicStart, LinearStart, QuinticStart, Sigmoid, Smits, StartMap, Viewing,
};
use nanospectra::{Curve, Factor, Grid, Nodes, Observer, Reflectance};
use nanospectra_hard::yardstick::product::rgb_product;
use rgb2spec::RGB2Spec;
use rgb2spec::optimize::{gamut::Gamut, optimize};
use std::hint::black_box;

/// The grid on which colors are compared, and the grid for which costs are given.
type Wide = Nodes<380, 780>;
type Few = Nodes<400, 700>;
const WIDE: usize = 81;
const FEW: usize = 31;

/// The cells along an edge of the table of `rgb2spec`.
const CELLS: usize = 16;

const LAMPS: [(&str, &str); 4] = [
    ("a_de2000", "under A: mean"),
    ("fl2_de2000", "FL2"),
    ("fl11_de2000", "FL11"),
    ("led_b3_de2000", "LED-B3"),
];

pub fn tables(runs: usize) -> Vec<Table> {
    let mut columns = vec![
        Column::key("method", "method"),
        Column::figure("bytes", "bytes"),
        Column::figure("mean_de2000", "there and back: mean CIEDE2000"),
        Column::figure("max_de2000", "max"),
        Column::figure("wrong_codes_percent", "wrong codes, %"),
    ];
    columns.extend(LAMPS.map(|(id, heading)| Column::figure(id, heading)));
    let study = Study::new();
    let samples = study.samples.len();
    let methods = Table {
        id: "upsample",
        title: "From sRGB to reflectances".into(),
        about: format!(
            "There and back: every 15th code of each component, on {WIDE} bands of 380..780 nm under D65. \
             Under other lamps: the {samples} of the 99 samples that are within sRGB, each compared with the \
             spectrum that is made of its RGB, with the lamp as white. The product of RGB makes no spectrum; \
             it multiplies the lamp's RGB and the surface's. Bytes, instructions and times are those of a \
             color on {FEW} bands of 400..700 nm, and include what is precomputed for them."
        ),
        columns: with_price(columns),
        rows: study.rows(runs),
    };
    vec![methods, gamuts::table()]
}

fn viewing<const N: usize, G: Grid>() -> Viewing<N, G> {
    Viewing::new(&CIE_1931.under(&D65.fine()).fold(Curve::Step))
}

fn wide(xyz: [f32; 3]) -> [f64; 3] {
    xyz.map(f64::from)
}

struct Study {
    viewing: Viewing<WIDE, Wide>,
    lamps: [Observer<3, WIDE, Factor, Wide>; 4],
    /// The samples within sRGB: the reflectance of each, and its RGB under D65.
    samples: Vec<(Reflectance<WIDE, Wide>, Rgb<Srgb>)>,
}

type Method<'a> = &'a dyn Fn(Rgb<Srgb>) -> Reflectance<WIDE, Wide>;

impl Study {
    fn new() -> Self {
        let viewing: Viewing<WIDE, Wide> = viewing();
        let lamps = [A.fine(), FL2.fine(), FL11.fine(), LED_B3.fine()]
            .map(|light| CIE_1931.under(&light).fold(Curve::Step).with_white_y(100.0));
        let samples = CES.iter().map(|sample| {
            let real: Reflectance<WIDE, Wide> = sample.resample();
            (real, viewing.rgb(&real))
        });
        let samples = samples.filter(|(_, rgb)| rgb.in_gamut()).collect();
        Study { viewing, lamps, samples }
    }

    fn rows(&self, runs: usize) -> Vec<Vec<Cell>> {
        let few: Viewing<FEW, Few> = viewing();
        let mut rows = Vec::new();
        let row = |name: &str, bytes: usize, word: &str, time: f64, method: Method<'_>| {
            let mut row = vec![Cell::key(name), of_bytes(bytes)];
            row.extend(self.there_and_back(method));
            row.extend(self.under_lamps(|rgb, lamp| wide(lamp.sees(&method(rgb)))));
            priced(row, word, time)
        };
        let pixel = Rgb::<Srgb>::new(0.2, 0.4, 0.7);
        macro_rules! sigmoid {
            ($start:ty, $name:literal, $file:literal, $word:literal) => {
                let time = self.time_of_sigmoid::<$start>(&few, runs);
                let (sigmoid, few) = (
                    Sigmoid::<WIDE, Wide, Srgb, $start>::new(&self.viewing),
                    Sigmoid::<FEW, Few, Srgb, $start>::new(&few),
                );
                let bytes = size_of_val(&few) + bytes_of($file);
                rows.push(row($name, bytes, $word, time, &|rgb| sigmoid.reflectance(rgb).spectrum.on_grid()));
            };
        }
        sigmoid!(LinearStart, "Sigmoid, Linear", "upsample/start_linear.csv", "upsample-linear-31");
        sigmoid!(CubicStart, "Sigmoid, Cubic", "upsample/start_cubic.csv", "upsample-cubic-31");
        sigmoid!(QuinticStart, "Sigmoid, Quintic", "upsample/start_quintic.csv", "upsample-quintic-31");
        let (basis, few_basis) = (Basis::new(&self.viewing), Basis::new(&few));
        let time = nanoseconds(runs, || few_basis.reflectance(black_box(pixel)));
        rows.push(row("Basis", size_of_val(&few_basis), "upsample-basis-31", time, &|rgb| {
            basis.reflectance(rgb)
        }));
        let (smits, few_smits) = (Smits::<WIDE, Wide>::new(), Smits::<FEW, Few>::new());
        let time = nanoseconds(runs, || few_smits.reflectance(black_box(pixel)));
        rows.push(row("Smits", size_of_val(&few_smits), "upsample-smits-31", time, &|rgb| {
            smits.reflectance(rgb)
        }));
        if let Ok(peer) = optimize(Gamut::SRGB, CELLS) {
            let time = nanoseconds(runs, || by_table::<FEW, Few>(&peer, black_box(pixel)));
            let mut file = Vec::new();
            let bytes = peer.to_writer(&mut file).map_or(0, |()| file.len());
            rows.push(row(&format!("rgb2spec, {CELLS}^3 cells"), bytes, "", time, &|rgb| {
                by_table(&peer, rgb)
            }));
        }
        rows.push(self.product(runs));
        rows
    }

    fn time_of_sigmoid<M: StartMap>(&self, few: &Viewing<FEW, Few>, runs: usize) -> f64 {
        let sigmoid = Sigmoid::<FEW, Few, Srgb, M>::new(few);
        let colors: Vec<Rgb<Srgb>> = self.samples.iter().map(|(_, rgb)| *rgb).collect();
        let mut turn = colors.iter().cycle();
        nanoseconds(runs, || {
            let rgb = turn.next().copied().unwrap_or(Rgb::new(0.5, 0.5, 0.5));
            sigmoid.reflectance(black_box(rgb)).spectrum.on_grid::<FEW, Few>()
        })
    }

    /// Makes spectra from RGB and computes their RGB again: the mean and the largest CIEDE2000, and the
    /// percentage of codes that are wrong.
    fn there_and_back(&self, method: Method<'_>) -> [Cell; 3] {
        let (mut sum, mut most, mut wrong, mut count) = (0.0, 0.0_f64, 0.0, 0.0);
        let codes = || (0..=255u8).step_by(15);
        for code in codes().flat_map(|r| codes().flat_map(move |g| codes().map(move |b| [r, g, b]))) {
            let rgb = EncodedRgb::<Srgb>::from_u8(code).decode();
            let spectrum = method(rgb);
            let off = f64::from(self.viewing.delta_e(rgb, &spectrum));
            (sum, most, count) = (sum + off, most.max(off), count + 1.0);
            wrong += f64::from(u8::from(self.viewing.rgb(&spectrum).encode().to_u8() != code));
        }
        [sum / count, most, 100.0 * wrong / count].map(Cell::figure)
    }

    /// Returns the mean CIEDE2000 under each of the lamps between the samples and what is `made` of their
    /// RGB.
    fn under_lamps(
        &self,
        made: impl Fn(Rgb<Srgb>, &Observer<3, WIDE, Factor, Wide>) -> [f64; 3],
    ) -> [Cell; 4] {
        self.lamps.each_ref().map(|lamp| {
            let white = wide(lamp.sees(&Reflectance::flat(1.0)));
            let off = |(real, rgb): &(Reflectance<WIDE, Wide>, Rgb<Srgb>)| {
                de2000(lab(wide(lamp.sees(real)), white), lab(made(*rgb, lamp), white))
            };
            Cell::figure(self.samples.iter().map(off).sum::<f64>() / self.samples.len() as f64)
        })
    }

    fn product(&self, runs: usize) -> Vec<Cell> {
        let light_of = |lamp: &Observer<3, WIDE, Factor, Wide>| {
            Rgb::<Srgb>::from_xyz(Xyz::from(lamp.sees(&Reflectance::flat(1.0)))).to_array()
        };
        let (light, pixel) = ([1.2, 0.9, 0.4], [0.2, 0.4, 0.7]);
        let time = nanoseconds(runs, || rgb_product(black_box(light), black_box(pixel)));
        let mut row = vec![
            Cell::key("product of RGB"),
            of_bytes(size_of_val(&light)),
            Cell::Nothing,
            Cell::Nothing,
            Cell::Nothing,
        ];
        row.extend(self.under_lamps(|rgb, lamp| wide(rgb_product(light_of(lamp), rgb.to_array()))));
        priced(row, "rgb-product", time)
    }
}

fn by_table<const N: usize, G: Grid>(table: &RGB2Spec, rgb: Rgb<Srgb>) -> Reflectance<N, G> {
    let coefficients = table.fetch(rgb.to_array());
    Reflectance::at_centers(|nm| rgb2spec::eval_precise(coefficients, nm))
}

/// Returns the bytes that the numbers of a table of the crate take as f32.
fn bytes_of(file: &str) -> usize {
    let table = table(file);
    size_of::<f32>() * table.len() * (table.names().len() + 1)
}
