//! How far the errors of the elementary functions change colors that are computed with them.

use super::backends::{Math, error_of, of_each};
use crate::cells::{in_order, priced, with_price};
use crate::clock::nanoseconds;
use crate::nanometers::{Lit, NODES, for_y_100, nm, world};
use crate::report::{Cell, Column, Table};
use model::cct::cct_codata;
use model::chromaticity::uv1960;
use model::delta_e::de2000;
use model::fresnel::reflectances;
use model::lab::lab;
use model::planck::radiance;
use model::tables::Observer;
use model::transfer::srgb_encode;
use nanospectra::color::transfer::{SrgbTransfer, Transfer};
use nanospectra::color::{EncodedRgb, Lab, ParametricFactors, Rgb, Srgb, Xyz, ciede2000_with};
use nanospectra::light::blackbody_with;
use nanospectra::matter::Dielectric;
use std::hint::black_box;

pub fn table(runs: usize) -> Table {
    let trials = Trials::new();
    let mut rows: Vec<Vec<Cell>> = of_each!(of, &trials, runs);
    in_order(&mut rows, NAMES.iter().map(|name| name.0));
    rows.push(fresnel(runs));
    let columns = with_price(vec![
        Column::key("composite", "what"),
        Column::key("backend", "backend"),
        Column::key("unit", "error in"),
        Column::figure("max_error", "largest error"),
    ]);
    Table {
        id: "math-composites",
        title: "What the functions do to color".into(),
        about:
            "The errors against f64. Black body: the color temperature of its 1 nm sums, for 1000..50 000 \
                K. Lab: the samples under all lamps. CIEDE2000: pairs of neighbors among these. sRGB: \
                signals of 0..1, in 8-bit codes before they are rounded. Fresnel: dielectrics of index 1.1 \
                to 4 at cosines of 1/64 to 1; the formula needs only square roots, which the core computes."
                .into(),
        columns,
        rows,
    }
}

/// The name of each computation, the name of its count on record, and the unit of its error.
const NAMES: [(&str, &str, &str); 4] = [
    ("black body at a wavelength", "planck", "mired"),
    ("XYZ to Lab", "lab", "CIEDE2000"),
    ("CIEDE2000 of two Lab", "ciede2000", "CIEDE2000"),
    ("encoding an sRGB pixel", "srgb", "8-bit codes"),
];

/// Returns the name of a count on record. CIEDE2000 is counted with the default backend alone, under a name
/// without a backend.
fn on_record(word: &str, backend: &str) -> String {
    match (word, backend) {
        ("ciede2000", "Portable") => word.to_owned(),
        _ => format!("math-{word}-{}", backend.to_lowercase()),
    }
}

/// The inputs for all backends, and the right results.
struct Trials {
    cmf: [Vec<f64>; 3],
    /// Black bodies: the temperature in K, and the mired of the exact spectrum.
    bodies: Vec<(f32, f64)>,
    /// Surfaces: XYZ, the white, and the exact Lab.
    surfaces: Vec<(Xyz, Xyz, [f64; 3])>,
}

impl Trials {
    fn new() -> Self {
        let cmf = Observer::Cie1931.on_cie_grid();
        let bodies = (0..=40).map(|k| (1000.0 * 50f64.powf(f64::from(k) / 40.0)) as f32);
        let bodies = bodies.map(|kelvin| {
            let power: Vec<f64> = (0..NODES).map(|k| radiance(nm(k), kelvin.into())).collect();
            (kelvin, mired(&cmf, &power))
        });
        let world = world();
        let surfaces = world.lights.iter().flat_map(|light| {
            let lit = Lit::new(&cmf, &light.power, for_y_100(&cmf, &light.power));
            let single = |xyz: [f64; 3]| Xyz::from(xyz.map(|value| value as f32));
            let exact = |xyz: Xyz| xyz.to_array().map(f64::from);
            let white = single(lit.white);
            let ces = world.ces.iter().map(move |sample| {
                let xyz = single(lit.sees(sample));
                (xyz, white, lab(exact(xyz), exact(white)))
            });
            // A light without any blue has no Lab.
            ces.filter(|(.., lab)| lab.iter().all(|part| part.is_finite())).collect::<Vec<_>>()
        });
        Trials { bodies: bodies.collect(), surfaces: surfaces.collect(), cmf }
    }
}

