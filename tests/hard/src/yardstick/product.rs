//! Color without a spectrum: what a renderer in RGB does with a light and a surface.

/// Linear sRGB to XYZ, Y = 100 for white: from the primaries and the white of the standard.
///
/// # Reference
/// IEC 61966-2-1:1999.
const TO_XYZ: [[f32; 3]; 3] = [
    [41.239_08, 35.758_434, 18.048_079],
    [21.263_9, 71.516_87, 7.219_232],
    [1.933_082, 11.919_478, 95.053_215],
];

/// XYZ of a surface under a light, both in linear sRGB: component by component, then the matrix.
///
/// The surface's is its color under D65, with (1, 1, 1) for a perfect white.
#[must_use]
pub fn rgb_product(light: [f32; 3], surface: [f32; 3]) -> [f32; 3] {
    let ([lr, lg, lb], [sr, sg, sb]) = (light, surface);
    let (r, g, b) = (lr * sr, lg * sg, lb * sb);
    TO_XYZ.map(|[to_r, to_g, to_b]| to_r * r + to_g * g + to_b * b)
}
