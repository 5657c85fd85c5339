//! Turns the numbers of a reading into labeled lines for the report and for the picture.

use crate::measure::args::Unit;
use crate::measure::reading::{Bench, Comparison, Difference, Reading};
use crate::output::number::{self, fixed, signed};

/// A label and the text beside it.
pub struct Fact {
    pub label: String,
    pub value: String,
}

/// Returns the facts about the color, and those about the light if the reading is one of a light.
pub fn facts(bench: &Bench, reading: &Reading) -> Vec<Fact> {
    let mut facts = Facts(Vec::new());
    facts.color(bench, reading);
    facts.light(reading);
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

    fn color(&mut self, bench: &Bench, reading: &Reading) {
        let unit = if bench.unit == Unit::Absolute { " lx" } else { "" };
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
        if let Some(delta) = reading.delta_e2000 {
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
            self.add("CRI Ra", fixed(ra, 2));
            for (k, part) in r.chunks(5).enumerate() {
                let cells = number::all(part.iter().copied(), 1, "  ");
                self.add(format!("R{}..R{}", 5 * k + 1, 5 * k + part.len()), cells);
            }
        }
        if let (Some(rf), Some(rg)) = (reading.tm30_rf, reading.tm30_rg) {
            self.add("TM-30 Rf, Rg", number::all([rf, rg], 2, ", "));
        }
        if let Some(ler) = reading.ler_lm_per_w {
            self.add("efficacy (LER)", format!("{} lm/W", fixed(ler, 2)));
        }
        if let Some(ratio) = reading.melanopic_edi_ratio {
            self.add("melanopic EDI ratio", fixed(ratio, 4));
        }
        if let Some(lux) = reading.lux {
            self.add("illuminance", format!("{} lx", significant(lux)));
        }
        if let Some(ppfd) = reading.ppfd {
            self.add("PPFD", format!("{} µmol/m²/s", significant(ppfd)));
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
