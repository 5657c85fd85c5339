//! Compares nanospectra with other crates and with code written by hand, and prints how many times as fast it
//! is:
//!
//! ```text
//! cargo bench -p nanospectra-benches --bench peers [-- [observer] [color] [upsample] [alias] [--json FILE]]
//! ```
//!
//! Without a word all four groups run. Every result is compared with an f64 reference before it is timed.
//! `RUSTFLAGS="-C target-cpu=x86-64-v3"` builds for AVX2, which changes no result. Times vary from run to
//! run, so a ratio below its bar is printed as missed but does not fail the bench. Tests count instructions
//! instead.

mod alias;
mod color;
mod observer;
mod race;
mod upsample;

use race::Races;

/// Comparisons that belong together.
type Group = fn(&mut Races);

fn main() -> std::io::Result<()> {
    let arguments: Vec<String> = std::env::args().collect();
    let mut races = Races::new(arguments.iter().any(|a| a == "--test"));
    let groups: [(&str, Group); 4] = [
        ("observer", observer::all),
        ("color", color::all),
        ("upsample", upsample::all),
        ("alias", alias::all),
    ];
    let named = |name: &str| arguments.iter().any(|a| a == name);
    let all = !groups.iter().any(|(name, _)| named(name));
    for (name, run) in groups {
        if all || named(name) {
            run(&mut races);
        }
    }
    races.print();
    if let Some(file) = arguments.iter().skip_while(|a| *a != "--json").nth(1) {
        std::fs::write(file, serde_json::to_string_pretty(&races.json())? + "\n")?;
    }
    Ok(())
}
