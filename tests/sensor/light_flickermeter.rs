//! The light flickermeter: the test points of IEC TR 61547-1, two f64 models, and hard cases.

use model::allowed::check;
use model::light_flickermeter::{Part, instantaneous, of_parts, pst_lm};
use nanospectra::sensor::{LightFlickermeter, PstLmError};
use std::f64::consts::{PI, TAU};

/// Lights with Pst LM 1: how often they jump up in a second, and by how many percent of their mean.
///
/// They are the test points of IEC TR 61547-1 for lamps on mains of 50 Hz, as meters that others published
/// are tested (a project for an STM32G4 has them with its own results, 0.9995 to 1.0056 in f64).
const POINTS: [(f64, f64); 5] =
    [(0.325, 2.5386), (0.9167, 2.0473), (8.8, 0.6832), (13.5, 0.7780), (33.3, 2.0027)];

/// How such a lamp swings with the mains: a cosine of 100 Hz, as a part of the mean.
const RIPPLE: f64 = -0.11;

/// Readings of a light, which is a function of the time in seconds.
fn readings(rate_hz: f64, seconds: f64, light: impl Fn(f64) -> f64) -> Vec<f64> {
    // As f32, because the library reads no more.
    (0..(rate_hz * seconds) as usize).map(|k| f64::from(light(k as f64 / rate_hz) as f32)).collect()
}

fn jumps(hz: f64, percent: f64) -> impl Fn(f64) -> f64 {
    move |t| {
        let up = if (hz * t).fract() < 0.5 { 1.0 } else { -1.0 };
        (1.0 + RIPPLE * (TAU * 100.0 * t).cos()) * (1.0 + up * percent / 200.0)
    }
}

/// The same light as a sum of sines.
fn parts(hz: f64, percent: f64) -> Vec<Part> {
    let odd = (0..).map(|k| f64::from(2 * k + 1)).take_while(|k| k * hz < 400.0);
    let part = |k: f64| {
        let (at, size) = (k * hz, percent / 200.0 * 4.0 / PI / k);
        let beside = 0.5 * RIPPLE * size;
        [[at, 0.0, size], [100.0 + at, 0.0, beside], [100.0 - at, 0.0, -beside]]
    };
    odd.flat_map(part).chain([[100.0, RIPPLE, 0.0]]).collect()
}

fn found(readings: &[f64], rate_hz: f64) -> Result<f32, PstLmError> {
    let mut meter = LightFlickermeter::new(rate_hz as f32).expect("a rate");
    readings.iter().for_each(|reading| meter.push(*reading as f32));
    meter.pst_lm()
}

/// Two independent models agree with the report, and so does the library.
#[test]
fn the_test_points_of_the_report_are_just_visible() {
    let published = [0.999_502, 0.999_708, 0.999_586, 1.000_237, 1.005_575];
    let mut all = check("Pst LM of the test points");
    for ((hz, percent), published) in POINTS.into_iter().zip(published) {
        let light = readings(2000.0, 120.0, jumps(hz, percent));
        let by_filters = pst_lm(&light, 2000.0);
        let by_series = of_parts(&parts(hz, percent), 80.0);
        assert!((by_filters - published).abs() < 1.5e-3, "{hz} Hz: {by_filters}");
        assert!((by_filters / by_series - 1.0).abs() < 1e-3, "{hz} Hz: {by_filters} and {by_series}");
        let found = found(&light, 2000.0).expect("a light");
        all.value(&format!("{hz} Hz"), found.into(), 1.0);
    }
    all.tight(5);
}

/// The other end of the scale: what the factor of the report was made for.
#[test]
fn a_sine_of_8_8_hz_that_swings_by_0_63_percent_has_an_instantaneous_flicker_of_1() {
    let light = readings(2000.0, 60.0, |t| 1.0 + 0.5 * 0.0063 * (TAU * 8.8 * t).sin());
    let crest = instantaneous(&light, 2000.0).into_iter().fold(0.0, f64::max);
    assert!((crest - 1.0).abs() < 5e-4, "{crest}");
}

