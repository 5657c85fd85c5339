//! The command `measure`, which computes color, rendering and photometric quantities of measured spectra.
//!
//! A file is parsed to a [`table`](crate::input::table), whose columns are [`source`]s. Each of them gives a
//! [`reading`], which is reported as [`text`], as [`json`] or as a [`picture`].

mod args;
mod exact;
mod facts;
mod input;
mod json;
mod lights;
mod picture;
mod reading;
mod source;
mod text;

pub use args::Args;

use crate::failure::Failure;
use crate::output::{Progress, terminal};
use reading::Bench;
use std::path::PathBuf;

/// Reports on the files, or on the bundled lamp if there are none.
pub fn run(args: &Args) -> Result<(), Failure> {
    args.check()?;
    if args.reflectance && args.files.is_empty() {
        let what = "the spectrum that comes with the program is a lamp; name FILES with reflectances";
        return Err(Failure::of("--reflectance", what));
    }
    let bench = Bench::new(args)?;
    let reference = reading::reference(&bench, args)?;
    let mut sources = if args.files.is_empty() { input::bundled()? } else { Vec::new() };
    for path in &args.files {
        sources.extend(input::read(path)?);
    }

    // Measure all spectra before reporting any, so that an error leaves no half report behind.
    let mut progress = Progress::of(sources.len());
    let mut readings = Vec::with_capacity(sources.len());
    for source in &sources {
        progress.step();
        readings.push(bench.measure_and_compare(source, reference.as_ref())?);
    }
    drop(progress);

    let pictures = match &args.svg {
        Some(directory) => picture::save_all(directory, &bench, &readings)?,
        None => Vec::new(),
    };
    let truecolor = terminal::is_colorful();
    let report = |(k, reading)| {
        if args.json {
            return format!("{}\n", json::object(&bench, reading));
        }
        text::report(&bench, reading, pictures.get(k).map(PathBuf::as_path), truecolor)
    };
    terminal::print(&readings.iter().enumerate().map(report).collect::<String>())
}
