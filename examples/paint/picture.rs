//! One SVG for each colour: its spectrum in the colours of the wavelengths, and swatches under the lights.

#[path = "../colorimeter/picture/axis.rs"]
mod axis;

use crate::answer::Answer;
use crate::args::{Args, name_of};
use crate::failure::Failure;
use crate::{text, tint};
use axis::{Axis, Frame};
use std::fs::{self, File};
use std::io::Error;
use std::path::{Path, PathBuf};
use svg::Document;
use svg::node::element::path::Data;
use svg::node::element::{Definitions, Group, LinearGradient, Rectangle, Stop};
use svg::node::element::{Path as Line, Text};

const WIDTH: f32 = 1120.0;
/// Above the first swatch, and from one to the next.
const SWATCHES: f32 = 90.0;
const SPACING: f32 = 90.0;
const INK: &str = "#222222";
const FAINT: &str = "#777777";
const GRID: &str = "#dddddd";
/// Colour changes every so many nm.
const COLOR_STEP: usize = 4;

/// Where a diagram stands on the page.
#[derive(Clone, Copy)]
struct Area {
    left: f32,
    top: f32,
    width: f32,
    height: f32,
}

/// New files, and the directories made for them. Both are taken back unless they are kept.
pub struct Pictures {
    /// In the order of the answers.
    pub paths: Vec<PathBuf>,
    /// The inner ones first.
    directories: Vec<PathBuf>,
}

impl Pictures {
    /// The run has done all it was asked for.
    pub fn keep(mut self) {
        self.paths.clear();
        self.directories.clear();
    }
}

impl Drop for Pictures {
    /// What cannot be removed stays: why the run fails is said already.
    fn drop(&mut self) {
        for path in &self.paths {
            let _ = fs::remove_file(path);
        }
        for directory in &self.directories {
            let _ = fs::remove_dir(directory);
        }
    }
}

/// Draws every answer into a new file of `directory`, which is made if missing.
pub fn save_all(directory: &Path, args: &Args, answers: &[Answer]) -> Result<Pictures, Failure> {
    let refused = |path: &Path, error: Error| {
        let what = format!("cannot be written ({}); name a directory you may write to", error.kind());
        Failure::of(format_args!("--svg {}", path.display()), what)
    };
    let missing = directory.ancestors().take_while(|path| path.symlink_metadata().is_err());
    let directories = missing.map(Path::to_path_buf).collect();
    let mut pictures = Pictures { paths: Vec::new(), directories };
    fs::create_dir_all(directory).map_err(|error| refused(directory, error))?;
    let digits = answers.len().to_string().len();
    let paths: Vec<PathBuf> = answers
        .iter()
        .zip(1..)
        .map(|(answer, number)| {
            let hex = tint::hex(answer.asked);
            directory.join(format!("{number:0digits$}-{}.svg", &hex[1..]))
        })
        .collect();
    // Before the first is written, so that no half set of pictures is left behind.
    if let Some(taken) = paths.iter().find(|path| path.symlink_metadata().is_ok()) {
        return Err(Failure::of(
            format_args!("--svg {}", taken.display()),
            "is there already; remove it or name another directory",
        ));
    }
    for (path, answer) in paths.into_iter().zip(answers) {
        let file = File::create_new(&path).map_err(|error| refused(&path, error))?;
        pictures.paths.push(path.clone());
        svg::write(file, &page(args, answer)).map_err(|error| refused(&path, error))?;
    }
    Ok(pictures)
}

fn page(args: &Args, answer: &Answer) -> Document {
    let swatches = SWATCHES + SPACING * (answer.looks.len() + 1) as f32;
    let height = swatches.max(490.0);
    let diagram = Area { left: 80.0, top: 90.0, width: 560.0, height: 330.0 };
    Document::new()
        .set("viewBox", (0, 0, WIDTH, height))
        .set("width", WIDTH)
        .set("height", height)
        .set("font-family", "DejaVu Sans, Verdana, Helvetica, Arial, sans-serif")
        .set("font-size", 13)
        .add(Rectangle::new().set("width", WIDTH).set("height", height).set("fill", "#ffffff"))
        .add(heading(args, answer))
        .add(spectrum(diagram, answer))
        .add(looks(answer))
}

