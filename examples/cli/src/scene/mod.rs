//! The command `scene`, which follows light from a lamp through what it meets to an eye or a sensor chip.
//!
//! [`mod@file`] reads a scene from TOML, which is [`bundled`] or the user's. Its lamp and its parts
//! ([`matter`]) become a scene of the library on one of the [`grids`], and [`answer`] computes what it looks
//! like. [`text`], [`json`] and [`picture`] report the answer.

pub mod answer;
mod args;
pub mod bundled;
pub mod file;
pub mod grids;
mod json;
mod lamp;
mod matter;
mod picture;
mod text;

pub use args::Args;

use crate::failure::Failure;
use crate::output::{Files, json::line, terminal};

/// Runs the command: answers a scene, or lists those that come with the program.
pub fn run(args: &Args) -> Result<(), Failure> {
    args.check()?;
    if let Some(name) = &args.print {
        return terminal::print(bundled::toml(name)?);
    }
    let Some(word) = args.scene.as_deref().filter(|_| !args.list) else {
        return terminal::print(&bundled::list()?);
    };
    let recipe = bundled::find(word)?;
    let answer = grids::answer(&recipe, args.budget)?;
    let mut files = Files::new("place", args.force, recipe.inputs());
    if let Some(path) = &args.svg {
        picture::write(&mut files, path, &answer)?;
    }
    terminal::print(&if args.json {
        line(json::object(&answer), json::why)
    } else {
        text::report(&answer, files.paths().pop(), terminal::is_colorful())
    })?;
    files.keep()
}
