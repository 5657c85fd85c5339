//! The chart: error against instructions of every scheme, on logarithmic scales.

use crate::counts::Core;
use crate::record::{self, Choice};
use serde_json::Value;
use svg::Document;
use svg::node::element::path::Data;
use svg::node::element::{Circle, Group, Line, Path, Rectangle, Style, Text};

const WIDTH: f64 = 860.0;
const HEIGHT: f64 = 600.0;
/// The diagram's edges on the page.
const LEFT: f64 = 74.0;
const RIGHT: f64 = 842.0;
const TOP: f64 = 64.0;
const BOTTOM: f64 = 540.0;

/// Of pages that are light, and of those that are dark.
const STYLE: &str = "\
.page { fill: #ffffff } .ink { fill: #1f2328 } .faint { fill: #59636e } .grid { stroke: #d8dee4 } \
.ring { stroke: #1f2328 } .front { stroke: #1f2328 } \
@media (prefers-color-scheme: dark) { \
.page { fill: #0d1117 } .ink { fill: #f0f6fc } .faint { fill: #9198a1 } .grid { stroke: #2a313c } \
.ring { stroke: #f0f6fc } .front { stroke: #f0f6fc } }";

/// Each scheme with its color: told apart by the color-blind, and seen on white and on black.
const SCHEMES: [(&str, &str); 8] = [
    ("points", "#d55e00"),
    ("averages", "#e69f00"),
    ("averages+tails", "#a58a54"),
    ("observer parabola", "#cc79a7"),
    ("folded step", "#56b4e9"),
    ("folded parabola", "#2f81f7"),
    ("folded spline", "#009e73"),
    ("sRGB product", "#8957e5"),
];

/// What is named in the diagram: range, scheme, bands, what to write, where: right and down of the point.
const NAMED: [(&str, &str, u32, &str, f64, f64); 8] = [
    ("-", "sRGB product", 3, "sRGB", 0.0, -12.0),
    ("400..700", "folded spline", 8, "spline, 8 bands", -12.0, 16.0),
    ("400..700", "folded spline", 12, "12", -12.0, 16.0),
    ("380..730", "folded spline", 16, "16", -12.0, 16.0),
    ("380..730", "folded spline", 20, "20", -12.0, 16.0),
    ("380..730", "folded spline", 31, "31", -12.0, 18.0),
    ("400..700", "points", 31, "31 points, every 10 nm", 0.0, -10.0),
    ("400..700", "averages", 60, "60 averages", 9.0, 4.5),
];

/// A logarithmic scale.
struct Scale {
    from: f64,
    to: f64,
    start: f64,
    end: f64,
}

const X: Scale = Scale { from: 20.0, to: 2000.0, start: LEFT, end: RIGHT };
const Y: Scale = Scale { from: 0.002, to: 60.0, start: BOTTOM, end: TOP };

impl Scale {
    fn place(&self, value: f64) -> f64 {
        let share = (value / self.from).ln() / (self.to / self.from).ln();
        self.start + share.clamp(0.0, 1.0) * (self.end - self.start)
    }
}

/// Instructions and error of a choice.
fn place(choice: &Choice) -> Option<(f64, f64)> {
    Some((X.place(choice.instructions(Core::M4F)?), Y.place(choice.of_lamps())))
}

/// The chart of every choice of a report that has a price, as the text of a file.
pub fn frontier(report: &Value) -> String {
    let choices = record::choices(report);
    let document = Document::new()
        .set("viewBox", format!("0 0 {WIDTH} {HEIGHT}"))
        .set("width", WIDTH)
        .set("height", HEIGHT)
        .set("font-family", "DejaVu Sans, Verdana, Helvetica, Arial, sans-serif")
        .set("font-size", 13)
        .add(Style::new(STYLE))
        .add(Rectangle::new().set("width", WIDTH).set("height", HEIGHT).set("class", "page"))
        .add(label(LEFT, 28.0, "What accuracy costs: XYZ of a surface under a lamp").set("font-size", 18))
        .add(
            label(LEFT, 48.0, "mean CIEDE2000 against a 0.1 nm truth: lamps of five kinds, 99 surfaces")
                .set("class", "faint"),
        )
        .add(frame())
        .add(legend());
    let document = choices.iter().fold(document, |document, choice| match place(choice) {
        Some(at) => document.add(mark(choice, at)),
        None => document,
    });
    let document = document.add(front(&record::front(report, &choices)));
    let named = NAMED.iter().filter_map(|(range, scheme, bands, text, right, down)| {
        let (x, y) = place(choices.iter().find(|choice| choice.is(range, scheme, *bands))?)?;
        let anchor = if *right < 0.0 { "end" } else { "start" };
        Some(label(x + right, y + down, text).set("text-anchor", anchor))
    });
    format!("{}\n", named.fold(document, Document::add))
}

