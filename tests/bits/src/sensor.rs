//! From counts to colors: readings, calibrations, and the same in integers.

use super::colors::WHITE;
use super::hash::{Hash, Random};
use core::array::from_fn;
use nanospectra::color::Cct;
use nanospectra::math::{Fast, Math, Portable};
use nanospectra::observer::{CIE_1931, Curve, Observer};
use nanospectra::sensor::fixed::{FixedCct, FixedMeter, FixedObserver, FixedXyz};
use nanospectra::sensor::{
    AutoExposure, BasicCounts, Calibration, Count, Drift, Exposure, Fit, Flicker, LightFlickermeter, Meter,
    Noise, ReadingError, Reconstruction, amplitude_at,
    chip::{as7341, tcs3472},
    nonnegative_spectrum, stroboscopic_visibility_with,
};
use nanospectra::{Light, Nodes, Power, const_unwrap};

pub fn run(report: &mut impl FnMut(&str, u32)) {
    report("readings", Hash::of(readings));
    report("fixed", Hash::of(fixed));
    report("reconstructions", Hash::of(reconstructions));
    report("fits", Hash::of(fits));
    report("noise-flicker", Hash::of(noise_flicker));
    report("visible-flicker", Hash::of(visible_flicker));
}

/// Random counts of three chips, from nearly dark to saturated, through random calibrations to colors.
pub fn readings(hash: &mut Hash) {
    let mut random = Random(0x5eed_c417);
    let exposures =
        [as7341::exposure(16.0, 29, 599), tcs3472::exposure(4.0, 0xc0), Exposure::new(0.5, 1.3, 0x00ff_ffff)];
    for exposure in &exposures {
        for k in 0..48 {
            // Every row of its own size; some weights are negative.
            let rows = from_fn(|_| random.bins().map(|weight: f32| 30.0 * weight - 3.0));
            let leak = from_fn(|i| from_fn(|j| if i == j { 1.0 } else { 0.05 * random.unit() }));
            let to_xyz = Calibration::from_rows(rows).behind_glass(0.92);
            let to_xyz = to_xyz.without_crosstalk(&leak).unwrap_or(to_xyz);
            let full = exposure.full_scale() as f32 * (k * k) as f32 / 2304.0;
            let counts = random.bins().map(|share: f32| (1.03 * full * share) as u32);
            reading(hash, exposure, &to_xyz, &counts, &mut random);
            reading(hash, exposure, &to_xyz, &counts.map(|count| count as u16), &mut random);
        }
    }
}

/// One reading: its color, or why it has none.
fn reading<T: Count>(
    hash: &mut Hash,
    exposure: &Exposure,
    to_xyz: &Calibration<8>,
    counts: &[T; 8],
    random: &mut Random,
) {
    let levels = random.bins().map(|level: f32| 40.0 * level);
    let drift = Drift { per_k: random.bins().map(|drift: f32| 2e-3 * drift), calibrated_at_c: 25.0 };
    for basic in [exposure.basic_counts(counts), exposure.basic_counts_above(&levels, counts)] {
        match basic.and_then(|basic| to_xyz.xyz(&basic.without(&drift, 41.5))) {
            Ok(xyz) => {
                hash.all(&xyz.to_array());
                let cct = xyz.cct().and_then(Cct::near);
                hash.maybe(cct.map(|(cct_k, duv)| [cct_k, duv]));
                let white = WHITE.xyz(1000.0).unwrap_or_default();
                for lab in [xyz.lab(white), xyz.lab_with::<Fast>(white)].into_iter().flatten() {
                    hash.all(&[lab.l, lab.a, lab.b]);
                }
            }
            Err(ReadingError::Saturated { channels }) => hash.word(channels.bits()),
            Err(ReadingError::Negative { xyz }) => hash.all(&xyz.to_array()),
            Err(_) => hash.word(0),
        }
    }
}

/// The same chips by `Meter` and in integers: random counts, random chromaticities, random spectra of 16
/// bits.
fn fixed(hash: &mut Hash) {
    const EXPOSURE: Exposure = as7341::exposure(16.0, 29, 599);
    static TO_XYZ: Calibration<8> = SMOOTH.seen_by(&EYE);
    static FLOATS: Meter<8> = Meter::new_above(&EXPOSURE, &[3.5; 8], &TO_XYZ);
    static INTEGERS: FixedMeter<8> = FixedMeter::new_above(&EXPOSURE, &[3.5; 8], &TO_XYZ).unwrap();
    static BANDS: FixedObserver<3, 31, TenNm> = FixedObserver::new(&EYE).unwrap();
    let mut random = Random(0x5eed_1234);
    for _ in 0..256 {
        let counts: [u16; 8] = random.bins().map(|share: f32| (18_100.0 * share) as u16);
        if let Ok(xyz) = FLOATS.xyz(&counts) {
            hash.all(&xyz.to_array());
        }
        match INTEGERS.xyz(&counts) {
            Ok(xyz) => temperature(hash, xyz),
            Err(ReadingError::Negative { xyz }) => hash.all(&xyz.to_array()),
            Err(_) => hash.word(0),
        }
        let xyz = random.bins().map(|share: f32| (0.2 + share) * 1e9);
        temperature(hash, FixedXyz::new(xyz.map(|x| x as i32), 20));
        let samples = from_fn(|_| (65_535.0 * random.unit()) as u16);
        for sum in BANDS.sees(&samples) {
            hash.word(sum as u32);
        }
    }
}

