//! The colors that a display shows.

use nanospectra::color::{Adaptation, Cat16, Rgb, RgbSpace, Srgb, Xyz};

/// Returns a color that is seen under a white, where Y = 100 for white, as linear sRGB adapted to D65 and as
/// 8-bit codes. It is not adapted if the white is none.
#[inline(never)]
pub fn displayed(seen: Xyz, white: Xyz) -> (Rgb<Srgb>, [f32; 3]) {
    let is_white = white.x > 0.0 && white.y > 0.0 && white.z > 0.0;
    let adaptation = Adaptation::between::<Cat16>(white, Srgb::WHITE_XYZ).filter(|_| is_white);
    let rgb = Rgb::from_xyz(adaptation.map_or(seen, |adaptation| adaptation.apply(seen)));
    let [r, g, b] = rgb.clip().rgb.encode().to_u8();
    (rgb, [f32::from(r), f32::from(g), f32::from(b)])
}
