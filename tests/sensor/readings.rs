//! A reading, from the counts on the bus to a color or to the reason why there is none.

use crate::TO_XYZ;
use model::allowed::check;
use nanospectra::color::{Cct, Xyz};
use nanospectra::math::{Fast, Math};
use nanospectra::sensor::{
    BasicCounts, Calibration, Channels, CrosstalkError, DarkCounts, Drift, Exposure, Meter, ReadingError,
    chip::{as7341, opt4048, tcs3472},
};
use proptest::prelude::*;

const EXPOSURE: Exposure = as7341::exposure(16.0, 29, 599);

#[test]
fn the_full_scale_of_an_as7341_is_its_number_of_steps() {
    // (ATIME + 1) (ASTEP + 1), at most 65 535; 2.78 us each (DS000504).
    for (atime, astep, full, ms) in [
        (29, 599, 18_000, 50.04),
        (9, 3596, 35_970, 99.9966),
        (255, 65_534, 65_535, 46_639.35),
        (0, 0, 1, 0.00278),
    ] {
        let exposure = as7341::exposure(1.0, atime, astep);
        assert_eq!(exposure.full_scale(), full);
        assert!((exposure.time_ms() / ms - 1.0).abs() < 1e-4, "{} {ms}", exposure.time_ms());
    }
}

#[test]
fn a_tcs3472_is_trusted_to_three_quarters_below_150_ms() {
    // 256 - ATIME cycles of 2.4 ms and 1024 counts; the rule of ripple in DN40.
    for (atime, full, ms) in [
        (0xff, 768, 2.4),
        (0xf6, 7680, 24.0),
        (0xd5, 33_024, 103.2),
        (0xc2, 47_616, 148.8),
        (0xc1, 64_512, 151.2),
        (0x00, 65_535, 614.4),
    ] {
        let exposure = tcs3472::exposure(4.0, atime);
        assert_eq!(exposure.full_scale(), full, "{atime:#x}");
        assert!((exposure.time_ms() - ms).abs() < 1e-3);
    }
}

#[test]
fn an_opt4048_reads_lux_from_its_codes() {
    // ESPHome, Adafruit: lux = 2.15e-3 times channel 1, whatever the range.
    let code = opt4048::code(250_000, 2);
    assert_eq!(code, 1_000_000);
    let basic = opt4048::exposure().basic_counts(&[code, code, code]).expect("a reading");
    let [lux] = opt4048::TO_LUX.apply(&basic);
    assert!((lux - 2150.0).abs() < 1e-3);
    // Equal codes in X, Y and Z: x, y by TI's matrix, computed by hand.
    let xy = opt4048::TO_XYZ.xyz(&basic).ok().and_then(Xyz::xy).expect("light");
    assert!((xy.x - 0.306_64).abs() < 1e-5 && (xy.y - 0.135_65).abs() < 1e-5, "{xy:?}");
    // Mantissa and exponent at their largest.
    let full = opt4048::code(0x000f_ffff, 8);
    assert!(matches!(opt4048::exposure().basic_counts(&[full, 0, 0]), Err(ReadingError::Saturated { .. })));
}

#[test]
fn the_codes_of_an_opt4048_double_with_each_step_of_the_exponent() {
    for exponent in 0..=12 {
        assert_eq!(opt4048::code(0x000f_ffff, exponent), 0x000f_ffff << exponent, "{exponent}");
    }
    // 20 bits of mantissa end at bit 31 with an exponent of 12; the four bits on the bus can say more.
    for exponent in [13, 15, u8::MAX] {
        assert_eq!(opt4048::code(0x000f_ffff, exponent), 0xffff_f000, "{exponent}");
    }
}

#[test]
fn a_full_scale_may_be_anything_below_2_to_the_31() {
    for full in [1, 18_000, 1 << 27, (1 << 27) + 1, 1 << 30, 0x7fff_fffe, 0x7fff_ffff] {
        let exposure = Exposure::new(1.0, 1.0, full);
        assert_eq!(exposure.full_scale(), full);
        assert!(
            exposure.saturated(&[full - 1]).count() == 0 && exposure.saturated(&[full]).count() == 1,
            "{full}"
        );
    }
    for beyond in [1 << 31, u32::MAX] {
        assert_eq!(Exposure::new(1.0, 1.0, beyond).full_scale(), 0x7fff_ffff);
    }
}

