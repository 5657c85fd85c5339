//! What a spectrum means: chromaticity, color temperature, color spaces, differences, rendering.

mod any_color_at_all;
mod appearance;
mod cct;
mod color_bits;
mod differences;
mod dominant;
mod hdr;
mod held_out;
mod planckian;
mod rendering;
mod rgb_and_adaptation;
mod spaces;
mod textbook_slips;
mod transfer;
mod worst_colors;
mod worst_conversions;

use nanospectra::color::Xyz;

fn narrow(v: [f64; 3]) -> [f32; 3] {
    v.map(|v| v as f32)
}

fn wide(v: Xyz) -> [f64; 3] {
    v.to_array().map(f64::from)
}
