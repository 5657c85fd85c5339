//! Lab, Luv and Oklab: goldens 04 and 12, the hard cases, and round trips by way of these and RGB.
//!
//! "golden" compares with numbers computed from more digits than an f32 holds, so what the
//! rounding of the input does is included; "model" gives the f64 model the same rounded input.

use crate::{narrow, wide};
use model::allowed::{Singles, check};
use model::csv::{Row, golden};
use model::interpolation::{Interpolation, Outside};
use model::linear::apply;
use model::tables::{Observer, source};
use model::tristimulus::xyz_of_surface;
use nanospectra::color::{
    AcesCg, Adaptation, AdobeRgb, Bradford, Bt2020, DisplayP3, Lab, Luv, Oklab, Rgb, RgbSpace, Srgb, Xyz,
};
use nanospectra::math::Fast;
use proptest::prelude::*;

const D65: Xyz = Srgb::WHITE_XYZ;

fn lab_array(lab: Lab) -> [f32; 3] {
    [lab.l, lab.a, lab.b]
}

fn luv_array(luv: Luv) -> [f32; 3] {
    [luv.l, luv.u, luv.v]
}

fn oklab_array(ok: Oklab) -> [f32; 3] {
    [ok.l, ok.a, ok.b]
}

/// Y = 100 for white on every way to tristimulus values and back.
#[test]
fn white_has_y_100_in_every_space() {
    fn of<S: RgbSpace>() {
        let white = Rgb::<S>::new(1.0, 1.0, 1.0).xyz();
        let near = |a: [f32; 3], b: [f32; 3], by: f32| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= by);
        assert!(
            near(white.to_array(), S::WHITE_XYZ.to_array(), 3e-5) && S::WHITE_XYZ.y == 100.0,
            "{white:?}"
        );
        assert!(near(Rgb::<S>::from_xyz(S::WHITE_XYZ).to_array(), [1.0; 3], 1e-6));
        assert_eq!(white.y, Rgb::<S>::new(1.0, 1.0, 1.0).luminance() * 100.0);
        let lab = white.lab(S::WHITE_XYZ).expect("a white");
        assert!(near(lab_array(lab), [100.0, 0.0, 0.0], 2e-4), "{lab:?}");
    }
    of::<Srgb>();
    of::<DisplayP3>();
    of::<Bt2020>();
    of::<AdobeRgb>();
    of::<AcesCg>();
    let [l, a, b] = oklab_array(D65.oklab());
    assert!((l - 1.0).abs() < 1e-5 && a.abs() < 2e-4 && b.abs() < 2e-4, "{l} {a} {b}");
    let white = Oklab::new(1.0, 0.0, 0.0).xyz();
    assert!((white.y - 100.0).abs() < 1e-3 && (white.x - D65.x).abs() < 0.02, "{white:?}");
}

/// The white golden 04 has for a light and an observer.
fn white_of(row: Row<'_>) -> [f64; 3] {
    let light = source(row.text("illuminant")).on_cie_grid(Interpolation::Sprague, Outside::Zero);
    xyz_of_surface(&[1.0; 471], &light, &Observer::named(row.text("observer")).on_cie_grid())
}

#[test]
fn lab_and_luv_of_surfaces_agree() {
    let mut all = [
        "Lab of surfaces, golden 04",
        "Lab of surfaces, model",
        "Luv of surfaces, golden 04",
        "Luv of surfaces, model",
        "Lab by Fast, of surfaces",
    ]
    .map(check);
    for row in golden("04_reflectance_colorimetry").rows() {
        let white = Xyz::from(narrow(white_of(row)));
        let color = Xyz::from(narrow(row.numbers(["X", "Y", "Z"])));
        let lab = lab_array(color.lab(white).expect("a white"));
        let luv = luv_array(color.luv(white).expect("a white"));
        let place = row.place();
        all[0].add_all(&place, lab, row.numbers(["L", "a", "b"]));
        all[1].add_all(&place, lab, model::lab::lab(wide(color), wide(white)));
        all[2].add_all(&place, luv, row.numbers(["Luv_L", "u", "v"]));
        all[3].add_all(&place, luv, model::lab::luv(wide(color), wide(white)));
        let fast = lab_array(color.lab_with::<Fast>(white).expect("a white"));
        all[4].add_all(&place, fast, model::lab::lab(wide(color), wide(white)));
    }
    all.into_iter().for_each(|check| check.tight(3 * 1752));
}

