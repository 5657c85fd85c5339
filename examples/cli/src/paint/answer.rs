//! Finds the spectrum of a color, and how it looks under lights.

use crate::failure::{Failure, short};
use crate::input::illuminants;
use crate::paint::args::{Args, Beyond, Method, Space};
use crate::paint::input::Color;
use nanospectra::color::{
    Aces2065, AcesCg, Adaptation, AdobeRgb, Bt2020, Cat16, DciP3, DisplayP3, EncodedRgb, Lab, ProPhoto, Rgb,
    RgbSpace, Srgb, Xyz,
};
use nanospectra::light::{D50, D65, daylight};
use nanospectra::observer::CIE_1931;
use nanospectra::upsample::{Basis, Sigmoid, Smits, Status, Viewing};
use nanospectra::{
    Curve, Factor, Fine, Grid, Interpolation, Light, Nodes, Observer, Outside, Power, Reflectance, matter,
};

/// What is the same for all colors of a run.
pub struct Job<'a> {
    args: &'a Args,
    /// The white of the RGB space.
    white: Lamp,
    /// The other lights under which spectra are shown.
    lamps: Vec<Lamp>,
}

struct Lamp {
    name: String,
    power: Fine<Power>,
}

/// Everything that is reported about one color.
pub struct Answer {
    pub sample: Option<String>,
    /// The color as it was given; linear with `--linear`.
    pub rgb: [f32; 3],
    pub status: &'static str,
    /// The share of the way from gray to the color that is left, 0..1, if the color was desaturated.
    pub kept: Option<f32>,
    /// Pairs of a wavelength in nm and a reflectance.
    pub spectrum: Vec<(f32, f32)>,
    /// The spectrum on the 1 nm grid for plots, zero outside its own grid.
    pub curve: Fine<Factor>,
    pub roundtrip: [f32; 3],
    pub delta_e2000: f32,
    /// The color that was asked for, in 8-bit sRGB and clipped to its gamut.
    pub asked: [u8; 3],
    /// How the spectrum looks under the white of the space, and then under the other lights.
    pub looks: Vec<Look>,
}

/// A surface under one light.
pub struct Look {
    pub light: String,
    /// Tristimulus values, with Y = 100 for the perfect white.
    pub xyz: Xyz,
    pub lab: Lab,
    /// The color in 8-bit sRGB, adapted to D65.
    pub srgb: [u8; 3],
}

impl Answer {
    /// Returns whether every number is finite.
    fn is_finite(&self) -> bool {
        let looks =
            self.looks.iter().flat_map(|Look { xyz, lab, .. }| [xyz.x, xyz.y, xyz.z, lab.l, lab.a, lab.b]);
        let spectrum = self.spectrum.iter().map(|(_, share)| *share);
        let numbers = self.rgb.into_iter().chain(self.roundtrip).chain([self.delta_e2000]).chain(self.kept);
        numbers.chain(looks).chain(spectrum).all(f32::is_finite)
    }
}

impl<'a> Job<'a> {
    pub fn new(args: &'a Args) -> Result<Self, Failure> {
        let (name, power) = white(args.space);
        let white = Lamp { name: name.into(), power };
        let mut lamps: Vec<Lamp> = Vec::new();
        for name in &args.light {
            let lamp = lamp(name.trim())?;
            if [&white].into_iter().chain(&lamps).all(|known| known.name != lamp.name) {
                lamps.push(lamp);
            }
        }
        Ok(Job { args, white, lamps })
    }
}

/// Returns the white of a space, with the name that it has in reports.
fn white(space: Space) -> (&'static str, Fine<Power>) {
    match space {
        Space::Srgb | Space::P3 | Space::Bt2020 | Space::Adobe => ("D65", D65.fine()),
        Space::Prophoto => ("D50", D50.fine()),
        Space::Acescg | Space::Aces2065 => {
            ("D60", daylight(6000.0).map_or_else(|| D65.fine(), |d60| d60.fine()))
        }
        // No phase of daylight is as green, but a sum of the CIE's components of daylight is.
        Space::DciP3 => ("DCI", Light::from_rgb(Rgb::<DciP3>::new(1.0, 1.0, 1.0))),
    }
}

fn lamp(name: &str) -> Result<Lamp, Failure> {
    let (name, power) = illuminants::find(name, Interpolation::Linear).ok_or_else(|| {
        let what = format!("this is not a CIE illuminant; use one of {}", nanospectra::light::NAMES_IN_BRIEF);
        Failure::of(format_args!("--light {}", short(name)), what)
    })?;
    Ok(Lamp { name, power })
}

/// Answers a color.
pub type Paint = Box<dyn Fn(&Color) -> Result<Answer, Failure>>;

/// Returns what answers the colors of a job on one grid.
pub fn in_space<const N: usize, G: Grid + 'static>(job: &Job) -> Paint {
    match job.args.space {
        Space::Srgb => painter::<N, G, Srgb>(job),
        Space::P3 => painter::<N, G, DisplayP3>(job),
        Space::DciP3 => painter::<N, G, DciP3>(job),
        Space::Bt2020 => painter::<N, G, Bt2020>(job),
        Space::Adobe => painter::<N, G, AdobeRgb>(job),
        Space::Prophoto => painter::<N, G, ProPhoto>(job),
        Space::Acescg => painter::<N, G, AcesCg>(job),
        Space::Aces2065 => painter::<N, G, Aces2065>(job),
    }
}

fn painter<const N: usize, G: Grid + 'static, S: RgbSpace + 'static>(job: &Job) -> Paint {
    let painter: Painter<N, G, S> = Painter::new(job);
    Box::new(move |color| painter.answer(color))
}

