//! Filters of readings at equal steps, made from analog ones by the bilinear transform.
//!
//! Each state is an integrator, so that numbers of 24 bits keep what a reading adds to it, however slow the
//! filter is. (The coefficients of the usual direct form lie near 1 and 2. To round them, for the low pass at
//! 50 000 readings a second, changes its gain by 0.34 %: `tests/sensor/light_flickermeter.rs`.)

use crate::math::{cos_turns, sin_turns};

/// Returns tan(pi f / rate), by which a filter has its corner at exactly the frequency f.
pub(super) const fn tangent(hz: f32, rate_hz: f32) -> f32 {
    let turns = 0.5 * hz / rate_hz;
    sin_turns(turns) / cos_turns(turns)
}

/// Removes the mean: s / (s + w).
#[derive(Clone, Debug)]
pub(super) struct HighPass {
    /// How much of the output is lost in a step, and how much of a difference enters it.
    loses: f32,
    keeps: f32,
    before: Option<f32>,
    out: f32,
}

impl HighPass {
    /// `corner` is tan(pi f / rate), as for all filters here.
    pub(super) const fn new(corner: f32) -> Self {
        let keeps = 1.0 / (1.0 + corner);
        HighPass { loses: 2.0 * corner * keeps, keeps, before: None, out: 0.0 }
    }

    /// The first reading is taken for the mean.
    pub(super) fn step(&mut self, reading: f32) -> f32 {
        let change = reading - self.before.unwrap_or(reading);
        self.before = Some(reading);
        self.out += self.keeps * change - self.loses * self.out;
        self.out
    }
}

/// The parts s / (s + w) and w / (s + w) of a signal.
#[derive(Clone, Debug)]
pub(super) struct FirstOrder {
    share: f32,
    state: f32,
}

impl FirstOrder {
    pub(super) const fn new(corner: f32) -> Self {
        FirstOrder { share: corner / (1.0 + corner), state: 0.0 }
    }

    pub(super) fn step(&mut self, input: f32) -> (f32, f32) {
        let half = self.share * (input - self.state);
        let low = self.state + half;
        self.state = low + half;
        (input - low, low)
    }
}

/// The parts s^2 / D, w s / D and w^2 / D of a signal, with D = s^2 + damping w s + w^2.
#[derive(Clone, Debug)]
pub(super) struct SecondOrder {
    damping: f32,
    /// What the two integrators add to the band.
    keeps: f32,
    corner: f32,
    states: [f32; 2],
}

impl SecondOrder {
    pub(super) const fn new(corner: f32, damping: f32) -> Self {
        let keeps = 1.0 / (1.0 + corner * (corner + damping));
        SecondOrder { damping, keeps, corner, states: [0.0; 2] }
    }

    pub(super) fn step(&mut self, input: f32) -> [f32; 3] {
        let [first, second] = self.states;
        let band = self.keeps * (first + self.corner * (input - second));
        let low = second + self.corner * band;
        self.states = [2.0 * band - first, 2.0 * low - second];
        [input - self.damping * band - low, band, low]
    }
}
