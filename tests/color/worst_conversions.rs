//! That the documented bounds of color temperature, of color spaces, of adaptation, of transfer functions and
//! of spectral similarity hold at the worst that a search finds.
#![cfg(feature = "libm")]

use model::cct::planckian;
use model::chromaticity::xy_from_uv1960;
use model::linear::apply;
use model::planck::C2_CIE;
use model::search::{Range::*, worst};
use model::{adaptation, hdr, lab, rgb, transfer as reference};
use nanospectra::color::transfer::{
    AdobeRgbTransfer, Bt709, Bt1886, DciTransfer, Hlg, Pq, ProPhotoTransfer, SrgbTransfer, Transfer,
};
use nanospectra::color::{
    AcesCg, Adaptation, Bradford, Bt2020, Cat02, Cat16, Cct, ConeResponses, DisplayP3, Ictcp, IctcpTransfer,
    ProPhoto, Rgb, RgbSpace, Srgb, Uv1960, VonKries, Xyz, ssi,
};
use nanospectra::{Fine, Power};

const STEPS: usize = 2000;

fn apart(got: [f32; 3], exact: [f64; 3]) -> f64 {
    let most = |most: f64, off: f64| if off > most || off.is_nan() { off } else { most };
    got.into_iter().zip(exact).map(|(got, exact)| (f64::from(got) - exact).abs()).fold(0.0, most)
}

/// The place at a distance from the locus, in f64.
fn beside([mired, duv]: [f32; 2]) -> [f64; 2] {
    let ([u, v], [du, dv]) = planckian(1e6 / f64::from(mired), C2_CIE);
    let share = f64::from(duv) / du.hypot(dv);
    [u + share * dv, v - share * du]
}

#[test]
fn temperatures_are_as_exact_as_promised() {
    let off = |at: [f32; 2]| {
        let [u, v] = beside(at).map(|x| x as f32);
        match (Uv1960 { u, v }).cct() {
            Cct::Near { cct_k, duv } => {
                [(1e6 / f64::from(cct_k) - f64::from(at[0])).abs(), f64::from((duv - at[1]).abs())]
            }
            _ => [-1.0; 2],
        }
    };
    let ranges = [Sizes(1.0, 1000.0), Even(-0.05, 0.05)];
    worst(1, 400, ranges, |at| off(at)[0]).is_what_is_promised("CCT of the whole band, mired", 0.009);
    worst(2, 400, ranges, |at| off(at)[1]).is_what_is_promised("Duv of the whole band", 2e-7);
}

/// The worst component in a space of a color of BT.2020.
fn in_space<S: RgbSpace>(name: &str) -> f64 {
    let from_xyz = rgb::named(name).xyz_to_rgb();
    let found = worst(1, STEPS, [Even(0.0, 1.0); 3], |[r, g, b]| {
        let color = Rgb::<Bt2020>::new(r, g, b).xyz();
        let exact = apply(from_xyz, color.to_array().map(|x| f64::from(x) / 100.0));
        apart(Rgb::<S>::from_xyz(color).to_array(), exact)
    });
    println!("{name}: {:.2e} at {:?}", found.error, found.at);
    found.error
}

#[test]
fn linear_colors_are_as_exact_as_promised() {
    let most = [
        in_space::<Srgb>("sRGB"),
        in_space::<DisplayP3>("Display P3"),
        in_space::<AcesCg>("ACEScg"),
        in_space::<ProPhoto>("ProPhoto RGB"),
    ];
    let most = most.into_iter().fold(0.0, f64::max);
    assert!((3e-7..=6e-7).contains(&most), "{most:.2e}");
    let color = |[r, g, b]: [f32; 3]| Rgb::<Bt2020>::new(r, g, b).xyz();
    worst(2, STEPS, [Even(0.0, 1.0); 3], |rgb| {
        let (found, xyz) = (color(rgb).oklab(), color(rgb).to_array().map(f64::from));
        apart([found.l, found.a, found.b], lab::oklab(xyz.map(|x| x / 100.0)))
    })
    .is_what_is_promised("Oklab", 1.1e-6);
    worst(3, STEPS, [Even(0.0, 1.0); 3], |rgb| {
        apart(color(rgb).oklab().xyz().to_array(), color(rgb).to_array().map(f64::from))
    })
    .is_what_is_promised("XYZ by way of Oklab", 2e-4);
}

