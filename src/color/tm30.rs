//! Color fidelity and gamut after ANSI/IES TM-30-18 (fidelity: CIE 224).

use crate::color::Xyz;
use crate::color::cam02ucs::{Cam02Ucs, Viewing};
use crate::color::reference::{RenderingError, daylight, planckian, temperature};
use crate::math::{Math, Portable, sqrt};
use crate::observer::{CIE_1931, CIE_1964, FineObserver};
use crate::spectrum::{Factor, Fine, Power};
use crate::test_samples::CES;

/// How a light renders the 99 color evaluation samples.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Tm30 {
    /// Fidelity index, 0..=100.
    pub rf: f32,
    /// Gamut index; 100 is the reference's, more is more saturated.
    pub rg: f32,
    /// Fidelity of each sample.
    pub rf_ces: [f32; 99],
    /// The 16 hue bins, counterclockwise from a' > 0; `None` for one that holds no sample.
    pub bins: [Option<HueBin>; 16],
    /// Correlated color temperature, K.
    pub cct_k: f32,
    /// Distance from the Planckian locus.
    pub duv: f32,
}

/// The samples of one sixteenth of the hue circle.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HueBin {
    /// Local fidelity, 0..=100.
    pub rf: f32,
    /// Local chroma shift, a fraction of the reference's chroma (0.1 is 10 % more).
    pub chroma_shift: f32,
    /// Local hue shift, a fraction of the reference's chroma along the hue circle (nearly radians).
    pub hue_shift: f32,
    /// How many samples are in it.
    pub count: u8,
}

/// The TM-30-18 method, unrounded.
///
/// CIE 1964 observer, sums over 380..=780 nm at 1 nm (also for the color temperature, which is on
/// the CIE 1931 observer); CAM02-UCS; between 4000 and 5000 K the reference is a mixture of black
/// body and daylight of equal Y.
///
/// # Accuracy
/// Rf and Rg are within 1.3e-4 of f64, over 63 lamps (`tests/color/rendering.rs`); Rg and the bins jump where
/// a sample sits on the edge between two bins.
///
/// # Cost
/// 159 KB of samples; some 600 inner products of 401 terms.
///
/// # Errors
/// [`RenderingError`]: dark, no white, or with values so negative that a sample has no color.
///
/// # Reference
/// ANSI/IES TM-30-18; CIE 224:2017.
pub fn tm30(light: &Fine<Power>) -> Result<Tm30, RenderingError> {
    let light = light.within(380.0, 780.0);
    let (cct_k, duv) = temperature(&light)?;
    let test = Judge::new(&light)?;
    let standard = Judge::new(&reference(cct_k))?;

    let mut rf_ces = [0.0; 99];
    let mut bins = [Bin::default(); 16];
    let mut total = 0.0;
    for (rf, sample) in rf_ces.iter_mut().zip(&CES) {
        let (a, b) = (test.looks_at(sample.values()), standard.looks_at(sample.values()));
        let difference = a.distance(b);
        *rf = fidelity(difference);
        total += difference;
        // Counterclockwise from a' > 0, in sixteenths of the circle.
        let turns = Portable::atan2(b.b, b.a) / core::f32::consts::TAU;
        let sector = if turns < 0.0 { turns + 1.0 } else { turns } * 16.0;
        if let Some(bin) = bins.get_mut((sector as usize).min(15)) {
            bin.add(a, b, difference);
        }
    }
    let rf = fidelity(total / 99.0);
    let rg = 100.0 * area(&bins, |bin| bin.test) / area(&bins, |bin| bin.reference);
    if !rf.is_finite() || !rg.is_finite() {
        return Err(RenderingError::Unreal);
    }
    Ok(Tm30 {
        rf,
        rg,
        rf_ces,
        bins: core::array::from_fn(|k| bins.get(k).and_then(|bin| bin.report(k))),
        cct_k,
        duv,
    })
}

