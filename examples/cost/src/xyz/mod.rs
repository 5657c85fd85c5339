//! XYZ of a reflectance under a light: the error and the cost of each scheme at each number of bands.
//!
//! [`lamps`] and [`world`] hold the lamps, the surfaces and the exact results. [`see`] runs the crate by each
//! [`scheme`], [`score`] computes the errors and [`price`] the cost. From these [`sweep`] makes the tables,
//! [`frontier`] lists the choices that no other choice beats, and [`losses`] the cases in which more effort
//! gives a larger error.

mod frontier;
pub mod lamps;
mod losses;
mod price;
mod scheme;
mod score;
mod see;
mod sweep;
mod world;

use crate::report::Table;
use price::Prices;
use see::{JOBS, Outcome};
use world::World;

pub fn tables(runs: usize) -> Vec<Table> {
    let world = World::new();
    let mut outcomes: Vec<Outcome> = JOBS.iter().flat_map(|job| job(&world)).collect();
    outcomes.push(see::in_rgb(&world));
    // Sorted by range and then by scheme, as the tables are read.
    outcomes.sort_by_key(|outcome| (range_place(outcome.range), outcome.scheme.place()));
    let prices = Prices::measured(runs);
    vec![
        sweep::means(&outcomes, &prices, &world),
        sweep::spreads(&outcomes),
        sweep::lights(&outcomes),
        sweep::two_bounces(&outcomes),
        sweep::filters(&outcomes),
        frontier::table(&outcomes, &prices),
        losses::table(&outcomes),
    ]
}

fn range_place(name: &str) -> usize {
    see::RANGES.iter().position(|range| *range == name).unwrap_or(see::RANGES.len())
}
