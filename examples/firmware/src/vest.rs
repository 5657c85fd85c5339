//! A fluorescent yellow vest and a lamp, which the compiler computes for the images with paths.

use nanospectra::light::FL11;
use nanospectra::matter::Dye;
use nanospectra::{Interpolation, Light, Reflectance, const_unwrap};

/// The light of FL11 at the centers of 31 bands.
pub static LAMP: Light<31> = FL11.interpolate(Interpolation::Linear);

/// A dye that absorbs blue (up to 490 nm) and emits green (500 to 580 nm).
pub static VEST: Dye<31> = {
    let (mut reflects, mut absorbs, mut emits) = ([0.1; 31], [0.0; 31], [0.0; 31]);
    let mut k = 0;
    while k < 31 {
        let nm = Light::<31>::center_nm(k);
        if nm < 490.0 {
            absorbs[k] = 0.8;
        } else {
            reflects[k] = 0.85;
        }
        if nm > 500.0 && nm < 580.0 {
            emits[k] = (580.0 - nm) / 80.0;
        }
        k += 1;
    }
    let (reflects, absorbs) = (Reflectance::from_bins(reflects), Reflectance::from_bins(absorbs));
    const_unwrap!(Dye::new(&reflects, &absorbs, &Light::from_bins(emits), 0.9))
};
