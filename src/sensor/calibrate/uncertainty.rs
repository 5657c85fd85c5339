//! How far a result may be off by chance: the noise of the counts, carried on to X, Y, Z, color temperature
//! and Duv.

use crate::color::{Cct, Uv1960, Xyz};
use crate::sensor::reading::root;
use crate::sensor::{Calibration, Variances};

impl<const C: usize, const D: usize> Calibration<C, D> {
    /// Computes the standard uncertainty (k = 1) of each result from the noise of the counts.
    ///
    /// That of a calibration in lux is in lux, that of PPFD in PPFD. It is of the noise alone: the
    /// calibration counts as exact.
    ///
    /// ```
    /// # use nanospectra::sensor::{Calibration, Variances};
    /// let to_lux = Calibration::from_rows([[3.0, 4.0]]);
    /// assert_eq!(to_lux.uncertainty(&Variances::new([1.0, 1.0])), [5.0]); // the root of 3^2 + 4^2
    /// ```
    #[must_use]
    pub fn uncertainty(&self, variances: &Variances<C>) -> [f32; D] {
        self.rows().map(|row| root(mixed(&row, &row, variances)))
    }
}

impl<const C: usize> Calibration<C> {
    /// Computes the covariance of X, Y and Z of a reading, which vary together because they share channels.
    ///
    /// See the [example](XyzCovariance#example) of [`XyzCovariance`].
    #[must_use]
    pub fn covariance(&self, variances: &Variances<C>) -> XyzCovariance {
        let [x, y, z] = self.rows();
        XyzCovariance {
            xx: mixed(x, x, variances),
            yy: mixed(y, y, variances),
            zz: mixed(z, z, variances),
            xy: mixed(x, y, variances),
            yz: mixed(y, z, variances),
            xz: mixed(x, z, variances),
        }
    }
}

fn mixed<const C: usize>(a: &[f32; C], b: &[f32; C], variances: &Variances<C>) -> f32 {
    a.iter().zip(b).zip(&variances.to_array()).map(|((a, b), variance)| a * b * variance).sum()
}

/// The covariance matrix of X, Y and Z, which says how noise moves a color, in the units of XYZ squared.
///
/// [`Calibration::covariance`] computes it from the noise of a reading; [`uncertainty`](Self::uncertainty)
/// and [`cct`](Self::cct) tell what it means for XYZ and for the color temperature.
///
/// # Example
///
/// ```
/// use nanospectra::sensor::{Calibration, Noise, ReadingError, chip::tcs3472};
///
/// static TO_LUX: Calibration<4> = Calibration::from_rows([
///     [3.0, 1.0, 1.0, 0.0],
///     [1.0, 3.0, 0.5, 0.0],
///     [0.0, 0.3, 5.5, 0.0],
/// ]);
/// let exposure = tcs3472::exposure(4.0, 235); // gain 4, 50.4 ms
/// let counts = [4000_u16, 4200, 3600, 12_000];
/// let xyz = TO_LUX.xyz(&exposure.basic_counts(&counts)?)?;
/// let noise = Noise { electrons_per_count: 100.0, read_counts: 2.0 };
/// let covariance = TO_LUX.covariance(&noise.variances(&exposure, &counts));
/// // 91.3 lx, known to 0.21 lx, most of which is 3 times the noise of the second channel.
/// let uncertainty = covariance.uncertainty();
/// assert!((xyz.y - 91.3).abs() < 0.1 && (uncertainty.y - 0.2075).abs() < 1e-3);
/// let Some(of_cct) = covariance.cct(xyz) else { return Ok(()) };
/// assert!(of_cct.mired < 2.0 && of_cct.duv < 0.002);
/// # Ok::<(), ReadingError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct XyzCovariance {
    /// The variance of X, which is the square of its uncertainty. See the [example](#example).
    pub xx: f32,
    /// The variance of Y, which is the square of its uncertainty.
    pub yy: f32,
    /// The variance of Z, which is the square of its uncertainty.
    pub zz: f32,
    /// The covariance of X and Y, which vary together.
    pub xy: f32,
    /// The covariance of Y and Z, which vary together.
    pub yz: f32,
    /// The covariance of X and Z, which vary together.
    pub xz: f32,
}

/// How uncertain a correlated color temperature and its Duv are, as standard uncertainties (k = 1).
///
/// [`XyzCovariance::cct`] computes it. See the [example](XyzCovariance#example).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CctUncertainty {
    /// The standard uncertainty of the color temperature, which is given in K.
    pub cct_k: f32,
    /// The same in mired (1e6 / K), a unit in which it depends less on the temperature.
    pub mired: f32,
    /// The standard uncertainty of Duv, which is positive or zero.
    pub duv: f32,
}

/// How far the chromaticity is moved to see how the temperature changes: 2 to 3 mired.
const STEP_UV: f32 = 5e-4;

