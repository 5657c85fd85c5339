//! The functions of the module `upsample`.

use super::names::*;

pub fn all() {
    calls![
        upsample::Basis::<31, G, color::Srgb>::reflectance,
        upsample::Display::<31, G>::primaries,
        upsample::Display::<31, G>::emits,
        upsample::Display::<31, G>::xyz,
        upsample::Display::<31, G>::rgb,
        <Spectrum<Power, 3, color::RgbBands<color::Srgb>> as upsample::FromRgb<color::Srgb>>::from_rgb,
        <Spectrum<Factor, 31, G> as upsample::FromRgb<color::Srgb>>::from_rgb,
        <Spectrum<Power, 31> as upsample::FromRgb<color::Srgb>>::from_rgb,
        upsample::kubelka_munk::<31, G>,
        upsample::SigmoidIlluminant::on_grid::<31, G>,
        upsample::SigmoidReflectance::on_grid::<31, G>,
        upsample::SigmoidReflectance::at,
        upsample::SigmoidReflectance::to_texel,
        upsample::SigmoidReflectance::from_texel,
        upsample::SigmoidReflectance::gray,
        upsample::SigmoidUnbounded::on_grid::<31, G>,
        upsample::SigmoidUnbounded::at,
        upsample::CohenR::<31, Power, G>::fundamental,
        upsample::CohenR::<31, Power, G>::black,
        upsample::Shape::at,
        upsample::Sigmoid::<31, G, color::Srgb, upsample::CubicStart>::reflectance,
        upsample::Sigmoid::<31, G, color::Srgb, upsample::CubicStart>::desaturated,
        upsample::Sigmoid::<31, G, color::Srgb, upsample::CubicStart>::unbounded,
        upsample::Sigmoid::<31, G, color::Srgb, upsample::CubicStart>::illuminant,
        upsample::Sigmoid::<31, G, color::Srgb, upsample::CubicStart>::reflectance_8,
        upsample::Sigmoid::<31, G, color::Srgb, upsample::CubicStart>::reflectance_each,
        upsample::Sigmoid::<31, G, color::Srgb, upsample::CubicStart>::solve,
        upsample::Smits::<31, G>::reflectance::<color::Srgb>,
        upsample::Miss::delta_e,
        upsample::Miss::delta_e76,
        upsample::Viewing::<31, G, color::Srgb>::rgb,
        upsample::Viewing::<31, G, color::Srgb>::xyz,
        upsample::Viewing::<31, G, color::Srgb>::rgb_of_xyz,
        upsample::Viewing::<31, G, color::Srgb>::delta_e,
    ];
}
