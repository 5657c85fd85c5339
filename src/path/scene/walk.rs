//! Follows light through a scene, part by part.

use crate::matter::Mueller;
use crate::path::scene::parts::Step;
use crate::path::scene::{Part, PolarizationError, Scene};
use crate::spectrum::{Factor, Power, Spectrum};

/// Light between two parts of a scene. It is followed as Stokes vectors only from a part that polarizes to
/// the next part that scatters.
enum Beam<const N: usize> {
    Plain([f32; N]),
    Stokes([[f32; 4]; N]),
}

impl<const N: usize> Beam<N> {
    fn intensity(&self) -> [f32; N] {
        match self {
            Beam::Plain(light) => *light,
            Beam::Stokes(light) => light.map(|[intensity, ..]| intensity),
        }
    }

    fn dimmed<G>(self, factors: &Spectrum<Factor, N, G>) -> Self {
        match self {
            Beam::Plain(light) => Beam::Plain(times(light, factors)),
            Beam::Stokes(mut light) => {
                for (stokes, factor) in light.iter_mut().zip(&factors.0) {
                    *stokes = stokes.map(|value| value * factor);
                }
                Beam::Stokes(light)
            }
        }
    }

    fn after<G>(self, step: &Step<'_, N, G>) -> Self {
        match &step.part {
            Part::Filter(factors) => self.dimmed(factors),
            Part::Surface(factors) => Beam::Plain(times(self.intensity(), factors)),
            Part::Effect(matter) if step.left_out => {
                Beam::Plain(times(self.intensity(), &matter.without_effect()))
            }
            Part::Effect(matter) => Beam::Plain(matter.leaving(&Spectrum::unchecked(self.intensity())).0),
            part if step.left_out => self.dimmed(&part.without_effect()),
            Part::Polarizing { mueller, .. } => self.turned(mueller),
        }
    }

    fn turned<G>(self, element: &Mueller<N, G>) -> Self {
        let mut turned = [[0.0; 4]; N];
        match self {
            Beam::Plain(light) => {
                for (k, (out, value)) in turned.iter_mut().zip(&light).enumerate() {
                    *out = element.turn_natural(k, *value);
                }
            }
            Beam::Stokes(light) => {
                for (k, (out, stokes)) in turned.iter_mut().zip(&light).enumerate() {
                    *out = element.turn(k, *stokes);
                }
            }
        }
        Beam::Stokes(turned)
    }
}

fn times<const N: usize, G>(mut light: [f32; N], factors: &Spectrum<Factor, N, G>) -> [f32; N] {
    for (value, factor) in light.iter_mut().zip(&factors.0) {
        *value *= factor;
    }
    light
}

impl<const N: usize, const CAP: usize, G> Scene<'_, N, CAP, G> {
    /// Returns the light that reaches the observer when the unpolarized light of `lamp` enters the scene.
    ///
    /// See the [example](#example).
    ///
    /// # Errors
    /// Returns a [`PolarizationError`] if a mirror, a polarizer or a retarder is in the scene and its effect
    /// is not left out; [`leaving_polarized`](Self::leaving_polarized) computes what they do.
    pub fn leaving(&self, lamp: &Spectrum<Power, N, G>) -> Result<Spectrum<Power, N, G>, PolarizationError> {
        self.unpolarized()?;
        Ok(self.leaving_polarized(lamp))
    }

    /// Returns the light that reaches the observer, and follows it as Stokes vectors where parts polarize it.
    ///
    /// For a scene without such parts it returns what [`leaving`](Self::leaving) does.
    ///
    /// # Cost
    /// On a Cortex-M4F 31 bands take 3,100 bytes of stack at opt-level 3, and 3,060 at "s".
    #[must_use]
    pub fn leaving_polarized(&self, lamp: &Spectrum<Power, N, G>) -> Spectrum<Power, N, G> {
        let beam = self.steps().fold(Beam::Plain(lamp.0), Beam::after);
        Spectrum::unchecked(beam.intensity())
    }
}