/// A light that changes from one flicker to another: a rate, a frequency, how far it swings at first and
/// later, the share of the time that counts until then, and the time that it is up in a period (0 for a
/// sine).
type Changing = ([f64; 6], &'static str);

/// The worst of a search over all of these, of 250 lights at each rate.
const WORST: [Changing; 5] = [
    ([400.0, 17.91, 0.104_267, 0.244_985, 0.391_4, 0.478_1], "400 Hz"),
    ([1000.0, 33.0, 0.185_895_47, 0.017_962_373, 0.722_409_37, 0.0], "1000 Hz"),
    ([2000.0, 21.62, 0.203_76, 0.001_406, 0.772_7, 0.0], "2000 Hz"),
    ([2500.0, 24.21, 0.886_691_7, 0.007_566, 0.404_475, 0.679_24], "2500 Hz"),
    ([10_000.0, 11.655, 0.006_11, 0.0005, 0.854_562, 0.0], "10 kHz"),
];

#[test]
fn the_worst_lights_are_near_the_model() {
    let mut all = check("Pst LM");
    for ([rate_hz, hz, first, later, until, up], what) in WORST {
        let light = readings(rate_hz, 45.0, |t| {
            let swing = if t < 20.0 + 25.0 * until { first } else { later };
            let wave = match up {
                0.0 => 0.5 * (TAU * hz * t).sin(),
                up if (hz * t).fract() < up => 0.5,
                _ => -0.5,
            };
            100.0 * (1.0 + swing * wave)
        });
        all.value(what, found(&light, rate_hz).expect("a light").into(), pst_lm(&light, rate_hz));
    }
    // Flicker of 0.3 % below pulses of 1000 Hz that turn the light off, which are 300 times as large.
    let light = readings(10_000.0, 40.0, |t| {
        let pulse = if (1000.0 * t + 0.05).fract() < 0.5 { 2.0 } else { 0.0 };
        pulse * (1.0 + 0.0015 * (TAU * 8.8 * t).sin())
    });
    all.value("pulses", found(&light, 1e4).expect("a light").into(), pst_lm(&light, 1e4));
    // So slow a filter beside so high a rate loses most of all.
    let light = readings(50_000.0, 45.0, jumps(0.9167, 2.0473));
    all.value("50 kHz", found(&light, 5e4).expect("a light").into(), pst_lm(&light, 5e4));
    all.tight(7);
}

/// A light that swings by one sine for most of the time and by one that is a little wider at last puts all
/// values at two places, wherever the bounds of the classes lie. A class is up to 3.1 % wide, which is 1.6 %
/// of the severity.
#[test]
fn no_light_is_far_off_by_the_classes() {
    for k in 0..24 {
        let swing = 0.004 * 1.03f64.powi(k);
        let light = |t: f64| 1.0 + swing * if t < 40.0 { 1.0 } else { 1.4 } * (TAU * 12.0 * t).sin();
        let light = readings(400.0, 45.0, light);
        let share = f64::from(found(&light, 400.0).expect("a light")) / pst_lm(&light, 400.0);
        assert!((share - 1.0).abs() < 0.016, "{swing}: {share}");
    }
}

/// Why the library does not filter as most programs do: the gain of the low pass for steady light, by the
/// coefficients of its three sections in direct form, of which each was rounded once.
#[test]
fn the_direct_form_would_change_the_gain() {
    let corner = (PI * 35.0 / 50_000.0).tan();
    let gain = |angle: f64| {
        let damping = 2.0 * angle.to_radians().sin();
        let sum = 1.0 + damping * corner + corner * corner;
        let [input, first, second] = [
            corner * corner / sum,
            2.0 * (corner * corner - 1.0) / sum,
            (1.0 - damping * corner + corner * corner) / sum,
        ]
        .map(|coefficient| f64::from(coefficient as f32));
        4.0 * input / (1.0 + first + second)
    };
    let all: f64 = [75.0, 45.0, 15.0].map(gain).iter().product();
    assert!((all - 1.0 + 0.0034).abs() < 1e-4, "{all}");
}

/// A rate is a choice: the analog filters do not know of it.
#[test]
fn the_severity_hardly_depends_on_the_rate() {
    let mut all = check("Pst LM at any rate");
    for (hz, percent) in [POINTS[2], POINTS[4]] {
        let exact = of_parts(&parts(hz, percent), 80.0);
        for rate_hz in [400.0, 500.0, 700.0, 1000.0, 1999.0, 2000.0, 3999.0, 12_345.6] {
            let light = readings(rate_hz, 60.0, jumps(hz, percent));
            let place = format!("{hz} Hz, {rate_hz} readings a second");
            all.value(&place, found(&light, rate_hz).expect("a light").into(), exact);
        }
    }
    all.tight(16);
}

#[test]
fn the_unit_of_the_readings_does_not_matter() {
    let light = readings(1000.0, 31.0, jumps(8.8, 0.6832));
    let one = found(&light, 1000.0).expect("a light");
    for scale in [2f64.powi(-30), 0.25, 2f64.powi(40)] {
        let scaled: Vec<f64> = light.iter().map(|reading| scale * reading).collect();
        assert_eq!(found(&scaled, 1000.0), Ok(one), "{scale}");
    }
    for scale in [1e-9, 1e14] {
        let scaled: Vec<f64> = light.iter().map(|reading| scale * reading).collect();
        let other = found(&scaled, 1000.0).expect("a light");
        assert!((other / one - 1.0).abs() < 1e-3, "{scale}: {other}, {one}");
    }
}

/// The severity is proportional to the swing, from hardly any to all of the light.
#[test]
fn twice_the_swing_is_twice_as_severe() {
    let of = |percent: f64| {
        let light = |t: f64| 1.0 + if (8.8 * t).fract() < 0.5 { percent } else { -percent } / 200.0;
        f64::from(found(&readings(1000.0, 40.0, light), 1000.0).expect("a light"))
    };
    let one = of(0.6832);
    for times in [0.01, 0.1, 10.0, 100.0, 290.0] {
        let share = of(0.6832 * times) / (times * one);
        assert!((share - 1.0).abs() < 3e-3, "{times} times as much: {share}");
    }
}

/// Counts are halved when they are full, which no percentile shows.
#[test]
fn a_quarter_of_an_hour_is_as_good_as_three_minutes() {
    let light = |t: f64| 1.0 + 0.01 * (TAU * 8.8 * t).sin() + 0.02 * (TAU * 0.35 * t).sin();
    let [short, long] =
        [180.0, 900.0].map(|seconds| found(&readings(1000.0, seconds, light), 1000.0).expect("a light"));
    assert!((long / short - 1.0).abs() < 1e-3, "{long}, {short}");
    // A minute of flicker and nine of quiet: the percentiles of the quiet are from counts below all classes.
    let calm = |t: f64| if t < 80.0 { light(t) } else { 1.0 + 1e-6 * (TAU * 8.8 * t).sin() };
    let exact = pst_lm(&readings(1000.0, 620.0, calm), 1000.0);
    let found = f64::from(found(&readings(1000.0, 620.0, calm), 1000.0).expect("a light"));
    assert!((found / exact - 1.0).abs() < 5e-3, "{found}, {exact}");
}

#[test]
fn steady_light_has_none_whatever_its_level() {
    for level in [1.0, 0.1, 1.0 / 3.0, 65_535.0, 1e-9, 1e15] {
        assert_eq!(found(&vec![level; 31_000], 1000.0), Ok(0.0), "{level}");
    }
    // A lamp that is turned on in time is steady, too.
    let turned_on = readings(1000.0, 60.0, |t| if t < 0.5 { 0.0 } else { 1000.0 });
    let severity = found(&turned_on, 1000.0).expect("a light");
    assert!(severity < 0.01, "{severity}");
    // The last bit of a converter of 12 bits.
    let noisy = readings(2000.0, 40.0, |t| 2000.0 + (t * 7919.0 * 7907.0).fract().round());
    let severity = found(&noisy, 2000.0).expect("a light");
    assert!((1e-4..0.02).contains(&severity), "{severity}");
}

#[test]
fn what_cannot_be_told_is_said() {
    for rate_hz in [0.0, -1000.0, 399.9, 50_001.0, f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert!(LightFlickermeter::new(rate_hz).is_none(), "{rate_hz}");
    }
    assert!(LightFlickermeter::new(400.0).is_some() && LightFlickermeter::new(50_000.0).is_some());
    assert_eq!(found(&[], 1000.0), Err(PstLmError::TooShort));
    assert_eq!(found(&vec![1.0; 29_999], 1000.0), Err(PstLmError::TooShort));
    assert_eq!(found(&vec![1.0; 30_000], 1000.0), Ok(0.0));
    assert_eq!(found(&vec![1.0; 299_999], 10_000.0), Err(PstLmError::TooShort));
    assert_eq!(found(&vec![1.0; 300_000], 10_000.0), Ok(0.0));
    assert_eq!(found(&vec![0.0; 30_000], 1000.0), Err(PstLmError::NoLight));
    assert_eq!(found(&vec![-5.0; 30_000], 1000.0), Err(PstLmError::NoLight));
    for bad in [f64::NAN, f64::INFINITY, -1e16, 1.1e15] {
        let mut light = vec![1.0; 30_000];
        light[7] = bad;
        assert_eq!(found(&light, 1000.0), Err(PstLmError::NotANumber), "{bad}");
    }
    assert_eq!(PstLmError::NoLight.to_string(), "there is no light");
    assert_eq!(PstLmError::TooShort.to_string(), "needs readings of 30 s or more");
    assert_eq!(PstLmError::NotANumber.to_string(), "a reading is not a number, or too large");
}

/// The largest readings, in the order that moves the filters most, and readings of both signs.
#[test]
fn extreme_readings_have_a_severity_that_is_a_number() {
    let huge = readings(400.0, 31.0, |t| if (8.8 * t).fract() < 0.5 { 1e15 } else { 0.0 });
    let severity = found(&huge, 400.0).expect("a light");
    assert!((severity / 293.0 - 1.0).abs() < 0.02, "{severity}");
    let both = readings(400.0, 31.0, |t| if (8.8 * t).fract() < 0.5 { 1e15 } else { -0.999e15 });
    assert!(found(&both, 400.0).expect("a light").is_finite());
    let dim = readings(400.0, 31.0, |t| {
        1e-11 * (1.0 + 0.003_416 * if (8.8 * t).fract() < 0.5 { 1.0 } else { -1.0 })
    });
    let severity = found(&dim, 400.0).expect("a light");
    assert!((severity - 1.0).abs() < 0.01, "{severity}");
    let tiny = vec![f64::from(f32::from_bits(1)); 13_000];
    assert_eq!(found(&tiny, 400.0), Err(PstLmError::NoLight));
}
