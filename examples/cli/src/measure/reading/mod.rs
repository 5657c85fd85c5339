//! Computes every number about a spectrum.

mod compare;
mod lamp;
mod shape;
mod strength;
mod surface;

pub use compare::{Comparison, Difference};
pub use shape::Shape;
pub use strength::Strength;

use crate::failure::{Failure, short};
use crate::measure::args::{Args, Between};
use crate::measure::input;
use crate::measure::level::Kind;
use crate::measure::lights::{self, Illuminant};
use crate::measure::source::{Rule, Source};
use nanospectra::color::{Lab, Rgb, Srgb, Uv1960, Uv1976, Xy, Xyz, dominant_wavelength};
use nanospectra::observer::NamedObserver;
use nanospectra::{Factor, Fine, FineObserver, Power};
use std::path::Path;
use std::rc::Rc;

/// The observer, the rule and the light on surfaces with which all spectra of a run are measured.
pub struct Bench {
    pub eye: &'static NamedObserver,
    pub between: Between,
    pub room: Room,
    /// Whether the user names the light on surfaces.
    is_lit: bool,
    /// What relative lights are scaled to.
    pub scaled_to: Option<Known>,
}

/// A known reading of a light, to which its relative spectrum is scaled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Known {
    /// In lx.
    Illuminance(f64),
    /// In umol/m2/s.
    Ppfd(f64),
}

/// The light on a surface, and the observer under that light.
pub struct Room {
    pub light: Illuminant,
    eye: FineObserver<3, Factor>,
    white: Xyz,
}

/// Every number about one spectrum, with `None` and a note that says why where one is not defined.
#[derive(Default)]
pub struct Reading {
    pub file: Rc<str>,
    pub name: String,
    /// Where it was read, and who says what its numbers are.
    pub origin: Option<String>,
    pub kind: Kind,
    /// What the file says beside its spectra, as names with their values.
    pub stated: Rc<[(String, String)]>,
    /// XYZ, with Y = 100 for a relative light and for white under a light, and Y in the unit of photometry for
    /// another light.
    pub xyz: [f64; 3],
    pub xy: Option<Xy>,
    pub uv1960: Option<Uv1960>,
    pub uv1976: Option<Uv1976>,
    pub cct_k: Option<f32>,
    pub duv: Option<f32>,
    pub lux: Option<f64>,
    pub ler_lm_per_w: Option<f32>,
    pub lab: Option<Lab>,
    /// The encoded components, clipped to 0..=1.
    pub srgb: Option<[f32; 3]>,
    pub hex: Option<String>,
    pub dominant_wavelength_nm: Option<f32>,
    pub purity: Option<f32>,
    pub cri_ra: Option<f32>,
    pub cri_r: Option<[f32; 15]>,
    /// Whether the light is near enough to its reference that CIE 13.3 applies.
    pub cri_is_valid: Option<bool>,
    pub tm30_rf: Option<f32>,
    pub tm30_rg: Option<f32>,
    pub melanopic_edi_ratio: Option<f32>,
    pub ppfd: Option<f64>,
    pub strength: Strength,
    pub shape: Option<Shape>,
    pub delta_e2000_to_white: Option<f32>,
    /// The difference to the spectrum that `--compare` names.
    pub compare: Option<Comparison>,
    pub notes: Vec<Note>,
    /// The rule by which the samples became a spectrum at 1 nm.
    pub rule: Option<Rule>,
    curve: Option<Fine<Power>>,
    /// Y of `curve`.
    curve_y: f64,
    /// Y of the numbers as they were read from the file.
    raw_y: f64,
}

/// A note about one quantity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// The key in the JSON report that the note is about, or `data` for the samples.
    pub key: String,
    pub text: String,
}

impl Bench {
    /// Makes the bench that the options describe.
    pub fn new(args: &Args) -> Result<Self, Failure> {
        let eye = args.observer.0;
        let name = args.light.as_deref().unwrap_or(Path::new("D65"));
        let light = lights::find(name, args, eye)?;
        let under = eye.functions.under(&light.power).with_white_y(100.0);
        let white = Xyz::from(under.sees(&Fine::flat(1.0)));
        Ok(Bench {
            eye,
            between: args.interpolation,
            room: Room { light, eye: under, white },
            is_lit: args.light.is_some(),
            scaled_to: args.lux.map(Known::Illuminance).or(args.ppfd.map(Known::Ppfd)),
        })
    }