fn temperature(hash: &mut Hash, xyz: FixedXyz) {
    for word in [xyz.x as u32, xyz.y as u32, xyz.z as u32, xyz.lux(), xyz.millilux()] {
        hash.word(word);
    }
    match xyz.cct() {
        Some(FixedCct::Near { cct_k, mired_e3, duv_e6 }) => {
            for word in [cct_k, mired_e3, duv_e6 as u32] {
                hash.word(word);
            }
        }
        Some(FixedCct::TooCold) => hash.word(1),
        Some(FixedCct::TooHot) => hash.word(2),
        _ => hash.word(3),
    }
}

type TenNm = Nodes<400, 700>;
static CHIP: Observer<8, 31, Power, TenNm> = as7341::NOMINAL.fold(Curve::Step);
static EYE: Observer<3, 31, Power, TenNm> = CIE_1931.fold(Curve::Step);
static SMOOTH: Reconstruction<8, 31, TenNm> = const_unwrap!(Reconstruction::smooth(&CHIP, 0.95, 0.01));

/// Spectra behind counts: the matrix that was made while compiling, what it says, and the search without
/// negative powers.
fn reconstructions(hash: &mut Hash) {
    let mut random = Random(0x5eed_5bec);
    SMOOTH.rows().iter().chain(SMOOTH.seen_by(&EYE).rows()).for_each(|row| hash.all(row));
    for k in 0..12 {
        let light = Light::<31, TenNm>::from_bins(from_fn(|n| if n % 12 == k { 5.0 } else { random.unit() }));
        let basic = BasicCounts::new(CHIP.sees(&light));
        hash.all(SMOOTH.spectrum(&basic).values());
        if let Ok(spectrum) = nonnegative_spectrum(&CHIP, &basic, 0.01, 30) {
            hash.all(spectrum.values());
        }
    }
}

/// Calibrations from random patches, as an instrument makes them on a bench.
fn fits(hash: &mut Hash) {
    let mut random = Random(0x5eed_f175);
    for _ in 0..8 {
        let mut fit = Fit::<8>::new();
        for _ in 0..12 {
            let patch = Light::<31, TenNm>::from_bins(random.bins());
            fit.add(&BasicCounts::new(CHIP.sees(&patch)), EYE.sees(&patch), 0.5 + random.unit());
        }
        match fit.solve() {
            Ok(to_xyz) => to_xyz.rows().iter().for_each(|row| hash.all(row)),
            Err(_) => hash.word(0),
        }
        hash.all(&fit.residual_rms());
    }
}

/// What chance does to color, what a lamp does in time, and which exposure comes next.
fn noise_flicker(hash: &mut Hash) {
    let mut random = Random(0x5eed_7077);
    let to_xyz = SMOOTH.seen_by(&EYE);
    let noise = Noise { electrons_per_count: 20.0, read_counts: 2.5 };
    let ladder = [1.0, 4.0, 16.0, 64.0].map(|gain| as7341::exposure(gain, 29, 599));
    for k in 1..32 {
        let counts: [u16; 8] = random.bins().map(|share: f32| (500.0 * k as f32 * (0.5 + share)) as u16);
        let covariance = to_xyz.covariance(&noise.variances(&ladder[2], &counts));
        let xyz = ladder[2].basic_counts(&counts).and_then(|basic| to_xyz.xyz(&basic));
        hash.all(&covariance.uncertainty().to_array());
        let cct = xyz.ok().and_then(|xyz| covariance.cct(xyz));
        hash.maybe(cct.map(|cct| [cct.cct_k, cct.duv]));
        if let Ok(exposures) = AutoExposure::new(&ladder) {
            let advice = exposures.advise(k % 4, &counts);
            hash.word(advice.next as u32 + u32::from(advice.saturated));
        }
        let wave: [f32; 48] = from_fn(|n| 2.0 + random.unit() + Portable::sin_turns(0.013 * (n * k) as f32));
        let hz = 20.0 * k as f32;
        hash.maybe(Flicker::of(&wave, 1000.0, hz).map(|flicker| [flicker.percent, flicker.index]));
        hash.maybe(amplitude_at(&wave, 1000.0, hz).map(|amplitude| [amplitude, 0.0]));
        hash.one(ladder[k % 4].residual_modulation(hz));
    }
}

/// What people see of a lamp in time: a light that jumps below its ripple, at rates on both sides of the one
/// from which not every reading is weighted.
fn visible_flicker(hash: &mut Hash) {
    let mut random = Random(0x5eed_5e1f);
    for (rate_hz, hz) in [(400.0, 8.8), (4000.0, 0.9)] {
        let Some(mut meter) = LightFlickermeter::new(rate_hz) else { continue };
        for k in 0..(31.0 * rate_hz) as u32 {
            let seconds = k as f32 / rate_hz;
            let up = if ((hz * seconds) as u32).is_multiple_of(2) { 1.0 } else { 1.02 };
            meter.push(up * (2.0 + Portable::sin_turns(100.0 * seconds) + 0.01 * random.unit()));
        }
        hash.one(meter.pst_lm().unwrap_or_default());
    }
    for k in 1..16 {
        let wave: [f32; 64] =
            from_fn(|n| 2.0 + random.unit() + Portable::sin_turns(0.031_25 * (n * k) as f32));
        let svm = stroboscopic_visibility_with::<Portable, _>(&wave, 6400.0, 100.0 * k as f32);
        hash.one(svm.unwrap_or_default());
        let fast = stroboscopic_visibility_with::<Fast, _>(&wave, 6400.0, 100.0 * k as f32);
        hash.one(fast.unwrap_or_default());
    }
}
