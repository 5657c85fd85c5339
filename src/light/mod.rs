//! Spectra of light sources: the illuminants that the CIE tabulates, daylight of any color temperature, and
//! black bodies.
//!
//! Use this module where a calculation needs a light that is known rather than measured: to judge surfaces
//! under D65, to compare a lamp with its nominal data, or to test a program. Each illuminant is a static on
//! the grid on which it was published; call [`fine`](crate::Spectrum::fine) to bring it to 1 nm, or
//! [`resample`](crate::Spectrum::resample) to bring it to your own bins.
//!
//! # Example
//! ```
//! use nanospectra::color::{Cct, Xyz};
//! use nanospectra::observer::CIE_1931;
//! use nanospectra::{Bins, Fine, Light, Power, light};
//!
//! // FL11, a three-band fluorescent lamp; CIE 15 has x = 0.3805, y = 0.3769 and 4000 K.
//! let lamp: Fine<Power> = light::FL11.fine();
//! let xyz = Xyz::from(CIE_1931.sees(&lamp));
//! let xy = xyz.xy().ok_or("black")?;
//! assert!((xy.x - 0.3805).abs() < 1e-4 && (xy.y - 0.3769).abs() < 3e-4);
//! let Some(Cct::Near { cct_k, .. }) = xyz.cct() else { return Err("no color temperature") };
//! assert!((cct_k - 4000.0).abs() < 5.0);
//!
//! // The same lamp in 31 bins of a renderer has the same power in these bins.
//! let bins: Light<31, Bins<400, 710>> = light::FL11.resample();
//! assert!((bins.power() / light::FL11.resample::<310, Bins<400, 710>>().power() - 1.0).abs() < 1e-6);
//!
//! // A light that the user of a program names, and daylight of 6504 K, whose table is that of D65.
//! let d65 = light::named("D65").ok_or("no such illuminant")?;
//! let daylight = light::daylight(6504.0).ok_or("out of range")?;
//! assert!(daylight.iter().all(|(nm, power)| {
//!     nm < 360.0 || (power - d65.values()[nm as usize - 360]).abs() < 0.1
//! }));
//! # Ok::<(), &str>(())
//! ```
//!
//! # Where the numbers come from
//! The illuminants are tables of the CIE. Their files lie in the folder `tables/illuminants` of the
//! repository and of the package. The build script, `tables/build.rs`, reads these CSV files and writes
//! `illuminants.rs` into the build directory; `src/light/illuminants.rs` includes that file. The source of a
//! static is therefore generated code, and the numbers are easier to read in the CSV file:
//!
//! | statics | what they are | file in `tables/illuminants` |
//! |---|---|---|
//! | [`A`] | a tungsten filament lamp | `A_1nm.csv` |
//! | [`C`] | a filtered tungsten lamp that imitates daylight | `C_5nm.csv` |
//! | [`D50`], [`D65`] | daylight | `D50_1nm.csv`, `D65_1nm.csv` |
//! | [`D55`], [`D75`] | daylight | `D55_5nm.csv`, `D75_5nm.csv` |
//! | [`ID50`], [`ID65`] | daylight behind window glass | `ID50_5nm.csv`, `ID65_5nm.csv` |
//! | [`FL1`] to [`FL6`] | standard fluorescent lamps | `FL_5nm.csv` |
//! | [`FL7`] to [`FL9`] | broad-band fluorescent lamps | `FL_5nm.csv` |
//! | [`FL10`] to [`FL12`] | three-band fluorescent lamps | `FL_5nm.csv` |
//! | [`FL3_1`] to [`FL3_3`] | standard halophosphate fluorescent lamps | `FL_5nm.csv` |
//! | [`FL3_4`] to [`FL3_6`] | DeLuxe fluorescent lamps | `FL_5nm.csv` |
//! | [`FL3_7`] to [`FL3_11`] | three-band fluorescent lamps | `FL_5nm.csv` |
//! | [`FL3_12`] to [`FL3_14`] | multi-band fluorescent lamps | `FL_5nm.csv` |
//! | [`FL3_15`] | a fluorescent lamp that simulates D65 | `FL_5nm.csv` |
//! | [`HP1`], [`HP2`] | high-pressure sodium lamps, the second color-enhanced | `HP_5nm.csv` |
//! | [`HP3`] to [`HP5`] | high-pressure metal halide lamps | `HP_5nm.csv` |
//! | [`LED_B1`] to [`LED_B5`] | blue LEDs with a phosphor | `LED_5nm.csv` |
//! | [`LED_BH1`] | a blue LED with a phosphor, and a red LED | `LED_5nm.csv` |
//! | [`LED_RGB1`] | red, green and blue LEDs | `LED_5nm.csv` |
//! | [`LED_V1`], [`LED_V2`] | violet LEDs with phosphors | `LED_5nm.csv` |
//! | [`L41`] | the white LED for calibrating photometers | `L41_1nm.csv` |
//! | names that end in `_1NM` | second tables of the FL and LED lamps | `FL_1nm.csv`, `LED_1nm.csv` |
//! | [`S0`], [`S1`], [`S2`] | the components of daylight | `daylight_components_5nm.csv` |
//!
//! The head of each file and `tables/SOURCES.md` name the publication and the license, CC BY-SA 4.0. A static
//! takes flash only in a program that reads it.
//!
//! The color temperatures and chromaticities in the documentation of the statics are computed from these
//! tables, interpolated linearly to 1 nm. Those that the CIE prints are rounded, and some are sums of 5 nm:
//! FL5 has 6343 K here, and 6350 K in CIE 15.

mod blackbody;
mod daylight;
mod illuminants;

#[cfg(feature = "libm")]
pub use blackbody::{blackbody, blackbody_relative};
pub use blackbody::{blackbody_exitance, blackbody_peak_nm, blackbody_relative_with, blackbody_with};
pub use daylight::{Daylight, daylight, daylight_xy};
pub use illuminants::*;

#[cfg(feature = "libm")]
pub(crate) use blackbody::{C2_COLOR_NM, relative as blackbody_shape};
#[cfg(feature = "libm")]
pub(crate) use daylight::{factors as daylight_factors, spectrum as daylight_at};
