//! From the samples of a spectroradiometer, this example computes the color of a lamp: XYZ, CCT with Duv, and
//! the color rendering index Ra. It is for everyone who has a table of wavelengths and values and needs the
//! numbers of a data sheet.
//!
//! `cargo run --release --example lamp_color`

use nanospectra::color::{Xyz, cri};
use nanospectra::observer::CIE_1931;
use nanospectra::{Fine, Light, Nodes, Power};

/// Relative spectral power at 380, 385, .. 780 nm. Here it is CIE illuminant FL11, a three-band fluorescent
/// lamp (CIE 15:2018, CC BY-SA 4.0), so that the results can be checked.
const SAMPLES: [f32; 81] = [
    0.91, 0.63, 0.46, 0.37, 1.29, 12.68, 1.59, 1.79, 2.46, 3.33, 4.49, 33.94, 12.13, 6.95, 7.19, 7.12, 6.72,
    6.13, 5.46, 4.79, 5.66, 14.29, 14.96, 8.97, 4.72, 2.33, 1.47, 1.10, 0.89, 0.83, 1.18, 4.90, 39.59, 72.84,
    32.61, 7.52, 2.83, 1.96, 1.67, 4.43, 11.28, 14.76, 12.73, 9.74, 7.33, 9.72, 55.27, 42.58, 13.18, 13.16,
    12.26, 5.11, 2.07, 2.34, 3.58, 3.01, 2.48, 2.14, 1.54, 1.33, 1.46, 1.94, 2.00, 1.20, 1.35, 4.10, 5.58,
    2.51, 0.57, 0.27, 0.23, 0.21, 0.24, 0.24, 0.20, 0.24, 0.32, 0.26, 0.16, 0.12, 0.09,
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // The sums of the CIE take values every 1 nm from 360 to 830 nm, so the samples are interpolated.
    // (Samples at other spacings are pairs of a wavelength and a value; `Fine::interpolated` takes those.)
    let measured = Light::<81, Nodes<380, 780>>::from_bins(SAMPLES);
    let lamp: Fine<Power> = measured.fine();

    // The values are relative, so XYZ is scaled to Y = 100.
    let xyz = Xyz::from(CIE_1931.sees(&lamp)).with_y(100.0).ok_or("the lamp is dark")?;
    let xy = xyz.xy().ok_or("the lamp is dark")?;
    let (cct_k, duv) = xy.uv1960().cct().near().ok_or("the lamp is not white, so it has no CCT")?;
    let ra = cri(&lamp)?.ra;

    println!("XYZ  {:.2}, {:.2}, {:.2} (Y = 100)", xyz.x, xyz.y, xyz.z);
    println!("xy   {:.4}, {:.4}", xy.x, xy.y);
    println!("CCT  {cct_k:.0} K, Duv {duv:+.4}");
    println!("Ra   {ra:.1}");

    // CIE 15:2018 lists FL11 with x = 0.3805, y = 0.3769, 4000 K and Ra = 83.
    assert!((xy.x - 0.3805).abs() < 3e-4 && (xy.y - 0.3769).abs() < 3e-4);
    assert!((cct_k - 4000.0).abs() < 8.0 && duv.abs() < 1e-3);
    assert!((ra - 83.0).abs() < 0.5);
    Ok(())
}