/// The worst element of a matrix from a white of 2000 K to 50 000 K to D65.
fn adapted<C: ConeResponses>(name: &str) -> f64 {
    let d65 = [95.047f32, 100.0, 108.883];
    let found = worst(1, 500, [Sizes(20.0, 500.0), Even(-0.02, 0.02)], |at| {
        let [x, y] = xy_from_uv1960(beside(at));
        let from = [100.0 * x / y, 100.0, 100.0 * (1.0 - x - y) / y].map(|x| x as f32);
        // What is redder has larger elements.
        if from[2] < 11.0 {
            return -1.0;
        }
        let exact = adaptation::matrix(name, from.map(f64::from), d65.map(f64::from));
        let Some(found) = Adaptation::between::<C>(Xyz::from(from), Xyz::from(d65)) else { return f64::NAN };
        found.matrix().iter().zip(exact).map(|(row, exact)| apart(*row, exact)).fold(0.0, f64::max)
    });
    println!("{name}: {:.2e} at {:?}", found.error, found.at);
    found.error
}

#[test]
fn adaptations_are_as_exact_as_promised() {
    let most = [
        adapted::<Bradford>("Bradford"),
        adapted::<Cat02>("CAT02"),
        adapted::<Cat16>("CAT16"),
        adapted::<VonKries>("Von Kries"),
    ];
    let most = most.into_iter().fold(0.0, f64::max);
    assert!((2e-6..=4e-6).contains(&most), "{most:.2e}");
}

fn curve(what: &str, bound: f64, function: fn(f32) -> f32, exact: impl Fn(f64) -> f64) {
    let off = |[x]: [f32; 1]| (f64::from(function(x)) - exact(x.into())).abs();
    let (even, small) = (worst(1, STEPS, [Even(0.0, 1.0)], off), worst(2, STEPS, [Sizes(1e-30, 1.0)], off));
    (if even.error > small.error { even } else { small }).is_what_is_promised(what, bound);
}

#[test]
fn transfer_functions_are_as_exact_as_promised() {
    curve("sRGB encode", 9e-8, SrgbTransfer::encode, reference::srgb_encode);
    curve("sRGB decode", 1.2e-7, SrgbTransfer::decode, reference::srgb_decode);
    curve("sRGB there and back", 1.2e-7, |x| SrgbTransfer::decode(SrgbTransfer::encode(x)), |x| x);
    curve("sRGB back and there", 1.2e-7, |x| SrgbTransfer::encode(SrgbTransfer::decode(x)), |x| x);
    curve("BT.1886 encode", 6e-8, Bt1886::encode, |v| v.powf(1.0 / 2.4));
    curve("BT.1886 decode", 6e-8, Bt1886::decode, reference::bt1886_decode);
    curve("BT.709 encode", 9.5e-8, Bt709::encode, |v| {
        // The knee in f32 is a little below 0.018.
        reference::bt709_encode(if v == f64::from(0.018_f32) { 0.018 } else { v })
    });
    curve("BT.709 decode", 1.2e-7, Bt709::decode, |v| match v {
        // Codes within the jump of the standard's curve are 0.018.
        0.081..0.081_247_944_035_140_54 => 0.018,
        _ => reference::bt709_decode(v),
    });
    curve("Adobe encode", 7e-8, AdobeRgbTransfer::encode, reference::adobe_encode);
    curve("Adobe decode", 7e-8, AdobeRgbTransfer::decode, reference::adobe_decode);
    curve("DCI encode", 7e-8, DciTransfer::encode, |v| v.powf(1.0 / 2.6));
    curve("DCI decode", 7e-8, DciTransfer::decode, reference::dci_decode);
    curve("ProPhoto encode", 7e-8, ProPhotoTransfer::encode, reference::prophoto_encode);
    curve("ProPhoto decode", 7e-8, ProPhotoTransfer::decode, reference::prophoto_decode);
    curve("HLG encode", 1e-7, Hlg::encode, reference::hlg_encode);
    curve("HLG decode", 3e-7, Hlg::decode, reference::hlg_decode);
    curve("PQ encode", 1.5e-7, Pq::encode, reference::pq_encode);
    curve("PQ decode", 8e-7, Pq::decode, reference::pq_decode);
    let relative = |found: f32, exact: f64| (f64::from(found) / exact - 1.0).abs();
    worst(1, STEPS, [Sizes(1e-8, 1.0)], |[x]| relative(Pq::encode(x), reference::pq_encode(x.into())))
        .is_what_is_promised("PQ encode from 1e-4 cd/m2, relative", 1.8e-6);
    worst(2, STEPS, [Sizes(1e-8, 1.0)], |[x]| {
        let code = reference::pq_encode(x.into()) as f32;
        relative(Pq::decode(code), reference::pq_decode(code.into()))
    })
    .is_what_is_promised("PQ decode from 1e-4 cd/m2, relative", 2.4e-6);
}

