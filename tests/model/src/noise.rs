//! Numbers without a pattern, the same in every run.

/// By Knuth's linear congruential generator, MMIX.
pub struct Noise(pub u64);

impl Noise {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0
    }

    pub fn bits(&mut self) -> u32 {
        (self.next() >> 32) as u32
    }

    /// From 0 to 1.
    pub fn uniform(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f32 {
        (low + (high - low) * self.uniform()) as f32
    }

    /// Evenly in the logarithm.
    pub fn decades(&mut self, low: f64, high: f64) -> f32 {
        (low * (high / low).powf(self.uniform())) as f32
    }

    /// Mean 0, variance 1, by Box and Muller.
    pub fn normal(&mut self) -> f64 {
        (-2.0 * (1.0 - self.uniform()).ln()).sqrt() * (std::f64::consts::TAU * self.uniform()).cos()
    }

    /// From 0 to 1, in the 24 bits of an f32.
    pub fn share(&mut self) -> f32 {
        (self.next() >> 40) as f32 / 16_777_216.0
    }

    pub fn shares<const N: usize>(&mut self) -> [f32; N] {
        std::array::from_fn(|_| self.share())
    }

    /// From -1 to 1.
    pub fn offset(&mut self) -> f32 {
        2.0 * self.share() - 1.0
    }

    /// In the cube from -1 to 1.
    pub fn point(&mut self) -> [f32; 3] {
        std::array::from_fn(|_| self.offset())
    }
}
