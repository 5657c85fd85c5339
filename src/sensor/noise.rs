//! How far a reading may be off by chance, carried through to X, Y, Z, color temperature and Duv.

use crate::color::{Cct, Uv1960, Xyz};
use crate::math::sqrt;
use crate::sensor::{BasicCounts, Calibration, Count, Exposure};

/// How noisy the counts of a chip are. Neither number is in most data sheets: repeat a reading of a steady lamp,
/// and one in the dark, and fit the variances.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Noise {
    /// Electrons that make one count at unit gain, above zero: the shot noise. Infinite for none.
    pub electrons_per_count: f32,
    /// What the converter adds to each count, rms, in counts, whatever the exposure; without the rounding to whole
    /// counts, which is known (1/12 of a count squared).
    pub read_counts: f32,
}

impl Noise {
    /// The variances of one reading: shot noise, read noise and the rounding to whole counts.
    ///
    /// At gain g a count n came from n / g * `electrons_per_count` electrons and so has the shot variance
    /// n g / `electrons_per_count`. The counts are raw ones, with their dark level in them: it is noisy too. Below
    /// zero there is no shot noise; NaN stays NaN.
    ///
    /// ```
    /// # use nanospectra::sensor::{Exposure, Noise};
    /// let noise = Noise { electrons_per_count: 100.0, read_counts: 2.0 };
    /// let [of_one_count] = noise.variances(&Exposure::new(1.0, 1.0, 65_535), &[10_000_u16]).to_array();
    /// assert!((of_one_count - (100.0 + 4.0 + 1.0 / 12.0)).abs() < 1e-4);
    /// ```
    #[must_use]
    pub fn variances<T: Count, const C: usize>(&self, exposure: &Exposure, counts: &[T; C]) -> Variances<C> {
        let shot = exposure.gain() / self.electrons_per_count;
        let rest = self.read_counts * self.read_counts + 1.0 / 12.0;
        let mut variances = [0.0; C];
        for (variance, count) in variances.iter_mut().zip(counts) {
            let count = count.to_f32();
            let above_zero = if count < 0.0 { 0.0 } else { count };
            *variance = (above_zero * shot + rest) * exposure.per_count() * exposure.per_count();
        }
        Variances(variances)
    }
}

/// The variance of each channel of [`BasicCounts`]; channels are independent of each other.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct Variances<const C: usize>([f32; C]);

impl<const C: usize> Variances<C> {
    /// From variances of basic counts: of repeated readings, say.
    #[must_use]
    pub const fn new(variances: [f32; C]) -> Self {
        Variances(variances)
    }

    /// One for each channel, in (counts per ms at unit gain) squared.
    #[must_use]
    pub const fn to_array(self) -> [f32; C] {
        self.0
    }

    /// With another cause of noise that is independent of this one: of the dark frame that was taken off.
    #[must_use]
    pub fn plus(mut self, other: &Variances<C>) -> Self {
        for (variance, more) in self.0.iter_mut().zip(&other.0) {
            *variance += more;
        }
        self
    }

    /// Of the mean of `readings` such readings, 1 or more.
    #[must_use]
    pub fn of_mean(mut self, readings: u16) -> Self {
        for variance in &mut self.0 {
            *variance /= f32::from(readings.max(1));
        }
        self
    }

    /// The standard uncertainty of each channel (k = 1): the square roots.
    #[must_use]
    pub fn uncertainty(&self) -> BasicCounts<C> {
        BasicCounts::new(self.0.map(root))
    }
}

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
    /// How X, Y and Z of a reading vary, together: they share channels.
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
    a.iter().zip(b).zip(&variances.0).map(|((a, b), variance)| a * b * variance).sum()
}

/// Rounding may leave a variance of nothing a little below zero.
fn root(variance: f32) -> f32 {
    if variance < 0.0 { 0.0 } else { sqrt(variance) }
}

/// How X, Y and Z vary together: the symmetric matrix of their covariances, in the units of XYZ squared.
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
    /// The standard uncertainties (k = 1) of X, Y and Z. That of Y is that of lux, if the calibration was in lux.
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
        // Along u and v; at an edge of the range, where one of these may lead out of it both ways, along diagonals.
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

#[cfg(feature = "defmt")]
impl<const C: usize> defmt::Format for Variances<C> {
    fn format(&self, fmt: defmt::Formatter<'_>) {
        defmt::write!(fmt, "Variances({})", self.0.as_slice());
    }
}
