//! Runs the crate by every scheme under every lamp, for each range and number of bands.

use super::scheme::{SPECTRAL, Scheme};
use super::score::{Score, Seen, score};
use super::world::{CES, Lamp, Surface, World};
use nanospectra::observer::CIE_1931;
use nanospectra::{
    Bins, Curve, Factor, Grid, Interpolation, Light, Nodes, Observer, Power, Reflectance, Spectrum,
};
use nanospectra_hard::yardstick::product::rgb_product;

/// The ranges of the bands, in nm.
pub const RANGES: [&str; 3] = ["400..700", "380..730", "380..780"];

/// A choice and its errors.
pub struct Outcome {
    pub range: &'static str,
    pub scheme: Scheme,
    pub bands: usize,
    pub score: Score,
}

/// Runs every scheme at one number of bands on one range.
pub type Job = fn(&World) -> Vec<Outcome>;

macro_rules! jobs {
    ($($n:literal)*) => {
        &[
            $(on::<$n, Bins<400, 700>, Nodes<400, 700>>,)*
            $(on::<$n, Bins<380, 730>, Nodes<380, 730>>,)*
            $(on::<$n, Bins<380, 780>, Nodes<380, 780>>,)*
        ]
    };
}

/// The jobs of all ranges and numbers of bands.
pub const JOBS: &[Job] = jobs!(3 8 12 16 20 24 31 36 40 60 81 95);

/// Runs every scheme on the bins `B`, or, for points, on the nodes `P` of the same range.
fn on<const N: usize, B: Grid, P: Grid>(world: &World) -> Vec<Outcome> {
    let range = format!("{}..{}", B::FIRST, B::LAST);
    let range = RANGES.into_iter().find(|known| *known == range).unwrap_or("");
    // Two bounces and narrow filters are looked at on the usual range alone.
    let sets = if range == "380..730" { &world.sets[..] } else { &world.sets[..=CES] };
    let bins: Vec<Vec<Reflectance<N, B>>> = sets.iter().map(|set| averages(set)).collect();
    let points: Vec<Vec<Reflectance<N, P>>> = sets.iter().map(|set| values(set)).collect();
    SPECTRAL
        .into_iter()
        .map(|scheme| {
            let seen: Vec<Seen> = world
                .lamps
                .iter()
                .map(|lamp| match scheme {
                    Scheme::Points => {
                        let light: Light<N, P> = interpolated(&lamp.points);
                        unfolded(&eye_at_points(), &light, &points, lamp)
                    }
                    Scheme::Folded(curve) => {
                        let eye: Observer<3, N, Factor, B> = lamp.eye.fold(curve);
                        let sees = |surface: &Reflectance<N, B>| eye.sees(surface).map(f64::from);
                        seen(&bins, sees)
                    }
                    Scheme::Averages => unfolded(&eye_cut_off(), &averaged(lamp), &bins, lamp),
                    Scheme::Eye => unfolded(&CIE_1931.fold(Curve::Parabola), &averaged(lamp), &bins, lamp),
                    Scheme::Tails | Scheme::Rgb => {
                        unfolded(&CIE_1931.fold(Curve::Step), &averaged(lamp), &bins, lamp)
                    }
                })
                .collect();
            Outcome { range, scheme, bands: N, score: score(world, &seen) }
        })
        .collect()
}

/// Runs the product of RGB colors for comparison, on the samples alone.
pub fn in_rgb(world: &World) -> Outcome {
    let seen: Vec<Seen> = world
        .lamps
        .iter()
        .map(|lamp| Seen {
            white: rgb_product(lamp.rgb, [1.0; 3]).map(f64::from),
            sets: vec![world.rgb.iter().map(|&paint| rgb_product(lamp.rgb, paint).map(f64::from)).collect()],
        })
        .collect();
    Outcome { range: "-", scheme: Scheme::Rgb, bands: 3, score: score(world, &seen) }
}

fn unfolded<const N: usize, G: Grid>(
    eye: &Observer<3, N, Power, G>,
    light: &Light<N, G>,
    sets: &[Vec<Reflectance<N, G>>],
    lamp: &Lamp,
) -> Seen {
    let scale = lamp.fine.scale();
    seen(sets, |surface| eye.sees(light.onto(surface)).map(|value| scale * f64::from(value)))
}

fn seen<const N: usize, G: Grid>(
    sets: &[Vec<Reflectance<N, G>>],
    sees: impl Fn(&Reflectance<N, G>) -> [f64; 3],
) -> Seen {
    Seen {
        white: sees(&Reflectance::flat(1.0)),
        sets: sets.iter().map(|surfaces| surfaces.iter().map(&sees).collect()).collect(),
    }
}

fn averaged<const N: usize, G: Grid>(lamp: &Lamp) -> Light<N, G> {
    Light::from_samples(&lamp.points).expect("a lamp's wavelengths increase")
}

fn interpolated<const N: usize, G: Grid>(points: &[(f32, f32)]) -> Light<N, G> {
    Light::interpolated(points, Interpolation::Linear).expect("a lamp's wavelengths increase")
}

/// Averages each surface over the bins. For two bounces this is the product of both averages.
fn averages<const N: usize, G: Grid>(set: &[Surface]) -> Vec<Reflectance<N, G>> {
    products(set, |factor| Reflectance::from_samples(factor).expect("a sample"))
}

fn values<const N: usize, G: Grid>(set: &[Surface]) -> Vec<Reflectance<N, G>> {
    products(set, |factor| Reflectance::interpolated(factor, Interpolation::Linear).expect("a sample"))
}

fn products<const N: usize, G: Grid>(
    set: &[Surface],
    one: impl Fn(&[(f32, f32)]) -> Reflectance<N, G>,
) -> Vec<Reflectance<N, G>> {
    let of = |factors: &Vec<Vec<(f32, f32)>>| {
        factors.iter().map(|factor| one(factor)).fold(Reflectance::flat(1.0), |all, factor| all * factor)
    };
    set.iter().map(|surface| of(&surface.factors)).collect()
}

/// The rows of the observer's own table as points (nm, weight).
fn table() -> [Vec<(f32, f32)>; 3] {
    let rows = CIE_1931.weights();
    rows.map(|row| row.into_iter().enumerate().map(|(k, weight)| (360.0 + k as f32, weight)).collect())
}

/// Averages the color-matching functions over the bins, without what lies outside them.
fn eye_cut_off<const N: usize, G: Grid>() -> Observer<3, N, Power, G> {
    Observer::from_rows(
        table()
            .map(|row| *Spectrum::<Power, N, G>::from_samples(&row).expect("the observer's table").values()),
    )
}

/// Reads the color-matching functions at the nodes, for sums of points.
fn eye_at_points<const N: usize, G: Grid>() -> Observer<3, N, Power, G> {
    Observer::from_rows(table().map(|row| *interpolated::<N, G>(&row).values()))
}
