//! Writes the spectra of all colors as one table in CSV, which the command `measure` reads.

use crate::input::bands;
use crate::output::number::shortest;
use crate::output::table::cell;
use crate::paint::answer::Answer;
use crate::paint::args::Args;
use crate::usage::name_of;

/// Returns the table, with a row for each band and a column for each color.
pub fn csv(args: &Args, answers: &[Answer]) -> String {
    let (space, method) = (name_of(args.space), name_of(args.method));
    let mut table = format!(
        "# Reflectances for colors in {space}, by the method {method} on {}.\n\
         # A value is the average over a band around its wavelength. Edges lie half way between wavelengths.\n",
        args.grid
    );
    let name = |answer: &Answer| {
        let numbers = || format!("{space} {}", answer.rgb.map(shortest).join(" "));
        cell(&answer.sample.clone().unwrap_or_else(numbers))
    };
    let row = |first: String, cells: Vec<String>| [vec![first], cells].concat().join(",") + "\n";
    table += &row(bands::HEADING.into(), answers.iter().map(name).collect());
    let wavelengths = answers.first().map_or(&[][..], |answer| &answer.spectrum);
    for (k, (nm, _)) in wavelengths.iter().enumerate() {
        let share = |answer: &Answer| shortest(answer.spectrum[k].1);
        table += &row(shortest(*nm), answers.iter().map(share).collect());
    }
    table
}
