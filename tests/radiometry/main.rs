//! How much light, where: quantities, directions, form factors.

mod any_geometry;
mod directions;
mod form_factors;
mod frames;
mod hard_cases;
mod quantities;
mod radiometry_bits;
mod worst_directions;
mod worst_sources;
