//! The functions of spectra and of samples.

use super::names::*;

pub fn all() {
    calls![
        Spectrum::<Power, 31, G>::from_samples,
        Spectrum::<Power, 31, G>::from_samples_outside,
        Spectrum::<Power, 31, G>::interpolated,
        Spectrum::<Power, 31, G>::interpolated_outside,
        Spectrum::<Power, 31, G>::from_bins,
        Spectrum::<Power, 31, G>::flat,
        Spectrum::<Power, 31, G>::values,
        Spectrum::<Power, 31, G>::values_mut,
        Spectrum::<Power, 31, G>::peak,
        Spectrum::<Power, 31, G>::at_centers as fn(fn(f32) -> f32) -> _,
        Spectrum::<Power, 31, G>::averaged as fn(fn(f32) -> f32) -> _,
        Spectrum::<Power, 31, G>::edge_nm,
        Spectrum::<Power, 31, G>::center_nm,
        Spectrum::<Power, 31, G>::within,
        Spectrum::<Power, 31, G>::power,
        Spectrum::<PerBin, 31, G>::total,
        Spectrum::<PerBin, 31, G>::density,
        Spectrum::<Power, 31, G>::fine,
        Spectrum::<Power, 31, G>::interpolate::<16, H>,
        Spectrum::<Power, 31, G>::interpolate_outside::<16, H>,
        Spectrum::<Power, 31, G>::resample::<16, H>,
        Spectrum::<Power, 31, G>::resample_outside::<16, H>,
        Spectrum::<Power, 31, G>::add_line,
        Spectrum::<Power, 31, G>::clamp,
        Spectrum::<Power, 31, G>::lerp,
        Spectrum::<Power, 31, G>::max,
        Spectrum::<Power, 31, G>::min,
        Spectrum::<Power, 31, G>::is_black,
        Spectrum::<Factor, 31, G>::sqrt,
        Spectrum::<Factor, 31, G>::exp,
        Spectrum::<Factor, 31, G>::exp_with::<Fast>,
        Spectrum::<Power, 31, G>::through::<&'static Spectrum<Factor, 31>>,
        Spectrum::<Power, 31, G>::onto::<&'static matter::Dye<31>>,
        Spectrum::<Power, 31, G>::polarized,
        Spectrum::<Power, 3, color::RgbBands<color::Srgb>>::to_rgb,
        Spectrum::<Power, 31, G>::from_rgb::<color::Srgb>,
        <Spectrum<Power, 31> as Default>::default,
        Samples::<8>::new,
        Samples::<8>::push,
        Samples::<8>::as_slice,
        Samples::<8>::clear,
    ];
    walks![Spectrum::<Power, 31, G>::iter,];
    operators![
        Spectrum<Power, 31>,
    ];
}
