//! Follows light through the parts of a scene, and computes the color and the price of each part.

use crate::board::{Board, board, code, given, put};
use crate::display::displayed;
use crate::fixed::Fixed;
use nanospectra::color::{Lab, Xy, Xyz};
use nanospectra::math::Portable;
use nanospectra::matter::{
    Absorber, Dye, FluorescenceError, Mirror, Polarizer, PowerShares, Retarder, ThinFilm,
};
use nanospectra::observer::{CIE_1931, CIE_1964};
use nanospectra::path::{IntoPart, Part, Price, Scene};
use nanospectra::radiometry::{Exitance, Irradiance};
use nanospectra::{Curve, Light, Nodes, Observer, Outside, Power, Reflectance, Spectrum};

/// The bands of all spectra, every 5 nm.
type Grid = Nodes<380, 780>;
const N: usize = 81;
/// The most parts that a scene may have.
const PARTS: usize = 16;

/// The observers CIE 1931 and CIE 1964.
pub static EYES: [Observer<3, N, Power, Grid>; 2] =
    [CIE_1931.fold(Curve::Spline), CIE_1964.fold(Curve::Spline)];

/// Returns V(lambda), which is y-bar of CIE 1931.
fn photopic() -> Observer<1, N, Power, Grid> {
    let [eye, _] = &EYES;
    let [_, y, _] = eye.weights();
    Observer::from_weights([*y])
}

/// One part of a scene.
enum What {
    Nothing,
    /// A reflectance of a matt surface, or a transmittance of a clear filter.
    Plain {
        factors: Reflectance<N, Grid>,
        matt: bool,
    },
    Dye(Dye<N, Grid>),
    Mirror(Mirror<N, Grid>),
    Polarizer(Polarizer<N, Grid>),
    Retarder(Retarder<N, Grid>),
}

static CLEAR: Reflectance<N, Grid> = Reflectance::flat(1.0);

impl What {
    fn part(&self) -> Part<'_, N, Grid> {
        match self {
            What::Nothing => Part::Filter(&CLEAR),
            What::Plain { factors, matt: true } => Part::Surface(factors),
            What::Plain { factors, matt: false } => Part::Filter(factors),
            What::Dye(dye) => dye.into_part(),
            What::Mirror(mirror) => mirror.into_part(),
            What::Polarizer(polarizer) => polarizer.into_part(),
            What::Retarder(retarder) => retarder.into_part(),
        }
    }
}

/// The parts in the order in which light meets them, and the factors that replace a plain part whose effect
/// is switched off.
struct Parts {
    parts: [What; PARTS],
    without: [Reflectance<N, Grid>; PARTS],
    count: usize,
}

static SCENE: Fixed<Parts> = Fixed::new(Parts {
    parts: [const { What::Nothing }; PARTS],
    without: [Spectrum::flat(0.0); PARTS],
    count: 0,
});

/// Adds a part behind the others. Returns 0, or 7 if there is no room.
fn add(what: What, without: Reflectance<N, Grid>) -> u32 {
    let Parts { parts, without: plain, count } = &mut *SCENE.get();
    let (Some(part), Some(plain)) = (parts.get_mut(*count), plain.get_mut(*count)) else { return 7 };
    (*part, *plain) = (what, without);
    *count += 1;
    0
}

fn read(samples: &[(f32, f32)], outside: Outside) -> Result<Reflectance<N, Grid>, u32> {
    Spectrum::from_samples_outside(samples, outside).map_err(code)
}

/// Empties the scene.
#[unsafe(no_mangle)]
extern "C" fn clear() {
    SCENE.get().count = 0;
}

/// Adds a filter, or with `matt` a surface, with the factors in the samples. Like all functions that add a
/// part, it returns 0 or the code of an error.
#[unsafe(no_mangle)]
extern "C" fn factors(count: u32, matt: u32) -> u32 {
    match read(given(&board().samples, count), Outside::Hold) {
        Ok(factors) => add(What::Plain { factors, matt: matt != 0 }, CLEAR),
        Err(code) => code,
    }
}

