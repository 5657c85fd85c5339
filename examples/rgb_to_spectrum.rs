//! This example finds a smooth reflectance that has exactly a given sRGB color in daylight. It converts the
//! reflectance back to sRGB, and computes how it looks under another lamp. It is for renderers and paint
//! programs that have an RGB color and need a spectrum.
//!
//! `cargo run --release --example rgb_to_spectrum`

use nanospectra::color::{EncodedRgb, Srgb, Xyz};
use nanospectra::light::{A, D65};
use nanospectra::observer::CIE_1931;
use nanospectra::upsample::{Sigmoid, Status, Viewing};
use nanospectra::{Curve, Factor, Nodes, Observer, Reflectance};

/// There are 31 bands, every 10 nm.
type Grid = Nodes<400, 700>;

/// The eye in daylight (D65), under which sRGB is defined. The compiler computes it, as well as the two
/// statics that follow.
static IN_DAYLIGHT: Observer<3, 31, Factor, Grid> =
    CIE_1931.under(&D65.fine()).fold(Curve::Step).with_white_y(100.0);
static VIEWING: Viewing<31, Grid> = Viewing::new(&IN_DAYLIGHT);
static SIGMOID: Sigmoid<31, Grid> = Sigmoid::new(&VIEWING);

/// The same eye at home, under an incandescent lamp (CIE illuminant A).
static AT_HOME: Observer<3, 31, Factor, Grid> =
    CIE_1931.under(&A.fine()).fold(Curve::Step).with_white_y(100.0);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let code = [210, 105, 30]; // #d2691e, "chocolate" in CSS
    let rgb = EncodedRgb::<Srgb>::from_u8(code).decode();

    let solved = SIGMOID.reflectance(rgb);
    let paint: Reflectance<31, Grid> = solved.spectrum.on_grid();
    for (nm, share) in paint.iter().step_by(5) {
        println!("{nm} nm: {:4.1} %", 100.0 * share);
    }

    let back = VIEWING.rgb(&paint);
    println!("back in sRGB: {:?}", back.encode().to_u8());

    let xyz = Xyz::from(AT_HOME.sees(&paint));
    let white = Xyz::from(AT_HOME.sees(&Reflectance::flat(1.0)));
    let lab = xyz.lab(white).ok_or("the lamp is dark")?;
    println!("under lamp A: L* {:.1}, a* {:.1}, b* {:.1}", lab.l, lab.a, lab.b);

    // The 8-bit code is the same again, and the reflectance is one that a real surface can have.
    assert_eq!((solved.status, back.encode().to_u8()), (Status::Exact, code));
    assert!(paint.values().iter().all(|share| (0.0..=1.0).contains(share)));
    // By IEC 61966-2-1, the luminance of a linear sRGB color is 0.2126 R + 0.7152 G + 0.0722 B.
    let y = 0.2126 * rgb.r + 0.7152 * rgb.g + 0.0722 * rgb.b;
    let [_, seen, _] = IN_DAYLIGHT.sees(&paint);
    assert!((seen - 100.0 * y).abs() < 1e-2);
    // By CIE 15:2018, illuminant A has XYZ = 109.85, 100, 35.58.
    assert!((white.x - 109.85).abs() < 0.01 && (white.z - 35.58).abs() < 0.01);
    Ok(())
}
