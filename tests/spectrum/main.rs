//! Spectra, the tables they come from, the observers that read them, and the elementary functions below.

mod accuracy;
mod any_spectrum;
mod backends;
mod every_f32;
mod eyes_and_samples;
mod hard_cases;
mod limits;
mod operators;
mod reference;
mod semantics;
mod spectrum_bits;
mod tables;
mod worst_spectra;
