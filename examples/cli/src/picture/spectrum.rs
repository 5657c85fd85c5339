//! Draws a spectrum as a diagram that is filled with the colors of its wavelengths.

use super::axis::{Axis, Frame};
use super::{Area, FAINT, INK};
use crate::output::tint;
use svg::node::element::path::Data;
use svg::node::element::{Definitions, Group, LinearGradient, Path, Stop};

/// The step, in nm, at which the color changes.
const COLOR_STEP: usize = 4;

/// The curves to draw, as pairs of a wavelength in nm and a value.
#[derive(Default)]
pub struct Spectrum<'a> {
    pub filled: &'a [(f32, f32)],
    /// A dashed line besides, which may be empty.
    pub dashed: &'a [(f32, f32)],
    /// The lowest value that the axis contains.
    pub low: f32,
    pub high: f32,
}

pub fn draw(area: Area, titles: [&str; 2], spectrum: &Spectrum) -> Group {
    let (Some(first), Some(last)) = (spectrum.filled.first(), spectrum.filled.last()) else {
        return Group::new();
    };
    let x = Axis { from: first.0, to: last.0, step: 50.0 };
    let frame = Frame { area, x, y: Axis::holding(spectrum.low, spectrum.high) };
    let base = |nm: f32| frame.place(nm, 0.0);
    let line_to = |data: Data, point: &(f32, f32)| data.line_to(frame.place(point.0, point.1));
    let outline = |points: &[(f32, f32)]| {
        let start = points.first().map_or((0.0, 0.0), |point| frame.place(point.0, point.1));
        let data = points.iter().fold(Data::new().move_to(start), line_to);
        Path::new().set("d", data).set("fill", "none").set("stroke-linejoin", "round")
    };
    let filled = spectrum.filled.iter().fold(Data::new().move_to(base(first.0)), line_to);
    let filled = filled.line_to(base(last.0)).close();
    let mut group = Group::new()
        .add(Definitions::new().add(rainbow(&frame)))
        .add(frame.draw(titles[0], titles[1]))
        .add(Path::new().set("d", filled).set("fill", "url(#rainbow)"))
        .add(outline(spectrum.filled).set("stroke", INK));
    if !spectrum.dashed.is_empty() {
        group = group.add(outline(spectrum.dashed).set("stroke", FAINT).set("stroke-dasharray", "5 3"));
    }
    group.add(frame.border())
}

/// Returns the gradient of the wavelengths' colors, from left to right.
fn rainbow(frame: &Frame) -> LinearGradient {
    let (from, to) = (frame.x.from, frame.x.to);
    let gradient = gradient("rainbow", (frame.place(from, 0.0).0, 0.0), (frame.place(to, 0.0).0, 0.0));
    (from as usize..=to as usize).step_by(COLOR_STEP).fold(gradient, |gradient, nm| {
        let share = (nm as f32 - from).max(0.0) / (to - from);
        gradient.add(stop(share, tint::of_wavelength(nm as f32)))
    })
}

/// Returns a gradient from one point of the page to another.
pub fn gradient(id: &str, from: (f32, f32), to: (f32, f32)) -> LinearGradient {
    LinearGradient::new()
        .set("id", id)
        .set("gradientUnits", "userSpaceOnUse")
        .set("x1", from.0)
        .set("y1", from.1)
        .set("x2", to.0)
        .set("y2", to.1)
}

pub fn stop(share: f32, color: [u8; 3]) -> Stop {
    Stop::new().set("offset", share).set("stop-color", tint::hex(color))
}
