//! Transfer functions, 1 for white; `encode` goes from linear light to the signal.

pub fn srgb_encode(v: f64) -> f64 {
    if v <= 0.0031308 { 12.92 * v } else { 1.055 * v.powf(1.0 / 2.4) - 0.055 }
}

pub fn srgb_decode(v: f64) -> f64 {
    if v <= 12.92 * 0.0031308 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
}

/// BT.709 with its four-digit constants.
pub fn bt709_encode(v: f64) -> f64 {
    if v < 0.018 { 4.5 * v } else { 1.099 * v.powf(0.45) - 0.099 }
}

pub fn bt709_decode(v: f64) -> f64 {
    if v < 4.5 * 0.018 { v / 4.5 } else { ((v + 0.099) / 1.099).powf(1.0 / 0.45) }
}

/// BT.2020 with the constants that make it smooth.
pub fn bt2020_encode(v: f64) -> f64 {
    let (alpha, beta) = (1.099_296_826_809_442_7, 0.018_053_968_510_807_807);
    if v < beta { 4.5 * v } else { alpha * v.powf(0.45) - (alpha - 1.0) }
}

const PQ_M1: f64 = 2610.0 / 16384.0;
const PQ_M2: f64 = 2523.0 / 4096.0 * 128.0;
const PQ_C1: f64 = 3424.0 / 4096.0;
const PQ_C2: f64 = 2413.0 / 4096.0 * 32.0;
const PQ_C3: f64 = 2392.0 / 4096.0 * 32.0;

/// SMPTE ST 2084, 1 for 10 000 cd/m2.
pub fn pq_encode(v: f64) -> f64 {
    let p = v.powf(PQ_M1);
    ((PQ_C1 + PQ_C2 * p) / (1.0 + PQ_C3 * p)).powf(PQ_M2)
}

pub fn pq_decode(v: f64) -> f64 {
    let p = v.powf(1.0 / PQ_M2);
    ((p - PQ_C1).max(0.0) / (PQ_C2 - PQ_C3 * p)).powf(1.0 / PQ_M1)
}

const HLG_A: f64 = 0.17883277;
const HLG_B: f64 = 1.0 - 4.0 * HLG_A;

fn hlg_c() -> f64 {
    0.5 - HLG_A * (4.0 * HLG_A).ln()
}

/// BT.2100 hybrid log-gamma, scene light from 0 to 1.
pub fn hlg_encode(v: f64) -> f64 {
    if v <= 1.0 / 12.0 { (3.0 * v).sqrt() } else { HLG_A * (12.0 * v - HLG_B).ln() + hlg_c() }
}

pub fn hlg_decode(v: f64) -> f64 {
    if v <= 0.5 { v * v / 3.0 } else { (((v - hlg_c()) / HLG_A).exp() + HLG_B) / 12.0 }
}

pub fn adobe_encode(v: f64) -> f64 {
    v.powf(256.0 / 563.0)
}

pub fn adobe_decode(v: f64) -> f64 {
    v.powf(563.0 / 256.0)
}

pub fn prophoto_encode(v: f64) -> f64 {
    if v < 1.0 / 512.0 { 16.0 * v } else { v.powf(1.0 / 1.8) }
}

pub fn prophoto_decode(v: f64) -> f64 {
    if v < 16.0 / 512.0 { v / 16.0 } else { v.powf(1.8) }
}

/// BT.1886 with black at zero.
pub fn bt1886_decode(v: f64) -> f64 {
    v.powf(2.4)
}

pub fn dci_decode(v: f64) -> f64 {
    v.powf(2.6)
}
