//! What the numbers of a spectrum are, and the units that follow from it.

use nanospectra_files::{Quantity, Unit};

/// What a spectrum is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    /// A surface or a filter, by the share of the light that leaves it.
    Surface,
    /// A light of unknown strength.
    #[default]
    Relative,
    /// A light on a surface, in W/m2/nm.
    Irradiance,
    /// A light in a direction, in W/m2/sr/nm.
    Radiance,
    /// A light from a source in a direction, in W/sr/nm.
    Intensity,
    /// All light of a source, in W/nm.
    Flux,
}

/// The units and the keys of the strength of a light.
pub struct Level {
    /// The name of the quantity in the report.
    pub name: &'static str,
    /// The unit of the spectrum.
    pub spectral: &'static str,
    /// The unit of the power of the whole spectrum, and its key in JSON.
    pub radiant: [&'static str; 2],
    /// The name, the unit and the key of what the eye sees of it.
    pub luminous: [&'static str; 3],
}

const IRRADIANCE: Level = Level {
    name: "irradiance",
    spectral: "W/m2/nm",
    radiant: ["W/m2", "irradiance_w_m2"],
    luminous: ["illuminance", "lx", "lux"],
};
const RADIANCE: Level = Level {
    name: "radiance",
    spectral: "W/m2/sr/nm",
    radiant: ["W/m2/sr", "radiance_w_m2_sr"],
    luminous: ["luminance", "cd/m2", "luminance_cd_m2"],
};
const INTENSITY: Level = Level {
    name: "intensity",
    spectral: "W/sr/nm",
    radiant: ["W/sr", "radiant_intensity_w_sr"],
    luminous: ["luminous intensity", "cd", "luminous_intensity_cd"],
};
const FLUX: Level = Level {
    name: "flux",
    spectral: "W/nm",
    radiant: ["W", "radiant_flux_w"],
    luminous: ["luminous flux", "lm", "luminous_flux_lm"],
};

impl Kind {
    /// Returns what numbers in this unit are.
    pub fn of(unit: Unit) -> Self {
        match unit.quantity {
            Quantity::Relative | Quantity::Counts => Kind::Relative,
            Quantity::Irradiance => Kind::Irradiance,
            Quantity::Radiance => Kind::Radiance,
            Quantity::Intensity => Kind::Intensity,
            Quantity::Flux => Kind::Flux,
            Quantity::Reflectance | Quantity::Transmittance | Quantity::Absorbance => Kind::Surface,
        }
    }

    /// Returns the units of a light of known strength.
    pub fn level(self) -> Option<&'static Level> {
        match self {
            Kind::Surface | Kind::Relative => None,
            Kind::Irradiance => Some(&IRRADIANCE),
            Kind::Radiance => Some(&RADIANCE),
            Kind::Intensity => Some(&INTENSITY),
            Kind::Flux => Some(&FLUX),
        }
    }

    /// Returns the name of the unit in the report.
    pub fn unit(self) -> &'static str {
        match self {
            Kind::Surface => "reflectance",
            _ => self.level().map_or("relative", |level| level.spectral),
        }
    }
}
