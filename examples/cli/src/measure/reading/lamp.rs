//! Computes the numbers about a light.

use super::{Bench, Known, Reading, shape, strength};
use crate::failure::Failure;
use crate::measure::level::Kind;
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

/// The excitation purity above which a chromaticity is outside of the spectrum locus by more than noise, and the one
/// above which no noise explains it.
const NOISY_PURITY: f32 = 1.01;
const MOST_PURITY: f32 = 1.2;

pub fn measure(bench: &Bench, source: &Source) -> Result<Reading, Failure> {
    let Lamp { power, scale: read } = source.light(bench.between)?;
    let seen = Xyz::from(bench.eye.functions.sees(&power));
    let standard = Xyz::from(CIE_1931.sees(&power));
    let relative =
        seen.with_y(100.0).filter(|_| standard.y > 0.0).ok_or_else(|| source.invisible(bench.eye))?;

    let mut reading = Reading::of(bench, source, relative, E);
    let mut scale = read;
    if let Some(known) = bench.scaled_to {
        scale = scaled(known, source, &power)?;
        reading.kind = Kind::Irradiance;
        let how = match known {
            Known::Illuminance(lux) => format!("{} lx", number::shortest(lux)),
            Known::Ppfd(photons) => format!("{} umol/m2/s of 400..700 nm", number::shortest(photons)),
        };
        reading.note("data", format!("the relative spectrum is scaled to {how}"));
    }
    reading.curve_y = f64::from(seen.y);
    reading.raw_y = reading.curve_y * scale;
    if reading.kind.level().is_some() {
        reading.xyz = seen.to_array().map(|value| f64::from(value * KM) * scale);
    }
    check_purity(&mut reading, source)?;
    white(&mut reading, standard);
    rendering(&mut reading, &power);
    efficacy(&mut reading, &power);
    strength::measure(&mut reading, source.power() * (scale / read), &power, scale);
    shape::measure(&mut reading, source);

    reading.show(Rgb::from_xyz(relative));
    reading.note("srgb", "this and hex are the light's chromaticity at Y = 100, clipped to the gamut");
    let surfaces = "a light has none, because it takes a surface and a white";
    reading.missing(&["lab", "delta_e2000_to_white"], surfaces);
    if !std::ptr::eq(bench.eye.functions, &CIE_1931) {
        let what = "is used for XYZ, chromaticity, dominant wavelength and sRGB, \
                    and CIE 1931 for CCT, Duv, CRI and photometry";
        reading.note("observer", format!("{} {what}", bench.eye.title));
    }
    for remark in source.remarks::<Power>(bench.between) {
        reading.note("data", remark);
    }
    reading.curve = Some(power);
    Ok(reading)
}

/// Returns the factor that brings the power of a relative light to a known reading.
fn scaled(known: Known, source: &Source, power: &Fine<Power>) -> Result<f64, Failure> {
    if let Some(level) = source.kind.level() {
        let what = format!(
            "this is in {} already, and only relative light is scaled; leave out --lux and --ppfd, or give --unit relative",
            level.spectral
        );
        return Err(source.wrong(&what));
    }
    let (wanted, found) = match known {
        Known::Illuminance(lux) => (lux, f64::from(illuminance(power))),
        Known::Ppfd(photons) => (photons, f64::from(ppfd(power))),
    };
    if found <= 0.0 {
        return Err(source.wrong("there is no light that could be scaled; give a spectrum that has some"));
    }
    Ok(wanted / found)
}

/// Looks whether any light can have the chromaticity.
fn check_purity(reading: &mut Reading, source: &Source) -> Result<(), Failure> {
    let purity = reading.purity.unwrap_or(0.0);
    if purity > MOST_PURITY {
        let what = "its chromaticity is far outside the spectrum locus, which no light has; look for numbers that \
                    stand for missing values, and subtract the dark reading";
        return Err(source.wrong(what));
    }
    if purity > NOISY_PURITY {
        let what =
            "the chromaticity is outside the spectrum locus, which no light has; is the dark reading right?";
        reading.note("xy", what);
    }
    Ok(())
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
            reading.cri_is_valid = Some(cri.dc <= MAX_DC);
            if cri.dc > MAX_DC {
                let what = "from its reference in uv, where CIE 13.3 allows 0.0054, so that Ra means little";
                reading.note("cri_ra", format!("the light is {} {what}", number::fixed(cri.dc, 4)));
            }
        }
        Err(error) => reading.missing(&["cri_ra", "cri_r", "cri_r9", "cri_is_valid"], &error.to_string()),
    }
    match tm30(power) {
        Ok(tm30) => {
            reading.tm30_rf = Some(tm30.rf);
            reading.tm30_rg = Some(tm30.rg);
        }
        Err(error) => reading.missing(&["tm30_rf", "tm30_rg"], &error.to_string()),
    }
}

/// Adds what the light does for the eye and for the body's clock, whatever its strength.
fn efficacy(reading: &mut Reading, power: &Fine<Power>) {
    reading.ler_lm_per_w = luminous_efficacy(power);
    if reading.ler_lm_per_w.is_none() {
        reading.missing(&["ler_lm_per_w"], "the power over 360..830 nm does not sum to more than zero");
    }
    reading.melanopic_edi_ratio = AlphaOpic::der(power).map(|ratios| ratios.melanopic);
    if reading.melanopic_edi_ratio.is_none() {
        reading.missing(&["melanopic_edi_ratio"], "there is no luminance to compare with");
    }
}
