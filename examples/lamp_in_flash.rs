//! A lamp folded into the eye by the compiler: of the 1 nm tables nothing is left in flash but 16 numbers for
//! each of X, Y and Z, and reading a reflectance is 48 multiplications. For color sensors, printers and
//! everything else that has one lamp of its own and little memory.
//!
//! `cargo run --release --example lamp_in_flash`

use nanospectra::color::Xyz;
use nanospectra::light::FL11;
use nanospectra::observer::CIE_1931;
use nanospectra::{Curve, Observer, Reflectance};

/// Eye and lamp on 16 bands over 380..730 nm (the default range); a white surface has Y = 100.
static EYE: Observer<3, 16> = CIE_1931.under(&FL11.fine()).fold(Curve::Spline).with_white_y(100.0);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("{} bytes of flash", size_of_val(&EYE));

    let white = Xyz::from(EYE.sees(&Reflectance::flat(1.0)));
    let gray = Xyz::from(EYE.sees(&Reflectance::flat(0.184)));
    let xy = white.xy().ok_or("the lamp is dark")?;
    let lab = gray.lab(white).ok_or("the lamp is dark")?;
    println!("white paper: x {:.4}, y {:.4}, Y {:.1}", xy.x, xy.y, white.y);
    println!("a gray card of 18.4 %: Y {:.2}, L* {:.1}", gray.y, lab.l);

    // CIE 15:2018: FL11 has x = 0.3805, y = 0.3769. The fold keeps the color of the light, however few the
    // bands.
    assert!((xy.x - 0.3805).abs() < 3e-4 && (xy.y - 0.3769).abs() < 3e-4);
    // ISO/CIE 11664-4: L* = 116 (Y / Yn)^(1/3) - 16, 50 for 18.4 %, and a gray has neither a* nor b*.
    assert!((lab.l - 50.0).abs() < 0.05 && lab.chroma() < 1e-3);
    assert_eq!(size_of_val(&EYE), 3 * 16 * 4);
    Ok(())
}
