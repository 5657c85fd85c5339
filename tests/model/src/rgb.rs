//! RGB spaces from the xy of their primaries and white.

use super::chromaticity::xyz_from_xy;
use super::linear::{Matrix3, apply, diagonal, inverse, product};

pub struct RgbSpace {
    pub name: &'static str,
    pub primaries: [[f64; 2]; 3],
    pub white: [f64; 2],
}

const D65: [f64; 2] = [0.3127, 0.3290];
const D50: [f64; 2] = [0.3457, 0.3585];
const ACES: [f64; 2] = [0.32168, 0.33767];

pub const SPACES: [RgbSpace; 9] = [
    space("sRGB", [[0.64, 0.33], [0.30, 0.60], [0.15, 0.06]], D65),
    space("Display P3", [[0.680, 0.320], [0.265, 0.690], [0.150, 0.060]], D65),
    space("ITU-R BT.2020", [[0.708, 0.292], [0.170, 0.797], [0.131, 0.046]], D65),
    space("ACEScg", [[0.713, 0.293], [0.165, 0.830], [0.128, 0.044]], ACES),
    space("ACES2065-1", [[0.7347, 0.2653], [0.0, 1.0], [0.0001, -0.0770]], ACES),
    space("Adobe RGB (1998)", [[0.64, 0.33], [0.21, 0.71], [0.15, 0.06]], D65),
    space("ProPhoto RGB", [[0.7347, 0.2653], [0.1596, 0.8404], [0.0366, 0.0001]], D50),
    space("DCI-P3", [[0.680, 0.320], [0.265, 0.690], [0.150, 0.060]], [0.314, 0.351]),
    space("NTSC (1953)", [[0.67, 0.33], [0.21, 0.71], [0.14, 0.08]], [0.31006, 0.31616]),
];

const fn space(name: &'static str, primaries: [[f64; 2]; 3], white: [f64; 2]) -> RgbSpace {
    RgbSpace { name, primaries, white }
}

pub fn named(name: &str) -> &'static RgbSpace {
    SPACES.iter().find(|space| space.name == name).unwrap_or_else(|| panic!("no RGB space called {name}"))
}

impl RgbSpace {
    /// Linear RGB to XYZ with Y = 1 for white.
    pub fn rgb_to_xyz(&self) -> Matrix3 {
        let primaries = self.primaries.map(|xy| xyz_from_xy(xy, 1.0));
        let columns = [0, 1, 2].map(|row| primaries.map(|xyz| xyz[row]));
        let amounts = apply(inverse(columns), xyz_from_xy(self.white, 1.0));
        product(columns, diagonal(amounts))
    }

    pub fn xyz_to_rgb(&self) -> Matrix3 {
        inverse(self.rgb_to_xyz())
    }
}

/// XYZ to linear sRGB as IEC 61966-2-1 prints it, to four decimals.
pub const IEC_XYZ_TO_SRGB: Matrix3 =
    [[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]];
