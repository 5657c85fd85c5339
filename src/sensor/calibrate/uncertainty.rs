//! How far a result may be off by chance: the noise of the counts, carried through to X, Y, Z, color
//! temperature and Duv.

use crate::color::{Cct, Uv1960, Xyz};
use crate::sensor::reading::root;
use crate::sensor::{Calibration, Variances};

impl<const C: usize, const D: usize> Calibration<C, D> {
    /// The standard uncertainty (k = 1) of each result: lux of a calibration in lux, PPFD of one in PPFD.
    ///
    /// Of the noise alone: the calibration counts as exact.
    #[must_use]
    pub fn uncertainty(&self, variances: &Variances<C>) -> [f32; D] {
        self.rows().map(|row| root(mixed(&row, &row, variances)))
    }
}

impl<const C: usize> Calibration<C> {
    /// The covariance of X, Y and Z of a reading, which vary together because they share channels.
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

/// The covariance matrix of X, Y and Z, in the units of XYZ squared.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct XyzCovariance {
    /// Variance of X.
    pub xx: f32,
    /// Variance of Y.
    pub yy: f32,
    /// Variance of Z.
    pub zz: f32,
    /// Covariance of X and Y.
    pub xy: f32,
    /// Covariance of Y and Z.
    pub yz: f32,
    /// Covariance of X and Z.
    pub xz: f32,
}

/// Standard uncertainties (k = 1) of a correlated color temperature and its Duv.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CctUncertainty {
    /// Of the color temperature in K.
    pub cct_k: f32,
    /// Of the same in mired (1e6 / K), in which it depends less on the temperature.
    pub mired: f32,
    /// Of Duv.
    pub duv: f32,
}

/// How far the chromaticity is moved to see how the temperature changes: 2 to 3 mired.
const STEP_UV: f32 = 5e-4;

impl XyzCovariance {
    /// The standard uncertainties (k = 1) of X, Y and Z. That of Y is that of lux, if the calibration was in
    /// lux.
    #[must_use]
    pub fn uncertainty(&self) -> Xyz {
        Xyz::new(root(self.xx), root(self.yy), root(self.zz))
    }

    /// The standard uncertainties of the color temperature and Duv of `xyz`; `None` if it has none.
    ///
    /// To first order: as long as the chromaticity is uncertain by less than its distance from 1000 K, from
    /// infinite temperature, and from the center of curvature of the locus, which is 0.05 or more away.
    ///
    /// # Accuracy
    /// 1.6 % of color temperature, 0.4 % of Duv (swept in `tests/sensor/measures.rs`): the slopes are central
    /// differences of [`Uv1960::cct`] over 1e-3 in u and in v, one-sided ones beside the ends of its range.
    ///
    /// # Cost
    /// Five color temperatures.
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
            // Through u and v of X, Y and Z.
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

/// Where a chromaticity lies beside the locus; or the slopes of both.
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

    /// How both change with u, and with v.
    fn slopes(self, at: Uv1960) -> Option<(Self, Self)> {
        // Along u and v; at an edge of the range, where one of these may lead out of it both ways, along
        // diagonals.
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

    /// How both change along the way (u, v) from `at`, which is here.
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
