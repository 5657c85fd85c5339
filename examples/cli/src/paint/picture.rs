//! Draws one SVG for each color, with its spectrum in the colors of the wavelengths and with swatches of how
//! it looks under the lights.

use crate::failure::Failure;
use crate::output::{Files, number, tint};
use crate::paint::answer::Answer;
use crate::paint::args::Args;
use crate::paint::text;
use crate::picture::spectrum::{self, Spectrum};
use crate::picture::{self, Area, FAINT, label, patch};
use crate::usage::name_of;
use std::path::Path;
use svg::Document;
use svg::node::element::Group;

/// Where the first swatch begins, from the top.
const SWATCHES: f32 = 90.0;
/// From one swatch to the next.
const SPACING: f32 = 90.0;

/// Draws every answer into a file in `directory`, which is made if it is missing.
pub fn write_all(
    files: &mut Files,
    directory: &Path,
    args: &Args,
    answers: impl ExactSizeIterator<Item = Result<Answer, Failure>>,
) -> Result<(), Failure> {
    files.make_directory(directory)?;
    let digits = answers.len().to_string().len();
    for (answer, number) in answers.zip(1..) {
        let answer = answer?;
        let hex = tint::hex(answer.asked);
        let path = directory.join(format!("{number:0digits$}-{}.svg", &hex[1..]));
        files.write(path, &page(args, &answer).to_string())?;
    }
    Ok(())
}

fn page(args: &Args, answer: &Answer) -> Document {
    let swatches = SWATCHES + SPACING * (answer.looks.len() + 1) as f32;
    let height = swatches.max(490.0);
    let numbers = answer.rgb.map(number::shortest).join(" ");
    let sample = answer.sample.as_ref().map(|name| format!("{name}: ")).unwrap_or_default();
    let subtitle = format!(
        "{}{}  ·  {} on {}  ·  {}",
        name_of(args.space),
        if args.linear { ", linear" } else { "" },
        name_of(args.method),
        args.grid,
        text::verdict(answer),
    );
    picture::page(height, &format!("{sample}{numbers}"), &subtitle).add(curve(answer)).add(looks(answer))
}

/// The curve through the centers of the bands. The axis holds 0..1, and more if the spectrum leaves that
/// range.
fn curve(answer: &Answer) -> Group {
    let area = Area { left: 80.0, top: 90.0, width: 560.0, height: 330.0 };
    let spectrum = Spectrum { filled: &spectrum::points(&answer.spectrum), high: 1.0, ..Spectrum::default() };
    spectrum::draw(area, ["wavelength / nm", "reflectance"], &spectrum)
}

/// The color that was asked for, and below it how the spectrum looks under each light.
fn looks(answer: &Answer) -> Group {
    let asked = ("asked for".to_owned(), answer.asked, String::new());
    let under =
        answer.looks.iter().map(|look| (format!("under {}", look.light), look.srgb, text::coordinates(look)));
    let mut group = Group::new();
    for (k, (title, color, numbers)) in [asked].into_iter().chain(under).enumerate() {
        let top = SWATCHES + SPACING * k as f32;
        let hex = tint::hex(color);
        let (xyz, lab) = numbers.split_once("  ").unwrap_or_default();
        let area = Area { left: 690.0, top, width: 130.0, height: SPACING - 12.0 };
        group = group
            .add(patch(area, color).set("rx", 8))
            .add(label(840.0, top + 18.0, &format!("{title}  {hex}")))
            .add(label(840.0, top + 42.0, xyz).set("fill", FAINT))
            .add(label(840.0, top + 62.0, lab).set("fill", FAINT));
    }
    group
}
