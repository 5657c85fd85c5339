//! What the groups are made of: a hash over bits, and numbers that are the same everywhere.

use core::array::from_fn;

/// FNV-1a, 32 bits.
pub struct Hash(pub u32);

impl Hash {
    /// Of what `f` hands over.
    pub fn of(f: impl FnOnce(&mut Hash)) -> u32 {
        let mut hash = Hash(0x811c_9dc5);
        f(&mut hash);
        hash.0
    }

    pub fn word(&mut self, word: u32) {
        for byte in word.to_le_bytes() {
            self.0 = (self.0 ^ u32::from(byte)).wrapping_mul(0x0100_0193);
        }
    }

    pub fn one(&mut self, value: f32) {
        // Which NaN comes out of an operation is the processor's choice; that it is one is ours.
        self.word(if value.is_nan() { f32::NAN.to_bits() } else { value.to_bits() });
    }

    pub fn all(&mut self, values: &[f32]) {
        values.iter().for_each(|value| self.one(*value));
    }

    pub fn maybe(&mut self, values: Option<[f32; 2]>) {
        match values {
            Some(values) => self.all(&values),
            None => self.word(0),
        }
    }
}

/// Marsaglia's xorshift: the same numbers everywhere, and exact as floats.
pub struct Random(pub u32);

impl Random {
    /// 0..1
    pub fn unit(&mut self) -> f32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        (self.0 >> 8) as f32 / 16_777_216.0
    }

    pub fn bins<const N: usize>(&mut self) -> [f32; N] {
        from_fn(|_| self.unit())
    }
}
