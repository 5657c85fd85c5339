//! The picture of the idea. The upper row shows a lamp, a filter, a surface and an eye, which are multiplied
//! at every wavelength and added up. The lower row shows the same with all but the surface folded into one
//! small matrix. The curves, the numbers and the colors are computed by the crate.

use super::{Color, filled, joined, label, page, round, stroke, text};
use nanospectra::color::{Adaptation, Cat16, Rgb, RgbSpace, Srgb, Xyz};
use nanospectra::light::LED_B3;
use nanospectra::matter::TCS;
use nanospectra::observer::CIE_1931;
use nanospectra::{Curve, Factor, Fine, FineObserver, Nodes, Observer, Power, Reflectance};
use svg::node::element::path::Data;
use svg::node::element::{Definitions, Group, LinearGradient, Path, Rectangle, Stop, Text};

const HEIGHT: f64 = 402.0;
const NAME: &str = "ns-chain";
const SPECTRUM: &str = "ns-chain-spectrum";

const COLORS: [Color; 3] =
    [("x", "#a84600", "#ff9e64"), ("y", "#00775a", "#3fd0a0"), ("z", "#0060a8", "#58a6ff")];

/// The wavelengths that are drawn, in nm.
const FROM: u16 = 380;
const TO: u16 = 730;
/// The first wavelength of tables at 1 nm.
const FIRST: u16 = 360;
/// The lamp's table has this step, so its curve is drawn exactly.
const STEP: usize = 5;

/// The bands of the folded matrix.
const BANDS: usize = 16;

/// What the picture shows.
struct Scene {
    lamp: Fine<Power>,
    filter: Fine<Factor>,
    surface: Fine<Factor>,
    /// The eye that looks at a surface by this lamp through this filter, at 1 nm and folded. White paper has
    /// Y = 100 without the filter.
    fine: FineObserver<3, Factor>,
    folded: Observer<3, BANDS>,
    white: Xyz,
}

impl Scene {
    fn new() -> Self {
        let lamp = LED_B3.fine();
        let filter = Reflectance::<36, Nodes<380, 730>>::from_rgb(Rgb::<Srgb>::new(0.95, 0.85, 0.5)).fine();
        let eye = CIE_1931.under(&lamp).with_white_y(100.0);
        let fine = eye.through(&filter);
        Scene {
            lamp,
            filter,
            surface: TCS[7],
            fine,
            folded: fine.fold(Curve::Spline),
            white: Xyz::from(eye.sees(&Fine::flat(1.0))),
        }
    }

    /// The color of the surface as it is computed at 1 nm, and by the folded matrix.
    fn seen(&self) -> (Xyz, Xyz) {
        let coarse: Reflectance<BANDS> = self.surface.resample();
        (Xyz::from(self.fine.sees(&self.surface)), Xyz::from(self.folded.sees(&coarse)))
    }
}

/// Makes colors that belong to this white fit for a screen, whose white is that of sRGB.
fn to_daylight(white: Xyz) -> Adaptation {
    Adaptation::between_const::<Cat16>(white, Srgb::WHITE_XYZ)
}

/// The names of the rows of the matrix, and the classes of their colors.
const XYZ: [(&str, &str); 3] = [("X", "x"), ("Y", "y"), ("Z", "z")];

/// Where the diagram of one factor stands.
#[derive(Clone, Copy)]
struct Panel {
    x: f64,
    y: f64,
    width: f64,
    height: f64,
}

impl Panel {
    fn right(self) -> f64 {
        self.x + self.width
    }

    fn bottom(self) -> f64 {
        self.y + self.height
    }

    fn middle(self) -> f64 {
        self.x + 0.5 * self.width
    }

