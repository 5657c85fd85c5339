//! Chromatic adaptation, RGB spaces and gamut mapping: goldens 04, 09 and 12.

use crate::{narrow, wide};
use model::allowed::{Singles, check};
use model::check::Check;
use model::csv::golden;
use model::tables::{Observer, source};
use model::tristimulus::{Method, xyz_of_light};
use nanospectra::color::{
    Aces2065, AcesCg, Adaptation, AdobeRgb, Bradford, Bt2020, Cat02, Cat16, ConeResponses, DciP3, DisplayP3,
    ProPhoto, Rgb, RgbSpace, Srgb, VonKries, Xyz,
};
use proptest::prelude::*;

/// The matrices of golden 09 made by one kind of cones.
fn adaptation<C: ConeResponses>(name: &str, rows: usize, [fixed, run, sample]: &mut [Check; 3]) {
    let white = |id: &str| match id {
        // summed like the others, so X and Z miss 1
        "E" => xyz_of_light(&source("E"), Observer::Cie1931, Method::NativeSum).0.map(|v| v / 100.0),
        _ => golden("09_whites").find("id", id).numbers(["X", "Y", "Z"]),
    };
    let mut seen = 0;
    for row in golden("09_cat_matrices").rows().filter(|row| row.text("transform") == name) {
        seen += 1;
        let (from, to) =
            (Xyz::from(narrow(white(row.text("from")))), Xyz::from(narrow(white(row.text("to")))));
        let expected = [["m00", "m01", "m02"], ["m10", "m11", "m12"], ["m20", "m21", "m22"]];
        let constant = Adaptation::between_const::<C>(from, to);
        let made = Adaptation::between::<C>(from, to).expect("whites");
        for ((fixed_row, run_row), cells) in constant.matrix().iter().zip(made.matrix()).zip(expected) {
            fixed.add_all(&row.place(), *fixed_row, row.numbers(cells));
            run.add_all(&row.place(), *run_row, row.numbers(cells));
        }
        let adapted = made.apply(Xyz::from(narrow(row.numbers(["sX", "sY", "sZ"]))));
        sample.add_all(&row.place(), adapted.to_array(), row.numbers(["aX", "aY", "aZ"]));
    }
    assert_eq!(seen, rows, "{name}");
}

#[test]
fn adaptation_matrices_agree() {
    let mut all = [
        "adaptation matrices, fixed",
        "adaptation matrices, made at run time",
        "samples adapted at run time",
    ]
    .map(check);
    adaptation::<Bradford>("Bradford", 78, &mut all);
    adaptation::<Cat02>("CAT02", 76, &mut all);
    adaptation::<Cat16>("CAT16", 81, &mut all);
    adaptation::<VonKries>("Von Kries", 78, &mut all);
    let [fixed, run, sample] = all;
    fixed.tight(9 * 313);
    run.tight(9 * 313);
    sample.tight(3 * 313);
}

#[test]
fn incomplete_adaptation_agrees() {
    let mut samples = check("samples adapted in part");
    for row in golden("09_cat_partial").rows() {
        if row.text("from") == "E" || row.text("to") == "E" {
            continue;
        }
        let white = |id: &str| Xyz::from(narrow(golden("09_whites").find("id", id).numbers(["X", "Y", "Z"])));
        let (from, to) = (white(row.text("from")), white(row.text("to")));
        let color = Xyz::from(narrow(row.numbers(["sX", "sY", "sZ"])));
        let d = row.number("D") as f32;
        let cat02 = Adaptation::partial::<Cat02>(from, to, d).expect("whites").apply(color);
        let cat16 = Adaptation::partial::<Cat16>(from, to, d).expect("whites").apply(color);
        samples.add_all(&row.place(), cat02.to_array(), row.numbers(["CAT02_X", "CAT02_Y", "CAT02_Z"]));
        samples.add_all(&row.place(), cat16.to_array(), row.numbers(["CAT16_X", "CAT16_Y", "CAT16_Z"]));
    }
    samples.tight(2 * 3 * 79);
}