    /// Computes all numbers about a spectrum.
    pub fn measure(&self, source: &Source) -> Result<Reading, Failure> {
        if source.kind != Kind::Surface && self.is_lit {
            return Err(source
                .wrong("this is a light, and --light is for surfaces; give --reflectance, or leave it out"));
        }
        let mut reading = match source.kind {
            Kind::Surface => surface::measure(self, source),
            _ => lamp::measure(self, source),
        }?;
        reading.leave_out_what_is_not_finite();
        reading.explain_the_rest();
        if reading.xyz.iter().any(|value| !value.is_finite()) {
            return Err(source.wrong("its sums are too large for any number; check the values and the unit"));
        }
        Ok(reading)
    }

    /// Computes all numbers about a spectrum, and the difference to the spectrum of `--compare`.
    pub fn measure_and_compare(
        &self,
        source: &Source,
        reference: Option<&Reading>,
    ) -> Result<Reading, Failure> {
        let mut reading = self.measure(source)?;
        if let Some(reference) = reference {
            if (reading.kind == Kind::Surface) != (reference.kind == Kind::Surface) {
                return Err(source.wrong(&format!(
                    "one of this and '{}' is a light and the other a surface; compare two of a kind",
                    short(&reference.name)
                )));
            }
            let (comparison, notes) = compare::compare(self, &reading, reference);
            reading.notes.extend(notes);
            reading.compare = Some(comparison);
        }
        Ok(reading)
    }
}

/// Measures the spectrum that `--compare` names.
pub fn reference(bench: &Bench, args: &Args) -> Result<Option<Reading>, Failure> {
    let Some(path) = &args.compare else { return Ok(None) };
    bench.measure(&input::read_one(path, "--compare", args, &args.options())?).map(Some)
}

impl Room {
    /// Returns XYZ of a perfect white surface in this light.
    pub fn white(&self) -> Xyz {
        self.white
    }
}

impl Reading {
    /// Returns the spectrum (of a surface, its reflectance) at every nanometer, for drawing and comparing.
    pub fn curve(&self) -> Fine<Power> {
        self.curve.unwrap_or(Fine::flat(0.0))
    }

    /// Returns the factor that makes the numbers as they were read of the curve.
    pub fn scale(&self) -> f64 {
        if self.curve_y == 0.0 { 1.0 } else { self.raw_y / self.curve_y }
    }

    /// Returns a reading that holds the color and nothing else, where `xyz` may be at any scale.
    fn of(bench: &Bench, source: &Source, xyz: Xyz, white: Xy) -> Self {
        let mut reading = Reading {
            file: Rc::clone(&source.file),
            name: source.name.clone(),
            origin: source.origin.clone(),
            kind: source.kind,
            stated: Rc::clone(&source.stated),
            rule: Some(source.rule(bench.between)),
            notes: source.notes.iter().map(|text| Note { key: "read".into(), text: text.clone() }).collect(),
            xyz: xyz.to_array().map(f64::from),
            xy: xyz.xy(),
            uv1960: xyz.uv1960(),
            uv1976: xyz.uv1976(),
            ..Reading::default()
        };
        let Some(xy) = reading.xy else {
            let black = "black has no chromaticity (X + Y + Z is not above zero)";
            reading.missing(&["xy", "uv1960", "uv1976", "dominant_wavelength_nm", "purity"], black);
            return reading;
        };
        if let Some(dominant) = dominant_wavelength(xy, white, bench.eye.functions) {
            reading.dominant_wavelength_nm = Some(dominant.nm);
            reading.purity = Some(dominant.purity);
        } else {
            reading.purity = Some(0.0);
            reading.missing(&["dominant_wavelength_nm"], "the color is within 0.00001 of the white");
        }
        reading
    }

