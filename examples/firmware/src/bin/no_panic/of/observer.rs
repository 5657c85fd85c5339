//! The functions of the module `observer`.

use super::names::*;

pub fn all() {
    calls![
        observer::Observer::<3, 31, Power, G>::sees::<&'static Light<31>>,
        observer::Observer::<3, 31, Power, G>::sees_each,
        observer::Observer::<3, 31, Power, G>::through,
        observer::Observer::<3, 31, Power, G>::looking_at,
        observer::Observer::<3, 31, Power, G>::under,
        observer::Observer::<3, 31, Power, G>::from_rows,
        observer::Observer::<3, 31, Power, G>::from_weights,
        observer::Observer::<3, 31, Power, G>::weights,
        observer::Observer::<3, 31, Power, G>::standard,
        observer::Observer::<3, 31, Power, G>::looking_at_matter::<matter::Dye<31>>,
        observer::Observer::<3, 31, Power, G>::polarized,
        observer::Observer::<3, 31, Factor, G>::delta_e,
        <&'static Spectrum<Power, 31> as observer::Stimulus<Power, 31, G>>::at,
        <&'static Spectrum<Power, 31> as observer::Stimulus<Power, 31, G>>::read::<f32> as fn(_, fn(&Light<31>) -> f32) -> _,
        <path::Glowing<&'static Light<31>, &'static matter::Dye<31>> as observer::Stimulus<Power, 31, G>>::at,
        <path::Affected<&'static Light<31>, &'static matter::Donaldson<31, 496>, 31, G> as observer::Stimulus<Power, 31, G>>::at,
        <path::Affected<&'static Light<31>, &'static matter::Donaldson<31, 496>, 31, G> as observer::Stimulus<Power, 31, G>>::read::<f32> as fn(_, fn(&Light<31>) -> f32) -> _,
        <path::Times<Lit, &'static Spectrum<Factor, 31, G>> as observer::Stimulus<Power, 31, G>>::at,
        <path::Plain<Power, &'static Light<31>> as observer::Stimulus<Power, 31, G>>::at,
        <path::Plain<Power, &'static Light<31>> as observer::Stimulus<Power, 31, G>>::read::<f32> as fn(_, fn(&Light<31>) -> f32) -> _,
        <path::IgnoringPolarization<path::Natural<&'static Light<31>>> as observer::Stimulus<Power, 31, G>>::at,
        observer::named,
    ];
}
