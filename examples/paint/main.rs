//! RGB to spectrum, looked at again.
//!
//! `cargo run --release --example paint -- 0.8,0.2,0.1`; `--help` says the rest. A word or a line becomes a
//! colour ([`input`]), that an [`answer`] on one of the [`grids`], and that a report: [`text`], [`json`] or a
//! [`picture`].

mod answer;
mod args;
#[path = "../colorimeter/failure.rs"]
mod failure;
mod grids;
mod input;
mod json;
mod picture;
#[path = "../colorimeter/plot.rs"]
mod plot;
#[path = "../colorimeter/progress.rs"]
mod progress;
mod text;
#[expect(dead_code, reason = "there are no chromaticities to color here")]
#[path = "../colorimeter/tint.rs"]
mod tint;
#[path = "../colorimeter/usage.rs"]
mod usage;
#[path = "../colorimeter/utf8.rs"]
mod utf8;

use answer::{Answer, Job};
use args::Args;
use failure::Failure;
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

/// All colours are answered before any is printed: an error leaves no half report behind.
fn run(args: &Args) -> Result<(), Failure> {
    let colors = if args.colors.is_empty() { answer::samples() } else { input::colors(&args.colors)? };
    let answers = grids::answers(&args.grid, &Job::new(args, &colors)?)?;
    let pictures =
        args.svg.as_ref().map(|directory| picture::save_all(directory, args, &answers)).transpose()?;
    match print(args, &answers, pictures.as_ref().map_or(&[], |pictures| &pictures.paths)) {
        // Whoever reads the pipe may have had enough: `| head`.
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::of("stdout", format_args!("cannot be written ({}); free its disk", error.kind())))
        }
        _ => {
            if let Some(pictures) = pictures {
                pictures.keep();
            }
            Ok(())
        }
    }
}

fn print(args: &Args, answers: &[Answer], pictures: &[PathBuf]) -> io::Result<()> {
    let truecolor = io::stdout().is_terminal() && color_is_welcome();
    let mut out = io::BufWriter::new(io::stdout().lock());
    if args.json {
        for answer in answers {
            writeln!(out, "{}", json::object(args, answer))?;
        }
    } else if args.colors.is_empty() {
        write!(out, "{}", text::chart(args, answers, args.svg.as_deref(), truecolor))?;
    } else {
        for (k, answer) in answers.iter().enumerate() {
            let picture = pictures.get(k).map(PathBuf::as_path);
            write!(out, "{}", text::report(args, answer, picture, truecolor))?;
        }
    }
    out.flush()
}

/// By <https://no-color.org>, and by a terminal that calls itself dumb.
fn color_is_welcome() -> bool {
    std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
        && std::env::var_os("TERM").is_none_or(|value| value != "dumb")
}
