//! Computes what a scene looks like, and what it costs.

use crate::failure::Failure;
use crate::scene::file::Recipe;
use crate::scene::lamp;
use crate::scene::matter::{self, Matter};
use nanospectra::color::{Adaptation, Cat16, Lab, Rgb, RgbSpace, Srgb, Xy, Xyz};
use nanospectra::observer::{CIE_1931, CIE_1964, V_PHOTOPIC};
use nanospectra::path::{Price, Scene};
use nanospectra::radiometry::{Exitance, Irradiance};
use nanospectra::sensor::chip;
use nanospectra::{Curve, FineObserver, Grid, Light, Observer, Power};

/// The most parts that a scene may have.
const PARTS: usize = 16;

/// Everything that is reported about a scene.
pub struct Answer {
    pub name: String,
    pub title: String,
    pub lamp: String,
    pub eye: &'static str,
    pub grid: String,
    /// The light of the lamp, as pairs of a wavelength in nm and a power.
    pub lit: Vec<(f32, f32)>,
    /// The light behind the last part, which reaches the eye.
    pub leaving: Vec<(f32, f32)>,
    pub look: Look,
    pub lamp_srgb: [u8; 3],
    pub absolute: Option<Absolute>,
    pub sensor: Option<Sensor>,
    pub bill: Vec<Line>,
    pub walked: Price,
    pub folded: Price,
    pub budget: Option<Budget>,
    /// What is unusual about the numbers.
    pub notes: Vec<String>,
}

/// Why a color has no Lab and is not adapted to D65.
pub const NO_WHITE: &str = "X, Y or Z of the lamp is not above zero, so the lamp is no white";

/// A color, with the lamp as white.
#[derive(Clone, Copy)]
pub struct Look {
    /// Tristimulus values, with Y = 100 for the bare lamp.
    pub xyz: Xyz,
    /// The chromaticity, which black does not have.
    pub xy: Option<Xy>,
    /// Lab, which there is only if the lamp is a white, with X, Y and Z above zero.
    pub lab: Option<Lab>,
    /// The color in 8-bit sRGB, adapted to D65 if the lamp is a white.
    pub srgb: [u8; 3],
    /// Whether the color is outside sRGB, so that a component was below 0 or above 1.
    pub is_clipped: bool,
}

/// Numbers with units, for a lamp with an illuminance.
pub struct Absolute {
    pub illuminance_lx: f32,
    pub irradiance_w_m2: f32,
    pub exitance_lm_m2: f32,
    pub exitance_w_m2: f32,
    /// Luminance in cd/m2 and radiance in W/(m2 sr), if the last part is matt.
    pub radiance: Option<[f32; 2]>,
}

/// What a sensor chip in place of the eye receives.
pub struct Sensor {
    pub name: String,
    pub peaks_nm: Vec<f32>,
    /// For each channel, the irradiance weighted by its responsivity, which is 1 at its peak. It is in W/m2
    /// if the lamp has an illuminance.
    pub channels: Vec<f32>,
    /// The same divided by the value for the bare lamp, if that is not 0.
    pub of_lamp: Vec<Option<f32>>,
}

/// The line of the bill for one part.
pub struct Line {
    pub name: String,
    pub kind: &'static str,
    pub effect: &'static str,
    pub price: Price,
    /// The difference in CIEDE2000, which there is only if the lamp is a white.
    pub without_delta_e: Option<f32>,
    pub without_srgb: [u8; 3],
    pub left_out: bool,
}

/// The result of `--budget`.
pub struct Budget {
    pub delta_e: f32,
    pub cost_delta_e: f32,
    pub left_out: Vec<usize>,
    pub srgb: [u8; 3],
    pub multiply_adds: usize,
}

/// An eye, a lamp and the white that the eye is adapted to.
struct Viewing<const N: usize, G> {
    eye: Observer<3, N, Power, G>,
    lamp: Light<N, G>,
    white: Xyz,
}

impl<const N: usize, G: Grid> Viewing<N, G> {
    fn look(&self, light: &Light<N, G>) -> Look {
        let [seen, white] =
            [Xyz::from(self.eye.sees(light)), self.white].map(|xyz| xyz.scaled(100.0 / self.white.y));
        let is_white = is_white(white);
        let adaptation = Adaptation::between::<Cat16>(white, Srgb::WHITE_XYZ).filter(|_| is_white);
        let d65 = adaptation.map_or(seen, |adaptation| adaptation.apply(seen));
        let rgb = Rgb::<Srgb>::from_xyz(d65);
        Look {
            xyz: seen,
            xy: seen.xy(),
            lab: seen.lab(white).filter(|lab| [lab.l, lab.a, lab.b].iter().all(|part| part.is_finite())),
            srgb: rgb.clip().rgb.encode().to_u8(),
            // One step of an 8-bit code is 3e-4 or more.
            is_clipped: rgb.to_array().iter().any(|part| !(-1e-4..=1.0001).contains(part)),
        }
    }

