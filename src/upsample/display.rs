//! The light that a display emits for an RGB.

use crate::color::Xyz;
use crate::color::matrix::{Matrix64, apply, apply64, inverse64, rounded, scale_columns64};
use crate::grid::{Bins, Grid};
use crate::light::LED_B4_1NM;
use crate::math::const_for;
use crate::observer::Observer;
use crate::spectrum::{Factor, Interpolation, Power, Spectrum};

/// A display whose three primaries have known spectra, which computes the light that leaves it for an RGB.
///
/// Make it from measured spectra ([`new`](Self::new)) or take a nominal one ([`led`](Self::led),
/// [`lcd`](Self::lcd)). [`rgb`](Self::rgb) computes the RGB that it needs for a color, and
/// [`emits`](Self::emits) its light for an RGB.
///
/// Two displays that show the same color emit different spectra. For an observer other than the one that they
/// were matched for, the two colors differ.
///
/// # Example
/// ```
/// use nanospectra::{Curve, Nodes, Observer, Power, observer::CIE_1931, upsample::Display};
/// static EYE: Observer<3, 81, Power, Nodes<380, 780>> = CIE_1931.fold(Curve::Step);
/// static LED: Display<81, Nodes<380, 780>> = Display::led(&EYE);
/// static LCD: Display<81, Nodes<380, 780>> = Display::lcd(&EYE);
/// let color = LCD.xyz([0.5, 0.4, 0.3]);
/// let same = EYE.sees(&LED.emits(LED.rgb(color)));
/// assert!((same[0] - color.x).abs() < 1e-3 && (same[1] - color.y).abs() < 1e-3);
/// assert_ne!(LED.emits(LED.rgb(color)), LCD.emits([0.5, 0.4, 0.3]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Display<const N: usize, G = Bins<380, 730>> {
    primaries: [Spectrum<Power, N, G>; 3],
    to_xyz: [[f32; 3]; 3],
    from_xyz: [[f32; 3]; 3],
}

/// The chromaticity of D65, as the RGB standards round it.
const D65: [f64; 2] = [0.3127, 0.3290];

impl<const N: usize, G: Grid> Display<N, G> {
    /// Makes a display from the measured spectra of red, green and blue at full drive, for the observer that
    /// colors are matched for. Like all that make a display, it computes in f64 and is meant for constants.
    ///
    /// Its colors have the units of the spectra and the observer: spectra in W/sr/m2/nm and an observer
    /// scaled by [`KM`](crate::observer::KM) give cd/m2.
    ///
    /// If the colors of the primaries lie on a line, [`rgb`](Self::rgb) has no meaning.
    #[must_use]
    pub const fn new(primaries: [Spectrum<Power, N, G>; 3], eye: &Observer<3, N, Power, G>) -> Self {
        let seen = seen(&primaries, eye);
        Display { primaries, to_xyz: rounded(&seen), from_xyz: rounded(&inverse64(&seen)) }
    }

    /// Makes a display whose primaries are scaled so that RGB (1, 1, 1) has the chromaticity `white_xy` and
    /// Y = 100.
    ///
    /// It is otherwise made as by [`new`](Self::new), and in f64. The y of the white must not be 0. If the
    /// primaries cannot make the white, one of them is scaled by a negative factor.
    #[must_use]
    pub const fn balanced(
        primaries: [Spectrum<Power, N, G>; 3],
        white_xy: [f64; 2],
        eye: &Observer<3, N, Power, G>,
    ) -> Self {
        let seen = seen(&primaries, eye);
        let [x, y] = white_xy;
        let amounts = apply64(&inverse64(&seen), [100.0 * x / y, 100.0, 100.0 * (1.0 - x - y) / y]);
        let mut scaled = [[0.0; N]; 3];
        const_for!(0..3, |k| {
            const_for!(0..N, |n| scaled[k][n] = (primaries[k].values()[n] as f64 * amounts[k]) as f32);
        });
        let matrix = scale_columns64(&seen, amounts);
        Display {
            primaries: [
                Spectrum::from_bins(scaled[0]),
                Spectrum::from_bins(scaled[1]),
                Spectrum::from_bins(scaled[2]),
            ],
            to_xyz: rounded(&matrix),
            from_xyz: rounded(&inverse64(&matrix)),
        }
    }

    /// Makes a nominal LED wall, whose white has the chromaticity of D65 and Y = 100.
    ///
    /// The primaries are bells (1 + d^2 / w^2)^-4 about 630, 525 and 465 nm with half widths of 9, 16 and 11
    /// nm. They are computed in f64, for `const` use. See the [example](#example).
    #[must_use]
    pub const fn led(eye: &Observer<3, N, Power, G>) -> Self {
        let red = bell::<Power, N, G>(630.0, 9.0);
        let green = bell::<Power, N, G>(525.0, 16.0);
        let blue = bell::<Power, N, G>(465.0, 11.0);
        Self::balanced([red, green, blue], D65, eye)
    }

