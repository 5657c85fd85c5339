//! The integer path against the f64 model and at the extremes: it cannot overflow, whatever the counts.

use crate::TO_XYZ;
use model::allowed::check;
use model::cct::planckian;
use model::planck::C2_CIE;
use nanospectra::color::{Cct, Xyz};
use nanospectra::observer::CIE_1931;
use nanospectra::sensor::fixed::{FixedCct, FixedMeter, FixedObserver, FixedXyz};
use nanospectra::sensor::{Calibration, Exposure, Meter, ReadingError, chip::as7341};
use nanospectra::{Curve, Nodes, Observer, Power};
use proptest::prelude::*;

const EXPOSURE: Exposure = as7341::exposure(16.0, 63, 999);
static METER: FixedMeter<8> = FixedMeter::new(&EXPOSURE, &TO_XYZ).unwrap();

/// XYZ with the chromaticity u, v and a largest component of about `size`.
fn fixed([u, v]: [f64; 2], size: f64) -> FixedXyz {
    // Y = 1: X = 3 u / 2 v, Z = (4 - u - 10 v) / 2 v.
    let xyz = [1.5 * u / v, 1.0, (4.0 - u - 10.0 * v) / (2.0 * v)];
    let largest = xyz.iter().copied().fold(0.0, f64::max);
    FixedXyz::new(xyz.map(|x| (x / largest * size).round() as i32), 0)
}

#[test]
fn every_temperature_is_found_at_every_duv() {
    let (mut mireds, mut duvs) = (check("CCT in integers, mired"), check("Duv in integers"));
    for mired in (0..=3996).map(|k| 1.0 + f64::from(k) * 0.25) {
        let ([u, v], [du, dv]) = planckian(1e6 / mired, C2_CIE);
        let length = du.hypot(dv);
        for step in -20..=20 {
            let duv = f64::from(step) * 0.0025;
            let p = [u + duv * dv / length, v - duv * du / length];
            for size in [2.1e9, 1.1e6] {
                let found = fixed(p, size).cct();
                let place = format!("{mired} mired, Duv {duv}, size {size:e}");
                let Some(FixedCct::Near { cct_k, mired_e3, duv_e6 }) = found else {
                    panic!("{place}: {found:?}")
                };
                mireds.value(&place, f64::from(mired_e3) / 1e3, mired);
                let kelvin = 1e9 / f64::from(mired_e3);
                assert!(
                    (f64::from(cct_k) - kelvin).abs() <= 0.5 + kelvin * 1e-3 / mired,
                    "{place}: {found:?}"
                );
                duvs.value(&place, f64::from(duv_e6) / 1e6, duv);
            }
        }
    }
    mireds.tight_over_all();
    duvs.tight_over_all();
}

#[test]
fn black_bodies_beyond_the_ends_of_the_locus_are_too_hot_or_too_cold() {
    let on = |mired: f64| fixed(planckian(1e6 / mired, C2_CIE).0, 2e9).cct();
    for k in 1..=94 {
        let mired = 0.01 * f64::from(k);
        assert_eq!(on(mired), Some(FixedCct::TooHot), "{mired} mired");
        let mired = 1000.0 + 0.25 * f64::from(k);
        assert_eq!(on(mired), Some(FixedCct::TooCold), "{mired} mired");
    }
}

#[test]
fn what_has_no_temperature_gets_the_reason_that_the_floats_give() {
    let mut compared = [0; 4];
    for i in 0..400 {
        for k in 0..300 {
            let (u, v) = (f64::from(i) * 0.0024 + 0.001, f64::from(k) * 0.0013 + 0.001);
            let point = fixed([u, v], 2e9);
            let uv = Xyz::from([point.x, point.y, point.z].map(|x| x as f32)).uv1960().expect("no black");
            // Not close to a border: far from the locus the two tables end at slightly different tangents.
            let all = |d: f32| {
                [[d, 0.0], [-d, 0.0], [0.0, d], [0.0, -d]]
                    .map(|[a, b]| nanospectra::color::Uv1960 { u: uv.u + a, v: uv.v + b }.cct())
            };
            let same = |a: &Cct| core::mem::discriminant(a) == core::mem::discriminant(&uv.cct());
            if point.z < 0 || !all(2e-3).iter().all(same) {
                continue;
            }
            let (expected, kind) = match uv.cct() {
                Cct::Near { .. } => ("Near", 0),
                Cct::TooCold => ("TooCold", 1),
                Cct::TooHot => ("TooHot", 2),
                _ => ("OffLocus", 3),
            };
            let found = format!("{:?}", point.cct().expect("no black"));
            assert!(found.starts_with(expected), "{u}, {v}: {found}, the floats say {expected}");
            compared[kind] += 1;
        }
    }
    assert!(compared.iter().all(|n| *n > 100), "{compared:?}");
}

