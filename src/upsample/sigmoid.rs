//! The solver: from an RGB to the sigmoid that has it.

use crate::color::matrix::{Matrix64, apply, inverse64, product64, rounded};
use crate::color::{Rgb, RgbSpace, Srgb, Xyz};
use crate::grid::{Bins, Grid};
use crate::math::const_for;
use crate::upsample::meaning::{SigmoidIlluminant, SigmoidReflectance, SigmoidUnbounded};
use crate::upsample::newton::{self, Found, Rows};
use crate::upsample::shape::{Shape, X};
use crate::upsample::start::{CubicStart, StartMap};
use crate::upsample::status::{Miss, Solved, Status};
use crate::upsample::tables::RESPONSES;
use crate::upsample::viewing::Viewing;
use core::marker::PhantomData;

/// Upsampling by a sigmoid of a quadratic: smooth, within 0..=1, and exact on the grid it is made for.
///
/// Made by the compiler from a [`Viewing`]; what it holds is `16 N + 48` bytes, beside the constants of its
/// start map `M`.
///
/// # What goes in
/// * Any gray is exactly that constant, black exactly 0, white exactly 1.
/// * Components may be below 0 or above 1: a color outside the RGB space is solved if a sigmoid has it.
///   As reflectances, colors brighter than white become white and those darker than black black, and say so.
/// * With a NaN or an infinity the spectrum is NaN, and the status says so.
/// * `k` times a dark color (largest component below 1/2) is `k` times its spectrum.
///
/// # Accuracy
/// On `Nodes<400, 700>` N = 31, `Bins<400, 700>` N = 60 and `Nodes<380, 780>` N = 81 every one of the 2^24
/// 8-bit sRGB colors comes back as its code, for the 2 degree eye, within 0.00042 (`CubicStart`), 0.00035
/// (`LinearStart`) and 0.00034 CIEDE2000 (`QuinticStart`) (`tests/upsample/all.rs`). Of a 17^3 cube, encoded
/// by the sRGB curve, of Display P3 96.3 % are solved, of BT.2020 78.2 %, of Adobe RGB 95.8 %, of ACEScg 68.4
/// % on 81 bands (95.9 and 77.4 % on 31; of BT.2020 in the code values of BT.1886 74.6 %); the others are
/// outside what sigmoids of a quadratic can be, and say so. With fewer than 31 bands, or wider than 10 nm,
/// more colors need damped steps (N = 16: none of sRGB is missed).
///
/// # Cost
/// 2 to 6 steps; 385 ns a color in the mean at N = 31 on x86-64, 4500 instructions on a Cortex-M4F (7900 at
/// most).
///
/// # Reference
/// W. Jakob, J. Hanika, "A low-dimensional function space for efficient spectral upsampling", Computer
/// Graphics Forum 38 (2019), for the family of curves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sigmoid<const N: usize, G = Bins<380, 730>, S = Srgb, M = CubicStart> {
    rows: Rows<N>,
    /// RGB to responses.
    response: [[f32; 3]; 3],
    /// The responses of white before they are scaled to 1.
    white: [f32; 3],
    kind: PhantomData<(G, S, M)>,
}

/// A color on its way to the solver.
enum Problem {
    /// Nothing to solve: a constant, and whether it is the color.
    Done(f32, bool),
    /// Solve for `responses`; the reflectance is `scale` times that, or 1 minus so much.
    Solve { responses: [f32; 3], scale: f32, complement: bool },
}

/// How many colors the solver takes at once: eight fill the vectors of AVX, four those of SSE, where eight
/// spill.
#[cfg(any(target_feature = "avx", target_os = "none"))]
const LANES: usize = 8;
#[cfg(not(any(target_feature = "avx", target_os = "none")))]
const LANES: usize = 4;

