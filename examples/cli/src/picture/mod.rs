//! Draws the parts that the pictures of all commands share: pages, texts, patches, diagrams and spectra.

pub mod axis;
pub mod spectrum;

use crate::failure::printable;
use crate::output::tint;
use svg::Document;
use svg::node::element::{Group, Rectangle, Text};

const WIDTH: f32 = 1120.0;
pub const INK: &str = "#222222";
pub const FAINT: &str = "#777777";
pub const GRID: &str = "#dddddd";

/// The place of a diagram on the page.
#[derive(Clone, Copy)]
pub struct Area {
    pub left: f32,
    pub top: f32,
    pub width: f32,
    pub height: f32,
}

/// Returns an empty page with a heading.
pub fn page(height: f32, title: &str, subtitle: &str) -> Document {
    let heading = Group::new()
        .add(label(30.0, 42.0, title).set("font-size", 24).set("font-weight", "bold"))
        .add(label(30.0, 66.0, subtitle).set("fill", FAINT));
    Document::new()
        .set("viewBox", (0, 0, WIDTH, height))
        .set("width", WIDTH)
        .set("height", height)
        .set("font-family", "DejaVu Sans, Verdana, Helvetica, Arial, sans-serif")
        .set("font-size", 13)
        .add(Rectangle::new().set("width", WIDTH).set("height", height).set("fill", "#ffffff"))
        .add(heading)
}

/// Returns a text, without the characters that XML does not allow.
pub fn label(x: f32, y: f32, text: &str) -> Text {
    // SVG shows several blanks as one.
    let text = printable(text).replace("  ", "\u{a0}\u{a0}");
    Text::new(text).set("x", x).set("y", y).set("fill", INK)
}

/// Returns a rectangle that is filled with a color.
pub fn patch(area: Area, color: [u8; 3]) -> Rectangle {
    area.rectangle().set("fill", tint::hex(color)).set("stroke", GRID)
}

impl Area {
    pub fn rectangle(self) -> Rectangle {
        Rectangle::new()
            .set("x", self.left)
            .set("y", self.top)
            .set("width", self.width)
            .set("height", self.height)
    }
}