#[test]
fn black_and_impossible_colors_have_no_temperature() {
    assert_eq!(FixedXyz::new([0; 3], 10).cct(), None);
    for xyz in [
        [1, 0, 0],
        [i32::MAX, 0, 0],
        [0, 0, 5],
        [0, 0, i32::MAX],
        [-5, 3, 3],
        [i32::MIN; 3],
        [3, i32::MIN, 9],
    ] {
        assert_eq!(FixedXyz::new(xyz, 0).cct(), Some(FixedCct::OffLocus), "{xyz:?}");
    }
    // Full range: equal energy at the largest there is, and at the smallest.
    for size in [1, 2, 3, 1000, i32::MAX] {
        let Some(FixedCct::Near { cct_k, duv_e6, .. }) = FixedXyz::new([size; 3], 0).cct() else {
            panic!("{size}")
        };
        assert!(
            (5440..=5470).contains(&cct_k) && (-4450..=-4300).contains(&duv_e6),
            "{size}: {cct_k} {duv_e6}"
        );
    }
}

/// The counts in f64, as exactly as can be.
fn expected(counts: &[u16; 8], dark: &[f32; 8], exposure: &Exposure) -> [f64; 3] {
    let per_count = 1.0 / (f64::from(exposure.gain()) * f64::from(exposure.time_ms()));
    TO_XYZ.rows().map(|row| {
        let terms = row.iter().zip(counts).zip(dark);
        terms.map(|((w, n), d)| f64::from(*w) * (f64::from(*n) - f64::from(*d)) * per_count).sum()
    })
}

#[test]
fn sums_are_exact_to_a_few_units_and_never_overflow() {
    let dark = [65_535.0, 12.25, 0.0, 3.5, 65_535.0, 700.0, 65_535.0, 0.5];
    let above = FixedMeter::new_above(&EXPOSURE, &dark, &TO_XYZ).expect("levels that counts can have");
    // Full scale of X, Y and Z: the sizes of the terms at 65 535.
    let full = expected(&[65_535; 8], &[0.0; 8], &EXPOSURE).map(|x| x * 1.02);
    let mut worst: f64 = 0.0;
    // All patterns of nothing and everything, of one count and of one below full scale.
    for bits in 0..256_u32 {
        for (low, high) in [(0, 63_999), (1, 63_998), (0, 8192), (17, 255)] {
            let counts = core::array::from_fn(|c| if bits >> c & 1 == 1 { high } else { low });
            for (meter, dark) in [(&METER, &[0.0; 8]), (&above, &dark)] {
                let sums = match meter.xyz(&counts) {
                    Ok(xyz) => xyz.to_xyz(),
                    Err(ReadingError::Negative { xyz }) => xyz,
                    Err(ReadingError::TooDark) => continue,
                    other => panic!("{counts:?}: {other:?}"),
                };
                for ((sum, exact), full) in
                    sums.to_array().into_iter().zip(expected(&counts, dark, &EXPOSURE)).zip(full)
                {
                    worst = worst.max((f64::from(sum) - exact).abs() / full);
                }
            }
        }
    }
    println!("XYZ in integers: {worst:.2e} of full scale, to_xyz's rounding to f32 included");
    assert!(worst < 6e-8, "{worst:e}");
    assert!(worst > 1e-9);
}

/// Each weight loses half a unit by rounding, each product nearly a whole one, and each dark level half a unit,
/// at the full scale that the sums use least.
#[test]
fn sums_lose_three_units_for_each_channel_at_worst_and_four_above_dark_levels() {
    let (exposure, weight) = (Exposure::new(2.0, 127.007_79, 65_535), 1.984_498_6_f32);
    let calibration = Calibration::from_rows([[weight; 8]; 3]);
    for (dark, units) in [(0.0_f32, 3.0), (6096.393, 4.0)] {
        let meter = FixedMeter::new_above(&exposure, &[dark; 8], &calibration).expect("a scale");
        let found = meter.xyz(&[65_534; 8]).expect("a light");
        let per_count = f64::from(exposure.gain()) * f64::from(exposure.time_ms());
        let of = |count: f64| 8.0 * f64::from(weight) * count / per_count;
        let off = (f64::from(found.y) / 2f64.powi(found.fraction()) - of(65_534.0 - f64::from(dark))).abs();
        let off = off / of(65_535.0) * 2f64.powi(30) / 8.0;
        assert!((0.99 * units..=units).contains(&off), "{off} units, above {dark}");
    }
}