/// Adds a filter with absorbances per cm, or with `matt` a surface behind such a layer. Returns 6 if one of
/// them is not an absorbance.
#[unsafe(no_mangle)]
extern "C" fn absorber(count: u32, path_m: f32, matt: u32) -> u32 {
    let absorbance = match read(given(&board().samples, count), Outside::Hold) {
        Ok(absorbance) => absorbance,
        Err(code) => return code,
    };
    match Absorber::<N, Grid>::from_molar(*absorbance.values(), 1.0) {
        Ok(glass) => add(What::Plain { factors: glass.transmittance(path_m), matt: matt != 0 }, CLEAR),
        Err(_) => 6,
    }
}

/// Adds a dye. The samples hold its reflectance, absorption and emission one after the other, with these
/// numbers of samples. An error of the dye is returned as 65536 plus its kind, and the bins are written to
/// `out`.
#[unsafe(no_mangle)]
extern "C" fn dye(reflectance: u32, absorption: u32, emission: u32, quantum_yield: f32) -> u32 {
    let Board { samples, out, .. } = &mut *board();
    let (first, rest) = samples.split_at((reflectance as usize).min(samples.len()));
    let (second, rest) = rest.split_at((absorption as usize).min(rest.len()));
    let third = rest.get(..emission as usize).unwrap_or(rest);
    let spectra = (read(first, Outside::Hold), read(second, Outside::Hold), read(third, Outside::Zero));
    let (reflects, absorbs, emits) = match spectra {
        (Ok(reflects), Ok(absorbs), Ok(emits)) => (reflects, absorbs, Light::from_bins(*emits.values())),
        (Err(code), ..) | (_, Err(code), _) | (.., Err(code)) => return code,
    };
    match Dye::new(&reflects, &absorbs, &emits, quantum_yield) {
        Ok(dye) => add(What::Dye(dye), CLEAR),
        Err(error) => {
            let (kind, [from, to]) = match error {
                FluorescenceError::OutOfRange { bin } => (0, [bin, 0]),
                FluorescenceError::AntiStokes { from, to } => (1, [from, to]),
                FluorescenceError::QuantumYield => (2, [0, 0]),
                FluorescenceError::NoEmission => (3, [0, 0]),
                FluorescenceError::Energy { bin } => (4, [bin, 0]),
                _ => (5, [0, 0]),
            };
            put(out, 0, [from as f32, to as f32]);
            // This is above any error of samples, which are at most about 8 * 4096.
            (1 << 16) + kind
        }
    }
}

/// Adds a thin film that reflects or transmits light at an angle of this cosine. Without its effect, which is
/// interference, it is a plate.
#[unsafe(no_mangle)]
extern "C" fn film(before: f32, n: f32, behind: f32, nm: f32, cos: f32, transmitted: u32) -> u32 {
    let share = |thickness_nm| {
        let film = ThinFilm::new([before, n, behind], thickness_nm);
        let mut shares = [0.0; N];
        for (k, share) in shares.iter_mut().enumerate() {
            let edge_nm = Reflectance::<N, Grid>::edge_nm;
            let (low_nm, high_nm) = (edge_nm(k), edge_nm(k + 1));
            let mean = PowerShares::mean(film.between_with::<Portable>(low_nm, high_nm, cos));
            *share = if transmitted == 0 { mean.reflected } else { mean.transmitted };
        }
        Spectrum::from_bins(shares)
    };
    add(What::Plain { factors: share(nm), matt: false }, share(f32::INFINITY))
}

/// Adds a mirror of index n + ik that light meets at an angle of this cosine.
#[unsafe(no_mangle)]
extern "C" fn mirror(n: f32, k: f32, cos: f32, axis_turns: f32) -> u32 {
    add(What::Mirror(Mirror::conductor(&Spectrum::flat(n), &Spectrum::flat(k), cos, axis_turns)), CLEAR)
}

