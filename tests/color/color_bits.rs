//! Every public function of `color`, on numbers of any bits: none panics, and finite numbers give what is
//! documented.
#![cfg(feature = "libm")]

use nanospectra::color::transfer::{self, *};
use nanospectra::color::*;
use nanospectra::math::{Fast, Portable};
use nanospectra::observer::CIE_1931;
use nanospectra::{Fine, Power};
use proptest::prelude::*;

/// Numbers of any bits, and often of a size that is in use, or an edge.
fn bits() -> impl Strategy<Value = f32> {
    let edges =
        vec![0.0, -0.0, 1.0, -1.0, f32::MAX, f32::MIN, f32::MIN_POSITIVE, 1e-45, f32::INFINITY, f32::NAN];
    prop_oneof![4 => any::<u32>().prop_map(f32::from_bits), 4 => -2.0f32..2.0, 1 => prop::sample::select(edges)]
}

fn three() -> impl Strategy<Value = [f32; 3]> {
    prop::array::uniform3(bits())
}

fn is_finite(numbers: &[f32]) -> bool {
    numbers.iter().all(|number| number.is_finite())
}

fn has_nan(numbers: &[f32]) -> bool {
    numbers.iter().any(|number| number.is_nan())
}

/// How often each test draws: 2,000 times, or as NANOSPECTRA_RUNS says.
fn runs() -> ProptestConfig {
    let runs = std::env::var("NANOSPECTRA_RUNS").ok().and_then(|runs| runs.parse().ok());
    ProptestConfig { cases: runs.unwrap_or(2_000), ..ProptestConfig::default() }
}

fn rgb_of<S: RgbSpace>(color: [f32; 3]) -> Result<(), TestCaseError> {
    let [r, g, b] = color;
    let rgb = Rgb::<S>::new(r, g, b);
    let from = Rgb::<S>::from_xyz(Xyz::new(r, g, b));
    let _ = (rgb.xyz(), rgb.luminance(), from.xyz(), rgb.encode().decode(), rgb.encode().to_u8());
    let code = EncodedRgb::<S>::new(r, g, b);
    let _ = (code.decode(), code.decode_with::<Fast>(), rgb.encode_with::<Pq, Portable>());
    // No finite number becomes NaN, and NaN is never hidden.
    for of in [rgb.encode().to_array(), code.decode().to_array()] {
        for (before, after) in color.into_iter().zip(of) {
            prop_assert!(before.is_nan() == after.is_nan() || before.is_infinite(), "{before} {after}");
        }
    }
    let inside = color.iter().all(|part| (0.0..=1.0).contains(part));
    prop_assert_eq!(rgb.in_gamut(), inside);
    let (clipped, dimmed, gray) = (rgb.clip(), rgb.dim(), rgb.desaturate());
    for mapped in [clipped, dimmed, gray] {
        prop_assert_eq!(mapped.was_inside, inside);
        prop_assert!(!inside || mapped.rgb.to_array() == color, "{:?} of {:?}", mapped, color);
    }
    if is_finite(&color) {
        prop_assert!(
            clipped.rgb.in_gamut() && gray.rgb.in_gamut(),
            "{:?} {:?} of {:?}",
            clipped,
            gray,
            color
        );
        prop_assert!(dimmed.rgb.to_array().iter().all(|part| *part <= 1.0), "{:?} of {:?}", dimmed, color);
    }
    prop_assert_eq!(has_nan(&rgb.clip().rgb.to_array()), has_nan(&color));
    Ok(())
}

fn transfer_of<T: Transfer>(value: f32) -> Result<(), TestCaseError> {
    let (code, light) = (T::encode(value), T::decode(value));
    prop_assert!(value.is_nan() == code.is_nan() || value.is_infinite(), "{} {}", value, code);
    prop_assert!(value.is_nan() == light.is_nan() || value.is_infinite(), "{} {}", value, light);
    Ok(())
}

fn adapted<C: ConeResponses>(from: Xyz, to: Xyz, color: Xyz, degree: f32) {
    for found in [Adaptation::between::<C>(from, to), Adaptation::partial::<C>(from, to, degree)] {
        let _ = found.map(|found| (found.apply(color), *found.matrix()));
    }
}

