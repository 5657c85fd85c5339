//! The compiler combines a lamp with the eye into one small matrix. In flash there are no 1 nm tables, but
//! only 16 numbers for each of X, Y and Z, and a reflectance becomes a color by 48 multiplications. This is
//! for color sensors, printers and other devices that have one lamp of their own and little memory.
//!
//! `cargo run --release --example lamp_in_flash`

use nanospectra::color::Xyz;
use nanospectra::light::FL11;
use nanospectra::observer::CIE_1931;
use nanospectra::{Curve, Observer, Reflectance};

/// The eye and the lamp on 16 bands over 380..730 nm, which is the default range. White has Y = 100.
static EYE: Observer<3, 16> = CIE_1931.under(&FL11.fine()).fold(Curve::Spline).with_white_y(100.0);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("{} bytes of flash", size_of_val(&EYE));

    let white = Xyz::from(EYE.sees(&Reflectance::flat(1.0)));
    let gray = Xyz::from(EYE.sees(&Reflectance::flat(0.184)));
    let xy = white.xy().ok_or("the lamp is dark")?;
    let lab = gray.lab(white).ok_or("the lamp is dark")?;
    println!("white paper: x {:.4}, y {:.4}, Y {:.1}", xy.x, xy.y, white.y);
    println!("a gray card of 18.4 %: Y {:.2}, L* {:.1}", gray.y, lab.l);

    // By CIE 15:2018, FL11 has x = 0.3805, y = 0.3769. The matrix keeps the color of the light, however few
    // the bands are.
    assert!((xy.x - 0.3805).abs() < 3e-4 && (xy.y - 0.3769).abs() < 3e-4);
    // By ISO/CIE 11664-4, L* = 116 (Y / Yn)^(1/3) - 16, which is 50 for 18.4 %, and a* = b* = 0 for a gray.
    assert!((lab.l - 50.0).abs() < 0.05 && lab.chroma() < 1e-3);
    assert_eq!(size_of_val(&EYE), 3 * 16 * 4);
    Ok(())
}