#[test]
fn basic_counts_do_not_depend_on_the_exposure() {
    let bright = as7341::exposure(1.0, 29, 599).basic_counts(&[1000_u16, 2000]).expect("a reading");
    let long = as7341::exposure(4.0, 59, 599).basic_counts(&[8000_u32, 16_000]).expect("a reading");
    let calibrated = as7341::exposure(1.0, 29, 599).basic_counts(&[1000.0_f32, 2000.0]).expect("a reading");
    for (a, b) in bright.values().iter().zip(long.values()) {
        assert!((a / b - 1.0).abs() < 3e-7);
    }
    assert_eq!(bright, calibrated);
    assert!((bright.values()[0] * 50.04 - 1000.0).abs() < 1e-3);
}

#[test]
fn counts_at_the_ends_of_the_range_have_a_meaning() {
    let full = EXPOSURE.full_scale() as u16;
    assert_eq!(EXPOSURE.basic_counts(&[0_u16; 8]), Err(ReadingError::TooDark));
    assert!(EXPOSURE.basic_counts(&[0_u16, 0, 0, 1, 0, 0, 0, 0]).is_ok());
    assert!(EXPOSURE.basic_counts(&[full - 1; 8]).is_ok());
    let all = Channels::default().with(0).with(1).with(2).with(3).with(4).with(5).with(6).with(7);
    for count in [full, u16::MAX] {
        assert_eq!(EXPOSURE.basic_counts(&[count; 8]), Err(ReadingError::Saturated { channels: all }));
    }
    for count in [u32::from(full), u32::MAX, 1 << 31] {
        assert_eq!(EXPOSURE.basic_counts(&[count; 8]), Err(ReadingError::Saturated { channels: all }));
    }
    assert_eq!(EXPOSURE.basic_counts(&[f32::INFINITY; 8]), Err(ReadingError::Saturated { channels: all }));
    // All equal is no color of its own: it is what the calibration says of it.
    let equal = EXPOSURE.basic_counts(&[1000_u16; 8]).expect("a reading");
    assert!(TO_XYZ.xyz(&equal).is_ok_and(|xyz| xyz.y > 0.0));
}

#[test]
fn what_is_not_a_number_stays_so() {
    let mut counts = [500.0_f32; 8];
    counts[3] = f32::NAN;
    let basic = EXPOSURE.basic_counts(&counts).expect("neither saturated nor dark");
    let xyz = TO_XYZ.xyz(&basic).expect("not negative");
    assert!(xyz.x.is_nan() && xyz.y.is_nan() && xyz.z.is_nan());
    let cct = xyz.uv1960().map(|uv| uv.cct());
    assert!(matches!(cct, Some(Cct::Near { cct_k, duv }) if cct_k.is_nan() && duv.is_nan()));
}

#[test]
fn channels_below_their_dark_level_are_negative_and_stay_so() {
    let levels = [40.0; 8];
    let basic =
        EXPOSURE.basic_counts_above(&levels, &[30_u16, 60, 40, 40, 40, 40, 40, 40]).expect("10 above");
    assert!(basic.values()[0] < 0.0 && basic.values()[1] > 0.0 && basic.values()[2] == 0.0);
    // As much below as above is dark, and all below is.
    assert_eq!(
        EXPOSURE.basic_counts_above(&levels, &[30_u16, 50, 40, 40, 40, 40, 40, 40]),
        Err(ReadingError::TooDark)
    );
    assert_eq!(EXPOSURE.basic_counts_above(&levels, &[0_u16; 8]), Err(ReadingError::TooDark));
    // Saturation is a matter of the raw count.
    assert!(matches!(
        EXPOSURE.basic_counts_above(&[500.0; 8], &[18_000_u16, 1, 1, 1, 1, 1, 1, 1]),
        Err(ReadingError::Saturated { channels }) if channels == Channels::default().with(0)
    ));
}

