//! Mapping of colors into the gamut of a display. No method is best for all colors; each says what it keeps.

use crate::color::{Rgb, RgbSpace};

/// A color that was mapped into the gamut of its space.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GamutMapped<S> {
    /// The color to show.
    pub rgb: Rgb<S>,
    /// Whether the color was in the gamut already, and is shown unchanged.
    pub was_inside: bool,
}

impl<S: RgbSpace> Rgb<S> {
    /// Whether every component is within 0..=1; `false` if one is NaN.
    #[must_use]
    pub fn in_gamut(self) -> bool {
        self.to_array().iter().all(|c| (0.0..=1.0).contains(c))
    }

    /// Clips each component to 0..=1, which keeps neither hue nor luminance. NaN stays NaN.
    #[must_use]
    pub fn clip(self) -> GamutMapped<S> {
        self.mapped(self.to_array().map(|c| c.clamp(0.0, 1.0)))
    }

    /// Divides by the largest component where that is above 1, which keeps the chromaticity: for lights that
    /// are brighter than the display. A component below zero stays below zero: desaturate or clip afterwards.
    #[must_use]
    pub fn dim(self) -> GamutMapped<S> {
        let largest = self.r.max(self.g).max(self.b);
        if largest > 1.0 {
            self.mapped(self.to_array().map(|c| c / largest))
        } else {
            self.mapped(self.to_array())
        }
    }

    /// Mixes the color with the gray of its luminance, just as much as brings it into the gamut, which keeps
    /// the luminance and the dominant wavelength. A color brighter than white becomes white, one with a
    /// luminance below zero black; NaN stays NaN.
    ///
    /// ```
    /// use nanospectra::color::{Rgb, Srgb};
    /// let cyan = Rgb::<Srgb>::new(-0.2, 0.6, 0.6); // spectral lights have a negative red
    /// let shown = cyan.desaturate().rgb;
    /// assert_eq!(shown.r, 0.0);
    /// assert!((shown.luminance() - cyan.luminance()).abs() < 1e-6);
    /// ```
    #[must_use]
    pub fn desaturate(self) -> GamutMapped<S> {
        let gray = self.luminance();
        if gray >= 1.0 {
            return self.mapped([1.0; 3]);
        }
        if gray <= 0.0 {
            return self.mapped([0.0; 3]);
        }
        if self.in_gamut() {
            return self.mapped(self.to_array());
        }
        let mut keep: f32 = 1.0;
        for c in self.to_array() {
            if c > 1.0 {
                keep = keep.min((1.0 - gray) / (c - gray));
            } else if c < 0.0 {
                keep = keep.min(gray / (gray - c));
            }
        }
        // The clamp takes off what rounding leaves beyond the faces.
        self.mapped(self.to_array().map(|c| (gray + keep * (c - gray)).clamp(0.0, 1.0)))
    }

    fn mapped(self, [r, g, b]: [f32; 3]) -> GamutMapped<S> {
        GamutMapped { rgb: Rgb::new(r, g, b), was_inside: self.in_gamut() }
    }
}
