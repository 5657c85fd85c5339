//! Answers for people.

use crate::failure::printable;
use crate::output::{plot, terminal};
use crate::scene::answer::{Absolute, Answer, Budget, Look, Sensor};
use nanospectra::{Fine, Interpolation, Light, Outside, Power};
use std::fmt::{self, Write};
use std::path::Path;

/// Where the values stand.
const INDENT: usize = 16;

/// All of it; with escapes for colour if `truecolor`.
pub fn report(answer: &Answer, picture: Option<&Path>, truecolor: bool) -> String {
    let mut report = Text { text: String::new(), truecolor };
    // Writing to a String cannot fail.
    let _ = report.all(answer, picture);
    report.text
}

struct Text {
    text: String,
    truecolor: bool,
}

impl Text {
    fn all(&mut self, answer: &Answer, picture: Option<&Path>) -> fmt::Result {
        writeln!(
            self.text,
            "{}   ({}, {}, {})\n",
            printable(&answer.title),
            printable(&answer.lamp),
            answer.eye,
            answer.grid
        )?;
        for line in plot::lines(&curve(&answer.leaving), self.truecolor) {
            writeln!(self.text, "  {line}")?;
        }
        writeln!(self.text)?;
        let [lamp, color] = [answer.lamp_srgb, answer.look.srgb].map(|color| self.swatch(color));
        let color = color + clipped(&answer.look);
        self.row("lamp", lamp)?;
        self.row("colour", color)?;
        for (label, value) in coordinates(&answer.look) {
            self.row(label, value)?;
        }
        if let Some(absolute) = &answer.absolute {
            for (label, value) in levels(absolute) {
                self.row(label, value)?;
            }
        }
        if let Some(sensor) = &answer.sensor {
            self.row(
                "sensor",
                format_args!("{}; irradiance by the responsivity of a channel:", sensor.name),
            )?;
            for (label, cells) in channels(sensor, answer.absolute.is_some()) {
                let cells: String = cells.iter().map(|cell| format!(" {cell:>9}")).collect();
                self.row(&format!("  {label}"), cells)?;
            }
        }
        self.bill(answer)?;
        if let Some(path) = picture {
            self.row("picture", path.display())?;
        }
        Ok(())
    }

    fn bill(&mut self, answer: &Answer) -> fmt::Result {
        writeln!(
            self.text,
            "\n  {:<24}{:<14}{:>14}{:>8}  without it",
            "part", "effect", "multiply-adds", "bytes"
        )?;
        for line in &answer.bill {
            let (name, fate) = (short_name(&line.name), if line.left_out { "  left out" } else { "" });
            let cost = line.without_delta_e;
            writeln!(
                self.text,
                "  {name:<24}{:<14}{:>14}{:>8}  {cost:.2} CIEDE2000{fate}",
                line.effect, line.price.multiply_adds, line.price.bytes
            )?;
        }
        let mut total = |what: &str, multiply_adds: usize, bytes: usize| {
            writeln!(self.text, "  {what:<38}{multiply_adds:>14}{bytes:>8}")
        };
        total("walked, with lamp and eye", answer.walked.multiply_adds, answer.walked.bytes)?;
        total("folded into the eye", answer.folded.multiply_adds, answer.folded.bytes)?;
        if let Some(budget) = &answer.budget {
            writeln!(self.text, "\n  {}; {}", verdict(budget), self.swatch(budget.srgb))?;
        }
        Ok(())
    }

    /// The code, behind a patch of the colour if there is colour.
    fn swatch(&self, color: [u8; 3]) -> String {
        terminal::swatch(color, 8, self.truecolor)
    }

    fn row(&mut self, label: &str, value: impl fmt::Display) -> fmt::Result {
        writeln!(self.text, "  {label:<INDENT$}{value}")
    }
}

/// What fits its column.
pub fn short_name(name: &str) -> String {
    let name = printable(name);
    if name.chars().count() > 22 { name.chars().take(21).chain(['…']).collect() } else { name }
}

/// XYZ, xy, Lab and the luminous factor.
pub fn coordinates(look: &Look) -> Vec<(&'static str, String)> {
    let [x, y, z] = look.xyz.to_array();
    let xy = look.xy.map_or("none, black".into(), |xy| format!("{:.4} {:.4}", xy.x, xy.y));
    let lab = look.lab;
    vec![
        ("XYZ", format!("{x:.3} {y:.3} {z:.3}  (lamp: Y = 100)")),
        ("xy", xy),
        ("Lab", [lab.l, lab.a, lab.b].map(|value| format!("{:.2}", tidy(value))).join(" ")),
        ("luminous factor", format!("{y:.2} %")),
    ]
}

/// The rows of a chip: peaks, shares of the bare lamp's and, with a level, watts.
pub fn channels(sensor: &Sensor, is_absolute: bool) -> Vec<(&'static str, Vec<String>)> {
    let share = |share: &Option<f32>| share.map_or("none".into(), |share| format!("{:.2}%", 100.0 * share));
    let mut rows = vec![
        ("nm", sensor.peaks_nm.iter().map(f32::to_string).collect()),
        ("of the lamp", sensor.of_lamp.iter().map(share).collect()),
    ];
    if is_absolute {
        rows.push(("W/m2", sensor.channels.iter().map(|value| digits(*value)).collect()));
    }
    rows
}

/// What to say behind the code of a colour that displays do not have.
pub fn clipped(look: &Look) -> &'static str {
    if look.is_clipped { "  clipped: outside sRGB" } else { "" }
}

/// What `--budget` came to, without its colour.
pub fn verdict(budget: &Budget) -> String {
    let within = format!("within {} CIEDE2000: ", budget.delta_e);
    let effects = match budget.left_out.len() {
        0 => return within + "nothing can be left out",
        1 => "1 effect".into(),
        count => format!("{count} effects"),
    };
    let Budget { cost_delta_e, multiply_adds, .. } = budget;
    format!("{within}{effects} left out, {cost_delta_e:.3} CIEDE2000 in all, {multiply_adds} multiply-adds")
}

/// Photometric and radiometric numbers with their units.
pub fn levels(absolute: &Absolute) -> Vec<(&'static str, String)> {
    let mut levels = vec![
        (
            "arrives",
            format!("{} lx, {} W/m2", digits(absolute.illuminance_lx), digits(absolute.irradiance_w_m2)),
        ),
        (
            "leaves",
            format!("{} lm/m2, {} W/m2", digits(absolute.exitance_lm_m2), digits(absolute.exitance_w_m2)),
        ),
    ];
    if let Some([luminance, radiance]) = absolute.radiance {
        let [luminance, radiance] = [luminance, radiance].map(digits);
        levels.push(("looks (Lambert)", format!("{luminance} cd/m2, {radiance} W/(m2 sr)")));
    }
    levels
}

/// Without a minus before what is printed as zero.
fn tidy(value: f32) -> f32 {
    if value.abs() < 0.005 { 0.0 } else { value }
}

/// A number with four digits or more, plain unless it is tiny.
fn digits(value: f32) -> String {
    let decimals = (3.0 - value.abs().log10().floor()).clamp(0.0, 9.0);
    if value == 0.0 {
        "0".into()
    } else if decimals < 9.0 {
        format!("{value:.*}", decimals as usize)
    } else {
        format!("{value:.3e}")
    }
}

/// For plots: the bands joined, on 1 nm.
fn curve(spectrum: &[(f32, f32)]) -> Fine<Power> {
    Fine::interpolated(spectrum, Interpolation::Linear, Outside::Zero).unwrap_or(Light::flat(0.0))
}