#[test]
fn lab_luv_and_oklab_of_any_color_agree() {
    let mut all = [
        "Lab of any color, golden 12",
        "Lab of any color, model",
        "Luv of any color, golden 12",
        "Luv of any color, model",
        "Oklab of any color, golden 12",
        "Oklab of any color, model",
        "Lab by Fast, of any color",
    ]
    .map(check);
    let exact_white = model::chromaticity::xyz_from_xy([0.3127, 0.3290], 100.0);
    assert_eq!(D65.to_array(), narrow(exact_white));
    for row in golden("12_color_spaces").rows() {
        let color = Xyz::from(narrow(row.numbers(["X", "Y", "Z"]).map(|v| 100.0 * v)));
        let lab = lab_array(color.lab(D65).expect("a white"));
        let luv = luv_array(color.luv(D65).expect("a white"));
        let ok = oklab_array(color.oklab());
        let place = row.place();
        all[0].add_all(&place, lab, row.numbers(["L", "a", "b"]));
        all[1].add_all(&place, lab, model::lab::lab(wide(color), wide(D65)));
        all[2].add_all(&place, luv, row.numbers(["Luv_L", "u", "v"]));
        all[3].add_all(&place, luv, model::lab::luv(wide(color), wide(D65)));
        all[4].add_all(&place, ok, row.numbers(["ok_L", "ok_a", "ok_b"]));
        all[5].add_all(&place, ok, model::lab::oklab(wide(color).map(|v| v / 100.0)));
        let fast = lab_array(color.lab_with::<Fast>(D65).expect("a white"));
        all[6].add_all(&place, fast, model::lab::lab(wide(color), wide(D65)));
    }
    all.into_iter().for_each(|check| check.tight(3 * 289));
}

#[test]
fn a_near_gray_is_as_certain_as_any_color() {
    let mut near_gray = check("Lab within 1 of gray, model");
    for k in 0..20_000 {
        let y = 0.009 + 0.991 * (k as f32 / 20_000.0);
        let off = 1.0 + 1e-3 * ((k * 37 % 101) as f32 / 50.0 - 1.0);
        let color = Xyz::new(D65.x * y * off, D65.y * y, D65.z * y / off);
        let lab = lab_array(color.lab(D65).expect("a white"));
        near_gray.add_all(&format!("{y}"), lab, model::lab::lab(wide(color), wide(D65)));
    }
    near_gray.tight(3 * 20_000);
}

#[cfg(feature = "libm")]
#[test]
fn polar_lab_agrees() {
    use nanospectra::color::Lch;
    let (mut chroma, mut hue) = (check("chroma of Lab, golden 12"), check("hue of Lab, degrees, golden 12"));
    let (mut lengths, mut back) = (check("chroma of Lab, model"), check("Lab by way of Lch, per chroma"));
    for row in golden("12_color_spaces").rows() {
        let [l, a, b] = narrow(row.numbers(["L", "a", "b"]));
        let Lch { l: l2, c, h_deg } = Lab::new(l, a, b).lch();
        assert_eq!(l, l2);
        chroma.add(&row.place(), c, row.number("C"));
        hue.add(&row.place(), h_deg, row.number("h"));
        lengths.add(&row.place(), c, f64::from(a).hypot(f64::from(b)));
        let round = Lch { l, c, h_deg }.lab();
        let size = row.number("C");
        back.add(&row.place(), ((round.a - a).abs()).max((round.b - b).abs()) / size as f32, 0.0);
    }
    [chroma, hue, lengths, back].into_iter().for_each(|check| check.tight(289));
}

