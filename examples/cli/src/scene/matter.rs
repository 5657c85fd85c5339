//! The parts of a scene on a grid, and what replaces them when their effect is left out.

use crate::failure::Failure;
use crate::input::table;
use crate::scene::file::{self, Factors, Film, Part as Written, Points, Recipe, Sample};
use nanospectra::matter::{Absorber, CES, Dye, Mirror, Polarizer, Retarder, ThinFilm};
use nanospectra::path::{IntoPart, Part};
use nanospectra::{Grid, Light, Quantity, Reflectance, Spectrum};
use toml::Spanned;

/// A part of a scene.
pub struct Matter<const N: usize, G> {
    pub name: String,
    pub kind: &'static str,
    /// What it does to light, for the bill.
    pub effect: &'static str,
    pub is_matt: bool,
    what: What<N, G>,
}

enum What<const N: usize, G> {
    /// A factor for each band, and the factors that replace them without the effect.
    Plain {
        factors: Reflectance<N, G>,
        without: Reflectance<N, G>,
    },
    Dye(Dye<N, G>),
    Mirror(Mirror<N, G>),
    Polarizer(Polarizer<N, G>),
    Retarder(Retarder<N, G>),
}

impl<const N: usize, G: Grid> Matter<N, G> {
    /// Whether light that is matt in front of the part is also matt behind it.
    pub fn is_sheet(&self) -> bool {
        matches!(self.kind, "filter" | "polarizer" | "retarder")
    }

    /// The part as the library takes it.
    pub fn part(&self) -> Part<'_, N, G> {
        match &self.what {
            What::Plain { factors, .. } if self.is_matt => Part::Surface(factors),
            What::Plain { factors, .. } => Part::Filter(factors),
            What::Dye(dye) => dye.into_part(),
            What::Mirror(mirror) => mirror.into_part(),
            What::Polarizer(polarizer) => polarizer.into_part(),
            What::Retarder(retarder) => retarder.into_part(),
        }
    }

    /// What replaces plain factors in a scene without them. The other parts have an effect that the library
    /// leaves out.
    pub fn replacement(&self) -> Option<Part<'_, N, G>> {
        match &self.what {
            What::Plain { without, .. } if self.is_matt => Some(Part::Surface(without)),
            What::Plain { without, .. } => Some(Part::Filter(without)),
            _ => None,
        }
    }

    /// Makes the part from what is written in the scene.
    pub fn of(recipe: &Recipe, at: &Spanned<Written>) -> Result<Self, Failure> {
        let written = at.get_ref();
        let wrong = |what: String| recipe.wrong(at, what);
        let Written { filter, surface, dye, film, mirror, polarizer, retarder, .. } = written;
        let kinds = [
            filter.is_some(),
            surface.is_some(),
            dye.is_some(),
            film.is_some(),
            mirror.is_some(),
            polarizer.is_some(),
            retarder.is_some(),
        ];
        let several = "a part is of exactly one kind; \
                       give one of filter, surface, dye, film, mirror, polarizer, retarder";
        if kinds.into_iter().filter(|given| *given).count() != 1 {
            return Err(recipe.wrong(at, several));
        }
        let (kind, effect, is_matt, what) = if let Some(factors) = filter {
            let effect = if factors.absorbance_per_cm.is_some() { "Beer-Lambert" } else { "absorption" };
            ("filter", effect, false, plain(factors_of(recipe, at, factors)?))
        } else if let Some(factors) = surface {
            ("surface", "reflection", true, plain(factors_of(recipe, at, factors)?))
        } else if let Some(dye) = dye {
            let transmitted = dye.transmitted;
            let [reflectance, absorption] =
                [("reflectance", &dye.reflectance), ("absorption", &dye.absorption)]
                    .map(|(name, points)| shares(points).map_err(|what| wrong(format!("{name}: {what}"))));
            let emission: Light<N, G> =
                samples(&dye.emission).map_err(|what| wrong(format!("emission: {what}")))?;
            let dye = Dye::new(&reflectance?, &absorption?, &emission, dye.quantum_yield)
                .map_err(|error| wrong(format!("{error}; correct the dye's numbers")))?;
            ("dye", "fluorescence", !transmitted, What::Dye(dye))
        } else if let Some(film) = film {
            ("film", "interference", false, film_of(film).map_err(wrong)?)
        } else if let Some(mirror) = mirror {
            if !((0.01..=100.0).contains(&mirror.n) && (0.0..=100.0).contains(&mirror.k)) {
                let what = "the index of refraction is out of range; give n = 0.01..100, k = 0..100";
                return Err(recipe.wrong(at, what));
            }
            let angle = angle(mirror.angle_deg).map_err(wrong)?;
            let axis = axis(mirror.axis_deg).map_err(wrong)?;
            let [n, k] = [mirror.n, mirror.k].map(Spectrum::flat);
            let metal = Mirror::conductor(&n, &k, angle.to_radians().cos(), axis / 360.0);
            ("mirror", "polarization", false, What::Mirror(metal))
        } else if let Some(polarizer) = polarizer {
            let [along, across] = [polarizer.along, polarizer.across];
            if ![along, across].iter().all(|share| (0.0..=1.0).contains(share)) {
                return Err(wrong("along and across are shares of the light; give 0..1".into()));
            }
            let [along, across] = [along, across].map(Reflectance::flat);
            let axis = axis(polarizer.axis_deg).map_err(wrong)?;
            let polarizer = Polarizer::new(&along, &across, axis / 360.0);
            ("polarizer", "polarization", false, What::Polarizer(polarizer))
        } else if let Some(retarder) = retarder {
            let (nm, axis) = (retarder.path_difference_nm, axis(retarder.axis_deg).map_err(wrong)?);
            if !(0.0..=1e5).contains(&nm) {
                return Err(wrong(format!("path_difference_nm = {nm} is out of range; give 0..100000")));
            }
            let retarder = Retarder::from_path_difference(nm, axis / 360.0);
            ("retarder", "polarization", false, What::Retarder(retarder))
        } else {
            return Err(recipe.wrong(at, several));
        };
        let name = written.name.clone().unwrap_or_else(|| kind.into());
        Ok(Matter { name, kind, effect, is_matt, what })
    }
}

