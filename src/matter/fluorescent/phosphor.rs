//! Phosphorescent matter, which goes on glowing when the light has gone.

use crate::grid::{Bins, by_fields};
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Double, Math};
use crate::matter::effect::glowing;
use crate::matter::{Dye, Effect, Glows};
use crate::observer::Stimulus;
use crate::price::{Effects, Price, Priced};
use crate::spectrum::{Power, Spectrum};

/// A dye that emits what it absorbed later, with one exponential decay, such as afterglow paint or the red
/// phosphor of a lamp.
///
/// It holds a state, the glow. Call [`step`](Self::step) to let time go by under a light. In a
/// [path](crate::path) it is a surface with the glow of this moment.
///
/// # Example
///
/// ```
/// # #[cfg(feature = "libm")] {
/// use nanospectra::matter::{Dye, Phosphor};
/// use nanospectra::{Bins, Light, Reflectance};
///
/// type Visible = Bins<400, 700>;
/// let (reflects, absorbs) = (Reflectance::<3, Visible>::flat(0.5), Reflectance::from_bins([0.5, 0.0, 0.0]));
/// let green = Light::from_bins([0.0, 1.0, 0.0]);
/// let mut paint = Phosphor::new(Dye::new(&reflects, &absorbs, &green, 0.9).unwrap(), 10.0);
/// let (lamp, dark) = (Light::flat(1.0), Light::flat(0.0));
/// paint.step(&lamp, 60.0);
/// let bright = dark.onto(&paint).collected();
/// paint.step(&dark, 10.0);
/// let faded = dark.onto(&paint).collected();
/// // One lifetime later it is 1 / e of what it was, and so is the glow.
/// assert!((faded.values()[1] / bright.values()[1] - 0.3679).abs() < 1e-4);
/// // Under a lamp that stays on, the glow grows to that of the dye.
/// paint.step(&lamp, 1000.0);
/// assert!((paint.glow() / paint.dye().glow_under(&lamp) - 1.0).abs() < 1e-6);
/// # }
/// ```
pub struct Phosphor<const N: usize, G = Bins<380, 730>> {
    dye: Dye<N, G>,
    lifetime_s: f32,
    glow: f32,
    /// The part of the glow that is below its last digit, so that very short steps add up.
    rest: f32,
}

by_fields!([const N: usize, G] Phosphor<N, G>, "Phosphor": dye, lifetime_s, glow, rest);

impl<const N: usize, G> Phosphor<N, G> {
    /// Makes a phosphor, dark at first, that absorbs and emits as `dye` does, but later.
    ///
    /// In the dark the glow falls to 1/e within `lifetime_s` seconds, 0 or more. See the [example](#example).
    #[must_use]
    pub const fn new(dye: Dye<N, G>, lifetime_s: f32) -> Self {
        Phosphor { dye, lifetime_s, glow: 0.0, rest: 0.0 }
    }

    /// Lets `duration_s` seconds go by under a light that does not change.
    ///
    /// Two steps have the same effect as one that is as long as both. A negative duration makes the glow NaN.
    /// A light whose glow would exceed f32 counts as half of `f32::MAX`. See the [example](#example).
    ///
    /// # Accuracy
    /// 6e-8 (2 + the number of lifetimes) of the glow that is left, in one step in the dark, and under a
    /// light 6e-8 (5 + the number of lifetimes) (searched in `tests/matter/worst_scattering.rs`). A million
    /// steps of 2^-26 lifetimes are off by 3e-8 from one as long as all (`tests/matter/fluorescence.rs`).
    #[cfg(feature = "libm")]
    pub fn step<S: Stimulus<Power, N, G>>(&mut self, light: S, duration_s: f32) {
        self.step_with::<Portable, S>(light, duration_s);
    }

    /// Returns the glow of this moment, which is the factor by which the emission spectrum is multiplied. See
    /// the [example](#example).
    #[must_use]
    pub const fn glow(&self) -> f32 {
        self.glow
    }

    /// Returns the dye, which emits at once what this phosphor emits later. See the [example](#example).
    #[must_use]
    pub const fn dye(&self) -> &Dye<N, G> {
        &self.dye
    }

    /// Does the same as [`step`](Self::step), on the math backend `M`.
    pub fn step_with<M: Math, S: Stimulus<Power, N, G>>(&mut self, light: S, duration_s: f32) {
        let lifetimes = match duration_s / self.lifetime_s {
            // With a lifetime of 0 the glow follows at once, and 0 / 0 would be NaN.
            _ if self.lifetime_s == 0.0 && duration_s >= 0.0 => f32::INFINITY,
            lifetimes if lifetimes >= 0.0 => lifetimes,
            _ => f32::NAN,
        };
        // An infinite glow would never fall, or become infinity times zero; half of the range leaves room for
        // rounding.
        let target = self.dye.glow_under(light).clamp(0.5 * f32::MIN, 0.5 * f32::MAX);
        let share = -M::expm1(-lifetimes);
        if lifetimes < 0.5 {
            // A short step may change the glow by less than its last digit, so the remainder is kept.
            let change = target * share - (self.glow * share - self.rest);
            let glow = Double::sum(self.glow, change);
            (self.glow, self.rest) = (glow.high, glow.low);
        } else {
            // After a long step little is left of the old glow, so no difference of large numbers is needed.
            self.glow = target * share + self.glow * M::exp(-lifetimes);
            self.rest = 0.0;
        }
    }
}

/// It emits with the glow of this moment, whatever light falls on it. It is therefore not linear in the light
/// and cannot be combined with an observer ([`Foldable`](crate::matter::Foldable)).
impl<const N: usize, G> Effect<N, G> for Phosphor<N, G> {
    #[inline]
    fn leaving(&self, light: &Spectrum<Power, N, G>) -> Spectrum<Power, N, G> {
        glowing(self, light)
    }
}

impl<const N: usize, G> Glows<N, G> for Phosphor<N, G> {
    #[inline]
    fn glow_in(&self, _: &Spectrum<Power, N, G>) -> f32 {
        self.glow
    }

    #[inline]
    fn leaving_bin(&self, k: usize, incoming: f32, glow: f32) -> f32 {
        self.dye.leaving_bin(k, incoming, glow)
    }
}

impl<const N: usize, G> Priced for Phosphor<N, G> {
    const PRICE: Price =
        Price { effects: Effects::PHOSPHORESCENCE, multiply_adds: 2 * N, bytes: 12 * N + 12 };
}
