//! The schemes by which light times surface times observer becomes a sum of N terms.

use nanospectra::Curve;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Scheme {
    /// Values at N wavelengths, which include both ends of the range.
    Points,
    /// Averages of light, surface and observer over N bins. What lies outside the range is cut off.
    Averages,
    /// The same averages, but what the observer sees outside the range is added to the end bins. This is an
    /// observer of the crate that is folded by steps without a light.
    Tails,
    /// An observer that is folded by parabolas. The light stays a spectrum of averages.
    Eye,
    /// Light and observer, folded together.
    Folded(Curve),
    /// A product of light and surface as linear sRGB.
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

/// The numbers of bands. The instructions of each are on record.
pub const BANDS: [usize; 12] = [3, 8, 12, 16, 20, 24, 31, 36, 40, 60, 81, 95];

impl Scheme {
    /// Returns the name that the tables and the command line use.
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

    /// Returns the position among the schemes.
    pub fn place(self) -> usize {
        SPECTRAL.iter().position(|scheme| *scheme == self).unwrap_or(SPECTRAL.len())
    }

    pub fn is_folded(self) -> bool {
        matches!(self, Scheme::Folded(_))
    }

    /// Returns the name of the count on record for XYZ of a surface. It includes the product of light and
    /// surface where the light is not folded in.
    pub fn counted_as(self, bands: usize) -> String {
        match self {
            Scheme::Rgb => "rgb-product".to_owned(),
            _ if self.is_folded() => format!("xyz-{bands}"),
            _ => format!("path-surface-{bands}"),
        }
    }

    /// Returns the bytes of its constants: the three rows of the observer, and the light unless it is folded
    /// into them. For sRGB they are the matrix and the light.
    pub fn bytes(self, bands: usize) -> usize {
        let numbers = match self {
            Scheme::Rgb => 3 * 3 + 3,
            _ if self.is_folded() => 3 * bands,
            _ => 4 * bands,
        };
        numbers * size_of::<f32>()
    }

    /// Returns the bytes that each surface takes.
    pub fn bytes_per_surface(self, bands: usize) -> usize {
        size_of::<f32>() * if self == Scheme::Rgb { 3 } else { bands }
    }
}