    /// Fills in the display's color, clipped to the gamut. Returns whether it was inside the gamut before.
    fn show(&mut self, color: Rgb<Srgb>) -> bool {
        let clipped = color.clip().rgb;
        let code = clipped.encode();
        let [r, g, b] = code.to_u8();
        self.srgb = Some(code.to_array());
        self.hex = Some(format!("#{r:02x}{g:02x}{b:02x}"));
        // Rounding may leave a white slightly outside the gamut, which needs no note.
        color.to_array().iter().zip(clipped.to_array()).all(|(a, b)| (a - b).abs() <= 1e-5)
    }

    /// Leaves out each number whose formula ended in NaN or an infinity, with a note.
    fn leave_out_what_is_not_finite(&mut self) {
        let mut lost = Vec::new();
        let all = |values: &[f32]| values.iter().all(|value| value.is_finite());
        let mut is_lost = |key: &'static str, is_finite: bool| {
            lost.extend((!is_finite).then_some(key));
            !is_finite
        };
        self.xy.take_if(|p| is_lost("xy", all(&[p.x, p.y])));
        self.uv1960.take_if(|p| is_lost("uv1960", all(&[p.u, p.v])));
        self.uv1976.take_if(|p| is_lost("uv1976", all(&[p.u, p.v])));
        self.cct_k.take_if(|value| is_lost("cct_k", value.is_finite()));
        self.duv.take_if(|value| is_lost("duv", value.is_finite()));
        self.lux.take_if(|value| is_lost("lux", value.is_finite()));
        self.ppfd.take_if(|value| is_lost("ppfd", value.is_finite()));
        self.ler_lm_per_w.take_if(|value| is_lost("ler_lm_per_w", value.is_finite()));
        self.lab.take_if(|lab| is_lost("lab", all(&[lab.l, lab.a, lab.b])));
        self.delta_e2000_to_white.take_if(|value| is_lost("delta_e2000_to_white", value.is_finite()));
        if self.srgb.take_if(|rgb| is_lost("srgb", all(rgb))).is_some() {
            self.hex = None;
        }
        self.dominant_wavelength_nm.take_if(|value| is_lost("dominant_wavelength_nm", value.is_finite()));
        self.purity.take_if(|value| is_lost("purity", value.is_finite()));
        self.cri_ra.take_if(|value| is_lost("cri_ra", value.is_finite()));
        self.cri_r.take_if(|values| is_lost("cri_r", all(values)));
        self.tm30_rf.take_if(|value| is_lost("tm30_rf", value.is_finite()));
        self.tm30_rg.take_if(|value| is_lost("tm30_rg", value.is_finite()));
        self.melanopic_edi_ratio.take_if(|value| is_lost("melanopic_edi_ratio", value.is_finite()));
        self.missing(&lost, "it is not defined for values that are so large or so negative");
    }

    /// Adds a note for each number that is missing without one, because the values are too extreme for its
    /// formula.
    fn explain_the_rest(&mut self) {
        let missing = [
            ("xy", self.xy.is_none()),
            ("uv1960", self.uv1960.is_none()),
            ("uv1976", self.uv1976.is_none()),
            ("cct_k", self.cct_k.is_none()),
            ("duv", self.duv.is_none()),
            ("lab", self.lab.is_none()),
            ("srgb", self.srgb.is_none()),
            ("purity", self.purity.is_none()),
            ("cri_ra", self.cri_ra.is_none()),
            ("tm30_rf", self.tm30_rf.is_none()),
            ("delta_e2000_to_white", self.delta_e2000_to_white.is_none()),
        ];
        for (key, is_missing) in missing {
            if is_missing && !self.notes.iter().any(|note| note.key == key) {
                self.note(key, "it is not defined for values that are so large or so negative");
            }
        }
    }

    fn note(&mut self, key: &str, text: impl Into<String>) {
        self.notes.push(Note { key: key.to_owned(), text: text.into() });
    }

    fn missing(&mut self, keys: &[&str], why: &str) {
        for key in keys {
            self.note(key, why);
        }
    }
}
