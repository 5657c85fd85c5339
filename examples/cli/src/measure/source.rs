//! Brings a measured spectrum, given by samples with their lines in a file, to the 1 nm grid.

use crate::failure::{Failure, short};
use crate::input::bands;
use crate::measure::args::Between;
use crate::measure::exact;
use crate::output::number::shortest;
use crate::usage::name_of;
use nanospectra::observer::NamedObserver;
use nanospectra::{Factor, Fine, Interpolation, Outside, Power, Quantity, SamplesError};
use std::rc::Rc;

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

/// A spectrum as it was read from a column of a file.
#[derive(Debug)]
pub struct Source {
    pub file: Rc<str>,
    pub name: String,
    /// The line of each sample, counted from 1.
    pub lines: Rc<[usize]>,
    /// The pairs (wavelength in nm, value): at least two, finite, with increasing wavelengths.
    pub samples: Vec<(f64, f64)>,
    /// Whether the values are averages over bands around the wavelengths, and not points of a curve.
    pub are_averages: bool,
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
    pub fn light(&self, by: Interpolation) -> Result<Lamp, Failure> {
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
    pub fn reflectance(&self, by: Interpolation) -> Result<Fine<Factor>, Failure> {
        self.check_reach()?;
        for ((_, value), line) in self.samples.iter().zip(&*self.lines) {
            if *value > MOST_REFLECTANCE {
                let name = short(&self.name);
                let value = shortest(*value);
                let what = format!(
                    "'{name}' is {value}, which is not a reflectance; give shares of 0..1, not percent or power"
                );
                return Err(Failure::at(&self.file, *line, what));
            }
        }
        self.fine(by, |value| value)
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
        Failure::at(&self.file, self.lines[0], format!("'{}': {what}", short(&self.name)))
    }

    fn fine<Q: Quantity>(&self, by: Interpolation, scaled: impl Fn(f64) -> f64) -> Result<Fine<Q>, Failure> {
        if self.are_averages {
            return Ok(self.steps(scaled));
        }
        let samples: Vec<(f32, f32)> =
            self.samples.iter().map(|(nm, value)| (*nm as f32, scaled(*value) as f32)).collect();
        let at = |index: usize, what| Failure::at(&self.file, self.lines[index], what);
        let mut fine = Fine::interpolated(&samples, by).map_err(|error| match error {
            SamplesError::NotRegular { index } => {
                at(index, "this row is off the regular step that sprague needs; use --interpolation linear")
            }
            SamplesError::TooFew { needed } => {
                self.wrong(&format!("there are fewer than {needed} samples; use --interpolation linear"))
            }
            // These are distinct in f64: a file may list wavelengths closer than f32 can tell apart.
            SamplesError::NotIncreasing { index } => {
                at(index, "this row is less than 0.0001 nm above the one before; merge the two")
            }
            other => self.wrong(&format!("{other}; correct the file")),
        })?;
        if exact::is_needed(&self.samples) {
            for (value, nm) in fine.values_mut().iter_mut().zip(360..) {
                let nm = f64::from(nm);
                let read = exact::at(&self.samples, nm, by);
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
        let (wavelengths, averages): (Vec<f64>, Vec<f64>) =
            self.samples.iter().map(|(nm, value)| (*nm, scaled(*value))).unzip();
        let edges = bands::edges(&wavelengths);
        let outside = match Q::OUTSIDE {
            Outside::Zero => [0.0, 0.0],
            Outside::Hold => [averages[0], averages[averages.len() - 1]],
        };
        let mut fine = Fine::flat(0.0);
        for (value, nm) in fine.values_mut().iter_mut().zip(360..) {
            *value = bands::mean(&edges, &averages, f64::from(nm), outside) as f32;
        }
        fine
    }

    /// Returns the name of the rule by which the samples become a spectrum at 1 nm.
    pub fn rule(&self, between: Between) -> String {
        if self.are_averages { "averages".into() } else { name_of(between) }
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
    pub fn remarks<Q: Quantity>(&self, by: Interpolation) -> Vec<String> {
        let mut remarks = Vec::new();
        if self.are_averages {
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
        // Sprague's rule reads six samples for each nanometer, and so nearly all of them.
        let unread = self.between_nodes();
        if unread > 0 && by == Interpolation::Linear && !self.are_averages {
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
        if widest > COARSE_NM && !self.are_averages {
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
