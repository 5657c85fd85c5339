//! From power to what it does: lumens, non-visual stimulation, photons for plants; the quantities of
//! radiometry with their relations; solid angles and form factors. (Directions are in
//! [`geometry`](crate::geometry).)
//!
//! Six quantities, [`Energy`], [`Flux`], [`Intensity`], [`Irradiance`], [`Exitance`] and [`Radiance`], carry
//! [`Radiant`] (watts), [`Luminous`] (lumens) or [`Scotopic`] numbers, or a whole spectrum in watts for each
//! nanometer: `Irradiance<Light<16>>` is a spectral irradiance, `Irradiance<Luminous>` (or [`Lux`]) an
//! illuminance. They follow from each other by distance, area, solid angle and cosine, and radiance from
//! irradiance by a BRDF ([`PerSr`]); a quotient by zero is the largest f32, by a relation as by `/`;
//! quantities and units that do not belong together do not compile. (Which eye counts the lumens of a
//! spectrum is the caller's word: `luminous_by` takes any observer of one row for V(lambda).)
//!
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
pub use photon::ppfd;

pub use boundary::SurfaceRadiance;
pub use carried::{Carried, Luminous, Radiant, Scotopic};
pub use element::SurfaceElement;
pub use quantity::{
    Candela, Energy, Exitance, Flux, Intensity, Irradiance, Lumen, Lux, Nit, Radiance, Talbot,
};
pub use relations::PerSr;
pub use source::{DiskSource, PointSource, RectangleSource, SphereSource};
