//! 8-bit sRGB colors, upsampled and looked at again: in plain `cargo test` every fifth level of each channel,
//! and all 2^24 colors (`cargo xtask full` does so for the default map) with
//!
//!     NANOSPECTRA_STRIDE=1 cargo test --release -p nanospectra --test upsample all::
#![cfg(feature = "libm")]

use crate::LIGHT;
use model::delta_e::de2000;
use model::lab::lab;
use nanospectra::color::{EncodedRgb, Rgb, Srgb};
use nanospectra::observer::CIE_1931;
use nanospectra::upsample::{
    CubicStart, LinearStart, QuinticStart, Sigmoid, SigmoidReflectance, Solved, StartMap, Status, Viewing,
};
use nanospectra::{Bins, Curve, Factor, Grid, Nodes, Observer};
use std::sync::atomic::{AtomicU32, Ordering};

/// What a sweep found.
#[derive(Clone, Copy, Debug, Default)]
struct Findings {
    colors: u64,
    /// 8-bit codes that did not come back.
    wrong: u64,
    /// Colors whose status is not `Exact`.
    unsolved: u64,
    /// Values outside 0..=1, and grays that are not constant.
    impossible: u64,
    sum: f64,
    worst: f64,
    worst_at: u32,
}

impl Findings {
    fn join(self, other: Findings) -> Findings {
        // NaN is worse than any number.
        let first = self.worst >= other.worst || self.worst.is_nan();
        Findings {
            colors: self.colors + other.colors,
            wrong: self.wrong + other.wrong,
            unsolved: self.unsolved + other.unsolved,
            impossible: self.impossible + other.impossible,
            sum: self.sum + other.sum,
            worst: if first { self.worst } else { other.worst },
            worst_at: if first { self.worst_at } else { other.worst_at },
        }
    }
}

/// The eye in f64, from the weights the crate ships.
struct Model<const N: usize> {
    rows: [[f64; N]; 3],
    white: [f64; 3],
    to_xyz: [[f64; 3]; 3],
    from_xyz: [[f64; 3]; 3],
}

impl<const N: usize> Model<N> {
    /// Of an eye with Y = 1 for white.
    fn new<G: Grid>(eye: &Observer<3, N, Factor, G>) -> Self {
        let rows = eye.weights().map(|row| row.map(f64::from));
        let white = rows.map(|row| row.iter().sum());
        let [x, y, z]: [f64; 3] = white;
        let space =
            model::rgb::RgbSpace { white: [x / (x + y + z), y / (x + y + z)], ..*model::rgb::named("sRGB") };
        let (to_xyz, from_xyz) = (space.rgb_to_xyz(), space.xyz_to_rgb());
        Model { rows, white: white.map(|w| w / y), to_xyz, from_xyz }
    }

    fn sees(&self, spectrum: &[f32; N]) -> [f64; 3] {
        self.rows.each_ref().map(|row| row.iter().zip(spectrum).map(|(w, s)| w * f64::from(*s)).sum())
    }
}

/// IEC 61966-2-1 in f64.
fn linear(code: u8) -> f64 {
    let code = f64::from(code) / 255.0;
    if code <= 0.04045 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }
}

fn code(linear: f64) -> i32 {
    let code = if linear <= 0.0031308 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
    (255.0 * code).round() as i32
}

/// Eight neighbors in blue at a time.
fn look<const N: usize, G: Grid, M: StartMap>(
    model: &Model<N>,
    sigmoid: &Sigmoid<N, G, Srgb, M>,
    codes: &[[u8; 3]; 8],
    findings: &mut Findings,
) {
    let asked: [Rgb<Srgb>; 8] = codes.map(|c| EncodedRgb::<Srgb>::from_u8(c).decode());
    let solved: [Solved<SigmoidReflectance>; 8] = sigmoid.reflectance_8(&asked);
    for (code3, solved) in codes.iter().zip(solved) {
        let spectrum = solved.spectrum.on_grid::<N, G>();
        findings.colors += 1;
        findings.unsolved += u64::from(solved.status != Status::Exact);
        let possible = spectrum.values().iter().all(|s| (0.0..=1.0).contains(s));
        let [r, g, b] = *code3;
        let gray = r == g && g == b;
        let first = EncodedRgb::<Srgb>::from_u8(*code3).decode().r;
        let constant = spectrum.values().iter().all(|s| s.to_bits() == first.to_bits());
        findings.impossible += u64::from(!possible || gray && !constant);
        let given = model.sees(spectrum.values());
        let back = model::linear::apply(model.from_xyz, given);
        findings.wrong += u64::from(back.map(code) != code3.map(i32::from));
        let wanted = model::linear::apply(model.to_xyz, code3.map(linear));
        let off = de2000(lab(wanted, model.white), lab(given, model.white));
        findings.sum += off;
        if off > findings.worst || off.is_nan() {
            findings.worst = off;
            findings.worst_at = u32::from_be_bytes([0, r, g, b]);
        }
    }
}

