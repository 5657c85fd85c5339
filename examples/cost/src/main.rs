//! Measures what accuracy costs in instructions, bytes and time.
//!
//! Run it with `cargo run --release -p nanospectra-cost`, and with `--help` for the options. Each of the
//! [`studies`] compares several ways of computing the same with an f64 reference, and lists what each way
//! costs: the instructions on record ([`counts`]), bytes, and nanoseconds on this machine ([`clock`]). A
//! study gives tables ([`report`]), which are printed for a terminal ([`text`]) or written for a program
//! ([`json`]). [`check`] compares them with the tables on record. From the record ([`record`]) the program
//! makes the pictures of the guide ([`picture`]) and the tables of the README and the guides ([`docs`]), as
//! files that [`made`] writes and compares, and [`advise`] chooses from it.

mod advise;
mod args;
mod cct;
mod cells;
mod check;
mod clock;
mod counts;
mod docs;
mod effects;
mod gamuts;
mod json;
mod made;
mod math;
mod nanometers;
mod observers;
mod picture;
mod record;
mod report;
mod studies;
mod sums;
mod tables;
mod text;
mod upsample;
mod xyz;

use args::Args;
use nanospectra_cli::failure::{Failure, exit_code, short};
use nanospectra_cli::output::terminal::print;
use report::Table;
use std::io::{self, Write};
use std::process::ExitCode;
use studies::STUDIES;

fn main() -> ExitCode {
    exit_code(Args::read().and_then(|args| run(&args)))
}

fn run(args: &Args) -> Result<ExitCode, Failure> {
    if args.advise {
        let choices = record::choices(&json::recorded()?);
        print(&advise::advice(&choices, &args.limits)?)?;
        return Ok(ExitCode::SUCCESS);
    }
    if args.docs {
        made::save(&made::of(&json::recorded()?)?)?;
        return Ok(ExitCode::SUCCESS);
    }
    let report = json::report(&measured(args)?);
    if let Some(path) = &args.json {
        made::write(path, &json::text(&report))?;
    }
    if args.bless {
        let record = json::updated(json::recorded()?, &report);
        made::write(&made::in_repository(json::PLACE), &json::text(&record))?;
        made::save(&made::of(&record)?)?;
    }
    if args.check {
        let record = json::recorded()?;
        let mut differences = check::differences(&report, &record);
        differences.extend(made::stale(&made::of(&record)?)?);
        for line in &differences {
            print(&format!("{line}\n"))?;
        }
        print(&format!("{} differences from what is on record\n", differences.len()))?;
        return Ok(if differences.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE });
    }
    Ok(ExitCode::SUCCESS)
}

/// Runs the studies, prints each table when it is ready, and returns all tables.
fn measured(args: &Args) -> Result<Vec<Table>, Failure> {
    if let Some(word) = args.only.iter().find(|word| STUDIES.iter().all(|study| study.name != **word)) {
        let names: Vec<&str> = STUDIES.iter().map(|study| study.name).collect();
        return Err(Failure::of(
            "--only",
            format_args!("{} is no study; there are {}", short(word), names.join(", ")),
        ));
    }
    let chosen: Vec<_> = STUDIES
        .iter()
        .filter(|study| args.only.is_empty() || args.only.iter().any(|word| word == study.name))
        .collect();
    let runs = if args.quick { 3 } else { 31 };
    let mut tables = Vec::new();
    for (k, study) in chosen.iter().enumerate() {
        // The study goes on if its progress cannot be shown.
        let _ = writeln!(io::stderr(), "study {} of {}: {}", k + 1, chosen.len(), study.name);
        for table in (study.run)(runs) {
            // A check prints nothing but the differences.
            if !args.check {
                print(&text::table(&table))?;
            }
            tables.push(table);
        }
    }
    Ok(tables)
}