/// The choices that no other beats, joined.
fn front(choices: &[&Choice]) -> Group {
    let places: Vec<(f64, f64)> = choices.iter().copied().filter_map(place).collect();
    let mut line = Data::new();
    for (k, (x, y)) in places.iter().enumerate() {
        let at = (round(*x), round(*y));
        line = if k == 0 { line.move_to(at) } else { line.line_to(at) };
    }
    let path = Path::new().set("d", line).set("fill", "none").set("class", "front").set("stroke-width", 1.6);
    places.iter().fold(Group::new().add(path), |group, (x, y)| {
        let ring = Circle::new().set("cx", round(*x)).set("cy", round(*y)).set("r", 6.5);
        group.add(ring.set("fill", "none").set("class", "ring").set("stroke-width", 1.6))
    })
}

/// A round mark for 380..730 nm, a square one for 400..700, a diamond for 380..780.
fn mark(choice: &Choice, (x, y): (f64, f64)) -> Path {
    let color = SCHEMES.iter().find(|(name, _)| *name == choice.scheme).map_or("#888888", |(_, color)| color);
    shape(&choice.range, round(x), round(y)).set("fill", color).set("fill-opacity", 0.85)
}

fn shape(range: &str, x: f64, y: f64) -> Path {
    let data = match range {
        "400..700" => Data::new()
            .move_to((x - 3.5, y - 3.5))
            .horizontal_line_by(7)
            .vertical_line_by(7)
            .horizontal_line_by(-7),
        "380..780" => {
            Data::new().move_to((x, y - 4.5)).line_by((4.5, 4.5)).line_by((-4.5, 4.5)).line_by((-4.5, -4.5))
        }
        _ => Data::new()
            .move_to((x - 4.0, y))
            .elliptical_arc_by((4, 4, 0, 0, 1, 8, 0))
            .elliptical_arc_by((4, 4, 0, 0, 1, -8, 0)),
    };
    Path::new().set("d", data.close())
}

/// Grid lines at every power of ten and their numbers, and the titles of the axes.
fn frame() -> Group {
    let mut group = Group::new();
    for value in [20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0] {
        let x = round(X.place(value));
        group = group.add(line((x, TOP), (x, BOTTOM)));
        group = group.add(label(x, BOTTOM + 18.0, &value.to_string()).set("text-anchor", "middle"));
    }
    for value in [0.01, 0.1, 1.0, 10.0] {
        let y = round(Y.place(value));
        group = group.add(line((LEFT, y), (RIGHT, y)));
        group = group.add(label(LEFT - 8.0, y + 4.5, &value.to_string()).set("text-anchor", "end"));
    }
    let middle = round(0.5 * (TOP + BOTTOM));
    let below =
        label(round(0.5 * (LEFT + RIGHT)), BOTTOM + 42.0, "instructions on a Cortex-M4F, for one XYZ");
    let beside =
        label(0.0, 0.0, "mean CIEDE2000").set("transform", format!("translate(22 {middle}) rotate(-90)"));
    group.add(below.set("text-anchor", "middle")).add(beside.set("text-anchor", "middle"))
}

/// Down at the left, where nothing can be.
fn legend() -> Group {
    let (x, mut y) = (LEFT + 18.0, BOTTOM - 196.0);
    let mut group = Group::new();
    for (name, color) in SCHEMES {
        group = group.add(shape("", x, y).set("fill", color)).add(label(x + 14.0, y + 4.5, name));
        y += 19.0;
    }
    for (range, at) in [("400..700", 0.0), ("380..730", 96.0), ("380..780", 192.0)] {
        let shape = shape(range, x + at, y + 6.0).set("class", "faint");
        group = group.add(shape).add(label(x + at + 12.0, y + 10.5, range).set("class", "faint"));
    }
    group.add(
        label(x - 4.0, y + 32.0, "ringed and joined: no choice is cheaper and nearer").set("class", "faint"),
    )
}

fn line((x1, y1): (f64, f64), (x2, y2): (f64, f64)) -> Line {
    Line::new().set("x1", x1).set("y1", y1).set("x2", x2).set("y2", y2).set("class", "grid")
}

fn label(x: f64, y: f64, text: &str) -> Text {
    Text::new(text).set("x", round(x)).set("y", round(y)).set("class", "ink")
}

/// To a tenth of a pixel: the same file everywhere.
fn round(value: f64) -> f64 {
    (value * 10.0).round() / 10.0
}
