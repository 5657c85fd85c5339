//! Automatic exposure: the right one is found quickly, and kept.

use model::noise::Noise;
use nanospectra::sensor::{Advice, AutoExposure, Exposure, LadderError, chip::as7341};

/// What eight channels count of a light at an exposure: the brightest `light` basic counts.
fn counted(light: f64, exposure: &Exposure, mut noise: impl FnMut(f64) -> f64) -> [u16; 8] {
    [0.1, 0.3, 0.5, 0.7, 1.0, 0.9, 0.6, 0.4].map(|share| {
        let count = light * share / f64::from(exposure.per_count());
        (count + noise(count)).clamp(0.0, exposure.full_scale().into()) as u16
    })
}

/// Basic counts over six decades, from hardly one count at the most sensitive exposure to just below full
/// scale at the least sensitive one.
fn six_decades() -> impl Iterator<Item = f64> {
    (0..=600).map(|step| 7e-4 * 10_f64.powf(f64::from(step) / 100.0))
}

#[test]
fn any_light_is_found_in_four_readings_from_anywhere() {
    let auto = AutoExposure::new(&as7341::LADDER).expect("a ladder");
    let mut longest = 0;
    for light in six_decades() {
        for start in 0..as7341::LADDER.len() {
            let (mut place, mut readings) = (start, 1);
            loop {
                let advice = auto.advise(place, &counted(light, &auto.exposure(place), |_| 0.0));
                if advice.next == place {
                    assert!(!advice.saturated, "{light} from {start}: saturated at {place}");
                    break;
                }
                place = advice.next;
                readings += 1;
                assert!(readings <= 4, "{light} from {start}: still moving at {place}");
            }
            longest = longest.max(readings);
            // It is the right one: the next would be too much, or there is none.
            let share = |place: usize| {
                let exposure = auto.exposure(place);
                light / f64::from(exposure.per_count()) / f64::from(exposure.full_scale())
            };
            assert!(place == 0 || share(place) < 0.9, "{light} from {start}");
            let last = as7341::LADDER.len() - 1;
            assert!(place == last || share(place + 1) > 0.78, "{light} from {start}: stops at {place}");
        }
    }
    println!("at most {longest} readings");
}

#[test]
fn noise_does_not_make_the_exposure_swing() {
    let auto = AutoExposure::new(&as7341::LADDER).expect("a ladder");
    let mut noise = Noise(0x0dd5_eed0_dd5e_ed01);
    for light in six_decades().step_by(3) {
        let mut place = 7;
        let mut moves = Vec::new();
        for reading in 0..60 {
            // 1 % of the count, and two counts.
            let counts = counted(light, &auto.exposure(place), |count| noise.normal() * (2.0 + 0.01 * count));
            let advice = auto.advise(place, &counts);
            if advice.next != place {
                moves.push((reading, place, advice.next));
            }
            place = advice.next;
        }
        // The last settling may take long where noise decides, but there is no way back.
        let back = moves.iter().filter(|(reading, from, to)| *reading > 5 && to < from).count();
        assert_eq!(back, 0, "{light}: {moves:?}");
        assert!(moves.len() <= 5, "{light}: {moves:?}");
    }
}

/// Between the target and half way from it to full scale an exposure is neither left nor taken.
#[test]
fn an_exposure_is_left_only_half_way_between_the_target_and_full_scale() {
    let ladder = [1.0, 2.0].map(|gain| Exposure::new(gain, 50.0, 10_000));
    let auto = AutoExposure::new(&ladder).expect("a ladder");
    for (target, keeps, leaves) in [(0.8, 8999, 9001), (0.5, 7500, 7501), (0.6, 7999, 8001)] {
        let auto = auto.with_target(target);
        let next = |count: u16| auto.advise(1, &[10, count]);
        assert_eq!(next(keeps), Advice { next: 1, saturated: false }, "{target}");
        assert_eq!(next(leaves), Advice { next: 0, saturated: false }, "{target}");
    }
}

/// A count of 7 may be of a light of nearly 8, which must fit where it is sent, as must a bright one.
#[test]
fn a_count_may_be_one_more_than_it_says() {
    let auto = AutoExposure::new(&as7341::LADDER).expect("a ladder");
    for place in 0..as7341::LADDER.len() {
        for count in (0..300_u16).chain((300..50_000).step_by(97)) {
            let next = auto.advise(place, &[count]).next;
            let light = (f32::from(count) + 1.0) * auto.exposure(place).per_count();
            let share = light / auto.exposure(next).per_count() / auto.exposure(next).full_scale() as f32;
            assert!(next <= place || share < 0.8 * 1.000_001, "{count} at {place}: {share} of {next}");
        }
    }
}

/// A steady light that counts 64 or more is not sent on from where the first advice sent it.
#[test]
fn after_64_counts_and_more_the_first_advice_is_the_last() {
    let ladder: [Exposure; 10] =
        std::array::from_fn(|k| Exposure::new(f32::from(1_u16 << k), 50.0, u16::MAX.into()));
    let auto = AutoExposure::new(&ladder).expect("a ladder");
    for quarters in 4 * 64..4 * 50_000_u32 {
        let count = |place: usize| [(quarters << place) as f32 / 4.0].map(f32::floor);
        let first = auto.advise(0, &count(0)).next;
        let then = auto.advise(first, &count(first));
        assert_eq!(then, Advice { next: first, saturated: false }, "{} counts", quarters as f32 / 4.0);
    }
}

#[test]
fn advice_never_leaves_the_ladder() {
    let auto = AutoExposure::new(&as7341::LADDER).expect("a ladder");
    for place in [0, 3, 14, 15, 1000, usize::MAX] {
        for count in [0_u16, 1, 20_000, u16::MAX] {
            assert!(auto.advise(place, &[count; 8]).next < 15);
        }
    }
    assert_eq!(auto.advise(0, &[u16::MAX; 8]), Advice { next: 0, saturated: true });
    assert_eq!(auto.advise(9, &[100.0, f32::NAN]), Advice { next: 9, saturated: false });
    assert_eq!(auto.advise(4, &[0_u16; 0]).next, 14);
    let one = [Exposure::new(1.0, 1.0, 100)];
    let auto = AutoExposure::new(&one).expect("a ladder of one").with_target(f32::NAN);
    assert_eq!(auto.advise(0, &[99_u16]), Advice { next: 0, saturated: false });
    assert_eq!(auto.middle(), 0);
}

#[test]
fn a_ladder_that_is_none_is_refused() {
    let good = Exposure::new(1.0, 50.0, 18_000);
    assert_eq!(AutoExposure::new(&[]), Err(LadderError::Empty));
    assert_eq!(AutoExposure::new(&[good, good]), Err(LadderError::NotSorted { index: 1 }));
    for (gain, time, full) in
        [(0.0, 1.0, 1), (-1.0, -1.0, 1), (f32::NAN, 1.0, 1), (1.0, f32::INFINITY, 1), (2.0, 50.0, 0)]
    {
        let bad = [good, Exposure::new(gain, time, full)];
        assert_eq!(AutoExposure::new(&bad), Err(LadderError::CannotCount { index: 1 }), "{gain} {time}");
    }
    assert!(LadderError::NotSorted { index: 1 }.to_string().contains("exposure 1"));
}
