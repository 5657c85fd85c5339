//! CIECAM02, CAM16 and their uniform spaces: published examples, golden 12, the f64 model at its worst.
#![cfg(feature = "libm")]

use crate::{narrow, wide};
use model::allowed::{Singles, check};
use model::appearance::{AVERAGE, DARK, DIM, Seen, Viewing, cam16, ciecam02, degree_of_adaptation, uniform};
use model::check::Check;
use model::csv::golden;
use model::noise::Noise;
use nanospectra::color::{
    Appearance, AppearanceModel, Cam16, CamUcs, Ciecam02, ProPhoto, Rgb, RgbSpace, Srgb, Surround,
    ViewingConditions, Xyz,
};
use nanospectra::math::Fast;
use nanospectra::observer::CIE_1931;
use proptest::prelude::*;

/// X, Y, Z, the white, L_A and Y_b of an example, and J, C, h, s, Q, M as printed.
type Example = ([f32; 3], [f32; 3], f32, f32, [f32; 6]);

fn attributes(seen: Appearance) -> [f32; 6] {
    [seen.j, seen.c, seen.h_deg, seen.s, seen.q, seen.m]
}

fn follows<A: AppearanceModel>(examples: &[Example], surround: Surround, [digits, arc]: [f32; 2]) {
    for &(color, white, la, yb, printed) in examples {
        let (color, white) = (Xyz::from(color), Xyz::from(white));
        let seen = ViewingConditions::<A>::new(white, la, yb, surround).expect("a white");
        let found = seen.appearance(color).expect("an appearance");
        let [j, c, h_deg, s, q, m] = attributes(found);
        let off = |k: usize, found: f32| (found - printed[k]).abs();
        let hue = along(h_deg, f64::from(printed[2]), f64::from(c)) as f32;
        let worst = [off(0, j), off(1, c), off(3, s), off(4, q), off(5, m)].into_iter().fold(0.0, f32::max);
        assert!(worst <= digits && hue <= arc, "{found:?}, printed {printed:?}");
        let back = seen.xyz(found).expect("a color");
        let ucs = seen.xyz_of_ucs(seen.ucs(color).expect("a place")).expect("a color");
        for (back, color) in
            [back, ucs].iter().flat_map(|back| back.to_array().into_iter().zip(color.to_array()))
        {
            assert!((back - color).abs() < 2e-4, "{back}, not {color}");
        }
    }
}

const D65: [f32; 3] = [95.05, 100.0, 108.88];
const A: [f32; 3] = [109.85, 100.0, 35.58];

/// The four cases of M. D. Fairchild, Color Appearance Models, third edition, table 16.4, to two decimals,
/// and the two of CIE 159:2004, to four, whose white has Y = 90.
#[test]
fn ciecam02_gives_the_published_examples() {
    let book = [
        ([19.01, 20.0, 21.78], D65, 318.31, 20.0, [41.73, 0.10, 219.0, 2.36, 195.37, 0.11]),
        ([57.06, 43.06, 31.96], D65, 31.83, 20.0, [65.96, 48.57, 19.6, 52.25, 152.67, 41.67]),
        ([3.53, 6.56, 2.14], A, 318.31, 20.0, [21.79, 46.94, 177.1, 58.79, 141.17, 48.80]),
        ([19.01, 20.0, 21.78], A, 31.83, 20.0, [42.53, 51.92, 248.9, 60.22, 122.83, 44.54]),
    ];
    follows::<Ciecam02>(&book, Surround::Average, [0.0051, 0.0432]);
    let white = [98.88, 90.0, 32.03];
    let standard = [
        ([19.31, 23.93, 10.14], white, 200.0, 18.0, [48.0314, 38.7789, 191.0452, 46.0177, 183.1240, 38.7789]),
        ([19.31, 23.93, 10.14], white, 20.0, 18.0, [47.6856, 36.0527, 185.3445, 51.1275, 113.8401, 29.7580]),
    ];
    follows::<Ciecam02>(&standard, Surround::Average, [1e-4; 2]);
}

