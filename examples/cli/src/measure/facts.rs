//! Turns the numbers of a reading into labeled lines for the report and for the picture.

use crate::measure::level::Kind;
use crate::measure::reading::{Comparison, Difference, Reading};
use crate::output::number::{self, fixed, signed};

/// A label and the text beside it.
pub struct Fact {
    pub label: String,
    pub value: String,
}

/// Returns the facts about the color, and those about the light if the reading is one of a light.
///
/// What a light does comes first, as it is what most instruments show.
pub fn facts(reading: &Reading) -> Vec<Fact> {
    let mut facts = Facts(Vec::new());
    if reading.kind != Kind::Surface {
        facts.strength(reading);
        facts.light(reading);
        facts.color(reading);
        facts.photons(reading);
        facts.receptors(reading);
        return facts.0;
    }
    facts.color(reading);
    facts.0
}

/// Returns the differences of a comparison as facts.
pub fn differences(comparison: &Comparison) -> Vec<Fact> {
    let mut facts = Facts(Vec::new());
    for (key, difference) in &comparison.differences {
        match difference {
            Some(Difference::One(value)) => facts.add(*key, fixed(*value, 5)),
            Some(Difference::Each(values)) => {
                let cells: Vec<String> = values.iter().map(|value| signed(*value, 5)).collect();
                facts.add(*key, cells.join("  "));
            }
            None => {}
        }
    }
    facts.0
}

struct Facts(Vec<Fact>);

impl Facts {
    fn add(&mut self, label: impl Into<String>, value: String) {
        self.0.push(Fact { label: label.into(), value });
    }

    /// Adds the power and what the eye sees of it.
    fn strength(&mut self, reading: &Reading) {
        let Some(level) = reading.kind.level() else { return };
        let [unit, _] = level.radiant;
        if let Some(power) = reading.strength.power {
            self.add(level.name, format!("{} {unit}", significant(power)));
        }
        let [name, unit, _] = level.luminous;
        if let Some(luminous) = reading.strength.luminous {
            self.add(name, format!("{} {unit}", significant(luminous)));
        }
    }

    /// Adds what plants receive.
    fn photons(&mut self, reading: &Reading) {
        let strength = &reading.strength;
        if let (Some(ppfd), Some(epar)) = (reading.ppfd, strength.epar) {
            self.add("PPFD, ePAR", format!("{}, {} µmol/m²/s", significant(ppfd), significant(epar)));
        }
        let bands = strength.bands.iter().filter_map(|(name, share, _)| {
            Some(format!("{} {} %", name.replace('_', " "), fixed((*share)? * 100.0, 1)))
        });
        let bands: Vec<String> = bands.collect();
        if !bands.is_empty() {
            self.add("photons of 400..700", bands.join(", "));
        }
        if let Some(ratio) = strength.r_fr {
            self.add("R:FR", number::significant(ratio, 4));
        }
        if let Some(shape) = &reading.shape {
            let nm = |value: Option<f64>| {
                value.map_or("unknown".into(), |value| format!("{} nm", fixed(value, 1)))
            };
            let value = format!("{}, {}, {}", nm(Some(shape.peak)), nm(shape.centroid), nm(shape.width));
            self.add("peak, centroid, FWHM", value);
        }
    }

    /// Adds what the five receptors of the eye receive.
    fn receptors(&mut self, reading: &Reading) {
        let receptors = &reading.strength.receptors;
        let ratios: Option<Vec<String>> =
            receptors.iter().map(|receptor| receptor.der.map(|der| fixed(der, 4))).collect();
        if let Some(ratios) = ratios.filter(|ratios| !ratios.is_empty()) {
            self.add("DER S M L rods mel", ratios.join("  "));
        }
        let levels: Option<Vec<String>> = receptors
            .iter()
            .map(|receptor| receptor.equivalent.map(|level| number::significant(level, 4)))
            .collect();
        if let Some(levels) = levels.filter(|levels| !levels.is_empty()) {
            let (label, unit) = if reading.kind == Kind::Radiance { ("EDL", "cd/m2") } else { ("EDI", "lx") };
            self.add(format!("{label} S M L rods mel"), format!("{} {unit}", levels.join("  ")));
        }
    }

    fn color(&mut self, reading: &Reading) {
        let unit = reading.kind.level().map_or(String::new(), |level| format!(" {}", level.luminous[1]));
        let [x, y, z] = reading.xyz.map(significant);
        self.add("X  Y  Z", format!("{x}  {y}  {z}{unit}"));
        if let Some(p) = reading.xy {
            self.add("x  y", number::all([p.x, p.y], 5, "  "));
        }
        if let Some(p) = reading.uv1960 {
            self.add("u  v  (1960)", number::all([p.u, p.v], 5, "  "));
        }
        if let Some(p) = reading.uv1976 {
            self.add("u' v' (1976)", number::all([p.u, p.v], 5, "  "));
        }
        if let Some(lab) = reading.lab {
            self.add("L* a* b*", number::all([lab.l, lab.a, lab.b], 3, "  "));
        }
        if let Some(delta) = reading.delta_e2000_to_white {
            self.add("CIEDE2000 to white", fixed(delta, 3));
        }
        if let (Some(rgb), Some(hex)) = (reading.srgb, &reading.hex) {
            self.add("sRGB", format!("{hex}  ({})", number::all(rgb, 4, "  ")));
        }
        if let (Some(nm), Some(purity)) = (reading.dominant_wavelength_nm, reading.purity) {
            let label = if nm < 0.0 { "complementary" } else { "dominant" };
            self.add(label, format!("{} nm, purity {} %", fixed(nm.abs(), 1), fixed(purity * 100.0, 2)));
        }
    }

    fn light(&mut self, reading: &Reading) {
        if let (Some(cct), Some(duv)) = (reading.cct_k, reading.duv) {
            self.add("CCT, Duv", format!("{} K, {}", kelvin(cct), signed(duv, 5)));
        }
        if let (Some(ra), Some(r)) = (reading.cri_ra, reading.cri_r) {
            let limit = if reading.cri_is_valid == Some(false) { " (beyond CIE 13.3's limit)" } else { "" };
            self.add("CRI Ra, R9", format!("{}, {}{limit}", fixed(ra, 2), fixed(r[8], 1)));
            for (k, part) in r.chunks(5).enumerate() {
                let cells = number::all(part.iter().copied(), 1, "  ");
                self.add(format!("R{}..R{}", 5 * k + 1, 5 * k + part.len()), cells);
            }
        }
        if let (Some(rf), Some(rg)) = (reading.tm30_rf, reading.tm30_rg) {
            self.add("TM-30-20 Rf, Rg", number::all([rf, rg], 2, ", "));
        }
        if let Some(ler) = reading.ler_lm_per_w {
            self.add("efficacy (LER)", format!("{} lm/W", fixed(ler, 2)));
        }
    }
}

/// Formats a number with six significant digits, which f32 holds.
fn significant(value: f64) -> String {
    number::significant(value, 6)
}

/// Formats a color temperature, with four digits above 10,000 K, where 0.05 mired is more than 5 K.
fn kelvin(cct_k: f32) -> String {
    let step = 10f32.powi((cct_k.log10().floor() as i32 - 3).max(0));
    fixed((cct_k / step).round() * step, 0)
}
