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
    pub filled: &'a [(f64, f64)],
    /// A dashed line besides, which may be empty.
    pub dashed: &'a [(f64, f64)],
    /// The highest value that the axis contains even if no curve reaches it. It also contains 0.
    pub high: f64,
}

/// Returns the points of a spectrum for drawing.
pub fn points(spectrum: &[(f32, f32)]) -> Vec<(f64, f64)> {
    spectrum.iter().map(|(nm, value)| (f64::from(*nm), f64::from(*value))).collect()
}

/// The share of the height by which a curve may leave the axis at its foot.
const SLIGHT: f64 = 0.01;

pub fn draw(area: Area, titles: [&str; 2], spectrum: &Spectrum) -> Group {
    let (Some(first), Some(last)) = (spectrum.filled.first(), spectrum.filled.last()) else {
        return Group::new();
    };
    let values = || spectrum.filled.iter().chain(spectrum.dashed).map(|point| point.1);
    let (low, high) = (values().fold(0.0, f64::min), values().fold(spectrum.high, f64::max));
    // What Sprague's rule or noise takes below zero may stand a little below the axis.
    let low = if low > -SLIGHT * high { 0.0 } else { low };
    let frame = Frame { area, x: Axis::between(first.0, last.0, 50.0), y: Axis::holding(low, high) };
    let base = |nm: f64| frame.place(nm, 0.0);
    let line_to = |data: Data, point: &(f64, f64)| data.line_to(frame.place(point.0, point.1));
    let outline = |points: &[(f64, f64)]| {
        let start = points.first().map_or((0.0, 0.0), |point| frame.place(point.0, point.1));
        let data = points.iter().fold(Data::new().move_to(start), line_to);
        Path::new().set("d", data).set("fill", "none").set("stroke-linejoin", "round")
    };
    let filled = spectrum.filled.iter().fold(Data::new().move_to(base(first.0)), line_to);
    let filled = filled.line_to(base(last.0)).close();
    let mut group = Group::new()
        .add(Definitions::new().add(rainbow(&frame, first.0, last.0)))
        .add(frame.draw(titles[0], titles[1]))
        .add(Path::new().set("d", filled).set("fill", "url(#rainbow)"))
        .add(outline(spectrum.filled).set("stroke", INK));
    if !spectrum.dashed.is_empty() {
        group = group.add(outline(spectrum.dashed).set("stroke", FAINT).set("stroke-dasharray", "5 3"));
    }
    group.add(frame.border())
}

/// Returns the gradient of the wavelengths' colors, from left to right.
fn rainbow(frame: &Frame, from: f64, to: f64) -> LinearGradient {
    let gradient = gradient("rainbow", (frame.place(from, 0.0).0, 0.0), (frame.place(to, 0.0).0, 0.0));
    (from as usize..=to as usize).step_by(COLOR_STEP).fold(gradient, |gradient, nm| {
        let share = (nm as f64 - from).max(0.0) / (to - from);
        gradient.add(stop(share as f32, tint::of_wavelength(nm as f32)))
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
