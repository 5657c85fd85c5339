//! Finds the effects of a scene that hardly show, and leaves them out.

use crate::color::{ParametricFactors, Xyz, ciede2000_with};
use crate::math::Math;
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::observer::Observer;
use crate::path::scene::Scene;
use crate::spectrum::{Power, Spectrum};

/// A scene from which [`Scene::within_budget`] has left out effects that hardly show.
#[derive(Clone, Copy, Debug)]
pub struct WithinBudget<S> {
    /// The scene that remains; [`left_out`](Scene::left_out) says which parts have lost their effect.
    pub scene: S,
    /// How much its color differs from the scene with all effects, in CIEDE2000; 0 if none is left out.
    pub delta_e: f32,
}

impl<const N: usize, const CAP: usize, G> Scene<'_, N, CAP, G> {
    /// Returns the color difference CIEDE2000 between this scene and another one, as this observer sees them
    /// under this lamp.
    ///
    /// The white of CIELAB is the color of the bare lamp. If that cannot be a white (see [`Xyz::lab`]), the
    /// difference is NaN.
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn difference(
        &self,
        other: &Self,
        eye: &Observer<3, N, Power, G>,
        lamp: &Spectrum<Power, N, G>,
    ) -> f32 {
        self.difference_with::<Portable>(other, eye, lamp)
    }

    /// Returns the color difference as `difference` does, computed by the functions of the math backend `M`.
    #[must_use]
    pub fn difference_with<M: Math>(
        &self,
        other: &Self,
        eye: &Observer<3, N, Power, G>,
        lamp: &Spectrum<Power, N, G>,
    ) -> f32 {
        let white = Xyz::from(eye.sees(lamp));
        let lab = |scene: &Self| Xyz::from(eye.sees(&scene.leaving_polarized(lamp))).lab_with::<M>(white);
        match (lab(self), lab(other)) {
            (Some(this), Some(that)) => ciede2000_with::<M>(this, that, ParametricFactors::default()),
            _ => f32::NAN,
        }
    }

    /// Leaves out effects that this observer would hardly miss under this lamp, and returns the scene that
    /// remains.
    ///
    /// Effects that save most multiply-adds are left out first, as long as the
    /// [`difference`](Self::difference) that all of them make *together* is at most `budget_delta_e`. Of
    /// effects that save as much, the first part goes. In the scene that remains no single effect could be
    /// left out as well. (Two of them could be, if their differences happened to cancel.)
    ///
    /// Call it again when the lamp or a part changes: a dye that does not show under a red lamp may be bright
    /// under a blue one.
    ///
    /// # Cost
    /// Light is followed through the scene twice for each part with an effect, and all of that again for each
    /// effect that is left out. On a Cortex-M4F 31 bands take 3,880 bytes of stack at opt-level 3, and 3,530
    /// at "s".
    ///
    /// ```
    /// use nanospectra::matter::{Dye, Retarder};
    /// use nanospectra::observer::CIE_1931;
    /// use nanospectra::path::Scene;
    /// use nanospectra::{Curve, Light, Observer, Power, Reflectance};
    ///
    /// static EYE: Observer<3, 16, Power> = CIE_1931.fold(Curve::Step);
    /// let blue = Reflectance::at_centers(|nm| if nm < 480.0 { 0.8 } else { 0.0 });
    /// let green = Light::at_centers(|nm| if nm > 500.0 && nm < 560.0 { 1.0 } else { 0.0 });
    /// let vest = Dye::new(&Reflectance::flat(0.1), &blue, &green, 0.9)?;
    /// let plate = Retarder::flat(0.25, 0.125); // a retarder alone changes no color
    /// let mut scene: Scene<16, 2> = Scene::new();
    /// scene.push(&vest)?;
    /// scene.push(&plate)?;
    ///
    /// let found = scene.within_budget(&EYE, &Light::flat(1.0), 0.5);
    /// assert!(found.scene.left_out().eq([1]) && found.delta_e == 0.0);
    /// // Without fluorescence the vest would look different: that takes a larger budget.
    /// let found = scene.within_budget(&EYE, &Light::flat(1.0), 50.0);
    /// assert!(found.scene.left_out().eq([0, 1]) && found.delta_e > 1.0);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[cfg(feature = "libm")]
    #[must_use]
    pub fn within_budget(
        &self,
        eye: &Observer<3, N, Power, G>,
        lamp: &Spectrum<Power, N, G>,
        budget_delta_e: f32,
    ) -> WithinBudget<Self>
    where
        G: Copy,
    {
        self.within_budget_with::<Portable>(eye, lamp, budget_delta_e)
    }

    /// Leaves out effects as `within_budget` does, computed by the functions of the math backend `M`.
    #[must_use]
    pub fn within_budget_with<M: Math>(
        &self,
        eye: &Observer<3, N, Power, G>,
        lamp: &Spectrum<Power, N, G>,
        budget_delta_e: f32,
    ) -> WithinBudget<Self>
    where
        G: Copy,
    {
        let mut found = WithinBudget { scene: *self, delta_e: 0.0 };
        loop {
            let mut next: Option<WithinBudget<Self>> = None;
            for line in found.scene.bill().filter(|line| !line.price.effects.is_empty()) {
                let scene = found.scene.leaving_out(line.part);
                let delta_e = self.difference_with::<M>(&scene, eye, lamp);
                let price = scene.price().multiply_adds;
                let saves_most = next.as_ref().is_none_or(|next| price < next.scene.price().multiply_adds);
                // The comparison is false for NaN, so an effect that cannot be judged stays.
                if delta_e <= budget_delta_e && saves_most {
                    next = Some(WithinBudget { scene, delta_e });
                }
            }
            match next {
                Some(next) => found = next,
                None => return found,
            }
        }
    }
}
