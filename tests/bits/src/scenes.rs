//! Paths chosen at run time: walked, folded, and within a budget.

use super::hash::{Hash, Random};
use nanospectra::matter::{Donaldson, Dye, Mirror, Polarizer, Retarder};
use nanospectra::observer::{CIE_1931, Curve, Observer};
use nanospectra::path::{IntoPart, Part, Scene};
use nanospectra::{Light, Power, Reflectance};

/// Few bands, as for the other paths.
static EYE: Observer<3, 16, Power> = CIE_1931.fold(Curve::Spline);

pub fn run(report: &mut impl FnMut(&str, u32)) {
    report("scenes", Hash::of(scenes));
}

/// Up to six random parts of random kinds.
fn scenes(hash: &mut Hash) {
    let mut random = Random(0x5eed_5ce0);
    for _ in 0..16 {
        let light = Light::from_bins(random.bins());
        let half = |bins| Reflectance::<16>::from_bins(bins) * 0.4;
        let (glass, emission) = (Reflectance::from_bins(random.bins()), Light::from_bins(random.bins()));
        let Ok(dye) = Dye::new(&half(random.bins()), &half(random.bins()), &emission, 0.8) else {
            hash.word(0);
            continue;
        };
        let matrix: Donaldson<16, 136> = Donaldson::from_dye(&dye);
        let lake = Mirror::dielectric(&[1.0 + random.unit(); 16], random.unit(), random.unit());
        let (sheet, plate) = (Polarizer::ideal(random.unit()), Retarder::flat(random.unit(), random.unit()));
        let mut scene: Scene<16, 6> = Scene::new();
        for _ in 0..6 {
            let part = match (7.0 * random.unit()) as u32 {
                0 => Part::Filter(&glass),
                1 => Part::Surface(&glass),
                2 => (&dye).into_part(),
                3 => (&matrix).into_part(),
                4 => (&lake).into_part(),
                5 => (&sheet).into_part(),
                _ => (&plate).into_part(),
            };
            hash.word(u32::from(scene.push(part).is_ok()));
        }
        hash.all(scene.leaving_polarized(&light).values());
        scene.fold_polarized(&EYE).weights().iter().for_each(|row| hash.all(row));
        let found = scene.within_budget(&EYE, &light, 20.0 * random.unit());
        hash.one(found.delta_e);
        found.scene.left_out().for_each(|part| hash.word(part as u32));
        hash.all(found.scene.leaving_polarized(&light).values());
    }
}
