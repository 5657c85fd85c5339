//! The one table of what the crate may be off by, against f64 references, and checks by it.
//!
//! Each entry is used by one test, which fails when an error is larger than allowed, and also when the
//! largest error is less than half of what is allowed: then the entry claims too little. Within these two, what
//! was measured is on record, and may not grow by more than 2 %.

mod colors;
mod lights;
pub mod record;

use crate::check::Check;

/// (what, absolute, relative): |got - expected| <= absolute + relative * |expected|.
pub type Allowed = (&'static str, f64, f64);

/// The whole table.
pub fn all() -> impl Iterator<Item = &'static Allowed> {
    colors::ALLOWED.iter().chain(lights::ALLOWED)
}

/// A check with the allowance of this name.
pub fn check(what: &'static str) -> Check {
    let mut entries = all().filter(|entry| entry.0 == what);
    let (Some((_, absolute, relative)), None) = (entries.next(), entries.next()) else {
        panic!("not one entry '{what}' in tests/model/src/allowed");
    };
    Check::new(what, *absolute, *relative).held_to(record::hold)
}

/// Numbers as the crate has them, in f32, singly and in triples.
pub trait Singles {
    fn add(&mut self, place: &str, got: f32, expected: f64);

    fn add_all(&mut self, place: &str, got: [f32; 3], expected: [f64; 3]) {
        got.into_iter().zip(expected).for_each(|(got, expected)| self.add(place, got, expected));
    }
}

impl Singles for Check {
    fn add(&mut self, place: &str, got: f32, expected: f64) {
        self.value(place, f64::from(got), expected);
    }
}
