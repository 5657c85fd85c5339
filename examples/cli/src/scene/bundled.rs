//! The scenes that come with the program.

use crate::failure::{Failure, short};
use crate::scene::file::{self, Recipe};
use std::path::Path;

/// The names and the texts of the scenes.
const SCENES: [(&str, &str); 6] = [
    ("paper", include_str!("../../data/scenes/paper.toml")),
    ("vest", include_str!("../../data/scenes/vest.toml")),
    ("asphalt", include_str!("../../data/scenes/asphalt.toml")),
    ("soap", include_str!("../../data/scenes/soap.toml")),
    ("wine", include_str!("../../data/scenes/wine.toml")),
    ("window", include_str!("../../data/scenes/window.toml")),
];

/// The text of the scene with this name.
pub fn toml(name: &str) -> Result<&'static str, Failure> {
    let scene = SCENES.iter().find(|(known, _)| *known == name);
    scene.map(|(_, text)| *text).ok_or_else(|| unknown(name))
}

/// Reads a scene that comes with the program, or a file if the word ends in .toml.
pub fn find(word: &str) -> Result<Recipe, Failure> {
    let path = Path::new(word);
    if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml")) {
        return file::read(path);
    }
    let text = toml(word)?;
    file::parse(&format!("{word}.toml"), word, Path::new("."), text)
}

/// The names and titles of all scenes, each on one line.
pub fn list() -> Result<String, Failure> {
    let mut list = String::new();
    for (name, text) in SCENES {
        let recipe = file::parse(&format!("{name}.toml"), name, Path::new("."), text)?;
        list += &format!("  {name:<10}{}\n", recipe.scene.title);
    }
    Ok(list
        + "\nTo follow light through one of them: nanospectra scene NAME\n\
                To start a scene of your own: nanospectra scene --print NAME > mine.toml\n")
}

fn unknown(name: &str) -> Failure {
    let names = SCENES.map(|(name, _)| name).join(", ");
    Failure::of(
        short(name),
        format_args!("there is no scene of this name; use {names}, or a file that ends in .toml"),
    )
}
