//! No finite color gives NaN, and NaN in any number of a color is seen in the result: the functions of colors
//! are called with numbers of every size that f32 has, and with those at the ends.
#![cfg(feature = "libm")]

use model::noise::Noise;
use nanospectra::color::transfer::{AdobeRgbTransfer, Bt1886, SrgbTransfer, Transfer};
use nanospectra::color::{
    Adaptation, Bradford, Cat16, Cie94Weights, Lab, Lch, Luv, Oklab, ParametricFactors, Rgb, Srgb, Uv1960,
    Xy, Xyz, cie76, cie94, ciede2000, ciede2000_with, cmc, dominant_wavelength, hyab,
};
use nanospectra::math::Fast;
use nanospectra::observer::CIE_1931;

const CASES: usize = if cfg!(debug_assertions) { 3_000 } else { 60_000 };

/// What a function makes of six numbers, and how many of them it takes. It may refuse.
type Family = (&'static str, usize, fn([f32; 6]) -> Option<Vec<f32>>);

fn lab([l, a, b]: [f32; 3]) -> Lab {
    Lab::new(l, a, b)
}

fn xyz([x, y, z]: [f32; 3]) -> Xyz {
    Xyz::new(x, y, z)
}

fn halves([a, b, c, d, e, f]: [f32; 6]) -> [[f32; 3]; 2] {
    [[a, b, c], [d, e, f]]
}

/// A difference of two colors.
fn apart(of: fn(Lab, Lab) -> f32, numbers: [f32; 6]) -> Option<Vec<f32>> {
    let [one, two] = halves(numbers).map(lab);
    Some(vec![of(one, two)])
}

/// Functions that take every finite number.
const FAMILIES: [Family; 22] = [
    ("ciede2000", 6, |n| apart(ciede2000, n)),
    ("ciede2000 by Fast", 6, |n| {
        apart(|x, y| ciede2000_with::<Fast>(x, y, ParametricFactors { k_l: 2.0, k_c: 0.5, k_h: 3.0 }), n)
    }),
    ("cie76", 6, |n| apart(cie76, n)),
    ("hyab", 6, |n| apart(hyab, n)),
    ("cie94 of prints", 6, |n| apart(|x, y| cie94(x, y, Cie94Weights::GraphicArts), n)),
    ("cie94 of cloth", 6, |n| apart(|x, y| cie94(x, y, Cie94Weights::Textiles), n)),
    ("CMC", 6, |n| apart(|x, y| cmc(x, y, 2.0, 1.0), n)),
    ("Lab", 6, |n| {
        let [color, white] = halves(n).map(xyz);
        color.lab(white).map(|lab| vec![lab.l, lab.a, lab.b])
    }),
    ("Lab by Fast", 6, |n| {
        let [color, white] = halves(n).map(xyz);
        color.lab_with::<Fast>(white).map(|lab| vec![lab.l, lab.a, lab.b])
    }),
    ("Luv", 6, |n| {
        let [color, white] = halves(n).map(xyz);
        color.luv(white).map(|luv| vec![luv.l, luv.u, luv.v])
    }),
    ("chroma and hue", 2, |[a, b, ..]| {
        let lch = Lab::new(50.0, a, b).lch();
        Some(vec![lch.c, lch.h_deg, Lab::new(50.0, a, b).chroma()])
    }),
    ("hue to Lab", 2, |[c, h_deg, ..]| {
        let lab = Lch { l: 50.0, c, h_deg }.lab();
        Some(vec![lab.a, lab.b])
    }),
    ("xy", 3, |n| xyz(halves(n)[0]).xy().map(|xy| vec![xy.x, xy.y])),
    ("uv 1960", 3, |n| xyz(halves(n)[0]).uv1960().map(|uv| vec![uv.u, uv.v])),
    ("u'v'", 3, |n| xyz(halves(n)[0]).uv1976().map(|uv| vec![uv.u, uv.v])),
    ("color temperature", 3, |n| {
        let (cct_k, duv) = xyz(halves(n)[0]).cct()?.near()?;
        Some(vec![cct_k, duv])
    }),
    ("color temperature of uv", 2, |[u, v, ..]| {
        let (cct_k, duv) = Uv1960 { u, v }.cct().near()?;
        Some(vec![cct_k, duv])
    }),
    ("dominant wavelength", 2, |[x, y, ..]| {
        let found = dominant_wavelength(Xy::new(x, y), Xy::new(0.3127, 0.329), &CIE_1931)?;
        Some(vec![found.nm, found.purity])
    }),
    ("sRGB code", 1, |[v, ..]| {
        Some(vec![SrgbTransfer::encode(v), Bt1886::encode(v), AdobeRgbTransfer::encode(v)])
    }),
    ("sRGB decoded", 1, |[v, ..]| {
        Some(vec![SrgbTransfer::decode(v), Bt1886::decode(v), AdobeRgbTransfer::decode(v)])
    }),
    ("clipped", 3, |[r, g, b, ..]| Some(Rgb::<Srgb>::new(r, g, b).clip().rgb.to_array().into())),
    ("dimmed", 3, |[r, g, b, ..]| Some(Rgb::<Srgb>::new(r, g, b).dim().rgb.to_array().into())),
];

/// Functions of sums of products, which overflow beyond a size that their documentation states.
const UP_TO: [(Family, f32); 7] = [
    (
        ("Oklab", 3, |n| {
            let oklab = xyz(halves(n)[0]).oklab();
            Some(vec![oklab.l, oklab.a, oklab.b])
        }),
        1e37,
    ),
    (("Oklab to XYZ", 3, |[l, a, b, ..]| Some(Oklab::new(l, a, b).xyz().to_array().into())), 1e12),
    (
        ("Lab to XYZ", 3, |n| Some(lab(halves(n)[0]).xyz(Xyz::new(95.0, 100.0, 109.0)).to_array().into())),
        1e12,
    ),
    (
        ("Luv to XYZ", 3, |[l, u, v, ..]| {
            Luv::new(l, u, v).xyz(Xyz::new(95.0, 100.0, 109.0)).map(|xyz| xyz.to_array().into())
        }),
        1e12,
    ),
    (("RGB of XYZ", 3, |n| Some(Rgb::<Srgb>::from_xyz(xyz(halves(n)[0])).to_array().into())), 1e34),
    (
        ("XYZ of RGB", 3, |[r, g, b, ..]| {
            let color = Rgb::<Srgb>::new(r, g, b);
            let gray = color.desaturate().rgb;
            Some(vec![color.xyz().x, color.xyz().y, color.xyz().z, color.luminance(), gray.r, gray.g, gray.b])
        }),
        1e34,
    ),
    (
        ("adaptation", 6, |n| {
            // Whites of which no part is much larger than another.
            let [from, to] = halves(n.map(|v| v.abs().clamp(1e-6, 1e12))).map(xyz);
            let one = Adaptation::between::<Bradford>(from, to)?;
            let other = Adaptation::partial::<Cat16>(from, to, 0.5)?;
            let color = Xyz::new(50.0, 40.0, 30.0);
            Some([one.apply(color).to_array(), other.apply(color).to_array()].concat())
        }),
        1e30,
    ),
];

/// Any finite number; often one of a usual size, or one at an end.
fn any(noise: &mut Noise) -> f32 {
    const ENDS: [f32; 12] = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        100.0,
        0.5,
        f32::MAX,
        f32::MIN,
        f32::MIN_POSITIVE,
        1e-45,
        -1e-45,
        1.844_674_4e19,
    ];
    match noise.bits() % 8 {
        0 | 1 => 200.0 * noise.offset(),
        2 => ENDS[noise.bits() as usize % ENDS.len()],
        _ => loop {
            let number = f32::from_bits(noise.bits());
            if number.is_finite() {
                return number;
            }
        },
    }
}

