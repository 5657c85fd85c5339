//! Damaged files: whatever the bytes are, the reader answers with sound curves or with a refusal.

use crate::layouts::all;
use nanospectra_files::{AxisUnit, By, Kind, Options, Reading, read};

/// How many damaged files are read: `NANOSPECTRA_FUZZ_RUNS=1000000` reads that many.
fn runs() -> u64 {
    std::env::var("NANOSPECTRA_FUZZ_RUNS").ok().and_then(|runs| runs.parse().ok()).unwrap_or(2000)
}

/// A generator of numbers, splitmix64.
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, end: usize) -> usize {
        (self.next() % end.max(1) as u64) as usize
    }
}

/// What damage likes to write.
const WORDS: [&str; 26] = [
    "nm",
    "W/m2/nm",
    "NaN",
    "-999",
    "1e308",
    "-1e308",
    "1e-320",
    "380",
    "0",
    "-",
    ",",
    ";",
    "\t",
    "\"",
    "\n",
    "\r",
    "(",
    "[",
    "um",
    "THz",
    "%",
    "Absorbance",
    "\u{2212}5",
    "\0",
    "{",
    "<?xml?>",
];

fn damaged(dice: &mut Dice, mut bytes: Vec<u8>) -> Vec<u8> {
    // Long files take long to read, and their middle is all alike.
    let longest = 400 + dice.below(4000);
    bytes.truncate(longest);
    for _ in 0..1 + dice.below(6) {
        let at = dice.below(bytes.len() + 1);
        let to = (at + dice.below(30)).min(bytes.len());
        match dice.below(5) {
            0 if at < bytes.len() => bytes[at] = dice.below(256) as u8,
            1 => drop(bytes.drain(at..to)),
            2 => {
                let piece = bytes[at..to].to_vec();
                let place = dice.below(bytes.len() + 1);
                bytes.splice(place..place, piece);
            }
            3 => bytes.truncate(at),
            _ => {
                let word = WORDS[dice.below(WORDS.len())];
                bytes.splice(at..at, word.bytes());
            }
        }
    }
    bytes
}

#[test]
fn whatever_the_bytes_are_the_reading_is_sound() {
    let layouts = all();
    let mut read_well = 0;
    let count = runs();
    for seed in 0..count {
        let mut dice = Dice(seed);
        let layout = &layouts[dice.below(layouts.len())];
        let bytes = damaged(&mut dice, layout.bytes.clone());
        match read(&bytes, &Options::default()) {
            Ok(reading) => {
                read_well += 1;
                assert_sound(&reading, &bytes, &format!("seed {seed}, {}", layout.name));
            }
            Err(refusal) => {
                assert!(refusal.what.contains(';') || refusal.setting.is_some(), "seed {seed}: {refusal}")
            }
        }
    }
    assert!(read_well > count / 6, "{read_well} of {count}");
}

fn assert_sound(reading: &Reading, bytes: &[u8], place: &str) {
    assert!(!reading.curves.is_empty(), "{place}");
    for curve in &reading.curves {
        let count = curve.wavelengths.len();
        assert!(count >= 2 && curve.values.len() == count && curve.lines.len() == count, "{place}");
        assert!(curve.wavelengths.windows(2).all(|pair| pair[0] < pair[1]), "{place}");
        assert!(curve.wavelengths.iter().chain(&curve.values).all(|number| number.is_finite()), "{place}");
        assert!(curve.edges.as_ref().is_none_or(|edges| edges.len() == count + 1), "{place}");
        // A unit that nobody states is an assumption, of which there is a note.
        let says_nm = String::from_utf8_lossy(bytes).replace('\0', "").to_lowercase().contains("nm");
        let is_assumed = reading
            .notes
            .iter()
            .any(|note| note.kind == Kind::Assumed && note.what.contains("axis is in nm"));
        assert!(curve.axis != AxisUnit::Nanometer || says_nm || is_assumed, "{place}: {:?}", reading.notes);
        assert_eq!(curve.unit.is_none(), curve.unit_by == By::Nobody, "{place}");
    }
}
