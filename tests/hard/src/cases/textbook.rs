//! The elementary functions of the naive forms, in radians as textbooks write them. They are those of `libm`,
//! so that the form fails and not the function.

use core::f32::consts::TAU;
use nanospectra::math::{Libm, Math, sqrt};

pub fn exp(x: f32) -> f32 {
    Libm::exp(x)
}

pub fn powf(x: f32, y: f32) -> f32 {
    Libm::powf(x, y)
}

pub fn cos(angle: f32) -> f32 {
    Libm::cos_turns(angle / TAU)
}

pub fn sin(angle: f32) -> f32 {
    Libm::sin_turns(angle / TAU)
}

pub fn tan(angle: f32) -> f32 {
    sin(angle) / cos(angle)
}

pub fn atan(x: f32) -> f32 {
    Libm::atan2(x, 1.0)
}

pub fn acos(x: f32) -> f32 {
    Libm::atan2(sqrt((1.0 - x) * (1.0 + x)), x)
}
