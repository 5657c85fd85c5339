//! The units of values, and the words that name a quantity.

use super::axis::AxisUnit;
use super::product::{self, Product};
use super::words::{self, plain};

/// Wavelength in nm times the energy in J of a mole of photons, divided by 1e6: what 1 umol is, times nm.
const MICROMOLE_NM: f64 = 119.626_565_638_697;

/// Avogadro's number, exact in the SI, per micromole.
const PHOTONS_PER_MICROMOLE: f64 = 6.022_140_76e17;

/// What the values of a curve are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Known up to a common factor.
    Relative,
    /// Power on a surface, in W/m2/nm.
    Irradiance,
    /// Power of a surface in a direction, in W/m2/sr/nm.
    Radiance,
    /// Power of a source in a direction, in W/sr/nm.
    Intensity,
    /// Power of a source, in W/nm.
    Flux,
    /// What a detector counted, without a calibration.
    Counts,
    /// The reflected part of the light, 1 for all of it.
    Reflectance,
    /// The transmitted part of the light, 1 for all of it.
    Transmittance,
    /// The negative decimal logarithm of a transmittance or reflectance, which is what it becomes.
    Absorbance,
}

/// The unit of the values in a file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// What is measured in it.
    pub quantity: Quantity,
    /// What one unit is in the unit of the quantity, or in umol/s where photons are counted.
    pub factor: f64,
    /// Whether photons are counted rather than energy.
    pub photons: bool,
    /// What a density is per, if the unit says so.
    pub per: Option<AxisUnit>,
}

impl Unit {
    /// The unit of values that are known up to a common factor.
    pub const RELATIVE: Self = Unit::of(Quantity::Relative, 1.0);

    /// Returns the unit of a quantity that is no density, or is one per nm.
    #[must_use]
    pub const fn of(quantity: Quantity, factor: f64) -> Self {
        let density = matches!(
            quantity,
            Quantity::Irradiance | Quantity::Radiance | Quantity::Intensity | Quantity::Flux
        );
        let per = if density { Some(AxisUnit::Nanometer) } else { None };
        Unit { quantity, factor, photons: false, per }
    }

    /// Returns whether it is a share of light rather than light.
    #[must_use]
    pub fn is_ratio(&self) -> bool {
        matches!(self.quantity, Quantity::Reflectance | Quantity::Transmittance | Quantity::Absorbance)
    }

    /// Returns whether another unit says the same, as far as it says something.
    pub(crate) fn agrees_with(&self, other: &Self) -> bool {
        let factor = self.factor / other.factor;
        (self.quantity, self.photons) == (other.quantity, other.photons)
            && (self.per.is_none() || other.per.is_none() || self.per == other.per)
            && (factor - 1.0).abs() < 1e-9
    }

    /// Returns a value of this unit at a wavelength, in the unit of the quantity.
    #[must_use]
    pub fn convert(&self, value: f64, nm: f64) -> f64 {
        let energy = if self.photons { MICROMOLE_NM / nm } else { 1.0 };
        let density = match self.per {
            // |d nu / d lambda|, in units of the axis per nm.
            Some(axis) if !axis.is_wavelength() => axis.nm(1.0) / (nm * nm),
            _ => 1.0,
        };
        if self.quantity == Quantity::Absorbance {
            return 10f64.powf(-value);
        }
        value * self.factor * energy * density
    }