/// From a mean difference to an index that ends softly at zero.
fn fidelity(difference: f32) -> f32 {
    let plain = 100.0 - 6.73 * difference;
    10.0 * Portable::ln(Portable::exp(plain / 10.0) + 1.0)
}

fn reference(cct_k: f32) -> Fine<Power> {
    let black = planckian(cct_k).within(380.0, 780.0);
    if cct_k <= 4000.0 {
        return black;
    }
    let day = daylight(cct_k).within(380.0, 780.0);
    if cct_k >= 5000.0 {
        return day;
    }
    let ([_, black_y, _], [_, day_y, _]) = (CIE_1931.sees(&black), CIE_1931.sees(&day));
    let share = (cct_k - 4000.0) / 1000.0;
    black * ((1.0 - share) / black_y) + day * (share / day_y)
}

/// The eye of the method under one light.
struct Judge {
    eye: FineObserver<3, Factor>,
    viewing: Viewing,
}

impl Judge {
    fn new(light: &Fine<Power>) -> Result<Self, RenderingError> {
        let mut eye = CIE_1964.under(light);
        let white = Xyz::from(eye.sees(&Fine::flat(1.0)));
        let scale = 100.0 / white.y;
        if !scale.is_finite() {
            return Err(RenderingError::Dark);
        }
        for weight in eye.0.as_flattened_mut() {
            *weight *= scale;
        }
        Ok(Judge { eye, viewing: Viewing::new(white.scaled(scale)) })
    }

    /// The samples are tabulated over 380..=780 nm, the middle of the eye's grid.
    fn looks_at(&self, sample: &[f32; 401]) -> Cam02Ucs {
        let mut fine = Fine::flat(0.0);
        if let Some(middle) = fine.values_mut().get_mut(20..).and_then(|rest| rest.first_chunk_mut()) {
            *middle = *sample;
        }
        self.viewing.appearance(Xyz::from(self.eye.sees(&fine)))
    }
}

/// Sums over the samples of a bin.
#[derive(Clone, Copy, Default)]
struct Bin {
    test: [f32; 2],
    reference: [f32; 2],
    difference: f32,
    count: u8,
}

impl Bin {
    fn add(&mut self, test: Cam02Ucs, reference: Cam02Ucs, difference: f32) {
        self.test = [self.test[0] + test.a, self.test[1] + test.b];
        self.reference = [self.reference[0] + reference.a, self.reference[1] + reference.b];
        self.difference += difference;
        self.count += 1;
    }

    fn report(&self, k: usize) -> Option<HueBin> {
        if self.count == 0 {
            return None;
        }
        let count = f32::from(self.count);
        let shift = [self.test[0] - self.reference[0], self.test[1] - self.reference[1]];
        let chroma = sqrt(self.reference[0] * self.reference[0] + self.reference[1] * self.reference[1]);
        let turns = (k as f32 + 0.5) / 16.0;
        let (cos, sin) = (Portable::cos_turns(turns), Portable::sin_turns(turns));
        Some(HueBin {
            rf: fidelity(self.difference / count),
            chroma_shift: (shift[0] * cos + shift[1] * sin) / chroma,
            hue_shift: (shift[1] * cos - shift[0] * sin) / chroma,
            count: self.count,
        })
    }
}

/// Area of the polygon of the bins' mean colors; a bin without samples has no corner.
fn area(bins: &[Bin; 16], color: fn(&Bin) -> [f32; 2]) -> f32 {
    let mut corners = bins.iter().filter(|bin| bin.count > 0).map(|bin| {
        let [a, b] = color(bin);
        [a / f32::from(bin.count), b / f32::from(bin.count)]
    });
    let Some(first) = corners.next() else { return 0.0 };
    let piece = |p: [f32; 2], q: [f32; 2]| p[0] * q[1] - p[1] * q[0];
    let (last, sum) = corners.fold((first, 0.0), |(p, sum), q| (q, sum + piece(p, q)));
    (sum + piece(last, first)) / 2.0
}
