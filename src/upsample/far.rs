//! Colors for which Newton's method finds no sigmoid: those near the limit of what sigmoids have, and those
//! beyond it.

use crate::color::matrix::apply;
use crate::color::{Rgb, RgbSpace};
use crate::grid::Grid;
use crate::upsample::descent::descend;
use crate::upsample::edges;
use crate::upsample::meaning::SigmoidReflectance;
use crate::upsample::newton;
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
    /// scale, that has the color or comes as near to it as possible. Without `nearest` only what the first
    /// descent finds is exact, and no nearest color is searched.
    #[inline(never)]
    pub(super) fn far(&self, asked: Rgb<S>, nearest: bool) -> Solved<SigmoidReflectance> {
        let (eye, responses) = (self.eye(), apply(&self.response, asked.to_array()));
        let xyz = apply(&eye.to_xyz, responses);
        let exposed = Asked::new(xyz, 0.5);
        let mut q = descend(&eye, exposed.xyz, exposed.exposure, [0.0; 3]);
        let mut exact = exposed.delta_e(eye.sees(q)) < 0.5 * NOTHING;
        if !exact && nearest {
            // What counts now is the difference of the colors as they are.
            let plain = Asked::new(xyz, DARKEST);
            let again = descend(&eye, plain.xyz, plain.exposure, q);
            let [a, b, c] = responses;
            let (edges, off_edges) = edges::nearest(&eye, &plain, (a + b + c) * (1.0 / 3.0));
            let (off, off_again) = (plain.delta_e(eye.sees(q)), plain.delta_e(eye.sees(again)));
            let (found, off) = if off_again < off { (again, off_again) } else { (q, off) };
            let (found, off) = if off_edges < off { (edges, off_edges) } else { (found, off) };
            (q, exact) = (found, off < NOTHING);
        }
        let status = if exact {
            Status::Exact
        } else {
            Status::Unreachable(self.miss(asked, newton::responses(&self.rows, q)))
        };
        Solved { spectrum: SigmoidReflectance::of(q), status }
    }

    fn eye(&self) -> Eye<'_, N> {
        Eye {
            rows: &self.rows,
            to_xyz: self.share_matrix().map(|row| {
                let white: f32 = row.iter().sum();
                row.map(|share| share / white)
            }),
        }
    }
}
