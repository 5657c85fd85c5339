//! The units of an axis, and the words that name one.

use super::words::{self, plain};

/// Speed of light in m/s, exact in the SI.
const LIGHT_SPEED: f64 = 299_792_458.0;

/// Wavelength in nm times energy in eV, from the exact constants of the SI.
const NM_TIMES_EV: f64 = 1_239.841_984_332_002_6;

/// The unit of an axis, which is a wavelength or what has one in vacuum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AxisUnit {
    /// nm
    Nanometer,
    /// um
    Micrometer,
    /// 0.1 nm
    Angstrom,
    /// m
    Meter,
    /// cm-1, wavenumbers in vacuum
    PerCentimeter,
    /// THz
    Terahertz,
    /// Hz
    Hertz,
    /// eV, the energy of a photon
    ElectronVolt,
}

impl AxisUnit {
    /// Returns the wavelength in nm of a place on the axis. It is infinite for a frequency of 0.
    #[must_use]
    pub fn nm(self, value: f64) -> f64 {
        match self {
            AxisUnit::Nanometer => value,
            AxisUnit::Micrometer => value * 1e3,
            AxisUnit::Angstrom => value / 10.0,
            AxisUnit::Meter => value * 1e9,
            AxisUnit::PerCentimeter => 1e7 / value,
            AxisUnit::Terahertz => LIGHT_SPEED * 1e-3 / value,
            AxisUnit::Hertz => LIGHT_SPEED * 1e9 / value,
            AxisUnit::ElectronVolt => NM_TIMES_EV / value,
        }
    }

    /// Returns whether equal steps of this unit are equal steps of wavelength.
    #[must_use]
    pub fn is_wavelength(self) -> bool {
        matches!(self, AxisUnit::Nanometer | AxisUnit::Micrometer | AxisUnit::Angstrom | AxisUnit::Meter)
    }

    /// Returns the sign of the unit, as `--wavelength-unit` takes it.
    #[must_use]
    pub fn sign(self) -> &'static str {
        match self {
            AxisUnit::Nanometer => "nm",
            AxisUnit::Micrometer => "um",
            AxisUnit::Angstrom => "angstrom",
            AxisUnit::Meter => "m",
            AxisUnit::PerCentimeter => "cm-1",
            AxisUnit::Terahertz => "THz",
            AxisUnit::Hertz => "Hz",
            AxisUnit::ElectronVolt => "eV",
        }
    }

    /// Reads the sign or the name of a unit, whose case does not matter.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let text = plain(text);
        let text = text.trim().trim_matches(['[', ']', '(', ')', '"', ' ']);
        Some(match text {
            "nm" | "nanometer" | "nanometers" | "nanometre" | "nanometres" | "nano" => AxisUnit::Nanometer,
            "um" | "micron" | "microns" | "micrometer" | "micrometers" | "micrometre" | "micrometres" => {
                AxisUnit::Micrometer
            }
            "ang" | "angstrom" | "angstroms" | "angström" => AxisUnit::Angstrom,
            "m" | "meter" | "meters" | "metre" | "metres" => AxisUnit::Meter,
            "cm-1" | "1/cm" | "wavenumber" | "wavenumbers" => AxisUnit::PerCentimeter,
            "thz" | "terahertz" => AxisUnit::Terahertz,
            "hz" | "hertz" => AxisUnit::Hertz,
            "ev" | "electronvolt" | "electronvolts" | "electron volts" => AxisUnit::ElectronVolt,
            _ => return None,
        })
    }

    /// Finds the unit in a heading such as `Wavelength (nm)`, `lambda_um` or `X Units: Wavelength
    /// (micrometers)`.
    #[must_use]
    pub fn in_heading(heading: &str) -> Option<Self> {
        if let Some(unit) = words::brackets(heading).find_map(Self::parse) {
            return Some(unit);
        }
        let text = plain(heading);
        if text.contains("cm-1") || text.contains("1/cm") || text.contains("wavenumber") {
            return Some(AxisUnit::PerCentimeter);
        }
        // A lone letter means something else in most words.
        words::of(&text).filter(|word| word.len() > 1).find_map(Self::parse).or_else(|| Self::parse(&text))
    }
}