proptest! {
    #![proptest_config(runs())]

    #[test]
    fn rgb_and_codes_of_any_bits(color in three(), value in bits(), code in any::<u8>()) {
        rgb_of::<Srgb>(color)?;
        rgb_of::<DisplayP3>(color)?;
        rgb_of::<Bt2020>(color)?;
        rgb_of::<AdobeRgb>(color)?;
        rgb_of::<AcesCg>(color)?;
        transfer_of::<SrgbTransfer>(value)?;
        transfer_of::<Bt1886>(value)?;
        transfer_of::<AdobeRgbTransfer>(value)?;
        transfer_of::<LinearTransfer>(value)?;
        transfer_of::<Pq>(value)?;
        transfer_of::<Hlg>(value)?;
        prop_assert_eq!(transfer::to_u8(transfer::from_u8(code)), code);
        prop_assert!(!value.is_nan() || transfer::to_u8(value) == 0);
        let coded = EncodedRgb::<Srgb>::from_u8([code; 3]);
        prop_assert_eq!(coded.to_u8(), [code; 3]);
    }

    #[test]
    fn colors_and_whites_of_any_bits(color in three(), white in three(), degree in bits()) {
        let ([x, y, z], [wx, wy, wz]) = (color, white);
        let (xyz, of) = (Xyz::new(x, y, z), Xyz::new(wx, wy, wz));
        let finite = is_finite(&color) && is_finite(&white);
        for lab in [xyz.lab(of), xyz.lab_with::<Portable>(of), Some(Lab::new(x, y, z))].into_iter().flatten() {
            prop_assert!(!finite || !has_nan(&[lab.l, lab.a, lab.b]), "{:?} {:?}", lab, of);
            let lch = lab.lch();
            let _ = (lab.xyz(of), lab.chroma(), lab.lch_with::<Portable>(), lch.lab());
        }
        for luv in [xyz.luv(of), Some(Luv::new(x, y, z))].into_iter().flatten() {
            // Beyond 1e37 the sum X + 15 Y + 3 Z overflows in its parts, and 13 L* may overflow too.
            let small = color.iter().chain(&white).all(|part| part.abs() <= 1e37) && luv.l.abs() <= f32::MAX / 13.0;
            prop_assert!(!small || !has_nan(&[luv.l, luv.u, luv.v]), "{:?} {:?}", luv, of);
            let _ = luv.xyz(of);
        }
        let oklab = xyz.oklab();
        let _ = (oklab.xyz(), Oklab::new(x, y, z).xyz(), xyz.scaled(degree), xyz.with_y(degree));
        adapted::<Bradford>(of, xyz, of, degree);
        adapted::<Cat02>(of, xyz, of, degree);
        adapted::<Cat16>(of, xyz, of, degree);
        adapted::<VonKries>(of, xyz, of, degree);
        if let Some(xy) = xyz.xy() {
            prop_assert!(!is_finite(&color) || !has_nan(&[xy.x, xy.y]), "{:?} {:?}", xy, xyz);
            let _ = (xy.xyz(degree), xy.uv1976(), dominant_wavelength(xy, Xy { x: wx, y: wy }, &CIE_1931));
        }
        if let Some(uv) = xyz.uv1960() {
            let _ = (uv.cct(), xyz.cct(), xyz.uv1976());
        }
        // A color that is near the locus has a temperature of the table, and is not far from it.
        if let Cct::Near { cct_k, duv } = (Uv1960 { u: x, v: y }).cct() {
            prop_assert!(has_nan(&[x, y]) || (999.9..1.001e6).contains(&cct_k), "{} {}", cct_k, duv);
            prop_assert!(has_nan(&[x, y]) || duv.abs() <= 0.0501, "{} {}", cct_k, duv);
        }
        let seen = dominant_wavelength(Xy { x, y }, Xy { x: wx, y: wy }, &CIE_1931);
        let _ = seen.map(|seen| (seen.nm, seen.purity));
    }

    #[test]
    fn differences_of_any_bits(one in three(), other in three(), white in three(), k in three()) {
        let [a, b] = [one, other].map(|[l, a, b]| Lab::new(l, a, b));
        let of = |[x, y, z]: [f32; 3]| Xyz::new(x, y, z);
        let factors = ParametricFactors { k_l: k[0], k_c: k[1], k_h: k[2] };
        let all = [
            cie76(a, b), hyab(a, b), cie94(a, b, Cie94Weights::GraphicArts), cie94(a, b, Cie94Weights::Textiles),
            cmc(a, b, 2.0, 1.0), ciede2000(a, b),
        ];
        let _ = (cmc(a, b, k[0], k[1]), ciede2000_with::<Portable>(a, b, factors), of(one).delta_e(of(other), of(white)));
        // NaN is never hidden, and no difference is negative.
        for difference in all {
            prop_assert!(difference.is_nan() || difference >= 0.0, "{:?}", all);
            prop_assert!(difference.is_nan() || !has_nan(&one) && !has_nan(&other), "{:?}", all);
        }
    }

    #[test]
    fn rendering_of_lights_of_any_bits(
        knots in prop::array::uniform16(bits()), start in 0usize..460, size in -120i32..120, tame in any::<bool>(),
    ) {
        // A piece of the light has any bits, or all of it is smooth and of any size.
        let mut values = [1.0f32; 471];
        for (k, value) in values.iter_mut().enumerate() {
            let knot = knots[k / 30];
            *value = if tame { 2f32.powi(size) * (0.01 + knot.abs().min(2.0)) } else { 1.0 };
        }
        if !tame {
            for (value, knot) in values[start..].iter_mut().zip(knots) {
                *value = knot;
            }
        }
        let light = Fine::<Power>::from_bins(values);
        let (ra, rf) = (cri(&light), tm30(&light));
        // A light with a NaN in what is summed has no rendering, and no light has one above 100.
        prop_assert!(!has_nan(&values) || ra.is_err(), "{:?}", ra);
        prop_assert!(!has_nan(&values[20..=420]) || rf.is_err(), "{:?}", rf);
        if let Ok(ra) = ra {
            prop_assert!(ra.r.iter().all(|r| *r <= 100.001 || r.is_nan()), "{:?}", ra);
        }
        if let Ok(rf) = rf {
            prop_assert!(rf.rf.is_nan() || (0.0..=100.001).contains(&rf.rf), "{}", rf.rf);
        }
    }
}
