//! ICtCp and Jzazbz: published examples, golden 12, the f64 model, and the way back.
#![cfg(feature = "libm")]

use crate::{narrow, wide};
use model::allowed::{Singles, check};
use model::csv::golden;
use model::noise::Noise;
use nanospectra::color::transfer::{Hlg, Pq};
use nanospectra::color::{Bt2020, Ictcp, IctcpTransfer, Jzazbz, Rgb, RgbSpace, Srgb, Xyz};

fn signal<T: IctcpTransfer>(color: Ictcp<T>) -> [f32; 3] {
    [color.i, color.ct, color.cp]
}

/// The examples of colour-science 0.4.7, of a light of less than half a cd/m2.
#[test]
fn ictcp_gives_the_published_examples() {
    let rgb = [0.456_205_19_f32, 0.030_810_71, 0.040_919_52];
    let [r, g, b] = rgb.map(|v| v / 10_000.0);
    for (found, printed) in signal(Ictcp::<Pq>::from_rgb(Rgb::new(r, g, b))).into_iter().zip([
        0.073_513_64,
        0.004_752_53,
        0.093_515_96,
    ]) {
        assert!((found - printed).abs() < 2e-6, "{found}, printed {printed}");
    }
    let [r, g, b] = rgb;
    for (found, printed) in signal(Ictcp::<Hlg>::from_rgb(Rgb::new(r, g, b))).into_iter().zip([
        0.625_679,
        -0.019_844_9,
        0.359_112_6,
    ]) {
        assert!((found - printed).abs() < 2e-6, "{found}, printed {printed}");
    }
    // The example of colour-science 0.4.7, of colors that differ in all three.
    let one = Ictcp::<Pq>::new(0.488_546_8, -0.047_393_51, 0.074_754_01);
    let other = Ictcp::<Pq>::new(0.489_920_3, -0.045_675_08, 0.073_613_42);
    assert!((one.delta_e_itp(other) - 1.426_572).abs() < 1e-4);
    // A step of Ct counts half, and each alone.
    let apart = |i, ct, cp| Ictcp::<Pq>::new(0.5, 0.25, 0.125).delta_e_itp(Ictcp::new(i, ct, cp));
    assert_eq!(
        [apart(0.25, 0.25, 0.125), apart(0.5, 0.5, 0.125), apart(0.5, 0.25, 0.375)],
        [180.0, 90.0, 180.0]
    );
    // BT.2124 asks for 720 steps from black to 10 000 cd/m2.
    let white = Ictcp::<Pq>::from_rgb(Rgb::new(1.0, 1.0, 1.0));
    assert!((white.delta_e_itp(Ictcp::new(0.0, 0.0, 0.0)) - 720.0).abs() < 1e-3);
    assert_eq!(white.delta_e_itp(white), 0.0);
}

#[test]
fn ictcp_follows_the_model_and_comes_back() {
    let mut all =
        ["ICtCp of PQ", "RGB by way of ICtCp of PQ", "ICtCp of HLG", "RGB by way of ICtCp of HLG"].map(check);
    let mut noise = Noise(2100);
    for k in 0..40_000 {
        let bright = if k % 2 == 0 { 1.0 } else { noise.decades(1e-6, 1.0) };
        let rgb: [f32; 3] = noise.shares().map(|v: f32| v * bright);
        let place = format!("{rgb:?}");
        let [r, g, b] = rgb;
        let exact = rgb.map(f64::from);
        let pq = Ictcp::<Pq>::from_rgb(Rgb::new(r, g, b));
        all[0].add_all(&place, signal(pq), model::hdr::ictcp_pq(exact));
        all[1].add_all(&place, pq.rgb().expect("a color").to_array(), exact);
        let hlg = Ictcp::<Hlg>::from_rgb(Rgb::new(r, g, b));
        all[2].add_all(&place, signal(hlg), model::hdr::ictcp_hlg(exact));
        all[3].add_all(&place, hlg.rgb().expect("a color").to_array(), exact);
    }
    all.into_iter().for_each(|check| check.tight(3 * 40_000));
}

