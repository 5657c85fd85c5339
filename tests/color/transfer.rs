//! Transfer functions: golden 12, the f64 model, knees, round trips, 8-bit codes.
#![cfg(feature = "libm")]

use model::allowed::{Singles, check};
use model::csv::golden;
use model::transfer as reference;
use nanospectra::color::transfer::{
    AdobeRgbTransfer, Bt709, Bt1886, DciTransfer, Hlg, LinearTransfer, Pq, ProPhotoTransfer, SrgbTransfer,
    Transfer, from_u8, to_u8,
};
use nanospectra::color::{AdobeRgb, EncodedRgb, Rgb};
use proptest::prelude::*;

#[test]
fn golden_values_agree() {
    let mut all = [
        ("sRGB_oetf", SrgbTransfer::encode as fn(f32) -> f32, "sRGB encode, golden 12"),
        ("sRGB_eotf", SrgbTransfer::decode, "sRGB decode, golden 12"),
        ("Adobe_enc", AdobeRgbTransfer::encode, "Adobe encode, golden 12"),
        ("Adobe_dec", AdobeRgbTransfer::decode, "Adobe decode, golden 12"),
        ("gamma2.4", Bt1886::decode, "BT.1886 decode, golden 12"),
        ("BT709_oetf", Bt709::encode, "BT.709 encode, golden 12"),
        ("BT709_inv", Bt709::decode, "BT.709 decode, golden 12"),
        ("ProPhoto_enc", ProPhotoTransfer::encode, "ProPhoto encode, golden 12"),
        ("ProPhoto_dec", ProPhotoTransfer::decode, "ProPhoto decode, golden 12"),
        ("gamma2.6", DciTransfer::decode, "DCI decode, golden 12"),
        ("PQ_inv_eotf", Pq::encode, "PQ encode, golden 12"),
        ("PQ_eotf", Pq::decode, "PQ decode, golden 12"),
        ("HLG_oetf", Hlg::encode, "HLG encode, golden 12"),
        ("HLG_inv", Hlg::decode, "HLG decode, golden 12"),
    ]
    .map(|(column, function, what)| (column, function, check(what)));
    for row in golden("12_transfer_functions").rows() {
        for (column, function, check) in &mut all {
            let v = row.number("v");
            let expected = match *column {
                // Inside the jump of BT.709 the golden goes on with the power; see the knees below.
                "BT709_inv" if (0.081..0.081_247).contains(&v) => 0.018,
                _ => row.number(column),
            };
            check.add(&row.place(), function(v as f32), expected);
        }
    }
    all.into_iter().for_each(|(.., check)| check.tight(66));
}

/// How long the [`sweep`] is.
const SWEPT: usize = 100_001 + 30 * 64;

/// 0 to 1 in equal steps, then the octaves down to 2^-30, where a curve is steepest.
fn sweep() -> impl Iterator<Item = f32> {
    let even = (0..=100_000_u32).map(|k| k as f32 / 100_000.0);
    let low =
        (0..30).flat_map(|octave| (0..64).map(move |k| (1.0 + k as f32 / 64.0) / (2u64 << octave) as f32));
    even.chain(low)
}

fn swept(what: &'static str, function: fn(f32) -> f32, model: fn(f64) -> f64) {
    let mut curve = check(what);
    sweep().for_each(|v| curve.add(&format!("{v}"), function(v), model(f64::from(v))));
    curve.tight(SWEPT);
}

#[test]
fn every_curve_follows_the_model() {
    swept("sRGB encode, swept", SrgbTransfer::encode, reference::srgb_encode);
    swept("sRGB decode, swept", SrgbTransfer::decode, reference::srgb_decode);
    swept("BT.1886 decode, swept", Bt1886::decode, reference::bt1886_decode);
    swept("BT.1886 encode, swept", Bt1886::encode, |v| v.powf(1.0 / 2.4));
    swept("BT.709 encode, swept", Bt709::encode, |v| {
        // The knee in f32 is a little below 0.018.
        reference::bt709_encode(if v == f64::from(0.018_f32) { 0.018 } else { v })
    });
    swept("BT.709 decode, swept", Bt709::decode, |v| match v {
        // The inverse of the standard's curve, which jumps from 0.081 to this: codes inside are 0.018.
        0.081..0.081_247_944_035_140_54 => 0.018,
        _ => reference::bt709_decode(v),
    });
    swept("DCI encode, swept", DciTransfer::encode, |v| v.powf(1.0 / 2.6));
    swept("DCI decode, swept", DciTransfer::decode, reference::dci_decode);
    swept("ProPhoto encode, swept", ProPhotoTransfer::encode, reference::prophoto_encode);
    swept("ProPhoto decode, swept", ProPhotoTransfer::decode, reference::prophoto_decode);
    swept("Adobe encode, swept", AdobeRgbTransfer::encode, reference::adobe_encode);
    swept("Adobe decode, swept", AdobeRgbTransfer::decode, reference::adobe_decode);
    swept("HLG encode, swept", Hlg::encode, reference::hlg_encode);
    swept("HLG decode, swept", Hlg::decode, reference::hlg_decode);
    swept("PQ encode, swept", Pq::encode, reference::pq_encode);
    swept("PQ decode, swept", Pq::decode, reference::pq_decode);
}

