//! Rows 25 to 40: sigmoids, Lab, sRGB, color differences, color temperature.

use super::judge::{Judge, Off, absolute, relative, share, zero};
use model::{cct, delta_e, transfer};
use nanospectra_hard::cases::color::STEEP;

pub const JUDGES: &[(&str, Judge)] = &[
    ("25", |at, got| relative(got, &[sigmoid(at[0])])),
    ("26", |at, got| absolute(got, &[if at[0] > 0.0 { 1.0 } else { 0.0 }])),
    ("27", |at, got| {
        let [a, b, c] = STEEP.map(f64::from);
        let x = (at[0] - 580.0) / 200.0;
        absolute(got, &[sigmoid((a * x + b) * x + c)])
    }),
    ("28", |at, got| relative(got, &[at[0].cbrt()])),
    ("29", |_, got| absolute(&[got[1] - got[0]], &[0.0])),
    ("30", |at, got| {
        let (knee, kappa) = (216.0 / 24389.0, 24389.0 / 27.0);
        relative(got, &[if at[0] > knee { 116.0 * at[0].cbrt() - 16.0 } else { kappa * at[0] }])
    }),
    ("31a", zero),
    ("31b", zero),
    ("31c", zero),
    ("32a", zero),
    ("32b", |at, got| absolute(got, &[at[0]])),
    ("33", |at, got| absolute(got, &[transfer::srgb_encode(at[0].abs()).copysign(at[0])]).per(1.0 / 65535.0)),
    ("34a", difference),
    ("34b", difference),
    ("34c", |at, got| share(got, &[exact_difference(at)])),
    ("35", difference),
    ("36", |at, got| share(got, &[exact_difference(at)])),
    ("37", mired),
    ("38", mired),
    ("39", mired),
    ("40", zero),
];

fn sigmoid(x: f64) -> f64 {
    let h = 1f64.hypot(x);
    let tail = 0.5 / (h * (h + x.abs()));
    if x > 0.0 { 1.0 - tail } else { tail }
}

fn exact_difference(at: &[f64]) -> f64 {
    delta_e::de2000([at[0], at[1], at[2]], [at[3], at[4], at[5]])
}

fn difference(at: &[f64], got: &[f64]) -> Off {
    absolute(got, &[exact_difference(at)])
}

fn mired(at: &[f64], got: &[f64]) -> Off {
    absolute(&[1e6 / got[0]], &[1e6 / cct::cct([at[0], at[1]]).cct_k])
}
