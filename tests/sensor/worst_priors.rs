//! How exact reconstructions by a learnt prior are, for the worst sets of lamps that a search finds.

use crate::reconstruction::exact_covariance;
use model::noise::Noise;
use model::sensor::{self, wide};
use nanospectra::light;
use nanospectra::sensor::{Reconstruction, chip::as7341, covariance_of};
use nanospectra::{Curve, Light, Nodes, Observer, Power};

type Grid = Nodes<400, 700>;
type Chip = Observer<8, 31, Power, Grid>;

static AS7341: Chip = as7341::NOMINAL.fold(Curve::Step);

/// Every light with a name, on the grid of the chip.
fn lights() -> Vec<Light<31, Grid>> {
    light::NAMES.iter().filter_map(|name| light::named(name)).map(|lamp| lamp.resample()).collect()
}

/// The largest error of an entry, relative to the largest entry, against the covariance of the lamps in f64.
fn error(lamps: &[Light<31, Grid>], alpha: f32) -> f64 {
    let expected = sensor::wiener(&wide(AS7341.weights()), &exact_covariance(lamps), alpha.into());
    let got = Reconstruction::wiener(&AS7341, &covariance_of(lamps), alpha).expect("channels that differ");
    let size = expected.iter().flatten().fold(0.0f64, |size, v| size.max(v.abs()));
    let pairs = got.rows().iter().flatten().zip(expected.iter().flatten());
    pairs.map(|(got, exact)| (f64::from(*got) - exact).abs() / size).fold(0.0, f64::max)
}

/// Sets of lamps are exchanged lamp by lamp while the matrix becomes worse.
#[test]
fn a_learnt_prior_is_as_exact_as_promised() {
    let (all, mut noise) = (lights(), Noise(1));
    let mut most = 0.0f64;
    for alpha in [1e-3f32, 1e-2, 1e-1] {
        let bound = 4e-5 + 6e-7 / f64::from(alpha);
        for count in [1, 2, 3, 6, 8, 12, 20, 40, 60] {
            let mut worst = 0.0f64;
            for _ in 0..3 {
                let mut lamps: Vec<_> = (0..count).map(|_| all[noise.bits() as usize % all.len()]).collect();
                let mut here = error(&lamps, alpha);
                for _ in 0..15 {
                    let place = noise.bits() as usize % count;
                    let before = std::mem::replace(&mut lamps[place], all[noise.bits() as usize % all.len()]);
                    let now = error(&lamps, alpha);
                    if now >= here {
                        here = now;
                    } else {
                        lamps[place] = before;
                    }
                }
                worst = worst.max(here);
            }
            println!("{count} lamps, alpha {alpha:e}: {worst:.2e}, {:.2} of what is promised", worst / bound);
            most = most.max(worst / bound);
        }
    }
    assert!((0.5..=1.0).contains(&most), "{most} of what is promised");
}
