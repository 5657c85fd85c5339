//! One SVG for each reading: the spectrum in its colours, its place in the chromaticity diagram, a
//! swatch and the numbers.

mod axis;
mod chromaticity;
mod spectrum;

use crate::facts;
use crate::failure::{Failure, printable};
use crate::measure::{Bench, Reading};
use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};
use svg::Document;
use svg::node::element::{Group, Rectangle, Text};

const WIDTH: f32 = 1120.0;
const HEIGHT: f32 = 740.0;
const INK: &str = "#222222";
const FAINT: &str = "#777777";
const GRID: &str = "#dddddd";
/// Longest title, in characters.
const TITLE: usize = 70;
/// Longest file name without `.svg`, in characters: below 255 bytes in any script.
const FILE_NAME: usize = 60;

/// Where a diagram stands on the page.
#[derive(Clone, Copy)]
struct Area {
    left: f32,
    top: f32,
    width: f32,
    height: f32,
}

/// Draws every reading into a file of `directory`, which is made if missing; the files in order.
pub fn save_all(directory: &Path, bench: &Bench, readings: &[Reading]) -> Result<Vec<PathBuf>, Failure> {
    let refused = |path: &Path, error: std::io::Error| {
        let what = format!("cannot be written ({}); name a directory you may write to", error.kind());
        Failure::of(format_args!("--svg {}", path.display()), what)
    };
    fs::create_dir_all(directory).map_err(|error| refused(directory, error))?;
    let mut taken = HashSet::new();
    let mut paths = Vec::new();
    for reading in readings {
        let path = directory.join(file_name(&reading.name, &mut taken));
        svg::save(&path, &page(bench, reading)).map_err(|error| refused(&path, error))?;
        paths.push(path);
    }
    Ok(paths)
}

/// A name that every file system takes, and that no earlier spectrum has (whatever its case).
fn file_name(name: &str, taken: &mut HashSet<String>) -> String {
    let safe = name.chars().map(|c| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '_' });
    let safe: String = safe.take(FILE_NAME).collect();
    let safe = safe.trim_matches('.');
    let safe = if safe.is_empty() { "spectrum" } else { safe };
    let numbered = (2..).map(|k| format!("{safe}-{k}"));
    std::iter::once(safe.to_owned())
        .chain(numbered)
        .find(|name| taken.insert(name.to_lowercase()))
        .map_or_else(String::new, |name| name + ".svg")
}

fn page(bench: &Bench, reading: &Reading) -> Document {
    let spectrum = Area { left: 80.0, top: 90.0, width: 560.0, height: 330.0 };
    let diagram = Area { left: 730.0, top: 90.0, width: 340.0, height: 382.5 };
    Document::new()
        .set("viewBox", (0, 0, WIDTH, HEIGHT))
        .set("width", WIDTH)
        .set("height", HEIGHT)
        .set("font-family", "DejaVu Sans, Verdana, Helvetica, Arial, sans-serif")
        .set("font-size", 13)
        .add(Rectangle::new().set("width", WIDTH).set("height", HEIGHT).set("fill", "#ffffff"))
        .add(heading(bench, reading))
        .add(spectrum::draw(spectrum, bench, reading))
        .add(chromaticity::draw(diagram, bench, reading))
        .add(numbers(bench, reading))
        .add(swatch(reading))
}

fn heading(bench: &Bench, reading: &Reading) -> Group {
    let name = printable(&reading.name);
    let title = if name.chars().count() > TITLE {
        name.chars().take(TITLE - 1).chain(['…']).collect()
    } else {
        name
    };
    let under = bench.room.as_ref().map(|room| format!("reflectance under {}", printable(&room.light.name)));
    let subtitle = format!("{}  ·  {}", under.unwrap_or("light".into()), bench.eye.title());
    Group::new()
        .add(label(30.0, 42.0, &title).set("font-size", 24).set("font-weight", "bold"))
        .add(label(30.0, 66.0, &subtitle).set("fill", FAINT))
}

/// The facts in two columns under the spectrum.
fn numbers(bench: &Bench, reading: &Reading) -> Group {
    let facts = facts::facts(bench, reading);
    let rows = facts.len().div_ceil(2).max(8);
    let mut group = Group::new();
    for (k, fact) in facts.iter().enumerate() {
        let (column, row) = ((k / rows) as f32, (k % rows) as f32);
        let (x, y) = (30.0 + 395.0 * column, 510.0 + 25.0 * row);
        group = group.add(label(x, y, &fact.label).set("fill", FAINT)).add(label(x + 145.0, y, &fact.value));
    }
    group
}

/// The colour, as well as a display can show it.
fn swatch(reading: &Reading) -> Group {
    let Some(hex) = reading.hex.as_deref() else { return Group::new() };
    let square = Rectangle::new()
        .set("x", 850)
        .set("y", 545)
        .set("width", 220)
        .set("height", 130)
        .set("rx", 8)
        .set("fill", hex)
        .set("stroke", GRID);
    Group::new().add(square).add(label(960.0, 700.0, hex).set("text-anchor", "middle"))
}

fn label(x: f32, y: f32, text: &str) -> Text {
    // SVG takes a run of blanks for one.
    let text = text.replace("  ", "\u{a0}\u{a0}");
    Text::new(text).set("x", x).set("y", y).set("fill", INK)
}
