//! Chromatic adaptation: the color that, seen under a second white, corresponds to one seen under a first.

use crate::color::Xyz;
use crate::color::matrix::{Matrix, apply, apply64, inverse64, product64, rounded, scale_columns64};

/// The cone responses that an adaptation scales one by one, as von Kries proposed.
///
/// [`Bradford`], [`Cat02`], [`Cat16`] and [`VonKries`] implement it. They are named where an adaptation is
/// made, as in `Adaptation::between::<Cat16>(from, to)`. See the [example](Adaptation#example).
pub trait ConeResponses: Copy + 'static {
    /// The matrix that takes X, Y, Z to the three responses, row by row.
    const FROM_XYZ: [[f64; 3]; 3];
}

/// The cone responses of the linear Bradford transform, by which ICC profiles adapt colors to D50.
///
/// See the [example](Adaptation#example).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Bradford;
/// The cone responses of CAT02, the chromatic adaptation transform that CIECAM02 uses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cat02;
/// The responses of CAT16, the transform that CIECAM16 uses.
///
/// See the [example](Adaptation#example).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cat16;
/// The cone responses of Hunt, Pointer and Estevez, scaled to be equal for D65.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct VonKries;

impl ConeResponses for Bradford {
    const FROM_XYZ: [[f64; 3]; 3] =
        [[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]];
}
impl ConeResponses for Cat02 {
    const FROM_XYZ: [[f64; 3]; 3] =
        [[0.7328, 0.4296, -0.1624], [-0.7036, 1.6975, 0.0061], [0.0030, 0.0136, 0.9834]];
}
impl ConeResponses for Cat16 {
    const FROM_XYZ: [[f64; 3]; 3] =
        [[0.401288, 0.650173, -0.051461], [-0.250268, 1.204414, 0.045854], [-0.002079, 0.048952, 0.953127]];
}
impl ConeResponses for VonKries {
    const FROM_XYZ: [[f64; 3]; 3] =
        [[0.40024, 0.7076, -0.08081], [-0.2263, 1.16532, 0.0457], [0.0, 0.0, 0.91822]];
}

/// A change of the white, as a matrix that takes a color seen under one white to the corresponding color
/// seen under another.
///
/// Make it by [`between`](Self::between), or by [`between_const`](Self::between_const) if both whites are
/// known when the program is compiled. Then call [`apply`](Self::apply) for each color.
///
/// The first white gets the chromaticity of the second and keeps its luminance, so that only the
/// chromaticities of the whites count. They may be given with any Y, and the adapted colors keep their scale.
///
/// # Reference
/// CIE 160:2004; ICC.1:2022 annex E for Bradford; CIE 248:2022 for CAT16.
///
/// # Example
/// ```
/// use nanospectra::color::{Adaptation, Bradford, Cat16, Xyz};
/// // From D65 to the D50 of ICC profiles, computed by the compiler.
/// const D65: Xyz = Xyz::new(95.047, 100.0, 108.883);
/// const TO_D50: Adaptation = Adaptation::between_const::<Bradford>(D65, Xyz::new(96.42, 100.0, 82.491));
/// let red = TO_D50.apply(Xyz::new(41.24, 21.26, 1.93)); // the red of sRGB, as ICC profiles have it:
/// assert!((red.x - 43.60).abs() < 0.01 && (red.y - 22.25).abs() < 0.01 && (red.z - 1.39).abs() < 0.01);
///
/// // At run time: complete adaptation takes the white of illuminant A to D65, degree 0 leaves it as it is.
/// let a = Xyz::new(109.85, 100.0, 35.585);
/// let white = Adaptation::between::<Cat16>(a, D65).ok_or("no such white")?.apply(a);
/// assert!((white.x - D65.x).abs() < 1e-3 && (white.z - D65.z).abs() < 1e-3);
/// let white = Adaptation::partial::<Cat16>(a, D65, 0.0).ok_or("no such white")?.apply(a);
/// assert!((white.x - a.x).abs() < 1e-3 && (white.z - a.z).abs() < 1e-3);
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Adaptation(Matrix);

impl Adaptation {
    /// Makes the complete adaptation from one white to another, at run time and in f32.
    ///
    /// The result is `None` for a white without luminance, and for one with a cone response that is not above
    /// zero, as a deep blue or red laser has. NaN stays NaN. A white with X / Y or Z / Y beyond 1e37
    /// overflows. See the [example](Adaptation#example).
    ///
    /// # Accuracy
    /// 4e-6 per element, whose largest is 10, from any white of 2000 K on, at a Duv of up to 0.02, to D65
    /// (searched in `tests/color/worst_conversions.rs`).
    #[must_use]
    pub fn between<C: ConeResponses>(from: Xyz, to: Xyz) -> Option<Self> {
        Self::partial::<C>(from, to, 1.0)
    }

    /// Makes an incomplete adaptation, whose `degree` goes from 0 (colors stay as they are) to 1 (complete).
    ///
    /// The responses are scaled by `degree * to / from + 1 - degree`, for whites of the same luminance. The
    /// result is `None` as in [`Adaptation::between`]. See the [example](Adaptation#example).
    #[must_use]
    pub fn partial<C: ConeResponses>(from: Xyz, to: Xyz, degree: f32) -> Option<Self> {
        let cones = const { rounded(&C::FROM_XYZ) };
        let back = const { rounded(&inverse64(&C::FROM_XYZ)) };
        let a = apply(&cones, from.with_y(1.0)?.to_array());
        let b = apply(&cones, to.with_y(1.0)?.to_array());
        let mut scaled = cones;
        for (row, (a, b)) in scaled.iter_mut().zip(a.iter().zip(&b)) {
            if *a <= 0.0 || *b <= 0.0 {
                return None;
            }
            let gain = degree * (b / a) + (1.0 - degree);
            for m in row {
                *m *= gain;
            }
        }
        let [l, m, s] = scaled;
        Some(Adaptation(back.map(|[p, q, r]| {
            [p * l[0] + q * m[0] + r * s[0], p * l[1] + q * m[1] + r * s[1], p * l[2] + q * m[2] + r * s[2]]
        })))
    }

    /// Makes the complete adaptation between two whites that are known when the program is compiled.
    ///
    /// It computes in f64, so keep the result in a `const` or `static`. It checks nothing: whites that
    /// [`Adaptation::between`] refuses make a matrix without meaning, or one that is not finite. See the
    /// [example](Adaptation#example).
    ///
    /// # Accuracy
    /// Each element is the f64 one rounded to f32.
    #[must_use]
    pub const fn between_const<C: ConeResponses>(from: Xyz, to: Xyz) -> Self {
        let a = apply64(&C::FROM_XYZ, [from.x as f64, from.y as f64, from.z as f64]);
        let b = apply64(&C::FROM_XYZ, [to.x as f64, to.y as f64, to.z as f64]);
        let k = from.y as f64 / to.y as f64;
        let gain = [k * b[0] / a[0], k * b[1] / a[1], k * b[2] / a[2]];
        let back = scale_columns64(&inverse64(&C::FROM_XYZ), gain);
        Adaptation(rounded(&product64(&back, &C::FROM_XYZ)))
    }

    /// Returns the color that corresponds to `color` under the second white, on the scale of `color`.
    ///
    /// See the [example](Adaptation#example).
    #[must_use]
    pub const fn apply(&self, color: Xyz) -> Xyz {
        let [x, y, z] = apply(&self.0, color.to_array());
        Xyz { x, y, z }
    }

    /// Returns the matrix of the adaptation, row by row.
    #[must_use]
    pub const fn matrix(&self) -> &[[f32; 3]; 3] {
        &self.0
    }
}
