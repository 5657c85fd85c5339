//! Computes the numbers about a light.

use super::{Bench, Reading};
use crate::failure::Failure;
use crate::measure::args::Unit;
use crate::measure::source::{Lamp, Source};
use crate::output::number;
use nanospectra::color::{Cct, Rgb, Xy, Xyz, cri, tm30};
use nanospectra::observer::{CIE_1931, KM};
use nanospectra::radiometry::{AlphaOpic, illuminance, luminous_efficacy, ppfd};
use nanospectra::{Fine, Power};

/// The equal-energy white, from which the dominant wavelength of a light is measured.
const E: Xy = Xy { x: 1.0 / 3.0, y: 1.0 / 3.0 };

/// The largest distance from the reference light at which Ra means something, by CIE 13.3.
const MAX_DC: f32 = 5.4e-3;

pub fn measure(bench: &Bench, source: &Source) -> Result<Reading, Failure> {
    let Lamp { power, scale } = source.light(bench.by())?;
    let seen = Xyz::from(bench.eye.functions.sees(&power));
    let standard = Xyz::from(CIE_1931.sees(&power));
    let relative =
        seen.with_y(100.0).filter(|_| standard.y > 0.0).ok_or_else(|| source.invisible(bench.eye))?;

    let mut reading = Reading::of(bench, source, relative, E);
    reading.curve_y = f64::from(seen.y);
    reading.raw_y = reading.curve_y * scale;
    if bench.unit == Unit::Absolute {
        reading.xyz = seen.to_array().map(|value| f64::from(value * KM) * scale);
    }
    white(&mut reading, standard);
    rendering(&mut reading, &power);
    photometry(&mut reading, bench.unit, &power, scale);

    reading.show(Rgb::from_xyz(relative));
    reading.note("srgb", "this and hex are the light's chromaticity at Y = 100, clipped to the gamut");
    let surfaces = "a light has none, because it takes a surface and a white";
    reading.missing(&["lab", "delta_e2000"], surfaces);
    if !std::ptr::eq(bench.eye.functions, &CIE_1931) {
        let what = "is used for XYZ, chromaticity, dominant wavelength and sRGB, \
                    and CIE 1931 for CCT, Duv, CRI and photometry";
        reading.note("observer", format!("{} {what}", bench.eye.title));
    }
    for remark in source.remarks::<Power>(bench.by()) {
        reading.note("data", remark);
    }
    reading.curve = Some(power);
    Ok(reading)
}

/// Adds the color temperature.
fn white(reading: &mut Reading, standard: Xyz) {
    let why = match standard.cct() {
        Some(Cct::Near { cct_k, duv }) => {
            reading.cct_k = Some(cct_k);
            reading.duv = Some(duv);
            return;
        }
        Some(none) => none.to_string(),
        None => "there is no chromaticity for the 1931 observer".into(),
    };
    reading.missing(&["cct_k", "duv"], &why);
}

/// Adds how the light renders colors.
fn rendering(reading: &mut Reading, power: &Fine<Power>) {
    match cri(power) {
        Ok(cri) => {
            reading.cri_ra = Some(cri.ra);
            reading.cri_r = Some(cri.r);
            if cri.dc > MAX_DC {
                let what = "from its reference in uv, where CIE 13.3 allows 0.0054, so that Ra means little";
                reading.note("cri_ra", format!("the light is {} {what}", number::fixed(cri.dc, 4)));
            }
        }
        Err(error) => reading.missing(&["cri_ra", "cri_r"], &error.to_string()),
    }
    match tm30(power) {
        Ok(tm30) => {
            reading.tm30_rf = Some(tm30.rf);
            reading.tm30_rg = Some(tm30.rg);
        }
        Err(error) => reading.missing(&["tm30_rf", "tm30_rg"], &error.to_string()),
    }
}

/// Adds what the light does for the eye, for the body's clock and for plants.
fn photometry(reading: &mut Reading, unit: Unit, power: &Fine<Power>, scale: f64) {
    reading.ler_lm_per_w = luminous_efficacy(power);
    if reading.ler_lm_per_w.is_none() {
        reading.missing(&["ler_lm_per_w"], "the power over 360..830 nm does not sum to more than zero");
    }
    reading.melanopic_edi_ratio = AlphaOpic::der(power).map(|ratios| ratios.melanopic);
    if reading.melanopic_edi_ratio.is_none() {
        reading.missing(&["melanopic_edi_ratio"], "there is no luminance to compare with");
    }
    if unit == Unit::Absolute {
        reading.lux = Some(f64::from(illuminance(power)) * scale);
        reading.ppfd = Some(f64::from(ppfd(power)) * scale);
    } else {
        reading.missing(&["lux", "ppfd"], "the input is relative; give W/m2/nm and --unit absolute");
    }
}