fn no_nan(of: Family, most: f32) {
    let (what, _, function) = of;
    let mut noise = Noise(7);
    for _ in 0..CASES {
        let numbers: [f32; 6] = std::array::from_fn(|_| any(&mut noise).clamp(-most, most));
        let got = function(numbers);
        assert!(!got.iter().flatten().any(|v| v.is_nan()), "{what} of {numbers:?}: {got:?}");
    }
}

#[test]
fn no_finite_color_gives_nan() {
    FAMILIES.into_iter().for_each(|family| no_nan(family, f32::MAX));
    UP_TO.into_iter().for_each(|(family, most)| no_nan(family, most));
}

#[test]
fn nan_is_never_swallowed() {
    // Beside usual numbers and beside those for which results are decided and not computed.
    let beside = [[40.0f32, 30.0, 20.0, 95.0, 100.0, 109.0], [0.0; 6], [1.0; 6], [0.3; 6], [-1.0; 6]];
    for (what, arguments, function) in FAMILIES.into_iter().chain(UP_TO.map(|(family, _)| family)) {
        for others in beside {
            for k in 0..arguments {
                let mut numbers = others;
                numbers[k] = f32::NAN;
                let got = function(numbers);
                let is_seen = got.as_ref().is_none_or(|got| got.iter().any(|v| v.is_nan()));
                assert!(is_seen, "{what} of {numbers:?}: {got:?}");
            }
        }
    }
}