#[test]
fn a_negative_color_is_an_outcome_and_keeps_its_numbers() {
    let red = BasicCounts::new([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
    let Err(ReadingError::Negative { xyz }) = TO_XYZ.xyz(&red) else { panic!("{:?}", TO_XYZ.xyz(&red)) };
    assert_eq!(xyz.to_array(), [-0.2993, -0.1845, -0.09507]);
    let text = TO_XYZ.xyz(&red).unwrap_err().to_string();
    assert_eq!(text, "the calibration gives a negative color: X -0.2993, Y -0.1845, Z -0.09507");
}

#[test]
fn the_floor_is_what_all_channels_count_together() {
    let exposure = EXPOSURE.with_floor(80.0);
    assert_eq!(exposure.basic_counts(&[9_u16, 10, 10, 10, 10, 10, 10, 10]), Err(ReadingError::TooDark));
    assert!(exposure.basic_counts(&[10_u16; 8]).is_ok());
}

#[test]
fn dark_counts_grow_with_time_gain_and_temperature() {
    let dark =
        DarkCounts { offset: [2.0, 0.0], rate: [0.01, 0.02], measured_at_c: 25.0, doubles_every_k: 8.0 };
    let exposure = Exposure::new(16.0, 50.0, 65_535);
    assert_eq!(dark.levels(&exposure), [10.0, 16.0]);
    for (celsius, levels) in [(25.0, [10.0, 16.0]), (33.0, [18.0, 32.0]), (17.0, [6.0, 8.0])] {
        for (a, b) in dark.levels_at_with::<Fast>(&exposure, celsius).iter().zip(levels) {
            assert!((a - b).abs() < 1e-5, "{celsius}: {a} {b}");
        }
    }
    assert_eq!(Fast::exp(0.0), 1.0);
}

#[test]
fn drift_is_undone() {
    let drift = Drift { per_k: [1e-3, -2e-3], calibrated_at_c: 25.0 };
    let warm = BasicCounts::new([100.0 * 1.02, 100.0 * 0.96]);
    for value in warm.without(&drift, 45.0).values() {
        assert!((value - 100.0).abs() < 1e-4);
    }
}

#[test]
fn what_is_linear_folds_into_the_calibration() {
    let basic = BasicCounts::new([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]);
    let factors = [1.1, 0.9, 1.0, 1.05, 0.95, 1.2, 0.8, 1.0];
    let leak: [[f32; 8]; 8] = core::array::from_fn(|i| {
        core::array::from_fn(|j| if i == j { 0.93 } else { 0.01 * (1 + (i + 2 * j) % 3) as f32 })
    });
    let mut check = check("folded corrections");
    let mut same = |what: &str, folded: [f32; 3], plain: [f32; 3]| {
        for (a, b) in folded.into_iter().zip(plain) {
            check.value(what, a.into(), b.into());
        }
    };
    let plain = TO_XYZ.apply(&basic);
    same("correction", TO_XYZ.corrected(&factors).apply(&basic), TO_XYZ.apply(&basic.scaled(&factors)));
    same("glass", TO_XYZ.behind_glass(0.5).apply(&basic), plain.map(|x| 2.0 * x));
    let leaked = BasicCounts::new(leak.map(|row| row.iter().zip(basic.values()).map(|(w, x)| w * x).sum()));
    let straight = TO_XYZ.without_crosstalk(&leak).expect("channels that can be told apart");
    same("cross-talk", straight.apply(&leaked), plain);
    check.tight(9);
}

#[test]
fn a_meter_is_within_its_rounding_of_the_exact_sums() {
    static METER: Meter<8> = Meter::new(&EXPOSURE, &TO_XYZ);
    let mut check = check("XYZ by a meter, of full scale");
    let mut random = 7_u32;
    for _ in 0..20_000 {
        let counts: [u16; 8] = core::array::from_fn(|_| {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            ((random >> 16) % 18_000) as u16
        });
        let xyz = match METER.xyz(&counts) {
            Ok(xyz) | Err(ReadingError::Negative { xyz }) => xyz,
            Err(other) => panic!("{counts:?}: {other}"),
        };
        for (got, row) in xyz.to_array().into_iter().zip(TO_XYZ.rows()) {
            let per_count = 1.0 / (16.0 * 30.0 * 600.0 * 2.78e-3);
            let sum = |of: &dyn Fn(f64, f64) -> f64| -> f64 {
                row.iter().zip(counts).map(|(w, n)| of(f64::from(*w) * per_count, n.into())).sum()
            };
            let full = sum(&|w, _| w.abs() * 18_000.0);
            check.value("", f64::from(got) / full, sum(&|w, n| w * n) / full);
        }
    }
    check.tight(60_000);
}

#[test]
fn cross_talk_that_cannot_be_undone_is_refused() {
    let refused = |matrix: [[f32; 2]; 2]| {
        Calibration::<2, 1>::from_rows([[1.0, 1.0]]).without_crosstalk(&matrix) == Err(CrosstalkError)
    };
    assert!(refused([[1.0, 1.0], [1.0, 1.0]]));
    assert!(refused([[0.0, 0.0], [0.0, 1.0]]));
    assert!(refused([[1.0, f32::NAN], [0.0, 1.0]]));
    assert!(refused([[1.0, 0.999_99], [0.999_99, 1.0]]));
    // Channels that have changed places, and small ones, are fine.
    assert!(!refused([[0.0, 1.0], [1.0, 0.0]]));
    assert!(!refused([[1e-6, 0.0], [0.0, 1e6]]));
    assert!(CrosstalkError.to_string().contains("cannot be told apart"));
}

#[test]
fn a_set_of_channels_says_which() {
    let some = Channels::default().with(2).with(31).with(99);
    assert!(some.contains(2) && some.contains(31) && !some.contains(3) && !some.contains(99));
    assert_eq!((some.count(), some.bits()), (2, 0x8000_0004));
}

proptest! {
    /// One pass and step by step give the same color, or the same reason.
    #[test]
    fn a_meter_reads_as_its_steps_do(
        counts in any::<[u16; 8]>(), dark in 0.0_f32..200.0, gain in 0.5_f32..512.0, atime in any::<u8>(),
        astep in 100_u16..65_534,
    ) {
        let exposure = as7341::exposure(gain, atime, astep);
        let meter = Meter::new_above(&exposure, &[dark; 8], &TO_XYZ);
        let steps = exposure.basic_counts_above(&[dark; 8], &counts).and_then(|basic| TO_XYZ.xyz(&basic));
        let size = exposure.per_count() * 65_535.0 * 180.0;
        match (meter.xyz(&counts), steps) {
            (Ok(a), Ok(b)) => {
                for (a, b) in a.to_array().into_iter().zip(b.to_array()) {
                    prop_assert!((a - b).abs() < 1e-6 * size, "{a} {b}");
                }
            }
            (Err(ReadingError::Negative { xyz }), Ok(other)) | (Ok(other), Err(ReadingError::Negative { xyz })) => {
                prop_assert!((xyz.y - other.y).abs() < 1e-6 * size);
            }
            (a, b) => prop_assert_eq!(
                a.err().map(|e| std::mem::discriminant(&e)), b.err().map(|e| std::mem::discriminant(&e))
            ),
        }
    }

    /// No finite count panics or becomes NaN silently, at any exposure.
    #[test]
    fn finite_counts_give_finite_colors(counts in any::<[u32; 8]>(), gain in 1e-3_f32..1e4, ms in 1e-3_f32..1e6) {
        let exposure = Exposure::new(gain, ms, u32::MAX);
        if let Ok(xyz) = exposure.basic_counts(&counts).and_then(|basic| TO_XYZ.xyz(&basic)) {
            prop_assert!(xyz.to_array().into_iter().all(f32::is_finite));
        }
    }
}
