//! The functions of the module `light`.

use super::names::*;

pub fn all() {
    calls![
        light::blackbody,
        light::blackbody_relative,
        light::blackbody_exitance,
        light::blackbody_peak_nm,
        light::blackbody_relative_with::<Fast>,
        light::blackbody_with::<Fast>,
        light::daylight,
        light::daylight_xy,
        light::named,
        light::interpolated,
    ];
}
