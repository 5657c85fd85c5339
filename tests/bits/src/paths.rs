//! Light on its way: factors, fluorescence, afterglow, Stokes vectors, RGB; walked and folded.

use super::hash::{Hash, Random};
use nanospectra::color::RgbBands;
use nanospectra::color::{Rgb, Srgb};
use nanospectra::matter::{Donaldson, Dye, Mirror, Phosphor, Polarizer, Retarder};
use nanospectra::observer::{CIE_1931, Curve, Observer};
use nanospectra::sensor::{DeadTime, Nonlinearity};
use nanospectra::{Light, Power, Reflectance};

/// Few bands: the smallest part has 16 KB for all of these.
static EYE: Observer<3, 16, Power> = CIE_1931.fold(Curve::Spline);

pub fn run(report: &mut impl FnMut(&str, u32)) {
    report("fluorescence", Hash::of(fluorescence));
    report("polarization", Hash::of(polarization));
    report("rgb-paths", Hash::of(rgb));
    report("linearity", Hash::of(linearity));
}

/// Random light and matter, by dye, by matrix, and with a memory.
fn fluorescence(hash: &mut Hash) {
    let mut random = Random(0x5eed_f100);
    for _ in 0..16 {
        let (light, paper) = (Light::from_bins(random.bins()), Reflectance::from_bins(random.bins()));
        let half = |bins| Reflectance::<16>::from_bins(bins) * 0.4;
        let emission = Light::from_bins(random.bins());
        let Ok(dye) = Dye::new(&half(random.bins()), &half(random.bins()), &emission, 0.8) else {
            hash.word(0);
            continue;
        };
        hash.all(&EYE.sees(light.onto(&paper).onto(&dye).through(&paper)));
        let folded = EYE.through(&paper).looking_at_dye(&dye).looking_at(&paper);
        folded.weights().iter().for_each(|row| hash.all(row));
        let matrix: Donaldson<16, 136> = Donaldson::from_dye(&dye);
        hash.all(light.onto(&matrix).collected().values());
        EYE.looking_at_donaldson(&matrix).weights().iter().for_each(|row| hash.all(row));
        let coarse: Dye<9> = dye.resample();
        hash.all(Light::<9>::from_bins(random.bins()).onto(&coarse).collected().values());
        let mut phosphor = Phosphor::new(dye, 0.1 + random.unit());
        for _ in 0..8 {
            phosphor.step(&light, random.unit());
            hash.one(phosphor.glow());
            phosphor.step(&Light::flat(0.0), random.unit());
            hash.all(&EYE.sees(light.onto(&paper).onto(&phosphor)));
        }
    }
}

/// Mirrors on both sides of every angle that matters, polarizers, plates.
fn polarization(hash: &mut Hash) {
    let mut random = Random(0x5eed_9010);
    for _ in 0..32 {
        let light = Light::from_bins(random.bins());
        let eta = random.bins().map(|unit: f32| 0.5 + 2.0 * unit);
        let lake = Mirror::dielectric(&eta, random.unit(), random.unit());
        let [along, across] = [(); 2].map(|()| Reflectance::from_bins(random.bins()));
        let sheet = Polarizer::new(&along, &across, random.unit());
        let plate = Retarder::from_path_difference(900.0 * random.unit(), random.unit());
        let path = light.polarized().onto(&lake).through(&plate).through(&along).through(&sheet);
        for k in 0..16 {
            hash.all(&path.stokes_at(k));
        }
        hash.all(&EYE.sees(path.ignoring_polarization()));
        let behind = EYE.polarized().through_polarizer(&sheet).through(&along).through_retarder(&plate);
        hash.all(&behind.looking_at_mirror(&lake).unpolarized_light().sees(&light));
        hash.all(lake.ignoring_polarization().values());
    }
}

fn rgb(hash: &mut Hash) {
    static EYE: Observer<3, 3, Power, RgbBands<Srgb>> = Observer::standard();
    let mut random = Random(0x5eed_0369);
    for _ in 0..64 {
        let [[r, g, b], [s, h, c]]: [[f32; 3]; 2] = [(); 2].map(|()| random.bins());
        let lamp = Light::<3, RgbBands<Srgb>>::from_rgb(Rgb::new(r, g, b));
        let paint = Reflectance::from_rgb(Rgb::new(s, h, c));
        hash.all(&EYE.sees(lamp.onto(&paint).through(&paint)));
    }
}

fn linearity(hash: &mut Hash) {
    let mut random = Random(0x5eed_11ea);
    let counter = DeadTime::new(1e-6);
    for _ in 0..256 {
        let rate = 2e6 * random.unit();
        hash.one(counter.counted(rate));
        hash.one(counter.arrived(rate).unwrap_or(-1.0));
        if let Some(bend) = Nonlinearity::new([0.6 * random.unit() - 0.4, 0.2 * random.unit()]) {
            hash.one(bend.signal(random.unit()).unwrap_or(-1.0));
        }
    }
}
