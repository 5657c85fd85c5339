//! A scene holds its parts in the order in which light meets them.

use crate::grid::Bins;
use crate::path::scene::{IntoPart, Part};
use crate::path::{Effects, Price};

/// A path that is put together at run time, as by a slider in a web page or from a file.
///
/// It holds references to up to `CAP` parts, in the order in which light meets them, in fixed memory. Start
/// with [`new`](Self::new) and [`push`](Self::push) the parts. Then either follow the light of a lamp
/// from part to part ([`leaving`](Self::leaving)), or [`fold`](Self::fold) the scene into an observer, which
/// then costs as much as any other observer.
///
/// Where the path is known while compiling, write `lamp.through(&glass).onto(&vest)` instead: then the
/// compiler refuses paths that have no meaning.
///
/// # Example
/// ```
/// use nanospectra::matter::Dye;
/// use nanospectra::observer::CIE_1931;
/// use nanospectra::path::{Effects, Part, Scene};
/// use nanospectra::{Curve, Light, Observer, Power, Reflectance};
///
/// static EYE: Observer<3, 16, Power> = CIE_1931.fold(Curve::Step);
///
/// let window = Reflectance::<16>::flat(0.8);
/// // A vest of dark gray cloth whose dye absorbs blue and emits green.
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
/// let seen = EYE.sees(&scene.leaving(&lamp)?);
/// let folded = scene.fold(&EYE)?.sees(&lamp);
/// assert!((folded[1] / seen[1] - 1.0).abs() < 4e-7);
/// // Following the light takes 64 multiply-adds for the parts. The folded eye has them in its weights.
/// assert_eq!(scene.price().multiply_adds, 16 + 3 * 16);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a, const N: usize, const CAP: usize, G = Bins<380, 730>> {
    steps: [Option<Step<'a, N, G>>; CAP],
}

/// A part together with whether its effect is left out.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step<'a, const N: usize, G> {
    pub(super) part: Part<'a, N, G>,
    pub(super) left_out: bool,
}

/// The error that [`Scene::push`] returns if the scene is full.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SceneFullError {
    /// How many parts the scene can hold.
    pub capacity: usize,
}

impl core::fmt::Display for SceneFullError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "the scene has room for {} parts", self.capacity)
    }
}

impl core::error::Error for SceneFullError {}

impl<'a, const N: usize, const CAP: usize, G> Scene<'a, N, CAP, G> {
    /// Returns an empty scene, in which nothing stands between the lamp and the observer.
    ///
    /// See the [example](#example).
    #[must_use]
    pub const fn new() -> Self {
        Scene { steps: [const { None }; CAP] }
    }

    /// Adds a part at the end, the one that the light meets last before it reaches the observer.
    ///
    /// See the [example](#example).
    ///
    /// # Errors
    /// Returns a [`SceneFullError`] if the scene holds `CAP` parts already.
    pub fn push(&mut self, part: impl IntoPart<'a, N, G>) -> Result<(), SceneFullError> {
        let free =
            self.steps.iter_mut().find(|step| step.is_none()).ok_or(SceneFullError { capacity: CAP })?;
        *free = Some(Step { part: part.into_part(), left_out: false });
        Ok(())
    }

    /// Returns the parts in the order in which light meets them.
    pub fn parts(&self) -> impl DoubleEndedIterator<Item = &Part<'a, N, G>> {
        self.steps().map(|step| &step.part)
    }

    /// Returns this scene with the effect of part `k` (counted from 0) left out: then a dye does not
    /// fluoresce, and a mirror dims all polarizations alike.
    ///
    /// Nothing changes if part `k` has no effect or does not exist.
    ///
    /// ```
    /// # use nanospectra::Light;
    /// # use nanospectra::matter::Polarizer;
    /// # use nanospectra::path::{PolarizationError, Scene};
    /// let sheet = Polarizer::ideal(0.0);
    /// let mut scene: Scene<31, 1> = Scene::new();
    /// scene.push(&sheet)?;
    /// let lamp = Light::flat(1.0);
    /// assert_eq!(scene.leaving(&lamp), Err(PolarizationError { part: 0 }));
    /// // A polarizer that dims all polarizations alike passes half of the light.
    /// let light = scene.leaving_out(0).leaving(&lamp)?;
    /// assert!((light.values()[0] - 0.5).abs() < 1e-6);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[must_use]
    pub fn leaving_out(mut self, k: usize) -> Self {
        if let Some(Some(step)) = self.steps.get_mut(k) {
            step.left_out = !step.part.price().effects.is_empty();
        }
        self
    }

    /// Returns the numbers, counted from 0, of the parts whose effect is left out.
    ///
    /// See the [example](Self::within_budget) of a budget.
    pub fn left_out(&self) -> impl Iterator<Item = usize> {
        self.steps().enumerate().filter(|(_, step)| step.left_out).map(|(k, _)| k)
    }

    /// Returns the effects of all parts except those that are left out. See the [example](#example).
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
    /// The price for light that is not followed as Stokes vectors.
    pub(super) fn price(&self) -> Price {
        if self.left_out { Price::factor(N) } else { self.part.price() }
    }
}
