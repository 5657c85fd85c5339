//! Answers for people.

use crate::output::{plot, terminal};
use crate::paint::answer::{Answer, Look};
use crate::paint::args::Args;
use crate::usage::name_of;
use nanospectra::{Fine, Power};
use std::fmt::{self, Write};
use std::path::Path;

/// Where the values stand.
const INDENT: usize = 14;

/// One colour with its spectrum; with escapes for colour if `truecolor`.
pub fn report(args: &Args, answer: &Answer, picture: Option<&Path>, truecolor: bool) -> String {
    let mut report = Text { text: String::new(), truecolor };
    // Writing to a String cannot fail.
    let _ = report.one(args, answer, picture);
    report.text
}

/// All samples, a line each: a picture made of swatches where there is colour.
pub fn chart(args: &Args, answers: &[Answer], truecolor: bool) -> String {
    let mut chart = Text { text: String::new(), truecolor };
    let _ = chart.all(args, answers);
    chart.text
}

struct Text {
    text: String,
    truecolor: bool,
}

impl Text {
    fn one(&mut self, args: &Args, answer: &Answer, picture: Option<&Path>) -> fmt::Result {
        let numbers = if args.linear { "linear" } else { "encoded" };
        let [r, g, b] = answer.rgb;
        let (space, method) = (name_of(args.space), name_of(args.method));
        writeln!(self.text, "{r} {g} {b}   ({space}, {numbers}; {method} on {})\n", args.grid)?;
        let curve: Fine<Power> = Fine::<Power>::flat(1.0) * answer.curve;
        for line in plot::lines(&curve, self.truecolor) {
            writeln!(self.text, "  {line}")?;
        }
        writeln!(self.text)?;
        if let Some(top) = answer.spectrum.iter().copied().reduce(|a, b| if b.1 > a.1 { b } else { a }) {
            self.row("highest", format_args!("{:.4} at {} nm", top.1, top.0))?;
        }
        let [r, g, b] = answer.roundtrip;
        self.row("gives back", format_args!("{r:.5}  {g:.5}  {b:.5}"))?;
        self.row("status", verdict(answer))?;
        let asked = self.swatch(answer.asked, 8);
        self.row("asked for", asked)?;
        for look in &answer.looks {
            let swatch = self.swatch(look.srgb, 8);
            self.row(&format!("under {}", look.light), format_args!("{swatch}  {}", coordinates(look)))?;
        }
        if let Some(path) = picture {
            self.row("picture", path.display())?;
        }
        writeln!(self.text)
    }

    fn all(&mut self, args: &Args, answers: &[Answer]) -> fmt::Result {
        let lights: Vec<&str> =
            answers.first().map_or(Vec::new(), |a| a.looks.iter().map(|look| look.light.as_str()).collect());
        writeln!(
            self.text,
            "24 samples of CES99, every fourth, by their colours in sRGB under D65 alone: {} on\n\
             {} makes a spectrum of each, here seen under {} (CIE 1931,\n\
             swatches adapted to D65 by CAT16). What the measured samples would look like there is another\n\
             matter. For a colour of your own: nanospectra paint 0.8,0.2,0.1; --help says the rest.\n",
            name_of(args.method),
            args.grid,
            lights.join(", "),
        )?;
        let wide = if self.truecolor { 20 } else { 10 };
        let heads: String = lights.iter().map(|light| format!("{light:<wide$}")).collect();
        writeln!(self.text, "  {:<8}{heads}status", "")?;
        for answer in answers {
            write!(self.text, "  {:<8}", answer.sample.as_deref().unwrap_or(""))?;
            for look in &answer.looks {
                let swatch = self.swatch(look.srgb, 10);
                write!(self.text, "{swatch}   ")?;
            }
            writeln!(self.text, "{}", verdict(answer))?;
        }
        if let Some(path) = &args.svg {
            writeln!(self.text)?;
            self.row("pictures", path.display())?;
        }
        Ok(())
    }

    /// The code, behind a patch of the colour if there is colour.
    fn swatch(&self, color: [u8; 3], wide: usize) -> String {
        terminal::swatch(color, wide, self.truecolor)
    }

    fn row(&mut self, label: &str, value: impl fmt::Display) -> fmt::Result {
        writeln!(self.text, "  {label:<INDENT$}{value}")
    }
}

/// The status, how it came about, and what it costs.
pub fn verdict(answer: &Answer) -> String {
    let how = match answer.kept {
        Some(kept) => format!(" (desaturate: {:.1} % of the way from grey)", 100.0 * kept),
        None if answer.status == "unreachable" => " (nearest)".into(),
        None => String::new(),
    };
    format!("{}{how}, CIEDE2000 {:.5}", answer.status, answer.delta_e2000)
}

/// XYZ and Lab under a light.
pub fn coordinates(look: &Look) -> String {
    let [x, y, z] = look.xyz.to_array();
    let lab = look.lab;
    format!("XYZ {x:.3} {y:.3} {z:.3}  Lab {:.3} {:.3} {:.3}", lab.l, lab.a, lab.b)
}
