//! The command `paint`, which finds spectra for RGB colors.
//!
//! [`input`] reads a word or a line as a color. [`answer`] finds its spectrum, on one of the [`grids`], and
//! how it looks under lights. [`text`], [`json`], [`table`] and [`picture`] report the answer.

mod answer;
mod args;
mod grids;
mod input;
mod json;
mod picture;
mod table;
mod text;

pub use args::{Args, negative};

use crate::failure::Failure;
use crate::output::{Files, json::line, terminal};
use answer::Job;
use std::path::Path;

/// Runs the command. All colors are answered before any is printed, so that an error leaves no half report.
pub fn run(args: &Args) -> Result<(), Failure> {
    args.check()?;
    let colors = if args.colors.is_empty() { answer::samples() } else { input::colors(&args.colors)? };
    let answers = grids::answers(&args.grid, &Job::new(args, &colors)?)?;
    let mut files = Files::new("directory", args.force, None::<&Path>);
    if let Some(directory) = &args.svg {
        picture::write_all(&mut files, directory, args, &answers)?;
    }
    let truecolor = terminal::is_colorful();
    let report = if args.csv {
        table::csv(args, &answers)
    } else if args.json {
        answers.iter().map(|answer| line(json::object(args, answer), json::why)).collect()
    } else if args.colors.is_empty() {
        text::chart(args, &answers, truecolor)
    } else {
        let pictures = files.paths();
        answers
            .iter()
            .enumerate()
            .map(|(k, answer)| text::report(args, answer, pictures.get(k).copied(), truecolor))
            .collect()
    };
    terminal::print(&report)?;
    files.keep()
}
