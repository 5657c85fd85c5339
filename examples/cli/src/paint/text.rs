//! Reports answers as text.

use crate::output::Report;
use crate::output::number::{self, fixed, shortest};
use crate::paint::answer::{Answer, Look};
use crate::paint::args::Args;
use crate::usage::name_of;
use nanospectra::color::Lab;
use nanospectra::{Fine, Power};
use std::path::Path;

/// The column at which values begin.
const INDENT: usize = 14;

/// Reports one color and its spectrum. With `truecolor` the text has escape sequences for colors.
pub fn report(args: &Args, answer: &Answer, picture: Option<&Path>, truecolor: bool) -> String {
    let mut report = Report::new(INDENT, truecolor);
    let numbers = if args.linear { "linear" } else { "encoded" };
    let rgb = answer.rgb.map(shortest).join(" ");
    let (space, method) = (name_of(args.space), name_of(args.method));
    report.line(format_args!("{rgb}   ({space}, {numbers}; {method} on {})\n", args.grid));
    report.plot(&(Fine::<Power>::flat(1.0) * answer.curve));
    if let Some(top) = answer.spectrum.iter().copied().reduce(|a, b| if b.1 > a.1 { b } else { a }) {
        report.row("highest", format_args!("{} at {} nm", fixed(top.1, 4), shortest(top.0)));
    }
    report.row("gives back", number::all(answer.roundtrip, 5, "  "));
    report.row("status", verdict(answer));
    report.row("asked for", report.swatch(answer.asked, 8));
    for look in &answer.looks {
        let swatch = report.swatch(look.srgb, 8);
        report.row(&format!("under {}", look.light), format_args!("{swatch}  {}", coordinates(look)));
    }
    if let Some(path) = picture {
        report.path("picture", path);
    }
    report.line("");
    report.into_text()
}

/// Reports all samples, each on one line, with swatches if the terminal has colors.
pub fn chart(args: &Args, answers: &[Answer], truecolor: bool) -> String {
    let mut chart = Report::new(INDENT, truecolor);
    let lights: Vec<&str> =
        answers.first().map_or(Vec::new(), |a| a.looks.iter().map(|look| look.light.as_str()).collect());
    chart.line(format_args!(
        "These are 24 samples of CES99 (every fourth), known only by their sRGB colors under D65. The method\n\
         {} on {} finds a spectrum with that color, which is shown under\n\
         {} (CIE 1931, swatches adapted to D65 by CAT16). The measured samples may look\n\
         different there. To see a color of your own: nanospectra paint 0.8,0.2,0.1. For more: --help.\n",
        name_of(args.method),
        args.grid,
        lights.join(", "),
    ));
    let wide = if truecolor { 20 } else { 10 };
    let heads: String = lights.iter().map(|light| format!("{light:<wide$}")).collect();
    chart.line(format_args!("  {:<8}{heads}status", ""));
    for answer in answers {
        let looks = answer.looks.iter().map(|look| chart.swatch(look.srgb, 10) + "   ");
        let looks: String = looks.collect();
        let sample = answer.sample.as_deref().unwrap_or("");
        chart.line(format_args!("  {sample:<8}{looks}{}", verdict(answer)));
    }
    if let Some(path) = &args.svg {
        chart.line("");
        chart.path("pictures", path);
    }
    chart.into_text()
}

/// The status, what was done about a color for which no sigmoid was found, and the color difference that is
/// left.
pub fn verdict(answer: &Answer) -> String {
    let how = match answer.kept {
        Some(kept) => format!(" (desaturate: {} % of the way from gray)", fixed(100.0 * kept, 1)),
        None if answer.status == "unreachable" => " (nearest)".into(),
        None => String::new(),
    };
    format!("{}{how}, CIEDE2000 {}", answer.status, fixed(answer.delta_e2000, 5))
}

/// The XYZ and Lab coordinates under a light.
pub fn coordinates(look: &Look) -> String {
    let Lab { l, a, b } = look.lab;
    format!("XYZ {}  Lab {}", number::all(look.xyz.to_array(), 3, " "), number::all([l, a, b], 3, " "))
}
