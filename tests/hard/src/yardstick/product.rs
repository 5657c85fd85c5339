//! Color without a spectrum, as a renderer in RGB multiplies a light by a surface.

/// The matrix from linear sRGB to XYZ with Y = 100 for white, from the primaries and the white of the
/// standard.
///
/// # Reference
/// IEC 61966-2-1:1999.
const TO_XYZ: [[f32; 3]; 3] = [
    [41.239_08, 35.758_434, 18.048_079],
    [21.263_9, 71.516_87, 7.219_232],
    [1.933_082, 11.919_478, 95.053_215],
];

/// Returns XYZ of a surface under a light, both given in linear sRGB: multiplies component by component, then
/// applies the matrix.
///
/// The surface is given by its color under D65, where a perfect white is (1, 1, 1).
#[must_use]
pub fn rgb_product(light: [f32; 3], surface: [f32; 3]) -> [f32; 3] {
    let ([lr, lg, lb], [sr, sg, sb]) = (light, surface);
    let (r, g, b) = (lr * sr, lg * sg, lb * sb);
    TO_XYZ.map(|[to_r, to_g, to_b]| to_r * r + to_g * g + to_b * b)
}
