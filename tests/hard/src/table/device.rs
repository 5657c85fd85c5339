//! The results of a Cortex-M4F, as `tests/devices.sh --bless` recorded them.

use std::collections::HashMap;

const RECORD: &str = include_str!("../../../data/hard_m4f.txt");

/// The results of both forms for one input.
#[derive(Clone, Default)]
pub struct Numbers {
    pub naive: Vec<f32>,
    pub ours: Vec<f32>,
}

/// The results by row and input, first with subnormal numbers, then with those flushed to zero where that
/// makes a difference.
pub struct Recorded {
    plain: HashMap<(String, usize), Numbers>,
    flushed: HashMap<(String, usize), Numbers>,
}

impl Recorded {
    pub fn read() -> Self {
        let (mut plain, mut flushed) = (HashMap::new(), HashMap::new());
        let mut into = &mut plain;
        for line in RECORD.lines().filter(|line| !line.starts_with('#')) {
            if line == "flush-to-zero" {
                into = &mut flushed;
                continue;
            }
            let words: Vec<&str> = line.split(' ').collect();
            let [row, k, naive, ours] = words[..] else { panic!("tests/data/hard_m4f.txt: {line}") };
            let k = k.parse().unwrap_or_else(|_| panic!("tests/data/hard_m4f.txt: {line}"));
            into.insert((row.to_string(), k), Numbers { naive: floats(naive), ours: floats(ours) });
        }
        Recorded { plain, flushed }
    }

    /// Returns nothing for a row that is not on record, because no device has run it yet.
    pub fn at(&self, row: &str, k: usize) -> [Numbers; 2] {
        let key = (row.to_string(), k);
        let plain = self.plain.get(&key).cloned().unwrap_or_default();
        let flushed = self.flushed.get(&key).cloned().unwrap_or_else(|| plain.clone());
        [plain, flushed]
    }
}

fn floats(bits: &str) -> Vec<f32> {
    let one = |bits| f32::from_bits(u32::from_str_radix(bits, 16).expect("eight hexadecimal digits"));
    bits.split(',').map(one).collect()
}
