//! Color differences: Sharma's 34 pairs, golden 05, the model, symmetry and the hard cases.

use model::allowed::{Singles, check};
use model::csv::golden;
use model::delta_e as reference;
use nanospectra::color::{Cie94Weights, Lab, cie76, cie94, cmc, hyab};
use proptest::prelude::*;

fn lab([l, a, b]: [f64; 3]) -> Lab {
    Lab::new(l as f32, a as f32, b as f32)
}

fn wide(c: Lab) -> [f64; 3] {
    [f64::from(c.l), f64::from(c.a), f64::from(c.b)]
}

#[test]
fn plain_differences_agree() {
    let mut all = [
        ("dE76", "dE76, golden 05"),
        ("dE94", "dE94, golden 05"),
        ("dE94_textiles", "dE94 of textiles, golden 05"),
        ("CMC_1_1", "CMC 1:1, golden 05"),
        ("CMC_2_1", "CMC 2:1, golden 05"),
        ("HyAB", "HyAB, golden 05"),
    ]
    .map(|(column, what)| (column, check(what)));
    for row in golden("05_delta_e").rows() {
        let (x, y) = (lab(row.numbers(["L1", "a1", "b1"])), lab(row.numbers(["L2", "a2", "b2"])));
        let got = [
            cie76(x, y),
            cie94(x, y, Cie94Weights::GraphicArts),
            cie94(x, y, Cie94Weights::Textiles),
            cmc(x, y, 1.0, 1.0),
            cmc(x, y, 2.0, 1.0),
            hyab(x, y),
        ];
        for ((column, check), got) in all.iter_mut().zip(got) {
            check.add(&row.place(), got, row.number(column));
        }
    }
    all.into_iter().for_each(|(_, check)| check.tight(1552));
}

/// How many [`pairs`] there are; the other 44 are the same color twice in f32.
const PAIRS: usize = 39_955;

/// Pairs of different colors all over the place, from far apart to 1e-5 apart.
fn pairs() -> impl Iterator<Item = (Lab, Lab)> {
    // a low-discrepancy sequence: the multiples of six irrational numbers
    let steps = [0.754_877_66, 0.569_840_29, 0.414_213_56, 0.732_050_8, 0.236_067_98, 0.645_751_3_f64];
    (1..40_000_u32)
        .map(move |k| {
            let [a, b, c, d, e, f] = steps.map(|s| (f64::from(k) * s).fract());
            let x = lab([100.0 * a, 200.0 * b - 100.0, 200.0 * c - 100.0]);
            let apart = 10f64.powf(f64::from(k % 8) - 5.0);
            let move_by = |v: f32, t: f64| v + (apart * (2.0 * t - 1.0)) as f32;
            let near = Lab::new(move_by(x.l, d), move_by(x.a, e), move_by(x.b, f));
            // and every ninth with one of the two next to gray
            let shrink = (0.1 * apart) as f32;
            match k % 9 {
                0 => (x, Lab::new(near.l, near.a * shrink, near.b * shrink)),
                1 => (Lab::new(x.l, x.b * shrink, -x.a * shrink), near),
                _ => (x, near),
            }
        })
        .filter(|(x, y)| x != y)
}

#[test]
fn near_pairs_are_as_exact_as_far_ones() {
    let mut all = ["dE76, near and far", "dE94, near and far", "CMC 2:1, near and far", "HyAB, near and far"]
        .map(check);
    for (x, y) in pairs() {
        let (one, two) = (wide(x), wide(y));
        let place = format!("{x:?} {y:?}");
        all[0].add(&place, cie76(x, y), reference::de76(one, two));
        all[1].add(&place, cie94(x, y, Cie94Weights::GraphicArts), reference::de94(one, two));
        all[2].add(&place, cmc(x, y, 2.0, 1.0), reference::cmc(one, two, 2.0, 1.0));
        all[3].add(&place, hyab(x, y), reference::hyab(one, two));
    }
    all.into_iter().for_each(|check| check.tight(PAIRS));
}