fn ictcp<T: IctcpTransfer>(what: &str, exact: fn([f64; 3]) -> [f64; 3], there: f64, back: f64) {
    let color = |[r, g, b]: [f32; 3]| Ictcp::<T>::from_rgb(Rgb::new(r, g, b));
    let size = Sizes(1e-6, 1.0);
    worst(1, STEPS, [size; 3], |rgb| {
        apart([color(rgb).i, color(rgb).ct, color(rgb).cp], exact(rgb.map(f64::from)))
    })
    .is_what_is_promised(what, there);
    worst(2, STEPS, [Even(0.0, 1.0); 3], |rgb| {
        color(rgb).rgb().map_or(f64::NAN, |back| apart(back.to_array(), rgb.map(f64::from)))
    })
    .is_what_is_promised(&format!("RGB by way of {what}"), back);
}

#[test]
fn colors_of_high_range_are_as_exact_as_promised() {
    ictcp::<Pq>("ICtCp of PQ", hdr::ictcp_pq, 1.2e-6, 1.2e-5);
    ictcp::<Hlg>("ICtCp of HLG", hdr::ictcp_hlg, 6e-7, 6e-6);
    // Up to 10 000 cd/m2.
    let color = |[r, g, b]: [f32; 3]| Rgb::<Bt2020>::new(100.0 * r, 100.0 * g, 100.0 * b).xyz();
    let exact = |color: Xyz| hdr::jzazbz(color.to_array().map(f64::from));
    let ranges = [Even(0.0, 1.0); 3];
    worst(1, STEPS, ranges, |rgb| {
        let ([jz, ..], found) = (exact(color(rgb)), color(rgb).jzazbz());
        (f64::from(found.jz) - jz).abs()
    })
    .is_what_is_promised("Jz", 3.5e-7);
    worst(2, STEPS, [Sizes(1e-6, 1.0); 3], |rgb| {
        let ([_, az, bz], found) = (exact(color(rgb)), color(rgb).jzazbz());
        apart([found.az, found.bz, 0.0], [az, bz, 0.0])
    })
    .is_what_is_promised("az and bz", 1.2e-6);
    worst(3, STEPS, ranges, |rgb| {
        let back = color(rgb).jzazbz().xyz();
        back.map_or(f64::NAN, |back| apart(back.to_array(), color(rgb).to_array().map(f64::from)) / 1e4)
    })
    .is_what_is_promised("XYZ by way of Jzazbz, of white", 4e-6);
}

/// The shares of the thirty intervals of 10 nm from 375 nm on.
fn shares(light: &Fine<Power>) -> Vec<f64> {
    let power = |nm: usize| f64::from(light.values()[nm - 360]);
    let interval =
        |from: usize| 0.5 * (power(from) + power(from + 10)) + (from + 1..from + 10).map(power).sum::<f64>();
    let all: Vec<f64> = (0..30).map(|k| interval(375 + 10 * k)).collect();
    let total: f64 = all.iter().sum();
    all.into_iter().map(|share| share / total).collect()
}

#[test]
fn similarities_are_as_exact_as_promised() {
    let lamp = |[nm, width, flat]: [f32; 3]| {
        Fine::<Power>::at_centers(|at| (-((at - nm) / width).powi(2)).exp() + flat)
    };
    let weight = |k: usize| match k {
        0..5 => [12.0, 22.0, 32.0, 40.0, 44.0][k] / 45.0,
        28 => 11.0 / 15.0,
        29 => 3.0 / 15.0,
        _ => 1.0,
    };
    let [nm, width, flat] = [Even(380.0, 670.0), Sizes(3.0, 300.0), Sizes(1e-6, 1.0)];
    worst(1, 300, [nm, width, flat, nm, width, flat], |[a, b, c, d, e, f]| {
        let (light, reference) = (lamp([a, b, c]), lamp([d, e, f]));
        let mut differences = vec![0.0; 32];
        for (k, (x, y)) in shares(&light).into_iter().zip(shares(&reference)).enumerate() {
            differences[k + 1] = weight(k) * (x - y) / (y + 1.0 / 30.0);
        }
        let smooth = differences.windows(3).map(|d| (0.22 * d[0] + 0.56 * d[1] + 0.22 * d[2]).powi(2));
        let lacks = 32.0 * smooth.sum::<f64>().sqrt();
        ssi(&light, &reference)
            .map_or(f64::NAN, |found| (f64::from(found) - (100.0 - lacks)).abs() / (5e-5 + 3e-6 * lacks))
    })
    .is_what_is_promised("spectral similarity, in 5e-5 and 3e-6 of what lacks", 1.0);
}