#[test]
fn pq_is_exact_in_relative_terms() {
    // The reference is the textbook's form, which loses to cancellation what f64 can spare.
    let (mut encode, mut decode) =
        (check("PQ encode, 1e-4 to 1e4 cd/m2"), check("PQ decode, 1e-4 to 1e4 cd/m2"));
    for k in 0..=100_000 {
        // 1e-4 to 1e4 cd/m2
        let light = 10f64.powf(f64::from(k) / 100_000.0 * 8.0 - 8.0) as f32;
        encode.add(&format!("{light}"), Pq::encode(light), reference::pq_encode(f64::from(light)));
        let code = reference::pq_encode(f64::from(light)) as f32;
        decode.add(&format!("{code}"), Pq::decode(code), reference::pq_decode(f64::from(code)));
    }
    encode.tight(100_001);
    decode.tight(100_001);
}

#[test]
fn ten_bit_pq_codes_survive() {
    for code in 0..=1023_u16 {
        let light = Pq::decode(f32::from(code) / 1023.0);
        assert_eq!((Pq::encode(light) * 1023.0).round(), f32::from(code));
    }
}

#[test]
fn there_and_back_again() {
    let mut all = [
        ("sRGB there and back", (|v| SrgbTransfer::decode(SrgbTransfer::encode(v))) as fn(f32) -> f32),
        ("sRGB back and there", |v| SrgbTransfer::encode(SrgbTransfer::decode(v))),
        ("Adobe there and back", |v| AdobeRgbTransfer::decode(AdobeRgbTransfer::encode(v))),
        ("BT.1886 there and back", |v| Bt1886::decode(Bt1886::encode(v))),
        ("BT.709 there and back", |v| Bt709::decode(Bt709::encode(v))),
        ("DCI there and back", |v| DciTransfer::decode(DciTransfer::encode(v))),
        ("ProPhoto there and back", |v| ProPhotoTransfer::decode(ProPhotoTransfer::encode(v))),
        ("HLG there and back", |v| Hlg::decode(Hlg::encode(v))),
        ("PQ there and back", |v| Pq::decode(Pq::encode(v))),
        ("PQ back and there", |v| Pq::encode(Pq::decode(v))),
    ]
    .map(|(what, function)| (function, check(what)));
    for v in sweep() {
        for (function, check) in &mut all {
            check.add(&format!("{v}"), function(v), f64::from(v));
        }
        assert_eq!(LinearTransfer::decode(LinearTransfer::encode(v)), v);
    }
    all.into_iter().for_each(|(_, check)| check.tight(SWEPT));
}

#[test]
fn knees_are_those_of_the_standards() {
    let above = |v: f32| f32::from_bits(v.to_bits() + 1);
    let mut encode = check("step of sRGB encode at its knee");
    encode.add("knee", SrgbTransfer::encode(above(0.003_130_8)) - SrgbTransfer::encode(0.003_130_8), 0.0);
    encode.tight(1);
    let mut decode = check("step of sRGB decode at its knee");
    decode.add("knee", SrgbTransfer::decode(above(0.040_45)) - SrgbTransfer::decode(0.040_45), 0.0);
    decode.tight(1);
    assert_eq!(Hlg::encode(above(1.0 / 12.0)), Hlg::encode(1.0 / 12.0));
    // BT.709 jumps by 2.479e-4 from 4.5 * 0.018, and no code of light is inside the jump.
    let below = |v: f32| f32::from_bits(v.to_bits() - 1);
    let (line, power) = (Bt709::encode(below(0.018)), Bt709::encode(0.018));
    assert!((line - 0.081).abs() < 3e-8 && (power - 0.081_247_94).abs() < 1e-8, "{line} {power}");
    for code in [0.081, 0.0811, 0.0812] {
        assert_eq!(Bt709::decode(code), 0.018, "{code}");
        assert_eq!(Bt709::decode(-code), -0.018, "{code}");
    }
    // BT.2020 with the constants for 12 bits, 1.0993 and 0.0181, is nowhere further from it than this.
    let twelve = |v: f64| if v < 0.0181 { 4.5 * v } else { 1.0993 * v.powf(0.45) - 0.0993 };
    let apart = |v: f32| (f64::from(Bt709::encode(v)) - twelve(f64::from(v))).abs();
    let furthest = sweep().chain([0.018, below(0.018), 0.0181]).map(apart).fold(0.0, f64::max);
    assert!((2.5e-4..=2.52e-4).contains(&furthest), "{furthest}");
    // The line and the power of ProPhoto meet at 1/512, code 1/32.
    assert_eq!(ProPhotoTransfer::encode(1.0 / 512.0), 1.0 / 32.0);
    assert_eq!(ProPhotoTransfer::encode(below(1.0 / 512.0)), below(1.0 / 32.0));
}