/// Chromas whose squares overflow in f32 are counted in another unit, which must not show.
#[test]
fn huge_pairs_are_as_exact_as_usual_ones() {
    let mut noise = model::noise::Noise(1018);
    for _ in 0..2000 {
        let size = noise.decades(1e17, 1e30);
        let [a, b, c, d]: [f32; 4] = noise.shares().map(|v: f32| size * (2.0 * v - 1.0));
        let (x, y) = (Lab::new(50.0, a, b), Lab::new(60.0, c, d));
        let (one, two) = (wide(x), wide(y));
        for (name, found, exact) in [
            ("dE76", cie76(x, y), reference::de76(one, two)),
            ("dE94", cie94(x, y, Cie94Weights::GraphicArts), reference::de94(one, two)),
            ("CMC", cmc(x, y, 2.0, 1.0), reference::cmc(one, two, 2.0, 1.0)),
            ("HyAB", hyab(x, y), reference::hyab(one, two)),
        ] {
            assert!(
                (f64::from(found) / exact - 1.0).abs() < 1e-5,
                "{name} of {x:?}, {y:?}: {found}, exact {exact}"
            );
        }
    }
}

#[cfg(feature = "libm")]
mod de00 {
    use super::*;
    use nanospectra::color::{ParametricFactors, ciede2000, ciede2000_with};
    use nanospectra::math::Portable;

    /// A hue of exactly 180 degrees is reached from both sides.
    #[test]
    fn the_sign_of_a_zero_does_not_matter() {
        let mut noise = model::noise::Noise(180);
        for _ in 0..2000 {
            let [p, q]: [f32; 2] = noise.shares().map(|v: f32| -100.0 * v);
            let of = |a: f32, b: f32| ciede2000(Lab::new(50.0, p, a), Lab::new(60.0, q, b)).to_bits();
            let plain = of(0.0, 0.0);
            assert!(
                [of(-0.0, 0.0), of(0.0, -0.0), of(-0.0, -0.0)].iter().all(|bits| *bits == plain),
                "{p}, {q}"
            );
        }
    }

    /// Sharma, Wu and Dalal 2005, table 1, all of it.
    const SHARMA: [([f64; 3], [f64; 3], f64); 34] = [
        ([50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485], 2.0425),
        ([50.0, 3.1571, -77.2803], [50.0, 0.0, -82.7485], 2.8615),
        ([50.0, 2.8361, -74.0200], [50.0, 0.0, -82.7485], 3.4412),
        ([50.0, -1.3802, -84.2814], [50.0, 0.0, -82.7485], 1.0000),
        ([50.0, -1.1848, -84.8006], [50.0, 0.0, -82.7485], 1.0000),
        ([50.0, -0.9009, -85.5211], [50.0, 0.0, -82.7485], 1.0000),
        ([50.0, 0.0, 0.0], [50.0, -1.0, 2.0], 2.3669),
        ([50.0, -1.0, 2.0], [50.0, 0.0, 0.0], 2.3669),
        ([50.0, 2.4900, -0.0010], [50.0, -2.4900, 0.0009], 7.1792),
        ([50.0, 2.4900, -0.0010], [50.0, -2.4900, 0.0010], 7.1792),
        ([50.0, 2.4900, -0.0010], [50.0, -2.4900, 0.0011], 7.2195),
        ([50.0, 2.4900, -0.0010], [50.0, -2.4900, 0.0012], 7.2195),
        ([50.0, -0.0010, 2.4900], [50.0, 0.0009, -2.4900], 4.8045),
        ([50.0, -0.0010, 2.4900], [50.0, 0.0010, -2.4900], 4.8045),
        ([50.0, -0.0010, 2.4900], [50.0, 0.0011, -2.4900], 4.7461),
        ([50.0, 2.5, 0.0], [50.0, 0.0, -2.5], 4.3065),
        ([50.0, 2.5, 0.0], [73.0, 25.0, -18.0], 27.1492),
        ([50.0, 2.5, 0.0], [61.0, -5.0, 29.0], 22.8977),
        ([50.0, 2.5, 0.0], [56.0, -27.0, -3.0], 31.9030),
        ([50.0, 2.5, 0.0], [58.0, 24.0, 15.0], 19.4535),
        ([50.0, 2.5, 0.0], [50.0, 3.1736, 0.5854], 1.0000),
        ([50.0, 2.5, 0.0], [50.0, 3.2972, 0.0], 1.0000),
        ([50.0, 2.5, 0.0], [50.0, 1.8634, 0.5757], 1.0000),
        ([50.0, 2.5, 0.0], [50.0, 3.2592, 0.3350], 1.0000),
        ([60.2574, -34.0099, 36.2677], [60.4626, -34.1751, 39.4387], 1.2644),
        ([63.0109, -31.0961, -5.8663], [62.8187, -29.7946, -4.0864], 1.2630),
        ([61.2901, 3.7196, -5.3901], [61.4292, 2.2480, -4.9620], 1.8731),
        ([35.0831, -44.1164, 3.7933], [35.0232, -40.0716, 1.5901], 1.8645),
        ([22.7233, 20.0904, -46.6940], [23.0331, 14.9730, -42.5619], 2.0373),
        ([36.4612, 47.8580, 18.3852], [36.2715, 50.5065, 21.2231], 1.4146),
        ([90.8027, -2.0831, 1.4410], [91.1528, -1.6435, 0.0447], 1.4441),
        ([90.9257, -0.5406, -0.9208], [88.6381, -0.8985, -0.7239], 1.5381),
        ([6.7747, -0.2908, -2.4247], [5.8714, -0.0985, -2.2286], 0.6377),
        ([2.0776, 0.0795, -1.1350], [0.9033, -0.0636, -0.5514], 0.9082),
    ];

