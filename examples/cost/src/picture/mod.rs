//! The two pictures of the guide, as texts of SVG files: [`chain`] shows what a fold is, and [`frontier`]
//! what accuracy costs.
//!
//! Both are shown as images and are also inlined into pages of rustdoc. The style of an inlined picture
//! applies to the whole page, so each of its rules names the class of the picture. The colors follow the
//! system of the reader, or the theme of rustdoc on its pages.

pub mod chain;
pub mod frontier;

use svg::node::element::path::Data;
use svg::node::element::{Line, Path, Rectangle, Style, Text, Title};
use svg::{Document, Node};

/// Both pictures are as wide as the text of a page, in pixels. A narrower page shrinks them.
const WIDTH: f64 = 720.0;

/// A class with its color on a light page and on a dark one. [`filled`], [`stroke`] and [`line()`] draw in
/// the color of a class.
type Color = (&'static str, &'static str, &'static str);

/// The colors of both pictures. Here and in each picture the contrast with white and with the dark themes of
/// rustdoc is at least 4.5, as the Web Content Accessibility Guidelines ask for text.
const COLORS: [Color; 4] = [
    ("page", "#ffffff", "#0d1117"),
    ("ink", "#1f2328", "#f0f6fc"),
    ("faint", "#57606a", "#b1bac4"),
    ("violet", "#7c3aed", "#dfc4ff"),
];

/// A picture with nothing on it yet. Its background is filled where the picture is an image; on a page of
/// rustdoc the background of the page is seen.
fn page(name: &str, title: &str, height: f64, colors: &[Color]) -> Document {
    let background = Rectangle::new().set("width", WIDTH).set("height", height);
    Document::new()
        .set("class", name)
        .set("role", "img")
        .set("viewBox", format!("0 0 {WIDTH} {height}"))
        .set("width", WIDTH)
        .set("height", height)
        .set("font-family", "system-ui, -apple-system, 'Segoe UI', Roboto, Helvetica, Arial, sans-serif")
        .set("font-size", 17)
        .add(Title::new(title))
        .add(Style::new(style(name, &[&COLORS, colors].concat())))
        .add(filled(background, "page"))
}

/// The text of the file. No line of it may be empty, because an empty line ends a block of HTML in Markdown.
fn text(document: &Document) -> String {
    format!("{document}\n")
}

/// The style sheet: each color for light pages, for systems that are dark, and for the themes of rustdoc.
fn style(name: &str, colors: &[Color]) -> String {
    let light = |theme: &str| -> String {
        colors.iter().map(|(class, light, _)| format!("{theme}.{name} .{class}{{color:{light}}}\n")).collect()
    };
    let dark = |themes: &[&str]| -> String {
        let rule = |(class, _, dark): &Color| {
            let places: Vec<_> = themes.iter().map(|theme| format!("{theme}.{name} .{class}")).collect();
            format!("{}{{color:{dark}}}\n", places.join(","))
        };
        colors.iter().map(rule).collect()
    };
    [
        light(""),
        format!("@media (prefers-color-scheme:dark){{\n{}}}\n", dark(&[""])),
        light("html[data-theme=light] "),
        dark(&["html[data-theme=dark] ", "html[data-theme=ayu] "]),
        // Marked as important because rustdoc sets the width of everything on its pages.
        format!("html .{name}{{display:block;width:100%;height:auto;max-width:{WIDTH}px!important;"),
        "margin:0 0 1em}\n".to_owned(),
        format!("html .{name} .page{{fill:none}}"),
    ]
    .concat()
}

/// Fills an element with the color of a class.
fn filled<E: Node>(mut element: E, class: &str) -> E {
    element.assign("class", class);
    element.assign("fill", "currentColor");
    element
}

fn label(x: f64, y: f64, text: &str, class: &str) -> Text {
    filled(Text::new(text).set("x", round(x)).set("y", round(y)), class)
}

fn line((x1, y1): (f64, f64), (x2, y2): (f64, f64), class: &str) -> Line {
    let line =
        Line::new().set("x1", round(x1)).set("y1", round(y1)).set("x2", round(x2)).set("y2", round(y2));
    line.set("class", class).set("stroke", "currentColor")
}

/// Joins points by straight lines.
fn joined(points: impl IntoIterator<Item = (f64, f64)>) -> Data {
    points.into_iter().enumerate().fold(Data::new(), |data, (k, (x, y))| {
        let at = (round(x), round(y));
        if k == 0 { data.move_to(at) } else { data.line_to(at) }
    })
}

fn stroke(data: Data, width: f64, class: &str) -> Path {
    let path = Path::new().set("d", data).set("fill", "none").set("stroke-width", width);
    path.set("class", class).set("stroke", "currentColor").set("stroke-linejoin", "round")
}

/// Rounds to a tenth of a pixel, so that the file is the same on every machine.
fn round(value: f64) -> f64 {
    (value * 10.0).round() / 10.0
}