/// Refuses a film that light meets at an angle next to something that depends on polarization. Such a film
/// polarizes light, but is a plain factor here. A part that scatters between the two makes the light
/// unpolarized again.
pub fn check_films<const N: usize, G: Grid>(recipe: &Recipe, parts: &[Matter<N, G>]) -> Result<(), Failure> {
    let written = &recipe.scene.part;
    let is_oblique =
        |at: &Spanned<Written>| at.get_ref().film.as_ref().is_some_and(|film| film.angle_deg > 0.0);
    let both: Vec<_> = written.iter().zip(parts).collect();
    for stretch in both.split(|(_, part)| part.is_matt || part.kind == "dye") {
        let directed = |(at, part): &&(&Spanned<Written>, &Matter<N, G>)| {
            is_oblique(at) || matches!(part.kind, "mirror" | "polarizer" | "retarder")
        };
        let film = stretch.iter().find(|(at, _)| is_oblique(at));
        if let Some((at, _)) = film
            && stretch.iter().filter(directed).count() > 1
        {
            return Err(recipe.wrong(
                *at,
                "a film at an angle polarizes light, and this program does not follow that next to a mirror, \
                 polarizer, retarder or another such film; give angle_deg = 0, or put a surface between them",
            ));
        }
    }
    Ok(())
}

fn plain<const N: usize, G: Grid>(factors: Reflectance<N, G>) -> What<N, G> {
    What::Plain { factors, without: Reflectance::flat(1.0) }
}

