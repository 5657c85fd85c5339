//! Ratios of two benches of one run, beside the goal. Wall time wobbles, so they are printed and
//! never fail; what may not grow is gated on instruction counts.

use serde_json::Value;
use std::path::PathBuf;
use std::{env, fs};

/// The median of one bench over that of another.
pub struct Ratio {
    of: &'static str,
    to: &'static str,
    goal: f64,
}

impl Ratio {
    pub fn at_most(of: &'static str, to: &'static str, goal: f64) -> Self {
        Ratio { of, to, goal }
    }
}

pub fn print(ratios: &[Ratio]) {
    for Ratio { of, to, goal } in ratios {
        let (Some(a), Some(b)) = (median(of), median(to)) else {
            println!("{of} / {to}: not both measured in this run");
            continue;
        };
        let verdict = if a / b <= *goal { "met" } else { "MISSED" };
        println!("{of} {a:.1} ns / {to} {b:.1} ns = {:.3}, goal {goal:.3}: {verdict}", a / b);
    }
}

/// In ns, from the file that criterion leaves.
fn median(id: &str) -> Option<f64> {
    let target = env::var_os("CARGO_TARGET_DIR").map_or_else(|| PathBuf::from("target"), PathBuf::from);
    let file = target.join("criterion").join(id).join("new/estimates.json");
    let text = fs::read_to_string(file).ok()?;
    serde_json::from_str::<Value>(&text).ok()?["median"]["point_estimate"].as_f64()
}