#[test]
fn the_largest_colors_have_differences() {
    let (x, y) = (Lab::new(50.0, 4e26, 1e26), Lab::new(60.0, -2e26, 3e26));
    // The weights grow as the chromas do: two huge colors differ as the same colors a hundred times nearer.
    let near = ciede2000(Lab::new(50.0, 4e12, 1e12), Lab::new(60.0, -2e12, 3e12));
    assert!((ciede2000(x, y) / near - 1.0).abs() < 1e-6, "{} {near}", ciede2000(x, y));
    assert!((near - 184.8306).abs() < 1e-3, "{near}");
    assert!((cie76(x, y) / 6.324_555e26 - 1.0).abs() < 1e-6);
    assert!((x.chroma() / 4.123_106e26 - 1.0).abs() < 1e-6);
    assert!((x.lch().h_deg - 14.036_243).abs() < 1e-4);
    let [arts, far] = [Cie94Weights::GraphicArts, Cie94Weights::Textiles].map(|of| cie94(x, y, of));
    assert!((arts - 102.446).abs() < 1e-3 && (far - 109.345).abs() < 1e-3, "{arts} {far}");
    let cmc = cmc(x, y, 1.0, 1.0);
    assert!((1e25..1e27).contains(&cmc), "{cmc}");
    // Black against the lightest color that f32 has, and lightness that overflows as a square.
    let lightness = ciede2000(Lab::new(0.0, 0.0, 0.0), Lab::new(f32::MAX, 0.0, 0.0));
    assert!((lightness - 2.0 / 0.015).abs() < 1e-3, "{lightness}");
    // S_L of L* = 0 is 1 + 0.015 50 / sqrt(1 + 20 / 2500).
    let opposite = ciede2000(Lab::new(-1e20, 0.0, 0.0), Lab::new(1e20, 0.0, 0.0));
    assert!((opposite / 1.144_808e20 - 1.0).abs() < 1e-6, "{opposite}");
    // The two of the CIELUV that were NaN.
    let none = Xyz::new(0.0, -0.191_526_96, 9.870_418e33).luv(Xyz::new(0.0, 3.520_512_3e-36, 0.0));
    assert_eq!(none, None, "L* is beyond f32");
    let dark = Xyz::new(0.0, 2_214.329_6, 0.0).luv(Xyz::new(0.0, 3.298_306_4e38, -2.090_576_1e38));
    assert!(dark.is_none_or(|luv| luv.l.is_finite() && luv.u.is_finite() && luv.v.is_finite()), "{dark:?}");
}