    /// A frame with the colors of the wavelengths below it.
    fn frame(self, class: &str) -> Group {
        let Panel { x, y, width, height } = self;
        let frame = Rectangle::new().set("x", x).set("y", y).set("width", width).set("height", height);
        let frame = filled(frame, class).set("fill-opacity", 0.07).set("stroke", "currentColor");
        let strip = Rectangle::new().set("x", x).set("y", self.bottom() + 3.0).set("width", width);
        Group::new()
            .add(frame.set("rx", 3).set("stroke-opacity", 0.7))
            .add(strip.set("height", 4).set("fill", format!("url(#{SPECTRUM})")))
    }

    /// The places of values at 1 nm, with `highest` at the top and 0 at the bottom.
    fn curve(self, values: &[f32], highest: f64) -> Vec<(f64, f64)> {
        let shown = values.iter().zip(FIRST..).skip(usize::from(FROM - FIRST)).step_by(STEP);
        let shown = shown.take_while(|(_, nm)| *nm <= TO);
        shown
            .map(|(value, nm)| {
                let x = self.x + self.width * f64::from(nm - FROM) / f64::from(TO - FROM);
                (x, self.bottom() - self.height * f64::from(*value) / highest)
            })
            .collect()
    }

    /// A bar from 0 for each value, with `lowest` at the bottom and `highest` at the top.
    fn bars(self, values: &[f32], lowest: f64, highest: f64) -> Path {
        let width = self.width / values.len() as f64;
        let y = |value: f64| self.bottom() - self.height * (value - lowest) / (highest - lowest);
        let bars = values.iter().enumerate().fold(Data::new(), |data, (k, value)| {
            data.move_to((round(self.x + width * k as f64 + 1.0), round(y(0.0))))
                .vertical_line_to(round(y(f64::from(*value))))
                .horizontal_line_by(round(width - 2.0))
                .vertical_line_to(round(y(0.0)))
        });
        Path::new().set("d", bars)
    }
}

/// Where the columns of the upper row begin, and their width.
const COLUMNS: [f64; 4] = [12.0, 164.0, 316.0, 468.0];
const COLUMN: f64 = 128.0;
/// Where the names of the results begin, the middle of the results, and where the patch of color begins.
const RESULTS: f64 = 621.0;
const RESULTS_MIDDLE: f64 = 668.0;
const PATCH: f64 = 693.0;

/// The panel of a column of the upper row.
const fn upper(column: usize) -> Panel {
    Panel { x: COLUMNS[column], y: 62.0, width: COLUMN, height: 84.0 }
}
/// The panels of the lower row.
const MATRIX: Panel = Panel { x: 12.0, y: 250.0, width: 432.0, height: 114.0 };
const NUMBERS: Panel = Panel { x: 468.0, y: 250.0, width: COLUMN, height: 114.0 };

/// The height of the line that joins what stays the same.
const BUS: f64 = 182.0;
/// The height of the line that leads the surface to its numbers.
const TURN: f64 = 216.0;

/// Draws the picture, as the text of a file.
pub fn chain() -> String {
    let scene = Scene::new();
    let (fine, folded) = scene.seen();
    let document = page(
        NAME,
        &format!(
            "Lamp, filter, surface and eye are multiplied at every wavelength. All but the surface fold into \
            one matrix of 3 by {BANDS} numbers."
        ),
        HEIGHT,
        &COLORS,
    )
    .add(Definitions::new().add(spectrum()))
    .add(
        title(12.0, 28.0, "From lamp to eye: multiply at every wavelength, then add up", "ink")
            .set("font-size", 19),
    )
    .add(factors(&scene))
    .add(eye())
    .add(joins())
    .add(matrix(&scene.folded))
    .add(numbers(&scene.surface))
    .add(results(fine, scene.white, upper(0)))
    .add(results(folded, scene.white, MATRIX))
    .add(label(RESULTS_MIDDLE, upper(0).y - 8.0, "color", "ink").set("text-anchor", "middle"))
    .add(label(RESULTS_MIDDLE, MATRIX.bottom() + 26.0, "same color", "ink").set("text-anchor", "middle"));
    text(&document)
}

