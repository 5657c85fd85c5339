//! The chart of accuracy against cost. It shows the error of a color over the instructions that the color
//! takes, both on logarithmic scales, with few words and no legend. Every position comes from the record.

use super::{Color, filled, joined, label, line, page, round, stroke, text};
use crate::counts::Core;
use crate::record::{self, CLASSES, Choice};
use nanospectra::matter::CES;
use serde_json::Value;
use svg::node::element::{Circle, Group, Rectangle};

const HEIGHT: f64 = 464.0;
/// The edges of the diagram on the page.
const LEFT: f64 = 60.0;
const RIGHT: f64 = 706.0;
const TOP: f64 = 68.0;
const BOTTOM: f64 = 404.0;

/// The colors of this picture alone.
const COLORS: [Color; 2] = [("folded", "#0060a8", "#58a6ff"), ("seen", "#a34500", "#ffae7a")];

/// A color difference of about this much, in CIEDE2000, is just visible.
const VISIBLE: f64 = 1.0;

/// The range of the spectra in the chart, in nm.
const RANGE: &str = "380..730";

/// The points of the bold line that have a name: the number of bands, and how far to the right of the point
/// and below it the name stands. A name on the left ends there, and a name that is not shifted is centered.
const FOLDED: [(u32, f64, f64); 6] = [
    (8, -14.0, 5.0),
    (12, -14.0, 8.0),
    (16, -14.0, 10.0),
    (20, -12.0, 16.0),
    (31, -10.0, 20.0),
    (81, 0.0, -13.0),
];

/// The points of the thin line that have a name: the number of bands, the name, and where it stands.
const AVERAGES: [(u32, &str, f64, f64); 2] =
    [(8, "8 averages, not folded", 12.0, -4.0), (60, "60 averages", -6.0, 22.0)];

/// The fewest and the most bands that the lines show.
const BANDS: std::ops::RangeInclusive<u32> = 8..=81;

/// A logarithmic scale.
struct Scale {
    from: f64,
    to: f64,
    start: f64,
    end: f64,
}

const X: Scale = Scale { from: 25.0, to: 1250.0, start: LEFT, end: RIGHT };
const Y: Scale = Scale { from: 0.002, to: 20.0, start: BOTTOM, end: TOP };

impl Scale {
    fn place(&self, value: f64) -> f64 {
        let share = (value / self.from).ln() / (self.to / self.from).ln();
        self.start + share.clamp(0.0, 1.0) * (self.end - self.start)
    }
}

/// Where the instructions and the error of a choice place it. `None` if nobody counted the instructions.
fn place(choice: &Choice) -> Option<(f64, f64)> {
    Some((X.place(choice.instructions(Core::M4F)?), Y.place(choice.of_lamps())))
}

/// Draws the chart of a report, as the text of a file. What the report does not have is left out.
pub fn frontier(report: &Value) -> String {
    let choices = record::choices(report);
    let title =
        "Color error against instructions: folded bands, plain averages, and a product of sRGB colors";
    let document = page("ns-frontier", title, HEIGHT, &COLORS)
        .add(label(12.0, 28.0, "What accuracy costs", "ink").set("font-size", 19).set("font-weight", 600))
        .add(frame())
        .add(averages(&choices))
        .add(folded(&choices));
    let srgb = choices.iter().find(|choice| choice.is("-", "sRGB product", 3)).and_then(place);
    text(&match srgb {
        Some((x, y)) => document.add(dot(x, y, 6.0, "violet")).add(label(
            x + 13.0,
            y + 5.0,
            "product of sRGB colors",
            "violet",
        )),
        None => document,
    })
}