/// Adds a polarizer with these transmittances along its axis and across.
#[unsafe(no_mangle)]
extern "C" fn polarizer(along: f32, across: f32, axis_turns: f32) -> u32 {
    let polarizer = Polarizer::new(&Reflectance::flat(along), &Reflectance::flat(across), axis_turns);
    add(What::Polarizer(polarizer), CLEAR)
}

/// Adds a wave plate of this path difference in nm.
#[unsafe(no_mangle)]
extern "C" fn retarder(path_difference_nm: f32, axis_turns: f32) -> u32 {
    add(What::Retarder(Retarder::from_path_difference(path_difference_nm, axis_turns)), CLEAR)
}

/// The places of results in `out`.
mod at {
    /// The 81 numbers of the lamp, and at `LEAVING` the 81 numbers of the light that leaves the scene.
    pub const LIT: usize = 0;
    pub const LEAVING: usize = 81;
    /// X, Y, Z; x, y; L*, a*, b*; 8-bit sRGB and whether it was clipped; then the latter two for the lamp.
    pub const LOOK: usize = 162;
    /// Multiply-adds and bytes for following the light, and then for the folded scene.
    pub const PRICES: usize = 178;
    /// The six numbers of [`absolute`](super::absolute), in lx, W/m2, lm/m2, W/m2, cd/m2 and W/m2/sr.
    pub const ABSOLUTE: usize = 182;
    /// For the parts that are switched on, CIEDE2000 to the whole scene, and multiply-adds.
    pub const SHOWN: usize = 188;
    /// Within the budget, CIEDE2000, multiply-adds, 8-bit sRGB, and a bit for each part that is left out.
    pub const BUDGET: usize = 190;
    /// For each part, multiply-adds, bytes, CIEDE2000 without it, and 8-bit sRGB without it.
    pub const BILL: usize = 196;
}

fn price(price: Price) -> [f32; 2] {
    [price.multiply_adds as f32, price.bytes as f32]
}

/// An observer, the lamp, and the white to which the observer is adapted.
struct Viewing {
    eye: &'static Observer<3, N, Power, Grid>,
    white: Xyz,
    lamp: Light<N, Grid>,
}

impl Viewing {
    /// Returns X, Y, Z; x, y; L*, a*, b*; 8-bit sRGB; and whether that is clipped.
    fn look(&self, light: &Light<N, Grid>) -> [f32; 12] {
        let scale = 100.0 / self.white.y;
        let seen = Xyz::from(self.eye.sees(light)).scaled(scale);
        let white = self.white.scaled(scale);
        let (rgb, [r, g, b]) = displayed(seen, white);
        // The tolerance is below the smallest step of an 8-bit code, which is 3e-4.
        let clipped = rgb.to_array().iter().any(|part| !(-1e-4..=1.0001).contains(part));
        let nan = f32::NAN;
        let lab = seen.lab_with::<Portable>(white).unwrap_or(Lab::new(nan, nan, nan));
        let xy = seen.xy().unwrap_or(Xy::new(nan, nan));
        let Xyz { x, y, z } = seen;
        [x, y, z, xy.x, xy.y, lab.l, lab.a, lab.b, r, g, b, f32::from(u8::from(clipped))]
    }

    fn srgb(&self, scene: &Scene<'_, N, PARTS, Grid>) -> [f32; 3] {
        let look = self.look(&scene.leaving_polarized(&self.lamp));
        [look[8], look[9], look[10]]
    }
}

/// Builds the scene, in which the parts whose bits are set in `off` have no effect.
fn scene(Parts { parts, without, count }: &Parts, off: u32) -> Scene<'_, N, PARTS, Grid> {
    let mut scene = Scene::new();
    for (k, (part, without)) in parts.iter().zip(without).take(*count).enumerate() {
        let is_off = off >> k & 1 == 1;
        let part = match part {
            What::Plain { matt: true, .. } if is_off => Part::Surface(without),
            What::Plain { .. } if is_off => Part::Filter(without),
            part => part.part(),
        };
        // There is always room, since `add` has counted the parts.
        let _ = scene.push(part);
    }
    (0..*count).filter(|k| off >> k & 1 == 1).fold(scene, Scene::leaving_out)
}

