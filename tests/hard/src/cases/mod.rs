//! The hard cases: inputs at which the textbook's form fails in f32, with that form and the crate's.
//!
//! Two programs run them: the binary of this package, which compares them with f64, and the image `hard` of
//! `examples/firmware`, which prints the bits of a Cortex-M4F with and without flush-to-zero.
//!
//! A row is named by its number and, if it has more than one part, by a letter, such as "18a".

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

/// A program that runs the rows, such as one that prints their results.
pub trait Cases {
    /// Runs both forms of one row at each of its inputs.
    fn row<const A: usize, const K: usize>(
        &mut self,
        row: &str,
        inputs: &[[f32; A]],
        naive: fn(&[f32; A]) -> [f32; K],
        ours: fn(&[f32; A]) -> [f32; K],
    );
}

/// Runs every row.
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

/// Returns 1 if there is a number and 0 if there is none; NaN stays NaN.
fn answered(number: Option<f32>) -> [f32; 1] {
    [number.map_or(0.0, |number| if number.is_nan() { number } else { 1.0 })]
}
