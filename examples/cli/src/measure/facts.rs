//! Turns the numbers of a reading into labeled lines for the report and for the picture.

use crate::measure::args::Unit;
use crate::measure::reading::{Bench, Comparison, Difference, Reading};
use crate::output::report;

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
            Some(Difference::One(value)) => facts.add(*key, format!("{value:.5}")),
            Some(Difference::Each(values)) => {
                let cells: Vec<String> = values.iter().map(|value| format!("{value:+.5}")).collect();
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
            self.add("x  y", format!("{:.5}  {:.5}", p.x, p.y));
        }
        if let Some(p) = reading.uv1960 {
            self.add("u  v  (1960)", format!("{:.5}  {:.5}", p.u, p.v));
        }
        if let Some(p) = reading.uv1976 {
            self.add("u' v' (1976)", format!("{:.5}  {:.5}", p.u, p.v));
        }
        if let Some(lab) = reading.lab {
            self.add("L* a* b*", format!("{:.3}  {:.3}  {:.3}", lab.l, lab.a, lab.b));
        }
        if let Some(delta) = reading.delta_e2000 {
            self.add("CIEDE2000 to white", format!("{delta:.3}"));
        }
        if let (Some([r, g, b]), Some(hex)) = (reading.srgb, &reading.hex) {
            self.add("sRGB", format!("{hex}  ({r:.4}  {g:.4}  {b:.4})"));
        }
        if let (Some(nm), Some(purity)) = (reading.dominant_wavelength_nm, reading.purity) {
            let label = if nm < 0.0 { "complementary" } else { "dominant" };
            self.add(label, format!("{:.1} nm, purity {:.2} %", nm.abs(), purity * 100.0));
        }
    }

    fn light(&mut self, reading: &Reading) {
        if let (Some(cct), Some(duv)) = (reading.cct_k, reading.duv) {
            self.add("CCT, Duv", format!("{} K, {duv:+.5}", kelvin(cct)));
        }
        if let (Some(ra), Some(r)) = (reading.cri_ra, reading.cri_r) {
            self.add("CRI Ra", format!("{ra:.2}"));
            for (k, part) in r.chunks(5).enumerate() {
                let cells: Vec<String> = part.iter().map(|value| format!("{value:.1}")).collect();
                self.add(format!("R{}..R{}", 5 * k + 1, 5 * k + part.len()), cells.join("  "));
            }
        }
        if let (Some(rf), Some(rg)) = (reading.tm30_rf, reading.tm30_rg) {
            self.add("TM-30 Rf, Rg", format!("{rf:.2}, {rg:.2}"));
        }
        if let Some(ler) = reading.ler_lm_per_w {
            self.add("efficacy (LER)", format!("{ler:.2} lm/W"));
        }
        if let Some(ratio) = reading.melanopic_edi_ratio {
            self.add("melanopic EDI ratio", format!("{ratio:.4}"));
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
    report::significant(value, 6)
}

/// Formats a color temperature, with four digits above 10,000 K, where 0.05 mired is more than 5 K.
fn kelvin(cct_k: f32) -> String {
    let step = 10f32.powi((cct_k.log10().floor() as i32 - 3).max(0));
    format!("{:.0}", (cct_k / step).round() * step)
}
