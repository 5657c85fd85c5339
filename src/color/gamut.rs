//! Mapping of colors into the gamut of a display. No method is best for all colors; each says what it keeps.

use crate::color::{Rgb, RgbSpace};

/// A color that was mapped into the gamut of its space, by [`Rgb::clip`], [`Rgb::dim`] or
/// [`Rgb::desaturate`].
///
/// # Example
/// ```
/// use nanospectra::color::{Rgb, Srgb};
/// let bright = Rgb::<Srgb>::new(2.0, 1.0, 0.5);
/// assert!(!bright.in_gamut());
///
/// let clipped = bright.clip(); // changes the hue
/// assert_eq!(clipped.rgb.to_array(), [1.0, 1.0, 0.5]);
/// let dimmed = bright.dim(); // keeps the chromaticity
/// assert_eq!(dimmed.rgb.to_array(), [1.0, 0.5, 0.25]);
/// assert!(!dimmed.was_inside && dimmed.rgb.clip().was_inside);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GamutMapped<S> {
    /// The color that the display can show.
    ///
    /// See the [example](GamutMapped#example).
    pub rgb: Rgb<S>,
    /// Whether the color was in the gamut already, and is shown unchanged.
    ///
    /// See the [example](GamutMapped#example).
    pub was_inside: bool,
}

impl<S: RgbSpace> Rgb<S> {
    /// Tells whether every component is within 0..=1; the answer is `false` if one is NaN.
    ///
    /// See the [example](GamutMapped#example).
    #[must_use]
    pub fn in_gamut(self) -> bool {
        self.to_array().iter().all(|c| (0.0..=1.0).contains(c))
    }

    /// Clips each component to 0..=1, which keeps neither hue nor luminance.
    ///
    /// NaN stays NaN. See the [example](GamutMapped#example).
    #[must_use]
    pub fn clip(self) -> GamutMapped<S> {
        self.mapped(self.to_array().map(|c| c.clamp(0.0, 1.0)))
    }

    /// Divides by the largest component if that is above 1, which keeps the chromaticity.
    ///
    /// Use it for lights that are brighter than the display. A component below zero stays below zero, so call
    /// [`desaturate`](Self::desaturate) or [`clip`](Self::clip) afterwards. See the
    /// [example](GamutMapped#example).
    #[must_use]
    pub fn dim(self) -> GamutMapped<S> {
        let largest = self.r.max(self.g).max(self.b);
        if largest > 1.0 {
            self.mapped(self.to_array().map(|c| c / largest))
        } else {
            self.mapped(self.to_array())
        }
    }

    /// Mixes the color with the gray of its luminance until it is in the gamut, which keeps the luminance and
    /// the dominant wavelength.
    ///
    /// The mixture has the smallest share of gray that suffices. A color brighter than white becomes white,
    /// and one with a luminance below zero becomes black. NaN stays NaN.
    ///
    /// # Example
    /// ```
    /// use nanospectra::color::{Rgb, Srgb};
    /// let cyan = Rgb::<Srgb>::new(-0.2, 0.6, 0.6); // spectral lights have a negative red
    /// let shown = cyan.desaturate().rgb;
    /// assert_eq!(shown.r, 0.0);
    /// assert!((shown.luminance() - cyan.luminance()).abs() < 1e-6);
    /// ```
    #[must_use]
    pub fn desaturate(self) -> GamutMapped<S> {
        if self.in_gamut() {
            return self.mapped(self.to_array());
        }
        let gray = self.luminance();
        if gray >= 1.0 {
            return self.mapped([1.0; 3]);
        }
        if gray <= 0.0 {
            return self.mapped([0.0; 3]);
        }
        let mut keep: f32 = 1.0;
        for c in self.to_array() {
            if c > 1.0 {
                keep = keep.min((1.0 - gray) / (c - gray));
            } else if c < 0.0 {
                keep = keep.min(gray / (gray - c));
            }
        }
        // The clamp removes what rounding leaves outside of 0..=1.
        self.mapped(self.to_array().map(|c| (gray + keep * (c - gray)).clamp(0.0, 1.0)))
    }

    fn mapped(self, [r, g, b]: [f32; 3]) -> GamutMapped<S> {
        GamutMapped { rgb: Rgb::new(r, g, b), was_inside: self.in_gamut() }
    }
}
