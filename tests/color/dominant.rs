//! Dominant wavelengths at the ends of the spectrum locus, and of purples.

use model::dominant;
use model::tables::Observer;
use nanospectra::color::{Xy, dominant_wavelength};
use nanospectra::observer::CIE_1931;

const WHITES: [Xy; 3] = [Xy::new(1.0 / 3.0, 1.0 / 3.0), Xy::new(0.3127, 0.329), Xy::new(0.4476, 0.4074)];

/// At its ends the locus turns back along itself. A light of one wavelength has this as its dominant wavelength
/// in between; at the ends it has one whose color is the same, and never a purple.
#[test]
fn a_light_of_one_wavelength_is_pure_and_no_purple() {
    let locus = dominant::spectral_locus(Observer::Cie1931);
    for white in WHITES {
        for (nm, [x, y]) in (360..).zip(&locus) {
            // On the locus and just beyond it.
            for share in [1.0, 1.0 + 1e-5] {
                let part =
                    |white: f32, pure: f64| (f64::from(white) + share * (pure - f64::from(white))) as f32;
                let sample = Xy::new(part(white.x, *x), part(white.y, *y));
                let found = dominant_wavelength(sample, white, &CIE_1931).expect("a color");
                assert!((found.purity - 1.0).abs() < 1e-4, "{nm} nm, {white:?}: {found:?}");
                assert!((360.0..=830.0).contains(&found.nm), "{nm} nm, {white:?}: {found:?}");
                let [seen_x, seen_y] = locus[(found.nm - 360.0).round() as usize];
                let apart = (seen_x - x).hypot(seen_y - y);
                assert!(apart < 6e-4, "{nm} nm, {white:?}: {found:?}, {apart}");
                // Of several, the one nearest to the middle, unless they are one point as beyond 690 nm.
                let from_middle = |nm: f32| (nm - 555.0).abs();
                let is_nearer = from_middle(found.nm) < from_middle(nm as f32) + 1.0;
                assert!(is_nearer || nm > 690, "{nm} nm, {white:?}: {found:?}");
                if (420..=670).contains(&nm) {
                    assert!((found.nm - nm as f32).abs() < 0.02, "{nm} nm, {white:?}: {found:?}");
                }
            }
        }
    }
}

/// Purples have the wavelength of the complementary green, with a minus sign, and a purity up to the purple line.
#[test]
fn purples_have_a_complementary_wavelength() {
    let locus = dominant::spectral_locus(Observer::Cie1931);
    let [blue, red] = [locus[0], locus[470]];
    for white in WHITES {
        for k in 1..100 {
            let t = f64::from(k) / 100.0;
            let edge = [0, 1].map(|i| (1.0 - t) * blue[i] + t * red[i]);
            for share in [0.01, 0.5, 0.99] {
                let [x, y] = [(white.x, edge[0]), (white.y, edge[1])]
                    .map(|(white, edge)| (f64::from(white) + share * (edge - f64::from(white))) as f32);
                let wide = |xy: Xy| [f64::from(xy.x), f64::from(xy.y)];
                let exact = dominant::dominant(wide(Xy::new(x, y)), wide(white), &locus);
                let found = dominant_wavelength(Xy::new(x, y), white, &CIE_1931).expect("a purple");
                let place =
                    format!("{t} of the purple line, {share} from {white:?}: {found:?}, exact {exact:?}");
                assert!(exact.purple && found.nm < 0.0, "{place}");
                assert!((f64::from(found.nm) - exact.nm).abs() < 0.02, "{place}");
                assert!((f64::from(found.purity) - exact.purity).abs() < 2e-5, "{place}");
            }
        }
    }
}

#[test]
fn a_color_within_rounding_of_the_white_has_no_hue() {
    for white in WHITES {
        for (dx, dy) in [(0.0, 0.0), (7e-6, 0.0), (0.0, -7e-6), (-5e-6, 5e-6)] {
            let sample = Xy::new(white.x + dx, white.y + dy);
            assert_eq!(dominant_wavelength(sample, white, &CIE_1931), None, "{dx}, {dy}");
        }
        assert!(dominant_wavelength(Xy::new(white.x, white.y + 2e-5), white, &CIE_1931).is_some());
    }
}