    /// Makes a nominal LCD, whose white has the chromaticity of D65 and Y = 100.
    ///
    /// Its light is the CIE's white LED B4 (5100 K) behind three filters. These are bells as of
    /// [`led`](Self::led) about 640, 535 and 455 nm with half widths of 45, 38 and 32 nm, and 1 % of light
    /// leaks through. It is computed in f64, for `const` use. See the [example](#example).
    #[must_use]
    pub const fn lcd(eye: &Observer<3, N, Power, G>) -> Self {
        let lamp: Spectrum<Power, N, G> = LED_B4_1NM.interpolate(Interpolation::Linear);
        let red = filtered(&lamp, &bell::<Factor, N, G>(640.0, 45.0));
        let green = filtered(&lamp, &bell::<Factor, N, G>(535.0, 38.0));
        let blue = filtered(&lamp, &bell::<Factor, N, G>(455.0, 32.0));
        Self::balanced([red, green, blue], D65, eye)
    }

    /// Returns the spectra of red, green and blue at full drive.
    #[must_use]
    pub const fn primaries(&self) -> &[Spectrum<Power, N, G>; 3] {
        &self.primaries
    }

    /// Returns the spectrum that the display emits for a linear RGB of its own. See the [example](#example).
    #[must_use]
    pub fn emits(&self, rgb: [f32; 3]) -> Spectrum<Power, N, G> {
        let [red, green, blue] = &self.primaries;
        let mut values = [0.0; N];
        let bins = red.values().iter().zip(green.values().iter().zip(blue.values()));
        for (value, (red, (green, blue))) in values.iter_mut().zip(bins) {
            *value = rgb[0] * red + rgb[1] * green + rgb[2] * blue;
        }
        Spectrum::from_bins(values)
    }

    /// Returns the color of the light that the display emits for a linear RGB of its own, for the observer
    /// that it was made for.
    ///
    /// For a [`balanced`](Self::balanced) display RGB (1, 1, 1) has Y = 100; for others the color has the
    /// units of the spectra and the observer. See the [example](#example).
    #[must_use]
    pub const fn xyz(&self, rgb: [f32; 3]) -> Xyz {
        let [x, y, z] = apply(&self.to_xyz, rgb);
        Xyz { x, y, z }
    }

    /// Returns the linear RGB that the display needs to show a color, which is given in the units of
    /// [`xyz`](Self::xyz).
    ///
    /// A component is below 0 or above 1 if the display cannot show the color. See the [example](#example).
    #[must_use]
    pub const fn rgb(&self, color: Xyz) -> [f32; 3] {
        apply(&self.from_xyz, color.to_array())
    }
}

/// Returns the XYZ of each primary, as columns.
const fn seen<const N: usize, G: Grid>(
    primaries: &[Spectrum<Power, N, G>; 3],
    eye: &Observer<3, N, Power, G>,
) -> Matrix64 {
    let mut matrix = [[0.0; 3]; 3];
    const_for!(0..3, |row| {
        const_for!(0..3, |k| {
            let (weights, values) = (&eye.weights()[row], primaries[k].values());
            const_for!(0..N, |n| matrix[row][k] += weights[n] as f64 * values[n] as f64);
        });
    });
    matrix
}

/// Returns (1 + d^2 / w^2)^-4, where w is such that the value is one half at `half_nm` from the center.
const fn bell<Q, const N: usize, G: Grid>(center_nm: f64, half_nm: f64) -> Spectrum<Q, N, G> {
    // 2^(1/4) - 1
    const HALF: f64 = 0.189_207_115_002_721_07;
    let mut values = [0.0; N];
    const_for!(0..N, |n| {
        let d = (Spectrum::<Q, N, G>::center_nm(n) as f64 - center_nm) / half_nm;
        let base = 1.0 + HALF * d * d;
        let square = base * base;
        values[n] = (1.0 / (square * square)) as f32;
    });
    Spectrum::from_bins(values)
}

const fn filtered<const N: usize, G: Grid>(
    lamp: &Spectrum<Power, N, G>,
    filter: &Spectrum<Factor, N, G>,
) -> Spectrum<Power, N, G> {
    let mut values = [0.0; N];
    const_for!(0..N, |n| values[n] = lamp.values()[n] * (0.01 + 0.99 * filter.values()[n]));
    Spectrum::from_bins(values)
}
