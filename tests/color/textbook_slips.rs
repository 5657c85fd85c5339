//! Where a rendering textbook's chapter on color slips, and what is right. (Others of its slips are held
//! where they belong: one cosine in irradiance and 683 lm/W in `radiometry`, theta and phi in `directions`,
//! reflectances of the same direction in `brdf`.)

use nanospectra::color::Xyz;
use nanospectra::light::D65;
use nanospectra::observer::CIE_1931;
use nanospectra::upsample::{CohenR, Display};
use nanospectra::{Curve, Light, Nodes, Observer, Power};

type Grid = Nodes<380, 780>;
static EYE: Observer<3, 81, Power, Grid> = CIE_1931.fold(Curve::Step);

/// x-bar X + y-bar Y + z-bar Z, as large as `light` is in Y.
fn sum_of_rows(light: &Light<81, Grid>) -> Light<81, Grid> {
    let amounts = EYE.sees(light);
    let mut sum = Light::flat(0.0);
    for (row, amount) in EYE.weights().iter().zip(amounts) {
        sum += Light::from_bins(*row) * amount;
    }
    sum * (amounts[1] / EYE.sees(&sum)[1])
}

#[test]
fn tristimulus_values_are_inner_products_and_no_coefficients() {
    let light: Light<81, Grid> = D65.resample();
    let xy = |light| Xyz::from(EYE.sees(light)).xy().map(|xy| [xy.x, xy.y]).expect("visible");
    let distance = |a: [f32; 2], b: [f32; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    // X x-bar + Y y-bar + Z z-bar is neither the spectrum nor a spectrum of that color: it is pink.
    let wrong = sum_of_rows(&light);
    assert!(distance(xy(&wrong), xy(&light)) > 0.03, "{:?} {:?}", xy(&wrong), xy(&light));
    // With the amounts that solve for the color, which Cohen's matrix has, it is of that color, and still not
    // D65.
    let right = CohenR::new(&EYE).fundamental(&light);
    assert!(distance(xy(&right), xy(&light)) < 1e-6);
    assert!((right.values()[0] - light.values()[0]).abs() > 0.5 * light.values()[0]);
}

#[test]
fn a_display_needs_the_inverse_of_its_matrix_and_not_the_overlap_of_its_primaries() {
    let display: Display<81, Grid> = Display::led(&EYE);
    let light: Light<81, Grid> = D65.resample();
    let light = light * (1.0 / EYE.sees(&light)[1]);
    let asked = EYE.sees(&light);
    let by_matrix = EYE.sees(&display.emits(display.rgb(Xyz::from(asked))));
    // The integral of each primary times the light, as large as white needs.
    let overlap = display.primaries().each_ref().map(|primary| {
        let product: f32 = primary.values().iter().zip(light.values()).map(|(p, l)| p * l).sum();
        product / primary.values().iter().map(|p| p * p).sum::<f32>()
    });
    let by_overlap = EYE.sees(&display.emits(overlap));
    for k in 0..3 {
        assert!((by_matrix[k] - asked[k]).abs() < 1e-5, "{by_matrix:?} {asked:?}");
    }
    assert!(
        (by_overlap[0] - asked[0]).abs() > 0.1 && (by_overlap[2] - asked[2]).abs() > 0.1,
        "{by_overlap:?}"
    );
}