/// Computes the scene under the lamp in `curve`, which is scaled to `illuminance_lx` if that is above 0, for
/// eye 0 (CIE 1931) or 1 (CIE 1964). `off` has a bit for each part whose effect is switched off. If `budget`
/// is not negative, effects are left out within that CIEDE2000. Returns 0, or 1 if the lamp is dark.
#[unsafe(no_mangle)]
extern "C" fn answer(eye: u32, illuminance_lx: f32, off: u32, budget: f32) -> u32 {
    let board = &mut *board();
    let parts = &*SCENE.get();
    let lit: Light<N, Grid> = board.curve.resample();
    let photopic = photopic();
    let bare = Irradiance::new(lit).luminous_by(&photopic).value().0;
    let lit = if illuminance_lx > 0.0 { lit * (illuminance_lx / bare) } else { lit };
    let eye = &EYES[usize::from(eye == 1)];
    let white = Xyz::from(eye.sees(&lit));
    if !(bare > 0.0 && (1e-30..=1e30).contains(&white.y)) {
        return 1;
    }
    let viewing = Viewing { eye, white, lamp: lit };
    let whole = scene(parts, 0);
    let shown = scene(parts, off);
    let leaving = shown.leaving_polarized(&lit);
    let out = &mut board.out;
    put(out, at::LIT, *lit.values());
    put(out, at::LEAVING, *leaving.values());
    put(out, at::LOOK, viewing.look(&leaving));
    let [.., r, g, b, clipped] = viewing.look(&lit);
    put(out, at::LOOK + 12, [r, g, b, clipped]);

    // The price of applying the three rows of the observer.
    let reading = Price { multiply_adds: 3 * N, bytes: 12 * N, ..Price::NONE };
    put(out, at::PRICES, price(whole.price().plus(Price::light(N)).plus(reading)));
    put(out, at::PRICES + 2, price(whole.folded_price(3).plus(Price::light(N))));
    put(out, at::ABSOLUTE, absolute(lit, leaving, &photopic));
    let [cost, _] = price(shown.price().plus(reading));
    put(out, at::SHOWN, [whole.difference(&shown, eye, &lit), cost]);
    if budget >= 0.0 {
        let found = whole.within_budget(eye, &lit, budget);
        let [cost, _] = price(found.scene.price().plus(reading));
        let [r, g, b] = viewing.srgb(&found.scene);
        let left_out = found.scene.left_out().fold(0, |bits, k| bits | 1 << k);
        put(out, at::BUDGET, [found.delta_e, cost, r, g, b, left_out as f32]);
    }
    for (k, line) in whole.bill().enumerate() {
        let without = scene(parts, 1 << k);
        let [multiply_adds, bytes] = price(line.price);
        let [r, g, b] = viewing.srgb(&without);
        let delta_e = whole.difference(&without, eye, &lit);
        put(out, at::BILL + 6 * k, [multiply_adds, bytes, delta_e, r, g, b]);
    }
    0
}

/// Returns the illuminance and irradiance of the light that arrives, the luminous and radiant exitance of the
/// light that leaves, and the luminance and radiance for a matt surface.
fn absolute(
    lit: Light<N, Grid>,
    leaving: Light<N, Grid>,
    photopic: &Observer<1, N, Power, Grid>,
) -> [f32; 6] {
    let (arrives, leaves) = (Irradiance::new(lit), Exitance::new(leaving));
    let radiance = leaves.lambertian();
    [
        arrives.luminous_by(photopic).value().0,
        arrives.radiant().value().0,
        leaves.luminous_by(photopic).value().0,
        leaves.radiant().value().0,
        radiance.luminous_by(photopic).value().0,
        radiance.radiant().value().0,
    ]
}
