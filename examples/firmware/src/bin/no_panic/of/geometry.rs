//! The functions of the module `geometry`.

use super::names::*;

pub fn all() {
    calls![
        <geometry::Direction as core::ops::Neg>::neg,
        <geometry::Uniform<4, 8> as geometry::Hemisphere>::integrate::<f32>
            as fn(_, fn(geometry::Direction) -> f32) -> _,
        <geometry::Uniform<4, 8> as geometry::Hemisphere>::integrate_projected::<f32>
            as fn(_, fn(geometry::Direction) -> f32) -> _,
        geometry::Direction::from_vector,
        geometry::Direction::spherical,
        geometry::Direction::from_cosine,
        geometry::Direction::x,
        geometry::Direction::y,
        geometry::Direction::cos_theta,
        geometry::Direction::sin_theta,
        geometry::Direction::to_array,
        geometry::Direction::theta_rad,
        geometry::Direction::theta_rad_with::<Fast>,
        geometry::Direction::phi_rad,
        geometry::Direction::phi_rad_with::<Fast>,
        geometry::Direction::dot,
        geometry::Direction::mirrored,
        geometry::Direction::reflected,
        geometry::Direction::halfway,
        geometry::Direction::refracted,
        geometry::Frame::from_normal,
        geometry::Frame::with_tangent,
        geometry::Frame::axes,
        geometry::Frame::to_local,
        geometry::Frame::towards,
        geometry::Frame::to_world,
        <Spectrum<Power, 31> as geometry::Integrand>::accumulate,
        <Spectrum<Power, 31> as geometry::Integrand>::map as fn(_, fn(f32) -> f32) -> _,
        <Spectrum<Power, 31> as geometry::Integrand>::peak,
        <Spectrum<Power, 31> as geometry::Integrand>::distance,
        <f32 as geometry::Integrand>::accumulate,
        <f32 as geometry::Integrand>::map as fn(_, fn(f32) -> f32) -> _,
        <f32 as geometry::Integrand>::peak,
        <f32 as geometry::Integrand>::distance,
        <radiometry::Radiant as geometry::Integrand>::accumulate,
        <radiometry::Radiant as geometry::Integrand>::map as fn(_, fn(f32) -> f32) -> _,
        <radiometry::Radiant as geometry::Integrand>::peak,
        <radiometry::Radiant as geometry::Integrand>::distance,
        <radiometry::Luminous as geometry::Integrand>::accumulate,
        <radiometry::Luminous as geometry::Integrand>::map as fn(_, fn(f32) -> f32) -> _,
        <radiometry::Luminous as geometry::Integrand>::peak,
        <radiometry::Luminous as geometry::Integrand>::distance,
        <radiometry::Scotopic as geometry::Integrand>::accumulate,
        <radiometry::Scotopic as geometry::Integrand>::map as fn(_, fn(f32) -> f32) -> _,
        <radiometry::Scotopic as geometry::Integrand>::peak,
        <radiometry::Scotopic as geometry::Integrand>::distance,
    ];
    walks![
        <geometry::Cosine<4, 8> as geometry::Hemisphere>::nodes,
        <geometry::GaussLegendre<4, 8> as geometry::Hemisphere>::nodes,
        <geometry::Uniform<4, 8> as geometry::Hemisphere>::nodes,
    ];
}