/// As colour-science 0.4.7 prints them: its own example of CAM16, and the colors above in three surrounds.
#[test]
fn cam16_gives_the_examples_of_colour_science() {
    let average = [
        (
            [19.01, 20.0, 21.78],
            D65,
            318.31,
            20.0,
            [41.731_21, 0.103_356, 217.068, 2.345_02, 195.3717, 0.107_437],
        ),
        (
            [57.06, 43.06, 31.96],
            D65,
            31.83,
            20.0,
            [65.428_28, 49.679_56, 17.486_59, 52.943_09, 152.0699, 42.624_73],
        ),
        (
            [3.53, 6.56, 2.14],
            A,
            318.31,
            20.0,
            [21.360_53, 50.993_82, 178.867_24, 61.579_53, 139.7858, 53.007_33],
        ),
    ];
    // The saturation of the gray is off by 7e-4, because a square root there grows steeply.
    follows::<Cam16>(&average, Surround::Average, [1e-3, 1e-4]);
    let white = [98.88, 90.0, 32.03];
    let color = [19.31, 23.93, 10.14];
    let dim =
        [(color, white, 200.0, 18.0, [52.794_04, 37.171_78, 187.099_47, 40.675_77, 224.6683, 37.171_78])];
    follows::<Cam16>(&dim, Surround::Dim, [1e-4; 2]);
    let dark =
        [(color, white, 20.0, 18.0, [56.396_99, 31.655_51, 176.957_37, 40.060_95, 162.8072, 26.128_59])];
    follows::<Cam16>(&dark, Surround::Dark, [1e-4; 2]);
    let seen =
        ViewingConditions::<Cam16>::new(Xyz::from(white), 200.0, 18.0, Surround::Average).expect("a white");
    let CamUcs { j, a, b } = seen.ucs(Xyz::from(color)).expect("a place");
    let near = |found: f32, printed: f32| (found - printed).abs() < 5e-5;
    assert!(near(j, 60.489_27) && near(a, -28.207_75) && near(b, -5.622_46), "{j} {a} {b}");
}

#[test]
fn golden_12_is_seen_as_by_colour_science() {
    let (mut size, mut arc) = (check("appearance, golden 12"), check("hue as an arc, golden 12"));
    let (la, white) = ((200.0 / std::f64::consts::PI) as f32, Srgb::WHITE_XYZ);
    let old = ViewingConditions::<Ciecam02>::new(white, la, 20.0, Surround::Average).expect("a white");
    let new = ViewingConditions::<Cam16>::new(white, la, 20.0, Surround::Average).expect("a white");
    for row in golden("12_color_spaces").rows() {
        let color = Xyz::from(narrow(row.numbers(["X", "Y", "Z"]).map(|v| 100.0 * v)));
        for (model, seen) in [("CIECAM02", old.appearance(color)), ("CAM16", new.appearance(color))] {
            let number = |name: &str| row.number(&format!("{model}:{name}"));
            let Some(seen) = seen else {
                assert!(number("J").is_nan() || number("C").is_nan(), "{} {model}", row.place());
                continue;
            };
            let place = format!("{} {model}", row.place());
            for (name, found) in [("J", seen.j), ("C", seen.c), ("Q", seen.q), ("M", seen.m)] {
                size.add(&format!("{place} {name}"), found, number(name));
            }
            arc.value(&place, along(seen.h_deg, number("h"), number("C")), 0.0);
        }
        let CamUcs { j, a, b } = new.ucs(color).expect("a place");
        size.add_all(&row.place(), [j, a, b], row.numbers(["CAM16UCS_J", "CAM16UCS_a", "CAM16UCS_b"]));
    }
    size.tight_over_more_than(3000);
    arc.tight_over_more_than(570);
}

