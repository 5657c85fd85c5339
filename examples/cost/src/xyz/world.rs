//! Lamps and surfaces with their exact colors, which are f64 sums at every 0.1 nm from 360 to 830 nm of the
//! straight lines that join the data.

use super::lamps::{self, Class};
use model::fine::{Curve, FineEye, values};
use model::interpolation::Outside;
use model::lab::lab;
use model::tables::{Observer, samples};
use nanospectra::color::{Rgb, Srgb, Xyz};
use nanospectra::observer::CIE_1931;
use nanospectra::{Factor, Fine, FineObserver, Interpolation, Power};

/// Samples as the crate takes them: (nm, value).
pub type Points = Vec<(f32, f32)>;

pub struct World {
    pub lamps: Vec<Lamp>,
    pub sets: Vec<Set>,
    /// The colors of the color evaluation samples under D65, for products of RGB colors.
    pub rgb: Vec<[f32; 3]>,
}

/// Surfaces that are looked at together.
pub type Set = Vec<Surface>;

/// What a light is multiplied by: one reflectance or transmittance, or two for two bounces.
pub struct Surface {
    pub factors: Vec<Points>,
    /// The product of the factors at every 0.1 nm.
    values: Vec<f64>,
}

/// A lamp with the exact colors of white and of all surfaces under it.
pub struct Lamp {
    pub class: Class,
    pub points: Points,
    /// The observer of the crate at 1 nm in the light of this lamp. Its scale is that of the exact white.
    pub eye: FineObserver<3, Factor>,
    /// The weights of the exact sums.
    pub fine: FineEye,
    pub white: [f64; 3],
    /// The exact Lab of each surface of each set.
    pub truth: Vec<Vec<[f64; 3]>>,
    pub rgb: [f32; 3],
}

/// The first set: the color evaluation samples.
pub const CES: usize = 0;
/// The second set: pairs of samples that light meets one after the other.
pub const TWO_BOUNCES: usize = 1;
/// The first of the sets of filters. The narrowest filters come first.
pub const FILTERS: usize = 2;

/// The full widths of the filters at half their height, in nm.
const FILTER_WIDTHS: [f64; 3] = [10.0, 20.0, 40.0];

/// The number of pairs of samples.
const BOUNCES: usize = 60;

impl World {
    pub fn new() -> Self {
        let ces: Vec<(Points, Vec<f64>)> = (1..=99)
            .map(|k| samples("samples/cie224_ces99_1nm.csv", &format!("CES{k:02}")).points())
            .map(|points| (singles(&points), values(&Curve::new(points, Outside::Hold))))
            .collect();
        let sets = sets(&ces);
        let lamps: Vec<Lamp> = lamps::all().into_iter().map(|lamp| Lamp::new(lamp, &sets)).collect();
        let daylight = FineEye::new(
            Observer::Cie1931,
            &Curve::new(model::tables::source("D65").points(), Outside::Zero),
        );
        let rgb = ces.iter().map(|(_, values)| in_srgb(daylight.sees_values(values))).collect();
        World { lamps, sets, rgb }
    }

    /// Returns the number of lamps of a class.
    pub fn count(&self, class: Class) -> usize {
        self.lamps.iter().filter(|lamp| lamp.class == class).count()
    }
}

fn sets(ces: &[(Points, Vec<f64>)]) -> Vec<Set> {
    let one = |(points, values): &(Points, Vec<f64>)| Surface {
        factors: vec![points.clone()],
        values: values.clone(),
    };
    let two = |k: usize| {
        let ((a, a_values), (b, b_values)) = (&ces[k * 5 % 99], &ces[(k * 7 + 31) % 99]);
        Surface {
            factors: vec![a.clone(), b.clone()],
            values: a_values.iter().zip(b_values).map(|(a, b)| a * b).collect(),
        }
    };
    let mut sets: Vec<Set> = vec![ces.iter().map(one).collect(), (0..BOUNCES).map(two).collect()];
    sets.extend(FILTER_WIDTHS.map(|width| -> Set {
        (420..=680).step_by(5).map(|center| filter(f64::from(center), width)).collect()
    }));
    sets
}

/// Makes a filter whose transmittance is a Gaussian with the value 1 at its center.
fn filter(center: f64, width: f64) -> Surface {
    let points: Vec<(f64, f64)> = (0..=940)
        .map(|k| 360.0 + f64::from(k) / 2.0)
        .map(|nm| (nm, (-4.0 * std::f64::consts::LN_2 * ((nm - center) / width).powi(2)).exp()))
        .collect();
    Surface { factors: vec![singles(&points)], values: values(&Curve::new(points, Outside::Hold)) }
}

impl Lamp {
    fn new(lamp: lamps::Lamp, sets: &[Set]) -> Self {
        let points = singles(&lamp.points);
        let fine = FineEye::new(Observer::Cie1931, &Curve::new(lamp.points, Outside::Zero));
        // Tables are interpolated, as the CIE recommends. Lines, which are narrower than 1 nm, are averaged.
        let light: Fine<Power> = if lamp.class == Class::Lines {
            Fine::from_samples(&points)
        } else {
            Fine::interpolated(&points, Interpolation::Linear)
        }
        .expect("lamps have increasing wavelengths");
        let white = fine.white();
        let seen = |surface: &Surface| lab(fine.sees_values(&surface.values), white);
        let truth = sets.iter().map(|set| set.iter().map(seen).collect()).collect();
        Lamp {
            class: lamp.class,
            eye: CIE_1931.under(&light).scaled(fine.scale()),
            points,
            white,
            truth,
            rgb: in_srgb(white),
            fine,
        }
    }
}

fn singles(points: &[(f64, f64)]) -> Points {
    points.iter().map(|&(nm, value)| (nm as f32, value as f32)).collect()
}

fn in_srgb(xyz: [f64; 3]) -> [f32; 3] {
    Rgb::<Srgb>::from_xyz(Xyz::from(xyz.map(|value| value as f32))).to_array()
}