fn coordinates(color: Jzazbz) -> [f32; 3] {
    [color.jz, color.az, color.bz]
}

/// The golden takes X, Y, Z from 0 to 1 as if they were cd/m2.
#[test]
fn jzazbz_is_that_of_golden_12() {
    let mut dark = check("Jzazbz, golden 12");
    for row in golden("12_color_spaces").rows() {
        let color = Xyz::from(narrow(row.numbers(["X", "Y", "Z"])));
        dark.add_all(&row.place(), coordinates(color.jzazbz()), row.numbers(["Jz", "az", "bz"]));
    }
    dark.tight(3 * 289);
}

#[test]
fn jzazbz_follows_the_model_and_comes_back() {
    let (mut light, mut hues) = (check("Jz"), check("az and bz"));
    let mut back = check("XYZ by way of Jzazbz, of white");
    let mut noise = Noise(2017);
    for _ in 0..40_000 {
        let bright = noise.decades(1e-2, 100.0);
        let [r, g, b] = noise.shares().map(|v: f32| v * bright);
        let color = Rgb::<Bt2020>::new(r, g, b).xyz();
        let place = format!("{color}");
        let found = color.jzazbz();
        let exact = model::hdr::jzazbz(wide(color));
        light.add(&place, found.jz, exact[0]);
        hues.add(&place, found.az, exact[1]);
        hues.add(&place, found.bz, exact[2]);
        let returned = found.xyz().expect("a color").to_array();
        let white = 100.0 * f64::from(bright);
        for (returned, color) in returned.into_iter().zip(wide(color)) {
            back.value(&place, white + (f64::from(returned) - color), white);
        }
    }
    light.tight(40_000);
    hues.tight(80_000);
    back.tight(120_000);
    // As colour-science has it: white of 100 and of 10 000 cd/m2.
    let white = |y: f32| Srgb::WHITE_XYZ.scaled(y / 100.0).jzazbz().jz;
    assert!(
        (white(100.0) - 0.167_17).abs() < 1e-4 && (white(10_000.0) - 0.988_61).abs() < 1e-4,
        "{}",
        white(10_000.0)
    );
}

/// What is taken off Jz so that black is 0 counts in the dark: here from 1e-7 to 0.1 cd/m2.
#[test]
fn jzazbz_of_the_darkest_light_comes_back() {
    let mut worst = 0.0_f32;
    for k in 0..=60 {
        let color = Srgb::WHITE_XYZ.scaled(1e-9 * 10_f32.powf(0.1 * k as f32));
        let back = color.jzazbz().xyz().expect("a color");
        for (back, color) in back.to_array().into_iter().zip(color.to_array()) {
            worst = worst.max((back / color - 1.0).abs());
        }
    }
    println!("XYZ of dark light by way of Jzazbz: {worst}");
    assert!(worst < 6e-6, "{worst}");
}

#[test]
fn black_is_black_and_what_has_no_light_is_none() {
    let black = Xyz::default().jzazbz();
    assert!(coordinates(black).iter().all(|v| v.abs() < 1e-15), "{black:?}");
    assert!(black.xyz().is_some_and(|xyz| xyz.to_array().iter().all(|v| v.abs() < 1e-6)));
    assert_eq!(Jzazbz::new(-1.0, 0.0, 0.0).xyz(), None);
    assert_eq!(Jzazbz::new(0.5, 60.0, 0.0).xyz(), None);
    assert_eq!(Ictcp::<Pq>::new(2.5, 0.0, 0.0).rgb(), None);
    assert_eq!(Ictcp::<Hlg>::new(40.0, 0.0, 0.0).rgb(), None);
    assert!(Xyz::new(f32::NAN, 1.0, 1.0).jzazbz().jz.is_nan());
    assert!(Ictcp::<Pq>::from_rgb(Rgb::new(f32::NAN, 0.5, 0.5)).i.is_nan());
    assert!(Ictcp::<Pq>::new(f32::NAN, 0.0, 0.0).rgb().is_some_and(|rgb| rgb.r.is_nan()));
}