    fn scene<'a>(
        &self,
        parts: impl Iterator<Item = nanospectra::path::Part<'a, N, G>>,
    ) -> Scene<'a, N, PARTS, G> {
        let mut scene = Scene::new();
        // The number of parts has been checked, so there is room.
        for part in parts {
            let _ = scene.push(part);
        }
        scene
    }
}

/// Returns whether XYZ are those of a light to which an eye can be adapted.
fn is_white(xyz: Xyz) -> bool {
    xyz.to_array().iter().all(|value| *value > 0.0)
}

/// Answers a scene on the grid `G`, whose name is `grid`.
pub fn answer_on<const N: usize, G: Grid>(
    recipe: &Recipe,
    grid: &str,
    budget: Option<f32>,
) -> Result<Answer, Failure> {
    let lamp = lamp::of(recipe)?;
    let (eye, eye_name) = eye(recipe)?;
    let written = &recipe.scene.part;
    if let Some(extra) = written.get(PARTS) {
        return Err(recipe.wrong(
            extra,
            format_args!("the scene has more than {PARTS} parts; combine several filters into one"),
        ));
    }
    let parts = written.iter().map(|part| Matter::<N, G>::of(recipe, part)).collect::<Result<Vec<_>, _>>()?;

    matter::check_films(recipe, &parts)?;

    let lit: Light<N, G> = lamp.power.resample();
    // The smooth curve through the averages of a narrow lamp swings below zero beside it, and the eye may see
    // less than nothing of that. Steps never do.
    let seen_by = |curve: Curve| Xyz::from(eye.fold::<N, G>(curve).sees(&lit));
    let is_narrow = !(is_white(seen_by(Curve::Spline)) && is_white(seen_by(Curve::Step)));
    let curve = if is_narrow { Curve::Step } else { Curve::Spline };
    let v: Observer<1, N, Power, G> = V_PHOTOPIC.fold(curve);
    let bare = Irradiance::new(lit).luminous_by(&v).value().0;
    // The lamp is scaled by its illuminance on the grid, so that the report shows what the file asks for.
    let lit = lamp.illuminance_lx.map_or(lit, |asked| lit * (asked / bare));
    let eye: Observer<3, N, Power, G> = eye.fold(curve);
    let white = Xyz::from(eye.sees(&lit));
    // (Only Y is checked, since Z of a red lamp can be 0.)
    if !(bare > 0.0 && (1e-30..=1e30).contains(&white.y)) {
        let what = format!("the lamp is dark on {grid}; give it power at the wavelengths of that grid");
        return Err(recipe.wrong(&recipe.scene.lamp, what));
    }
    let mut notes = Vec::new();
    if is_narrow {
        let what =
            "a smooth curve through the power of so narrow a lamp has X, Y or Z that is not above zero";
        notes.push(format!("XYZ: {what}, so the power is taken as constant within each band"));
    }
    if !is_white(white) {
        notes.push(format!("lab, hex: {NO_WHITE}; there is no Lab, and the colors are not adapted to D65"));
    }
    let viewing = Viewing { white, eye, lamp: lit };
    let scene = viewing.scene(parts.iter().map(Matter::part));
    let leaving = scene.leaving_polarized(&lit);
    let found = budget.map(|delta_e| (delta_e, scene.within_budget(&viewing.eye, &lit, delta_e)));
    // The price of the three rows of the eye.
    let reading = Price { multiply_adds: 3 * N, bytes: 12 * N, ..Price::NONE };
    let is_matt = parts.iter().rfind(|part| !part.is_sheet()).is_some_and(|part| part.is_matt);
    Ok(Answer {
        name: recipe.name.clone(),
        title: recipe.scene.title.clone(),
        lamp: lamp.name,
        eye: eye_name,
        grid: grid.into(),
        lit: lit.iter().collect(),
        leaving: leaving.iter().collect(),
        look: viewing.look(&leaving),
        lamp_srgb: viewing.look(&lit).srgb,
        absolute: lamp.illuminance_lx.map(|_| Absolute::of(&v, lit, leaving, is_matt)),
        sensor: sensor(recipe, &lit, &leaving)?,
        bill: bill(&viewing, &parts, &scene, found.as_ref().map(|(_, found)| &found.scene)),
        walked: scene.price().plus(Price::light(N)).plus(reading),
        folded: scene.folded_price(3).plus(Price::light(N)),
        notes,
        budget: found.map(|(delta_e, found)| Budget {
            delta_e,
            cost_delta_e: found.delta_e,
            left_out: found.scene.left_out().collect(),
            srgb: viewing.look(&found.scene.leaving_polarized(&lit)).srgb,
            multiply_adds: found.scene.price().plus(reading).multiply_adds,
        }),
    })
}

