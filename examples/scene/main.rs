//! A lamp, what its light meets, and what an eye or a chip makes of it.
//!
//! `cargo run --release --example scene -- vest`; `--help` says the rest. A text ([`file`]: TOML, [`bundled`] or the
//! user's) becomes [`matter`] on one of the [`grids`], that a scene and an [`answer`], and that a report: [`text`],
//! [`json`] or a [`picture`].

mod answer;
mod args;
mod bundled;
#[path = "../colorimeter/failure.rs"]
mod failure;
mod file;
mod grids;
mod json;
mod lamp;
mod matter;
mod picture;
#[path = "../colorimeter/plot.rs"]
mod plot;
mod table;
mod text;
#[expect(dead_code, reason = "there are no chromaticities to color here")]
#[path = "../colorimeter/tint.rs"]
mod tint;
#[path = "../colorimeter/usage.rs"]
mod usage;
#[path = "../colorimeter/utf8.rs"]
mod utf8;

use args::Args;
use failure::Failure;
use std::io::{self, ErrorKind, IsTerminal, Write};
use std::process::ExitCode;

fn main() -> ExitCode {
    match Args::read().and_then(|args| run(&args)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            // Nobody may be there to read it.
            let _ = writeln!(io::stderr(), "{failure}");
            ExitCode::from(2)
        }
    }
}

fn run(args: &Args) -> Result<(), Failure> {
    if let Some(name) = &args.print {
        return print(bundled::toml(name)?);
    }
    let Some(word) = args.scene.as_deref().filter(|_| !args.list) else { return print(&bundled::list()?) };
    let recipe = bundled::find(word)?;
    let answer = grids::answer(&recipe, args.budget)?;
    let picture = args.svg.as_ref().map(|path| picture::save(path, &answer)).transpose()?;
    if args.json {
        return print(&format!("{}\n", json::object(&answer)));
    }
    let truecolor = io::stdout().is_terminal() && color_is_welcome();
    print(&text::report(&answer, picture.as_deref(), truecolor))
}

fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        // Whoever reads the pipe may have had enough: `| head`.
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::of("stdout", format_args!("cannot be written ({}); free its disk", error.kind())))
        }
        _ => Ok(()),
    }
}

/// By <https://no-color.org>, and by a terminal that calls itself dumb.
fn color_is_welcome() -> bool {
    std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
        && std::env::var_os("TERM").is_none_or(|value| value != "dumb")
}
