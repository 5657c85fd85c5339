//! The spectrum, filled with the colours of its wavelengths.

use super::axis::{Axis, Frame};
use super::{Area, INK};
use crate::args::Unit;
use crate::measure::{Bench, Reading};
use crate::tint;
use svg::node::element::path::Data;
use svg::node::element::{Definitions, Group, LinearGradient, Path, Stop};

/// What is drawn, in nm; the tables begin at 360.
const FIRST: usize = 380;
const LAST: usize = 780;
/// Colour changes every so many nm.
const COLOR_STEP: usize = 4;

pub fn draw(area: Area, bench: &Bench, reading: &Reading) -> Group {
    let (values, title) = ordinates(bench, reading);
    let shown = &values[FIRST - 360..=LAST - 360];
    let low = shown.iter().copied().fold(0.0, f32::min);
    let high = shown.iter().copied().fold(0.0, f32::max);
    let (low, high) = if low < high { (low, high) } else { (0.0, 1.0) };
    let x = Axis { from: FIRST as f32, to: LAST as f32, step: 50.0 };
    let frame = Frame { area, x, y: Axis::holding(low, high) };

    let points: Vec<(f32, f32)> =
        shown.iter().zip(FIRST..).map(|(value, nm)| frame.place(nm as f32, *value)).collect();
    let base = frame.place(FIRST as f32, 0.0).1;
    let mut outline = Data::new().move_to(points[0]);
    let mut filled = Data::new().move_to((points[0].0, base));
    for point in &points {
        outline = outline.line_to(*point);
        filled = filled.line_to(*point);
    }
    filled = filled.line_to((points[points.len() - 1].0, base)).close();

    Group::new()
        .add(Definitions::new().add(rainbow(&frame)))
        .add(frame.draw("wavelength / nm", &title))
        .add(Path::new().set("d", filled).set("fill", "url(#rainbow)"))
        .add(
            Path::new()
                .set("d", outline)
                .set("fill", "none")
                .set("stroke", INK)
                .set("stroke-linejoin", "round"),
        )
        .add(frame.border())
}

/// The numbers to draw, and what they are.
fn ordinates(bench: &Bench, reading: &Reading) -> (Vec<f32>, String) {
    let times = |k: f64| reading.curve.values().iter().map(|value| (f64::from(*value) * k) as f32).collect();
    match (&bench.room, bench.unit) {
        (Some(_), _) => (times(1.0), "reflectance".into()),
        (None, Unit::Absolute) => (times(reading.scale()), "W / m² / nm".into()),
        (None, Unit::Relative) => {
            let peak = reading.curve.values().iter().copied().fold(0.0, f32::max);
            (times(1.0 / f64::from(peak)), "relative spectral power".into())
        }
    }
}

/// Left to right the colours of the wavelengths.
fn rainbow(frame: &Frame) -> LinearGradient {
    let (from, _) = frame.place(FIRST as f32, 0.0);
    let (to, _) = frame.place(LAST as f32, 0.0);
    let gradient = LinearGradient::new()
        .set("id", "rainbow")
        .set("gradientUnits", "userSpaceOnUse")
        .set("x1", from)
        .set("x2", to)
        .set("y1", 0)
        .set("y2", 0);
    (FIRST..=LAST).step_by(COLOR_STEP).fold(gradient, |gradient, nm| {
        let share = (nm - FIRST) as f32 / (LAST - FIRST) as f32;
        let color = tint::hex(tint::of_wavelength(nm as f32));
        gradient.add(Stop::new().set("offset", share).set("stop-color", color))
    })
}