impl<const N: usize, G: Grid, S: RgbSpace, M: StartMap> Sigmoid<N, G, S, M> {
    /// For this eye, light, grid and RGB space; for `const` use.
    ///
    /// ```
    /// use nanospectra::color::{DisplayP3, Rgb};
    /// use nanospectra::upsample::{QuinticStart, Sigmoid, Status, Viewing};
    /// use nanospectra::{Bins, Curve, light::D65, observer::CIE_1931};
    /// static VIEWING: Viewing<36, Bins<380, 730>, DisplayP3> = Viewing::new(
    ///     &CIE_1931.under(&D65.fine()).fold(Curve::Step),
    /// );
    /// static SIGMOID: Sigmoid<36, Bins<380, 730>, DisplayP3, QuinticStart> = Sigmoid::new(&VIEWING);
    /// assert_eq!(SIGMOID.reflectance(Rgb::new(0.9, 0.3, 0.2)).status, Status::Exact);
    /// // No paint is as green as the green of Display P3 at full drive; gray has a part in what comes nearest.
    /// let green = Rgb::new(0.0, 1.0, 0.0);
    /// assert!(matches!(SIGMOID.reflectance(green).status, Status::Unreachable(_)));
    /// assert!(matches!(SIGMOID.desaturated(green).status, Status::Desaturated { kept, .. } if kept > 0.8));
    /// // As light it is no problem: at half the size it is a color that a sigmoid has.
    /// assert_eq!(SIGMOID.illuminant(green).status, Status::Exact);
    /// ```
    #[must_use]
    pub const fn new(viewing: &Viewing<N, G, S>) -> Self {
        let eye = viewing.eye.weights();
        let mixture: Matrix64 = widened(&RESPONSES);
        // Each response is scaled to 1 for white.
        let white = viewing.eye.row_sums();
        let (mut normal, mut scale) = (mixture, [0.0; 3]);
        const_for!(0..3, |k| {
            let sum = mixture[k][0] * white[0] + mixture[k][1] * white[1] + mixture[k][2] * white[2];
            scale[k] = sum as f32;
            const_for!(0..3, |j| normal[k][j] = mixture[k][j] / sum);
        });
        let mut rows = [[0.0; 4]; N];
        const_for!(0..N, |n| {
            const_for!(0..3, |k| {
                let m = &normal[k];
                let (x, y, z) = (eye[0][n] as f64, eye[1][n] as f64, eye[2][n] as f64);
                let weight = m[0] * x + m[1] * y + m[2] * z;
                rows[n][k] = if -1e-30 < weight && weight < 1e-30 { 0.0 } else { weight as f32 };
            });
            rows[n][3] = X::<G, N>::ALL[n];
        });
        Sigmoid {
            rows,
            response: rounded(&product64(&normal, &widened(&viewing.to_xyz))),
            white: scale,
            kind: PhantomData,
        }
    }

    /// The reflectance that has exactly this color (linear RGB, on 6 bands or more), if undamped steps find
    /// one: the solver alone, for programs that must be small. The same bits as
    /// [`reflectance`](Self::reflectance).
    #[must_use]
    pub fn solve(&self, rgb: Rgb<S>) -> Option<SigmoidReflectance> {
        match self.problem(rgb.to_array()) {
            Problem::Done(share, exact) => exact.then_some(SigmoidReflectance::gray(share)),
            Problem::Solve { responses, scale, complement } => {
                let q = newton::exact::<N, M>(&self.rows, responses)?;
                Some(SigmoidReflectance { shape: Shape { q }, scale, complement })
            }
        }
    }

    /// The reflectance of a color (linear RGB). What no sigmoid has comes near by least squares: the
    /// primaries of BT.2020 within 2.5 to 9.6 CIEDE2000. For components within 0..=1 that is in the mean
    /// nearer than [`desaturated`](Self::desaturated); above 1 the hue turns, and
    /// [`unbounded`](Self::unbounded) is what to take.
    #[must_use]
    pub fn reflectance(&self, rgb: Rgb<S>) -> Solved<SigmoidReflectance> {
        let problem = self.problem(rgb.to_array());
        self.solved(rgb, problem, |responses| newton::solve::<N, M>(&self.rows, responses))
    }

    /// The reflectance of a color; what no sigmoid has is mixed with the gray of its luminance until one has
    /// it, to within 1/1000 of the way: same luminance, same direction from gray, less of it. What is
    /// brighter than white becomes white, what has a luminance below 0 black.
    ///
    /// # Cost
    /// Of an unsolvable color eleven times that of [`reflectance`](Self::reflectance), which is then 88
    /// steps.
    #[must_use]
    pub fn desaturated(&self, rgb: Rgb<S>) -> Solved<SigmoidReflectance> {
        let first = self.reflectance(rgb);
        if !matches!(first.status, Status::Unreachable(_)) {
            return first;
        }
        let [x, luminance, z] = self.shares(apply(&self.response, rgb.to_array()));
        let asked = Xyz::new(x, luminance, z).scaled(100.0);
        let gray = luminance.clamp(0.0, 1.0);
        let at = |spectrum, kept, rgb| {
            let miss = Miss { asked, given: self.xyz_of(rgb), white: self.xyz([1.0; 3]) };
            Solved { spectrum, status: Status::Desaturated { kept, miss } }
        };
        let mut best = at(SigmoidReflectance::gray(gray), 0.0, Rgb::new(gray, gray, gray));
        let (mut kept, mut part) = (0.0, 0.5);
        let halvings = if gray == luminance { 10 } else { 0 };
        for _ in 0..halvings {
            let trial = kept + part;
            let mixed = rgb.to_array().map(|c| gray + trial * (c - gray));
            let mixed = Rgb::new(mixed[0], mixed[1], mixed[2]);
            let solved = self.reflectance(mixed);
            if solved.status == Status::Exact {
                kept = trial;
                best = at(solved.spectrum, kept, mixed);
            }
            part *= 0.5;
        }
        best
    }