fn mired(cmf: &[Vec<f64>; 3], power: &[f64]) -> f64 {
    let xyz = cmf.each_ref().map(|row| row.iter().zip(power).map(|(weight, power)| weight * power).sum());
    1e6 / cct_codata(uv1960(xyz)).cct_k
}

fn of<M: Math>(backend: &'static str, trials: &Trials, runs: usize) -> Vec<Vec<Cell>> {
    let mut names = NAMES.into_iter();
    let mut all = Vec::new();
    let mut add = |error: f64, time: f64| {
        let Some((name, word, unit)) = names.next() else { return };
        let row = vec![Cell::key(name), Cell::key(backend), Cell::key(unit), error_of(error)];
        all.push(priced(row, &on_record(word, backend), time));
    };
    let shifts = trials.bodies.iter().map(|&(kelvin, exact)| {
        let power: Vec<f64> = (0..NODES).map(|k| blackbody_with::<M>(nm(k) as f32, kelvin).into()).collect();
        (mired(&trials.cmf, &power) - exact).abs()
    });
    add(largest(shifts), nanoseconds(runs, || blackbody_with::<M>(black_box(555.0), black_box(2856.0))));
    let wide = |lab: Lab| [lab.l, lab.a, lab.b].map(f64::from);
    let differences = trials.surfaces.iter().map(|(xyz, white, exact)| {
        xyz.lab_with::<M>(*white).map_or(f64::INFINITY, |lab| de2000(*exact, wide(lab)))
    });
    let (xyz, white) = (Xyz::new(30.0, 20.0, 10.0), Xyz::new(95.0, 100.0, 108.0));
    add(largest(differences), nanoseconds(runs, || black_box(xyz).lab_with::<M>(black_box(white))));
    let single = |lab: [f64; 3]| {
        let [l, a, b] = lab.map(|part| part as f32);
        Lab::new(l, a, b)
    };
    let pairs = trials.surfaces.windows(2).map(|two| (single(two[0].2), single(two[1].2)));
    let differences = pairs.map(|(one, other)| {
        let got = ciede2000_with::<M>(one, other, ParametricFactors::default());
        (f64::from(got) - de2000(wide(one), wide(other))).abs()
    });
    let (one, other) = (Lab::new(50.0, 2.6772, -79.7751), Lab::new(52.0, 3.0, -82.7485));
    add(
        largest(differences),
        nanoseconds(runs, || {
            ciede2000_with::<M>(black_box(one), black_box(other), ParametricFactors::default())
        }),
    );
    let signals = (0..=100_000u32).map(|k| k as f32 / 100_000.0);
    let codes = signals.map(|signal| {
        255.0 * (f64::from(SrgbTransfer::encode_with::<M>(signal)) - srgb_encode(signal.into())).abs()
    });
    let pixel = Rgb::<Srgb>::new(0.2, 0.4, 0.8);
    let encode = || -> EncodedRgb<Srgb> { black_box(pixel).encode_with::<SrgbTransfer, M>() };
    add(largest(codes), nanoseconds(runs, encode));
    all
}

/// Returns the largest error. NaN counts as larger than any number.
fn largest(errors: impl Iterator<Item = f64>) -> f64 {
    errors.max_by(f64::total_cmp).unwrap_or(f64::NAN)
}

fn fresnel(runs: usize) -> Vec<Cell> {
    let angles = (1..=64u8).map(|k| f32::from(k) / 64.0);
    let errors = angles.flat_map(|cos| {
        (11..=40u8).map(move |tenths| {
            let eta = f32::from(tenths) / 10.0;
            let (s, p) = reflectances([eta.into(), 0.0], cos.into());
            let got = Dielectric::new(eta).fresnel(cos).unpolarized();
            (f64::from(got) / (0.5 * (s + p)) - 1.0).abs()
        })
    });
    let time = nanoseconds(runs, || Dielectric::new(black_box(1.5)).fresnel(black_box(0.6)).unpolarized());
    let row = vec![
        Cell::key("reflectance by Fresnel"),
        Cell::key("any"),
        Cell::key("shares of it"),
        Cell::figure(largest(errors)),
    ];
    priced(row, "math-fresnel", time)
}
