//! Times a call on this machine. Such times give an impression, and must not be compared with those of
//! another machine.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// How long a run should last, so that the steps of the clock do not matter.
const RUN: Duration = Duration::from_micros(200);

/// Returns the nanoseconds of one call, as the median of `runs` runs of many calls each.
pub fn nanoseconds<R>(runs: usize, mut call: impl FnMut() -> R) -> f64 {
    let mut calls = 1_u32;
    while timed(calls, &mut call) < RUN && calls < 1 << 24 {
        calls *= 2;
    }
    let mut times: Vec<f64> =
        (0..runs).map(|_| timed(calls, &mut call).as_secs_f64() * 1e9 / f64::from(calls)).collect();
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn timed<R>(calls: u32, call: &mut impl FnMut() -> R) -> Duration {
    let start = Instant::now();
    for _ in 0..calls {
        black_box(call());
    }
    start.elapsed()
}