#[test]
fn adaptation_is_a_matter_of_chromaticity() {
    let (a, d65) = (Xyz::new(109.85, 100.0, 35.58), Xyz::new(95.047, 100.0, 108.883));
    let one = Adaptation::between::<Bradford>(a, d65).expect("whites");
    let other = Adaptation::between::<Bradford>(a.scaled(0.5), d65.scaled(8.0)).expect("whites");
    assert_eq!(one, other);
    let white = one.apply(a);
    let mut adapted = check("white adapted to white");
    adapted.add_all("A to D65", white.to_array(), [95.047, 100.0, 108.883]);
    adapted.tight(3);
    let mut kept = check("white adapted to degree 0");
    let none = Adaptation::partial::<Cat16>(a, d65, 0.0).expect("whites");
    kept.add_all("A", none.apply(a).to_array(), wide(a));
    kept.tight(3);
    assert_eq!(Adaptation::between::<Bradford>(Xyz::default(), d65), None);
    assert_eq!(Adaptation::between::<Bradford>(a, Xyz::new(10.0, 1.0, 150.0)), None, "a blue laser");
}

/// The luminance of a white is no part of an adaptation, in a constant neither.
#[test]
fn constant_adaptations_are_a_matter_of_chromaticity() {
    let (a, d65) = (Xyz::new(109.85, 100.0, 35.58), Xyz::new(95.047, 100.0, 108.883));
    let one = Adaptation::between_const::<Cat16>(a, d65);
    // Powers of two, so that no chromaticity is rounded.
    for (from, to) in [(0.5, 8.0), (4096.0, 1.0), (1.0, 1.0 / 64.0)] {
        assert_eq!(Adaptation::between_const::<Cat16>(a.scaled(from), d65.scaled(to)), one, "{from}, {to}");
    }
}

/// The matrices of an RGB space against those of the model, on the model's digits.
fn rgb_matrices<S: RgbSpace>(name: &str, matrix: &mut Check) {
    let space = model::rgb::named(name);
    for (row, expected) in S::TO_XYZ.iter().zip(space.rgb_to_xyz()) {
        matrix.add_all(name, *row, expected);
    }
    for (row, expected) in S::FROM_XYZ.iter().zip(space.xyz_to_rgb()) {
        matrix.add_all(name, *row, expected);
    }
}

/// One RGB space against the golden and the model's matrices.
fn rgb_space<S: RgbSpace>(name: &str, [matrix, values, back]: &mut [Check; 3]) {
    rgb_matrices::<S>(name, matrix);
    for row in golden("12_color_spaces").rows() {
        let color = Xyz::from(narrow(row.numbers(["X", "Y", "Z"]).map(|v| 100.0 * v)));
        let rgb = Rgb::<S>::from_xyz(color);
        let columns = ["R", "G", "B"].map(|c| format!("{name}:{c}"));
        let expected = [0, 1, 2].map(|c: usize| row.number(&columns[c]));
        values.add_all(&format!("{name} {}", row.place()), rgb.to_array(), expected);
        back.add_all(&format!("{name} {}", row.place()), rgb.xyz().to_array(), wide(color));
    }
}

#[test]
fn rgb_spaces_agree() {
    let mut all =
        ["matrices of RGB spaces", "linear RGB, golden 12", "XYZ by way of RGB, golden 12"].map(check);
    rgb_space::<Srgb>("sRGB", &mut all);
    rgb_space::<DisplayP3>("Display P3", &mut all);
    rgb_space::<Bt2020>("ITU-R BT.2020", &mut all);
    rgb_space::<AdobeRgb>("Adobe RGB (1998)", &mut all);
    rgb_space::<AcesCg>("ACEScg", &mut all);
    rgb_space::<Aces2065>("ACES2065-1", &mut all);
    rgb_space::<ProPhoto>("ProPhoto RGB", &mut all);
    let [mut matrix, values, back] = all;
    rgb_matrices::<DciP3>("DCI-P3", &mut matrix);
    matrix.tight(8 * 2 * 9);
    values.tight(7 * 3 * 289);
    back.tight(7 * 3 * 289);
}

