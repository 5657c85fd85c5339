//! Random choices that are the same for the same seed, and numbers as a user or an instrument may write them.

/// A generator of random numbers (SplitMix64).
pub struct Dice(u64);

/// Which numbers the cells of a run have.
#[derive(Clone, Copy)]
pub enum Mood {
    /// Between 0 and 1, times a power of ten.
    Scaled(i32),
    /// Any bits of an f64, and words such as nan.
    Wild,
    /// Mostly between 0 and 1, and now and then wild.
    Spotted,
}

/// Texts that hurt programs.
const EDGES: [&str; 28] = [
    "0",
    "-0",
    "0.0",
    "1",
    "-1",
    "nan",
    "NaN",
    "inf",
    "-inf",
    "infinity",
    "",
    " ",
    "1e400",
    "-1e400",
    "1e-400",
    "5e-324",
    "1e-310",
    "1e-45",
    "1.4e-45",
    "1.17e-38",
    "3.4028235e38",
    "3.4028236e38",
    "1e39",
    "1.7976931348623157e308",
    "-1e308",
    "1e16",
    "0,5",
    "1_000",
];

impl Dice {
    pub fn new(seed: u64) -> Self {
        Dice(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15))
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Returns a whole number below `end`.
    pub fn below(&mut self, end: usize) -> usize {
        (self.bits() % end as u64) as usize
    }

    /// Returns whether a thing happens that happens once in `times`.
    pub fn once_in(&mut self, times: usize) -> bool {
        self.below(times) == 0
    }

    /// Returns a number of 0..1.
    pub fn share(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.share()
    }

    pub fn of<'a, T: ?Sized>(&mut self, choices: &[&'a T]) -> &'a T {
        choices[self.below(choices.len())]
    }

    pub fn mood(&mut self) -> Mood {
        match self.below(8) {
            0..=2 => Mood::Scaled(0),
            3..=5 => {
                let most = [3, 20, 45, 323][self.below(4)];
                Mood::Scaled(self.below(2 * most) as i32 - most as i32)
            }
            6 => Mood::Spotted,
            _ => Mood::Wild,
        }
    }

    /// Returns a number as text.
    pub fn number(&mut self, mood: Mood) -> String {
        match mood {
            Mood::Scaled(power) => {
                let share = if self.once_in(12) { 0.0 } else { self.share() };
                format!("{share:.6}e{power}")
            }
            Mood::Spotted if !self.once_in(12) => format!("{:.6}", self.share()),
            Mood::Spotted | Mood::Wild => self.wild(),
        }
    }

    fn wild(&mut self) -> String {
        match self.below(5) {
            0 => self.of(&EDGES).into(),
            1 => format!("{:e}", f64::from_bits(self.bits())),
            2 => format!("{:e}", f32::from_bits(self.bits() as u32)),
            3 => {
                let power = self.below(648) as i32 - 324;
                format!("{:.3}e{power}", self.share())
            }
            _ => f64::from_bits(self.bits()).to_string(),
        }
    }

    /// Returns a number that is between two bounds unless the mood is wild.
    pub fn number_in(&mut self, mood: Mood, from: f64, to: f64) -> String {
        match mood {
            Mood::Wild if !self.once_in(3) => self.wild(),
            Mood::Spotted if self.once_in(12) => self.wild(),
            _ => format!("{:.4}", self.between(from, to)),
        }
    }
}
