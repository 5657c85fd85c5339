//! The grids that this program is compiled for. A grid is part of a spectrum's type: how many bands there
//! are, and at which wavelengths.

use crate::failure::{Failure, short};
use crate::scene::answer::{Answer, answer_on};
use crate::scene::file::Recipe;
use nanospectra::{Bins, Nodes};

/// The names of the grids, as `grid` takes them in a scene.
const NAMES: &str =
    "bins:16,380,730 | bins:31,380,730 | bins:60,380,730 | nodes:36,380,730 | nodes:81,380,780";

/// Answers a scene on the grid that it names, or else on 81 bands of 5 nm.
pub fn answer(recipe: &Recipe, budget: Option<f32>) -> Result<Answer, Failure> {
    let grid = recipe.scene.grid.as_ref();
    let name = grid.map_or("nodes:81,380,780", |grid| grid.get_ref().as_str());
    match name {
        "bins:16,380,730" => answer_on::<16, Bins<380, 730>>(recipe, name, budget),
        "bins:31,380,730" => answer_on::<31, Bins<380, 730>>(recipe, name, budget),
        "bins:60,380,730" => answer_on::<60, Bins<380, 730>>(recipe, name, budget),
        "nodes:36,380,730" => answer_on::<36, Nodes<380, 730>>(recipe, name, budget),
        "nodes:81,380,780" => answer_on::<81, Nodes<380, 780>>(recipe, name, budget),
        _ => {
            let what = format!("the grid '{}' is not compiled in; use one of {NAMES}", short(name));
            Err(grid.map_or_else(|| Failure::of("grid", &what), |grid| recipe.wrong(grid, &what)))
        }
    }
}
