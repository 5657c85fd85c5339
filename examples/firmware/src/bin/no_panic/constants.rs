//! The functions that compute in f64, most of which are meant for constants.

use crate::calls;
use nanospectra::{Bins, Nodes, Power};
use nanospectra::{color, math, matter, observer, sensor, upsample};

type G = Bins<380, 730>;
type H = Nodes<400, 700>;

pub fn all() {
    calls![
        color::Adaptation::between_const::<color::Bradford>,
        matter::Donaldson::<31, 496, G>::new,
        matter::Dye::<31, G>::new,
        observer::Observer::<3, 31, Power, G>::with_white_y,
        observer::Observer::<3, 31, Power, G>::scaled,
        observer::Observer::<3, 31, Power, G>::mixed::<3>,
        observer::Observer::<3, 31, Power, G>::row_sums,
        observer::Observer::<3, 31, Power, G>::fold::<16, H>,
        observer::Observer::<3, 31, Power, G>::looking_at_dye,
        observer::Observer::<3, 31, Power, G>::looking_at_donaldson::<496>,
        sensor::chip::Chip::nominal::<31, G>,
        sensor::fixed::FixedMeter::<8>::new,
        sensor::fixed::FixedMeter::<8>::new_above,
        sensor::fixed::FixedObserver::<8, 31, G>::new::<Power>,
        sensor::gaussian_responsivities::<8, 31, G>,
        upsample::Basis::<31, G, color::Srgb>::new,
        upsample::Display::<31, G>::new,
        upsample::Display::<31, G>::balanced,
        upsample::Display::<31, G>::led,
        upsample::Display::<31, G>::lcd,
        upsample::CohenR::<31, Power, G>::new,
        upsample::Sigmoid::<31, G, color::Srgb, upsample::CubicStart>::new,
        upsample::Smits::<31, G>::new,
        <upsample::Smits<31, G> as Default>::default,
        upsample::Viewing::<31, G, color::Srgb>::new,
    ];
    // These are there to compare with.
    calls![
        <math::Libm as math::Math>::cbrt,
        <math::Libm as math::Math>::cos_turns,
        <math::Libm as math::Math>::sin_turns,
    ];
}
