//! Eyes and sensors that turn a spectrum into numbers: [`Observer`], and the CIE's standard observers.
//!
//! Use this module to get X, Y and Z of a light or of a surface, the responses of cones, luminous quantities,
//! or the counts of a sensor. [`Observer::sees`] computes them; [`Observer::fold`] makes an observer that
//! needs few numbers of each spectrum.
//!
//! # Example
//! ```
//! use nanospectra::color::Xyz;
//! use nanospectra::observer::{CIE_1931, CIE_1964, KM, V_PHOTOPIC};
//! use nanospectra::{Curve, Fine, Light, Observer, Power, light};
//!
//! // The chromaticity of illuminant D65 for fields of 2 and of 10 degrees (CIE 15).
//! let lamp: Fine<Power> = light::D65.fine();
//! let two = Xyz::from(CIE_1931.sees(&lamp)).xy().ok_or("black")?;
//! let ten = Xyz::from(CIE_1964.sees(&lamp)).xy().ok_or("black")?;
//! assert!((two.x - 0.3127).abs() < 5e-5 && (two.y - 0.3290).abs() < 5e-5);
//! assert!((ten.x - 0.3138).abs() < 5e-5 && (ten.y - 0.3310).abs() < 5e-5);
//!
//! // A program that measures 16 bands needs an observer of 16 bands. The compiler makes it from the 1 nm
//! // table, so the program contains 192 bytes.
//! static EYE: Observer<3, 16, Power> = CIE_1931.fold(Curve::Spline);
//! assert_eq!(size_of_val(&EYE), 192);
//! let [x, y, z] = EYE.sees(&Light::flat(1.0));
//! // Equal energy is white: x = y = 1/3.
//! assert!((x / y - 1.0).abs() < 1e-3 && (z / y - 1.0).abs() < 1e-3);
//!
//! // Luminous flux: 1 W at 555 nm is 683 lm.
//! let mut laser = Fine::<Power>::flat(0.0);
//! assert_eq!(laser.add_line(555.0, 1.0), 0.0); // nothing is lost
//! let [watts_seen] = V_PHOTOPIC.sees(&laser);
//! assert!((KM * watts_seen - 683.0).abs() < 0.01);
//! # Ok::<(), &str>(())
//! ```
//!
//! # Where the numbers come from
//! The standard observers are tables of the CIE. Their files lie in the folder `tables/cmf` of the repository
//! and of the package. The build script, `tables/build.rs`, reads these CSV files and writes `observers.rs`
//! into the build directory; `src/observer/cie.rs` includes that file. The source of a static is therefore
//! generated code, and the numbers are easier to read in the CSV file:
//!
//! | static | file in `tables/cmf` |
//! |---|---|
//! | [`CIE_1931`] | `cie_1931_2deg_xyz_1nm.csv` |
//! | [`CIE_1964`] | `cie_1964_10deg_xyz_1nm.csv` |
//! | [`CIE_2015_2`] | `cie_2015_2deg_xyz_1nm.csv` |
//! | [`CIE_2015_10`] | `cie_2015_10deg_xyz_1nm.csv` |
//! | [`CIE_2006_LMS_2`] | `cie_2006_2deg_lms_5nm_official.csv` |
//! | [`CIE_2006_LMS_10`] | `cie_2006_10deg_lms_5nm_official.csv` |
//! | [`V_PHOTOPIC`] | `v_photopic_1nm.csv` |
//! | [`V_SCOTOPIC`] | `v_scotopic_1nm.csv` |
//! | [`ALPHA_OPIC`] | `alpha_opic_s026_1nm.csv` |
//!
//! The head of each file and `tables/SOURCES.md` name the publication and the license, CC BY-SA 4.0.

// The documentation of `Observer` lists methods in the order of these modules, so what one calls first stands
// first. Empty lines keep rustfmt from sorting them.
mod rows;

mod fold;

mod cie;

mod stimulus;

pub use cie::*;
pub use fold::Curve;
pub use rows::{FineObserver, Observer};
pub use stimulus::Stimulus;
