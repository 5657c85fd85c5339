//! Dominant wavelength and excitation purity.

use crate::color::{Xy, Xyz};
use crate::observer::FineObserver;

/// The distance from the white, in x, y, within which rounding decides the hue.
const ACHROMATIC: f32 = 1e-5;
/// The share of the largest distance from which on two crossings with the locus count as equally far out. (At
/// its ends the locus runs back along itself, so that a ray crosses it twice at nearly one place.)
const SAME_CUT: f32 = 0.999;
/// The angle in radians within which a ray may touch a node of the locus.
const TOUCH: f32 = 1e-4;
/// Below about 410 nm and above about 690 nm the locus runs back along itself. Of two crossings there, the
/// one whose wavelength is nearer to this one, in nm, is taken.
const MIDDLE_NM: f32 = 555.0;

/// The wavelength of the spectral color that gives a color when it is mixed with white, and how pure the
/// color is.
///
/// [`dominant_wavelength`] returns it. See the [example](dominant_wavelength#example).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DominantWavelength {
    /// The dominant wavelength in nm, or for a purple, which has none, the complementary wavelength with a
    /// minus sign (-499.6).
    ///
    /// See the [example](dominant_wavelength#example).
    pub nm: f32,
    /// The excitation purity, which is 0 for the white and 1 for a spectral color.
    ///
    /// It is the distance of the color from the white over that of the boundary (the spectrum locus or the
    /// purple line) in the same direction, 0..=1 for real colors. See the
    /// [example](dominant_wavelength#example).
    pub purity: f32,
}

/// Finds the dominant wavelength and the excitation purity of `sample` as seen against `white`.
///
/// `eye` is the observer to which both chromaticities belong. The white must be a real color, inside the
/// spectrum locus. The result is `None` if the sample is within 1e-5 of the white or is not a number.
///
/// The ray from the white through the sample is intersected with the spectrum locus of `eye`, which is taken
/// as straight between its 1 nm nodes, or with the purple line between its ends.
///
/// # Accuracy
/// 1.8e-4 nm between 450 and 650 nm, 5.5e-4 nm between 405 and 680 nm, and 6.4e-7 of purity, of lights from
/// 5 % of purity seen against equal energy. Outside that range the locus runs back along itself, and the
/// wavelength hangs on the last digits of x and y.
///
/// # Reference
/// CIE 15:2018, 10.4; the sign of the complementary wavelength follows ASTM E308.
///
/// # Example
/// ```
/// # use nanospectra::{color::{Xy, dominant_wavelength}, observer::CIE_1931};
/// let equal_energy = Xy::new(1.0 / 3.0, 1.0 / 3.0);
/// let amber = dominant_wavelength(Xy::new(0.466291, 0.460586), equal_energy, &CIE_1931).ok_or("white")?;
/// assert!((amber.nm - 578.600).abs() < 0.01 && (amber.purity - 0.78286).abs() < 1e-4);
/// # Ok::<(), &str>(())
/// ```
#[must_use]
pub fn dominant_wavelength(sample: Xy, white: Xy, eye: &FineObserver<3>) -> Option<DominantWavelength> {
    let ray = [sample.x - white.x, sample.y - white.y];
    let length = dot(ray, ray);
    if length.is_nan() || length < ACHROMATIC * ACHROMATIC {
        return None;
    }
    let locus = Locus { eye, white };
    if let Some((nm, reach)) = locus.cut(ray) {
        return Some(DominantWavelength { nm, purity: share(length, reach) });
    }
    // A deep red or violet light lies where the locus turns back at one of its ends, on or beyond the purple
    // line. A ray that just touches the locus there crosses nothing.
    let purple = locus.purple(ray);
    let (touched, reach, angle) = locus.nearest(ray)?;
    if angle < TOUCH && purple.is_none_or(|purple| length > purple * (1.0 - 1e-6)) {
        return Some(DominantWavelength { nm: touched, purity: share(length, reach) });
    }
    let (nm, _) = locus.cut([-ray[0], -ray[1]])?;
    Some(DominantWavelength { nm: -nm, purity: share(length, purple?) })
}

/// Computes a purity, and takes off what rounding adds to the 1 of a spectral color.
fn share(length: f32, reach: f32) -> f32 {
    let purity = length / reach;
    if purity > 1.0 && purity < 1.000_001 { 1.0 } else { purity }
}

fn dot(a: [f32; 2], b: [f32; 2]) -> f32 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: [f32; 2], b: [f32; 2]) -> f32 {
    a[0] * b[1] - a[1] * b[0]
}

/// The spectrum locus, seen from a white.
struct Locus<'a> {
    eye: &'a FineObserver<3>,
    white: Xy,
}

impl Locus<'_> {
    /// Returns a node as (nm, vector from the white), if the eye responds at its wavelength.
    fn node(&self, k: usize) -> Option<(f32, [f32; 2])> {
        let [Some(x), Some(y), Some(z)] = self.eye.weights().each_ref().map(|row| row.get(k)) else {
            return None;
        };
        let xy = Xyz::new(*x, *y, *z).xy()?;
        Some((360.0 + k as f32, [xy.x - self.white.x, xy.y - self.white.y]))
    }

    fn nodes(&self) -> impl DoubleEndedIterator<Item = (f32, [f32; 2])> {
        (0..471).filter_map(|k| self.node(k))
    }

    /// Finds where the ray crosses the locus, as the wavelength and the distance from the white times the
    /// length of the ray. Of several crossings it takes the outermost.
    fn cut(&self, ray: [f32; 2]) -> Option<(f32, f32)> {
        let mut found: Option<(f32, f32)> = None;
        let mut before = None;
        for b in self.nodes() {
            let Some(a) = before.replace(b) else { continue };
            let (from, to) = (cross(ray, a.1), cross(ray, b.1));
            if (from < 0.0) == (to < 0.0) {
                continue;
            }
            let t = from / (from - to);
            let reach = dot(ray, a.1) + t * (dot(ray, b.1) - dot(ray, a.1));
            let nm = a.0 + t * (b.0 - a.0);
            let (known, outermost) = found.unwrap_or((nm, 0.0));
            let nearer = (nm - MIDDLE_NM).abs() < (known - MIDDLE_NM).abs();
            if reach * SAME_CUT > outermost || (nearer && reach > outermost * SAME_CUT) {
                found = Some((nm, reach));
            }
        }
        found
    }

    /// Finds the node that the ray passes at the smallest angle, and returns its wavelength, its distance as
    /// in [`cut`](Self::cut), and the tangent of that angle.
    fn nearest(&self, ray: [f32; 2]) -> Option<(f32, f32, f32)> {
        let ahead = self.nodes().map(|(nm, node)| (nm, dot(ray, node), cross(ray, node).abs()));
        let angles = ahead.filter(|node| node.1 > 0.0).map(|(nm, reach, off)| (nm, reach, off / reach));
        angles.reduce(|best, node| if node.2 < best.2 { node } else { best })
    }

    /// Returns the distance, as in [`cut`](Self::cut), at which the ray crosses the purple line.
    fn purple(&self, ray: [f32; 2]) -> Option<f32> {
        let (blue, red) = (self.nodes().next()?.1, self.nodes().next_back()?.1);
        let (from, to) = (cross(ray, blue), cross(ray, red));
        let reach = dot(ray, blue) + from / (from - to) * (dot(ray, red) - dot(ray, blue));
        (reach > 0.0).then_some(reach)
    }
}