/// By how much a hue is off, as the length of the arc at this chroma.
fn along(found: f32, exact_deg: f64, chroma: f64) -> f64 {
    let turned = (f64::from(found) - exact_deg + 540.0).rem_euclid(360.0) - 180.0;
    turned.to_radians().abs() * chroma
}

/// A scene for the crate and for the model.
struct Scene<A> {
    crate_: ViewingConditions<A>,
    model: Viewing,
    of_model: fn([f64; 3], Viewing) -> Seen,
}

fn scenes<A: AppearanceModel>(of_model: fn([f64; 3], Viewing) -> Seen) -> Vec<Scene<A>> {
    let mut scenes = Vec::new();
    for white in [D65, A, [98.88, 90.0, 32.03]] {
        for (surround, of_surround) in
            [(Surround::Average, AVERAGE), (Surround::Dim, DIM), (Surround::Dark, DARK)]
        {
            for (la, yb) in [(4.0, 20.0), (63.662, 20.0), (318.31, 5.0), (2000.0, 60.0)] {
                let crate_ = ViewingConditions::new(Xyz::from(white), la, yb, surround).expect("a white");
                let (la, yb) = (f64::from(la), f64::from(yb));
                let d = degree_of_adaptation(la, of_surround);
                let model = Viewing { white: white.map(f64::from), la, yb, d, surround: of_surround };
                scenes.push(Scene { crate_, model, of_model });
            }
        }
    }
    scenes
}

/// The errors of one color: J, C, M and the hue as an arc; Q over its white; the place in the uniform space;
/// and XYZ on the way back.
fn errors<A: AppearanceModel>(scene: &Scene<A>, color: Xyz) -> Option<[f64; 4]> {
    let exact = (scene.of_model)(wide(color), scene.model);
    if exact.lightness.is_nan() || exact.chroma.is_nan() {
        return None;
    }
    let found = scene.crate_.appearance(color)?;
    let off = |found: f32, exact: f64| (f64::from(found) - exact).abs();
    let sizes =
        off(found.j, exact.lightness).max(off(found.c, exact.chroma)).max(off(found.m, exact.colorfulness));
    let sizes = sizes.max(along(found.h_deg, exact.hue_deg, exact.chroma));
    let CamUcs { j, a, b } = scene.crate_.ucs(color)?;
    let [j2, a2, b2] = uniform(exact);
    let place = off(j, j2).hypot(off(a, a2)).hypot(off(b, b2));
    let back = scene.crate_.xyz(found)?;
    let back_of_ucs = scene.crate_.xyz_of_ucs(CamUcs { j, a, b })?;
    let back = [back, back_of_ucs].map(|back| {
        let off = |a: f32, b: f32| f64::from((a - b).abs());
        off(back.x, color.x).max(off(back.y, color.y)).max(off(back.z, color.z))
    });
    Some([sizes, off(found.q, exact.brightness), place, back[0].max(back[1])])
}

/// Colors of the wide gamut of BT.2020 at every brightness, and from each the way uphill to larger errors.
fn searched<A: AppearanceModel>(of_model: fn([f64; 3], Viewing) -> Seen, checks: &mut [Check; 4]) {
    let to_xyz = model::rgb::named("ITU-R BT.2020").rgb_to_xyz();
    let mut noise = Noise(16);
    for (number, scene) in scenes::<A>(of_model).iter().enumerate() {
        let color = |rgb: [f32; 3]| {
            Xyz::from(narrow(model::linear::apply(to_xyz, rgb.map(|v| 100.0 * f64::from(v)))))
        };
        let mut worst = [(0.0, [0.0; 3]); 4];
        let mut judge = |rgb: [f32; 3], worst: &mut [(f64, [f32; 3]); 4]| {
            let Some(found) = errors(scene, color(rgb)) else { return };
            for ((check, worst), found) in checks.iter_mut().zip(worst).zip(found) {
                check.value(&format!("scene {number}, {rgb:?}"), found, 0.0);
                if found > worst.0 {
                    *worst = (found, rgb);
                }
            }
        };
        for _ in 0..1000 {
            let bright = noise.decades(1e-3, 1.0);
            judge(noise.shares().map(|v: f32| v * bright), &mut worst);
        }
        for k in 0..1000 {
            let around = worst[k % 4].1;
            let reach = 0.3 * 0.99_f32.powi(k as i32 / 2);
            judge(around.map(|v| (v * (1.0 + reach * noise.offset())).clamp(0.0, 1.0)), &mut worst);
        }
    }
}

