//! The parts of a scene, in order.

use crate::grid::Bins;
use crate::path::scene::{IntoPart, Part};
use crate::path::{Effects, Price};

/// A path that is chosen at run time, by a slider in a web page or by a file: up to `CAP` parts, in the order
/// in which light meets them, in fixed memory. Where the path is known while compiling,
/// `lamp.through(&glass).onto(&vest)` is better: what cannot be does not compile.
///
/// A scene can be evaluated from the lamp on, part by part ([`leaving`](Self::leaving)), or from the eye
/// back: [`fold`](Self::fold) gives an observer that costs as much as any other.
///
/// ```
/// use nanospectra::matter::Dye;
/// use nanospectra::observer::CIE_1931;
/// use nanospectra::path::{Effects, Part, Scene};
/// use nanospectra::{Curve, Light, Observer, Power, Reflectance};
///
/// static EYE: Observer<3, 16, Power> = CIE_1931.fold(Curve::Step);
///
/// let window = Reflectance::<16>::flat(0.8);
/// // A vest: gray by itself, it absorbs blue and emits green.
/// let gray = Reflectance::flat(0.1);
/// let absorbs = Reflectance::at_centers(|nm| if nm < 480.0 { 0.8 } else { 0.0 });
/// let emits = Light::at_centers(|nm| if nm > 500.0 && nm < 560.0 { 1.0 } else { 0.0 });
/// let vest = Dye::new(&gray, &absorbs, &emits, 0.9)?;
/// let lamp = Light::flat(1.0);
///
/// let mut scene: Scene<16, 4> = Scene::new();
/// scene.push(Part::Filter(&window))?;
/// scene.push(&vest)?;
/// assert_eq!(scene.effects(), Effects::FLUORESCENCE);
///
/// let walked = EYE.sees(&scene.leaving(&lamp)?);
/// let folded = scene.fold(&EYE)?.sees(&lamp);
/// assert!((folded[1] / walked[1] - 1.0).abs() < 4e-7);
/// // 64 multiply-adds for the parts, where the folded eye has them in its weights.
/// assert_eq!(scene.price().multiply_adds, 16 + 3 * 16);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a, const N: usize, const CAP: usize, G = Bins<380, 730>> {
    steps: [Option<Step<'a, N, G>>; CAP],
}

/// A part, and whether its effect is left out.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step<'a, const N: usize, G> {
    pub(super) part: Part<'a, N, G>,
    pub(super) left_out: bool,
}

/// The reason why a part could not be pushed: the scene is full.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SceneFullError {
    /// How many parts there is room for.
    pub capacity: usize,
}

impl core::fmt::Display for SceneFullError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "the scene has room for {} parts", self.capacity)
    }
}

impl core::error::Error for SceneFullError {}

impl<'a, const N: usize, const CAP: usize, G> Scene<'a, N, CAP, G> {
    /// An empty scene: nothing stands between the lamp and the eye.
    #[must_use]
    pub const fn new() -> Self {
        Scene { steps: [const { None }; CAP] }
    }

    /// Puts a part behind the others: the one that the light meets last, before the eye.
    ///
    /// # Errors
    /// [`SceneFullError`]: there are `CAP` parts already.
    pub fn push(&mut self, part: impl IntoPart<'a, N, G>) -> Result<(), SceneFullError> {
        let free =
            self.steps.iter_mut().find(|step| step.is_none()).ok_or(SceneFullError { capacity: CAP })?;
        *free = Some(Step { part: part.into_part(), left_out: false });
        Ok(())
    }

    /// The parts, in the order in which light meets them.
    pub fn parts(&self) -> impl DoubleEndedIterator<Item = &Part<'a, N, G>> {
        self.steps().map(|step| &step.part)
    }

    /// This scene with the effect of part `k` (counted from 0) left out: a dye does not glow, a mirror dims
    /// all polarizations alike. Nothing changes where part `k` has no effect or does not exist.
    #[must_use]
    pub fn leaving_out(mut self, k: usize) -> Self {
        if let Some(Some(step)) = self.steps.get_mut(k) {
            step.left_out = !step.part.price().effects.is_empty();
        }
        self
    }

    /// The parts whose effect is left out, counted from 0.
    pub fn left_out(&self) -> impl Iterator<Item = usize> {
        self.steps().enumerate().filter(|(_, step)| step.left_out).map(|(k, _)| k)
    }

    /// The effects of all parts, without those that are left out.
    #[must_use]
    pub fn effects(&self) -> Effects {
        self.steps().fold(Effects::NONE, |effects, step| effects.and(step.price().effects))
    }

    pub(super) fn steps(&self) -> impl DoubleEndedIterator<Item = &Step<'a, N, G>> {
        self.steps.iter().flatten()
    }
}

impl<const N: usize, const CAP: usize, G> Default for Scene<'_, N, CAP, G> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const N: usize, G> Step<'_, N, G> {
    /// For light that is not followed as Stokes vectors.
    pub(super) fn price(&self) -> Price {
        if self.left_out { Price::factor(N) } else { self.part.price() }
    }
}
