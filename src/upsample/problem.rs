//! What is left for the solver to find for a color: nothing, or a curve with three responses.

use crate::color::matrix::apply;

/// A color on its way to the solver.
pub enum Problem {
    /// There is nothing to solve: the spectrum is this constant, and the flag says whether it has the color.
    Done(f32, bool),
    /// A curve with these responses is to be found. The reflectance is `scale` times the curve, or 1 minus
    /// that.
    Solve { responses: [f32; 3], scale: f32, complement: bool },
}

impl Problem {
    /// Returns what the solver has to do for a color in linear RGB, where `response` is the matrix from RGB
    /// to responses. (It is written without `f32::max`, which is a function call on a Cortex-M4F.)
    #[inline(always)]
    pub fn of(rgb: [f32; 3], response: &[[f32; 3]; 3]) -> Self {
        let [r, g, b] = rgb;
        let (smallest, largest) = range(rgb);
        // Zero times a NaN or an infinity is NaN, and so the sum is not zero.
        if 0.0 * r + 0.0 * g + 0.0 * b != 0.0 {
            return Problem::Done(f32::NAN, false);
        }
        if largest <= 0.0 {
            return Problem::Done(0.0, smallest == 0.0);
        }
        if smallest >= 1.0 {
            return Problem::Done(1.0, largest == 1.0);
        }
        if smallest == largest {
            return Problem::Done(r, true);
        }
        // `color` is c or 1 - c for each component c, enlarged so that the largest component is 1/2.
        let (offset, sign, scale) = if largest < 0.5 {
            (0.0, 1.0, 2.0 * largest)
        } else if smallest > 0.5 {
            (1.0, -1.0, 2.0 * (1.0 - smallest))
        } else {
            (0.0, 1.0, 1.0)
        };
        let color = [(offset + sign * r) / scale, (offset + sign * g) / scale, (offset + sign * b) / scale];
        Problem::Solve { responses: apply(response, color), scale, complement: sign < 0.0 }
    }
}

/// Returns the smallest and the largest component.
#[inline(always)]
pub fn range([r, g, b]: [f32; 3]) -> (f32, f32) {
    let (low, high) = if r < g { (r, g) } else { (g, r) };
    (if b < low { b } else { low }, if b > high { b } else { high })
}
