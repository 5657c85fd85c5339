//! Calls every run-time step of the crate in one image, which does not link if one of them can panic.
//!
//! `tests/devices.sh` links it for the Cortex-M4F at both optimization levels and checks that it has no software
//! f64. The image is not run, since `bits` computes the results.
#![no_std]
#![no_main]

mod without_panic;

use core::hint::black_box;
use nanospectra::color::{
    Adaptation, Bradford, Lab, Rgb, Srgb, Xy, Xyz, cie94, ciede2000, cmc, cri, dominant_wavelength, tm30,
};
use nanospectra::light::{D65, FL11, blackbody, daylight};
use nanospectra::observer::{CIE_1931, Curve, Observer};
use nanospectra::radiometry::{AlphaOpic, illuminance, luminous_efficacy, ppfd, scotopic_illuminance};
use nanospectra::upsample::{Basis, CohenR, Display, QuinticStart, Sigmoid, Smits, Viewing, kubelka_munk};
use nanospectra::{Bins, Fine, Interpolation, Light, Outside, Power, Reflectance};

static EYE: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);

static IN_DAYLIGHT: Observer<3, 31> = CIE_1931.under(&D65.fine()).fold(Curve::Step);
static VIEWING: Viewing<31> = Viewing::new(&IN_DAYLIGHT);
static SIGMOID: Sigmoid<31, Bins<380, 730>, Srgb, QuinticStart> = Sigmoid::new(&VIEWING);
static BASIS: Basis<31> = Basis::new(&VIEWING);
static SMITS: Smits<31> = Smits::new();
static COHEN: CohenR<31> = CohenR::new(&IN_DAYLIGHT);
static DISPLAY: Display<31> = Display::lcd(&EYE);

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    loop {
        everything();
        upsampling();
    }
}

fn everything() {
    let samples =
        black_box([(380.0, 0.1), (450.0, 1.0), (460.0, 0.7), (555.5, 0.4), (620.0, 1.0), (780.0, 0.0)]);
    for by in [Interpolation::Linear, Interpolation::Sprague] {
        let _ =
            black_box(Fine::<Power>::interpolated_outside(&samples, black_box(by), black_box(Outside::Hold)));
        let lamp: Fine<Power> = black_box(&FL11).interpolate(black_box(by));
        meaning(&lamp);
    }
    let mut lamp = Light::<31>::from_samples(&samples).unwrap_or(Light::flat(1.0));
    let _ = black_box(lamp.add_line(black_box(589.0), 1.0));
    let coarse: Light<16> = lamp.resample_outside(black_box(Outside::Zero));
    let hot = Light::<31>::averaged(|nm| blackbody(nm, black_box(2856.0)));
    let mut reports = [[0.0; 3]; 2];
    EYE.sees_each(&[lamp, hot + lamp * 0.5], &mut reports);
    black_box((coarse, reports, coarse.power(), coarse.peak(), daylight(black_box(6500.0))));
}

/// Finds spectra for RGB colors, mixes paints and drives a display.
fn upsampling() {
    let rgb = black_box([Rgb::new(0.8, 0.2, 0.1); 8]);
    let mut each = SIGMOID.reflectance_8(&rgb);
    SIGMOID.reflectance_each(black_box(&rgb), black_box(&mut each));
    let paint: Reflectance<31> = SIGMOID.desaturated(rgb[0]).spectrum.on_grid();
    let light = SIGMOID.illuminant(rgb[1]).spectrum.on_grid(&Light::<31>::flat(1.0));
    let mixed = kubelka_munk(&[(1.0, &paint), (black_box(2.0), &BASIS.reflectance(rgb[2]))]);
    let black = COHEN.black(&(mixed + SMITS.reflectance(rgb[3])));
    black_box((each, light, VIEWING.delta_e(rgb[4], &black), IN_DAYLIGHT.delta_e(&paint, &mixed)));
    black_box(DISPLAY.emits(DISPLAY.rgb(VIEWING.xyz(VIEWING.rgb(&paint)))));
}

/// Computes everything about a light and its color.
fn meaning(lamp: &Fine<Power>) {
    black_box((cri(lamp).ok(), tm30(lamp).ok(), AlphaOpic::der(lamp), luminous_efficacy(lamp), ppfd(lamp)));
    black_box((illuminance(lamp), scotopic_illuminance(&lamp.within(400.0, 700.0))));
    let xyz = Xyz::from(CIE_1931.sees(lamp));
    let (white, xy) = (black_box(Xyz::new(95.047, 100.0, 108.883)), xyz.xy().unwrap_or(Xy::new(0.3, 0.3)));
    black_box((xyz.cct(), xyz.uv1976(), xyz.with_y(100.0)));
    black_box(dominant_wavelength(xy, Xy::new(1.0 / 3.0, 1.0 / 3.0), &CIE_1931));
    let (lab, gray) =
        (xyz.lab(white).unwrap_or(Lab::new(50.0, 0.0, 0.0)), black_box(Lab::new(50.0, 1.0, 1.0)));
    black_box((ciede2000(lab, gray), cmc(lab, gray, 2.0, 1.0), lab.lch().lab(), xyz.luv(white), xyz.oklab()));
    black_box(cie94(lab, gray, nanospectra::color::Cie94Weights::Textiles));
    let adapted = Adaptation::between::<Bradford>(xyz, white).map(|to_white| to_white.apply(xyz));
    let rgb = Rgb::<Srgb>::from_xyz(adapted.unwrap_or(white));
    black_box((rgb.clip().rgb.encode().to_u8(), rgb.dim(), rgb.desaturate().rgb.encode().decode()));
    black_box(&D65);
}
