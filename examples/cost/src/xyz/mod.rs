//! XYZ of a reflectance under a light: what a scheme and a number of bands are off by, and what they cost.
//!
//! [`lamps`] and [`world`] are what is looked at and the truth about it, [`see`] the crate at work by each
//! [`scheme`], [`score`] the errors and [`price`] the cost. Of them [`sweep`] makes the tables, [`frontier`]
//! what no other choice beats, and [`losses`] where more is worse.

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
    // Range by range and scheme by scheme, as the tables are read.
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
