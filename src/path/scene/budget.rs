//! Effects that hardly show, left out.

use crate::color::{ParametricFactors, Xyz, ciede2000_with};
use crate::math::Math;
#[cfg(feature = "libm")]
use crate::math::Portable;
use crate::observer::Observer;
use crate::path::scene::Scene;
use crate::spectrum::{Power, Spectrum};

/// A scene within a color-difference budget: which effects are left out, and what that costs in all.
#[derive(Clone, Copy, Debug)]
pub struct WithinBudget<S> {
    /// The scene; it says which parts are [`left_out`](Scene::left_out).
    pub scene: S,
    /// CIEDE2000 to the scene with all its effects; 0 if none is left out.
    pub delta_e: f32,
}

impl<const N: usize, const CAP: usize, G> Scene<'_, N, CAP, G> {
    /// How different another scene looks to this eye under this lamp: CIEDE2000, where the white of CIELAB is
    /// that of the bare lamp. NaN if that is no white (see [`Xyz::lab`]).
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

    /// [`difference`](Self::difference) by the functions of `M`.
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

    /// This scene without the effects that this eye would hardly miss under this lamp: those that save most
    /// multiply-adds first, as long as all that is left out *together* makes a
    /// [`difference`](Self::difference) of `budget_delta_e` at most. No other effect could be left out as
    /// well by itself; two might, together.
    ///
    /// A lamp or part that changes needs a new answer: what does not show under a red lamp may shine under a
    /// blue one.
    ///
    /// # Cost
    /// The scene is walked twice for each part with an effect, and that again for each that is left out.
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
    /// let plate = Retarder::flat(0.25, 0.125); // alone: nothing tells it
    /// let mut scene: Scene<16, 2> = Scene::new();
    /// scene.push(&vest)?;
    /// scene.push(&plate)?;
    ///
    /// let found = scene.within_budget(&EYE, &Light::flat(1.0), 0.5);
    /// assert!(found.scene.left_out().eq([1]) && found.delta_e == 0.0);
    /// // The vest is worth more than that: to leave it out as well, the budget has to be large.
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

    /// [`within_budget`](Self::within_budget) by the functions of `M`.
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
                // (Also false for NaN: what cannot be judged stays.)
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
