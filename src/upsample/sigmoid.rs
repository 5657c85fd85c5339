//! Upsampling by a sigmoid of a quadratic: from an RGB to the numbers of the curve that has it.

use crate::color::matrix::{Matrix, Matrix64, apply, inverse64, product64, rounded};
use crate::color::{Rgb, RgbSpace, Srgb, Xyz};
use crate::grid::{Bins, Grid};
use crate::math::const_for;
use crate::upsample::meaning::{SigmoidIlluminant, SigmoidReflectance, SigmoidUnbounded};
use crate::upsample::newton::{self, Found, Rows};
use crate::upsample::problem::{Problem, range};
use crate::upsample::shape::{Shape, X};
use crate::upsample::start::{CubicStart, StartMap};
use crate::upsample::status::{Miss, Solved, Status};
use crate::upsample::tables::RESPONSES;
use crate::upsample::viewing::Viewing;
use core::marker::PhantomData;

/// Finds for an RGB a spectrum that is smooth, within 0..=1, and has exactly that color on the grid at hand.
///
/// Make it by [`new`](Self::new) while compiling. Call [`reflectance`](Self::reflectance) for a surface,
/// [`illuminant`](Self::illuminant) for a light, and [`reflectance_each`](Self::reflectance_each) for many
/// colors. See the [example](crate::upsample#example) of the module.
///
/// The spectrum is a sigmoid of a quadratic in the wavelength ([`Shape`]).
///
/// # Which colors are solved
/// * A gray has a constant spectrum, exactly. Black is exactly 0, and white exactly 1.
/// * Components may be below 0 or above 1: a color outside the RGB space is solved if a sigmoid has it. As a
///   reflectance, a color brighter than white becomes white and one darker than black becomes black, and the
///   [`Status`] says so.
/// * If a component is NaN or infinite, the spectrum is NaN, and the status says so.
/// * The spectrum of `k` times a dark color (largest component below 1/2) is `k` times its spectrum, unless
///   only a sigmoid without a scale has one of the two.
///
/// # Accuracy
/// On `Nodes<400, 700>` N = 31, `Bins<400, 700>` N = 60 and `Nodes<380, 780>` N = 81, every one of the 2^24
/// 8-bit sRGB colors is found so that the CIE 1931 observer sees its code again. The color is within 0.00042
/// (`CubicStart`), 0.00035 (`LinearStart`) and 0.00034 CIEDE2000 (`QuinticStart`) (`tests/upsample/all.rs`).
///
/// Of a cube of 17^3 colors, encoded by the sRGB curve, a spectrum is found on 81 bands for 96.5 % in Display
/// P3, 79.6 % in BT.2020, 95.8 % in Adobe RGB and 69.6 % in ACEScg. On 31 bands it is 96.2 % in Display P3
/// and 79.0 % in BT.2020; in BT.2020 encoded by BT.1886 it is 77.2 %. No sigmoid of a quadratic was found for
/// the other colors, and the status says so.
///
/// With fewer than 31 bands, or with bands wider than 10 nm, more colors need damped steps. With N = 16 all
/// colors of sRGB are found.
///
/// # Colors out of reach
/// Where Newton's method finds no curve, a search of all sigmoids follows, and then one of the spectra at
/// their limit, which are 1 in a band of wavelengths and 0 elsewhere, or the other way round. No surface of
/// any kind has colors beyond this limit. Of the cubes above and one of ProPhoto RGB, no color is called
/// unreachable for which a search in f64 finds a sigmoid. The CIEDE2000 difference of the nearest color is
/// within 2 % of the least that any surface has, or within 0.025 of it (`tests/upsample/reach.rs`).
///
/// # Cost
/// A color takes 2 to 6 steps of Newton's method. At N = 31 that is 385 ns in the mean on x86-64, and 4500
/// instructions on a Cortex-M4F, 7900 at most. It holds `16 N + 48` bytes, beside the constants of its
/// starting polynomial `M`.
///
/// # Reference
/// W. Jakob, J. Hanika, "A low-dimensional function space for efficient spectral upsampling", Computer
/// Graphics Forum 38 (2019), for the family of curves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sigmoid<const N: usize, G = Bins<380, 730>, S = Srgb, M = CubicStart> {
    pub(super) rows: Rows<N>,
    /// The matrix from RGB to responses.
    pub(super) response: [[f32; 3]; 3],
    /// The responses of white before they are scaled to 1.
    white: [f32; 3],
    kind: PhantomData<(G, S, M)>,
}

