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
use crate::output::{Files, Progress, json::line, terminal};
use answer::Job;
use std::path::Path;

/// Runs the command. All colors are answered before any is printed, so that an error leaves no half report.
///
/// They are answered again when it is their turn to be drawn or printed, since an answer takes a hundred
/// times the memory of its color.
pub fn run(args: &Args) -> Result<(), Failure> {
    args.check()?;
    let colors = if args.colors.is_empty() { answer::samples() } else { input::colors(&args.colors)? };
    let job = Job::new(args)?;
    let answer = grids::painter(&args.grid, &job)?;
    let mut progress = Progress::of(colors.len());
    for color in &colors {
        progress.step();
        answer(color)?;
    }
    drop(progress);

    let answers = || colors.iter().map(&answer);
    let mut files = Files::new("directory", args.force, None::<&Path>);
    if let Some(directory) = &args.svg {
        picture::write_all(&mut files, directory, args, answers())?;
    }
    let truecolor = terminal::is_colorful();
    let pictures = files.paths();
    terminal::stream(|out| {
        if args.csv {
            return out.write(&table::csv(args, answers())?);
        }
        if !args.json && args.colors.is_empty() {
            return out.write(&text::chart(args, &answers().collect::<Result<Vec<_>, _>>()?, truecolor));
        }
        for (k, answer) in answers().enumerate() {
            out.write(&if args.json {
                line(json::object(args, &answer?), json::why)
            } else {
                text::report(args, &answer?, pictures.get(k).copied(), truecolor)
            })?;
        }
        Ok(())
    })?;
    files.keep()
}
