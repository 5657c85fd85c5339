//! Prints what the reader makes of files: `cargo run -p nanospectra-files --example look -- FILES`.

use nanospectra_files::{Options, Reading, read};

/// How many curves of a file are shown.
const SHOWN: usize = 4;

fn main() -> Result<(), std::io::Error> {
    for path in std::env::args().skip(1) {
        println!("{path}");
        match read(&std::fs::read(&path)?, &Options::default()) {
            Ok(reading) => show(&reading),
            Err(refusal) => println!("  refused: {refusal} (setting: {:?})", refusal.setting),
        }
    }
    Ok(())
}

fn show(reading: &Reading) {
    for curve in reading.curves.iter().take(SHOWN) {
        let name = curve.name.as_deref().unwrap_or("without a name");
        let (first, last) = (curve.wavelengths.first(), curve.wavelengths.last());
        println!(
            "  {name}: {} samples from {first:?} to {last:?} nm; {}",
            curve.values.len(),
            curve.origin()
        );
    }
    println!("  {} curves, {} facts", reading.curves.len(), reading.facts.len());
    for note in &reading.notes {
        println!("  {:?}: {}", note.kind, note.what);
    }
}
