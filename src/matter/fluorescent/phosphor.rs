//! Matter that glows on after the light has gone.

use crate::grid::{Bins, by_fields};
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::math::{Double, Math};
use crate::matter::effect::glowing;
use crate::matter::{Dye, Effect, Glows};
use crate::observer::Stimulus;
use crate::price::{Effects, Price, Priced};
use crate::spectrum::{Power, Spectrum};

/// A dye that emits what it absorbed later, by one exponential decay: afterglow paint, the red of a lamp's
/// phosphor.
///
/// It holds its state, the glow; as a surface in a path it is that of the moment.
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
/// // One lifetime later it is 1 / e of what it was.
/// assert!((faded.values()[1] / bright.values()[1] - 0.3679).abs() < 1e-4);
/// # }
/// ```
pub struct Phosphor<const N: usize, G = Bins<380, 730>> {
    dye: Dye<N, G>,
    lifetime_s: f32,
    glow: f32,
    /// What the last digit of `glow` left out, so that steps below it add up.
    rest: f32,
}

by_fields!([const N: usize, G] Phosphor<N, G>, "Phosphor": dye, lifetime_s, glow, rest);

impl<const N: usize, G> Phosphor<N, G> {
    /// What emits as `dye` does, dark so far; the glow falls to 1/e in `lifetime_s` seconds, zero or more.
    #[must_use]
    pub const fn new(dye: Dye<N, G>, lifetime_s: f32) -> Self {
        Phosphor { dye, lifetime_s, glow: 0.0, rest: 0.0 }
    }

    /// The dye: what this would be without a memory.
    #[must_use]
    pub const fn dye(&self) -> &Dye<N, G> {
        &self.dye
    }

    /// The glow of this moment: the number the emission is multiplied with.
    #[must_use]
    pub const fn glow(&self) -> f32 {
        self.glow
    }

    /// Lets `duration_s` seconds (zero or more; NaN below) go by under a light that does not change.
    ///
    /// Two steps are the same as one as long as both. Light beyond what f32 can add up counts as half of
    /// `f32::MAX`.
    ///
    /// # Accuracy
    /// 6e-8 (2 + the number of lifetimes) of the glow that is left, in one step. A million steps of 2^-26
    /// lifetimes are off by 3e-8 from one as long as all (`tests/matter/fluorescence.rs`).
    #[cfg(feature = "libm")]
    pub fn step<S: Stimulus<Power, N, G>>(&mut self, light: S, duration_s: f32) {
        self.step_with::<Portable, S>(light, duration_s);
    }

    /// [`step`](Self::step) by the functions of `M`.
    pub fn step_with<M: Math, S: Stimulus<Power, N, G>>(&mut self, light: S, duration_s: f32) {
        let lifetimes = match duration_s / self.lifetime_s {
            // Without a lifetime it is there at once, and 0 / 0 is no number of lifetimes.
            _ if self.lifetime_s == 0.0 && duration_s >= 0.0 => f32::INFINITY,
            lifetimes if lifetimes >= 0.0 => lifetimes,
            _ => f32::NAN,
        };
        // (An infinite glow would stay one, or become infinity times zero; and roundings need room.)
        let target = self.dye.glow_under(light).clamp(0.5 * f32::MIN, 0.5 * f32::MAX);
        let share = -M::expm1(-lifetimes);
        if lifetimes < 0.5 {
            // Short steps may be less than the last digit of the glow: what is rounded off is kept.
            let change = target * share - (self.glow * share - self.rest);
            let glow = Double::sum(self.glow, change);
            (self.glow, self.rest) = (glow.high, glow.low);
        } else {
            // After long ones little is left of the glow, which is no difference.
            self.glow = target * share + self.glow * M::exp(-lifetimes);
            self.rest = 0.0;
        }
    }
}

/// It emits the glow of this moment, whatever light falls on it. So it is not linear in the light, and does
/// not fold.
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
