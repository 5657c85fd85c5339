//! What an eight-channel chip reaches as a light meter: a simulated AS7341 under every lamp of CIE 15,
//! calibrated on the 99 samples of CIE 224 under three lamps, with noise, full scale and whole counts. Prints
//! a table.

use model::allowed::check;
use model::noise::Noise;
use model::sensor::{self, wide};
use nanospectra::color::{Cct, Xyz};
use nanospectra::light;
use nanospectra::matter::CES;
use nanospectra::observer::{CIE_1931, KM};
use nanospectra::sensor::{BasicCounts, Calibration, DEFAULT_ALPHA, Fit, Reconstruction, chip::as7341};
use nanospectra::{Curve, Fine, Nodes, Observer, Power, const_unwrap};

/// The chip of the simulation: the converter ends at 18 000 counts after 50 ms.
const ATIME: u8 = 29;
const ASTEP: u16 = 599;
/// What a count stands for; shot noise of 10 000 counts is then 0.35 %.
const ELECTRONS_PER_COUNT: f64 = 8.0;
/// Noise of reading out, in counts.
const READ_NOISE: f64 = 2.0;
const SEED: u64 = 7341;
/// Counts per ms at unit gain for 1 W/m2/nm over 1 nm at the peak of a channel: any number would do, the
/// exposure follows.
const PER_WATT: f32 = 40.0;

/// Illuminance of the lamps, and what the perfect white on the chart has under them.
const LUX: f32 = 500.0;

/// What the chip reports of a light: gain chosen so that the brightest channel is at 30 to 90 % of full
/// scale.
fn measured(light: &Fine<Power>, noise: &mut Noise) -> BasicCounts<8> {
    let basic = as7341::NOMINAL.sees(light).map(|b| b * PER_WATT);
    let brightest = basic.iter().fold(0.0f32, |most, b| most.max(*b));
    for power in -1..=9 {
        let exposure = as7341::exposure(2f32.powi(power), ATIME, ASTEP);
        let share = brightest / exposure.per_count() / exposure.full_scale() as f32;
        if (0.30..0.90).contains(&share) {
            let counts = basic.map(|b| {
                let counts = f64::from(b / exposure.per_count());
                let deviation = (counts / ELECTRONS_PER_COUNT + READ_NOISE * READ_NOISE).sqrt();
                (counts + deviation * noise.normal()).round().max(0.0) as u16
            });
            return exposure.basic_counts(&counts).expect("neither dark nor saturated");
        }
    }
    panic!("no gain suits {brightest}")
}

/// The lamps of CIE 15, on their 5 nm tables and on their 1 nm ones, at [`LUX`].
fn lamps() -> Vec<(String, Fine<Power>)> {
    let mut names: Vec<String> = (1..=12).map(|k| format!("FL{k}")).collect();
    names.extend((1..=15).map(|k| format!("FL3.{k}")));
    names.extend(["B1", "B2", "B3", "B4", "B5", "BH1", "RGB1", "V1", "V2"].map(|led| format!("LED-{led}")));
    names.extend(names.clone().into_iter().map(|name| format!("{name}_1NM")));
    names.extend((1..=5).map(|k| format!("HP{k}")));
    names.into_iter().map(|name| (lamp(&name), name)).map(|(lamp, name)| (name, lamp)).collect()
}

fn lamp(name: &str) -> Fine<Power> {
    let lamp = light::named(name).unwrap_or_else(|| panic!("no lamp {name}"));
    let [_, y, _] = CIE_1931.sees(&lamp);
    lamp * (LUX / KM / y)
}

fn xyz(light: &Fine<Power>) -> Xyz {
    Xyz::from(CIE_1931.sees(light)).scaled(KM)
}

/// The 297 patches: each sample under FL2, FL11 and LED-B3, its counts (with noise or without), its XYZ in
/// lux.
fn calibrated(mut report: impl FnMut(&Fine<Power>) -> BasicCounts<8>) -> Fit<8> {
    let mut fit = Fit::new();
    for name in ["FL2", "FL11", "LED-B3"] {
        let lamp = lamp(name);
        for sample in &CES {
            let patch = lamp * sample.fine();
            fit.add_relative(&report(&patch), xyz(&patch));
        }
    }
    fit
}

fn exactly(light: &Fine<Power>) -> BasicCounts<8> {
    BasicCounts::new(as7341::NOMINAL.sees(light).map(|b| b * PER_WATT))
}

/// The matrix by the shortest way for who has the responsivities: reconstruction and eye, folded while
/// compiling.
static BY_SPECTRUM: Calibration<8> = {
    type Grid = Nodes<380, 730>;
    let chip: Observer<8, 36, Power, Grid> = as7341::NOMINAL.fold(Curve::Step);
    let eye: Observer<3, 36, Power, Grid> = CIE_1931.fold(Curve::Step);
    const_unwrap!(Reconstruction::smooth(&chip, 0.95, DEFAULT_ALPHA)).seen_by(&eye).scaled(KM / PER_WATT)
};

/// Errors of lux and of CCT in per cent; no CCT for lights that are not near the locus.
fn errors(is: Xyz, got: Xyz) -> (f64, Option<f64>) {
    let near = |xyz: Xyz| match xyz.uv1960().map(|uv| uv.cct()) {
        Some(Cct::Near { cct_k, duv }) => Some((f64::from(cct_k), duv)),
        _ => None,
    };
    let lux = 100.0 * (f64::from(got.y) / f64::from(is.y) - 1.0);
    let cct = match near(is) {
        Some((is, duv)) if duv.abs() < 0.02 => {
            Some(near(got).map_or(100.0, |(got, _)| 100.0 * (got / is - 1.0)))
        }
        _ => None,
    };
    (lux, cct)
}