    /// Reads a unit as options give it: `relative`, `absolute` (W/m2/nm), `counts`, `percent`, or a product such
    /// as `uW/cm2/nm`.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let text = plain(text);
        Some(match text.as_str() {
            "relative" | "a.u." | "au" | "arb" | "arb." | "arbitrary" | "arbitrary units" | "arb. units"
            | "rel" | "rel." => Self::RELATIVE,
            "absolute" => Unit::of(Quantity::Irradiance, 1.0),
            "counts" | "count" | "cts" | "dn" | "adu" | "digital counts" => Unit::of(Quantity::Counts, 1.0),
            "absorbance" | "abs" | "a" | "od" | "optical density" => Unit::of(Quantity::Absorbance, 1.0),
            "reflectance" | "reflection" => Unit::of(Quantity::Reflectance, 1.0),
            "transmittance" | "transmission" => Unit::of(Quantity::Transmittance, 1.0),
            _ => return Self::of_product(product::parse(&text)?),
        })
    }

    fn of_product(product: Product) -> Option<Self> {
        let Product {
            watt,
            mole,
            photon,
            second,
            meter,
            steradian,
            nanometer,
            terahertz,
            wavenumber,
            electronvolt,
            factor,
        } = product;
        let (photons, factor) = match (watt, mole, photon, second) {
            (1, 0, 0, 0) => (false, factor),
            (0, 1, 0, -1) => (true, factor * 1e6),
            (0, 0, 1, -1) => (true, factor / PHOTONS_PER_MICROMOLE),
            _ => return None,
        };
        let quantity = match (meter, steradian) {
            (-2, 0) => Quantity::Irradiance,
            (-2, -1) => Quantity::Radiance,
            (0, -1) => Quantity::Intensity,
            (0, 0) => Quantity::Flux,
            _ => return None,
        };
        let per = match (nanometer, terahertz, wavenumber, electronvolt) {
            (-1, 0, 0, 0) => Some(AxisUnit::Nanometer),
            (0, -1, 0, 0) => Some(AxisUnit::Terahertz),
            (0, 0, -1, 0) => Some(AxisUnit::PerCentimeter),
            (0, 0, 0, -1) => Some(AxisUnit::ElectronVolt),
            (0, 0, 0, 0) => None,
            _ => return None,
        };
        // Watts without anything else are more often a power than a spectrum.
        (per.is_some() || quantity != Quantity::Flux || photons).then_some(Unit {
            quantity,
            factor,
            photons,
            per,
        })
    }

    /// Finds the unit in a heading, such as `Irradiance (mW/m2/nm)`, `lamp [counts]`, `R%` or `Absorbance`.
    #[must_use]
    pub fn in_heading(heading: &str) -> Option<Self> {
        let text = plain(heading);
        // Outside of brackets a lone letter is more often a name.
        let bare = Some(heading).filter(|_| text.len() > 1);
        let product = words::brackets(heading).chain(bare).find_map(Self::parse);
        let names = |names: &[&str]| names.iter().any(|name| text.contains(name));
        let words = |wanted: &[&str]| words::of(&text).any(|word| wanted.contains(&word));
        let percent = text.contains('%') || words(&["percent", "pct", "pct."]);
        let scale = if percent { 0.01 } else { 1.0 };
        if let Some(unit) = product {
            return Some(unit);
        }
        // `mW/m2/nm` at the end of a heading without brackets.
        if let Some(start) = text.rfind(char::is_whitespace)
            && text.contains('/')
            && let Some(unit) = Self::parse(&text[start..])
        {
            return Some(unit);
        }
        Some(if names(&["absorbance", "absorptance", "optical density"]) || words(&["absorb", "od"]) {
            Unit::of(Quantity::Absorbance, 1.0)
        } else if names(&["transmi"]) || words(&["%t", "t%"]) {
            Unit::of(Quantity::Transmittance, scale)
        } else if names(&["reflect", "remission"]) || words(&["%r", "r%"]) || percent {
            Unit::of(Quantity::Reflectance, scale)
        } else if words(&["counts", "cts", "adu", "dn"]) {
            Unit::of(Quantity::Counts, 1.0)
        } else {
            return None;
        })
    }

    /// Returns the unit as a file writes it, such as `mW/m2/nm`.
    #[must_use]
    pub fn written(&self) -> String {
        const PREFIXES: [(f64, &str); 5] = [(1.0, ""), (1e-3, "m"), (1e-6, "u"), (1e-9, "n"), (1e3, "k")];
        let is = |factor: f64| (self.factor / factor - 1.0).abs() < 1e-9;
        let prefix =
            |area: f64| PREFIXES.iter().find(|(factor, _)| is(factor * area)).map(|(_, prefix)| prefix);
        let per = self.per.map_or(String::new(), |axis| format!("/{}", axis.sign()));
        let per = if self.per == Some(AxisUnit::PerCentimeter) { "/cm-1".into() } else { per };
        let area = match self.quantity {
            Quantity::Irradiance => "/m2",
            Quantity::Radiance => "/m2/sr",
            Quantity::Intensity => "/sr",
            Quantity::Flux => "",
            _ if is(0.01) => return "percent".into(),
            _ => return self.sign().into(),
        };
        match (self.photons, prefix(1.0), prefix(1e4)) {
            (true, _, _) if is(1.0) => format!("umol{area}/s{per}"),
            (true, _, _) => format!("{:e} umol{area}/s{per}", self.factor),
            (false, Some(prefix), _) => format!("{prefix}W{area}{per}"),
            (false, None, Some(prefix)) if area.contains("m2") => {
                format!("{prefix}W{}{per}", area.replace("m2", "cm2"))
            }
            _ => format!("{:e} W{area}{per}", self.factor),
        }
    }

    /// Returns the unit of the values after [`convert`](Self::convert), as messages write it.
    #[must_use]
    pub fn sign(&self) -> &'static str {
        match self.quantity {
            Quantity::Relative => "relative",
            Quantity::Irradiance => "W/m2/nm",
            Quantity::Radiance => "W/m2/sr/nm",
            Quantity::Intensity => "W/sr/nm",
            Quantity::Flux => "W/nm",
            Quantity::Counts => "counts",
            Quantity::Reflectance => "reflectance",
            Quantity::Transmittance => "transmittance",
            Quantity::Absorbance => "absorbance",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_have_their_factors() {
        for (text, quantity, factor, photons) in [
            ("W/m2/nm", Quantity::Irradiance, 1.0, false),
            ("W m-2 nm-1", Quantity::Irradiance, 1.0, false),
            ("W·m⁻²·nm⁻¹", Quantity::Irradiance, 1.0, false),
            ("W/(m²·nm)", Quantity::Irradiance, 1.0, false),
            ("W/m2-nm", Quantity::Irradiance, 1.0, false),
            ("W/(sqm*nm)", Quantity::Irradiance, 1.0, false),
            ("mW/m^2/nm", Quantity::Irradiance, 1e-3, false),
            ("µWatt/cm²/nm", Quantity::Irradiance, 0.01, false),
            ("uW/cm2/nm", Quantity::Irradiance, 0.01, false),
            ("W/m2/um", Quantity::Irradiance, 1e-3, false),
            ("W/m3", Quantity::Irradiance, 1e-9, false),
            ("W/m2/sr/nm", Quantity::Radiance, 1.0, false),
            ("W sr-1 m-2 nm-1", Quantity::Radiance, 1.0, false),
            ("mW/nm", Quantity::Flux, 1e-3, false),
            ("umol/m2/s/nm", Quantity::Irradiance, 1.0, true),
            ("µmol m-2 s-1 nm-1", Quantity::Irradiance, 1.0, true),
            ("umol m-2 s-1", Quantity::Irradiance, 1.0, true),
            ("photons/s/cm2/nm", Quantity::Irradiance, 1e4 / 6.022_140_76e17, true),
            ("erg s-1 cm-2 Å-1", Quantity::Irradiance, 1e-2, false),
            ("J/s/m2/nm", Quantity::Irradiance, 1.0, false),
            ("counts", Quantity::Counts, 1.0, false),
        ] {
            let unit = Unit::parse(text).unwrap_or_else(|| panic!("{text}"));
            assert_eq!((unit.quantity, unit.photons), (quantity, photons), "{text}");
            assert!((unit.factor / factor - 1.0).abs() < 1e-12, "{text}: {}", unit.factor);
        }
        for text in
            ["mW/m2/nm", "uW/cm2/nm", "W/cm2/nm", "umol/m2/s/nm", "W/m2/sr/nm", "mW/sr/nm", "W/nm", "counts"]
        {
            assert_eq!(Unit::parse(text).unwrap().written(), text);
        }
        for text in ["lamp", "nm", "W", "m2", "umol/m2/nm", "uJ/cm2/nm", "W/m2/nm/nm", "5 W/m2/nm", ""] {
            assert_eq!(Unit::parse(text), None, "{text}");
        }
    }

    #[test]
    fn photons_become_energy() {
        let unit = Unit::parse("umol/m2/s/nm").unwrap();
        // A micromole a second of 555 nm has 0.2155433 W.
        assert!((unit.convert(1.0, 555.0) - 0.215_543_4).abs() < 1e-6);
        assert_eq!(unit.convert(2.0, 119.626_565_638_697), 2.0);
    }

    #[test]
    fn densities_become_those_of_wavelength() {
        // 1 W/m2/THz at 500 nm, where 1 nm is 1.199169832 THz.
        let unit = Unit::parse("W/m2/THz").unwrap();
        assert!((unit.convert(1.0, 500.0) - 1.199_169_832).abs() < 1e-9);
        // 1 nm is 40 cm-1 there.
        let unit = Unit::parse("W/m2/cm-1").unwrap();
        assert!((unit.convert(1.0, 500.0) - 40.0).abs() < 1e-9);
        // 2.48 eV is there, of which 1 nm is the five-hundredth part.
        let unit = Unit::parse("W/m2/eV").unwrap();
        assert!((unit.convert(1.0, 500.0) - 0.004_959_367_9).abs() < 1e-9);
    }

    #[test]
    fn headings_state_units() {
        for (heading, quantity, factor) in [
            ("Irradiance (mW/m2/nm)", Quantity::Irradiance, 1e-3),
            ("PFD(umol m-2 s-1)", Quantity::Irradiance, 1.0),
            ("[µWatt/cm²/nm]", Quantity::Irradiance, 0.01),
            ("Sample [counts]", Quantity::Counts, 1.0),
            ("R%", Quantity::Reflectance, 0.01),
            ("Y Units:  Reflectance (percent)", Quantity::Reflectance, 0.01),
            ("%T", Quantity::Transmittance, 0.01),
            ("Absorbance", Quantity::Absorbance, 1.0),
            ("Radiance W/m2/sr/nm", Quantity::Radiance, 1.0),
        ] {
            let unit = Unit::in_heading(heading).unwrap_or_else(|| panic!("{heading}"));
            assert_eq!(unit.quantity, quantity, "{heading}");
            assert!((unit.factor / factor - 1.0).abs() < 1e-12, "{heading}");
        }
        for heading in ["lamp", "Wavelength (nm)", "extra", "global", "P", "Sample A", "a"] {
            assert_eq!(Unit::in_heading(heading), None, "{heading}");
        }
    }
}
