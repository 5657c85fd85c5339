//! Compares nanospectra with the crate `colorimetry` 0.1.0, which needs std and computes in f64 over 380 to
//! 780 nm. Both get the spectra of `colorimetry`. Where its results deviate, the reason is named and the
//! deviation is bounded.

use colorimetry::illuminant::CieIlluminant as Theirs;
use colorimetry::observer::Observer as TheirEye;
use model::allowed::check;
use model::chromaticity::uv1960;
use model::planck::{C2_CODATA, relative};
use model::tables::Observer;
use nanospectra::color::{Xyz, cri, tm30};
use nanospectra::light;
use nanospectra::observer::{CIE_1931, CIE_1964, CIE_2015_2, CIE_2015_10};
use nanospectra::{Fine, Nodes, Power, Spectrum};

macro_rules! names {
    ($($name:ident)*) => { [$((stringify!($name), Theirs::$name)),*] };
}

const LIGHTS: [(&str, Theirs); 40] = names! {
    D65 D50 E A F1 F2 F3 F4 F5 F6 F7 F8 F9 F10 F11 F12
    F3_1 F3_2 F3_3 F3_4 F3_5 F3_6 F3_7 F3_8 F3_9 F3_10 F3_11 F3_12 F3_13 F3_14 F3_15
    LED_B1 LED_B2 LED_B3 LED_B4 LED_B5 LED_BH1 LED_RGB1 LED_V1 LED_V2
};

/// One of its illuminants, 401 numbers, as a spectrum of this crate.
fn ours(theirs: Theirs) -> Fine<Power> {
    let spectrum: &colorimetry::spectrum::Spectrum = theirs.illuminant().as_ref();
    let values = spectrum.as_array().map(|value| value as f32);
    let nodes = Spectrum::<Power, 401, Nodes<380, 780>>::from_bins(values);
    nodes.fine()
}

#[test]
fn xyz_and_xy_are_the_same_for_every_observer() {
    let (mut xyz, mut xy) = (check("XYZ beside colorimetry"), check("xy beside colorimetry"));
    let eyes = [
        (TheirEye::Cie1931, &CIE_1931),
        (TheirEye::Cie1964, &CIE_1964),
        (TheirEye::Cie2015, &CIE_2015_2),
        (TheirEye::Cie2015_10, &CIE_2015_10),
    ];
    for (name, light) in LIGHTS {
        for (theirs, eye) in &eyes {
            let expected = theirs.xyz_cie_table(&light, Some(100.0));
            let found = Xyz::from(eye.sees(&ours(light))).with_y(100.0).expect("a visible light");
            for (got, expected) in found.to_array().into_iter().zip(expected.to_array()) {
                xyz.value(&format!("{name} {theirs:?}"), got.into(), expected);
            }
            let (found, expected) = (found.xy().expect("visible"), expected.chromaticity());
            xy.value(&format!("{name} {theirs:?} x"), found.x.into(), expected.x());
            xy.value(&format!("{name} {theirs:?} y"), found.y.into(), expected.y());
        }
    }
    xyz.tight(3 * 4 * LIGHTS.len());
    xy.tight(2 * 4 * LIGHTS.len());
}

/// A point of the Planckian locus and its derivative by mired, as `colorimetry` computes them: by sums over
/// 380 to 780 nm, and with the c2 of CODATA.
fn their_locus(mired: f64) -> ([f64; 2], [f64; 2]) {
    let cmf = Observer::Cie1931.on_cie_grid();
    let at = |mired: f64| {
        let planck = |nm: usize| relative(nm as f64, 1e6 / mired, C2_CODATA);
        uv1960([0, 1, 2].map(|c| (380..=780).map(|nm| cmf[c][nm - 360] * planck(nm)).sum()))
    };
    let (low, high) = (at(mired - 0.01), at(mired + 0.01));
    (at(mired), [0, 1].map(|c| (high[c] - low[c]) / 0.02))
}

