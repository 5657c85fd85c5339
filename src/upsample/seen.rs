//! What the observer sees of a curve: X, Y and Z relative to white, and Lab.

use crate::color::matrix::{Matrix, apply};
use crate::color::{Lab, ParametricFactors, Xyz, ciede2000_with};
use crate::math::Fast;
use crate::upsample::newton::{Rows, responses};

/// The observer of a solver.
pub(super) struct Eye<'a, const N: usize> {
    pub(super) rows: &'a Rows<N>,
    /// The matrix from responses to X, Y and Z, each of which is 1 for white.
    pub(super) to_xyz: Matrix,
}

impl<const N: usize> Eye<'_, N> {
    /// Returns X, Y and Z of a curve, relative to white.
    pub(super) fn sees(&self, q: [f32; 3]) -> [f32; 3] {
        apply(&self.to_xyz, responses(self.rows, q))
    }
}

/// A color that was asked for, to which others are compared.
pub(super) struct Asked {
    pub(super) xyz: [f32; 3],
    lab: Lab,
    /// What both colors are multiplied by before they are compared. It is above 1 for colors that are so dark
    /// that any two of them would look alike.
    pub(super) exposure: f32,
}

impl Asked {
    /// The color with these X, Y and Z relative to white, compared as if it were brought to a size of `least`
    /// if it is darker.
    pub(super) fn new(xyz: [f32; 3], least: f32) -> Self {
        // No curve comes near colors that are further outside, whose Lab might overflow.
        let xyz = xyz.map(|share| share.clamp(-10.0, 10.0));
        let [x, y, z] = xyz;
        let largest = x.abs().max(y.abs()).max(z.abs());
        let exposure = if 1e-30 < largest && largest < least { least / largest } else { 1.0 };
        Asked { xyz, lab: lab(xyz.map(|share| exposure * share)), exposure }
    }

    /// Returns the CIEDE2000 difference from a color with these X, Y and Z. It does not depend on features of
    /// the crate, since it is computed by `Fast`.
    pub(super) fn delta_e(&self, xyz: [f32; 3]) -> f32 {
        let seen = lab(xyz.map(|share| self.exposure * share));
        ciede2000_with::<Fast>(self.lab, seen, ParametricFactors::default())
    }
}

/// Returns Lab of X, Y and Z that are 1 for white.
pub(super) fn lab(xyz: [f32; 3]) -> Lab {
    Xyz::from(xyz).lab(Xyz::new(1.0, 1.0, 1.0)).unwrap_or(Lab::new(f32::NAN, f32::NAN, f32::NAN))
}