fn factors_of<const N: usize, G: Grid>(
    recipe: &Recipe,
    at: &Spanned<Written>,
    factors: &Factors,
) -> Result<Reflectance<N, G>, Failure> {
    let wrong = |what: String| recipe.wrong(at, what);
    let path_m = match (factors.path_cm, &factors.absorbance_per_cm) {
        (Some(cm), Some(_)) if (0.0..=1e5).contains(&cm) => 0.01 * cm,
        (Some(cm), Some(_)) => return Err(wrong(format!("path_cm = {cm} is out of range; give 0..100000"))),
        (None, Some(_)) => {
            return Err(wrong("the absorbance needs the length of the path; give path_cm".into()));
        }
        (Some(_), None) => {
            return Err(wrong(
                "path_cm belongs to absorbance_per_cm, which is not given; leave it out".into(),
            ));
        }
        (None, None) => 0.0,
    };
    let Factors { flat, points, csv, ces, absorbance_per_cm, .. } = factors;
    match (flat, points, csv, ces, absorbance_per_cm) {
        (Some(share), None, None, None, None) if (0.0..=1.0).contains(share) => Ok(Reflectance::flat(*share)),
        (Some(share), None, None, None, None) => {
            Err(wrong(format!("flat = {share} is not a share of the light; give 0..1")))
        }
        (None, Some(points), None, None, None) => shares(points).map_err(wrong),
        (None, None, Some(path), None, None) => {
            let path = recipe.beside(path);
            let points: Points =
                table::samples(&path)?.into_iter().map(|(nm, value)| Sample { nm, value }).collect();
            shares(&points).map_err(|what| Failure::of(path.display(), what))
        }
        (None, None, None, Some(number), None) => {
            let sample = number.checked_sub(1).and_then(|k| CES.get(k));
            let none = || wrong(format!("there is no sample with ces = {number}; give 1..99"));
            Ok(sample.ok_or_else(none)?.resample())
        }
        (None, None, None, None, Some(points)) => {
            let absorbance: Reflectance<N, G> = samples(points).map_err(wrong)?;
            let glass = Absorber::<N, G>::from_molar(*absorbance.values(), 1.0)
                .map_err(|error| wrong(format!("{error}; give absorbances of 0 or more")))?;
            Ok(glass.transmittance(path_m))
        }
        _ => Err(wrong(
            "a filter or a surface is given in exactly one way; \
             give one of flat, points, csv, ces, absorbance_per_cm"
                .into(),
        )),
    }
}

fn film_of<const N: usize, G: Grid>(film: &Film) -> Result<What<N, G>, String> {
    let indices = [film.n_before, film.n, film.n_behind];
    if !indices.iter().all(|n| (0.01..=100.0).contains(n)) {
        return Err("an index of refraction is out of range; give 0.01..100".into());
    }
    if !(0.0..=1e9).contains(&film.thickness_nm) {
        return Err(format!("thickness_nm = {} is out of range; give 0..1000000000", film.thickness_nm));
    }
    let cos = angle(film.angle_deg)?.to_radians().cos();
    let share = |thickness_nm| {
        let film_of = ThinFilm::new(indices, thickness_nm);
        if film.transmitted { film_of.transmittance(cos) } else { film_of.reflectance(cos) }
    };
    Ok(What::Plain { factors: share(film.thickness_nm), without: share(f32::INFINITY) })
}

fn angle(deg: f32) -> Result<f32, String> {
    if (0.0..=90.0).contains(&deg) {
        Ok(deg)
    } else {
        Err(format!("angle_deg = {deg} is not an angle of incidence; give 0..90"))
    }
}

fn axis(deg: f32) -> Result<f32, String> {
    if (-360.0..=360.0).contains(&deg) {
        Ok(deg)
    } else {
        Err(format!("axis_deg = {deg} is out of range; give -360..360"))
    }
}

/// Reads shares of the light. Beyond its ends a table keeps its last values.
fn shares<const N: usize, G: Grid>(points: &Points) -> Result<Reflectance<N, G>, String> {
    if let Some(Sample { nm, value }) = points.iter().find(|sample| !(0.0..=1.0).contains(&sample.value)) {
        return Err(format!("{value} at {nm} nm is not a share of the light; give 0..1, not percent"));
    }
    samples(points)
}

fn samples<Q: Quantity, const N: usize, G: Grid>(points: &Points) -> Result<Spectrum<Q, N, G>, String> {
    Spectrum::from_samples(&file::pairs(points))
        .map_err(|error| format!("{error}; give [[nm, value], ..] with increasing wavelengths"))
}
