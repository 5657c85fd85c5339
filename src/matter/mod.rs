//! What light meets: surfaces, films, volumes and fluorescent matter, each computed in every bin of a
//! spectrum.
//!
//! Use this module to find out which part of the light a material reflects, transmits, scatters or absorbs.
//! Most types give a [`Reflectance`](crate::Reflectance) (which is also the type of a transmittance), and
//! that is what a [path](crate::path) of light takes as a surface or a filter.
//!
//! # Example
//!
//! ```
//! use nanospectra::matter::{Dielectric, Glass, N_BK7, Reflector};
//! use nanospectra::{Light, Nodes};
//!
//! // What one face of a window of N-BK7 reflects at normal incidence.
//! let Some(index) = N_BK7.indices::<31, Nodes<400, 700>>() else { return };
//! let face = Dielectric::new(index).reflectance(1.0);
//! // At 590 nm the index is 1.5167, so that ((n - 1) / (n + 1))^2 = 4.22 % come back.
//! assert!((face[19] - 0.0422).abs() < 1e-4);
//! // A lamp that is mirrored in this face.
//! let mirrored = Light::flat(100.0).onto(&face).collected();
//! assert!((mirrored[19] - 4.22).abs() < 1e-2);
//! ```
//!
//! # What there is
//!
//! * **Smooth boundaries**: [`Dielectric`] and [`Conductor`] hold Fresnel's equations; a [`Glass`] formula
//!   gives the refractive index at each wavelength. [`Reflector`] is what all of them have in common.
//! * **Surfaces in a renderer**: a [`Brdf`] is a function of two directions. There are [`Lambert`],
//!   [`OrenNayar`], [`Microfacet`] and [`Smooth`]; [`scattering`] integrates and checks them.
//! * **Films**: [`ThinFilm`] is one layer that does not absorb, [`Stack`] any number of layers that may.
//! * **Volumes**: an [`Absorber`] is a medium that takes light out of a beam, a [`Slab`] a pane of it with
//!   both faces. [`Burley`] and [`Dipole`] describe light that leaves beside the point where it entered, and
//!   [`rayleigh_per_m`] what air scatters.
//! * **Fluorescence**: a [`Dye`] emits one spectrum, a [`Donaldson`] matrix describes any fluorescent matter,
//!   and a [`Phosphor`] goes on glowing when the light has gone. An [`Effect`] is one of your own.
//! * **Polarization**: a [`Mirror`], a [`Polarizer`] or a [`Retarder`] acts on light that is
//!   [`polarized()`](crate::Spectrum::polarized).
//! * **Test samples**: [`TCS`] and [`CES`] are the reflectances by which color rendering is judged.

mod effect;
mod film;
mod fluorescent;
mod polarizing;
mod surface;
mod volume;

pub use crate::test_samples::{CES, TCS};
pub use effect::{Effect, Foldable, Glows};
pub use film::*;
pub use fluorescent::*;
pub use polarizing::*;
pub use surface::*;
pub use volume::*;