/// A matrix that is found and one that is printed, with the digits of that.
type Printed = (&'static str, [[f32; 3]; 3], [[f64; 3]; 3], f64);

/// The matrices to X, Y, Z as standards print them, to all digits there.
#[test]
fn the_matrices_of_wide_spaces_are_the_printed_ones() {
    let printed: [Printed; 3] = [
        (
            "DCI-P3, SMPTE EG 432-1",
            DciP3::TO_XYZ,
            [
                [0.445_169_815_6, 0.277_134_409_2, 0.172_282_669_8],
                [0.209_491_677_9, 0.721_595_254_2, 0.068_913_067_9],
                [0.0, 0.047_060_560_1, 0.907_355_394_4],
            ],
            6e-8,
        ),
        (
            "ACES2065-1, SMPTE ST 2065-1",
            Aces2065::TO_XYZ,
            [
                [0.952_552_395_9, 0.0, 0.000_093_678_6],
                [0.343_966_449_8, 0.728_166_096_6, -0.072_132_546_4],
                [0.0, 0.0, 1.008_825_184_4],
            ],
            6e-8,
        ),
        (
            // It is made from a white with more digits, X = 0.9642, Z = 0.8249.
            "ROMM, ISO 22028-2",
            ProPhoto::TO_XYZ,
            [[0.7977, 0.1352, 0.0313], [0.2880, 0.7119, 0.0001], [0.0, 0.0, 0.8249]],
            2.1e-4,
        ),
    ];
    for (name, found, printed, digits) in printed {
        for (found, printed) in found.as_flattened().iter().zip(printed.as_flattened()) {
            assert!((f64::from(*found) - printed).abs() < digits, "{name}: {found}, printed {printed}");
        }
    }
}

#[cfg(feature = "libm")]
#[test]
fn surfaces_adapted_to_d65_have_their_srgb_codes() {
    use model::interpolation::{Interpolation, Outside};
    let white_of = |id: &str| {
        let light = source(id).on_cie_grid(Interpolation::Sprague, Outside::Zero);
        model::tristimulus::xyz_of_surface(&[1.0; 471], &light, &Observer::Cie1931.on_cie_grid())
    };
    let (mut linear, mut encoded) =
        (check("linear sRGB of surfaces, golden 04"), check("encoded sRGB of surfaces, golden 04"));
    let mut codes = 0;
    for row in golden("04_reflectance_colorimetry").rows().filter(|row| !row.is_missing("lin_R")) {
        let white = Xyz::from(narrow(white_of(row.text("illuminant"))));
        let to_d65 = Adaptation::between::<Bradford>(white, Srgb::WHITE_XYZ).expect("whites");
        let color = to_d65.apply(Xyz::from(narrow(row.numbers(["X", "Y", "Z"]))));
        let rgb = Rgb::<Srgb>::from_xyz(color);
        linear.add_all(&row.place(), rgb.to_array(), row.numbers(["lin_R", "lin_G", "lin_B"]));
        let expected = row.numbers(["enc_R", "enc_G", "enc_B"]);
        for (got, expected) in rgb.encode().to_array().into_iter().zip(expected) {
            // below zero the golden goes on straight, as the standard does not, and the crate is odd
            if expected >= 0.0 {
                encoded.add(&row.place(), got, expected);
            }
        }
        assert_eq!(
            rgb.clip().rgb.encode().to_u8(),
            expected.map(|v| (v * 255.0 + 0.5).floor().clamp(0.0, 255.0) as u8),
            "{}",
            row.place()
        );
        codes += 1;
    }
    assert_eq!(codes, 876);
    linear.tight(3 * 876);
    encoded.tight(2547);
}

/// The luminances of the primaries as the standards print them: IEC 61966-2-1, SMPTE EG 432-1, ITU-R
/// BT.2020-2, Adobe RGB (1998), Academy S-2014-004, SMPTE RP 431-2, ST 2065-1.
#[test]
fn the_luminance_of_each_primary_is_the_published_one() {
    fn of<S: RgbSpace>() -> [f32; 3] {
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
            .map(|[r, g, b]| Rgb::<S>::new(r, g, b).luminance())
    }
    for (name, found, published) in [
        ("sRGB", of::<Srgb>(), [0.2126, 0.7152, 0.0722]),
        ("Display P3", of::<DisplayP3>(), [0.2290, 0.6917, 0.0793]),
        ("BT.2020", of::<Bt2020>(), [0.2627, 0.6780, 0.0593]),
        ("Adobe RGB", of::<AdobeRgb>(), [0.29734, 0.62736, 0.07529]),
        ("ACEScg", of::<AcesCg>(), [0.272_23, 0.674_08, 0.053_69]),
        ("DCI-P3", of::<DciP3>(), [0.2095, 0.7216, 0.0689]),
        ("ACES2065-1", of::<Aces2065>(), [0.343_97, 0.728_17, -0.072_13]),
    ] {
        for (found, published) in found.into_iter().zip(published) {
            // They are printed to four digits, and sRGB has the matrix of rounded ones.
            assert!((found - published).abs() < 6e-5, "{name}: {found}, published {published}");
        }
    }
    // Lights add up: 0.2126 * 0.5 + 0.7152 * 0.25 + 0.0722 * 2.
    assert!((Rgb::<Srgb>::new(0.5, 0.25, 2.0).luminance() - 0.4295).abs() < 1e-4);
}

#[test]
fn the_least_excess_is_dimmed_and_full_scale_is_not() {
    let full = Rgb::<Srgb>::new(0.5, 1.0, 0.25).dim();
    assert_eq!((full.rgb.to_array(), full.was_inside), ([0.5, 1.0, 0.25], true));
    for above in [1.0f32.next_up(), 1.0001, 1.0005, 1.002] {
        let dimmed = Rgb::<Srgb>::new(0.5, above, 0.25).dim();
        assert_eq!((dimmed.rgb.to_array(), dimmed.was_inside), ([0.5 / above, 1.0, 0.25 / above], false));
    }
}

#[test]
fn no_more_gray_is_mixed_in_than_the_gamut_asks_for() {
    // The luminance is 0.4299, and 0.4299 / 0.6299 of the way from this gray to the color red is zero.
    let cyan = Rgb::<Srgb>::new(-0.2, 0.6, 0.6).desaturate().rgb.to_array();
    // The luminance is 0.2722, and 0.7278 / 0.9278 of the way blue is at full scale.
    let blue = Rgb::<Srgb>::new(0.2, 0.2, 1.2).desaturate().rgb.to_array();
    for (found, exact) in cyan.into_iter().chain(blue).zip([0.0, 0.5460, 0.5460, 0.215_56, 0.215_56, 1.0]) {
        assert!((found - exact).abs() < 2e-5, "{cyan:?}, {blue:?}: {found}, not {exact}");
    }
}

#[test]
fn gamut_mapping_keeps_what_it_says() {
    type P3 = Rgb<DisplayP3>;
    let inside = P3::new(0.2, 0.5, 1.0);
    for mapped in [inside.clip(), inside.dim(), inside.desaturate()] {
        assert_eq!(mapped.rgb, inside);
        assert!(mapped.was_inside);
    }
    let bright = P3::new(1.0, 2.0, 4.0);
    assert_eq!(bright.clip().rgb.to_array(), [1.0, 1.0, 1.0]);
    assert_eq!(bright.dim().rgb.to_array(), [0.25, 0.5, 1.0]);
    assert_eq!(bright.desaturate().rgb.to_array(), [1.0, 1.0, 1.0]);
    assert!(!bright.dim().was_inside);
    assert_eq!(P3::new(-1.0, -1.0, 0.5).desaturate().rgb.to_array(), [0.0; 3]);
    let nan = P3::new(f32::NAN, 0.5, 0.5);
    for mapped in [nan.clip(), nan.dim(), nan.desaturate()] {
        assert!(mapped.rgb.r.is_nan() && !mapped.was_inside);
    }
}
proptest! {
    #[test]
    fn what_fits_is_in_the_gamut_and_keeps_its_luminance(
        r in -2.0_f32..3.0, g in -2.0_f32..3.0, b in -2.0_f32..3.0
    ) {
        let color = Rgb::<Srgb>::new(r, g, b);
        prop_assert!(color.clip().rgb.in_gamut());
        let fitted = color.desaturate();
        prop_assert!(fitted.rgb.in_gamut());
        prop_assert_eq!(fitted.was_inside, color.in_gamut());
        prop_assert!((fitted.rgb.luminance() - color.luminance().clamp(0.0, 1.0)).abs() < 1e-6);
        let dimmed = color.dim().rgb;
        prop_assert!(dimmed.r <= 1.0 && dimmed.g <= 1.0 && dimmed.b <= 1.0);
    }
}
