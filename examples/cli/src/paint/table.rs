//! Writes the spectra of all colors as one table in CSV, which the command `measure` reads.

use crate::failure::Failure;
use crate::input::bands;
use crate::output::number::shortest;
use crate::output::table::cell;
use crate::paint::answer::Answer;
use crate::paint::args::Args;
use crate::usage::name_of;

/// Returns the table, with a row for each band and a column for each color.
///
/// Of each answer it keeps what stands in its column.
pub fn csv(args: &Args, answers: impl Iterator<Item = Result<Answer, Failure>>) -> Result<String, Failure> {
    let (space, method) = (name_of(args.space), name_of(args.method));
    let (mut heading, mut wavelengths) = (bands::HEADING.to_owned(), Vec::new());
    let mut columns: Vec<Vec<f32>> = Vec::new();
    for answer in answers {
        let Answer { sample, rgb, spectrum, .. } = answer?;
        let numbers = || format!("{space} {}", rgb.map(shortest).join(" "));
        heading = heading + "," + &cell(&sample.unwrap_or_else(numbers));
        columns.push(spectrum.iter().map(|(_, share)| *share).collect());
        wavelengths = spectrum.into_iter().map(|(nm, _)| nm).collect();
    }
    let mut table = format!(
        "# Reflectances for colors in {space}, by the method {method} on {}.\n\
         # A value is the average over a band around its wavelength. Edges lie half way between wavelengths.\n\
         {heading}\n",
        args.grid
    );
    for (k, nm) in wavelengths.iter().enumerate() {
        let shares = columns.iter().map(|column| column[k]);
        let row: Vec<String> = [*nm].into_iter().chain(shares).map(shortest).collect();
        table += &(row.join(",") + "\n");
    }
    Ok(table)
}