fn heading(args: &Args, answer: &Answer) -> Group {
    let [r, g, b] = answer.rgb;
    let sample = answer.sample.as_ref().map(|name| format!("{name}: ")).unwrap_or_default();
    let subtitle = format!(
        "{}{}  ·  {} on {}  ·  {}",
        name_of(args.space),
        if args.linear { ", linear" } else { "" },
        name_of(args.method),
        args.grid,
        text::verdict(answer),
    );
    Group::new()
        .add(
            label(30.0, 42.0, &format!("{sample}{r} {g} {b}"))
                .set("font-size", 24)
                .set("font-weight", "bold"),
        )
        .add(label(30.0, 66.0, &subtitle).set("fill", FAINT))
}

/// The curve through the centres of the bands; the axis holds 0..1, and what is beyond if something is.
fn spectrum(area: Area, answer: &Answer) -> Group {
    let samples = &answer.spectrum;
    let (Some(first), Some(last)) = (samples.first(), samples.last()) else { return Group::new() };
    let low = samples.iter().map(|(_, share)| *share).fold(0.0, f32::min);
    let high = samples.iter().map(|(_, share)| *share).fold(1.0, f32::max);
    let x = Axis { from: first.0, to: last.0, step: 50.0 };
    let frame = Frame { area, x, y: Axis::holding(low, high) };
    let base = frame.place(first.0, 0.0).1;
    let points = samples.iter().map(|(nm, share)| frame.place(*nm, *share));
    let start = frame.place(first.0, first.1);
    let (mut outline, mut filled) = (Data::new().move_to(start), Data::new().move_to((start.0, base)));
    for point in points {
        outline = outline.line_to(point);
        filled = filled.line_to(point);
    }
    filled = filled.line_to((frame.place(last.0, 0.0).0, base)).close();
    let curve = Line::new().set("d", outline).set("fill", "none").set("stroke", INK);
    Group::new()
        .add(Definitions::new().add(rainbow(&frame)))
        .add(frame.draw("wavelength / nm", "reflectance"))
        .add(Line::new().set("d", filled).set("fill", "url(#rainbow)"))
        .add(curve.set("stroke-linejoin", "round"))
        .add(frame.border())
}

/// Left to right the colours of the wavelengths.
fn rainbow(frame: &Frame) -> LinearGradient {
    let (from, to) = (frame.x.from, frame.x.to);
    let gradient = LinearGradient::new()
        .set("id", "rainbow")
        .set("gradientUnits", "userSpaceOnUse")
        .set("x1", frame.place(from, 0.0).0)
        .set("x2", frame.place(to, 0.0).0)
        .set("y1", 0)
        .set("y2", 0);
    (from as usize..=to as usize).step_by(COLOR_STEP).fold(gradient, |gradient, nm| {
        let nm = nm as f32;
        let color = tint::hex(tint::of_wavelength(nm));
        gradient.add(Stop::new().set("offset", (nm - from).max(0.0) / (to - from)).set("stop-color", color))
    })
}

/// What was asked for, and below it what the spectrum looks like under each light.
fn looks(answer: &Answer) -> Group {
    let asked = ("asked for".to_owned(), answer.asked, String::new());
    let under =
        answer.looks.iter().map(|look| (format!("under {}", look.light), look.srgb, text::coordinates(look)));
    let mut group = Group::new();
    for (k, (title, color, numbers)) in [asked].into_iter().chain(under).enumerate() {
        let top = SWATCHES + SPACING * k as f32;
        let hex = tint::hex(color);
        let (xyz, lab) = numbers.split_once("  ").unwrap_or_default();
        let patch = Rectangle::new()
            .set("x", 690)
            .set("y", top)
            .set("width", 130)
            .set("height", SPACING - 12.0)
            .set("rx", 8)
            .set("fill", hex.as_str())
            .set("stroke", GRID);
        group = group
            .add(patch)
            .add(label(840.0, top + 18.0, &format!("{title}  {hex}")))
            .add(label(840.0, top + 42.0, xyz).set("fill", FAINT))
            .add(label(840.0, top + 62.0, lab).set("fill", FAINT));
    }
    group
}

fn label(x: f32, y: f32, text: &str) -> Text {
    // SVG takes a run of blanks for one.
    let text = text.replace("  ", "\u{a0}\u{a0}");
    Text::new(text).set("x", x).set("y", y).set("fill", INK)
}
