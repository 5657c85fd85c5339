//! Brings a measured spectrum, given by samples with their lines in a file, to the 1 nm grid.

use crate::failure::{Failure, short};
use crate::input::bands;
use crate::measure::args::Between;
use crate::measure::exact;
use crate::measure::level::Kind;
use crate::output::number::shortest;
use nanospectra::observer::NamedObserver;
use nanospectra::{Factor, Fine, Interpolation, Outside, Power, Quantity, SamplesError};
use std::ops::RangeInclusive;
use std::rc::Rc;
use std::sync::Arc;

/// The ends of the CIE grid, in nm.
const FIRST: f64 = 360.0;
const LAST: f64 = 830.0;
/// The visible range, in nm. Data that ends within it gets a note; power beyond it hardly shows.
const VISIBLE_FROM: f64 = 380.0;
const VISIBLE_TO: f64 = 780.0;
/// The value above which a number is a percentage or not a reflectance at all. (Fluorescent and glossy
/// surfaces do exceed 1.)
const MOST_REFLECTANCE: f64 = 2.0;
/// The step, in nm, above which a note is given. CIE 15 asks for 5 nm or less.
const COARSE_NM: f64 = 20.0;
/// The step, in nm, below which samples are averaged over each nanometer. (A step of 1 nm may be rounded.)
const FINE_NM: f64 = 0.999;
/// The steps, in nm, for which Sprague's rule is nearer to spectra at 1 nm than straight lines are: see
/// `--interpolation` in the manual for the measurement.
const SPRAGUE_NM: RangeInclusive<f64> = 4.999..=20.001;
/// The fewest samples for that rule.
const SPRAGUE_LEAST: usize = 6;
/// How far a sample may be from its place, as a share of the step, if steps are equal.
const EQUAL: f64 = 1e-4;

/// A spectrum as it was read from a column of a file.
#[derive(Debug)]
pub struct Source {
    pub file: Rc<str>,
    pub name: String,
    /// Where it was read and who says what its numbers are, unless nothing had to be found out.
    pub origin: Option<String>,
    pub kind: Kind,
    /// What was stated, assumed and left out.
    pub notes: Rc<[String]>,
    /// What the file says beside its spectra, as names with their values.
    pub stated: Rc<[(String, String)]>,
    /// The line of each sample, counted from 1, or 0 if the file has no lines.
    pub lines: Arc<[usize]>,
    /// The pairs (wavelength in nm, value): at least two, finite, with increasing wavelengths.
    pub samples: Vec<(f64, f64)>,
    /// The edges of the bands over which the values are averages, or `None` for points of a curve.
    pub edges: Option<Vec<f64>>,
}

/// The rule that brings samples to 1 nm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// Straight lines, read at whole nanometers.
    Linear,
    Sprague,
    /// The means of straight lines over each nanometer.
    Means,
    /// Averages over bands, which are constant within each.
    Bands,
}

impl Rule {
    /// Returns the name in the report.
    pub fn name(self) -> &'static str {
        match self {
            Rule::Linear => "linear",
            Rule::Sprague => "sprague",
            Rule::Means => "means",
            Rule::Bands => "averages",
        }
    }
}

/// A light on the CIE grid, where the numbers of the file are `power` times `scale`.
#[derive(Debug)]
pub struct Lamp {
    /// The power, scaled to near 1 by a power of two, so that f32 holds lights of any strength.
    pub power: Fine<Power>,
    pub scale: f64,
}

impl Source {
    /// Returns the spectrum as a light, which is zero outside its samples.
    pub fn light(&self, by: Between) -> Result<Lamp, Failure> {
        self.check_reach()?;
        let peak = self.samples.iter().map(|sample| sample.1.abs()).fold(0.0, f64::max);
        if peak == 0.0 {
            return Err(self.wrong("every value is zero; measure again with the lamp on"));
        }
        // A power of two does not change how values are rounded to f32. It is applied in two steps, since
        // 2^1074 would overflow. (`powi` computes 2^-1074 as 1 / 2^1074, which would be 0.)
        let half = (peak.log2() / 2.0).floor() as i32;
        let (up, scale) = (f64::powi(2.0, -half), f64::powi(2.0, half).powi(2));
        let power = self.fine(by, |value| value * up * up)?;
        if power.values().iter().all(|value| *value == 0.0) {
            return Err(self.wrong(
                "there is no power at any whole nanometer of 360..830, so nothing is visible; \
                 give a spectrum that has some",
            ));
        }
        Ok(Lamp { power, scale })
    }

    /// Returns the spectrum as a reflectance, which keeps its end values outside its samples.
    pub fn reflectance(&self, by: Between) -> Result<Fine<Factor>, Failure> {
        self.check_reach()?;
        let above = self.samples.iter().position(|(_, value)| *value > MOST_REFLECTANCE);
        // A white that is shinier than its standard exceeds 1 here and there, but not everywhere.
        let all = || self.samples.iter().all(|(_, value)| *value > 1.0).then_some(0);
        if let Some(k) = above.or_else(all) {
            let value = shortest(self.samples[k].1);
            return Err(self.wrong_at(
                k,
                &format!("{value} is not a reflectance; give --percent if it is percent, or shares of 0..1"),
            ));
        }
        self.fine(by, |value| value)
    }

