//! A screen: what it emits for an RGB.

use crate::color::Xyz;
use crate::color::matrix::{Matrix64, apply, apply64, inverse64, rounded, scale_columns64};
use crate::grid::{Bins, Grid};
use crate::light::LED_B4_1NM;
use crate::math::const_for;
use crate::observer::Observer;
use crate::spectrum::{Factor, Interpolation, Power, Spectrum};

/// A display with three primaries whose spectra are known: the RGB it needs for a color, and the light that
/// leaves it then.
///
/// Two displays that show the same color emit different spectra, and agree only for the observer they were
/// matched for.
///
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

/// x, y of D65 as the RGB standards round it.
const D65: [f64; 2] = [0.3127, 0.3290];

impl<const N: usize, G: Grid> Display<N, G> {
    /// From the measured spectra of red, green and blue at full drive, and the eye to match colors for; for
    /// `const` use. In the units of both: W/sr/m2/nm and an eye times [`KM`](crate::observer::KM) make cd/m2.
    ///
    /// Primaries whose colors lie on a line have no inverse, and their `rgb` means nothing.
    #[must_use]
    pub const fn new(primaries: [Spectrum<Power, N, G>; 3], eye: &Observer<3, N, Power, G>) -> Self {
        let seen = seen(&primaries, eye);
        Display { primaries, to_xyz: rounded(&seen), from_xyz: rounded(&inverse64(&seen)) }
    }

    /// As [`new`](Self::new), the primaries scaled so that RGB (1, 1, 1) has chromaticity `white_xy` and Y =
    /// 100.
    ///
    /// A white with y = 0 has no such scale, and one that the primaries cannot make takes a negative amount
    /// of one.
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

    /// A nominal LED wall, D65 and Y = 100 at white: bells (1 + d^2 / w^2)^-4 about 630, 525 and 465 nm with
    /// half widths of 9, 16 and 11 nm.
    #[must_use]
    pub const fn led(eye: &Observer<3, N, Power, G>) -> Self {
        let red = bell::<Power, N, G>(630.0, 9.0);
        let green = bell::<Power, N, G>(525.0, 16.0);
        let blue = bell::<Power, N, G>(465.0, 11.0);
        Self::balanced([red, green, blue], D65, eye)
    }

    /// A nominal LCD, D65 and Y = 100 at white: the CIE's white LED B4 (5100 K) through three filters, bells
    /// as above about 640, 535 and 455 nm with half widths of 45, 38 and 32 nm, and 1 % of light that leaks.
    #[must_use]
    pub const fn lcd(eye: &Observer<3, N, Power, G>) -> Self {
        let lamp: Spectrum<Power, N, G> = LED_B4_1NM.interpolate(Interpolation::Linear);
        let red = filtered(&lamp, &bell::<Factor, N, G>(640.0, 45.0));
        let green = filtered(&lamp, &bell::<Factor, N, G>(535.0, 38.0));
        let blue = filtered(&lamp, &bell::<Factor, N, G>(455.0, 32.0));
        Self::balanced([red, green, blue], D65, eye)
    }

    /// The spectra of red, green and blue at full drive.
    #[must_use]
    pub const fn primaries(&self) -> &[Spectrum<Power, N, G>; 3] {
        &self.primaries
    }

    /// The light it emits for a linear RGB of its own.
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

    /// The color of that light to the eye it was made for: Y = 100 for RGB (1, 1, 1) of a
    /// [`balanced`](Self::balanced) display, in the units of the spectra and the eye otherwise.
    #[must_use]
    pub const fn xyz(&self, rgb: [f32; 3]) -> Xyz {
        let [x, y, z] = apply(&self.to_xyz, rgb);
        Xyz { x, y, z }
    }

    /// The linear RGB it needs for a color, in the same units as [`xyz`](Self::xyz) gives; below 0 or above 1
    /// if it cannot show it.
    #[must_use]
    pub const fn rgb(&self, color: Xyz) -> [f32; 3] {
        apply(&self.from_xyz, color.to_array())
    }
}

/// XYZ of each primary, as columns.
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

/// (1 + d^2 / w^2)^-4 with w so that `half_nm` from the center half is left.
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
