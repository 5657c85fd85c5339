//! What to do with a color the display cannot show. There is no best way; each says what it
//! keeps.

use crate::color::{Rgb, RgbSpace};

/// A color brought into the gamut.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GamutMapped<S> {
    /// The color to show.
    pub rgb: Rgb<S>,
    /// Was it in the gamut, and so is shown as it is?
    pub was_inside: bool,
}

impl<S: RgbSpace> Rgb<S> {
    /// Is every component in 0..=1? Not if one is NaN.
    #[must_use]
    pub fn in_gamut(self) -> bool {
        self.to_array().iter().all(|c| (0.0..=1.0).contains(c))
    }

    /// Each component by itself into 0..=1: simple, and keeps neither hue nor luminance. NaN
    /// stays NaN.
    #[must_use]
    pub fn clip(self) -> GamutMapped<S> {
        self.mapped(self.to_array().map(|c| c.clamp(0.0, 1.0)))
    }

    /// Dimmed until the largest component is 1: keeps the chromaticity, for lights brighter than
    /// the display. A chromaticity it does not have (a component below zero) stays outside:
    /// desaturate or clip after.
    #[must_use]
    pub fn dim(self) -> GamutMapped<S> {
        let largest = self.r.max(self.g).max(self.b);
        if largest > 1.0 {
            self.mapped(self.to_array().map(|c| c / largest))
        } else {
            self.mapped(self.to_array())
        }
    }

    /// Mixed with the gray of its own luminance, no more than needed: keeps the luminance and
    /// the dominant wavelength. What is brighter than white is white, darker than black black;
    /// NaN stays NaN.
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