struct Painter<const N: usize, G, S> {
    viewing: Viewing<N, G, S>,
    sigmoid: Sigmoid<N, G, S>,
    basis: Basis<N, G, S>,
    smits: Smits<N, G>,
    eyes: Vec<(String, Observer<3, N, Factor, G>)>,
    method: Method,
    beyond: Option<Beyond>,
    linear: bool,
}

impl<const N: usize, G: Grid, S: RgbSpace> Painter<N, G, S> {
    fn new(job: &Job) -> Self {
        let under = |lamp: &Lamp| CIE_1931.under(&lamp.power).fold(Curve::Step);
        let eye = |lamp: &Lamp| (lamp.name.clone(), under(lamp).with_white_y(100.0));
        let viewing = Viewing::new(&under(&job.white));
        Painter {
            sigmoid: Sigmoid::new(&viewing),
            basis: Basis::new(&viewing),
            smits: Smits::new(),
            viewing,
            eyes: [&job.white].into_iter().chain(&job.lamps).map(eye).collect(),
            method: job.args.method,
            beyond: job.args.beyond(),
            linear: job.args.linear,
        }
    }

    fn answer(&self, color: &Color) -> Result<Answer, Failure> {
        let [r, g, b] = color.numbers;
        let encoded = color.is_code || !self.linear;
        let rgb: Rgb<S> = if encoded { EncodedRgb::<S>::new(r, g, b).decode() } else { Rgb::new(r, g, b) };
        let (spectrum, status, kept) = self.spectrum(rgb);
        let given = |rgb: Rgb<S>| if self.linear { rgb.to_array() } else { rgb.encode().to_array() };
        let srgb: Rgb<Srgb> = Rgb::from_xyz(self.to_d65(0, self.viewing.xyz(rgb)));
        let answer = Answer {
            sample: color.sample.clone(),
            rgb: if self.linear { rgb.to_array() } else { color.numbers },
            status,
            kept,
            spectrum: spectrum.iter().collect(),
            curve: spectrum.resample_outside(Outside::Zero),
            roundtrip: given(self.viewing.rgb(&spectrum)),
            delta_e2000: self.viewing.delta_e(rgb, &spectrum),
            asked: srgb.clip().rgb.encode().to_u8(),
            looks: (0..self.eyes.len()).filter_map(|k| self.look(k, &spectrum)).collect(),
        };
        if answer.looks.len() == self.eyes.len() && answer.is_finite() {
            return Ok(answer);
        }
        // Above about 1e15 the transfer functions, the sums and the color differences overflow.
        let what = "the numbers are too large, so that the spectrum or its color is not finite; \
                    give smaller numbers (0..1 for surfaces)";
        Err(Failure::of(&color.place, what))
    }

    fn spectrum(&self, rgb: Rgb<S>) -> (Reflectance<N, G>, &'static str, Option<f32>) {
        match self.method {
            Method::Sigmoid => {
                let solved = match self.beyond {
                    Some(Beyond::Desaturate) => self.sigmoid.desaturated(rgb),
                    _ => self.sigmoid.reflectance(rgb),
                };
                let (status, kept) = match solved.status {
                    Status::Exact => ("exact", None),
                    Status::Desaturated { kept, .. } => ("desaturated", Some(kept)),
                    _ => ("unreachable", None),
                };
                (solved.spectrum.on_grid(), status, kept)
            }
            Method::Basis => {
                let spectrum = self.basis.reflectance(rgb);
                let possible = spectrum.values().iter().all(|share| (0.0..=1.0).contains(share));
                (spectrum, if possible { "exact" } else { "unphysical" }, None)
            }
            Method::Smits => (self.smits.reflectance(rgb), "approximate", None),
        }
    }

    /// Returns how a surface looks under a light, if that light is a white.
    fn look(&self, k: usize, surface: &Reflectance<N, G>) -> Option<Look> {
        let (light, eye) = &self.eyes[k];
        let seen = Xyz::from(eye.sees(surface));
        let lab = seen.lab(self.white(k))?;
        let srgb = Rgb::<Srgb>::from_xyz(self.to_d65(k, seen)).clip().rgb.encode().to_u8();
        Some(Look { light: light.clone(), xyz: seen, lab, srgb })
    }

    /// The color of the perfect white under a light.
    fn white(&self, k: usize) -> Xyz {
        Xyz::from(self.eyes[k].1.row_sums().map(|sum| sum as f32))
    }

    /// Adapts a color that is seen under a light to D65.
    fn to_d65(&self, k: usize, seen: Xyz) -> Xyz {
        let adaptation = Adaptation::between::<Cat16>(self.white(k), Srgb::WHITE_XYZ);
        adaptation.map_or(seen, |adaptation| adaptation.apply(seen))
    }
}

/// The encoded sRGB colors under D65 of 24 samples of CES99, which is every fourth.
pub fn samples() -> Vec<Color> {
    let viewing: Viewing<81, Nodes<380, 780>> = Viewing::new(&CIE_1931.under(&D65.fine()).fold(Curve::Step));
    let every_fourth = matter::CES.iter().zip(1..).step_by(4).take(24);
    every_fourth
        .map(|(sample, number)| {
            let name = format!("CES{number:02}");
            let surface: Reflectance<81, Nodes<380, 780>> = sample.resample();
            let numbers = viewing.rgb(&surface).clip().rgb.encode().to_array();
            Color { place: name.clone(), sample: Some(name), numbers, is_code: true }
        })
        .collect()
}
