//! Reads a scene from TOML, and says where in it something is wrong.

use crate::failure::{Failure, printable};
use crate::input::text;
use serde::de::Error;
use serde::{Deserialize, Deserializer};
use std::ops::Range;
use std::path::{Path, PathBuf};
use toml::Spanned;

/// A scene as it was written, with what is needed to say where something is wrong.
pub struct Recipe {
    pub name: String,
    pub scene: Scene,
    file: String,
    folder: PathBuf,
    text: String,
}

/// The TOML document.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    pub title: String,
    pub grid: Option<Spanned<String>>,
    pub lamp: Spanned<Lamp>,
    pub eye: Option<Spanned<String>>,
    pub sensor: Option<Spanned<String>>,
    #[serde(deserialize_with = "parts")]
    pub part: Vec<Spanned<Part>>,
}

/// A lamp. It has one of the first four fields, and perhaps an illuminance.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Lamp {
    pub cie: Option<String>,
    pub blackbody_k: Option<f32>,
    pub csv: Option<PathBuf>,
    pub points: Option<Points>,
    pub illuminance_lx: Option<f32>,
}

/// A table `[[nm, value], ..]`.
pub type Points = Vec<Sample>;

/// A row `[nm, value]` of a table, which has exactly two numbers.
#[derive(Clone, Copy, Deserialize)]
#[serde(try_from = "Vec<f32>")]
pub struct Sample {
    pub nm: f32,
    pub value: f32,
}

impl TryFrom<Vec<f32>> for Sample {
    type Error = String;

    fn try_from(row: Vec<f32>) -> Result<Self, String> {
        match row[..] {
            [nm, value] => Ok(Sample { nm, value }),
            _ => Err(format!("a row of points has 2 numbers, [nm, value], but this one has {}", row.len())),
        }
    }
}

/// The points as pairs, which is how the library takes them.
pub fn pairs(points: &Points) -> Vec<(f32, f32)> {
    points.iter().map(|sample| (sample.nm, sample.value)).collect()
}

/// A part. It has a name, if it is given one, and exactly one of the other fields.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Part {
    pub name: Option<String>,
    pub filter: Option<Factors>,
    pub surface: Option<Factors>,
    pub dye: Option<Dye>,
    pub film: Option<Film>,
    pub mirror: Option<Mirror>,
    pub polarizer: Option<Polarizer>,
    pub retarder: Option<Retarder>,
}

/// A transmittance or a reflectance, which is given by one of these fields. `path_cm` belongs to the
/// absorbance.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Factors {
    pub flat: Option<f32>,
    pub points: Option<Points>,
    pub csv: Option<PathBuf>,
    pub ces: Option<usize>,
    pub absorbance_per_cm: Option<Points>,
    pub path_cm: Option<f32>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Dye {
    pub reflectance: Points,
    pub absorption: Points,
    pub emission: Points,
    pub quantum_yield: f32,
    #[serde(default)]
    pub transmitted: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Film {
    pub n: f32,
    #[serde(default = "one")]
    pub n_before: f32,
    #[serde(default = "one")]
    pub n_behind: f32,
    pub thickness_nm: f32,
    #[serde(default)]
    pub angle_deg: f32,
    #[serde(default)]
    pub transmitted: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mirror {
    pub n: f32,
    #[serde(default)]
    pub k: f32,
    pub angle_deg: f32,
    #[serde(default)]
    pub axis_deg: f32,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Polarizer {
    pub axis_deg: f32,
    #[serde(default = "one")]
    pub along: f32,
    #[serde(default)]
    pub across: f32,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Retarder {
    pub path_difference_nm: f32,
    pub axis_deg: f32,
}

fn one() -> f32 {
    1.0
}

/// Reads the parts, of which there must be at least one.
fn parts<'de, D: Deserializer<'de>>(toml: D) -> Result<Vec<Spanned<Part>>, D::Error> {
    let parts = Vec::deserialize(toml)?;
    if parts.is_empty() { Err(D::Error::custom("this is a scene without a part")) } else { Ok(parts) }
}

/// Reads the scene in a file.
pub fn read(path: &Path) -> Result<Recipe, Failure> {
    let (file, text) = text::read(path)?;
    let name = text::stem(path).unwrap_or_else(|| file.clone());
    let folder = path.parent().unwrap_or(Path::new("."));
    parse(&file, &name, folder, &text)
}

/// Reads the scene in a text. `file` is its name for messages.
pub fn parse(file: &str, name: &str, folder: &Path, text: &str) -> Result<Recipe, Failure> {
    let scene = toml::from_str(text).map_err(|error| {
        let line = line(text, error.span());
        let what = printable(error.message()).replace("\\n", ", ");
        Failure::at(file, line, format_args!("{what}; compare with nanospectra scene --print paper"))
    })?;
    Ok(Recipe { name: name.into(), scene, file: file.into(), folder: folder.into(), text: text.into() })
}

/// The line in which a span begins, counted from 1.
fn line(text: &str, span: Option<Range<usize>>) -> usize {
    let before = span.and_then(|span| text.get(..span.start)).unwrap_or_default();
    before.matches('\n').count() + 1
}

impl Recipe {
    /// A failure at something that is written in the scene.
    pub fn wrong<T>(&self, at: &Spanned<T>, what: impl std::fmt::Display) -> Failure {
        Failure::at(&self.file, line(&self.text, Some(at.span())), what)
    }

    /// The files that are read: the scene, if it is one, and those that it names.
    pub fn inputs(&self) -> Vec<PathBuf> {
        let parts = self.scene.part.iter().map(Spanned::get_ref);
        let factors = parts.flat_map(|part| [&part.filter, &part.surface]).flatten();
        let named = factors.filter_map(|factors| factors.csv.as_ref()).chain(&self.scene.lamp.get_ref().csv);
        named.map(|path| self.beside(path)).chain([PathBuf::from(&self.file)]).collect()
    }

    /// The path of a file that the scene names.
    pub fn beside(&self, path: &Path) -> PathBuf {
        self.folder.join(path)
    }
}
