//! This example computes what a lens reflects with an anti-reflection coating and without it, at a right
//! angle and at 45 degrees, and the purple color of the light that the coating still reflects. It is for
//! everyone who works with thin films, such as coatings, oxide layers and soap.
//!
//! `cargo run --release --example lens_coating`

use nanospectra::color::{Lab, Xyz};
use nanospectra::light::D65;
use nanospectra::matter::ThinFilm;
use nanospectra::observer::CIE_1931;
use nanospectra::{Curve, Observer, Reflectance};

/// The eye in daylight, on 31 bands over 380..730 nm. A perfect mirror has Y = 100.
static EYE: Observer<3, 31> = CIE_1931.under(&D65.fine()).fold(Curve::Spline).with_white_y(100.0);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Light goes from air through magnesium fluoride into crown glass. The coating is a quarter of a wave
    // thick at 550 nm.
    let indices = [1.0, 1.38, 1.52];
    let coating = ThinFilm::new(indices, 550.0 / (4.0 * 1.38));
    let bare = ThinFilm::new(indices, 0.0);

    let white = Xyz::from(EYE.sees(&Reflectance::flat(1.0)));
    for (name, film) in [("bare", bare), ("coated", coating)] {
        for degrees in [0.0_f32, 45.0] {
            let reflected: Reflectance<31> = film.reflectance(degrees.to_radians().cos());
            let xyz = Xyz::from(EYE.sees(&reflected));
            let Lab { a, b, .. } = xyz.lab(white).ok_or("the lamp is dark")?;
            println!("{name}, {degrees} degrees: {:.2} % of daylight, a* {a:+.1}, b* {b:+.1}", xyz.y);
        }
    }

    // At a right angle, glass of index n reflects ((1 - n) / (1 + n))^2 = 4.26 % (Fresnel). With a quarter of
    // a wave of index n1 on it, it reflects ((n - n1^2) / (n + n1^2))^2 = 1.26 % (Born and Wolf, Principles
    // of Optics, 1.6).
    let [s, p] = bare.at(550.0, 1.0);
    assert!((s.reflected - 0.0426).abs() < 5e-5 && (p.reflected - 0.0426).abs() < 5e-5);
    let [s, p] = coating.at(550.0, 1.0);
    assert!((s.reflected - 0.0126).abs() < 5e-5 && (p.reflected - 0.0126).abs() < 5e-5);
    Ok(())
}
