//! Displays, mixed paints and metamers.
#![cfg(feature = "libm")]

use crate::LIGHT;
use model::allowed::{Singles, check};
use model::linear;
use nanospectra::color::{EncodedRgb, Rgb, Srgb, Xyz};
use nanospectra::light::{A, FL11};
use nanospectra::matter::CES;
use nanospectra::observer::CIE_1931;
use nanospectra::upsample::{Basis, CohenR, Display, Sigmoid, Viewing, kubelka_munk};
use nanospectra::{Curve, Factor, Fine, Nodes, Observer, Power, Reflectance};

type Grid = Nodes<380, 780>;
const UNDER_A: Fine<Power> = A.fine();
static EYE: Observer<3, 81, Power, Grid> = CIE_1931.fold(Curve::Step);
static BY_DAY: Observer<3, 81, Factor, Grid> = CIE_1931.under(&LIGHT).fold(Curve::Step);
static VIEWING: Viewing<81, Grid> = Viewing::new(&BY_DAY);
static BY_A: Observer<3, 81, Factor, Grid> = CIE_1931.under(&UNDER_A).fold(Curve::Step);
static SIGMOID: Sigmoid<81, Grid> = Sigmoid::new(&VIEWING);
static LED: Display<81, Grid> = Display::led(&EYE);
static LCD: Display<81, Grid> = Display::lcd(&EYE);

fn near(a: Xyz, b: Xyz, by: f32) -> bool {
    (a.x - b.x).abs() < by && (a.y - b.y).abs() < by && (a.z - b.z).abs() < by
}

#[test]
fn a_display_emits_the_color_it_is_asked_for() {
    for display in [&LED, &LCD] {
        let white = display.xyz([1.0; 3]);
        let xy = white.xy().expect("a white");
        assert!(
            (xy.x - 0.3127).abs() < 1e-6 && (xy.y - 0.3290).abs() < 1e-6 && (white.y - 100.0).abs() < 1e-4
        );
        for rgb in [[1.0, 0.0, 0.0], [0.2, 0.9, 0.4], [0.0, 0.0, 1.0], [0.5; 3]] {
            let light = display.emits(rgb);
            assert!(near(Xyz::from(EYE.sees(&light)), display.xyz(rgb), 2e-4));
            assert!(light.values().iter().all(|power| *power >= 0.0));
            for (back, asked) in display.rgb(display.xyz(rgb)).into_iter().zip(rgb) {
                assert!((back - asked).abs() < 2e-6);
            }
        }
    }
    // Narrow LEDs show more colors than filters before a white one.
    let lcd_green = LED.rgb(LCD.xyz([0.0, 1.0, 0.0]));
    assert!(lcd_green.iter().all(|amount| *amount > 0.0), "{lcd_green:?}");
    let led_green = LCD.rgb(LED.xyz([0.0, 1.0, 0.0]));
    assert!(led_green.iter().any(|amount| *amount < 0.0), "{led_green:?}");
}

#[test]
fn two_displays_match_for_one_observer_and_not_for_another() {
    let other: Observer<3, 81, Power, Grid> = nanospectra::observer::CIE_1964.fold(Curve::Step);
    let asked = [0.5, 0.4, 0.3];
    let (lcd, led) = (LCD.emits(asked), LED.emits(LED.rgb(LCD.xyz(asked))));
    assert!(near(Xyz::from(EYE.sees(&lcd)), Xyz::from(EYE.sees(&led)), 2e-4));
    let (a, b) = (Xyz::from(other.sees(&lcd)), Xyz::from(other.sees(&led)));
    assert!(!near(a, b, 0.2), "{a:?} {b:?}");
}

#[test]
fn blue_and_yellow_paint_make_green_and_their_lights_make_gray() {
    let paint = |r, g, b| {
        SIGMOID.reflectance(EncodedRgb::<Srgb>::from_u8([r, g, b]).decode()).spectrum.on_grid::<81, Grid>()
    };
    let (blue, yellow) = (paint(20, 60, 180), paint(250, 220, 20));
    let mixed: Rgb<Srgb> = VIEWING.rgb(&kubelka_munk(&[(1.0, &blue), (4.0, &yellow)]));
    assert!(mixed.g > 1.3 * mixed.r && mixed.g > 1.3 * mixed.b, "{mixed:?}");
    let shares = VIEWING.rgb(&((blue + yellow) * 0.5));
    assert!(shares.g < 1.3 * shares.r, "{shares:?}");
    // One paint, or the same twice, is that paint; the scale of the shares does not matter.
    for mixed in [kubelka_munk(&[(3.0, &blue)]), kubelka_munk(&[(0.2, &blue), (0.6, &blue)])] {
        for (mixed, paint) in mixed.values().iter().zip(blue.values()) {
            assert!((mixed - paint).abs() < 1e-6, "{mixed} {paint}");
        }
    }
    let (white, black) = (Reflectance::<81, Grid>::flat(1.0), Reflectance::flat(0.0));
    assert_eq!(kubelka_munk(&[(1.0, &white), (0.0, &black)]), white);
    assert_eq!(kubelka_munk(&[(1.0, &white), (0.1, &black)]), black);
    assert!(kubelka_munk::<81, Grid>(&[]).values().iter().all(|r| r.is_nan()));
}

