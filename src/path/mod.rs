//! Follows light from a lamp through filters and off surfaces to an observer, and computes what it sees.
//!
//! Use it where light meets matter once or several times on one way: a painted wall behind a window, a safety
//! vest in headlights, a reflection in water. Write the stages in the order in which the light meets them.
//!
//! # Example
//! ```
//! use nanospectra::observer::CIE_1931;
//! use nanospectra::{Curve, Light, Observer, Power, Reflectance};
//!
//! static EYE: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);
//! let (sun, glass, paper) = (Light::flat(1.0), Reflectance::flat(0.5), Reflectance::flat(0.8));
//! let xyz = EYE.sees(sun.through(&glass).onto(&paper));
//! // Half of the light gets through the glass and 80 % of that comes back from the paper.
//! assert!((xyz[1] - 0.4 * EYE.sees(&sun)[1]).abs() < 1e-4);
//! ```
//!
//! The stages are references. Filters and surfaces are evaluated when an observer looks, in one pass over the
//! bins for the whole path. An effect that no stage has costs no instruction and no byte.
//!
//! # The kinds of light
//!
//! * [`Plain`] light is unpolarized and has one number for each bin. A [`Spectrum`](crate::Spectrum) of
//!   [`Factor`](crate::Factor) multiplies it. A [`Dye`](crate::matter::Dye), a
//!   [`Donaldson`](crate::matter::Donaldson) matrix, a [`Phosphor`](crate::matter::Phosphor) or an
//!   [`Effect`](crate::matter::Effect) of your own (by [`Own`]) moves power between bins.
//! * [`Stokes`] light has four numbers for each bin. It starts at `polarized()`, and
//!   [`Mirror`](crate::matter::Mirror)s, [`Polarizer`](crate::matter::Polarizer)s and
//!   [`Retarder`](crate::matter::Retarder)s act on it. A matt surface makes it plain again, and so does
//!   `ignoring_polarization()`, which you call before an observer looks at it.
//! * Light on [`RgbBands`](crate::color::RgbBands) has three bands in place of a grid. It is cheap, and its
//!   documentation says how far its colors are off.
//!
//! A [`Scene`] is a path that is put together at run time. It lists what its parts cost and finds those whose
//! effect hardly shows. The [`Price`] of any other path is known while compiling ([`Priced`]).
//!
//! # Folding a path into an observer
//!
//! All of these stages are linear, so a path that stays the same can be multiplied into the weights of the
//! observer once. The crate calls this folding. The result is another [`Observer`](crate::Observer): to see a
//! lamp along the whole path then costs as much as to see the bare lamp. Folding goes backwards, from the
//! observer to the lamp, and is `const fn` for all matter of this crate:
//!
//! ```
//! use nanospectra::matter::{Dye, Mirror, Polarizer};
//! use nanospectra::{Bins, Light, Observer, Power, Reflectance, const_unwrap};
//!
//! type Grid = Bins<400, 700>;
//! const EYE: Observer<1, 3, Power, Grid> = Observer::from_rows([[0.1, 0.8, 0.3]]);
//! const LAMP: Light<3, Grid> = Light::from_bins([1.0, 0.6, 0.4]);
//! static SHEET: Polarizer<3, Grid> = Polarizer::ideal(0.0);
//! static LAKE: Mirror<3, Grid> = Mirror::dielectric(&[1.33; 3], 0.6, 0.0);
//! static VEST: Dye<3, Grid> = const_unwrap!(Dye::new(
//!     &Reflectance::from_bins([0.1, 0.8, 0.8]),
//!     &Reflectance::from_bins([0.8, 0.0, 0.0]),
//!     &Light::from_bins([0.0, 1.0, 0.0]),
//!     0.9,
//! ));
//! // A fluorescent vest, reflected by a lake and seen through a polarizer.
//! static FOLDED: Observer<1, 3, Power, Grid> = EYE
//!     .polarized()
//!     .through_polarizer(&SHEET)
//!     .looking_at_mirror(&LAKE)
//!     .unpolarized_light()
//!     .looking_at_dye(&VEST);
//!
//! let [folded] = FOLDED.sees(&LAMP);
//! let path = LAMP.onto(&VEST).polarized().onto(&LAKE).through(&SHEET).ignoring_polarization();
//! let [walked] = EYE.sees(path);
//! assert!((folded - walked).abs() < 4e-7 * walked);
//! ```
//!
//! What a sensor does after the light has reached it is not part of a path, since it is not linear: dead time
//! ([`DeadTime`](crate::sensor::DeadTime)), a curved response
//! ([`Nonlinearity`](crate::sensor::Nonlinearity)), saturation and noise.
//!
//! # What does not compile
//!
//! The compiler refuses paths that have no meaning, and its message says what to write instead. The comments
//! in these examples say the same.
//!
//! Unpolarized light cannot fall on a mirror before it is followed as Stokes vectors:
//! ```compile_fail,E0277
//! # use nanospectra::{Light, matter::Mirror};
//! fn seen(sun: &Light<31>, lake: &Mirror<31>) { let _ = sun.onto(lake); } // sun.polarized().onto(lake)
//! ```
//! An observer that a lamp has been folded into cannot look at fluorescent matter any more:
//! ```compile_fail,E0599
//! # use nanospectra::{Light, Observer, Power, matter::Dye};
//! fn seen(eye: &Observer<3, 31, Power>, lamp: &Light<31>, vest: &Dye<31>) {
//!     eye.under(lamp).looking_at_dye(vest); // eye.looking_at_dye(vest).under(lamp)
//! }
//! ```
//! All stages of a path lie on one grid:
//! ```compile_fail,E0277
//! # use nanospectra::{Bins, Light, Reflectance};
//! fn seen(sun: &Light<31>, glass: &Reflectance<31, Bins<400, 700>>) {
//!     let _ = sun.through(glass); // sun.through(&glass.resample())
//! }
//! ```

mod effect;
mod fold;
mod matter;
mod on_its_way;
mod plain;
mod polarized;
mod scene;

pub use crate::price::{Effects, Price, Priced, price_of};
pub use effect::{Affected, Excites, Glowing, Own};
pub use fold::PolarizedObserver;
pub use matter::{Filter, Surface};
pub use plain::{Plain, Times};
pub use polarized::{Dimmed, IgnoringPolarization, Natural, Polarized, Stokes, StokesPath, Turned};
pub use scene::{BillLine, IntoPart, Part, PolarizationError, Scene, SceneFullError, WithinBudget};