/// Lamp, filter and surface, filled with the colors of the spectrum.
fn factors(scene: &Scene) -> Group {
    let curves: [(&str, &str, &[f32]); 3] = [
        ("lamp", "faint", scene.lamp.values()),
        ("filter", "faint", scene.filter.values()),
        ("surface", "violet", scene.surface.values()),
    ];
    let group = Group::new();
    curves.into_iter().enumerate().fold(group, |group, (column, (name, class, values))| {
        let panel = upper(column);
        let highest = if column == 0 { 1.05 * values.iter().fold(0.0, |a: f32, b| a.max(*b)) } else { 1.0 };
        let points = panel.curve(values, f64::from(highest));
        let area = joined(points.iter().copied())
            .line_to((panel.right(), panel.bottom()))
            .line_to((panel.x, panel.bottom()))
            .close();
        group
            .add(panel.frame(class))
            .add(Path::new().set("d", area).set("fill", format!("url(#{SPECTRUM})")).set("fill-opacity", 0.6))
            .add(stroke(joined(points), 1.5, "ink"))
            .add(heading(panel, name))
            .add(sign(panel.right() + 12.0, panel, "\u{d7}"))
    })
}

/// The color-matching functions.
fn eye() -> Group {
    let panel = upper(3);
    let group = Group::new().add(panel.frame("faint")).add(heading(panel, "eye"));
    let group =
        CIE_1931.weights().iter().zip(XYZ).fold(group, |group, (row, (_, class))| {
            group.add(stroke(joined(panel.curve(row, 1.9)), 2.5, class))
        });
    group.add(sign(panel.right() + 10.0, panel, "="))
}

/// The lines that lead from the upper row to the lower one.
fn joins() -> Group {
    let [lamp, filter, surface, eye] =
        [0, 1, 2, 3].map(|column| (upper(column).middle(), upper(column).bottom() + 9.0));
    // The line from the eye passes over the line from the surface in an arc.
    let fixed = Data::new()
        .move_to(eye)
        .vertical_line_to(BUS)
        .horizontal_line_to(surface.0 + 8.0)
        .elliptical_arc_to((8, 8, 0, 0, 0, surface.0 - 8.0, BUS))
        .horizontal_line_to(lamp.0)
        .move_to(lamp)
        .vertical_line_to(MATRIX.y - 9.0)
        .move_to(filter)
        .vertical_line_to(BUS);
    let changing = Data::new()
        .move_to(surface)
        .vertical_line_to(TURN)
        .horizontal_line_to(NUMBERS.middle())
        .vertical_line_to(NUMBERS.y - 9.0);
    Group::new()
        .add(stroke(fixed, 2.0, "faint"))
        .add(stroke(changing, 2.0, "violet"))
        .add(filled(arrow(lamp.0, MATRIX.y), "faint"))
        .add(filled(arrow(NUMBERS.middle(), NUMBERS.y), "violet"))
        .add(label(lamp.0 + 14.0, BUS + 25.0, "These stay the same:", "ink"))
        .add(label(lamp.0 + 14.0, BUS + 46.0, "fold them into one matrix.", "ink"))
        .add(label(surface.0 + 12.0, TURN - 9.0, "Only this changes.", "violet"))
}

/// The folded rows, a bar for each number.
fn matrix(folded: &Observer<3, BANDS>) -> Group {
    let rows = folded.weights();
    let highest = rows.iter().flatten().fold(0.0, |a: f32, b| a.max(*b));
    let lowest = rows.iter().flatten().fold(0.0, |a: f32, b| a.min(*b));
    let height = MATRIX.height / 3.0;
    let group = Group::new().add(MATRIX.frame("faint"));
    let group = rows.iter().zip(XYZ).enumerate().fold(group, |group, (row, (values, (name, class)))| {
        let y = MATRIX.y + height * row as f64;
        // A little air above and below.
        let strip =
            Panel { x: MATRIX.x + 26.0, y: y + 4.0, width: MATRIX.width - 30.0, height: height - 6.0 };
        let bars = strip.bars(values, f64::from(lowest), f64::from(highest));
        group.add(title(MATRIX.x + 8.0, y + height - 8.0, name, class)).add(filled(bars, class))
    });
    let says = format!("3 \u{d7} {BANDS} numbers, made by the compiler");
    group.add(below(MATRIX, &says)).add(sign(MATRIX.right() + 12.0, MATRIX, "\u{d7}"))
}

