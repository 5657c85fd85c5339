//! Read-outs that are not linear, there and back.

use nanospectra::sensor::{DeadTime, Nonlinearity};
use proptest::prelude::*;

/// Units in the last place of `b` between two numbers.
fn ulps(a: f32, b: f32) -> f32 {
    (a - b).abs() / (b.abs().next_up() - b.abs())
}

#[test]
fn a_counter_is_exact_to_rounding_and_comes_back_to_two_ulps() {
    let counter = DeadTime::new(50e-9);
    let (mut worst, mut model) = (0.0f32, 0.0f64);
    for k in 0..20_000 {
        // Up to a sixth of the time dead.
        let arriving = 1e3 * 1.0005f32.powi(k).min(4e3);
        let counted = counter.counted(arriving);
        let exact = f64::from(arriving) / (1.0 + f64::from(50e-9f32) * f64::from(arriving));
        model = model.max((f64::from(counted) / exact - 1.0).abs());
        worst = worst.max(ulps(counter.arrived(counted).expect("below the pole"), arriving));
    }
    println!("dead time: {model:e} of the model, {worst} ulps there and back");
    assert!(model < 2.0 / 16_777_216.0, "{model:e}");
    assert!((1.0..=2.0).contains(&worst), "{worst}");
}

#[test]
fn a_counter_has_a_pole_and_says_so() {
    let counter = DeadTime::new(1e-6);
    assert_eq!(counter.arrived(1e6), None);
    assert_eq!(counter.arrived(2e6), None);
    assert!(counter.arrived(0.99e6).is_some_and(|rate| (rate / 99e6 - 1.0).abs() < 1e-5));
    assert_eq!((counter.counted(0.0), counter.arrived(0.0)), (0.0, Some(0.0)));
    assert_eq!(counter.counted(f32::INFINITY), 1e6);
    assert!(counter.counted(f32::MAX) <= 1e6 * (1.0 + 1e-7));
    assert!(counter.counted(f32::NAN).is_nan() && counter.arrived(f32::NAN).is_some_and(f32::is_nan));
    let ideal = DeadTime::new(0.0);
    assert_eq!((ideal.counted(123.0), ideal.arrived(123.0)), (123.0, Some(123.0)));
    assert_eq!(ideal.counted(f32::INFINITY), f32::INFINITY);
}

#[test]
fn a_counter_comes_back_to_four_ulps_while_half_of_the_time_is_dead_at_most() {
    let counter = DeadTime::new(50e-9);
    let mut worst = 0.0f32;
    for k in 0..200_000 {
        let arriving = 4e6 + 16e6 * (k as f32 / 2e5);
        worst =
            worst.max(ulps(counter.arrived(counter.counted(arriving)).expect("below the pole"), arriving));
    }
    println!("dead up to half of the time: {worst} ulps there and back");
    assert!((2.0..=4.0).contains(&worst), "{worst}");
}

#[test]
fn no_counter_is_at_a_loss() {
    assert_eq!(DeadTime::new(10.0).counted(1e38), 0.1);
    assert_eq!(DeadTime::new(-1e-6).counted(1e6), 1e6, "fewer than no seconds are none");
    assert_eq!(DeadTime::new(0.0).arrived(f32::INFINITY), Some(f32::INFINITY));
    assert_eq!(DeadTime::new(1e-6).arrived(f32::INFINITY), None);
    assert!(DeadTime::new(f32::NAN).counted(1.0).is_nan());
}

/// The straight line starts Newton's steps beyond full scale.
#[test]
fn a_bend_upwards_gives_no_signal_beyond_full_scale() {
    let signal = |bend: Nonlinearity<2>, read: f32| bend.signal(read).expect("a signal");
    assert_eq!(Nonlinearity::new([1.5, -1.0]).map(|bend| signal(bend, 1.5)), Some(1.0));
    assert_eq!(Nonlinearity::new([3.0, -1.0]).map(|bend| signal(bend, bend.read(1.0))), Some(1.0));
    let steep = Nonlinearity::new([10.0, -6.0]).expect("rises");
    assert!((signal(steep, steep.read(0.4083)) - 0.4083).abs() < 1e-6);
}

#[test]
fn what_bends_back_is_refused() {
    assert_eq!(Nonlinearity::new([-0.5]), None);
    assert!(Nonlinearity::new([-0.49]).is_some());
    assert_eq!(Nonlinearity::new([f32::NAN]), None);
    assert_eq!(Nonlinearity::new([0.0, f32::INFINITY]), None);
    // Rises at both ends and falls between them.
    assert_eq!(Nonlinearity::new([-3.0, 2.2]), None);
    assert!(Nonlinearity::<0>::new([]).is_some_and(|straight| straight.signal(0.3) == Some(0.3)));
}

#[test]
fn a_slope_is_refused_once_it_may_reach_zero_between_two_places() {
    // x - c x^2 is flattest at 1, and its slope changes by 2 c: refused from 1 - 2 c = 2 c / 512 on, which is
    // c = 0.499 03.
    assert!(Nonlinearity::new([-0.4990]).is_some());
    assert_eq!(Nonlinearity::new([-0.4991]), None);
    // The slope of x + a x^2 + b x^3 is least half way between two of the 257 places, and below zero only
    // between these two.
    let [a, b] = [-1.992_222_f32, 1.322_98];
    let slope = |x: f64| 1.0 + 2.0 * f64::from(a) * x + 3.0 * f64::from(b) * x * x;
    let between = 128.5 / 256.0;
    assert!(slope(between) < -1e-6 && slope(128.0 / 256.0) > 1e-5 && slope(129.0 / 256.0) > 1e-5);
    assert_eq!(Nonlinearity::new([a, b]), None);
}

#[test]
fn what_no_signal_reads_has_none() {
    let bend = Nonlinearity::new([-0.1, 0.02]).expect("rises");
    assert_eq!(bend.signal(-1e-6), None);
    assert_eq!(bend.signal(bend.read(1.0) + 1e-6), None);
    assert_eq!(bend.signal(0.0), Some(0.0));
    assert!(bend.signal(f32::NAN).is_some_and(f32::is_nan));
    assert_eq!(bend.signal(f32::INFINITY), None);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 20_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_bend_comes_back(c2 in -0.3f32..0.5, c3 in -0.1f32..0.3, signal in 0.0f32..=1.0) {
        let Some(bend) = Nonlinearity::new([c2, c3]) else { return Ok(()) };
        let read = bend.read(signal);
        let back = bend.signal(read);
        let slope = 1.0 + 2.0 * f64::from(c2 * signal) + 3.0 * f64::from(c3 * signal * signal);
        let allowed = 2.0 * f64::from(f32::EPSILON) / slope.min(1.0);
        prop_assert!(back.is_some_and(|back| f64::from((back - signal).abs()) <= allowed), "{back:?} {signal}");
    }

    #[test]
    fn the_steepest_bends_come_back_too(c2 in -0.6f32..12.0, c3 in -7.0f32..2.0, signal in 0.0f32..=1.0) {
        let Some(bend) = Nonlinearity::new([c2, c3]) else { return Ok(()) };
        let Some(back) = bend.signal(bend.read(signal)) else {
            return Err(TestCaseError::fail("no signal"));
        };
        prop_assert!((0.0..=1.0).contains(&back), "{back}");
        prop_assert!((bend.read(back) - bend.read(signal)).abs() <= 4.0 * f32::EPSILON * (1.0 + c2.abs() + c3.abs()));
    }
}
