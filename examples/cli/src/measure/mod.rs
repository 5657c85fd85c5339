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
use crate::output::{Files, Progress, json::line, terminal};
use reading::Bench;

/// Reports on the files, or on the bundled lamp if there are none.
pub fn run(args: &Args) -> Result<(), Failure> {
    args.check()?;
    if args.reflectance && args.files.is_empty() {
        let what = "the spectrum that comes with the program is a lamp; name FILES with reflectances";
        return Err(Failure::of("--reflectance", what));
    }
    let bench = Bench::new(args)?;
    let reference = reading::reference(&bench, args)?;
    let tables = if args.files.is_empty() {
        vec![input::bundled()?]
    } else {
        args.files.iter().map(|path| input::read(path)).collect::<Result<Vec<_>, _>>()?
    };

    // Measure all spectra before reporting any, so that an error leaves no half report behind.
    let count = tables.iter().map(|table| table.len()).sum();
    let mut progress = Progress::of(count);
    let mut readings = Vec::with_capacity(count);
    for source in tables.into_iter().flatten() {
        progress.step();
        readings.push(bench.measure_and_compare(&source, reference.as_ref())?);
    }
    drop(progress);

    let mut files = Files::new("directory", args.force, args.inputs());
    if let Some(directory) = &args.svg {
        picture::write_all(&mut files, directory, &bench, &readings)?;
    }
    let pictures = files.paths();
    let truecolor = terminal::is_colorful();
    let report = |(k, reading)| {
        if args.json {
            return line(json::object(&bench, reading), |_| None);
        }
        text::report(&bench, reading, pictures.get(k).copied(), truecolor)
    };
    terminal::print_all(readings.iter().enumerate().map(report))?;
    files.keep()
}
