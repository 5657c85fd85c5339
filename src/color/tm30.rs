//! Color fidelity and gamut by ANSI/IES TM-30-18; its fidelity is that of CIE 224.

use crate::color::reference::{RenderingError, daylight, planckian, temperature};
use crate::color::{CamUcs, Ciecam02, Surround, ViewingConditions, Xyz};
use crate::math::{Math, Portable, sqrt};
use crate::observer::{CIE_1931, CIE_1964};
use crate::spectrum::{Fine, Power};
use crate::sum;
use crate::test_samples::CES;

/// The measures of TM-30, which describe how a light renders the 99 color evaluation samples.
///
/// [`tm30`] computes them. See the [example](tm30#example).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Tm30 {
    /// The fidelity index Rf, 0..=100, where 100 means that all samples look as under the reference.
    ///
    /// See the [example](tm30#example).
    pub rf: f32,
    /// The gamut index Rg, which is 100 for the reference and larger if colors are more saturated.
    ///
    /// See the [example](tm30#example).
    pub rg: f32,
    /// The fidelity index of each sample, which is 0..=100.
    ///
    /// See the [example](tm30#example).
    pub rf_ces: [f32; 99],
    /// The 16 hue bins, counterclockwise from a' > 0; a bin that holds no sample is `None`.
    ///
    /// See the [example](tm30#example).
    pub bins: [Option<HueBin>; 16],
    /// The correlated color temperature that the light has, and its reference too, in K.
    ///
    /// See the [example](tm30#example).
    pub cct_k: f32,
    /// The distance of the light from the Planckian locus, which is positive above it.
    pub duv: f32,
}

/// The mean rendering of the samples that fall into one sixteenth of the hue circle.
///
/// See the [example](tm30#example).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HueBin {
    /// The local fidelity index, 0..=100, of the samples that are in this bin.
    pub rf: f32,
    /// The local chroma shift, which is given as a fraction of the reference's chroma (0.1 is 10 % more).
    ///
    /// See the [example](tm30#example).
    pub chroma_shift: f32,
    /// The local hue shift, which is given as a fraction of the reference's chroma along the hue circle and
    /// is nearly the angle in radians.
    pub hue_shift: f32,
    /// The number of samples that are in this bin.
    ///
    /// See the [example](tm30#example).
    pub count: u8,
}

/// Computes fidelity, gamut and the hue bins of a light by the TM-30-18 method.
///
/// The results are not rounded. Colors are those of the CIE 1964 observer in CAM02-UCS, and the color
/// temperature is that of the CIE 1931 observer; sums are over 380..=780 nm at 1 nm for both. The reference
/// is a black body up to 4000 K and CIE daylight from 5000 K; in between it is a mixture of both, made of
/// parts of equal Y.
///
/// # Accuracy
/// Rf and Rg are within 2e-4 of f64, over 1800 spectra of lamps that stand in no table, up to |Duv| = 0.05.
/// Where a search for the largest errors ended, Rf was off by 2.8e-4, and Rg by 1.6e-3 for a mixture of lines
/// that leaves the blue cone nearly no light of some sample (`tests/color/held_out.rs`). Near 100 the error
/// of Rf is always downward, because rounding makes two equal colors different: a black body, which is its
/// own reference, has a little less than 100. Rg and the bins change by a jump where a sample passes the edge
/// between two bins.
///
/// # Cost
/// 159 KB of samples; some 600 inner products of 401 terms. On a Cortex-M4F it takes 10,300 bytes of stack at
/// opt-level 3, and 10,200 at "s".
///
/// # Errors
/// Returns a [`RenderingError`] if the light is dark, if it is not a white, or if it has values so negative
/// that a sample has no color.
///
/// # Reference
/// ANSI/IES TM-30-18; CIE 224:2017, whose fidelity index is the same as Rf.
///
/// # Example
/// ```
/// use nanospectra::{Interpolation, color::tm30, light};
/// // Illuminant A is a black body, and so its own reference.
/// let a = tm30(&light::A.fine())?;
/// assert!(a.rf > 99.9 && (a.rg - 100.0).abs() < 0.1 && (a.cct_k - 2855.5).abs() < 1.0);
///
/// // FL4, a warm white fluorescent lamp, shows few saturated colors: its Rg is well below 100.
/// let lamp = tm30(&light::FL4.interpolate(Interpolation::Sprague))?;
/// assert!((lamp.rf - 56.700).abs() < 1e-3 && (lamp.rg - 83.491).abs() < 1e-3); // as f64 gives them
/// // The samples of the first hue bin, reds, lose more than a quarter of their chroma.
/// let red = lamp.bins[0].ok_or(nanospectra::color::RenderingError::Dark)?;
/// assert!(red.chroma_shift < -0.25 && red.count > 0);
/// assert!(lamp.rf_ces.iter().all(|rf| (0.0..=100.0).contains(rf)));
/// # Ok::<(), nanospectra::color::RenderingError>(())
/// ```
pub fn tm30(light: &Fine<Power>) -> Result<Tm30, RenderingError> {
    let (cct_k, duv) = temperature_within(light)?;
    // The light first, and then its reference, so that only one observer is on the stack.
    let (mut test, mut standard) = ([CamUcs::default(); 99], [CamUcs::default(); 99]);
    look(light, &mut test)?;
    look_under_reference(cct_k, &mut standard)?;
    compared(&test, &standard, cct_k, duv)
}