    /// The spectrum of any size whose curve is the color's: for densities and for what is brighter than
    /// white.
    #[must_use]
    pub fn unbounded(&self, rgb: Rgb<S>) -> Solved<SigmoidUnbounded> {
        let (_, largest) = range(rgb.to_array());
        let scale = 2.0 * largest;
        if scale == f32::INFINITY {
            let nothing = SigmoidUnbounded { shape: Shape { q: [0.0; 3] }, scale: f32::NAN };
            return Solved { spectrum: nothing, status: Status::NotFinite };
        }
        let finite = rgb.to_array().iter().all(|c| c.is_finite());
        if !finite || largest <= 0.0 {
            let black = self.reflectance(rgb);
            return black.map(|s| SigmoidUnbounded { shape: s.shape, scale: s.scale });
        }
        // Beside the largest, -1e6 is as far from any curve as what overflows.
        let half = rgb.to_array().map(|c| 0.5 * (c / largest).max(-1e6));
        let solved = self.reflectance(Rgb::new(half[0], half[1], half[2]));
        let status = match solved.status {
            Status::Unreachable(miss) => {
                Status::Unreachable(Miss { asked: self.xyz_of(rgb), given: miss.given.scaled(scale), ..miss })
            }
            status => status,
        };
        Solved { spectrum: SigmoidUnbounded { shape: solved.spectrum.shape, scale }, status }
    }

    /// The light of a color: [`unbounded`](Self::unbounded) times the white.
    #[must_use]
    pub fn illuminant(&self, rgb: Rgb<S>) -> Solved<SigmoidIlluminant> {
        self.unbounded(rgb).map(|factor| SigmoidIlluminant { factor })
    }

    /// Eight reflectances at once, the same bits as [`reflectance`](Self::reflectance) one by one.
    ///
    /// # Cost
    /// 140 ns a color at N = 31 for x86-64-v3, 295 ns for the default x86-64 target.
    #[must_use]
    pub fn reflectance_8(&self, rgb: &[Rgb<S>; 8]) -> [Solved<SigmoidReflectance>; 8] {
        let nothing = Solved { spectrum: SigmoidReflectance::gray(0.0), status: Status::Exact };
        let mut all = [nothing; 8];
        for (rgb, all) in rgb.as_chunks::<LANES>().0.iter().zip(all.as_chunks_mut::<LANES>().0) {
            self.solve_lanes(rgb, all);
        }
        all
    }

    /// A reflectance for each color, several at a time; the shorter of the two slices says how many.
    pub fn reflectance_each(&self, rgb: &[Rgb<S>], spectra: &mut [Solved<SigmoidReflectance>]) {
        let count = rgb.len().min(spectra.len());
        let (Some(rgb), Some(spectra)) = (rgb.get(..count), spectra.get_mut(..count)) else { return };
        let (whole, rest) = rgb.as_chunks::<LANES>();
        let (whole_spectra, rest_spectra) = spectra.as_chunks_mut::<LANES>();
        for (rgb, spectra) in whole.iter().zip(whole_spectra) {
            self.solve_lanes(rgb, spectra);
        }
        for (rgb, spectrum) in rest.iter().zip(rest_spectra) {
            *spectrum = self.reflectance(*rgb);
        }
    }

    #[inline(never)]
    fn solve_lanes<const L: usize>(&self, rgb: &[Rgb<S>; L], all: &mut [Solved<SigmoidReflectance>; L]) {
        let problems = rgb.map(|rgb| self.problem(rgb.to_array()));
        let mut responses = [[0.5; 3]; L];
        for (responses, problem) in responses.iter_mut().zip(&problems) {
            if let Problem::Solve { responses: asked, .. } = problem {
                *responses = *asked;
            }
        }
        let found = newton::solve_some::<L, N, M>(&self.rows, &responses);
        for (((rgb, solved), problem), found) in rgb.iter().zip(all).zip(problems).zip(found) {
            *solved = self.solved(*rgb, problem, |_| found);
        }
    }