    /// Returns the power of all samples, visible or not, in the unit of its kind without the nm.
    pub fn power(&self) -> f64 {
        match &self.edges {
            Some(edges) => edges
                .windows(2)
                .zip(&self.samples)
                .map(|(edges, (_, value))| value * (edges[1] - edges[0]))
                .sum(),
            None => self
                .samples
                .windows(2)
                .map(|pair| (pair[1].0 - pair[0].0) * f64::midpoint(pair[0].1, pair[1].1))
                .sum(),
        }
    }

    /// Returns the failure of a light that `eye` does not see.
    pub fn invisible(&self, eye: &NamedObserver) -> Failure {
        let eye = eye.title;
        self.wrong(&format!(
            "nothing is visible, since Y is not above zero for {eye}; check the range and the dark reading"
        ))
    }

    /// Returns a failure of the spectrum as a whole, at its first row.
    pub fn wrong(&self, what: &str) -> Failure {
        self.wrong_at(0, what)
    }

    /// Returns a failure at a sample.
    fn wrong_at(&self, k: usize, what: &str) -> Failure {
        let what = format!("'{}': {what}", short(&self.name));
        match self.lines.get(k) {
            Some(line) if *line > 0 => Failure::at(&self.file, *line, what),
            _ => Failure::of(&self.file, what),
        }
    }

    /// Returns the rule by which the samples become a spectrum at 1 nm.
    pub fn rule(&self, between: Between) -> Rule {
        match between {
            _ if self.edges.is_some() => Rule::Bands,
            Between::Linear => Rule::Linear,
            Between::Sprague => Rule::Sprague,
            Between::Auto if self.is_fine() => Rule::Means,
            Between::Auto if self.is_regular() => Rule::Sprague,
            Between::Auto => Rule::Linear,
        }
    }

    /// Returns whether samples of the visible are nearer than whole nanometers.
    fn is_fine(&self) -> bool {
        let steps = self.samples.windows(2).filter(|pair| pair[1].0 > FIRST && pair[0].0 < LAST);
        steps.map(|pair| pair[1].0 - pair[0].0).any(|step| step < FINE_NM)
    }

    /// Returns whether the steps are equal and of a width for which Sprague's rule is better than straight lines.
    fn is_regular(&self) -> bool {
        let step = (self.ends().1 - self.ends().0) / (self.samples.len() - 1) as f64;
        let is_equal = |k: usize| {
            let expected = self.samples[0].0 + step * k as f64;
            (self.samples[k].0 - expected).abs() <= EQUAL * step
        };
        self.samples.len() >= SPRAGUE_LEAST
            && SPRAGUE_NM.contains(&step)
            && (0..self.samples.len()).all(is_equal)
    }

    fn fine<Q: Quantity>(&self, by: Between, scaled: impl Fn(f64) -> f64) -> Result<Fine<Q>, Failure> {
        let interpolation = match self.rule(by) {
            Rule::Bands => return Ok(self.steps(scaled)),
            Rule::Means => return Ok(self.means(scaled)),
            Rule::Linear => Interpolation::Linear,
            Rule::Sprague => Interpolation::Sprague,
        };
        let samples: Vec<(f32, f32)> =
            self.samples.iter().map(|(nm, value)| (*nm as f32, scaled(*value) as f32)).collect();
        let mut fine = Fine::interpolated(&samples, interpolation).map_err(|error| match error {
            SamplesError::NotRegular { index } => self.wrong_at(
                index,
                "this row is off the regular step that sprague needs; use --interpolation linear",
            ),
            SamplesError::TooFew { needed } => {
                self.wrong(&format!("there are fewer than {needed} samples; use --interpolation linear"))
            }
            // These are distinct in f64: a file may list wavelengths closer than f32 can tell apart.
            SamplesError::NotIncreasing { index } => {
                self.wrong_at(index, "this row is less than 0.0001 nm above the one before; merge the two")
            }
            other => self.wrong(&format!("{other}; correct the file")),
        })?;
        if exact::is_needed(&self.samples) {
            for (value, nm) in fine.values_mut().iter_mut().zip(360..) {
                let nm = f64::from(nm);
                let read = exact::at(&self.samples, nm, interpolation);
                *value = match (read, Q::OUTSIDE) {
                    (Some(read), _) => scaled(read) as f32,
                    (None, Outside::Zero) => 0.0,
                    (None, Outside::Hold) if nm < self.samples[0].0 => scaled(self.samples[0].1) as f32,
                    (None, Outside::Hold) => scaled(self.samples[self.samples.len() - 1].1) as f32,
                };
            }
        }
        Ok(fine)
    }

