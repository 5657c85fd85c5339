//! What a program does not use is not in its image: a look into real executables, built as a user would
//! build them.

use crate::programs::Package;
use nanospectra::light::{A, D65, FL2, FL11, LED_B3, S0};
use nanospectra::matter::{CES, TCS};
use nanospectra::observer::{ALPHA_OPIC, CIE_1931, CIE_1964, CIE_2006_LMS_2, CIE_2015_2, V_SCOTOPIC};

/// The eye under a lamp, folded to 16 bins while compiling.
const FOLDED: &str = "
use nanospectra::{Curve, Observer, Reflectance, light::FL11, observer::CIE_1931};

static EYE: Observer<3, 16> = CIE_1931
    .under(&FL11.fine())
    .fold(Curve::Spline)
    .with_white_y(100.0);

fn main() {
    // Not known while compiling, so that the weights are needed, and as they are.
    let share = std::env::args().count() as f32 / 2.0;
    let [x, y, z] = std::hint::black_box(&EYE).sees(&Reflectance::flat(share));
    println!(\"{x} {y} {z}\");
}
";

/// The eye at 1 nm, for samples as they come.
const FINE: &str = "
use nanospectra::{Fine, Interpolation, Power, observer::CIE_1931};

fn main() {
    let power = std::env::args().count() as f32;
    let samples = [(400.0, power), (700.0, 2.0 * power)];
    let light = Fine::<Power>::interpolated(&samples, Interpolation::Linear);
    println!(\"{:?}\", light.map(|light| std::hint::black_box(&CIE_1931).sees(&light)));
}
";

/// As the numbers lie in memory.
fn bytes(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

fn contains(image: &[u8], values: &[f32]) -> bool {
    let wanted = bytes(values);
    image.windows(wanted.len()).any(|window| window == wanted)
}

/// A piece of every table, from where it is not zero.
fn pieces() -> Vec<(&'static str, &'static [f32])> {
    vec![
        ("x-bar of 1931", &CIE_1931.weights()[0][190..206]),
        ("y-bar of 1931", &CIE_1931.weights()[1][190..206]),
        ("z-bar of 1931", &CIE_1931.weights()[2][80..96]),
        ("y-bar of 1964", &CIE_1964.weights()[1][190..206]),
        ("y-bar of 2015", &CIE_2015_2.weights()[1][190..206]),
        ("the L cone", &CIE_2006_LMS_2.weights()[0][190..206]),
        ("V'", &V_SCOTOPIC.weights()[0][140..156]),
        ("melanopsin", &ALPHA_OPIC.weights()[4][120..136]),
        ("A", &A.values()[250..258]),
        ("D65", &D65.values()[250..258]),
        ("FL2", &FL2.values()[30..38]),
        ("FL11", &FL11.values()[30..38]),
        ("LED-B3", &LED_B3.values()[30..38]),
        ("S0", &S0.values()[40..48]),
        ("TCS01", &TCS[0].values()[200..208]),
        ("CES01", &CES[0].values()[200..208]),
        ("CES99", &CES[98].values()[200..208]),
    ]
}

#[test]
fn only_the_tables_that_a_program_uses_are_in_its_image() {
    let package = Package::using_the_crate("image", &[("folded", FOLDED), ("fine", FINE)]);
    let output = package.cargo(&["build", "--release"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let read = |program: &str| {
        let path = package
            .folder
            .join("target/release")
            .join(program)
            .with_extension(std::env::consts::EXE_EXTENSION);
        let image = std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let run = std::process::Command::new(&path).output().expect("the program runs");
        (image, String::from_utf8_lossy(&run.stdout).into_owned())
    };
    let ((folded, reflected), (fine, seen)) = (read("folded"), read("fine"));

    // The folded program has the weights that this test folds, and reports half the white.
    let eye: nanospectra::Observer<3, 16> =
        CIE_1931.under(&FL11.fine()).fold(nanospectra::Curve::Spline).with_white_y(100.0);
    for row in eye.weights() {
        assert!(contains(&folded, row), "the folded weights are missing");
        assert!(!contains(&fine, row), "folded weights in a program that has none");
    }
    assert!(reflected.contains(" 50 ") || reflected.contains(" 50.0"), "{reflected}");
    assert!(seen.starts_with("Ok(["), "{seen}");

    for (name, values) in pieces() {
        assert!(values.iter().all(|v| *v != 0.0), "{name}: zeros prove nothing");
        assert!(!contains(&folded, values), "{name} is in the image of a folded program");
        assert_eq!(contains(&fine, values), name.ends_with("of 1931"), "{name} in the 1 nm program");
    }
}

#[test]
fn a_folded_observer_is_its_weights_and_nothing_else() {
    assert_eq!(size_of::<nanospectra::Observer<3, 16>>(), 12 * 16);
    assert_eq!(size_of::<nanospectra::Light<31>>(), 4 * 31);
    assert_eq!(size_of::<nanospectra::FineObserver<3>>(), 4 * 3 * 471);
}
