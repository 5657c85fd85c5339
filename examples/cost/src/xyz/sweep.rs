//! The tables of the sweep: scheme by range by number of bands.

use super::lamps::CLASSES;
use super::price::Prices;
use super::see::Outcome;
use super::world::World;
use crate::report::{Cell, Column, Table};

const KEYS: [Column; 3] =
    [Column::key("range", "range, nm"), Column::key("scheme", "scheme"), Column::key("bands", "N")];

/// A column for each class, in their order.
pub const MEANS: [Column; CLASSES.len()] = [
    Column::figure("smooth", "smooth"),
    Column::figure("halophosphate", "halophosphate"),
    Column::figure("triphosphor", "triphosphor"),
    Column::figure("led", "LED"),
    Column::figure("hid", "HID"),
    Column::figure("lines", "lines"),
];

const SPREADS: [Column; 2 * CLASSES.len()] = [
    Column::figure("smooth_p95", "smooth p95"),
    Column::figure("smooth_max", "max"),
    Column::figure("halophosphate_p95", "halophosphate p95"),
    Column::figure("halophosphate_max", "max"),
    Column::figure("triphosphor_p95", "triphosphor p95"),
    Column::figure("triphosphor_max", "max"),
    Column::figure("led_p95", "LED p95"),
    Column::figure("led_max", "max"),
    Column::figure("hid_p95", "HID p95"),
    Column::figure("hid_max", "max"),
    Column::figure("lines_p95", "lines p95"),
    Column::figure("lines_max", "max"),
];

const BOUNCES: [Column; 2 * CLASSES.len()] = [
    Column::figure("smooth", "smooth mean"),
    Column::figure("smooth_max", "max"),
    Column::figure("halophosphate", "halophosphate mean"),
    Column::figure("halophosphate_max", "max"),
    Column::figure("triphosphor", "triphosphor mean"),
    Column::figure("triphosphor_max", "max"),
    Column::figure("led", "LED mean"),
    Column::figure("led_max", "max"),
    Column::figure("hid", "HID mean"),
    Column::figure("hid_max", "max"),
    Column::figure("lines", "lines mean"),
    Column::figure("lines_max", "max"),
];

pub fn means(outcomes: &[Outcome], prices: &Prices, world: &World) -> Table {
    let costs = [
        Column::figure("m4f_instructions", "M4F"),
        Column::figure("m0_instructions", "M0"),
        Column::figure("constant_bytes", "bytes"),
        Column::figure("surface_bytes", "a surface"),
        Column::time("ns", "ns here"),
    ];
    let cells = |outcome: &Outcome| {
        let price = prices.of(outcome.scheme, outcome.bands);
        let mut cells: Vec<Cell> =
            outcome.score.absolute.iter().map(|spread| Cell::figure(spread.mean)).collect();
        cells.extend([Cell::count(price.m4f), Cell::count(price.m0)]);
        cells.extend([price.constants, price.per_surface].map(|bytes| Cell::figure(bytes as f64)));
        cells.push(Cell::time(price.nanoseconds));
        cells
    };
    Table {
        id: "xyz",
        title: "XYZ of a surface under a lamp: mean CIEDE2000, and what it costs".to_owned(),
        about: format!(
            "Truth: f64 sums every 0.1 nm, 360 to 830 nm, of straight lines between the data; 99 colour evaluation \
             samples (CIE 224) under {}. Errors are absolute: with the truth's white and the truth's scale. A folded observer has what \
             lies outside its range in the end bins, points and averages cut it off, averages+tails do not. \
             Instructions at opt-level 3 in QEMU; bytes of constants, and of each surface.",
            CLASSES.map(|class| format!("{} {}", world.count(class), class.name())).join(", ")
        ),
        columns: [&KEYS[..], &MEANS, &costs].concat(),
        rows: outcomes.iter().map(|outcome| row(outcome, cells(outcome))).collect(),
    }
}

