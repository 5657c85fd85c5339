//! Draws the frame of a diagram, with grid lines and numbers on linear scales.

use super::{Area, FAINT, GRID, INK, label};
use svg::node::element::{Group, Line, Rectangle};

/// A linear scale from the data to the page.
#[derive(Clone, Copy)]
pub struct Axis {
    pub from: f32,
    pub to: f32,
    /// The step between the numbers, which stand at its multiples.
    pub step: f32,
}

impl Axis {
    /// Returns a scale that contains `low..=high` and ends on ticks of 1, 2 or 5 times a power of ten.
    pub fn holding(low: f32, high: f32) -> Self {
        let rough = (high - low) / 5.0;
        let power = 10f32.powf(rough.log10().floor());
        let step =
            [1.0, 2.0, 5.0].into_iter().map(|k| k * power).find(|s| *s >= rough).unwrap_or(10.0 * power);
        // The tolerance keeps rounding from adding an empty step.
        let (from, to) = ((low / step + 1e-4).floor(), (high / step - 1e-4).ceil());
        Axis { from: from * step, to: to * step, step }
    }

    /// Returns the ticks, each with its number as text.
    fn ticks(self) -> Vec<(f32, String)> {
        let decimals = (-self.step.log10().floor()).max(0.0) as usize;
        let plain = self.to.abs() < 1e5 && decimals <= 4;
        // The tolerance is for ends that are ticks except for rounding.
        let (first, last) = ((self.from / self.step - 1e-4).ceil(), (self.to / self.step + 1e-4).floor());
        let ticks = (first as i32..=last as i32).map(|k| k as f32 * self.step);
        ticks
            .map(|at| (at, if plain || at == 0.0 { format!("{at:.decimals$}") } else { format!("{at:.0e}") }))
            .collect()
    }

    fn share(self, value: f32) -> f32 {
        (value - self.from) / (self.to - self.from)
    }
}

/// A frame with an axis below and an axis at the left.
#[derive(Clone, Copy)]
pub struct Frame {
    pub area: Area,
    pub x: Axis,
    pub y: Axis,
}

impl Frame {
    /// Returns the place on the page of a point of the data.
    pub fn place(&self, x: f32, y: f32) -> (f32, f32) {
        let Area { left, top, width, height } = self.area;
        (left + width * self.x.share(x), top + height * (1.0 - self.y.share(y)))
    }

    /// Draws grid lines, numbers and titles. What is drawn later lies on top of them.
    pub fn draw(&self, x_title: &str, y_title: &str) -> Group {
        let Area { left, top, width, height } = self.area;
        let (right, bottom) = (left + width, top + height);
        let mut group = Group::new();
        for (at, text) in self.x.ticks() {
            let (x, _) = self.place(at, self.y.from);
            group = group
                .add(line((x, top), (x, bottom)))
                .add(label(x, bottom + 18.0, &text).set("text-anchor", "middle").set("fill", FAINT));
        }
        for (at, text) in self.y.ticks() {
            let (_, y) = self.place(self.x.from, at);
            group = group
                .add(line((left, y), (right, y)))
                .add(label(left - 8.0, y + 4.5, &text).set("text-anchor", "end").set("fill", FAINT));
        }
        let middle = top + height / 2.0;
        let upright = format!("rotate(-90 {} {middle})", left - 52.0);
        group
            .add(label(left + width / 2.0, bottom + 40.0, x_title).set("text-anchor", "middle"))
            .add(label(left - 52.0, middle, y_title).set("text-anchor", "middle").set("transform", upright))
    }

    /// Draws the border, which comes last.
    pub fn border(&self) -> Rectangle {
        self.area.rectangle().set("fill", "none").set("stroke", INK)
    }
}

fn line(from: (f32, f32), to: (f32, f32)) -> Line {
    Line::new().set("x1", from.0).set("y1", from.1).set("x2", to.0).set("y2", to.1).set("stroke", GRID)
}
