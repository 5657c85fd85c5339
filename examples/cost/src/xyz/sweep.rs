//! The tables that compare the schemes on each range and at each number of bands.

use super::lamps::CLASSES;
use super::price::Prices;
use super::see::Outcome;
use super::world::World;
use crate::report::{Cell, Column, Kind, Table};

const KEYS: [Column; 3] =
    [Column::key("range", "range, nm"), Column::key("scheme", "scheme"), Column::key("bands", "N")];

/// A column for each class of lamps, in the order of the classes.
const MEANS: [Column; CLASSES.len()] = [
    Column::figure("smooth", "smooth"),
    Column::figure("halophosphate", "halophosphate"),
    Column::figure("triphosphor", "triphosphor"),
    Column::figure("led", "LED"),
    Column::figure("hid", "HID"),
    Column::figure("lines", "lines"),
];

/// Makes two columns for each class: one whose name ends in `ending` and whose heading ends in `word`, and
/// one for the largest error.
fn with_max(ending: &str, word: &str) -> Vec<Column> {
    let figure =
        |id: String, heading: String| Column { id: id.into(), heading: heading.into(), kind: Kind::Figure };
    let two = |class: Column| {
        [
            figure(format!("{}{ending}", class.id), format!("{} {word}", class.heading)),
            figure(format!("{}_max", class.id), "max".to_owned()),
        ]
    };
    MEANS.into_iter().flat_map(two).collect()
}

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
    let title = "XYZ of a surface under a lamp: mean CIEDE2000, and what it costs";
    let about = format!(
        "The reference is f64 sums at every 0.1 nm, 360 to 830 nm, of straight lines between the data, for \
         99 color evaluation samples (CIE 224) under {}. Errors are absolute: both colors have the white and \
         the scale of the reference. Folded observers and averages+tails count what lies outside the range \
         in the end bins; points and averages cut it off. Instructions are those at opt-level 3 in QEMU; \
         bytes are those of the constants, and of each surface.",
        CLASSES.map(|class| format!("{} {}", world.count(class), class.name())).join(", ")
    );
    table("xyz", title, &about, &[&MEANS, &costs], outcomes, cells)
}

pub fn spreads(outcomes: &[Outcome]) -> Table {
    let title = "XYZ of a surface under a lamp: 95th percentile and largest CIEDE2000";
    let about = "The same errors as in the table of means, which hides the largest.";
    table("xyz-spread", title, about, &[&with_max("_p95", "p95")], outcomes, |outcome| {
        outcome.score.absolute.iter().flat_map(|spread| [spread.p95, spread.max]).map(Cell::figure).collect()
    })
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
    let title = "The light itself: its worst error, and mean CIEDE2000 from its own white";
    let about = "Mean CIEDE2000 with the choice's own white, which removes the error of the light. Then \
            the largest errors in Y, u'v' and color temperature of the light, for the lamps of tables and \
            for lines. Color temperatures are those of lights within 0.02 of the locus; - means that such a \
            light has lost its color temperature.";
    table("xyz-light", title, about, &[&MEANS, &errors], outcomes, |outcome| {
        let light = outcome.score.light.iter().flat_map(|worst| [worst.percent_y, worst.uv, worst.mired]);
        let finite = |value: f64| if value.is_finite() { Cell::figure(value) } else { Cell::Nothing };
        outcome.score.own_white.into_iter().chain(light).map(finite).collect()
    })
}

pub fn two_bounces(outcomes: &[Outcome]) -> Table {
    let title = "Light off two surfaces: CIEDE2000 of products of averages";
    let about = "The errors for 60 pairs of the color evaluation samples. The average of a product is not \
            the product of averages, and no fold of the light can correct that.";
    table("two-bounces", title, about, &[&with_max("", "mean")], hard(outcomes), |outcome| {
        let spreads = outcome.score.two_bounces.iter();
        spreads.flat_map(|spread| [spread.mean, spread.max]).map(Cell::figure).collect()
    })
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
    let title = "Narrow filters: CIEDE2000, and how often X, Y or Z is negative";
    let about = "The errors for Gaussian filters 10, 20 and 40 nm wide at half their height, centered on \
            420, 425 .. 680 nm, under the lamps of all tables. A smooth curve through averages is not meant \
            for such filters.";
    table("filters", title, about, &[&columns], hard(outcomes), |outcome| {
        let filters = outcome.score.filters.iter();
        filters.flat_map(|(spread, share)| [spread.mean, spread.max, *share]).map(Cell::figure).collect()
    })
}

/// The choices for which two bounces and narrow filters were looked at.
fn hard(outcomes: &[Outcome]) -> impl Iterator<Item = &Outcome> {
    outcomes.iter().filter(|outcome| !outcome.score.filters.is_empty())
}

/// Makes a table with a row for each choice: its keys, and its cells for the columns.
fn table<'a>(
    id: &'static str,
    title: &str,
    about: &str,
    columns: &[&[Column]],
    outcomes: impl IntoIterator<Item = &'a Outcome>,
    cells: impl Fn(&Outcome) -> Vec<Cell>,
) -> Table {
    let row = |outcome: &Outcome| {
        let keys = [Cell::key(outcome.range), Cell::key(outcome.scheme.name()), Cell::key(outcome.bands)];
        keys.into_iter().chain(cells(outcome)).collect()
    };
    Table {
        id,
        title: title.to_owned(),
        about: about.to_owned(),
        columns: KEYS.into_iter().chain(columns.concat()).collect(),
        rows: outcomes.into_iter().map(row).collect(),
    }
}