// Functions that are not inlined give their memory back before the next one is called.

/// Compares how the samples look under the light and under its reference, which has this CCT.
#[inline(never)]
fn compared(
    test: &[CamUcs; 99],
    standard: &[CamUcs; 99],
    cct_k: f32,
    duv: f32,
) -> Result<Tm30, RenderingError> {
    let mut rf_ces = [0.0; 99];
    let mut bins = [Bin::default(); 16];
    let mut total = 0.0;
    for (rf, (a, b)) in rf_ces.iter_mut().zip(test.iter().zip(standard)) {
        let difference = a.distance(*b);
        *rf = fidelity(difference);
        total += difference;
        // Counterclockwise from a' > 0, in sixteenths of the circle.
        let turns = Portable::atan2(b.b, b.a) / core::f32::consts::TAU;
        let sector = if turns < 0.0 { turns + 1.0 } else { turns } * 16.0;
        if let Some(bin) = bins.get_mut((sector as usize).min(15)) {
            bin.add(*a, *b, difference);
        }
    }
    let rf = fidelity(total / 99.0);
    let rg = 100.0 * area(&bins, |bin| bin.test) / area(&bins, |bin| bin.reference);
    // Where a sample has no color, both indices are NaN.
    if !rg.is_finite() {
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

/// Converts a mean color difference to a fidelity index, which approaches zero but does not go below.
fn fidelity(difference: f32) -> f32 {
    let plain = 100.0 - 6.73 * difference;
    10.0 * Portable::ln(Portable::exp(plain / 10.0) + 1.0)
}

/// Returns the CCT and Duv of a light, which counts over 380..=780 nm.
#[inline(never)]
fn temperature_within(light: &Fine<Power>) -> Result<(f32, f32), RenderingError> {
    temperature(&light.within(380.0, 780.0))
}

/// Computes how the samples look under the reference light of this temperature.
#[inline(never)]
fn look_under_reference(cct_k: f32, colors: &mut [CamUcs; 99]) -> Result<(), RenderingError> {
    let mut light = Fine::flat(0.0);
    reference(cct_k, &mut light);
    look(&light, colors)
}

/// Makes the reference light of this temperature, which counts over 380..=780 nm.
#[inline(never)]
fn reference(cct_k: f32, light: &mut Fine<Power>) {
    if cct_k >= 5000.0 {
        *light = daylight(cct_k);
        return;
    }
    planckian(cct_k, light);
    if cct_k > 4000.0 {
        let day = daylight(cct_k);
        let share = (cct_k - 4000.0) / 1000.0;
        let (of_black, of_day) = ((1.0 - share) / luminance(light), share / luminance(&day));
        for (value, day) in light.values_mut().iter_mut().zip(day.values()) {
            *value = *value * of_black + day * of_day;
        }
    }
}

/// Returns the luminance of a light over 380..=780 nm.
#[inline(never)]
fn luminance(light: &Fine<Power>) -> f32 {
    let [_, y, _] = CIE_1931.sees(&light.within(380.0, 780.0));
    y
}

/// Where the samples begin on the CIE's grid: at 380 nm.
const FIRST: usize = 20;

/// Computes how the samples look under a light.
///
/// The observer has weights for the nanometers of the samples alone. Those before are a multiple of four, so
/// that only those of the eight partial sums change places which are added to each other first. The bits are
/// therefore those of sums over the whole grid.
#[inline(never)]
fn look(light: &Fine<Power>, colors: &mut [CamUcs; 99]) -> Result<(), RenderingError> {
    let mut eye = [[0.0; 401]; 3];
    for (weights, row) in eye.iter_mut().zip(CIE_1964.weights()) {
        let products = row.iter().zip(light.values()).skip(FIRST);
        for (weight, (row, light)) in weights.iter_mut().zip(products) {
            *weight = row * light;
        }
    }
    let white = Xyz::from(eye.each_ref().map(|row| sum::sum(row)));
    let scale = 100.0 / white.y;
    if !scale.is_finite() {
        return Err(RenderingError::Dark);
    }
    for weight in eye.as_flattened_mut() {
        *weight *= scale;
    }
    // An adapting luminance of 100 cd/m2, a background with Y = 20, and complete adaptation.
    let white = white.scaled(scale);
    let viewing =
        ViewingConditions::<Ciecam02>::of::<Portable>(white, 100.0, 100.0, 0.2, Surround::Average, 1.0);
    for (color, sample) in colors.iter_mut().zip(&CES) {
        *color = viewing.ucs_or_nan::<Portable>(Xyz::from(sum::rows(&eye, sample.values())));
    }
    Ok(())
}

/// The sums over the samples of a bin.
#[derive(Clone, Copy, Default)]
struct Bin {
    test: [f32; 2],
    reference: [f32; 2],
    difference: f32,
    count: u8,
}

impl Bin {
    fn add(&mut self, test: CamUcs, reference: CamUcs, difference: f32) {
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

/// Computes the area of the polygon of the bins' mean colors, to which a bin without samples gives no corner.
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
