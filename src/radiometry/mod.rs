//! Computes how much light there is, how it spreads from a source to a surface, and what it does there.
//!
//! This is the module for a lighting bench, a light meter or a renderer that reports in lux and cd/m2.
//!
//! # What a measured spectrum does
//!
//! A spectral irradiance with 1 nm steps, a [`Fine<Power>`](crate::Fine) in W/(m2 nm), is converted
//!
//! * to lux by [`illuminance`], and for the dark-adapted eye by [`scotopic_illuminance`];
//! * to photons for plants by [`ppfd`] and [`photon_flux`];
//! * to the alpha-opic irradiances of the five kinds of photoreceptors, and from these to melanopic EDI and
//!   DER, by [`AlphaOpic`] (CIE S 026);
//! * to its luminous efficacy of radiation (LER), in lm/W, by [`luminous_efficacy`].
//!
//! # Quantities with units
//!
//! | quantity | radiant unit | luminous unit | luminous type | says |
//! |---|---|---|---|---|
//! | [`Energy`] | J | lm s | [`Talbot`] | how much light there is in a pulse |
//! | [`Flux`] | W | lm | [`Lumen`] | how much a lamp emits in a second |
//! | [`Intensity`] | W/sr | cd | [`Candela`] | how much a small source emits in a direction |
//! | [`Irradiance`] | W/m2 | lx | [`Lux`] | how much arrives at a surface |
//! | [`Exitance`] | W/m2 | lm/m2 | | how much leaves a surface |
//! | [`Radiance`] | W/(m2 sr) | cd/m2 | [`Nit`] | how bright a surface looks from a direction |
//!
//! Each of them carries a [`Radiant`], a [`Luminous`] or a [`Scotopic`] number, or a whole spectrum in watts
//! per nanometer: `Irradiance<Light<16>>` is a spectral irradiance, and `Irradiance<Luminous>`, or [`Lux`],
//! an illuminance. Start with `new`, or with `From<f32>` for a single number.
//!
//! Methods lead from one quantity to another by distance, area, solid angle or the cosine of an angle. A BRDF
//! makes radiance of irradiance ([`PerSr`]). What would be infinite after a division by zero is the largest
//! f32 instead. Directions and integrals over the hemisphere are in [`geometry`](crate::geometry), the
//! geometry of sources in [`solid_angle`] and [`form_factor`].
//!
//! # Example
//! ```
//! use nanospectra::radiometry::{Flux, Radiance, form_factor};
//! use nanospectra::{Curve, Light, Observer, Power, observer::V_PHOTOPIC};
//!
//! static V: Observer<1, 16, Power> = V_PHOTOPIC.fold(Curve::Spline);
//!
//! // 20 W of white light (380..730 nm) from a panel of 0.36 m2, on a desk 2 m below its middle.
//! let panel = Flux::new(Light::<16>::flat(20.0 / 350.0));
//! let radiance: Radiance<_> = panel.exitance(0.36).lambertian();
//! let on_desk = radiance.through_form_factor(form_factor::to_disk(0.339, 2.0, 0.0));
//! assert_eq!(format!("{:.2}", on_desk.radiant()), "1.55 W/m2");
//! assert_eq!(format!("{:.0}", on_desk.luminous_by(&V)), "324 lx");
//! ```
//!
//! # What the compiler refuses
//!
//! Quantities and units that do not belong together are different types. An illuminance is not an intensity:
//!
//! ```compile_fail
//! # use nanospectra::radiometry::{Candela, Lux};
//! let sum = Lux::from(300.0) + Candela::from(100.0);
//! ```
//!
//! Watts are not lumens:
//!
//! ```compile_fail
//! # use nanospectra::radiometry::{Irradiance, Lux, Radiant};
//! let sum = Lux::from(300.0) + Irradiance::new(Radiant(1.0));
//! ```
//!
//! What arrives at a surface is not what leaves it:
//!
//! ```compile_fail
//! # use nanospectra::radiometry::{Exitance, Irradiance, Radiant};
//! let sum = Irradiance::new(Radiant(1.0)) + Exitance::new(Radiant(1.0));
//! ```
//!
//! The compiler cannot check which eye counts the lumens of a spectrum: `luminous_by` accepts any observer
//! with one row, and relies on its caller to pass V(lambda).

mod alpha_opic;
mod luminous;
mod photon;

mod boundary;
mod carried;
mod element;
mod quantity;
mod relations;
mod source;

pub mod form_factor;
mod off_axis_disk;
pub mod solid_angle;

pub use alpha_opic::AlphaOpic;
pub use luminous::{illuminance, luminous_efficacy, scotopic_illuminance};
pub use photon::{photon_flux, ppfd};

pub use boundary::SurfaceRadiance;
pub use carried::{Carried, Luminous, Radiant, Scotopic};
pub use element::SurfaceElement;
pub use quantity::{
    Candela, Energy, Exitance, Flux, Intensity, Irradiance, Lumen, Lux, Nit, Radiance, Talbot,
};
pub use relations::PerSr;
pub use source::{DiskSource, PointSource, RectangleSource, SphereSource};
