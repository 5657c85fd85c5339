//! Computes the color of a surface in a light.

use crate::board::{board, put};
use crate::measure::{at, chromaticity, eye, show};
use nanospectra::color::{Adaptation, Bradford, Lab, Rgb, RgbSpace, Srgb, Xyz, ciede2000};
use nanospectra::{Factor, Fine};

const PERFECT_WHITE: Lab = Lab { l: 100.0, a: 0.0, b: 0.0 };

/// Returns CIEDE2000 between two colors in L*, a*, b*.
#[unsafe(no_mangle)]
extern "C" fn difference(l: f32, a: f32, b: f32, other_l: f32, other_a: f32, other_b: f32) -> f32 {
    ciede2000(Lab { l, a, b }, Lab { l: other_l, a: other_a, b: other_b })
}

/// Computes the color of the reflectance in `curve` in the light in `light`. Returns 0, plus 1 if the light
/// gives no white for Lab, plus 2 if its white cannot be adapted to D65.
#[unsafe(no_mangle)]
extern "C" fn see_surface(observer: u32) -> u32 {
    let board = &mut *board();
    let room = eye(observer).under(&board.light).with_white_y(100.0);
    let white = Xyz::from(room.sees(&Fine::flat(1.0)));
    let xyz = Xyz::from(room.sees(&Fine::<Factor>::from_bins(*board.curve.values())));
    let out = &mut board.out;
    put(out, at::XYZ, xyz.to_array());
    put(out, at::ABSOLUTE, white.to_array());
    chromaticity(out, xyz);
    let mut status = 0;
    match xyz.lab(white) {
        Some(lab) => put(out, at::LAB, [lab.l, lab.a, lab.b, ciede2000(lab, PERFECT_WHITE)]),
        None => {
            put(out, at::LAB, [f32::NAN; 4]);
            status = 1;
        }
    }
    match Adaptation::between::<Bradford>(white, Srgb::WHITE_XYZ) {
        Some(to_d65) => show(out, Rgb::from_xyz(to_d65.apply(xyz))),
        None => status += 2,
    }
    status
}
