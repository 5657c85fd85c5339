//! How much light, where: quantities, directions, form factors.

mod directions;
mod form_factors;
mod frames;
mod hard_cases;
mod properties;
mod quantities;