#[test]
fn both_models_follow_f64_at_their_worst() {
    let mut all = [
        "J, C, M and hue of CIECAM02, searched",
        "Q of CIECAM02, searched",
        "CAM02-UCS, searched",
        "XYZ by way of CIECAM02",
    ]
    .map(check);
    searched::<Ciecam02>(ciecam02, &mut all);
    all.into_iter().for_each(|check| check.tight_over_more_than(60_000));
    let mut all = [
        "J, C, M and hue of CAM16, searched",
        "Q of CAM16, searched",
        "CAM16-UCS, searched",
        "XYZ by way of CAM16",
    ]
    .map(check);
    searched::<Cam16>(cam16, &mut all);
    all.into_iter().for_each(|check| check.tight_over_more_than(60_000));
}

#[test]
fn fast_differs_by_no_more_than_rounding() {
    let seen =
        ViewingConditions::<Cam16>::new(Xyz::from(D65), 63.662, 20.0, Surround::Average).expect("a white");
    let fast = ViewingConditions::<Cam16>::new_with::<Fast>(Xyz::from(D65), 63.662, 20.0, Surround::Average);
    let fast = fast.expect("a white");
    let mut apart = check("CAM16-UCS by Fast");
    let mut noise = Noise(61);
    for _ in 0..20_000 {
        let color = {
            let [r, g, b] = noise.shares();
            Rgb::<Srgb>::new(r, g, b).xyz()
        };
        let (a, b) = (seen.ucs(color).expect("a place"), fast.ucs_with::<Fast>(color).expect("a place"));
        apart.value("", f64::from(a.distance(b)), 0.0);
    }
    apart.tight(20_000);
}

#[test]
fn a_color_that_the_model_cannot_see_is_none_and_never_nan() {
    let d65 = Srgb::WHITE_XYZ;
    let old = ViewingConditions::<Ciecam02>::new(d65, 63.662, 20.0, Surround::Average).expect("a white");
    let new = ViewingConditions::<Cam16>::new(d65, 63.662, 20.0, Surround::Average).expect("a white");
    // The blue primary of ProPhoto, an imaginary color.
    let blue = Rgb::<ProPhoto>::new(0.0, 0.0, 1.0).xyz();
    assert_eq!(old.appearance(blue), None);
    assert_eq!(old.ucs(blue), None);
    // Where the model in f64 has NaN there is None, and a number everywhere else.
    for nm in 390..=700 {
        let light = CIE_1931.weights().map(|row| row[nm - 360]);
        for (bright, white) in [(1.0, "dark"), (10.0, "bright")] {
            let color = Xyz::from(light).scaled(bright);
            let la = f64::from(63.662_f32);
            let viewing = Viewing {
                white: wide(d65),
                la,
                yb: 20.0,
                d: degree_of_adaptation(la, AVERAGE),
                surround: AVERAGE,
            };
            let exact = ciecam02(wide(color), viewing);
            let none = exact.lightness.is_nan() || exact.chroma.is_nan();
            assert_eq!(old.appearance(color).is_none(), none, "{nm} nm, {white}");
            assert!(new.appearance(color).is_some(), "{nm} nm, {white}");
        }
    }
}