pub fn spreads(outcomes: &[Outcome]) -> Table {
    let cells = |outcome: &Outcome| {
        outcome.score.absolute.iter().flat_map(|spread| [spread.p95, spread.max]).map(Cell::figure).collect()
    };
    Table {
        id: "xyz-spread",
        title: "XYZ of a surface under a lamp: 95th percentile and largest CIEDE2000".to_owned(),
        about: "Of the table before: what the mean hides.".to_owned(),
        columns: [&KEYS[..], &SPREADS].concat(),
        rows: outcomes.iter().map(|outcome| row(outcome, cells(outcome))).collect(),
    }
}

pub fn lights(outcomes: &[Outcome]) -> Table {
    let errors = [
        Column::figure("lamps_percent_y", "lamps dY %"),
        Column::figure("lamps_uv", "du'v'"),
        Column::figure("lamps_mired", "mired"),
        Column::figure("lines_percent_y", "lines dY %"),
        Column::figure("lines_uv", "du'v'"),
        Column::figure("lines_mired", "mired"),
    ];
    let cells = |outcome: &Outcome| {
        let light = outcome.score.light.iter().flat_map(|worst| [worst.percent_y, worst.uv, worst.mired]);
        outcome.score.own_white.into_iter().chain(light).map(finite).collect()
    };
    Table {
        id: "xyz-light",
        title: "The light itself: its worst error, and mean CIEDE2000 from its own white".to_owned(),
        about: "Seen from its own white a colour is nearer to the truth, since the error of the light goes out of \
            it. Then the worst Y, u'v' and CCT of the lights of tables and of lines; CCT of those within 0.02 of \
            the locus, - where one has none any more."
            .to_owned(),
        columns: [&KEYS[..], &MEANS, &errors].concat(),
        rows: outcomes.iter().map(|outcome| row(outcome, cells(outcome))).collect(),
    }
}

pub fn two_bounces(outcomes: &[Outcome]) -> Table {
    let cells = |outcome: &Outcome| {
        outcome
            .score
            .two_bounces
            .iter()
            .flat_map(|spread| [spread.mean, spread.max])
            .map(Cell::figure)
            .collect()
    };
    let hard = outcomes.iter().filter(|outcome| !outcome.score.filters.is_empty());
    Table {
        id: "two-bounces",
        title: "Light off two surfaces: CIEDE2000 of products of averages".to_owned(),
        about: "60 pairs of the colour evaluation samples. An average of products is no product of averages, and no \
            fold of the light knows of it."
            .to_owned(),
        columns: [&KEYS[..], &BOUNCES].concat(),
        rows: hard.map(|outcome| row(outcome, cells(outcome))).collect(),
    }
}

pub fn filters(outcomes: &[Outcome]) -> Table {
    let columns = [
        Column::figure("mean_10nm", "10 nm mean"),
        Column::figure("max_10nm", "max"),
        Column::figure("negative_10nm", "negative %"),
        Column::figure("mean_20nm", "20 nm mean"),
        Column::figure("max_20nm", "max"),
        Column::figure("negative_20nm", "negative %"),
        Column::figure("mean_40nm", "40 nm mean"),
        Column::figure("max_40nm", "max"),
        Column::figure("negative_40nm", "negative %"),
    ];
    let cells = |outcome: &Outcome| {
        let filters = outcome.score.filters.iter();
        filters.flat_map(|(spread, share)| [spread.mean, spread.max, *share]).map(Cell::figure).collect()
    };
    let hard = outcomes.iter().filter(|outcome| !outcome.score.filters.is_empty());
    Table {
        id: "filters",
        title: "Narrow filters: CIEDE2000, and how often X, Y or Z is negative".to_owned(),
        about: "Gaussians 10, 20 and 40 nm wide at half their height, centred on 420, 425 .. 680 nm, under the lamps \
            of all tables: what a smooth curve through averages is not made for."
            .to_owned(),
        columns: [&KEYS[..], &columns].concat(),
        rows: hard.map(|outcome| row(outcome, cells(outcome))).collect(),
    }
}

/// The keys of an outcome, then its cells.
fn row(outcome: &Outcome, cells: Vec<Cell>) -> Vec<Cell> {
    let keys = [Cell::key(outcome.range), Cell::key(outcome.scheme.name()), Cell::key(outcome.bands)];
    keys.into_iter().chain(cells).collect()
}

fn finite(value: f64) -> Cell {
    if value.is_finite() { Cell::figure(value) } else { Cell::Nothing }
}
