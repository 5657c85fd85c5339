//! The picture of a scene: the light before and after, what it looks like, and the bill.

#[path = "../colorimeter/picture/axis.rs"]
mod axis;

use crate::answer::{Answer, Line};
use crate::failure::{Failure, printable};
use crate::{text, tint};
use axis::{Axis, Frame};
use std::fs::{self, File};
use std::io::Error;
use std::path::{Path, PathBuf};
use svg::Document;
use svg::node::element::path::Data;
use svg::node::element::{Definitions, Group, LinearGradient, Path as Curve, Rectangle, Stop, Text};

const WIDTH: f32 = 1120.0;
const INK: &str = "#222222";
const FAINT: &str = "#777777";
const GRID: &str = "#dddddd";
/// Where the bill begins, and from one line to the next.
const BILL: f32 = 520.0;
const SPACING: f32 = 26.0;
/// The columns of the bill: part, effect, multiply-adds, bytes, without it, patch.
const COLUMNS: [f32; 6] = [30.0, 250.0, 470.0, 560.0, 600.0, 780.0];

/// Where a diagram stands on the page.
#[derive(Clone, Copy)]
struct Area {
    left: f32,
    top: f32,
    width: f32,
    height: f32,
}

/// Draws into a new file: `path` if it ends in .svg, else one in that directory, which is made if missing.
pub fn save(path: &Path, answer: &Answer) -> Result<PathBuf, Failure> {
    let refused = |path: &Path, error: Error| {
        let what = format!("cannot be written ({}); name a place you may write to", error.kind());
        Failure::of(format_args!("--svg {}", path.display()), what)
    };
    let path = if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("svg")) {
        path.to_owned()
    } else {
        fs::create_dir_all(path).map_err(|error| refused(path, error))?;
        path.join(format!("{}.svg", answer.name))
    };
    if path.symlink_metadata().is_ok() {
        return Err(Failure::of(
            format_args!("--svg {}", path.display()),
            "is there already; remove it or give another name",
        ));
    }
    let file = File::create_new(&path).map_err(|error| refused(&path, error))?;
    svg::write(file, &page(answer)).map_err(|error| refused(&path, error))?;
    Ok(path)
}

fn page(answer: &Answer) -> Document {
    let notes = notes(answer);
    let end = BILL + SPACING * (answer.bill.len() + 3) as f32;
    let height = end + SPACING * (notes.len() + 1) as f32;
    let diagram = Area { left: 90.0, top: 90.0, width: 560.0, height: 330.0 };
    Document::new()
        .set("viewBox", (0, 0, WIDTH, height))
        .set("width", WIDTH)
        .set("height", height)
        .set("font-family", "DejaVu Sans, Verdana, Helvetica, Arial, sans-serif")
        .set("font-size", 13)
        .add(Rectangle::new().set("width", WIDTH).set("height", height).set("fill", "#ffffff"))
        .add(heading(answer))
        .add(spectra(diagram, answer))
        .add(looks(answer))
        .add(bill(answer))
        .add(notes.into_iter().enumerate().fold(Group::new(), |group, (k, cells)| {
            let y = end + SPACING * (k + 1) as f32;
            // The title, and eight columns behind it.
            cells.iter().enumerate().fold(group, |group, (column, cell)| {
                let x = if column == 0 { COLUMNS[0] } else { 150.0 + 100.0 * column as f32 };
                group.add(label(x, y, cell).set("fill", if column == 0 { FAINT } else { INK }))
            })
        }))
}

/// Below the bill: what `--budget` came to, and the chip.
fn notes(answer: &Answer) -> Vec<Vec<String>> {
    let mut notes = Vec::new();
    if let Some(budget) = &answer.budget {
        notes.push(vec![format!("{}; {}", text::verdict(budget), tint::hex(budget.srgb))]);
    }
    if let Some(sensor) = &answer.sensor {
        for (title, cells) in text::channels(sensor, answer.absolute.is_some()) {
            notes.push([vec![format!("{}, {title}", sensor.name)], cells].concat());
        }
    }
    notes
}

fn heading(answer: &Answer) -> Group {
    let subtitle = format!("{}  ·  {}  ·  {}", printable(&answer.lamp), answer.eye, answer.grid);
    Group::new()
        .add(label(30.0, 42.0, &printable(&answer.title)).set("font-size", 24).set("font-weight", "bold"))
        .add(label(30.0, 66.0, &subtitle).set("fill", FAINT))
}