#[test]
fn black_white_and_grays_are_exact() {
    for white in [D65, A].map(Xyz::from) {
        let seen =
            ViewingConditions::<Cam16>::discounting(white, 63.662, 20.0, Surround::Dim).expect("a white");
        let black = seen.appearance(Xyz::default()).expect("black");
        assert_eq!(black, Appearance::default());
        assert_eq!(seen.xyz(black), Some(Xyz::default()));
        let full = seen.appearance(white).expect("white");
        assert_eq!(full.j, 100.0);
        assert!(full.c < 2e-3, "{full:?}");
        let gray = seen.appearance(white.scaled(0.2)).expect("gray");
        assert!(gray.c < 2e-3 && (40.0..50.0).contains(&gray.j), "{gray:?}");
    }
}

#[test]
fn conditions_and_attributes_without_a_meaning_are_none() {
    let d65 = Xyz::from(D65);
    let new = |white, la, yb| ViewingConditions::<Cam16>::new(white, la, yb, Surround::Average);
    for (white, la, yb) in [
        (Xyz::default(), 64.0, 20.0),
        (Xyz::new(10.0, 1.0, 150.0), 64.0, 20.0), // a blue laser
        (d65, 0.0, 20.0),
        (d65, -1.0, 20.0),
        (d65, 64.0, 0.0),
        (d65, 64.0, -20.0),
    ] {
        assert_eq!(new(white, la, yb), None, "{white} {la} {yb}");
    }
    let seen = new(d65, 64.0, 20.0).expect("conditions");
    let with = |j, c, h_deg| seen.xyz(Appearance { j, c, h_deg, ..Appearance::default() });
    assert_eq!(with(-1.0, 0.0, 0.0), None);
    assert_eq!(with(50.0, -1.0, 0.0), None);
    assert_eq!(with(0.0, 10.0, 0.0), None);
    assert_eq!(with(1e6, 0.0, 0.0), None, "a response beyond the largest");
    assert_eq!(with(50.0, 1e4, 250.0), None, "a chroma that no color has");
    assert_eq!(seen.xyz_of_ucs(CamUcs::new(243.0, 0.0, 0.0)), None);
    assert_eq!(seen.xyz_of_ucs(CamUcs::default()), Some(Xyz::default()));
    let nan = seen.appearance(Xyz::new(f32::NAN, 20.0, 20.0)).expect("NaN is no reason for None");
    assert!(nan.j.is_nan() && nan.h_deg.is_nan());
    assert!(with(50.0, 10.0, f32::NAN).expect("NaN is no reason").x.is_nan());
}

fn any_xyz() -> impl Strategy<Value = Xyz> {
    let any = || prop_oneof![-1e36_f32..1e36, -1e3_f32..1e3, -1.0_f32..1.0, Just(0.0), Just(1e-40_f32)];
    [any(), any(), any()].prop_map(Xyz::from)
}

proptest! {
    #[test]
    fn no_finite_color_looks_like_nan(color in any_xyz(), la in 1e-3_f32..1e6, yb in 0.1_f32..200.0) {
        let white = Xyz::from(D65);
        let old = ViewingConditions::<Ciecam02>::new(white, la, yb, Surround::Dark).expect("a white");
        let new = ViewingConditions::<Cam16>::new(white, la, yb, Surround::Average).expect("a white");
        for seen in [old.appearance(color), new.appearance(color)].into_iter().flatten() {
            prop_assert!(attributes(seen).iter().all(|v| v.is_finite()), "{seen:?}");
            prop_assert!((0.0..360.0).contains(&seen.h_deg) && seen.c >= 0.0 && seen.j >= 0.0);
        }
        for ucs in [old.ucs(color), new.ucs(color)].into_iter().flatten() {
            prop_assert!([ucs.j, ucs.a, ucs.b].iter().all(|v| v.is_finite()), "{ucs:?}");
        }
        let [j, a, b] = color.to_array();
        for back in [old.xyz_of_ucs(CamUcs { j, a, b }), new.xyz_of_ucs(CamUcs { j, a, b })].into_iter().flatten() {
            prop_assert!(back.to_array().iter().all(|v| !v.is_nan()), "{back:?}");
        }
    }
}
