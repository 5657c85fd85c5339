//! Draws an SVG for each reading, with the spectrum, the chromaticity diagram, a swatch and the numbers.

mod chromaticity;

use crate::failure::{Failure, shown};
use crate::measure::facts;
use crate::measure::level::Kind;
use crate::measure::reading::{Bench, Reading};
use crate::measure::text::NAME;
use crate::output::Files;
use crate::picture::spectrum::{self, Spectrum};
use crate::picture::{self, Area, FAINT, GRID, label};
use std::collections::HashMap;
use std::path::Path;
use svg::Document;
use svg::node::element::Group;

/// The range of a spectrum that is drawn, in nm. The tables begin at 360.
const FIRST: usize = 380;
const LAST: usize = 780;
/// The length of the longest file name without `.svg`, in characters, which is below 255 bytes in any script.
const FILE_NAME: usize = 60;

/// Draws every reading to a file in `directory`, which is made if it is missing.
pub fn write_all(
    files: &mut Files,
    directory: &Path,
    bench: &Bench,
    readings: &[Reading],
) -> Result<(), Failure> {
    files.make_directory(directory)?;
    let mut taken = HashMap::new();
    for reading in readings {
        let path = directory.join(file_name(&reading.name, &mut taken));
        files.write(path, &page(bench, reading).to_string())?;
    }
    Ok(())
}

/// Returns a name that every file system accepts and that no earlier spectrum has, in any case of its
/// letters.
///
/// `taken` has these names in lower case, each with the first number that may be free behind it.
fn file_name(name: &str, taken: &mut HashMap<String, usize>) -> String {
    let safe = name.chars().map(|c| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '_' });
    let safe: String = safe.take(FILE_NAME).collect();
    let safe = safe.trim_matches('.');
    let safe = if safe.is_empty() { "spectrum" } else { safe };
    let mut free = safe.to_owned();
    if let Some(first) = taken.get(&safe.to_lowercase()) {
        let mut number = *first;
        while taken.contains_key(&format!("{safe}-{number}").to_lowercase()) {
            number += 1;
        }
        taken.insert(safe.to_lowercase(), number + 1);
        free = format!("{safe}-{number}");
    }
    taken.insert(free.to_lowercase(), 2);
    free + ".svg"
}

fn page(bench: &Bench, reading: &Reading) -> Document {
    let diagram = Area { left: 730.0, top: 90.0, width: 340.0, height: 382.5 };
    let kind = match reading.kind {
        Kind::Surface => format!("reflectance under {}", shown(&bench.room.light.name, NAME)),
        _ => "light".into(),
    };
    let subtitle = format!("{kind}  ·  {}", bench.eye.title);
    picture::page(740.0, &shown(&reading.name, NAME), &subtitle)
        .add(curve(reading))
        .add(chromaticity::draw(diagram, bench, reading))
        .add(numbers(reading))
        .add(swatch(reading))
}

fn curve(reading: &Reading) -> Group {
    let (values, title) = ordinates(reading);
    let shown: Vec<(f64, f64)> =
        (FIRST..=LAST).map(|nm| nm as f64).zip(values[FIRST - 360..=LAST - 360].iter().copied()).collect();
    let area = Area { left: 80.0, top: 90.0, width: 560.0, height: 330.0 };
    let spectrum = Spectrum { filled: &shown, ..Spectrum::default() };
    spectrum::draw(area, ["wavelength / nm", &title], &spectrum)
}

/// Returns the numbers to draw, and the title of their axis.
fn ordinates(reading: &Reading) -> (Vec<f64>, String) {
    let times = |k: f64| reading.curve().values().iter().map(|value| f64::from(*value) * k).collect();
    match (reading.kind, reading.kind.level()) {
        (Kind::Surface, _) => (times(1.0), "reflectance".into()),
        (_, Some(level)) => (times(reading.scale()), level.spectral.replace('/', " / ")),
        (_, None) => {
            let peak = reading.curve().values().iter().copied().fold(0.0, f32::max);
            (times(1.0 / f64::from(peak)), "relative spectral power".into())
        }
    }
}

/// Draws the facts in two columns under the spectrum.
fn numbers(reading: &Reading) -> Group {
    let facts = facts::facts(reading);
    let rows = facts.len().div_ceil(2).max(8);
    let mut group = Group::new();
    for (k, fact) in facts.iter().enumerate() {
        let (column, row) = ((k / rows) as f32, (k % rows) as f32);
        let (x, y) = (30.0 + 395.0 * column, 510.0 + 25.0 * row);
        group = group.add(label(x, y, &fact.label).set("fill", FAINT)).add(label(x + 145.0, y, &fact.value));
    }
    group
}

/// Draws the color, as well as a display can show it.
fn swatch(reading: &Reading) -> Group {
    let Some(hex) = reading.hex.as_deref() else { return Group::new() };
    let area = Area { left: 850.0, top: 545.0, width: 220.0, height: 130.0 };
    let square = area.rectangle().set("rx", 8).set("fill", hex).set("stroke", GRID);
    Group::new().add(square).add(label(960.0, 700.0, hex).set("text-anchor", "middle"))
}
