//! How the bundled scenes of `nanospectra scene` change without one of their parts.

use crate::cells::{COUNTED, RANGE, counted, range};
use crate::report::{Cell, Column, Table};
use nanospectra_cli::failure::Failure;
use nanospectra_cli::scene::answer::Answer;
use nanospectra_cli::scene::bundled;
use nanospectra_cli::scene::file::{self, Recipe};
use nanospectra_cli::scene::grids;
use std::path::Path;

pub const SCENES: [&str; 6] = ["paper", "vest", "asphalt", "soap", "wine", "window"];

pub const LAMPS: [&str; 8] = ["A", "D65", "FL2", "FL7", "FL11", "LED-B1", "LED-B3", "LED-RGB1"];

/// For each effect the count on record that comes nearest to it, which is that of a whole path of 31 bands.
const PATHS: [(&str, &str); 5] = [
    ("fluorescence", "path-dye"),
    ("polarization", "path-two-mirrors"),
    ("absorption", "path-glass-surface"),
    ("Beer-Lambert", "path-glass-surface"),
    ("reflection", "path-surface"),
];

pub fn table() -> Table {
    let mut columns =
        vec![Column::key("scene", "scene"), Column::key("part", "without"), Column::key("effect", "effect")];
    columns.extend(RANGE);
    columns.push(Column::figure("multiply_adds", "multiply-adds"));
    columns.extend(COUNTED);
    Table {
        id: "effects",
        title: "Bundled scenes without one of their parts".into(),
        about: format!(
            "CIEDE2000 between a scene and the same scene without the effect of a part, over {}: without a \
             filter or a film, with a dye that does not glow, with a mirror that does not polarize. The \
             white is that of the bare lamp. Colors and multiply-adds are those of 81 bands, as the bill of \
             the scene lists them. Instructions are those of a whole path of 31 bands with such a part that \
             is not folded.",
            LAMPS.join(", ")
        ),
        columns,
        rows: SCENES.into_iter().flat_map(of).collect(),
    }
}

fn of(scene: &str) -> Vec<Vec<Cell>> {
    let answers: Vec<Answer> =
        LAMPS.iter().filter_map(|lamp| grids::answer(&under(scene, lamp).ok()?, None).ok()).collect();
    let Some(first) = answers.first().filter(|_| answers.len() == LAMPS.len()) else { return Vec::new() };
    let parts = first.bill.iter().enumerate().map(|(k, line)| {
        let lines = answers.iter().filter_map(|answer| answer.bill.get(k));
        let differences: Vec<f64> = lines.filter_map(|line| line.without_delta_e).map(f64::from).collect();
        let word = PATHS.iter().find(|(effect, _)| *effect == line.effect).map_or("", |(_, word)| word);
        let mut row = vec![Cell::key(scene), Cell::key(&line.name), Cell::key(line.effect)];
        row.extend(range(&differences));
        row.push(Cell::figure(line.price.multiply_adds as f64));
        row.extend(counted(word));
        row
    });
    parts.collect()
}

/// Reads a bundled scene with another lamp in it.
pub fn under(scene: &str, lamp: &str) -> Result<Recipe, Failure> {
    let text: Vec<String> = bundled::toml(scene)?
        .lines()
        .map(|line| if line.starts_with("cie = ") { format!("cie = \"{lamp}\"") } else { line.to_owned() })
        .collect();
    file::parse(scene, scene, Path::new("."), &text.join("\n"))
}
