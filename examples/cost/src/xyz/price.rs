//! What XYZ of one surface costs: instructions on record, bytes, and nanoseconds on this machine.

use super::scheme::{BANDS, Scheme};
use crate::clock::nanoseconds;
use crate::counts::{Core, instructions};
use nanospectra::observer::CIE_1931;
use nanospectra::{Curve, Light, Observer, Power, Reflectance, light, matter};
use nanospectra_hard::yardstick::product::rgb_product;
use std::hint::black_box;

pub struct Price {
    pub m4f: Option<u32>,
    pub m0: Option<u32>,
    pub constants: usize,
    pub per_surface: usize,
    pub nanoseconds: f64,
}

/// The times of each number of bands, with the light folded in and without.
pub struct Prices {
    bands: Vec<(usize, f64, f64)>,
    rgb: f64,
}

impl Prices {
    pub fn measured(runs: usize) -> Self {
        macro_rules! each {
            ($($n:literal)*) => { vec![$({
                let (folded, unfolded) = timed::<$n>(runs);
                ($n, folded, unfolded)
            }),*] };
        }
        let bands = each!(3 8 12 16 20 24 31 36 40 60 81 95);
        debug_assert!(bands.iter().map(|row: &(usize, f64, f64)| row.0).eq(BANDS));
        let rgb = nanoseconds(runs, || rgb_product(black_box([0.9, 1.0, 0.8]), black_box([0.2, 0.5, 0.7])));
        Prices { bands, rgb }
    }

    pub fn of(&self, scheme: Scheme, bands: usize) -> Price {
        let time =
            self.bands.iter().find(|row| row.0 == bands).map_or(
                f64::NAN,
                |(_, folded, unfolded)| match scheme {
                    Scheme::Rgb => self.rgb,
                    _ if scheme.is_folded() => *folded,
                    _ => *unfolded,
                },
            );
        let counted = scheme.counted_as(bands);
        Price {
            m4f: instructions(Core::M4F, &counted),
            m0: instructions(Core::M0, &counted),
            constants: scheme.bytes(bands),
            per_surface: scheme.bytes_per_surface(bands),
            nanoseconds: time,
        }
    }
}

fn timed<const N: usize>(runs: usize) -> (f64, f64) {
    let eye: Observer<3, N, Power> = CIE_1931.fold(Curve::Spline);
    let lamp: Light<N> = light::FL11.resample();
    let lit = eye.under(&lamp);
    let paint: Reflectance<N> = matter::CES[0].resample();
    let folded = nanoseconds(runs, || black_box(&lit).sees(black_box(&paint)));
    (folded, nanoseconds(runs, || black_box(&eye).sees(black_box(&lamp).onto(black_box(&paint)))))
}