fn bill<const N: usize, G: Grid>(
    viewing: &Viewing<N, G>,
    parts: &[Matter<N, G>],
    scene: &Scene<'_, N, PARTS, G>,
    found: Option<&Scene<'_, N, PARTS, G>>,
) -> Vec<Line> {
    let lines = scene.bill().zip(parts).enumerate();
    lines
        .map(|(k, (line, part))| {
            let replaced = parts.iter().enumerate().map(|(j, other)| match other.replacement() {
                Some(without) if j == k => without,
                _ => other.part(),
            });
            let without = viewing.scene(replaced).leaving_out(k);
            Line {
                name: part.name.clone(),
                kind: part.kind,
                effect: part.effect,
                price: line.price,
                without_delta_e: Some(scene.difference(&without, &viewing.eye, &viewing.lamp))
                    .filter(|delta_e| delta_e.is_finite()),
                without_srgb: viewing.look(&without.leaving_polarized(&viewing.lamp)).srgb,
                left_out: found.is_some_and(|found| found.left_out().any(|out| out == k)),
            }
        })
        .collect()
}

impl Absolute {
    fn of<const N: usize, G: Grid>(
        v: &Observer<1, N, Power, G>,
        lit: Light<N, G>,
        leaving: Light<N, G>,
        is_matt: bool,
    ) -> Self {
        let (arrives, leaves) = (Irradiance::new(lit), Exitance::new(leaving));
        let radiance = leaves.lambertian();
        Absolute {
            illuminance_lx: arrives.luminous_by(v).value().0,
            irradiance_w_m2: arrives.radiant().value().0,
            exitance_lm_m2: leaves.luminous_by(v).value().0,
            exitance_w_m2: leaves.radiant().value().0,
            radiance: is_matt.then(|| [radiance.luminous_by(v).value().0, radiance.radiant().value().0]),
        }
    }
}

fn eye(recipe: &Recipe) -> Result<(&'static FineObserver<3>, &'static str), Failure> {
    let Some(at) = &recipe.scene.eye else { return Ok((&CIE_1931, "CIE 1931")) };
    match at.get_ref().as_str() {
        "CIE 1931" => Ok((&CIE_1931, "CIE 1931")),
        "CIE 1964" => Ok((&CIE_1964, "CIE 1964")),
        _ => Err(recipe.wrong(at, "there is no eye of this name; use \"CIE 1931\" or \"CIE 1964\"")),
    }
}

fn sensor<const N: usize, G: Grid>(
    recipe: &Recipe,
    lit: &Light<N, G>,
    leaving: &Light<N, G>,
) -> Result<Option<Sensor>, Failure> {
    let Some(at) = &recipe.scene.sensor else { return Ok(None) };
    let chip = chip::named(at.get_ref()).filter(|chip| chip.peak_nm(0).is_some());
    let Some(chip) = chip else {
        let known = chip::ALL.iter().filter(|chip| chip.peak_nm(0).is_some());
        let names = known.map(|chip| format!("\"{}\"", chip.name)).collect::<Vec<_>>().join(", ");
        return Err(
            recipe.wrong(at, format_args!("no sensor of this name has nominal channels; use one of {names}"))
        );
    };
    let alone = |channel: usize| -> Option<(f32, [f32; 2])> {
        let observer: Observer<1, N, Power, G> = chip.nominal(channel)?;
        let ([got], [bare]) = (observer.sees(leaving), observer.sees(lit));
        Some((chip.peak_nm(channel)?, [got, bare]))
    };
    let (peaks_nm, seen): (Vec<f32>, Vec<[f32; 2]>) = (0..chip.channels.len()).filter_map(alone).unzip();
    Ok(Some(Sensor {
        name: format!("{}, nominal", chip.name),
        peaks_nm,
        channels: seen.iter().map(|[got, _]| *got).collect(),
        of_lamp: seen.iter().map(|[got, bare]| (*bare > 0.0).then(|| got / bare)).collect(),
    }))
}
