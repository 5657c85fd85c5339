//! Draws the frame of a diagram, with grid lines and numbers on linear scales.
//!
//! An [`Axis`] accepts every finite range of f64: it has few ticks whose numbers differ, and places on the
//! page are finite.

use super::{Area, FAINT, GRID, INK, label};
use crate::output::number;
use svg::node::element::{Group, Line, Rectangle};

/// The most grid lines of an axis.
const MOST_TICKS: f64 = 20.0;
/// The range below which, as a share of its larger end, its ends count as equal. The numbers of ticks would
/// else have more digits than there is room for.
const NARROWEST: f64 = 1e-6;
/// How far outside the axis a point can be, in lengths of the axis. That is off the page in any case.
const FARTHEST: f64 = 100.0;

/// A linear scale from the data to the page.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    /// The ends and the step between the numbers, which stand at its multiples, in units of the power of ten.
    from: f64,
    to: f64,
    step: f64,
    /// The power of ten in which large and tiny numbers are written, or 0.
    exponent: i32,
}

impl Axis {
    /// Returns a scale with these ends, for which `low < high`, and with a number at every multiple of
    /// `step`.
    pub fn between(low: f64, high: f64, step: f64) -> Self {
        let step = step.max((high - low) / MOST_TICKS);
        if low < high && step.is_finite() {
            Axis { from: low, to: high, step, exponent: 0 }
        } else {
            Axis::holding(low, high)
        }
    }

    /// Returns a scale that contains `low..=high` and ends on ticks of 1, 2 or 5 times a power of ten.
    ///
    /// The two numbers may be in any order. If they are equal, or nearly so, the scale reaches to half of
    /// them and to one and a half of them, or from 0 to 1 if they are 0.
    pub fn holding(low: f64, high: f64) -> Self {
        let [a, b] = [low, high].map(|end| if end.is_nan() { 0.0 } else { end.clamp(f64::MIN, f64::MAX) });
        let (low, high) = (a.min(b), a.max(b));
        let largest = low.abs().max(high.abs());
        if largest == 0.0 {
            return Axis { from: 0.0, to: 1.0, step: 0.2, exponent: 0 };
        }
        let is_narrow = high / largest - low / largest < NARROWEST;
        // (The halves are the range where the difference would exceed every number.)
        let steps = if is_narrow { largest / 5.0 } else { (high / 2.0 - low / 2.0) / 2.5 };
        let is_plain = largest < 1e5 && steps >= 1e-4;
        let exponent = if is_plain { 0 } else { largest.log10().floor() as i32 };
        let half = if is_narrow { 0.5 * scaled(largest, exponent) } else { 0.0 };
        let (low, high) = (scaled(low, exponent) - half, scaled(high, exponent) + half);
        let rough = (high - low) / 5.0;
        let power = 10f64.powf(rough.log10().floor());
        let step = [1.0, 2.0, 5.0].map(|k| k * power).into_iter().find(|step| *step >= rough);
        let step = step.unwrap_or(10.0 * power);
        // The tolerance keeps rounding from adding an empty step.
        let (from, to) = ((low / step + 1e-4).floor(), (high / step - 1e-4).ceil());
        Axis { from: from * step, to: to * step, step, exponent }
    }

    /// Returns the ticks, each with its share of the axis and its number as text.
    pub fn ticks(&self) -> Vec<(f64, String)> {
        let decimals = (-self.step.log10().floor()).max(0.0) as usize;
        // The tolerance is for ends that are ticks except for rounding.
        let (first, last) = ((self.from / self.step - 1e-4).ceil(), (self.to / self.step + 1e-4).floor());
        let ticks = (first as i64..=last as i64).map(|k| k as f64 * self.step);
        let share = |at: f64| (at - self.from) / (self.to - self.from);
        ticks.map(|at| (share(at), number::with_exponent(at, decimals, self.exponent))).collect()
    }

    /// Returns where a number of the data lies: 0 at the lower end of the axis and 1 at the upper one.
    ///
    /// What is far outside the axis is moved nearer, but stays off the page.
    pub fn share(&self, value: f64) -> f64 {
        let share = (scaled(value, self.exponent) - self.from) / (self.to - self.from);
        if share.is_nan() { -FARTHEST } else { share.clamp(-FARTHEST, FARTHEST) }
    }
}

/// Returns a number in units of a power of ten, which may itself exceed every number.
fn scaled(value: f64, exponent: i32) -> f64 {
    let half = exponent / 2;
    value / 10f64.powi(half) / 10f64.powi(exponent - half)
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
    pub fn place(&self, x: impl Into<f64>, y: impl Into<f64>) -> (f32, f32) {
        self.at(self.x.share(x.into()), self.y.share(y.into()))
    }

    fn at(&self, x: f64, y: f64) -> (f32, f32) {
        let Area { left, top, width, height } = self.area;
        (left + width * x as f32, top + height * (1.0 - y as f32))
    }

    /// Draws grid lines, numbers and titles. What is drawn later lies on top of them.
    pub fn draw(&self, x_title: &str, y_title: &str) -> Group {
        let Area { left, top, width, height } = self.area;
        let (right, bottom) = (left + width, top + height);
        let mut group = Group::new();
        for (at, text) in self.x.ticks() {
            let (x, _) = self.at(at, 0.0);
            group = group
                .add(line((x, top), (x, bottom)))
                .add(label(x, bottom + 18.0, &text).set("text-anchor", "middle").set("fill", FAINT));
        }
        for (at, text) in self.y.ticks() {
            let (_, y) = self.at(0.0, at);
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