/// Sizes of errors.
#[derive(Default)]
struct Sizes(Vec<f64>);

impl Sizes {
    fn mean(&self) -> f64 {
        self.0.iter().sum::<f64>() / self.0.len() as f64
    }

    fn worst(&self) -> f64 {
        self.0.iter().fold(0.0, |worst, e| worst.max(*e))
    }
}

#[test]
fn an_as7341_measures_lux_and_cct_of_every_lamp_within_the_bar() {
    let mut noise = Noise(SEED);
    let fit = calibrated(|patch| measured(patch, &mut noise));
    let matrix = fit.solve().expect("297 patches");
    let noise_free = calibrated(exactly).solve().expect("297 patches");
    // What no combination of the channels can see: the color-matching functions less their projection.
    let columns = sensor::transposed(&wide(as7341::NOMINAL.weights()));
    let functions = sensor::transposed(&wide(CIE_1931.weights()));
    let projection = sensor::fit(&columns, &functions, &[1.0; 471]);
    println!("residual of the patches, relative to Y: {:?}", fit.residual_rms());
    println!(
        "| lamp | CCT, K | Duv | lux, % | CCT, % | lux without noise | CCT without noise | outside the span: X, Y, Z, % | \
         lux by reconstruction | CCT by reconstruction |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    let mut sizes: [[Sizes; 2]; 3] = Default::default();
    for (name, light) in lamps() {
        let is = xyz(&light);
        let counts = measured(&light, &mut noise);
        let outcomes = [
            errors(is, matrix.xyz(&counts).expect("a color")),
            errors(is, noise_free.xyz(&exactly(&light)).expect("a color")),
            errors(is, BY_SPECTRUM.xyz(&counts).expect("a color")),
        ];
        let values = wide(&[*light.values()]).remove(0);
        let seen: Vec<f64> =
            sensor::transposed(&columns).iter().map(|row| sensor::dot(row, &values)).collect();
        let outside: Vec<f64> = projection
            .iter()
            .zip(sensor::transposed(&functions))
            .map(|(row, function)| 100.0 * (1.0 - sensor::dot(row, &seen) / sensor::dot(&function, &values)))
            .collect();
        let (cct_k, duv) = is.uv1960().and_then(|uv| uv.cct().near()).expect("a white");
        let shown = |cct: Option<f64>| cct.map_or(String::from("-"), |cct| format!("{cct:.2}"));
        println!(
            "| {name} | {cct_k:.0} | {duv:.4} | {:.2} | {} | {:.2} | {} | {:.1} {:.1} {:.1} | {:.2} | {} |",
            outcomes[0].0,
            shown(outcomes[0].1),
            outcomes[1].0,
            shown(outcomes[1].1),
            outside[0],
            outside[1],
            outside[2],
            outcomes[2].0,
            shown(outcomes[2].1)
        );
        for ([all_lux, all_cct], (lux, cct)) in sizes.iter_mut().zip(outcomes) {
            all_lux.0.push(lux.abs());
            all_cct.0.extend(cct.map(f64::abs));
        }
    }
    for (what, [lux, cct]) in ["fit", "fit, no noise", "reconstruction"].iter().zip(&sizes) {
        println!(
            "{what}: lux {:.2} % in the mean, {:.2} at worst; CCT {:.2} and {:.2}, {} lamps",
            lux.mean(),
            lux.worst(),
            cct.mean(),
            cct.worst(),
            lux.0.len()
        );
    }
    let [[lux, cct], _, [spectral_lux, spectral_cct]] = &sizes;
    assert_eq!((lux.0.len(), cct.0.len()), (77, 77));
    for (what, error) in [
        ("residual of patches, % of Y", 100.0 * f64::from(fit.residual_rms()[1])),
        ("AS7341, lux in the mean, %", lux.mean()),
        ("AS7341, lux at worst, %", lux.worst()),
        ("AS7341, CCT in the mean, %", cct.mean()),
        ("AS7341, CCT at worst, %", cct.worst()),
        ("AS7341 by its spectrum, lux in the mean, %", spectral_lux.mean()),
        ("AS7341 by its spectrum, lux at worst, %", spectral_lux.worst()),
        ("AS7341 by its spectrum, CCT in the mean, %", spectral_cct.mean()),
        ("AS7341 by its spectrum, CCT at worst, %", spectral_cct.worst()),
    ] {
        let mut bar = check(what);
        bar.value("77 lamps", error, 0.0);
        bar.tight(1);
    }
}

#[test]
fn eight_channels_to_xyz_are_a_tenth_of_a_difference_off() {
    // Row 51: every second sample under D65 to calibrate with, the others to judge.
    let d65 = lamp("D65");
    let seen = |sample: usize| d65 * CES[sample].fine();
    let mut fit = Fit::<8>::new();
    (0..99).step_by(2).map(seen).for_each(|patch| fit.add_relative(&exactly(&patch), xyz(&patch)));
    let matrix = fit.solve().expect("50 patches");
    let lab = |xyz: Xyz| {
        let white = CIE_1931.sees(&d65).map(|v| f64::from(v * KM));
        model::lab::lab(xyz.to_array().map(f64::from), white)
    };
    let mut differences = Sizes::default();
    for patch in (1..99).step_by(2).map(seen) {
        let got = matrix.xyz(&exactly(&patch)).expect("a color");
        differences.0.push(model::delta_e::de2000(lab(got), lab(xyz(&patch))));
    }
    let mut check = check("8 channels to XYZ, CIEDE2000");
    check.value("mean", differences.mean(), 0.0);
    check.value("worst, a fifth", differences.worst() / 5.0, 0.0);
    check.tight(2);
}