/// The lamp as a line, what leaves in the colours of the wavelengths.
fn spectra(area: Area, answer: &Answer) -> Group {
    let (Some(first), Some(last)) = (answer.lit.first(), answer.lit.last()) else { return Group::new() };
    let high =
        answer.lit.iter().chain(&answer.leaving).map(|(_, power)| *power).fold(f32::MIN_POSITIVE, f32::max);
    let x = Axis { from: first.0, to: last.0, step: 50.0 };
    let frame = Frame { area, x, y: Axis::holding(0.0, high) };
    let base = frame.place(first.0, 0.0).1;
    let outline = |spectrum: &[(f32, f32)]| {
        let mut points = spectrum.iter().map(|(nm, power)| frame.place(*nm, *power));
        let start = Data::new().move_to(points.next().unwrap_or_default());
        points.fold(start, Data::line_to)
    };
    let filled = outline(&answer.leaving)
        .line_to((frame.place(last.0, 0.0).0, base))
        .line_to((frame.place(first.0, 0.0).0, base))
        .close();
    let curve = |data: Data| Curve::new().set("d", data).set("fill", "none").set("stroke-linejoin", "round");
    let power = if answer.absolute.is_some() { "W/(m2 nm)" } else { "relative power" };
    Group::new()
        .add(Definitions::new().add(rainbow(&frame)))
        .add(frame.draw("wavelength / nm   (dashed: the lamp)", power))
        .add(Curve::new().set("d", filled).set("fill", "url(#rainbow)"))
        .add(curve(outline(&answer.leaving)).set("stroke", INK))
        .add(curve(outline(&answer.lit)).set("stroke", FAINT).set("stroke-dasharray", "5 3"))
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
    (from as usize..=to as usize).step_by(4).fold(gradient, |gradient, nm| {
        let nm = nm as f32;
        let color = tint::hex(tint::of_wavelength(nm));
        gradient.add(Stop::new().set("offset", (nm - from).max(0.0) / (to - from)).set("stop-color", color))
    })
}

/// The lamp's patch, that of what leaves, and the numbers.
fn looks(answer: &Answer) -> Group {
    let mut group = Group::new();
    let patches =
        [("the lamp", answer.lamp_srgb, 90.0, 60.0), ("what leaves", answer.look.srgb, 165.0, 120.0)];
    for (title, color, top, height) in patches {
        group = group.add(patch(700.0, top, 150.0, height, color)).add(label(866.0, top + 20.0, title));
        group = group.add(label(866.0, top + 42.0, &tint::hex(color)).set("fill", FAINT));
    }
    if answer.look.is_clipped {
        group = group.add(label(866.0, 229.0, text::clipped(&answer.look).trim()).set("fill", FAINT));
    }
    let levels = answer.absolute.as_ref().map_or(Vec::new(), text::levels);
    for (k, (title, value)) in text::coordinates(&answer.look).into_iter().chain(levels).enumerate() {
        let y = 316.0 + 22.0 * k as f32;
        group = group.add(label(700.0, y, title).set("fill", FAINT)).add(label(820.0, y, &value));
    }
    group
}

/// A line for each part, with what the scene looks like without it.
fn bill(answer: &Answer) -> Group {
    let heads = ["part", "effect", "multiply-adds", "bytes", "without it", "with, without"];
    let mut group = row(0, heads.map(String::from), FAINT);
    for (k, line) in answer.bill.iter().enumerate() {
        let Line { name, effect, price, without_delta_e, .. } = line;
        let fate = if line.left_out { ", left out" } else { "" };
        let cells = [
            text::short_name(name),
            (*effect).into(),
            price.multiply_adds.to_string(),
            price.bytes.to_string(),
            format!("{without_delta_e:.2} CIEDE2000{fate}"),
            String::new(),
        ];
        let top = BILL + SPACING * (k + 1) as f32;
        group = group
            .add(row(k + 1, cells, INK))
            .add(patch(COLUMNS[5], top - 15.0, 80.0, 20.0, answer.look.srgb))
            .add(patch(COLUMNS[5] + 80.0, top - 15.0, 80.0, 20.0, line.without_srgb));
    }
    let totals = [("walked, with lamp and eye", answer.walked), ("folded into the eye", answer.folded)];
    for (k, (what, price)) in totals.into_iter().enumerate() {
        let cells = [what.into(), String::new(), price.multiply_adds.to_string(), price.bytes.to_string()];
        let [a, b, c, d] = cells;
        group = group.add(row(answer.bill.len() + 1 + k, [a, b, c, d, String::new(), String::new()], FAINT));
    }
    group
}

fn row(k: usize, cells: [String; 6], color: &str) -> Group {
    let y = BILL + SPACING * k as f32;
    let mut group = Group::new();
    for (column, (cell, x)) in cells.iter().zip(COLUMNS).enumerate() {
        let anchor = if column == 2 || column == 3 { "end" } else { "start" };
        group = group.add(label(x, y, cell).set("fill", color).set("text-anchor", anchor));
    }
    group
}

fn patch(x: f32, y: f32, width: f32, height: f32, color: [u8; 3]) -> Rectangle {
    Rectangle::new()
        .set("x", x)
        .set("y", y)
        .set("width", width)
        .set("height", height)
        .set("fill", tint::hex(color))
        .set("stroke", GRID)
}

fn label(x: f32, y: f32, text: &str) -> Text {
    // SVG takes a run of blanks for one.
    let text = text.replace("  ", "\u{a0}\u{a0}");
    Text::new(text).set("x", x).set("y", y).set("fill", INK)
}