#[test]
fn temperature_is_that_of_the_floats_from_an_eighth_of_full_scale() {
    static FLOATS: Meter<8> = Meter::new(&EXPOSURE, &TO_XYZ);
    let mut random = 0x5eed_u64;
    let mut next = move || {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (random >> 40) as f32 / (1 << 24) as f32
    };
    let (mut compared, mut worst) = (0, 0.0_f32);
    for _ in 0..400_000 {
        let (kelvin, size) = (1e6 / (5.0 + 900.0 * next()), 8000.0 + 55_000.0 * next());
        // A black body through the nominal channels, disturbed by a tenth.
        let shape = as7341::NOMINAL.sees(
            &nanospectra::Fine::interpolated_outside(
                &[360.0, 450.0, 550.0, 650.0, 750.0, 830.0].map(|nm: f32| {
                    (
                        nm,
                        (1.4388e7 / (nm * kelvin)).exp_m1().recip()
                            * (560.0 / nm).powi(5)
                            * (1.0 + 0.2 * next()),
                    )
                }),
                nanospectra::Interpolation::Linear,
                nanospectra::Outside::Hold,
            )
            .expect("samples in order"),
        );
        let largest = shape.into_iter().fold(0.0, f32::max);
        let counts: [u16; 8] = shape.map(|x| (x / largest * size) as u16);
        let (Ok(fixed), Ok(float)) = (METER.xyz(&counts), FLOATS.xyz(&counts)) else { continue };
        let (Some(FixedCct::Near { mired_e3, .. }), Some((cct_k, _))) =
            (fixed.cct(), float.uv1960().and_then(|uv| uv.cct().near()))
        else {
            continue;
        };
        worst = worst.max((mired_e3 as f32 / 1e3 - 1e6 / cct_k).abs());
        compared += 1;
        if compared == 20_000 {
            break;
        }
    }
    println!("CCT of counts in integers: within {worst} mired of the floats, {compared} readings");
    assert!(compared == 20_000 && (0.02..0.1).contains(&worst), "{compared} {worst}");
}

#[test]
fn lux_is_whole_at_every_scale() {
    for (y, fraction, lux, milli) in [
        (3 << 20, 20, 3, 3000),
        ((3 << 20) + (1 << 19), 20, 4, 3500),
        ((3 << 20) + (1 << 19) - 1, 20, 3, 3499),
        (-5, 3, 0, 0),
        (i32::MAX, 31, 1, 999),
        (i32::MAX, 62, 0, 0),
        (7, 0, 7, 7000),
        (7, -3, 56, 56_000),
        (i32::MAX, -1, u32::MAX - 1, u32::MAX),
        (i32::MAX, -2, u32::MAX, u32::MAX),
        (1, -62, u32::MAX, u32::MAX),
        (0, -62, 0, 0),
    ] {
        let xyz = FixedXyz::new([0, y, 0], fraction);
        assert_eq!((xyz.lux(), xyz.millilux()), (lux, milli), "{y} / 2^{fraction}");
    }
}

#[test]
fn a_meter_that_cannot_be_is_refused() {
    let one = |w: f32| Calibration::from_rows([[w; 2]; 3]);
    let exposure = Exposure::new(1.0, 1.0, 65_535);
    for w in [0.0, f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(FixedMeter::new(&exposure, &one(w)), None, "{w}");
    }
    for level in [-1.0, 65_536.0, f32::NAN] {
        assert_eq!(FixedMeter::new_above(&exposure, &[0.0, level], &one(1.0)), None, "{level}");
    }
    for row in 0..3 {
        let mut rows = [[1.0; 2]; 3];
        rows[row][0] = f32::NAN;
        assert_eq!(FixedMeter::new(&exposure, &Calibration::from_rows(rows)), None, "NaN in row {row}");
    }
    // Usual sizes of weights find their scale, others are refused.
    for w in [1e-12, 1e-6, 1.0, 1e6, 1e12] {
        let meter = FixedMeter::new(&exposure, &one(w)).expect("a scale");
        let xyz = meter.xyz(&[10_000, 20_000]).map(FixedXyz::to_xyz).expect("light");
        assert!((xyz.y / (30_000.0 * w) - 1.0).abs() < 3e-7, "{w}: {xyz:?}");
    }
    for w in [1e-30, 1e-25, 1e25, 1e30] {
        assert_eq!(FixedMeter::new(&exposure, &one(w)), None, "{w}");
    }
    // However high the floor, less is too dark.
    for floor in [5e9, f32::INFINITY] {
        let meter = FixedMeter::new(&exposure.with_floor(floor), &one(1.0)).expect("a scale");
        assert_eq!(meter.xyz(&[5, 5]), Err(ReadingError::TooDark));
    }
}

