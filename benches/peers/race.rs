//! Times two ways of doing the same. They take turns, so that a disturbance of the machine slows both.

use serde_json::{Value, json};
use std::hint::black_box;
use std::time::Instant;

/// Collects the comparisons and prints them.
pub struct Races {
    /// Whether to call everything only once, to see that it runs.
    test: bool,
    rows: Vec<Row>,
}

struct Row {
    what: String,
    ours_ns: f64,
    theirs: &'static str,
    theirs_ns: f64,
    /// The ratio of theirs to ours that is expected at least.
    bar: Option<f64>,
    /// The largest errors of ours and theirs against f64, if they are compared.
    errors: Option<[f64; 2]>,
}

impl Races {
    pub fn new(test: bool) -> Self {
        Races { test, rows: Vec::new() }
    }

    /// Times ours against theirs. One call of either does the work of `per` operations, and times are for one
    /// operation.
    pub fn run<A, B>(
        &mut self,
        what: impl Into<String>,
        bar: impl Into<Option<f64>>,
        per: f64,
        mut ours: impl FnMut() -> A,
        (theirs, mut other): (&'static str, impl FnMut() -> B),
    ) {
        let counts = if self.test { [1, 1] } else { [calls(&mut ours), calls(&mut other)] };
        let mut times = [Vec::new(), Vec::new()];
        for _ in 0..if self.test { 1 } else { 101 } {
            times[0].push(time(counts[0], &mut ours) / per);
            times[1].push(time(counts[1], &mut other) / per);
        }
        let [ours_ns, theirs_ns] = times.map(median);
        self.rows.push(Row { what: what.into(), ours_ns, theirs, theirs_ns, bar: bar.into(), errors: None });
    }

    /// Notes the largest errors of the last comparison, ours and theirs.
    pub fn errors(&mut self, ours: f64, theirs: f64) {
        if let Some(row) = self.rows.last_mut() {
            row.errors = Some([ours, theirs]);
        }
    }

    pub fn print(&self) {
        if self.test {
            return println!("{} comparisons run, and their results are right", self.rows.len());
        }
        println!(
            "{:34} {:>9} {:28} {:>9} {:>7} {:>6}         worst errors",
            "times in ns", "ours", "  against", "theirs", "ratio", "bar"
        );
        for row in &self.rows {
            let ratio = row.theirs_ns / row.ours_ns;
            let (bar, verdict) = match row.bar {
                Some(bar) => (format!("{bar:.2}"), if ratio >= bar { "met" } else { "MISSED" }),
                None => (String::new(), ""),
            };
            let errors = row.errors.map_or(String::new(), |[a, b]| format!("{a:.1e} / {b:.1e}"));
            println!(
                "{:34} {:9.2}   {:26} {:9.2} {ratio:7.2} {bar:>6} {verdict:7} {errors}",
                row.what, row.ours_ns, row.theirs, row.theirs_ns
            );
        }
    }

    pub fn json(&self) -> Value {
        let rows = self.rows.iter().map(|row| {
            json!({
                "what": row.what, "ours_ns": row.ours_ns, "against": row.theirs, "theirs_ns": row.theirs_ns,
                "ratio": row.theirs_ns / row.ours_ns, "bar": row.bar, "errors": row.errors,
            })
        });
        let features = [("avx", cfg!(target_feature = "avx")), ("simd", cfg!(feature = "simd"))];
        let features: Vec<_> = features.iter().filter(|(_, on)| *on).map(|(name, _)| *name).collect();
        json!({ "built_with": features, "rows": rows.collect::<Vec<_>>() })
    }
}

/// How many calls take about 50 microseconds.
fn calls<R>(f: &mut impl FnMut() -> R) -> usize {
    let mut calls = 1;
    while time(calls, f) * (calls as f64) < 50e3 {
        calls *= 2;
    }
    calls
}

/// The nanoseconds of one call.
fn time<R>(calls: usize, f: &mut impl FnMut() -> R) -> f64 {
    let start = Instant::now();
    for _ in 0..calls {
        black_box(f());
    }
    start.elapsed().as_secs_f64() * 1e9 / calls as f64
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Makes a function that takes the inputs in turn.
pub fn each<'a, T, R>(inputs: &'a [T], f: impl Fn(&T) -> R + 'a) -> impl FnMut() -> R + 'a {
    let mut next = inputs.iter().cycle();
    move || f(black_box(next.next().expect("an input")))
}