#[test]
fn mixed_paints_keep_their_digits_down_to_a_thousandth() {
    let exact = |r: f64| (1.0 - r) * (1.0 - r) / (2.0 * r);
    let mut check = check("mixtures of two paints");
    for one in 0..=60 {
        for other in 0..=60 {
            let [a, b] = [one, other].map(|k| 10f32.powf(-0.05 * k as f32));
            let (one, other) = (Reflectance::<2, Grid>::flat(a), Reflectance::flat(b));
            let got = kubelka_munk(&[(0.7, &one), (0.3, &other)]).values()[1];
            let [share, rest] = [0.7f32, 0.3].map(f64::from);
            let k = (share * exact(a.into()) + rest * exact(b.into())) / (share + rest);
            check.add(&format!("{a} {b}"), got, 1.0 + k - (k * (k + 2.0)).sqrt());
        }
    }
    check.tight(61 * 61);
}

#[test]
fn matrix_r_is_cohens() {
    static R: CohenR<81, Power, Grid> = CohenR::new(&EYE);
    // A (A'A)^-1 A' s in f64.
    let rows = EYE.weights().map(|row| row.map(f64::from));
    let gram = [0, 1, 2].map(|i| [0, 1, 2].map(|j| (0..81).map(|k| rows[i][k] * rows[j][k]).sum::<f64>()));
    let seen = [0, 1, 2].map(|i| (0..81).map(|k| rows[i][k] * f64::from(FL11.values()[k])).sum::<f64>());
    let amounts = linear::apply(linear::inverse(gram), seen);
    let (fundamental, black) = (R.fundamental(&FL11), R.black(&FL11));
    let mut worst = 0.0f64;
    for (k, value) in fundamental.values().iter().enumerate() {
        let exact: f64 = (0..3).map(|i| amounts[i] * rows[i][k]).sum();
        worst = worst.max((f64::from(*value) - exact).abs());
    }
    println!("fundamental of FL11 within {worst:.1e} of {}", FL11.peak());
    assert!(worst < 5e-5);
    for (black, all) in EYE.sees(&black).into_iter().zip(EYE.sees(&FL11)) {
        assert!(black.abs() < 3e-6 * all, "{black} of {all}");
    }
    // Orthogonal, and idempotent.
    let product: f32 = fundamental.values().iter().zip(black.values()).map(|(a, b)| a * b).sum();
    let power: f32 = FL11.values().iter().map(|a| a * a).sum();
    assert!(product.abs() < 1e-5 * power);
    for (twice, once) in R.fundamental(&fundamental).values().iter().zip(fundamental.values()) {
        assert!((twice - once).abs() < 1e-4);
    }
}

#[test]
fn metamers_match_under_d65_and_drift_apart_under_a() {
    let basis = Basis::new(&VIEWING);
    let (mut most, mut drift) = (0.0f32, 0.0f32);
    for sample in &CES {
        let measured: Reflectance<81, Grid> = sample.resample();
        let rgb = VIEWING.rgb(&measured);
        if !rgb.in_gamut() {
            continue;
        }
        let (smooth, banded) = (SIGMOID.reflectance(rgb).spectrum.on_grid(), basis.reflectance(rgb));
        most = most.max(BY_DAY.delta_e(&smooth, &banded));
        drift = drift.max(BY_A.delta_e(&smooth, &banded));
        // A metameric black, added, is not seen.
        let r = CohenR::new(&BY_DAY);
        let other = smooth + r.black(&banded) * 0.5;
        assert!(BY_DAY.delta_e(&smooth, &other) < 1e-3);
    }
    println!("two metamers: {most} under D65, {drift} under A");
    assert!(most < 2e-3 && drift > 2.0);
    assert_eq!(BY_A.delta_e(&Reflectance::flat(0.3), &Reflectance::flat(0.3)), 0.0);
}
