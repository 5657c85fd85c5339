//! Chromaticity coordinates.

pub fn xy([x, y, z]: [f64; 3]) -> [f64; 2] {
    let sum = x + y + z;
    [x / sum, y / sum]
}

/// CIE 1960 UCS, the diagram in which CCT and Duv are defined.
pub fn uv1960([x, y, z]: [f64; 3]) -> [f64; 2] {
    let sum = x + 15.0 * y + 3.0 * z;
    [4.0 * x / sum, 6.0 * y / sum]
}

/// CIE 1976 UCS: u' = u, v' = 1.5 v.
pub fn uv1976(xyz: [f64; 3]) -> [f64; 2] {
    let [u, v] = uv1960(xyz);
    [u, 1.5 * v]
}

/// XYZ of a chromaticity at a given Y.
pub fn xyz_from_xy([x, y]: [f64; 2], luminance: f64) -> [f64; 3] {
    [x / y * luminance, luminance, (1.0 - x - y) / y * luminance]
}

pub fn xy_from_uv1960([u, v]: [f64; 2]) -> [f64; 2] {
    let divisor = 2.0 * u - 8.0 * v + 4.0;
    [3.0 * u / divisor, 2.0 * v / divisor]
}