impl XyzCovariance {
    /// Computes the standard uncertainties (k = 1) of X, Y and Z. See the [example](#example).
    ///
    /// That of Y is the uncertainty in lux, if the calibration was in lux.
    #[must_use]
    pub fn uncertainty(&self) -> Xyz {
        Xyz::new(root(self.xx), root(self.yy), root(self.zz))
    }

    /// Computes the standard uncertainties of the color temperature and Duv of `xyz`. See the
    /// [example](#example).
    ///
    /// The result is `None` if `xyz` has no color temperature. It is computed to first order, so the
    /// uncertainty of the chromaticity must be small beside its distances from the two ends of the locus
    /// (1000 K and infinite temperature) and from the center of curvature of the locus, which is 0.05 or more
    /// away.
    ///
    /// # Accuracy
    /// The uncertainty of the color temperature is within 1.6 %, and that of Duv within 0.4 %, of what the
    /// exact slopes give (swept in `tests/sensor/measures.rs`). The slopes are central differences of
    /// [`Uv1960::cct`] over 1e-3 in u and in v, and one-sided differences beside the ends of its range.
    ///
    /// # Cost
    /// It computes five color temperatures.
    ///
    /// # Reference
    /// JCGM 100:2008 (GUM), 5.2.2.
    #[must_use]
    pub fn cct(&self, xyz: Xyz) -> Option<CctUncertainty> {
        let at = xyz.uv1960()?;
        let here = Place::of(at)?;
        let (along_u, along_v) = here.slopes(at)?;
        let Uv1960 { u, v } = at;
        let size = xyz.x + 15.0 * xyz.y + 3.0 * xyz.z;
        let uncertainty = |by_u: f32, by_v: f32| {
            // Passes through u and v, which depend on X, Y and Z.
            let toward = by_u * u + by_v * v;
            let x = (4.0 * by_u - toward) / size;
            let y = (6.0 * by_v - 15.0 * toward) / size;
            let z = -3.0 * toward / size;
            let squares = x * x * self.xx + y * y * self.yy + z * z * self.zz;
            root(squares + 2.0 * (x * y * self.xy + y * z * self.yz + x * z * self.xz))
        };
        let mired = uncertainty(along_u.mired, along_v.mired);
        let duv = uncertainty(along_u.duv, along_v.duv);
        Some(CctUncertainty { cct_k: mired * (1e6 / (here.mired * here.mired)), mired, duv })
    }
}

/// Where a chromaticity lies beside the locus, or how fast both numbers change.
#[derive(Clone, Copy)]
struct Place {
    mired: f32,
    duv: f32,
}

impl Place {
    fn of(uv: Uv1960) -> Option<Self> {
        match uv.cct() {
            Cct::Near { cct_k, duv } => Some(Place { mired: 1e6 / cct_k, duv }),
            _ => None,
        }
    }

    /// Computes how fast both numbers change with u, and with v.
    fn slopes(self, at: Uv1960) -> Option<(Self, Self)> {
        // The ways go along u and v. At an edge of the range, where one of these may lead out of it in both
        // directions, diagonals take their place.
        let directions = [(1.0, 0.0), (0.0, 1.0), (0.7, 0.7), (0.7, -0.7)];
        let mut slopes = directions.into_iter().filter_map(|way| Some((way, self.slope(at, way)?)));
        let ((way_a, a), (way_b, b)) = (slopes.next()?, slopes.next()?);
        let area = way_a.0 * way_b.1 - way_a.1 * way_b.0;
        let by_u = |a: f32, b: f32| (a * way_b.1 - b * way_a.1) / area;
        let by_v = |a: f32, b: f32| (b * way_a.0 - a * way_b.0) / area;
        let along_u = Place { mired: by_u(a.mired, b.mired), duv: by_u(a.duv, b.duv) };
        let along_v = Place { mired: by_v(a.mired, b.mired), duv: by_v(a.duv, b.duv) };
        Some((along_u, along_v))
    }

    /// Computes how fast both numbers change along the way (u, v) from `at`, which is here.
    fn slope(self, at: Uv1960, way: (f32, f32)) -> Option<Self> {
        let (u, v) = (STEP_UV * way.0, STEP_UV * way.1);
        let after = Place::of(Uv1960 { u: at.u + u, v: at.v + v });
        let before = Place::of(Uv1960 { u: at.u - u, v: at.v - v });
        let steps = match (before, after) {
            (None, None) => return None,
            (Some(_), Some(_)) => 2.0,
            _ => 1.0,
        };
        let (before, after) = (before.unwrap_or(self), after.unwrap_or(self));
        let per_step = 1.0 / (steps * STEP_UV);
        Some(Place {
            mired: (after.mired - before.mired) * per_step,
            duv: (after.duv - before.duv) * per_step,
        })
    }
}
