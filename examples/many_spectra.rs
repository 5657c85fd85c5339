//! This example computes XYZ and CCT of many spectra at once. Here they are of a furnace that heats up and is
//! measured a thousand times, every 5 nm. It is for logs, hyperspectral images and production lines.
//!
//! `cargo run --release --example many_spectra`

use nanospectra::color::Xyz;
use nanospectra::light::blackbody_relative;
use nanospectra::observer::CIE_1931;
use nanospectra::{Curve, Light, Nodes, Observer, Power};
use std::time::Instant;

/// The bands of the instrument: 380, 385, .. 780 nm.
type Grid = Nodes<380, 780>;

static EYE: Observer<3, 81, Power, Grid> = CIE_1931.fold(Curve::Spline);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // The furnace is a black body, at temperatures from 1500 K in steps of 10 K.
    let kelvins: Vec<f32> = (0..1000).map(|k| 1500.0 + 10.0 * k as f32).collect();
    let spectra: Vec<Light<81, Grid>> =
        kelvins.iter().map(|&kelvin| Light::averaged(|nm| blackbody_relative(nm, kelvin))).collect();

    let mut xyz = vec![[0.0; 3]; spectra.len()];
    let start = Instant::now();
    EYE.sees_each(&spectra, &mut xyz);
    println!("{} spectra to XYZ in {:?}", spectra.len(), start.elapsed());

    // By definition, the CCT of a black body is its temperature. (Errors are compared in mired, 1e6 / K, in
    // which they are about equally visible at all temperatures. 1 mired is hardly visible.)
    let mut worst_mired = 0.0_f32;
    for (&kelvin, &xyz) in kelvins.iter().zip(&xyz) {
        let uv = Xyz::from(xyz).uv1960().ok_or("dark")?;
        let (cct_k, duv) = uv.cct().near().ok_or("not white")?;
        worst_mired = worst_mired.max((1e6 / cct_k - 1e6 / kelvin).abs());
        assert!(duv.abs() < 1e-4);
    }
    println!("CCT is off by at most {worst_mired:.3} mired");
    assert!(worst_mired < 0.1);
    Ok(())
}