/// Returns whether a heading names wavelengths, or frequencies and energies that stand for them.
#[must_use]
pub fn names_axis(heading: &str) -> bool {
    /// In English, German, French, Spanish, Italian, Dutch, Swedish, Polish, Russian, Chinese and Japanese.
    const NAMES: [&str; 19] = [
        "wavel",
        "wave len",
        "lambda",
        "λ",
        "wellenl",
        "longueur",
        "longitud de onda",
        "lunghezza",
        "golfl",
        "våg",
        "długo",
        "длина",
        "波长",
        "波長",
        "wavenumber",
        "frequency",
        "photon energy",
        "nanomet",
        "band-nm",
    ];
    const WORDS: [&str; 9] = ["wave", "waves", "nm", "wl", "lam", "thz", "um", "angstrom", "cm-1"];
    let text = plain(heading);
    if super::Unit::in_heading(heading).is_some() {
        return false;
    }
    if NAMES.iter().any(|name| text.contains(name)) {
        return true;
    }
    // `nm` and `Wave[nm]`, but not `lamp at 450 nm`.
    let mut words = words::of(&text);
    let first = words.next().unwrap_or("");
    WORDS.contains(&first) && words.all(|word| AxisUnit::parse(word).is_some())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_become_nanometers() {
        for (unit, value, nm) in [
            (AxisUnit::Nanometer, 555.0, 555.0),
            (AxisUnit::Micrometer, 0.555, 555.0),
            (AxisUnit::Angstrom, 5550.0, 555.0),
            (AxisUnit::Meter, 555e-9, 555.0),
            // The candela is defined at 540 THz, which is 555.171 nm in vacuum.
            (AxisUnit::Terahertz, 540.0, 555.171_218_5),
            (AxisUnit::Hertz, 540e12, 555.171_218_5),
            (AxisUnit::PerCentimeter, 20_000.0, 500.0),
            (AxisUnit::ElectronVolt, 2.0, 619.920_992_2),
        ] {
            assert!((unit.nm(value) / nm - 1.0).abs() < 1e-9, "{unit:?}");
            assert_eq!(AxisUnit::parse(unit.sign()), Some(unit));
        }
    }

    #[test]
    fn headings_name_axes() {
        for heading in [
            "nm",
            "Wavelength",
            "wavelength (nm)",
            "Wave(nm)",
            "Wave   ",
            "lambda",
            "λ [nm]",
            "Wellenlänge",
            "WL",
            "wavelength_nm",
            "Frequency (THz)",
            "Wavenumber (cm-1)",
            "X Units: Wavelength (micrometers)",
            "[nm]",
        ] {
            assert!(names_axis(heading), "{heading}");
        }
        for heading in
            ["lamp", "W/m2/nm", "mW/m2/nm", "Irradiance (W/m2/nm)", "Peak at 450 nm", "R%", "waveguide"]
        {
            assert!(!names_axis(heading), "{heading}");
        }
        for (heading, unit) in [
            ("Wavelength (nm)", AxisUnit::Nanometer),
            ("wavelength_um", AxisUnit::Micrometer),
            ("X Units:  Wavelength (micrometers)", AxisUnit::Micrometer),
            ("Wavelength [m]", AxisUnit::Meter),
            ("Wavenumber", AxisUnit::PerCentimeter),
            ("freq THz", AxisUnit::Terahertz),
        ] {
            assert_eq!(AxisUnit::in_heading(heading), Some(unit), "{heading}");
        }
        assert_eq!(AxisUnit::in_heading("Wavelength"), None);
    }
}
