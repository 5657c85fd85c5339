//! The hard cases: inputs at which the form of the textbook fails in f32, that form, and the crate's.
//!
//! Two programs run them: the binary of this package, which knows the right answers, and the image `hard` of
//! `examples/firmware`, which prints the bits of a Cortex-M4F with and without flush-to-zero.
//!
//! A row is named by its number and, where one row asks more than one thing, a letter: "18a".

pub mod color;
mod differences;
mod facets;
mod films;
mod fresnel;
mod geometry;
mod noise;
mod planck;
pub mod sensor;
mod sums;
mod temperature;
mod textbook;

/// Runs the rows, in whatever way it runs them.
pub trait Cases {
    /// The numbers that both forms give for each input.
    fn row<const A: usize, const K: usize>(
        &mut self,
        row: &str,
        inputs: &[[f32; A]],
        naive: fn(&[f32; A]) -> [f32; K],
        ours: fn(&[f32; A]) -> [f32; K],
    );
}

/// Every row.
pub fn all(cases: &mut impl Cases) {
    planck::rows(cases);
    geometry::rows(cases);
    fresnel::rows(cases);
    facets::rows(cases);
    color::rows(cases);
    differences::rows(cases);
    temperature::rows(cases);
    sums::rows(cases);
    films::rows(cases);
    sensor::rows(cases);
}

/// What stands for an answer: 1 for a number, 0 for none; NaN stays.
fn answered(number: Option<f32>) -> [f32; 1] {
    [number.map_or(0.0, |number| if number.is_nan() { number } else { 1.0 })]
}