/// How many colors the solver takes at once. Eight fill the vectors of AVX, and four those of SSE, which has
/// too few registers for eight.
#[cfg(any(target_feature = "avx", target_os = "none"))]
const LANES: usize = 8;
#[cfg(not(any(target_feature = "avx", target_os = "none")))]
const LANES: usize = 4;

impl<const N: usize, G: Grid, S: RgbSpace, M: StartMap> Sigmoid<N, G, S, M> {
    /// Prepares the method for the observer, light, grid and RGB space of `viewing`, in f64; for `const` use.
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
    /// // No paint is as green as the green of Display P3 at full drive. Mixed with some gray it can be had.
    /// let green = Rgb::new(0.0, 1.0, 0.0);
    /// assert!(matches!(SIGMOID.reflectance(green).status, Status::Unreachable(_)));
    /// assert!(matches!(SIGMOID.desaturated(green).status, Status::Desaturated { kept, .. } if kept > 0.8));
    /// // As a light it is exact: at half the size it is a color that a sigmoid has.
    /// assert_eq!(SIGMOID.illuminant(green).status, Status::Exact);
    /// ```
    #[must_use]
    pub const fn new(viewing: &Viewing<N, G, S>) -> Self {
        let eye = viewing.eye.weights();
        let mixture: Matrix64 = widened(&RESPONSES);
        // Each response is scaled so that it is 1 for white.
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

    /// Returns a reflectance for a color in linear RGB, or if none is found, the one whose color is nearest
    /// in the sense of CIEDE2000.
    ///
    /// For components within 0..=1 the result is nearer to the color than that of
    /// [`desaturated`](Self::desaturated). For components above 1 its hue changes; take
    /// [`unbounded`](Self::unbounded) for them.
    ///
    /// See the [example](crate::upsample#example) of the module.
    ///
    /// # Cost
    /// On a Cortex-M4F it takes 1,180 bytes of stack at opt-level 3, and 1,600 at "s".
    #[must_use]
    pub fn reflectance(&self, rgb: Rgb<S>) -> Solved<SigmoidReflectance> {
        self.searched(rgb, true)
    }

    /// Returns the reflectance of a color, with the nearest if none has it and `nearest` is set.
    fn searched(&self, rgb: Rgb<S>, nearest: bool) -> Solved<SigmoidReflectance> {
        let problem = Problem::of(rgb.to_array(), &self.response);
        self.solved(rgb, problem, nearest, |responses| newton::solve::<N, M>(&self.rows, responses))
    }

    /// Returns a reflectance for a color in linear RGB, which is mixed with the gray of its luminance if no
    /// sigmoid is found for the color.
    ///
    /// As little gray is added as possible, to within 1/1000 of the way from gray to the color. So the
    /// luminance and the direction from gray stay, and the saturation is reduced. A color brighter than white
    /// becomes white, and one with a luminance below 0 becomes black. See the [example](Self::new) of `new`.
    ///
    /// # Cost
    /// A color for which no sigmoid is found takes up to 10 further searches of sigmoids, beside the one for
    /// the nearest that [`reflectance`](Self::reflectance) makes. That search compares some hundreds of colors.
    /// On a Cortex-M4F it takes 1,350 bytes of stack at opt-level 3, and 1,860 at "s".
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
            if let Solved { spectrum, status: Status::Exact } = self.searched(mixed, false) {
                kept = trial;
                best = at(spectrum, kept, mixed);
            }
            part *= 0.5;
        }
        best
    }

    /// Returns a spectrum of any size that has this color, for densities and for colors brighter than white.
    ///
    /// `rgb` is linear and may have components above 1.
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
        // Relative to the largest component, -1e6 is as far from any curve as a value that would overflow.
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

    /// Returns a light of this color, which is [`unbounded`](Self::unbounded) times the white of the viewing.
    ///
    /// `rgb` is linear and may have components above 1. See the [example](Self::new) of `new`.
    #[must_use]
    pub fn illuminant(&self, rgb: Rgb<S>) -> Solved<SigmoidIlluminant> {
        self.unbounded(rgb).map(|factor| SigmoidIlluminant { factor })
    }

    /// Returns the reflectances of eight colors, which takes less time than one call for each.
    ///
    /// The results have the same bits as those of [`reflectance`](Self::reflectance).
    ///
    /// # Cost
    /// A color takes 140 ns at N = 31 for x86-64-v3, and 295 ns for the default x86-64 target. On a
    /// Cortex-M4F it takes 2,400 bytes of stack at opt-level 3, and 2,620 at "s".
    #[must_use]
    pub fn reflectance_8(&self, rgb: &[Rgb<S>; 8]) -> [Solved<SigmoidReflectance>; 8] {
        let nothing = Solved { spectrum: SigmoidReflectance::gray(0.0), status: Status::Exact };
        let mut all = [nothing; 8];
        for (rgb, all) in rgb.as_chunks::<LANES>().0.iter().zip(all.as_chunks_mut::<LANES>().0) {
            self.solve_lanes(rgb, all);
        }
        all
    }

    /// Writes the reflectance of each color into `spectra`, and solves several at a time.
    ///
    /// If the slices differ in length, the shorter one decides how many are solved.
    ///
    /// ```
    /// # use nanospectra::color::Rgb;
    /// # use nanospectra::upsample::{Sigmoid, SigmoidReflectance, Solved, Status, Viewing};
    /// # use nanospectra::{Curve, light::D65, observer::CIE_1931};
    /// static VIEWING: Viewing<36> = Viewing::new(&CIE_1931.under(&D65.fine()).fold(Curve::Step));
    /// static SIGMOID: Sigmoid<36> = Sigmoid::new(&VIEWING);
    /// let black = Solved { spectrum: SigmoidReflectance::gray(0.0), status: Status::Exact };
    /// let colors = [Rgb::new(0.1, 0.5, 0.4), Rgb::new(0.3, 0.2, 0.1), Rgb::new(0.7, 0.7, 0.7)];
    /// let mut paints = [black; 3];
    /// SIGMOID.reflectance_each(&colors, &mut paints);
    /// assert_eq!(paints, colors.map(|color| SIGMOID.reflectance(color)));
    /// ```
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

    /// Returns the reflectance that has exactly this color, if undamped steps of Newton's method find one.
    ///
    /// `None` does not mean that no sigmoid has the color: [`reflectance`](Self::reflectance) searches
    /// further.
    ///
    /// This is the solver alone, for programs that have to be small. `rgb` is linear, and the grid has 6
    /// bands or more. The result has the same bits as that of [`reflectance`](Self::reflectance).
    ///
    /// ```
    /// # use nanospectra::color::Rgb;
    /// # use nanospectra::upsample::{Sigmoid, Viewing};
    /// # use nanospectra::{Curve, light::D65, observer::CIE_1931};
    /// static VIEWING: Viewing<36> = Viewing::new(&CIE_1931.under(&D65.fine()).fold(Curve::Step));
    /// static SIGMOID: Sigmoid<36> = Sigmoid::new(&VIEWING);
    /// let teal = Rgb::new(0.1, 0.5, 0.4);
    /// assert_eq!(SIGMOID.solve(teal), Some(SIGMOID.reflectance(teal).spectrum));
    /// assert_eq!(SIGMOID.solve(Rgb::new(2.0, 2.0, 2.0)), None); // brighter than white
    /// ```
    #[must_use]
    pub fn solve(&self, rgb: Rgb<S>) -> Option<SigmoidReflectance> {
        match Problem::of(rgb.to_array(), &self.response) {
            Problem::Done(share, exact) => exact.then_some(SigmoidReflectance::gray(share)),
            Problem::Solve { responses, scale, complement } => {
                let q = newton::exact::<N, M>(&self.rows, responses)?;
                Some(SigmoidReflectance { shape: Shape { q }, scale, complement })
            }
        }
    }

    #[inline(never)]
    fn solve_lanes<const L: usize>(&self, rgb: &[Rgb<S>; L], all: &mut [Solved<SigmoidReflectance>; L]) {
        let problems = rgb.map(|rgb| Problem::of(rgb.to_array(), &self.response));
        let mut responses = [[0.5; 3]; L];
        for (responses, problem) in responses.iter_mut().zip(&problems) {
            if let Problem::Solve { responses: asked, .. } = problem {
                *responses = *asked;
            }
        }
        let found = newton::solve_some::<L, N, M>(&self.rows, &responses);
        for (((rgb, solved), problem), found) in rgb.iter().zip(all).zip(problems).zip(found) {
            *solved = self.solved(*rgb, problem, true, |_| found);
        }
    }

    /// Returns the spectrum and the status of a problem, with the curve that `solve` finds, or else with one
    /// that is searched further.
    #[inline(always)]
    fn solved(
        &self,
        asked: Rgb<S>,
        problem: Problem,
        nearest: bool,
        solve: impl FnOnce([f32; 3]) -> Option<Found>,
    ) -> Solved<SigmoidReflectance> {
        let (responses, scale, complement) = match problem {
            Problem::Done(share, exact) => return self.done(asked, share, exact),
            Problem::Solve { responses, scale, complement } => (responses, scale, complement),
        };
        let Some((q, given)) = solve(responses) else { return self.far(asked, nearest) };
        if let Some(given) = given {
            let miss = if complement {
                self.miss(asked, given.map(|a| 1.0 - scale * a))
            } else {
                // Dark colors are compared after they have been enlarged, since as they are any two look
                // alike.
                Miss { asked: self.xyz(responses), given: self.xyz(given), white: self.xyz([1.0; 3]) }
            };
            if !miss.is_nothing() {
                return self.far(asked, nearest);
            }
        }
        Solved {
            spectrum: SigmoidReflectance { shape: Shape { q }, scale, complement },
            status: Status::Exact,
        }
    }

    /// Returns the spectrum and the status of a constant.
    fn done(&self, asked: Rgb<S>, share: f32, exact: bool) -> Solved<SigmoidReflectance> {
        let status = if exact {
            Status::Exact
        } else if share.is_nan() {
            Status::NotFinite
        } else {
            let miss = self.miss(asked, [share; 3]);
            if miss.is_nothing() { Status::Exact } else { Status::Unreachable(miss) }
        };
        Solved { spectrum: SigmoidReflectance::gray(share), status }
    }

    /// Returns the color that was asked for beside the one that has the responses `given`.
    #[inline(never)]
    pub(super) fn miss(&self, asked: Rgb<S>, given: [f32; 3]) -> Miss {
        Miss { asked: self.xyz_of(asked), given: self.xyz(given), white: self.xyz([1.0; 3]) }
    }

    fn xyz_of(&self, rgb: Rgb<S>) -> Xyz {
        self.xyz(apply(&self.response, rgb.to_array()))
    }

    fn xyz(&self, responses: [f32; 3]) -> Xyz {
        Xyz::from(self.shares(responses)).scaled(100.0)
    }

    /// Returns X, Y and Z of responses, as shares of the Y of white.
    fn shares(&self, [a, b, c]: [f32; 3]) -> [f32; 3] {
        let [u, v, w] = self.white;
        apply(&TO_XYZ, [u * a, v * b, w * c])
    }

    /// Returns the matrix that does the same.
    pub(super) fn share_matrix(&self) -> Matrix {
        let [u, v, w] = self.white;
        TO_XYZ.map(|[a, b, c]| [u * a, v * b, w * c])
    }
}

/// The matrix from the sums of responses to X, Y and Z.
static TO_XYZ: Matrix = rounded(&inverse64(&widened(&RESPONSES)));

const fn widened(m: &[[f32; 3]; 3]) -> Matrix64 {
    let [[a, b, c], [d, e, f], [g, h, i]] = *m;
    [[a as f64, b as f64, c as f64], [d as f64, e as f64, f as f64], [g as f64, h as f64, i as f64]]
}
