//! Dominant wavelength and purity: where a ray from the white meets the spectral locus, drawn as
//! straight lines between its 1 nm points and closed by the purple line.

use super::chromaticity::xy;
use super::tables::Observer;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dominant {
    /// Negative for purples: then its magnitude is the complementary wavelength.
    pub nm: f64,
    /// Excitation purity |s - w| / |b - w|, with b on the locus or on the purple line.
    pub purity: f64,
    /// Colorimetric purity, NaN for purples.
    pub colorimetric_purity: f64,
    /// Where the ray through the sample leaves the diagram.
    pub boundary: [f64; 2],
    pub purple: bool,
    /// Wavelength met in the opposite direction, NaN when that is the purple line.
    pub complementary_nm: f64,
}

/// Chromaticities of the monochromatic lights from 360 to 830 nm.
pub fn spectral_locus(observer: Observer) -> Vec<[f64; 2]> {
    let [x, y, z] = observer.on_cie_grid();
    (0..x.len()).map(|i| xy([x[i], y[i], z[i]])).collect()
}

pub fn dominant(sample: [f64; 2], white: [f64; 2], locus: &[[f64; 2]]) -> Dominant {
    let towards = [sample[0] - white[0], sample[1] - white[1]];
    let ahead = meet(white, towards, locus);
    let behind = meet(white, [-towards[0], -towards[1]], locus).nm;
    let boundary = [white[0] + ahead.along * towards[0], white[1] + ahead.along * towards[1]];
    let purple = ahead.nm.is_nan();
    let purity = 1.0 / ahead.along;
    Dominant {
        nm: if purple { -behind } else { ahead.nm },
        purity,
        colorimetric_purity: if purple { f64::NAN } else { purity * boundary[1] / sample[1] },
        boundary,
        purple,
        complementary_nm: if purple { f64::NAN } else { behind },
    }
}

struct Meeting {
    /// In units of the ray's direction.
    along: f64,
    /// NaN on the purple line.
    nm: f64,
}

/// The nearest crossing, the locus before the purple line.
fn meet(from: [f64; 2], towards: [f64; 2], locus: &[[f64; 2]]) -> Meeting {
    let mut found: Option<Meeting> = None;
    for (i, pair) in locus.windows(2).enumerate() {
        if let Some((along, t)) = cross(from, towards, pair[0], pair[1])
            && found.as_ref().is_none_or(|earlier| along < earlier.along)
        {
            found = Some(Meeting { along, nm: 360.0 + i as f64 + t });
        }
    }
    found.unwrap_or_else(|| {
        let (along, _) = cross(from, towards, locus[locus.len() - 1], locus[0])
            .expect("a ray from inside the diagram leaves it");
        Meeting { along, nm: f64::NAN }
    })
}

/// Where ray and segment cross: distance along the ray, and 0 to 1 along the segment.
fn cross(from: [f64; 2], d: [f64; 2], p: [f64; 2], q: [f64; 2]) -> Option<(f64, f64)> {
    let s = [q[0] - p[0], q[1] - p[1]];
    let w = [p[0] - from[0], p[1] - from[1]];
    let determinant = d[0] * s[1] - d[1] * s[0];
    let along = (w[0] * s[1] - w[1] * s[0]) / determinant;
    let t = (w[0] * d[1] - w[1] * d[0]) / determinant;
    (determinant != 0.0 && along > 0.0 && (0.0..=1.0).contains(&t)).then_some((along, t))
}