    /// What the solver has to do for a color. (Written without `f32::max`, which is a call on a Cortex-M4F.)
    #[inline(always)]
    fn problem(&self, rgb: [f32; 3]) -> Problem {
        let [r, g, b] = rgb;
        let (smallest, largest) = range(rgb);
        // Zero times an infinity is NaN too.
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
        // (c + offset) * sign / size: c or 1 - c, enlarged to a largest component of 1/2.
        let (offset, sign, scale) = if largest < 0.5 {
            (0.0, 1.0, 2.0 * largest)
        } else if smallest > 0.5 {
            (1.0, -1.0, 2.0 * (1.0 - smallest))
        } else {
            (0.0, 1.0, 1.0)
        };
        let color = [(offset + sign * r) / scale, (offset + sign * g) / scale, (offset + sign * b) / scale];
        Problem::Solve { responses: apply(&self.response, color), scale, complement: sign < 0.0 }
    }

    /// From a problem to its spectrum, with the curve as `solve` finds it.
    #[inline(always)]
    fn solved(
        &self,
        asked: Rgb<S>,
        problem: Problem,
        solve: impl FnOnce([f32; 3]) -> Found,
    ) -> Solved<SigmoidReflectance> {
        let (responses, scale, complement) = match problem {
            Problem::Done(share, exact) => return self.done(asked, share, exact),
            Problem::Solve { responses, scale, complement } => (responses, scale, complement),
        };
        let (q, given) = solve(responses);
        let spectrum = SigmoidReflectance { shape: Shape { q }, scale, complement };
        let Some(given) = given else { return Solved { spectrum, status: Status::Exact } };
        let status = if complement {
            let miss = self.miss(asked, given.map(|a| 1.0 - scale * a));
            status_of(miss, miss)
        } else {
            // Dark colors are judged as bright as can be: else any would do.
            let miss = self.miss(asked, given.map(|a| scale * a));
            status_of(miss, Miss { asked: self.xyz(responses), given: self.xyz(given), ..miss })
        };
        Solved { spectrum, status }
    }

    /// Of a constant.
    fn done(&self, asked: Rgb<S>, share: f32, exact: bool) -> Solved<SigmoidReflectance> {
        let status = if exact {
            Status::Exact
        } else if share.is_nan() {
            Status::NotFinite
        } else {
            let miss = self.miss(asked, [share; 3]);
            status_of(miss, miss)
        };
        Solved { spectrum: SigmoidReflectance::gray(share), status }
    }

    /// A color and the responses it got.
    #[inline(never)]
    fn miss(&self, asked: Rgb<S>, given: [f32; 3]) -> Miss {
        Miss { asked: self.xyz_of(asked), given: self.xyz(given), white: self.xyz([1.0; 3]) }
    }

    fn xyz_of(&self, rgb: Rgb<S>) -> Xyz {
        self.xyz(apply(&self.response, rgb.to_array()))
    }

    fn xyz(&self, responses: [f32; 3]) -> Xyz {
        Xyz::from(self.shares(responses)).scaled(100.0)
    }

    /// X, Y and Z of responses as shares of the white's Y.
    fn shares(&self, [a, b, c]: [f32; 3]) -> [f32; 3] {
        static TO_XYZ: [[f32; 3]; 3] = rounded(&inverse64(&widened(&RESPONSES)));
        let [u, v, w] = self.white;
        apply(&TO_XYZ, [u * a, v * b, w * c])
    }
}

/// Exact if nobody could tell, as `seen`, else how far off.
#[inline(never)]
fn status_of(miss: Miss, seen: Miss) -> Status {
    if seen.is_nothing() { Status::Exact } else { Status::Unreachable(miss) }
}

/// The smallest and the largest.
#[inline(always)]
fn range([r, g, b]: [f32; 3]) -> (f32, f32) {
    let (low, high) = if r < g { (r, g) } else { (g, r) };
    (if b < low { b } else { low }, if b > high { b } else { high })
}

const fn widened(m: &[[f32; 3]; 3]) -> Matrix64 {
    let [[a, b, c], [d, e, f], [g, h, i]] = *m;
    [[a as f64, b as f64, c as f64], [d as f64, e as f64, f as f64], [g as f64, h as f64, i as f64]]
}
