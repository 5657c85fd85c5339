//! The command `measure`, which computes color, rendering and photometric quantities of measured spectra.
//!
//! The crate `nanospectra_files` reads the curves of a file, which are [`source`]s here. Each of them gives a
//! [`reading`], which is reported as [`text`], as [`json`], as a row of a [`table`] or as a [`picture`].

mod args;
mod exact;
mod facts;
mod input;
mod json;
mod level;
mod lights;
mod picture;
mod reading;
mod source;
mod table;
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
    let mut failures = Failures { first_ends: args.fail_fast, all: Vec::new() };
    let mut tables = Vec::with_capacity(args.files.len().max(1));
    if args.files.is_empty() {
        tables.push(input::bundled(args)?);
    }
    for path in &args.files {
        tables.extend(failures.keep(input::read(path, args))?);
    }

    // Measure all spectra before reporting any, so that an error of the output leaves no half report behind.
    let count = tables.iter().map(|table| table.len()).sum();
    let mut progress = Progress::of(count);
    let mut readings = Vec::with_capacity(count);
    for source in tables.into_iter().flatten() {
        progress.step();
        readings.extend(failures.keep(bench.measure_and_compare(&source, reference.as_ref()))?);
    }
    drop(progress);

    let mut files = Files::new("directory", args.force, args.inputs());
    if let Some(directory) = &args.svg {
        picture::write_all(&mut files, directory, &bench, &readings)?;
    }
    let pictures = files.paths();
    let truecolor = terminal::is_colorful();
    if args.csv {
        terminal::print(&table::csv(&bench, &readings)?)?;
        files.keep()?;
        return failures.end();
    }
    let report = |(k, reading)| {
        if args.json {
            return line(json::object(&bench, reading), |_| None);
        }
        text::report(&bench, reading, pictures.get(k).copied(), truecolor)
    };
    terminal::print_all(readings.iter().enumerate().map(report))?;
    files.keep()?;
    failures.end()
}

/// The failures of a run, which goes on with what can be measured.
struct Failures {
    /// Whether the first one ends the run.
    first_ends: bool,
    all: Vec<Failure>,
}

impl Failures {
    /// Returns what succeeded, and keeps the failure otherwise.
    fn keep<T>(&mut self, outcome: Result<T, Failure>) -> Result<Option<T>, Failure> {
        match outcome {
            Ok(done) => Ok(Some(done)),
            Err(failure) if self.first_ends => Err(failure),
            Err(failure) => {
                self.all.push(failure);
                Ok(None)
            }
        }
    }

    /// Returns all failures as one.
    fn end(self) -> Result<(), Failure> {
        Failure::all(self.all).map_or(Ok(()), Err)
    }
}
