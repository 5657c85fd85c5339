//! Prints the table of hard cases as Markdown: `cargo run --release -p nanospectra-hard`. If a row differs
//! from what it claims, the reason goes to stderr and the exit code is 1.

mod table;
#[cfg(test)]
mod tests;

use std::io::{self, Write};
use std::process::ExitCode;
use table::HardCase;

fn main() -> io::Result<ExitCode> {
    let cases = table::hard_cases();
    io::stdout().write_all(table::markdown(&cases).as_bytes())?;
    let faults: Vec<String> = cases.iter().flat_map(HardCase::faults).collect();
    for fault in &faults {
        writeln!(io::stderr(), "{fault}")?;
    }
    Ok(if faults.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
