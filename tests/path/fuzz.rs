//! A million random cases of matter, read-outs and light, of any size that f32 has: no finite number gives
//! NaN.

use nanospectra::math::Fast;
use nanospectra::matter::{Dye, Mirror, Mueller, Phosphor, Polarizer, Retarder};
use nanospectra::sensor::{DeadTime, Nonlinearity};
use nanospectra::{Bins, Light, Reflectance, Spectrum};

type Two = Bins<400, 700>;

/// Debug builds are some 30 times slower.
const CASES: usize = if cfg!(debug_assertions) { 30_000 } else { 1_000_000 };

struct Random(u64);

impl Random {
    /// Marsaglia's xorshift64*.
    fn bits(&mut self) -> u32 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 32) as u32
    }

    /// Any finite f32; in three of eight cases one of a size that is in use, 2^-20 to 2^20, or an edge.
    fn any(&mut self) -> f32 {
        match self.bits() % 8 {
            0..4 => loop {
                let value = f32::from_bits(self.bits());
                if value.is_finite() {
                    return value;
                }
            },
            4..7 => {
                let size = 2f32.powi((self.bits() % 41) as i32 - 20) * (1.0 + self.unit());
                if self.bits().is_multiple_of(2) { size } else { -size }
            }
            _ => [0.0, 1.0, -1.0, f32::MAX, f32::MIN_POSITIVE, 0.5, 1e-45, 2.0][self.bits() as usize % 8],
        }
    }

    /// 0..1.
    fn unit(&mut self) -> f32 {
        (self.bits() >> 8) as f32 / 16_777_216.0
    }

    fn two(&mut self) -> [f32; 2] {
        [self.any(), self.any()]
    }
}

#[test]
fn no_counter_and_no_bend_gives_nan() {
    let mut random = Random(0x5eed_0001);
    let mut bends = 0;
    for _ in 0..CASES {
        let (seconds, rate) = (random.any(), random.any());
        let counter = DeadTime::new(seconds);
        assert!(!counter.counted(rate).is_nan(), "{seconds:e} {rate:e}");
        assert!(!counter.arrived(rate).is_some_and(f32::is_nan), "{seconds:e} {rate:e}");
        let coefficients = [random.any(), random.any()];
        let read = random.any();
        // (Judged at 257 places: one in eight is enough.)
        if random.bits().is_multiple_of(8) {
            let small = [12.0 * random.unit() - 1.0, 9.0 * random.unit() - 7.0];
            for coefficients in [coefficients, small] {
                let Some(bend) = Nonlinearity::new(coefficients) else { continue };
                bends += 1;
                for read in [read, random.unit(), bend.read(random.unit()), bend.read(1.0)] {
                    if let Some(signal) = bend.signal(read) {
                        assert!((0.0..=1.0).contains(&signal), "{coefficients:?} {read:e}: {signal:e}");
                    }
                }
            }
        }
    }
    assert!(bends > CASES / 50, "{bends}");
}

#[test]
fn nothing_that_polarizes_gives_nan() {
    let mut random = Random(0x5eed_0002);
    for case in 0..CASES {
        let axis = random.any();
        let (numbers, others) = (random.two(), random.two());
        let [first, second] = [numbers, others].map(Reflectance::<2, Two>::from_bins);
        let element: Mueller<2, Two> = match case % 6 {
            0 => *Polarizer::ideal(axis).mueller(),
            1 => *Polarizer::new(&first, &second, axis).mueller(),
            2 => *Retarder::from_path_difference(numbers[0], axis).mueller(),
            3 => *Retarder::flat(numbers[0], axis).mueller(),
            4 => *Mirror::dielectric(&numbers.map(f32::abs), others[0], axis).mueller(),
            _ => {
                let turns = f64::from(random.unit()) * core::f64::consts::TAU;
                let phase = [turns.cos() as f32, turns.sin() as f32];
                *Mirror::new(&first, &second, &[phase; 2], axis).mueller()
            }
        };
        let intensity = random.unit();
        let light = [1.0, 0.6, -0.64, 0.48].map(|share| share * intensity);
        for k in 0..2 {
            let left = element.turn(k, light);
            assert!(left.iter().all(|v| !v.is_nan()), "{case}: {axis:e} {numbers:?} {others:?}: {left:?}");
        }
    }
}

#[test]
fn no_metal_in_use_gives_nan_or_more_than_all() {
    let mut random = Random(0x5eed_0003);
    for _ in 0..CASES {
        let [n, k] =
            [4.0 * random.unit(), if random.bits().is_multiple_of(4) { 0.0 } else { 8.0 * random.unit() }];
        let (cos, axis) = (random.unit(), random.any());
        let metal = Mirror::<1, Bins<500, 600>>::conductor(&Spectrum::flat(n), &Spectrum::flat(k), cos, axis);
        let [i, ..] = metal.mueller().turn(0, [1.0, 0.0, 0.0, 1.0]);
        assert!((0.0..=1.0).contains(&i), "{n} {k} {cos}: {i}");
    }
}

#[test]
fn no_afterglow_gives_nan() {
    let mut random = Random(0x5eed_0004);
    let dye = Dye::new(
        &Reflectance::<2, Two>::flat(0.1),
        &Reflectance::from_bins([0.8, 0.1]),
        &Light::from_bins([0.0, 1.0]),
        0.9,
    )
    .expect("possible");
    for _ in 0..CASES / 8 {
        let mut phosphor = Phosphor::new(dye, random.any().abs());
        for _ in 0..8 {
            let light = Light::from_bins(random.two().map(f32::abs));
            phosphor.step_with::<Fast, _>(&light, random.any().abs());
            assert!(phosphor.glow().is_finite() && phosphor.glow() >= 0.0, "{phosphor:?}");
        }
    }
}