#[test]
fn spectra_of_16_bits_are_seen_as_the_floats_see_them() {
    type Grid = Nodes<380, 780>;
    static EYE: Observer<3, 81, Power, Grid> = CIE_1931.fold(Curve::Spline);
    static FIXED: FixedObserver<3, 81, Grid> = FixedObserver::new(&EYE).unwrap();
    let full: [f64; 3] = EYE.weights().map(|row| row.iter().map(|w| f64::from(w.max(0.0))).sum());
    let mut worst: f64 = 0.0;
    let mut see = |samples: &[u16; 81]| {
        for ((sum, row), full) in FIXED.sees(samples).into_iter().zip(EYE.weights()).zip(full) {
            let exact: f64 = row.iter().zip(samples).map(|(w, s)| f64::from(*w) * f64::from(*s)).sum();
            let got = f64::from(sum) * f64::from(FIXED.unit());
            worst = worst.max((got - exact).abs() / (65_535.0 * full));
        }
    };
    see(&[65_535; 81]);
    see(&[0; 81]);
    see(&[1; 81]);
    // Where the weights were rounded up, and where down: the worst there can be.
    for channel in 0..3 {
        for sign in [1.0, -1.0] {
            let rounding = |w: f32| {
                let units = w / FIXED.unit() * 512.0;
                sign * (units.round() - units) > 0.0
            };
            see(&EYE.weights()[channel].map(|w| if rounding(w) { 65_535 } else { 0 }));
        }
    }
    let mut random = 1_u32;
    for _ in 0..2000 {
        see(&core::array::from_fn(|_| {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (random >> 16) as u16
        }));
    }
    println!("81 bands of 16 bits to XYZ: {worst:.2e} of full scale");
    assert!((5e-6..3e-5).contains(&worst), "{worst:e}");
    assert!(FixedObserver::<3, 81, Grid>::new(&EYE.scaled(0.0)).is_none());
}

#[test]
fn negative_weights_are_seen_too() {
    static CHIP: Observer<2, 8, Power> =
        Observer::from_weights([[1.0, -0.5, 0.25, 2.0, -2.0, 0.0, 0.5, 1.0]; 2]);
    static FIXED: FixedObserver<2, 8> = FixedObserver::new(&CHIP).unwrap();
    let sums = |samples| FIXED.sees(&samples).map(|sum| sum as f32 * FIXED.unit());
    for sum in sums([1000, 0, 0, 0, 0, 0, 0, 0]).into_iter().chain(sums([0, 0, 0, 0, 0, 0, 2000, 0])) {
        assert!((sum - 1000.0).abs() < 0.1, "{sum}");
    }
    for sum in sums([0, 65_535, 0, 0, 65_535, 0, 0, 0]) {
        assert!((sum / 65_535.0 + 2.5).abs() < 1e-4, "{sum}");
    }
}

proptest! {
    /// Debug builds check every addition: no counts, no scale and no weights overflow.
    #[test]
    fn nothing_overflows(
        counts in any::<[u16; 4]>(), dark in prop::array::uniform4(0.0_f32..=65_535.0),
        rows in prop::array::uniform3(prop::array::uniform4(-1e9_f32..1e9)), size in -120_i32..90,
        xyz in any::<[i32; 3]>(), fraction in -62..=62_i32, samples in any::<[u16; 4]>(),
    ) {
        let calibration = Calibration::from_rows(rows).scaled(2.0_f32.powi(size));
        if let Some(meter) = FixedMeter::new_above(&Exposure::new(1.0, 1.0, 65_535), &dark, &calibration)
            && let Ok(found) = meter.xyz(&counts)
        {
            let _ = (found.cct(), found.lux(), found.millilux());
        }
        let xyz = FixedXyz::new(xyz, fraction);
        let _ = (xyz.cct(), xyz.lux(), xyz.millilux(), xyz.to_xyz());
        if let Some(fixed) = FixedObserver::new(&Observer::<3, 4, Power>::from_weights(rows)) {
            let _ = fixed.sees(&samples);
        }
    }
}