#[cfg(feature = "libm")]
#[test]
fn hue_is_an_angle_below_a_full_turn_and_zero_for_gray() {
    for (a, b, h_deg) in [
        (0.0, 0.0, 0.0),
        (-0.0, -0.0, 0.0),
        (-0.0, 0.0, 0.0),
        (1.0, 0.0, 0.0),
        (1.0, -0.0, 0.0),
        (0.0, 1.0, 90.0),
        (-1.0, 0.0, 180.0),
        (-1.0, -0.0, 180.0),
        (0.0, -1.0, 270.0),
        (1.0, -1e-12, 0.0),
        (1.0, -1.0, 315.0),
    ] {
        assert_eq!(Lab::new(50.0, a, b).lch().h_deg, h_deg, "a {a} b {b}");
    }
}

#[test]
fn black_and_white_are_exact() {
    for white in [D65, Xyz::new(109.85, 100.0, 35.58), Xyz::new(1e-3, 1e-3, 1e-3)] {
        assert_eq!(white.lab(white), Some(Lab::new(100.0, 0.0, 0.0)));
        assert_eq!(Xyz::default().lab(white), Some(Lab::default()));
        assert_eq!(white.luv(white), Some(Luv::new(100.0, 0.0, 0.0)));
        assert_eq!(Xyz::default().luv(white), Some(Luv::default()));
        assert_eq!(Lab::default().xyz(white), Xyz::default());
        assert_eq!(Luv::default().xyz(white), Some(Xyz::default()));
    }
    assert_eq!(Xyz::default().oklab(), Oklab::default());
}

#[test]
fn lightness_has_no_jump_at_the_knee() {
    let white = Xyz::new(1.0, 1.0, 1.0);
    let knee = 216.0 / 24389.0_f32;
    let around = |steps: i32| {
        let y = f32::from_bits(knee.to_bits().wrapping_add_signed(steps));
        Xyz::new(y, y, y).lab(white).expect("a white").l
    };
    let mut step = check("step of L* at the knee");
    for steps in -200..200 {
        step.add(&format!("{steps}"), around(steps + 1) - around(steps), 0.0);
    }
    step.tight(400);
    // a* and b* neither: X and Z cross the knee while Y does not
    let mut across = check("Lab with X and Z at the knee, model");
    for y in [0.008, 0.010] {
        for steps in -200..200 {
            let t = f32::from_bits(knee.to_bits().wrapping_add_signed(steps));
            let color = Xyz::new(t, y, t);
            let lab = lab_array(color.lab(white).expect("a white"));
            across.add_all(&format!("{steps}"), lab, model::lab::lab(wide(color), wide(white)));
        }
    }
    across.tight(3 * 2 * 400);
}

#[test]
fn negative_tristimulus_values_are_on_the_straight_line() {
    let white = Xyz::new(1.0, 1.0, 1.0);
    let lab = Xyz::new(-0.001, -0.002, -0.003).lab(white).expect("a white");
    let slope = 24389.0 / 27.0;
    let mut line = check("Lab of negative XYZ");
    line.add("L", lab.l, -0.002 * slope);
    line.add("a", lab.a, 500.0 / 116.0 * slope * 0.001);
    line.add("b", lab.b, 200.0 / 116.0 * slope * 0.001);
    line.tight(3);
}

#[test]
fn lab_relative_to_a_red_laser_is_undefined_but_luv_is_not() {
    let laser = Xyz::new(0.2835, 0.1070, 0.0); // 650 nm
    assert_eq!(laser.lab(laser), None);
    assert_eq!(laser.luv(laser), Some(Luv::new(100.0, 0.0, 0.0)));
    assert_eq!(D65.lab(Xyz::default()), None);
    assert_eq!(D65.luv(Xyz::default()), None);
    assert_eq!(D65.lab(Xyz::new(1.0, -1.0, 1.0)), None);
    // a color without chromaticity that is not black
    assert_eq!(Xyz::new(-1.0, 0.01, 0.0).luv(D65), None);
    // no luminance, no color
    assert_eq!(Xyz::new(1.0, 0.0, 0.0).luv(D65), Some(Luv::default()));
}