/// The axes with their titles, and the limit of what is visible.
fn frame() -> Group {
    let limit = round(Y.place(VISIBLE));
    let seen = Rectangle::new().set("x", LEFT).set("y", TOP).set("width", RIGHT - LEFT);
    let seen = filled(seen.set("height", round(limit - TOP)), "seen").set("fill-opacity", 0.12);
    let mut group = Group::new().add(seen);
    let number = |x, y, value: f64| label(x, y, &value.to_string(), "faint").set("font-size", 16);
    for value in [30.0, 100.0, 300.0, 1000.0] {
        let x = X.place(value);
        group = group.add(line((x, BOTTOM), (x, BOTTOM + 6.0), "faint"));
        group = group.add(number(x, BOTTOM + 23.0, value).set("text-anchor", "middle"));
    }
    group = group.add(line((LEFT, BOTTOM), (RIGHT, BOTTOM), "faint"));
    for value in [0.01, 0.1, 1.0, 10.0] {
        let y = Y.place(value);
        group = group.add(line((LEFT, y), (RIGHT, y), "faint").set("stroke-opacity", 0.25));
        group = group.add(number(LEFT - 8.0, y + 5.0, value).set("text-anchor", "end"));
    }
    let (lamps, surfaces) = (CLASSES.len() - 1, CES.len());
    let error = format!("Color error: CIEDE2000, mean over {surfaces} surfaces and {lamps} kinds of lamps");
    let cost = "Instructions for one XYZ, Cortex-M4F at opt-level 3";
    group
        .add(
            line((LEFT, limit), (RIGHT, limit), "seen")
                .set("stroke-dasharray", "6 4")
                .set("stroke-width", 1.5),
        )
        .add(label(RIGHT - 8.0, limit - 9.0, "visible above this line", "seen").set("text-anchor", "end"))
        .add(label(12.0, 52.0, &error, "faint"))
        .add(label(0.5 * (LEFT + RIGHT), BOTTOM + 49.0, cost, "faint").set("text-anchor", "middle"))
}

/// A point of a line.
struct Point {
    bands: u32,
    instructions: f64,
    at: (f64, f64),
}

/// The points of a scheme, one for every number of bands.
fn curve(choices: &[Choice], scheme: &str) -> Vec<Point> {
    let shown =
        |choice: &&Choice| choice.scheme == scheme && choice.range == RANGE && BANDS.contains(&choice.bands);
    let point = |choice: &Choice| {
        let instructions = choice.instructions(Core::M4F)?;
        Some(Point { bands: choice.bands, instructions, at: place(choice)? })
    };
    choices.iter().filter(shown).filter_map(point).collect()
}

/// The thin line: spectra as plain averages over the bands.
fn averages(choices: &[Choice]) -> Group {
    let points = curve(choices, "averages");
    let mut group = Group::new().add(stroke(joined(points.iter().map(|point| point.at)), 1.5, "faint"));
    for Point { bands, at: (x, y), .. } in points {
        let Some((_, name, right, down)) = AVERAGES.iter().find(|(named, ..)| *named == bands) else {
            continue;
        };
        let name = label(x + right, y + down, name, "faint").set("text-anchor", anchor(*right));
        group = group.add(dot(x, y, 4.0, "faint")).add(name);
    }
    group
}

/// The bold line: the lamp and the eye folded together.
fn folded(choices: &[Choice]) -> Group {
    let points = curve(choices, "folded spline");
    let mut group = Group::new().add(stroke(joined(points.iter().map(|point| point.at)), 4.0, "folded"));
    for Point { bands, instructions, at: (x, y) } in points {
        let Some((_, right, down)) = FOLDED.iter().find(|(named, ..)| *named == bands) else { continue };
        let name = match bands {
            8 => "folded into 8 bands".to_owned(),
            16 => format!("16 bands: {instructions} instructions"),
            81 => "81 bands".to_owned(),
            _ => bands.to_string(),
        };
        let name = label(x + right, y + down, &name, "ink").set("text-anchor", anchor(*right));
        group = group.add(dot(x, y, 6.0, "folded")).add(name.set("font-weight", 600));
    }
    group
}

/// The side of a text that is nearest to what it names, if it stands this far to the right of it.
fn anchor(right: f64) -> &'static str {
    match right {
        0.0 => "middle",
        ..0.0 => "end",
        _ => "start",
    }
}

fn dot(x: f64, y: f64, radius: f64, class: &str) -> Circle {
    filled(Circle::new().set("cx", round(x)).set("cy", round(y)).set("r", radius), class)
}
