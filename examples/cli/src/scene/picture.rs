//! Draws a scene: the light of the lamp and the light behind the last part, its color, and the bill.

use crate::failure::{Failure, shown};
use crate::output::{Files, tint};
use crate::picture::spectrum::{self, Spectrum};
use crate::picture::{self, Area, FAINT, INK, label, patch};
use crate::scene::answer::{Answer, Line};
use crate::scene::text;
use std::path::Path;
use svg::Document;
use svg::node::element::Group;

/// Where the bill begins, from the top.
const BILL: f32 = 520.0;
/// From one line to the next.
const SPACING: f32 = 26.0;
/// Where the columns of the bill begin: part, effect, multiply-adds, bytes, difference without it, patch.
const COLUMNS: [f32; 6] = [30.0, 250.0, 470.0, 560.0, 600.0, 780.0];

/// Draws into a file. It is `path` if that ends in .svg, and else a file in that directory, which is made if
/// it is missing.
pub fn write(files: &mut Files, path: &Path, answer: &Answer) -> Result<(), Failure> {
    let path = if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("svg")) {
        path.to_owned()
    } else {
        files.make_directory(path)?;
        path.join(format!("{}.svg", answer.name))
    };
    files.write(path, &page(answer).to_string())
}

fn page(answer: &Answer) -> Document {
    let notes = notes(answer);
    let end = BILL + SPACING * (answer.bill.len() + 3) as f32;
    let height = end + SPACING * (notes.len() + 1) as f32;
    let subtitle = format!("{}  ·  {}  ·  {}", shown(&answer.lamp, text::NAME), answer.eye, answer.grid);
    picture::page(height, &shown(&answer.title, text::NAME), &subtitle)
        .add(spectra(answer))
        .add(looks(answer))
        .add(bill(answer))
        .add(notes.into_iter().enumerate().fold(Group::new(), |group, (k, cells)| {
            let y = end + SPACING * (k + 1) as f32;
            // A title, and up to eight columns behind it.
            cells.iter().enumerate().fold(group, |group, (column, cell)| {
                let x = if column == 0 { COLUMNS[0] } else { 150.0 + 100.0 * column as f32 };
                group.add(label(x, y, cell).set("fill", if column == 0 { FAINT } else { INK }))
            })
        }))
}

/// The rows below the bill: the result of `--budget`, and the channels of the sensor.
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
    notes.extend(answer.notes.iter().map(|note| vec![note.clone()]));
    notes
}

/// The light behind the last part, filled with the colors of the wavelengths, and that of the lamp as a line.
fn spectra(answer: &Answer) -> Group {
    let [lit, leaving] = [&answer.lit, &answer.leaving].map(|light| spectrum::points(light));
    let power = if answer.absolute.is_some() { "W/(m2 nm)" } else { "relative power" };
    let area = Area { left: 90.0, top: 90.0, width: 560.0, height: 330.0 };
    let spectrum = Spectrum { filled: &leaving, dashed: &lit, high: 0.0 };
    spectrum::draw(area, ["wavelength / nm   (dashed: the lamp)", power], &spectrum)
}

/// A patch with the color of the lamp, one with that of the light behind the last part, and the numbers.
fn looks(answer: &Answer) -> Group {
    let mut group = Group::new();
    let patches =
        [("the lamp", answer.lamp_srgb, 90.0, 60.0), ("what leaves", answer.look.srgb, 165.0, 120.0)];
    for (title, color, top, height) in patches {
        group = group.add(patch(Area { left: 700.0, top, width: 150.0, height }, color)).add(label(
            866.0,
            top + 20.0,
            title,
        ));
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

/// The bill: a line for each part, with the color that the scene has without it.
fn bill(answer: &Answer) -> Group {
    let heads = ["part", "effect", "multiply-adds", "bytes", "without it", "with, without"];
    let mut group = row(0, heads.map(String::from), FAINT);
    for (k, line) in answer.bill.iter().enumerate() {
        let Line { name, effect, price, .. } = line;
        let fate = if line.left_out { ", left out" } else { "" };
        let cells = [
            text::short_name(name),
            (*effect).into(),
            price.multiply_adds.to_string(),
            price.bytes.to_string(),
            text::difference(line) + fate,
            String::new(),
        ];
        let top = BILL + SPACING * (k + 1) as f32 - 15.0;
        let half = Area { left: COLUMNS[5], top, width: 80.0, height: 20.0 };
        group = group
            .add(row(k + 1, cells, INK))
            .add(patch(half, answer.look.srgb))
            .add(patch(Area { left: COLUMNS[5] + 80.0, ..half }, line.without_srgb));
    }
    for (k, (what, price)) in text::totals(answer).into_iter().enumerate() {
        let (work, bytes) = (price.multiply_adds.to_string(), price.bytes.to_string());
        let cells = [what.into(), String::new(), work, bytes, String::new(), String::new()];
        group = group.add(row(answer.bill.len() + 1 + k, cells, FAINT));
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