/// Round trips over a lattice of the unit cube of `RGB`, black and white included.
fn lattice() -> impl Iterator<Item = [f32; 3]> {
    (0..=24_u16).flat_map(|r| {
        (0..=24_u16).flat_map(move |g| (0..=24_u16).map(move |b| [r, g, b].map(|c| f32::from(c) / 24.0)))
    })
}

#[test]
fn colors_survive_the_round_trip() {
    let mut all = [
        "XYZ by way of Lab",
        "XYZ by way of Luv",
        "XYZ by way of Oklab",
        "XYZ by way of sRGB",
        "XYZ by way of ACEScg",
    ]
    .map(check);
    let p3 = model::rgb::named("Display P3").rgb_to_xyz();
    for rgb in lattice() {
        let color = Xyz::from(narrow(apply(p3, rgb.map(|v| 100.0 * f64::from(v)))));
        let place = format!("{rgb:?}");
        let expected = wide(color);
        let lab = color.lab(D65).expect("a white").xyz(D65);
        let luv = color.luv(D65).expect("a white").xyz(D65).expect("a white");
        all[0].add_all(&place, lab.to_array(), expected);
        all[1].add_all(&place, luv.to_array(), expected);
        all[2].add_all(&place, color.oklab().xyz().to_array(), expected);
        all[3].add_all(&place, Rgb::<Srgb>::from_xyz(color).xyz().to_array(), expected);
        all[4].add_all(&place, Rgb::<AcesCg>::from_xyz(color).xyz().to_array(), expected);
    }
    all.into_iter().for_each(|check| check.tight(3 * 25 * 25 * 25));
}

fn finite() -> impl Strategy<Value = f32> {
    use prop::num::f32::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    prop_oneof![NORMAL | SUBNORMAL | ZERO | POSITIVE | NEGATIVE, -2.0_f32..2.0]
}

fn any_xyz() -> impl Strategy<Value = Xyz> {
    [finite(), finite(), finite()].prop_map(Xyz::from)
}

fn no_nan(values: [f32; 3]) -> bool {
    values.iter().all(|v| !v.is_nan())
}

proptest! {
    #[test]
    fn no_finite_color_has_a_nan_in_lab_or_luv(color in any_xyz(), white in any_xyz()) {
        prop_assert!(color.lab(white).is_none_or(|lab| no_nan(lab_array(lab))));
        // The sum X + 15 Y + 3 Z must not overflow in parts, and where 13 L* does, 0 times it is NaN.
        let within = |v: f32| v.clamp(-1e37, 1e37);
        let luv = Xyz::from(color.to_array().map(within)).luv(Xyz::from(white.to_array().map(within)));
        prop_assert!(luv.is_none_or(|luv| luv.l.abs() > f32::MAX / 13.0 || no_nan(luv_array(luv))));
        let [l, a, b] = color.to_array();
        prop_assert!(no_nan(Lab::new(within(l), within(a), within(b)).xyz(white).to_array()));
    }

    #[test]
    fn nan_is_never_hidden(which in 0_usize..3, other in 0.01_f32..2.0) {
        let mut color = [other; 3];
        color[which] = f32::NAN;
        let color = Xyz::from(color);
        let gray = Xyz::new(0.5, 0.5, 0.5);
        let lab = color.lab(D65).expect("NaN is no reason for None");
        prop_assert!(lab.l.is_nan() || lab.a.is_nan() || lab.b.is_nan());
        let lab = gray.lab(color).expect("NaN is no reason for None");
        prop_assert!(lab.l.is_nan() || lab.a.is_nan() || lab.b.is_nan());
        let luv = color.luv(D65).expect("NaN is no reason for None");
        prop_assert!(luv.u.is_nan());
        prop_assert!(color.oklab().l.is_nan());
        prop_assert!(Rgb::<Srgb>::from_xyz(color).r.is_nan());
        prop_assert!(Adaptation::between::<Bradford>(color, D65).expect("NaN is no reason").apply(gray).x.is_nan());
    }
}
