//! Reports an answer as text.

use crate::failure::shown;
use crate::output::Report;
use crate::output::number::{self, at_least_four, fixed, shortest};
use crate::scene::answer::{Absolute, Answer, Budget, Line, Look, Sensor};
use nanospectra::color::Lab;
use nanospectra::path::Price;
use nanospectra::{Fine, Interpolation, Light, Power};
use std::path::Path;

/// The length of the longest title, and of the longest name of a lamp, in characters.
pub const NAME: usize = 70;

/// Reports a scene. With `truecolor` the text has escape sequences for colors.
pub fn report(answer: &Answer, picture: Option<&Path>, truecolor: bool) -> String {
    let mut report = Report::new(16, truecolor);
    let [title, lamp] = [&answer.title, &answer.lamp].map(|name| shown(name, NAME));
    report.line(format_args!("{title}   ({lamp}, {}, {})\n", answer.eye, answer.grid));
    report.plot(&curve(&answer.leaving));
    report.row("lamp", report.swatch(answer.lamp_srgb, 8));
    report.row("color", report.swatch(answer.look.srgb, 8) + clipped(&answer.look));
    let levels = answer.absolute.as_ref().map_or(Vec::new(), levels);
    for (label, value) in coordinates(&answer.look).into_iter().chain(levels) {
        report.row(label, value);
    }
    if let Some(sensor) = &answer.sensor {
        report.row(
            "sensor",
            format_args!("{}; irradiance weighted by the responsivity of a channel:", sensor.name),
        );
        for (label, cells) in channels(sensor, answer.absolute.is_some()) {
            let cells: String = cells.iter().map(|cell| format!(" {cell:>9}")).collect();
            report.row(&format!("  {label}"), cells);
        }
    }
    bill(&mut report, answer);
    for note in &answer.notes {
        report.line(format_args!("\n  {note}"));
    }
    if let Some(path) = picture {
        report.path("picture", path);
    }
    report.into_text()
}

fn bill(report: &mut Report, answer: &Answer) {
    let [part, effect, work, bytes] = ["part", "effect", "multiply-adds", "bytes"];
    report.line(format_args!("\n  {part:<24}{effect:<14}{work:>14}{bytes:>8}  without it"));
    for line in &answer.bill {
        let (name, fate) = (short_name(&line.name), if line.left_out { "  left out" } else { "" });
        let (effect, cost) = (line.effect, difference(line));
        let (work, bytes) = (line.price.multiply_adds, line.price.bytes);
        report.line(format_args!("  {name:<24}{effect:<14}{work:>14}{bytes:>8}  {cost}{fate}"));
    }
    for (what, price) in totals(answer) {
        report.line(format_args!("  {what:<38}{:>14}{:>8}", price.multiply_adds, price.bytes));
    }
    if let Some(budget) = &answer.budget {
        report.line(format_args!("\n  {}; {}", verdict(budget), report.swatch(budget.srgb, 8)));
    }
}

/// The color difference that a scene has without a part.
pub fn difference(line: &Line) -> String {
    line.without_delta_e
        .map_or("no color difference".into(), |delta_e| format!("{} CIEDE2000", fixed(delta_e, 2)))
}

/// The prices of the whole scene: part by part (`walked`), and as one matrix (`folded`).
pub fn totals(answer: &Answer) -> [(&'static str, Price); 2] {
    [("part by part, with lamp and eye", answer.walked), ("as one matrix, with the eye", answer.folded)]
}

/// Shortens a name to the width of its column.
pub fn short_name(name: &str) -> String {
    shown(name, 22)
}

/// The rows for XYZ, xy, Lab and the luminous factor.
pub fn coordinates(look: &Look) -> Vec<(&'static str, String)> {
    let xy = look.xy.map_or("none, black".into(), |xy| number::all([xy.x, xy.y], 4, " "));
    let lab = |lab: Lab| number::all([lab.l, lab.a, lab.b].map(tidy), 2, " ");
    vec![
        ("XYZ", number::all(look.xyz.to_array(), 3, " ") + "  (lamp: Y = 100)"),
        ("xy", xy),
        ("Lab", look.lab.map_or("none, the lamp is no white".into(), lab)),
        ("luminous factor", fixed(look.xyz.y, 2) + " %"),
    ]
}

/// The rows of a sensor: the peaks of its channels, their values relative to the bare lamp and, if the lamp
/// has an illuminance, in W/m2.
pub fn channels(sensor: &Sensor, is_absolute: bool) -> Vec<(&'static str, Vec<String>)> {
    let share = |share: &Option<f32>| share.map_or("none".into(), |share| fixed(100.0 * share, 2) + "%");
    let mut rows = vec![
        ("nm", sensor.peaks_nm.iter().copied().map(shortest).collect()),
        ("of the lamp", sensor.of_lamp.iter().map(share).collect()),
    ];
    if is_absolute {
        rows.push(("W/m2", sensor.channels.iter().map(|value| at_least_four(*value)).collect()));
    }
    rows
}

/// What follows the code of a color that is outside sRGB.
pub fn clipped(look: &Look) -> &'static str {
    if look.is_clipped { "  clipped: outside sRGB" } else { "" }
}

/// The result of `--budget`, without the color.
pub fn verdict(budget: &Budget) -> String {
    let within = format!("within {} CIEDE2000: ", shortest(budget.delta_e));
    let effects = match budget.left_out.len() {
        0 => return within + "nothing can be left out",
        1 => "1 effect".into(),
        count => format!("{count} effects"),
    };
    let (cost, work) = (fixed(budget.cost_delta_e, 3), budget.multiply_adds);
    format!("{within}{effects} left out, {cost} CIEDE2000 in all, {work} multiply-adds")
}

/// The rows of photometric and radiometric numbers, with units.
pub fn levels(absolute: &Absolute) -> Vec<(&'static str, String)> {
    let Absolute { illuminance_lx, irradiance_w_m2, exitance_lm_m2, exitance_w_m2, .. } = *absolute;
    let [lx, falling] = [illuminance_lx, irradiance_w_m2].map(at_least_four);
    let [lm, leaving] = [exitance_lm_m2, exitance_w_m2].map(at_least_four);
    let mut levels = vec![
        ("arrives", format!("{lx} lx, {falling} W/m2")),
        ("leaves", format!("{lm} lm/m2, {leaving} W/m2")),
    ];
    if let Some([luminance, radiance]) = absolute.radiance {
        let [luminance, radiance] = [luminance, radiance].map(at_least_four);
        levels.push(("looks (Lambert)", format!("{luminance} cd/m2, {radiance} W/(m2 sr)")));
    }
    levels
}

/// Removes the minus sign from a number that would be printed as -0.00.
fn tidy(value: f32) -> f32 {
    if value.abs() < 0.005 { 0.0 } else { value }
}

/// The spectrum on the 1 nm grid for plots, with straight lines from band to band.
fn curve(spectrum: &[(f32, f32)]) -> Fine<Power> {
    Fine::interpolated(spectrum, Interpolation::Linear).unwrap_or(Light::flat(0.0))
}
