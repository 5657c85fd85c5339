//! Colors for which Newton's method finds no sigmoid: those near the limit of what sigmoids have, and those
//! beyond it.

use crate::color::matrix::apply;
use crate::color::{Rgb, RgbSpace};
use crate::grid::Grid;
use crate::upsample::descent::descend;
use crate::upsample::edges::nearest;
use crate::upsample::meaning::SigmoidReflectance;
use crate::upsample::newton;
use crate::upsample::problem::Problem;
use crate::upsample::seen::{Asked, Eye};
use crate::upsample::sigmoid::Sigmoid;
use crate::upsample::start::StartMap;
use crate::upsample::status::{Solved, Status};

/// The CIEDE2000 difference below which two colors are the same.
const NOTHING: f32 = 0.002;
/// Colors of which X, Y and Z are below this share of white are compared as if the largest were this share.
const DARKEST: f32 = 1e-3;

impl<const N: usize, G: Grid, S: RgbSpace, M: StartMap> Sigmoid<N, G, S, M> {
    /// Returns the spectrum of a color for which Newton's method found none: a sigmoid itself, without a
    /// scale, that has the color or comes as near to it as possible.
    #[inline(never)]
    pub(super) fn far(&self, asked: Rgb<S>) -> Solved<SigmoidReflectance> {
        let (eye, xyz) = (self.eye(), self.relative(asked));
        let (q, found) = self.descended(&eye, xyz);
        if found {
            return Solved { spectrum: SigmoidReflectance::of(q), status: Status::Exact };
        }
        // What counts now is the difference of the colors as they are.
        let plain = Asked::new(xyz, DARKEST);
        let again = descend(&eye, plain.xyz, plain.exposure, q);
        let (mut q, mut off) = (q, plain.delta_e(eye.sees(q)));
        let off_again = plain.delta_e(eye.sees(again));
        if off_again < off {
            (q, off) = (again, off_again);
        }
        let [a, b, c] = apply(&self.response, asked.to_array());
        let (edges, off_edges) = nearest(&eye, &plain, (a + b + c) * (1.0 / 3.0));
        if off_edges < off {
            (q, off) = (edges, off_edges);
        }
        let status = if off < NOTHING {
            Status::Exact
        } else {
            Status::Unreachable(self.miss(asked, newton::responses(&self.rows, q)))
        };
        Solved { spectrum: SigmoidReflectance::of(q), status }
    }

    /// Returns the sigmoid that is found for X, Y and Z relative to white, and whether it has the color.
    fn descended(&self, eye: &Eye<'_, N>, xyz: [f32; 3]) -> ([f32; 3], bool) {
        let asked = Asked::new(xyz, 0.5);
        let q = descend(eye, asked.xyz, asked.exposure, [0.0; 3]);
        (q, asked.delta_e(eye.sees(q)) < 0.5 * NOTHING)
    }

    fn eye(&self) -> Eye<'_, N> {
        let [x, y, z] = self.shares([1.0; 3]);
        let of = |responses| {
            let [a, b, c] = self.shares(responses);
            [a / x, b / y, c / z]
        };
        let [[a, b, c], [d, e, f], [g, h, i]] =
            [of([1.0, 0.0, 0.0]), of([0.0, 1.0, 0.0]), of([0.0, 0.0, 1.0])];
        Eye { rows: &self.rows, to_xyz: [[a, d, g], [b, e, h], [c, f, i]] }
    }

    /// Returns X, Y and Z of a color, each of which is 1 for white.
    fn relative(&self, rgb: Rgb<S>) -> [f32; 3] {
        let (white, [x, y, z]) = (self.shares([1.0; 3]), self.shares(apply(&self.response, rgb.to_array())));
        [x / white[0], y / white[1], z / white[2]]
    }

    /// Returns the reflectance that has this color, without a search for the nearest if none does.
    #[inline(never)]
    pub(super) fn exact(&self, rgb: Rgb<S>) -> Option<SigmoidReflectance> {
        let problem = Problem::of(rgb.to_array(), &self.response);
        let solve = |responses| newton::solve::<N, M>(&self.rows, responses);
        if let Some(solved) = self.answered(rgb, problem, solve) {
            return (solved.status == Status::Exact).then_some(solved.spectrum);
        }
        let (q, found) = self.descended(&self.eye(), self.relative(rgb));
        found.then_some(SigmoidReflectance::of(q))
    }
}
