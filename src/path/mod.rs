//! The light's path: lamp, filters, surfaces, and what an eye makes of them, written in that order.
//!
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
//! The stages are references, and nothing is computed until an observer looks: then one pass over the bins
//! evaluates the whole path. An effect that is not written costs nothing.
//!
//! * [`Plain`] light has one number for each bin. [`Spectrum`](crate::Spectrum)s of [`Factor`](crate::Factor)
//!   dim it; a [`Dye`](crate::matter::Dye), a [`Donaldson`](crate::matter::Donaldson) matrix, a
//!   [`Phosphor`](crate::matter::Phosphor) or an [`Effect`](crate::matter::Effect) of your own moves it
//!   between bins.
//! * [`Stokes`] light, from `polarized()` on, has four numbers for each bin, which
//!   [`Mirror`](crate::matter::Mirror)s, [`Polarizer`](crate::matter::Polarizer)s and
//!   [`Retarder`](crate::matter::Retarder)s mix. A matt surface makes it plain again; so does
//!   `ignoring_polarization()`, for an eye or by choice.
//! * In place of a grid [`RgbBands`](crate::color::RgbBands) are three bands: cheap, and off by what they
//!   say.
//! * A [`Scene`] is a path that is put together at run time. It says what its parts cost and which of them
//!   hardly show.
//!
//! The price of a path is known while compiling ([`Priced`]). A path that stays the same folds into the eye
//! in `const fn`, from the eye backwards; then looking along it costs no more than looking at a lamp:
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
//! // The vest, seen in the lake through the sheet, under the lamp with something before it.
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
//! A read-out that bends ([`DeadTime`](crate::sensor::DeadTime),
//! [`Nonlinearity`](crate::sensor::Nonlinearity)), saturates or is noisy comes after the eye and is no part
//! of a path: there linearity ends.
//!
//! # What does not compile
//!
//! The compiler's messages say what to write instead. Here this stands in the comments:
//!
//! ```compile_fail,E0277
//! # use nanospectra::{Light, matter::Mirror};
//! fn seen(sun: &Light<31>, lake: &Mirror<31>) { let _ = sun.onto(lake); } // sun.polarized().onto(lake)
//! ```
//! ```compile_fail,E0599
//! # use nanospectra::{Light, Observer, Power, matter::Dye};
//! fn seen(eye: &Observer<3, 31, Power>, lamp: &Light<31>, vest: &Dye<31>) {
//!     eye.under(lamp).looking_at_dye(vest); // eye.looking_at_dye(vest).under(lamp)
//! }
//! ```
//! ```compile_fail,E0277
//! # use nanospectra::{Bins, Light, Reflectance};
//! fn seen(sun: &Light<31>, glass: &Reflectance<31, Bins<400, 700>>) { let _ = sun.through(glass); } // resample()
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
