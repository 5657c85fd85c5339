//! Pseudorandom numbers that are the same on every target.

pub struct Noise(pub u64);

impl Noise {
    /// Returns a number from 0 to 1.
    pub fn share(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 40) as f32 / 16_777_216.0
    }

    /// Returns a number from -1 to 1.
    pub fn offset(&mut self) -> f32 {
        2.0 * self.share() - 1.0
    }
}