#[test]
fn ends_are_exact_or_as_the_standard_has_them() {
    assert_eq!(SrgbTransfer::encode(0.0), 0.0);
    assert_eq!(SrgbTransfer::decode(0.0), 0.0);
    assert_eq!(SrgbTransfer::encode(1.0), 1.0);
    assert_eq!(SrgbTransfer::decode(1.0), 1.0);
    assert_eq!(AdobeRgbTransfer::encode(1.0), 1.0);
    for white in [Bt1886::decode, Bt709::encode, Bt709::decode, DciTransfer::encode, DciTransfer::decode] {
        assert_eq!(white(1.0), 1.0);
    }
    assert_eq!(ProPhotoTransfer::encode(1.0), 1.0);
    assert_eq!(ProPhotoTransfer::decode(1.0), 1.0);
    assert_eq!(Pq::encode(1.0), 1.0);
    assert_eq!(Pq::decode(1.0), 1.0);
    assert_eq!(Pq::decode(0.0), 0.0);
    let mut dark = check("PQ of no light");
    dark.add("0", Pq::encode(0.0), 7.309_559e-7);
    dark.tight(1);
    assert_eq!(Pq::decode(Pq::encode(0.0)), 0.0);
    assert_eq!(Pq::encode(-1.0), Pq::encode(0.0));
    assert_eq!(Pq::decode(-1.0), 0.0);
    assert_eq!(Pq::decode(2.0), f32::INFINITY);
    assert!(Pq::decode(1.99).is_finite());
    // BT.2408: 203 cd/m2, the reference white of HDR, is 58 % PQ; HLG has it at 75 %
    let mut white = check("PQ and HLG of the reference white");
    white.add("PQ", Pq::encode(0.0203), 0.5807);
    white.add("HLG", Hlg::encode(0.265), 0.75);
    white.tight(2);
}

#[test]
fn eight_bit_codes_round_half_up() {
    for code in 0..=255_u8 {
        assert_eq!(to_u8(from_u8(code)), code);
        let half = (f64::from(code) + 0.5) / 255.0;
        let (below, above) = ((half - 1e-6) as f32, (half + 1e-6) as f32);
        assert_eq!(to_u8(below), code);
        assert_eq!(to_u8(above), code.saturating_add(1));
    }
    assert_eq!(to_u8(0.5), 128); // 127.5
    assert_eq!(to_u8(-0.001), 0);
    assert_eq!(to_u8(-1e30), 0);
    assert_eq!(to_u8(1.5), 255);
    assert_eq!(to_u8(f32::INFINITY), 255);
    assert_eq!(to_u8(f32::NEG_INFINITY), 0);
    assert_eq!(to_u8(f32::NAN), 0);
}

#[test]
fn every_srgb_code_survives_linear_light() {
    for code in 0..=255_u8 {
        assert_eq!(to_u8(SrgbTransfer::encode(SrgbTransfer::decode(from_u8(code)))), code);
        let adobe = EncodedRgb::<AdobeRgb>::from_u8([code, 255 - code, 7]);
        assert_eq!(adobe.decode().encode().to_u8(), [code, 255 - code, 7]);
    }
    let linear: Rgb<AdobeRgb> = EncodedRgb::<AdobeRgb>::from_u8([255, 128, 0]).decode();
    assert_eq!((linear.r, linear.b), (1.0, 0.0));
}

fn finite() -> impl Strategy<Value = f32> {
    use prop::num::f32::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    prop_oneof![NORMAL | SUBNORMAL | ZERO | POSITIVE | NEGATIVE, -2.0_f32..2.0]
}

/// Every curve that is odd, both ways.
const ODD: [fn(f32) -> f32; 14] = [
    SrgbTransfer::encode,
    SrgbTransfer::decode,
    Bt1886::encode,
    Bt1886::decode,
    Bt709::encode,
    Bt709::decode,
    DciTransfer::encode,
    DciTransfer::decode,
    AdobeRgbTransfer::encode,
    AdobeRgbTransfer::decode,
    ProPhotoTransfer::encode,
    ProPhotoTransfer::decode,
    Hlg::encode,
    Hlg::decode,
];

proptest! {
    #[test]
    fn no_finite_number_becomes_nan(v in finite()) {
        for function in ODD.into_iter().chain([Pq::encode, Pq::decode]) {
            prop_assert!(!function(v).is_nan());
            prop_assert!(function(f32::NAN).is_nan());
        }
    }

    #[test]
    fn all_but_pq_are_odd(v in finite()) {
        for function in ODD {
            prop_assert_eq!(function(-v).to_bits(), (-function(v)).to_bits());
        }
    }

    #[test]
    fn more_light_is_a_higher_code(v in 0.0_f32..1.0, w in 0.0_f32..1.0) {
        let (low, high) = (v.min(w), v.max(w));
        // two numbers apart by more than rounding
        prop_assume!(high - low > 1e-6);
        for function in ODD.into_iter().chain([Pq::encode as fn(f32) -> f32]) {
            prop_assert!(function(low) <= function(high));
        }
    }
}