    #[test]
    fn all_published_pairs_agree() {
        let (mut typed, mut table) = (check("Sharma's table, by the model"), check("Sharma's table"));
        let mut model = check("Sharma's pairs, model");
        for (k, (one, two, expected)) in SHARMA.into_iter().enumerate() {
            let place = format!("pair {}", k + 1);
            let (x, y) = (lab(one), lab(two));
            typed.value(&place, reference::de2000(one, two), expected);
            table.add(&place, ciede2000(x, y), expected);
            model.add(&place, ciede2000(x, y), reference::de2000(one, two));
        }
        [typed, table, model].into_iter().for_each(|check| check.tight(34));
    }

    #[test]
    fn golden_05_agrees() {
        let mut all = check("dE00, golden 05");
        for row in golden("05_delta_e").rows() {
            let (x, y) = (lab(row.numbers(["L1", "a1", "b1"])), lab(row.numbers(["L2", "a2", "b2"])));
            all.add(&row.place(), ciede2000(x, y), row.number("dE00"));
            assert_eq!(ciede2000(x, y).to_bits(), ciede2000(y, x).to_bits(), "{}", row.place());
        }
        all.tight(1552);
    }

    #[test]
    fn near_pairs_are_as_exact_as_far_ones() {
        let mut all = check("dE00, near and far");
        for (x, y) in pairs() {
            let expected = reference::de2000(wide(x), wide(y));
            all.add(&format!("{x:?} {y:?}"), ciede2000(x, y), expected);
        }
        all.tight(PAIRS);
    }

    #[test]
    fn opposite_hues_are_symmetric() {
        for k in 0..3600 {
            let angle = f64::from(k) * 0.1_f64.to_radians();
            let (a, b) = ((30.0 * angle.cos()) as f32, (30.0 * angle.sin()) as f32);
            let (x, y) = (Lab::new(40.0, a, b), Lab::new(70.0, -1.5 * a, -1.5 * b));
            assert_eq!(ciede2000(x, y).to_bits(), ciede2000(y, x).to_bits(), "{k}");
        }
    }

