//! What accuracy costs in time, measured again.
//!
//! `cargo run --release -p nanospectra-cost`; `--help` says the rest. Each of the [`studies`] compares
//! choices with an f64 reference and puts what they cost beside: instructions on record ([`counts`]), bytes,
//! and nanoseconds here ([`clock`]). What it finds are tables ([`report`]), for a terminal ([`text`]) or a
//! program ([`json`]); [`check`] compares them with those on record. Of the record ([`record`]) the chart
//! ([`picture`]) and the tables of the documentation ([`docs`]) are [`made`], and by it [`advise`] chooses.

mod advise;
mod args;
mod cct;
mod cells;
mod check;
mod clock;
mod counts;
mod docs;
mod effects;
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

/// What the studies find, each printed as it comes.
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
        // Progress that cannot be shown is no reason to stop.
        let _ = writeln!(io::stderr(), "study {} of {}: {}", k + 1, chosen.len(), study.name);
        for table in (study.run)(runs) {
            // Who checks wants the differences alone.
            if !args.check {
                print(&text::table(&table))?;
            }
            tables.push(table);
        }
    }
    Ok(tables)
}
