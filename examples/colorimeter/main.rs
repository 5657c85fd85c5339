//! From measured spectra to every number that matters about them.
//!
//! `cargo run --release --example colorimeter -- [FILES...]`; `--help` says the rest. A file
//! becomes a [`table`], its columns [`source`]s, each of them a [`measure`]d reading, and that a
//! report: [`text`], [`json`] or a [`picture`].

mod args;
mod exact;
mod facts;
mod failure;
mod input;
mod json;
mod lights;
mod measure;
mod picture;
mod plot;
mod progress;
mod source;
mod table;
mod text;
mod tint;
mod usage;
mod utf8;

use args::Args;
use failure::Failure;
use measure::{Bench, Reading};
use progress::Progress;
use std::io::{self, ErrorKind, IsTerminal, Write};
use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> ExitCode {
    match Args::read().and_then(|args| run(&args)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("{failure}");
            ExitCode::from(2)
        }
    }
}

fn run(args: &Args) -> Result<(), Failure> {
    if args.reflectance && args.files.is_empty() {
        return Err(Failure::of(
            "--reflectance",
            "the bundled spectrum is a lamp; give FILES with reflectances",
        ));
    }
    let bench = Bench::new(args)?;
    let reference = measure::reference(&bench, args)?;
    let mut sources = if args.files.is_empty() { input::bundled()? } else { Vec::new() };
    for path in &args.files {
        sources.extend(input::read(path)?);
    }

    // All are measured before any is reported: an error leaves no half report behind.
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
    match print(args, &bench, &readings, &pictures) {
        // Whoever reads the pipe has had enough: `| head`.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        Err(error) => {
            Err(Failure::of("stdout", format_args!("cannot be written ({}); free its disk", error.kind())))
        }
        Ok(()) => Ok(()),
    }
}

fn print(args: &Args, bench: &Bench, readings: &[Reading], pictures: &[PathBuf]) -> io::Result<()> {
    let truecolor = io::stdout().is_terminal() && color_is_welcome();
    let mut out = io::BufWriter::new(io::stdout().lock());
    for (k, reading) in readings.iter().enumerate() {
        if args.json {
            writeln!(out, "{}", json::object(bench, reading))?;
        } else {
            write!(
                out,
                "{}",
                text::report(bench, reading, pictures.get(k).map(PathBuf::as_path), truecolor)
            )?;
        }
    }
    out.flush()
}

/// By <https://no-color.org>, and by a terminal that calls itself dumb.
fn color_is_welcome() -> bool {
    std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
        && std::env::var_os("TERM").is_none_or(|value| value != "dumb")
}
