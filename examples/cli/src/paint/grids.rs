//! The grids that this program is compiled for: how many bands and where are part of a spectrum's type.

/// Makes, of lines like `nodes Nodes<400, 700> 31;`, the names and what picks the types for a name.
macro_rules! grids {
    ($($word:ident $layout:ident<$from:literal, $to:literal> $count:literal;)+) => {
        /// As `--grid` takes them.
        pub const NAMES: &[&str] =
            &[$(concat!(stringify!($word), ":", $count, ",", $from, ",", $to)),+];

        /// The answers on the grid called `name`, which is one of [`NAMES`].
        pub fn answers(name: &str, job: &Job) -> Result<Vec<Answer>, Failure> {
            $(if name == concat!(stringify!($word), ":", $count, ",", $from, ",", $to) {
                return in_space::<$count, $layout<$from, $to>>(job);
            })+
            Err(Failure::of("--grid", refusal()))
        }
    };
}

use crate::failure::Failure;
use crate::paint::answer::{Answer, Job, in_space};
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

/// `text` if it is one of [`NAMES`], for clap.
pub fn known(text: &str) -> Result<String, String> {
    if NAMES.contains(&text) { Ok(text.to_owned()) } else { Err(refusal()) }
}

/// For `--help`.
pub fn help() -> String {
    format!("Bands of the spectrum: points or bins, how many, from and to in nm. One of {}", NAMES.join(", "))
}

fn refusal() -> String {
    format!("a grid is part of a type, and compiled in are {}; use one of these", NAMES.join(" | "))
}
