//! The axis of every picture, on ranges that nobody chose.

use nanospectra_cli::picture::Area;
use nanospectra_cli::picture::axis::{Axis, Frame};
use proptest::prelude::*;
use std::collections::HashSet;

/// Any finite f64, from subnormals to the largest, with those that people try more often.
fn finite() -> impl Strategy<Value = f64> {
    use proptest::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    let edges = [0.0, -0.0, 5e-324, 1e-45, 1e-310, f64::MIN_POSITIVE, 1.0, 3.4e38, f64::MAX, f64::MIN];
    prop_oneof![
        POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO,
        proptest::sample::select(edges.to_vec()),
        0.0..1e5
    ]
}

/// Two ends: of any kind, the same, or neighbors.
fn ends() -> impl Strategy<Value = (f64, f64)> {
    prop_oneof![
        (finite(), finite()),
        finite().prop_map(|end| (end, end)),
        finite().prop_map(|end| (end, if end == f64::MAX { end.next_down() } else { end.next_up() })),
        (finite(), -1e-3..1e-3_f64)
            .prop_map(|(end, share)| (end, (end - end * share).clamp(f64::MIN, f64::MAX))),
    ]
}

fn assert_sound(axis: &Axis, low: f64, high: f64) -> Result<(), TestCaseError> {
    let ticks = axis.ticks();
    prop_assert!((2..=22).contains(&ticks.len()), "{} ticks: {axis:?}", ticks.len());
    let texts: HashSet<&str> = ticks.iter().map(|(_, text)| text.as_str()).collect();
    prop_assert_eq!(texts.len(), ticks.len(), "{:?}", ticks);
    for (share, text) in &ticks {
        prop_assert!((-1e-3..=1.001).contains(share), "{share} {text}");
        prop_assert!(text.len() <= 16, "{text}");
        // The number that is written is the one that the tick stands at.
        let read: f64 = text.parse().expect("a number");
        // (Near the smallest and the largest f64 there are not enough digits for that, or no number.)
        if (1e-300..1e300).contains(&read.abs()) {
            prop_assert!(
                (axis.share(read) - share).abs() < 1e-3,
                "{text} is at {} and not {share}",
                axis.share(read)
            );
        }
    }
    let (low, high) = (low.min(high), low.max(high));
    let [from, to] = [low, high].map(|end| axis.share(end));
    prop_assert!(from >= -1e-3 && to <= 1.001 && from <= to, "{from}..{to}");
    let area = Area { left: 80.0, top: 90.0, width: 560.0, height: 330.0 };
    let frame = Frame { area, x: *axis, y: *axis };
    for value in [low, high, 0.0, f64::MAX, f64::MIN] {
        let (x, y) = frame.place(value, value);
        prop_assert!(x.abs() < 1e5 && y.abs() < 1e5, "{value} at {x} {y}");
    }
    let drawn = frame.draw("x", "y").to_string();
    prop_assert!(drawn.len() < 20_000 && !drawn.contains("NaN") && !drawn.contains("inf"));
    Ok(())
}

proptest! {
    #[test]
    fn an_axis_holds_every_range((low, high) in ends()) {
        assert_sound(&Axis::holding(low, high), low, high)?;
    }

    #[test]
    fn an_axis_with_given_ends_has_few_numbers(low in 0.0..1e4_f64, length in 1e-3..1e4_f64, step in 0.0..1e3_f64) {
        let ticks = Axis::between(low, low + length, step).ticks();
        prop_assert!(ticks.len() <= 22 && ticks.iter().all(|(share, _)| (-1e-3..=1.001).contains(share)));
    }
}

#[test]
fn numbers_are_round() {
    let texts =
        |low, high| Axis::holding(low, high).ticks().into_iter().map(|(_, text)| text).collect::<Vec<_>>();
    assert_eq!(texts(0.0, 0.93), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
    assert_eq!(texts(0.0, 250_000.0), ["0.0", "0.5e5", "1.0e5", "1.5e5", "2.0e5", "2.5e5"]);
    assert_eq!(texts(0.0, 5e-324), ["0", "1e-324", "2e-324", "3e-324", "4e-324", "5e-324"]);
    assert_eq!(texts(7.0, 7.0), ["2", "4", "6", "8", "10", "12"]);
}
