//! Reads spectra from JSON, in the many ways in which programs write them.

mod find;
mod keys;
mod node;
mod places;
mod records;

use super::{Contents, too_large};
use crate::refusal::Refusal;
use crate::text::lines::lines;
use find::Finder;

/// Reads the spectra of a file.
pub fn read(text: &str) -> Result<Contents, Refusal> {
    let root = node::parse(text).map_err(|fault| match fault {
        node::Fault::TooLarge => too_large(),
        node::Fault::Broken { line, what } => {
            Refusal::at(line, format!("this is not valid JSON ({what}); correct it or save it again"))
        }
    })?;
    let mut finder = Finder::new(1..=lines(text).count().max(1));
    finder.search(&root)?;
    finder.finish()
}

#[cfg(test)]
mod tests;
