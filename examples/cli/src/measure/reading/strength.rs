//! Computes how strong a light is: for instruments, for the eye, for the body's clock and for plants.

use super::Reading;
use crate::measure::level::Kind;
use nanospectra::radiometry::{AlphaOpic, illuminance, photon_flux};
use nanospectra::{Fine, Power};

/// The illuminance, in lx, above which no daylight is: the sun at the zenith gives some 130,000.
const MOST_DAYLIGHT: f64 = 200_000.0;

/// The bands of photons by ANSI/ASABE S640, with their ends in nm.
const BANDS: [(&str, f32, f32); 4] =
    [("blue", 400.0, 500.0), ("green", 500.0, 600.0), ("red", 600.0, 700.0), ("far_red", 700.0, 800.0)];

/// How strong a light is.
#[derive(Debug, Default)]
pub struct Strength {
    /// The power of all samples, in the unit of its kind.
    pub power: Option<f64>,
    /// What the eye sees of it, in the unit of its kind.
    pub luminous: Option<f64>,
    /// Photons of 400 to 750 nm, in umol/m2/s.
    pub epar: Option<f64>,
    /// The photons of each band: its name, its share of those of 400 to 700 nm, and its umol/m2/s.
    pub bands: Vec<(&'static str, Option<f64>, Option<f64>)>,
    /// Red over far-red photons: those of 655..665 and 725..735 nm.
    pub r_fr: Option<f64>,
    /// Each receptor with its daylight efficacy ratio, its irradiance in W/m2 (or radiance in W/m2/sr) and its
    /// equivalent daylight illuminance in lx (or luminance in cd/m2).
    pub receptors: Vec<Receptor>,
}

/// What a receptor of the eye receives.
#[derive(Debug)]
pub struct Receptor {
    pub name: &'static str,
    pub der: Option<f64>,
    pub alpha_opic: Option<f64>,
    pub equivalent: Option<f64>,
}

/// The receptors in the order of the CIE.
const RECEPTORS: [&str; 5] = ["s_cone", "m_cone", "l_cone", "rhodopic", "melanopic"];

/// Adds the strength of a light, whose samples have this power, and whose curve at 1 nm is `power` times `scale`.
pub fn measure(reading: &mut Reading, of_samples: f64, power: &Fine<Power>, scale: f64) {
    let kind = reading.kind;
    let photons = |from, to| f64::from(photon_flux(power, from, to));
    let par = photons(400.0, 700.0);
    let is_on_surface = kind == Kind::Irradiance;
    let mut strength = Strength::default();
    if kind.level().is_some() {
        strength.power = Some(of_samples);
        strength.luminous = Some(f64::from(illuminance(power)) * scale);
    }
    strength.epar = is_on_surface.then(|| photons(400.0, 750.0) * scale);
    strength.bands = BANDS
        .map(|(name, from, to)| {
            let band = photons(from, to);
            (name, (par > 0.0).then(|| band / par), is_on_surface.then_some(band * scale))
        })
        .into();
    let far_red = photons(725.0, 735.0);
    strength.r_fr = (far_red > 0.0).then(|| photons(655.0, 665.0) / far_red);
    strength.receptors = receptors(kind, power, scale);
    if is_on_surface {
        reading.lux = strength.luminous;
        reading.ppfd = Some(par * scale);
    }
    explain(reading, &strength);
    reading.strength = strength;
}

fn receptors(kind: Kind, power: &Fine<Power>, scale: f64) -> Vec<Receptor> {
    let has_level = matches!(kind, Kind::Irradiance | Kind::Radiance);
    let own = AlphaOpic::new(power);
    let levels = own.to_array().into_iter().zip(own.edi().to_array());
    let ratios = AlphaOpic::der(power).map(AlphaOpic::to_array);
    let rows = RECEPTORS.into_iter().zip(levels).enumerate();
    rows.map(|(k, (name, (alpha_opic, equivalent)))| Receptor {
        name,
        der: ratios.map(|ratios| f64::from(ratios[k])),
        alpha_opic: has_level.then(|| f64::from(alpha_opic) * scale),
        equivalent: has_level.then(|| f64::from(equivalent) * scale),
    })
    .collect()
}

/// Says why numbers are missing, and what is beyond belief.
fn explain(reading: &mut Reading, strength: &Strength) {
    let why = match reading.kind.level() {
        Some(level) => format!("the light is a {}, and this number is one of an irradiance", level.name),
        None => {
            "the input is relative; give --unit such as absolute (W/m2/nm) or mW/m2/nm, or --lux or --ppfd"
                .into()
        }
    };
    let is_on_surface = reading.kind == Kind::Irradiance;
    if !is_on_surface {
        reading.missing(&["lux", "ppfd", "epar", "photons"], &why);
    }
    if strength.r_fr.is_none() {
        reading.note("r_fr", "there are no photons of 725..735 nm to compare with");
    }
    if reading.lux.is_some_and(|lux| lux > MOST_DAYLIGHT) {
        reading.note("lux", "this is brighter than the sun on the ground (130,000 lx); is the unit right?");
    }
}