/// The surface as the matrix reads it.
fn numbers(surface: &Fine<Factor>) -> Group {
    let coarse: Reflectance<BANDS> = surface.resample();
    let strip = Panel { x: NUMBERS.x + 4.0, width: NUMBERS.width - 8.0, ..NUMBERS };
    Group::new()
        .add(NUMBERS.frame("violet"))
        .add(filled(strip.bars(coarse.values(), 0.0, 1.0), "violet"))
        .add(below(NUMBERS, &format!("{BANDS} numbers")))
        .add(sign(NUMBERS.right() + 10.0, NUMBERS, "="))
}

/// X, Y, Z and a patch of that color, at the height of a panel.
fn results(xyz: Xyz, white: Xyz, beside: Panel) -> Group {
    let middle = beside.y + 0.5 * beside.height;
    let color = Rgb::<Srgb>::from_xyz(to_daylight(white).apply(xyz)).encode().to_u8();
    let patch = Rectangle::new().set("x", PATCH).set("y", middle - 34.0).set("width", 22).set("height", 70);
    let group = Group::new().add(patch.set("rx", 3).set("fill", hex(color)));
    [xyz.x, xyz.y, xyz.z].into_iter().zip(XYZ).enumerate().fold(
        group,
        |group, (row, (value, (name, class)))| {
            let y = middle + 6.0 + 24.0 * (row as f64 - 1.0);
            let number = label(PATCH - 7.0, y, &format!("{value:.1}"), "ink").set("text-anchor", "end");
            group.add(title(RESULTS, y, name, class)).add(number)
        },
    )
}

/// The colors of the wavelengths, each as bright and as saturated as sRGB allows.
fn spectrum() -> LinearGradient {
    let gradient = LinearGradient::new().set("id", SPECTRUM);
    (FROM..=TO).step_by(25).fold(gradient, |gradient, nm| {
        let [x, y, z] = CIE_1931.weights().map(|row| row[usize::from(nm - FIRST)]);
        let rgb = Rgb::<Srgb>::from_xyz(Xyz::new(x, y, z)).to_array().map(|value| value.max(0.0));
        let highest = rgb.iter().fold(0.0, |a: f32, b| a.max(*b));
        let [r, g, b] = rgb.map(|value| value / highest);
        let offset = f64::from(nm - FROM) / f64::from(TO - FROM);
        let color = hex(Rgb::<Srgb>::new(r, g, b).encode().to_u8());
        gradient.add(Stop::new().set("offset", (1000.0 * offset).round() / 1000.0).set("stop-color", color))
    })
}

fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn title(x: f64, y: f64, text: &str, class: &str) -> Text {
    label(x, y, text, class).set("font-weight", 600)
}

/// A word above a panel.
fn heading(panel: Panel, text: &str) -> Text {
    label(panel.middle(), panel.y - 8.0, text, "ink").set("text-anchor", "middle")
}

/// Words below a panel.
fn below(panel: Panel, text: &str) -> Text {
    label(panel.middle(), panel.bottom() + 26.0, text, "ink").set("text-anchor", "middle")
}

/// An operator at the height of a panel.
fn sign(x: f64, panel: Panel, text: &str) -> Text {
    let y = panel.y + 0.5 * panel.height + 7.0;
    label(x, y, text, "ink").set("text-anchor", "middle").set("font-size", 22)
}

/// The head of an arrow that points down to (x, y).
fn arrow(x: f64, y: f64) -> Path {
    let data = Data::new().move_to((round(x), round(y - 2.0))).line_by((-6, -10)).line_by((12, 0)).close();
    Path::new().set("d", data)
}
