//! The grids that this program is compiled for. A grid is part of a spectrum's type: how many bands there
//! are, and at which wavelengths.

/// From lines such as `nodes Nodes<400, 700> 31;`, makes the list of names and the function that chooses the
/// types for a name.
macro_rules! grids {
    ($($word:ident $layout:ident<$from:literal, $to:literal> $count:literal;)+) => {
        /// The names, as `--grid` takes them.
        pub const NAMES: &[&str] =
            &[$(concat!(stringify!($word), ":", $count, ",", $from, ",", $to)),+];

        /// Returns what answers colors on the grid with this name, which is one of [`NAMES`].
        pub fn painter(name: &str, job: &Job) -> Result<Paint, Failure> {
            $(if name == concat!(stringify!($word), ":", $count, ",", $from, ",", $to) {
                return Ok(in_space::<$count, $layout<$from, $to>>(job));
            })+
            Err(Failure::of("--grid", refusal()))
        }
    };
}

use crate::failure::Failure;
use crate::paint::answer::{Job, Paint, in_space};
use nanospectra::{Bins, Nodes};

grids! {
    nodes Nodes<400, 700> 31;
    nodes Nodes<380, 730> 36;
    nodes Nodes<380, 780> 81;
    bins Bins<380, 730> 16;
    bins Bins<380, 730> 31;
    bins Bins<380, 730> 36;
    bins Bins<380, 730> 60;
    bins Bins<400, 700> 60;
}

/// Accepts one of [`NAMES`], as clap asks for it.
pub fn known(text: &str) -> Result<String, String> {
    if NAMES.contains(&text) { Ok(text.to_owned()) } else { Err(refusal()) }
}

/// The text of `--help` on grids.
pub fn help() -> String {
    format!(
        "The bands of the spectrum: nodes or bins, how many, and from where to where in nm. One of {}",
        NAMES.join(", ")
    )
}

fn refusal() -> String {
    format!("this program is compiled for the grids {}; use one of these", NAMES.join(" | "))
}