/// Every `step`th red, green and blue (and the last one), on all cores.
fn sweep<const N: usize, G: Grid + Sync + Send, M: StartMap + Sync>(step: usize) -> Findings {
    let eye = CIE_1931.under(&LIGHT).fold(Curve::Step).with_white_y(1.0);
    let (model, sigmoid) = (Model::new(&eye), Sigmoid::<N, G, Srgb, M>::new(&Viewing::new(&eye)));
    let levels: Vec<u8> = (0..=255u8).filter(|v| usize::from(*v) % step == 0 || *v == 255).collect();
    let mut blues = levels.clone();
    while !blues.len().is_multiple_of(8) {
        blues.push(254 - blues.len() as u8 % 8);
    }
    let next = AtomicU32::new(0);
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get());
    std::thread::scope(|scope| {
        let work = || {
            let mut findings = Findings::default();
            loop {
                let red = next.fetch_add(1, Ordering::Relaxed) as usize;
                let Some(r) = levels.get(red) else { return findings };
                for g in &levels {
                    for eight in blues.as_chunks::<8>().0 {
                        look(&model, &sigmoid, &eight.map(|b| [*r, *g, b]), &mut findings);
                    }
                }
            }
        };
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().fold(Findings::default(), |all, worker| all.join(worker.join().expect("a sweep")))
    })
}

fn hold(what: &str, found: Findings, allowed: f64) {
    println!(
        "{what}: {} colors, {} wrong codes, {} unsolved, {} impossible, mean {:.2e}, max {:.6} at #{:06x}",
        found.colors,
        found.wrong,
        found.unsolved,
        found.impossible,
        found.sum / found.colors as f64,
        found.worst,
        found.worst_at
    );
    assert_eq!((found.wrong, found.unsolved, found.impossible), (0, 0, 0), "{what}");
    assert!(found.worst <= allowed, "{what}: {} CIEDE2000", found.worst);
    // Of all colors: an allowance of twice what is needed would hide a loss.
    assert!(found.colors < 1 << 24 || found.worst > allowed / 2.0, "{what}: {} CIEDE2000", found.worst);
}

fn every_grid<M: StartMap + Sync>(map: &str, allowed: f64) {
    let sample = if cfg!(debug_assertions) { 15 } else { 5 };
    let step = std::env::var("NANOSPECTRA_STRIDE")
        .map_or(sample, |n| n.parse().expect("NANOSPECTRA_STRIDE: a number"));
    hold(&format!("31 nodes 400..700, {map}"), sweep::<31, Nodes<400, 700>, M>(step), allowed);
    hold(&format!("60 bins 400..700, {map}"), sweep::<60, Bins<400, 700>, M>(step), allowed);
    hold(&format!("81 nodes 380..780, {map}"), sweep::<81, Nodes<380, 780>, M>(step), allowed);
}

/// The largest CIEDE2000 that each map is allowed; half of it is what f32 sums leave of an exact solution.
const CUBIC: f64 = 0.00042;
const LINEAR: f64 = 0.00035;
const QUINTIC: f64 = 0.00034;

#[test]
fn the_8_bit_colors_come_back_as_their_codes_with_the_cubic_map() {
    every_grid::<CubicStart>("cubic", CUBIC);
}

#[test]
fn the_8_bit_colors_come_back_as_their_codes_with_the_linear_map() {
    every_grid::<LinearStart>("linear", LINEAR);
}

#[test]
fn the_8_bit_colors_come_back_as_their_codes_with_the_quintic_map() {
    every_grid::<QuinticStart>("quintic", QUINTIC);
}
