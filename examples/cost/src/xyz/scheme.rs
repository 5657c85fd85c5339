//! How light times surface times observer becomes a sum of N terms.

use nanospectra::Curve;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Scheme {
    /// Values at N wavelengths, both ends of the range among them.
    Points,
    /// Averages over N bins of light, surface and observer; what lies outside the range is cut off.
    Averages,
    /// The same, what the observer sees outside the range in the end bins: an unfolded observer of the crate.
    Tails,
    /// The observer folded by parabolas; the light stays a spectrum of averages.
    Eye,
    /// Light and observer folded together.
    Folded(Curve),
    /// Light and surface as linear sRGB.
    Rgb,
}

pub const SPECTRAL: [Scheme; 7] = [
    Scheme::Points,
    Scheme::Averages,
    Scheme::Tails,
    Scheme::Eye,
    Scheme::Folded(Curve::Step),
    Scheme::Folded(Curve::Parabola),
    Scheme::Folded(Curve::Spline),
];

/// Numbers of bands, each with its instructions on record.
pub const BANDS: [usize; 12] = [3, 8, 12, 16, 20, 24, 31, 36, 40, 60, 81, 95];

impl Scheme {
    /// As tables and the command line call it.
    pub fn name(self) -> &'static str {
        match self {
            Scheme::Points => "points",
            Scheme::Averages => "averages",
            Scheme::Tails => "averages+tails",
            Scheme::Eye => "observer parabola",
            Scheme::Folded(Curve::Step) => "folded step",
            Scheme::Folded(Curve::Parabola) => "folded parabola",
            Scheme::Folded(Curve::Spline) => "folded spline",
            Scheme::Rgb => "sRGB product",
        }
    }

    /// Where it stands among the schemes.
    pub fn place(self) -> usize {
        SPECTRAL.iter().position(|scheme| *scheme == self).unwrap_or(SPECTRAL.len())
    }

    pub fn is_folded(self) -> bool {
        matches!(self, Scheme::Folded(_))
    }

    /// The count on record of its XYZ of a surface: light times surface only where the light is not folded
    /// in.
    pub fn counted_as(self, bands: usize) -> String {
        match self {
            Scheme::Rgb => "rgb-product".to_owned(),
            _ if self.is_folded() => format!("xyz-{bands}"),
            _ => format!("path-surface-{bands}"),
        }
    }

    /// Bytes of constants: the observer's three rows, and the light unless it is folded into them; of sRGB
    /// the matrix and the light.
    pub fn bytes(self, bands: usize) -> usize {
        let numbers = match self {
            Scheme::Rgb => 3 * 3 + 3,
            _ if self.is_folded() => 3 * bands,
            _ => 4 * bands,
        };
        numbers * size_of::<f32>()
    }

    /// Bytes that each surface takes.
    pub fn bytes_per_surface(self, bands: usize) -> usize {
        size_of::<f32>() * if self == Scheme::Rgb { 3 } else { bands }
    }
}