    /// Returns averages over bands at 1 nm: each nanometer has the mean of the bands that it lies in.
    fn steps<Q: Quantity>(&self, scaled: impl Fn(f64) -> f64) -> Fine<Q> {
        let averages: Vec<f64> = self.samples.iter().map(|(_, value)| scaled(*value)).collect();
        let edges = self.edges.as_deref().unwrap_or(&[]);
        let outside = outside::<Q>([averages[0], averages[averages.len() - 1]]);
        let mut fine = Fine::flat(0.0);
        for (value, nm) in fine.values_mut().iter_mut().zip(360..) {
            *value = bands::mean(edges, &averages, f64::from(nm), outside) as f32;
        }
        fine
    }

    /// Returns the means over each nanometer of straight lines between the samples, so that the power of a line
    /// counts wherever it lies.
    fn means<Q: Quantity>(&self, scaled: impl Fn(f64) -> f64) -> Fine<Q> {
        let samples: Vec<(f64, f64)> = self.samples.iter().map(|(nm, value)| (*nm, scaled(*value))).collect();
        let outside = outside::<Q>([samples[0].1, samples[samples.len() - 1].1]);
        let mut fine = Fine::flat(0.0);
        for (value, mean) in fine.values_mut().iter_mut().zip(exact::means(&samples, 360.0, outside)) {
            *value = mean as f32;
        }
        fine
    }

    fn ends(&self) -> (f64, f64) {
        (self.samples[0].0, self.samples[self.samples.len() - 1].0)
    }

    /// Checks that the samples reach into the visible range, which those in another unit often do not.
    fn check_reach(&self) -> Result<(), Failure> {
        let (first, last) = self.ends();
        if first <= LAST && last >= FIRST {
            return Ok(());
        }
        let units = [("micrometers", 1e3), ("ångströms", 0.1), ("meters", 1e9)];
        let unit = units.into_iter().find(|(_, nm)| first * nm <= LAST && last * nm >= FIRST);
        let advice = match unit {
            Some((unit, nm)) => format!("if the wavelengths are in {unit}, multiply them by {nm}"),
            None => "give a spectrum that reaches into this range".into(),
        };
        let [first, last] = [first, last].map(shortest);
        Err(self
            .wrong(&format!("{first}..{last} nm is outside 360..830 nm, so nothing is visible; {advice}")))
    }

    /// Returns notes on how the samples were used.
    pub fn remarks<Q: Quantity>(&self, by: Between) -> Vec<String> {
        let mut remarks = Vec::new();
        let rule = self.rule(by);
        if rule == Rule::Bands {
            remarks
                .push("the values are averages over bands, and the spectrum is constant within each".into());
        }
        let (first, last) = self.ends();
        if first > VISIBLE_FROM || last < VISIBLE_TO {
            let fate = match Q::OUTSIDE {
                Outside::Zero => "counts as zero",
                Outside::Hold => "has the value of the nearest end",
            };
            let [first, last] = [first, last].map(shortest);
            remarks.push(format!("the samples cover {first}..{last} nm; what is outside {fate}"));
        }
        let inside = self.samples.iter().filter(|(nm, _)| (FIRST..=LAST).contains(nm)).count();
        // The other rules read all samples, or nearly all.
        let unread = self.between_nodes();
        if unread > 0 && rule == Rule::Linear {
            remarks.push(format!(
                "the steps are finer than 1 nm, but the sum reads whole nanometers: {unread} of {inside} samples \
                 do not count, and narrow lines between whole nanometers are missed"
            ));
        }
        let beyond = self.samples.len() - inside;
        if beyond > 0 {
            remarks.push(format!("{beyond} samples outside 360..830 nm are not part of any sum"));
        }
        let negative = self.samples.iter().filter(|(_, value)| *value < 0.0).count();
        if negative > 0 {
            remarks.push(format!("{negative} negative values are used as they are"));
        }
        let widest = self.samples.windows(2).map(|pair| pair[1].0 - pair[0].0).fold(0.0, f64::max);
        if widest > COARSE_NM && rule != Rule::Bands {
            remarks.push(format!(
                "the steps are up to {} nm wide; what lies between the samples is unknown",
                shortest(widest)
            ));
        }
        remarks
    }

    /// Returns the number of samples that no whole nanometer of the grid reads.
    ///
    /// A whole nanometer reads the sample that lies on it, or else its two neighbors.
    fn between_nodes(&self) -> usize {
        let samples = &self.samples;
        let unread = |k: usize| {
            let nm = samples[k].0;
            let before = k.checked_sub(1).map_or(nm, |k| samples[k].0);
            let after = samples.get(k + 1).map_or(nm, |next| next.0);
            // A whole nanometer above the one before and below the one after reads this sample.
            let reader = before.floor() + 1.0;
            nm.fract() != 0.0 && reader >= after && (FIRST..=LAST).contains(&nm)
        };
        (0..samples.len()).filter(|k| unread(*k)).count()
    }
}

/// Returns the values outside the samples, whose first and last values are these.
fn outside<Q: Quantity>(ends: [f64; 2]) -> [f64; 2] {
    match Q::OUTSIDE {
        Outside::Zero => [0.0, 0.0],
        Outside::Hold => ends,
    }
}
