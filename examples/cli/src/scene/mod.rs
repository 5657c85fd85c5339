//! A lamp, what its light meets, and what an eye or a chip makes of it.
//!
//! A text ([`mod@file`]: TOML, [`bundled`] or the user's) becomes [`matter`] on one of the [`grids`], that a
//! scene and an [`answer`], and that a report: [`text`], [`json`] or a [`picture`].

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
use crate::output::terminal;

/// Answers a scene, or names those there are.
pub fn run(args: &Args) -> Result<(), Failure> {
    args.check()?;
    if let Some(name) = &args.print {
        return terminal::print(bundled::toml(name)?);
    }
    let Some(word) = args.scene.as_deref().filter(|_| !args.list) else {
        return terminal::print(&bundled::list()?);
    };
    let answer = grids::answer(&bundled::find(word)?, args.budget)?;
    let picture = args.svg.as_ref().map(|path| picture::save(path, &answer)).transpose()?;
    terminal::print(&if args.json {
        format!("{}\n", json::object(&answer))
    } else {
        text::report(&answer, picture.as_deref(), terminal::is_colorful())
    })
}
