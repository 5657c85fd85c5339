//! From the reflectance of a paint, this example computes its CIELAB color under daylight, an incandescent
//! lamp and a fluorescent lamp, and how far each color is from that in daylight (CIEDE2000). It is for
//! everyone who matches surfaces that must look right both in the shop and at home.
//!
//! `cargo run --release --example paint_under_lamps`

use nanospectra::color::{Lab, Xyz, ciede2000};
use nanospectra::observer::CIE_1931;
use nanospectra::{Factor, Fine, Nodes, Reflectance, light};

/// Reflectance at 400, 410, .. 700 nm: the strong red of CIE 13.3 (test sample 9, Munsell 4.5 R 4/13).
const PAINT: [f32; 31] = [
    0.052, 0.051, 0.050, 0.048, 0.046, 0.042, 0.038, 0.033, 0.030, 0.028, 0.028, 0.030, 0.031, 0.032, 0.033,
    0.035, 0.041, 0.048, 0.060, 0.102, 0.190, 0.336, 0.505, 0.641, 0.717, 0.758, 0.781, 0.797, 0.809, 0.819,
    0.828,
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Outside the measured range, the best guess is that the reflectance stays as it is at the ends.
    let measured = Reflectance::<31, Nodes<400, 700>>::from_bins(PAINT);
    let paint: Fine<Factor> = measured.fine();

    let mut in_daylight: Option<Lab> = None;
    // CIE 15:2018 lists the chromaticity of each lamp, which is also that of a white surface under it.
    for (name, [x, y]) in [("D65", [0.3127, 0.3290]), ("A", [0.4476, 0.4074]), ("FL11", [0.3805, 0.3769])] {
        let lamp = light::named(name).ok_or("no such lamp")?;
        // This is the eye in a room that is lit by the lamp. It takes reflectances, and white has Y = 100.
        let eye = CIE_1931.under(&lamp).with_white_y(100.0);
        let white = Xyz::from(eye.sees(&Fine::flat(1.0)));
        let lab = Xyz::from(eye.sees(&paint)).lab(white).ok_or("the lamp is dark")?;

        let daylight = *in_daylight.get_or_insert(lab);
        let delta_e = ciede2000(daylight, lab);
        println!(
            "{name:5} L* {:.1}, a* {:.1}, b* {:.1}: {delta_e:.1} CIEDE2000 from daylight",
            lab.l, lab.a, lab.b
        );

        let xy = white.xy().ok_or("the lamp is dark")?;
        assert!((xy.x - x).abs() < 3e-4 && (xy.y - y).abs() < 3e-4);
    }

    // In daylight a Munsell value of 4 is a lightness L* of about 41.
    assert!(in_daylight.is_some_and(|lab| (lab.l - 41.0).abs() < 1.0));
    Ok(())
}