#[test]
fn cct_and_duv_are_the_same_but_for_its_locus() {
    let (mut cct, mut duv) = (check("CCT beside colorimetry, mired"), check("Duv beside colorimetry"));
    let mut explained = check("CCT beside colorimetry, on its own locus, mired");
    let mut explained_duv = check("Duv beside colorimetry, on its own locus");
    for (name, light) in LIGHTS {
        let expected = light.illuminant().cct().expect("a white light");
        let uv = Xyz::from(CIE_1931.sees(&ours(light))).uv1960().expect("a visible light");
        let (kelvin, distance) = uv.cct().near().expect("a white light");
        let mired = 1e6 / expected.t();
        cct.value(name, 1e6 / f64::from(kelvin), mired);
        duv.value(name, distance.into(), expected.d());
        // Its locus differs from ours. On its own locus its temperature belongs to the nearest point, as it
        // should.
        let ([u, v], [du, dv]) = their_locus(mired);
        let along = (f64::from(uv.u) - u) * du + (f64::from(uv.v) - v) * dv;
        explained.value(name, along / (du * du + dv * dv), 0.0);
        let across = ((f64::from(uv.v) - v) * du - (f64::from(uv.u) - u) * dv) / du.hypot(dv);
        explained_duv.value(name, across, expected.d());
    }
    cct.tight(LIGHTS.len());
    duv.tight(LIGHTS.len());
    explained.tight(LIGHTS.len());
    explained_duv.tight(LIGHTS.len());
}

#[test]
fn color_rendering_indices_are_the_same_but_for_its_straight_samples() {
    let (mut ra, mut r) = (check("Ra beside colorimetry"), check("R1 to R14 beside colorimetry"));
    for (name, light) in LIGHTS {
        let expected = light.illuminant().cri().expect("a white light");
        let found = cri(&ours(light)).expect("a white light");
        if name == "F3_10" {
            // This lamp has 4999.5 K, and 5000.1 K on its locus. At 5000 K the reference changes from a black
            // body to daylight.
            assert!(found.cct_k < 5000.0 && light.illuminant().cct().expect("white").t() > 5000.0);
            assert!((f64::from(found.ra) - expected.ra()).abs() < 0.25, "{found:?}");
            continue;
        }
        // It interpolates the 5 nm values of the test colors linearly, while CIE 13.3 demands Sprague's
        // method.
        ra.value(name, found.ra.into(), expected.ra());
        for (k, (got, expected)) in found.r.iter().zip(expected.to_array()).enumerate() {
            r.value(&format!("{name} R{}", k + 1), (*got).into(), expected);
        }
    }
    ra.tight(LIGHTS.len() - 1);
    r.tight(14 * (LIGHTS.len() - 1));
}

#[test]
fn fidelity_and_gamut_are_the_same_but_for_its_blend_between_4000_and_5000_k() {
    let (mut rf, mut rg) = (check("Rf beside colorimetry"), check("Rg beside colorimetry"));
    let (mut blended_rf, mut blended_rg) =
        (check("Rf beside colorimetry, 4000 to 5000 K"), check("Rg beside colorimetry, 4000 to 5000 K"));
    let mut blended = 0;
    for (name, light) in LIGHTS {
        let theirs = light.illuminant().cfi().expect("a white light");
        let found = tm30(&ours(light)).expect("a white light");
        let (expected_rf, expected_rg) = (theirs.color_fidelity_index(), theirs.color_gamut_index());
        // In this range it mixes a black body of 4000 K with daylight of 5000 K, while TM-30 mixes both at
        // the temperature of the lamp.
        if (4000.0..5000.0).contains(&found.cct_k) {
            blended += 1;
            blended_rf.value(name, found.rf.into(), expected_rf);
            blended_rg.value(name, found.rg.into(), expected_rg);
        } else {
            rf.value(name, found.rf.into(), expected_rf);
            rg.value(name, found.rg.into(), expected_rg);
        }
    }
    rf.tight(LIGHTS.len() - blended);
    rg.tight(LIGHTS.len() - blended);
    blended_rf.tight(blended);
    blended_rg.tight(blended);
    assert!(blended >= 5, "{blended} lights between 4000 and 5000 K");
}

#[test]
fn its_lamps_are_the_1nm_tables_bit_for_bit() {
    let pairs: [(Theirs, &Spectrum<Power, 401, Nodes<380, 780>>); 8] = [
        (Theirs::F1, &light::FL1_1NM),
        (Theirs::F2, &light::FL2_1NM),
        (Theirs::F11, &light::FL11_1NM),
        (Theirs::F3_1, &light::FL3_1_1NM),
        (Theirs::F3_15, &light::FL3_15_1NM),
        (Theirs::LED_B3, &light::LED_B3_1NM),
        (Theirs::LED_RGB1, &light::LED_RGB1_1NM),
        (Theirs::LED_V2, &light::LED_V2_1NM),
    ];
    for (theirs, table) in pairs {
        assert_eq!(&ours(theirs).values()[20..=420], table.values(), "{theirs:?}");
    }
    for (theirs, table) in [(Theirs::D65, &light::D65), (Theirs::D50, &light::D50), (Theirs::A, &light::A)] {
        assert_eq!(&ours(theirs).values()[20..=420], &table.values()[80..=480], "{theirs:?}");
    }
}