    #[test]
    fn grays_and_large_chromas_are_finite() {
        let gray = Lab::new(50.0, 0.0, 0.0);
        assert_eq!(ciede2000(gray, gray), 0.0);
        assert_eq!(ciede2000(Lab::default(), Lab::new(100.0, 0.0, 0.0)), 100.0);
        assert_eq!(ciede2000(gray, Lab::new(50.0, -0.0, -0.0)), 0.0);
        let mut large = check("dE00 of large chromas");
        for size in [1e2_f32, 1e3, 1e5, 3.2e5, 1e6, 1e9] {
            for (p, q) in [(1.0, 0.3), (-0.7, 0.9), (0.1, -1.0)] {
                let (x, y) = (Lab::new(50.0, size * p, size * q), Lab::new(60.0, size * q, -size * p));
                let expected = reference::de2000(wide(x), wide(y));
                large.add(&format!("{size}"), ciede2000(x, y), expected);
            }
        }
        large.tight(6 * 3);
    }

    #[test]
    fn parametric_factors_divide_their_own_part() {
        let k = ParametricFactors { k_l: 2.0, ..ParametricFactors::default() };
        let (x, y) = (Lab::new(40.0, 10.0, 0.0), Lab::new(60.0, 10.0, 0.0));
        assert_eq!(ciede2000_with::<Portable>(x, y, k), 0.5 * ciede2000(x, y));
        let (x, y) = (Lab::new(50.0, 10.0, 0.0), Lab::new(50.0, 20.0, 0.0));
        assert_eq!(ciede2000_with::<Portable>(x, y, k), ciede2000(x, y));
    }

    proptest! {
        #[test]
        fn swapping_changes_no_bit(x in any_lab(), y in any_lab()) {
            prop_assert_eq!(ciede2000(x, y).to_bits(), ciede2000(y, x).to_bits());
            prop_assert_eq!(ciede2000(x, x), 0.0);
            prop_assert!(ciede2000(x, y).is_finite() && ciede2000(x, y) >= 0.0);
        }

        #[test]
        fn nan_is_never_hidden(x in any_lab(), which in 0_usize..3) {
            let mut parts = [x.l, x.a, x.b];
            parts[which] = f32::NAN;
            let [l, a, b] = parts;
            let nan = Lab::new(l, a, b);
            prop_assert!(ciede2000(x, nan).is_nan() && ciede2000(nan, x).is_nan());
        }
    }
}

/// Colors as they are, and up to 1e9.
fn any_lab() -> impl Strategy<Value = Lab> {
    prop_oneof![
        [0.0_f32..100.0, -120.0_f32..120.0, -120.0_f32..120.0].prop_map(|[l, a, b]| Lab::new(l, a, b)),
        [-1e9_f32..1e9, -1e9_f32..1e9, -1e9_f32..1e9].prop_map(|[l, a, b]| Lab::new(l, a, b)),
        [-1e-9_f32..1e-9, -1e-9_f32..1e-9, -1e-9_f32..1e-9].prop_map(|[l, a, b]| Lab::new(l, a, b)),
    ]
}

proptest! {
    #[test]
    fn plain_differences_are_distances(x in any_lab(), y in any_lab()) {
        prop_assert_eq!(cie76(x, y).to_bits(), cie76(y, x).to_bits());
        prop_assert_eq!(hyab(x, y).to_bits(), hyab(y, x).to_bits());
        for weights in [Cie94Weights::GraphicArts, Cie94Weights::Textiles] {
            prop_assert!(cie94(x, y, weights).is_finite());
            prop_assert_eq!(cie94(x, x, weights), 0.0);
        }
        prop_assert!(cmc(x, y, 2.0, 1.0).is_finite());
        prop_assert_eq!(cmc(x, x, 2.0, 1.0), 0.0);
    }

    #[test]
    fn nan_is_never_hidden(x in any_lab(), which in 0_usize..3) {
        let mut parts = [x.l, x.a, x.b];
        parts[which] = f32::NAN;
        let [l, a, b] = parts;
        let nan = Lab::new(l, a, b);
        for (p, q) in [(x, nan), (nan, x)] {
            prop_assert!(cie76(p, q).is_nan() && hyab(p, q).is_nan());
            prop_assert!(cie94(p, q, Cie94Weights::Textiles).is_nan() && cmc(p, q, 1.0, 1.0).is_nan());
        }
    }
}
