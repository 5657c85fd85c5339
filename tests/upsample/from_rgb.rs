//! `Spectrum::from_rgb`: a color on a grid is the one that it is in RGB bands.
#![cfg(feature = "libm")]

use model::noise::Noise;
use nanospectra::color::{
    AcesCg, Bt2020, DciP3, DisplayP3, Lab, ProPhoto, Rgb, RgbBands, RgbSpace, Srgb, Xyz, ciede2000,
};
use nanospectra::{Bins, Light, Observer, Power, Reflectance};

/// The largest differences of lights and of surfaces under the white, in CIEDE2000.
fn apart<const N: usize, const START: u16, const END: u16, S: RgbSpace>() -> [f32; 2]
where
    Bins<START, END>: nanospectra::Grid,
{
    let eye: Observer<3, N, Power, Bins<START, END>> = Observer::standard();
    let eye_of_rgb: Observer<3, 3, Power, RgbBands<S>> = Observer::standard();
    let lab = |[x, y, z]: [f32; 3]| -> Lab { Xyz::new(x, y, z).lab(S::WHITE_XYZ).expect("a color") };
    let white = Rgb::<S>::new(1.0, 1.0, 1.0);
    let mut noise = Noise(314);
    let mut most = [0.0_f32; 2];
    for k in 0..300 {
        // Colors that are not far from gray, which a sigmoid has in every space.
        let shares: [f32; 3] = noise.shares();
        let [r, g, b] = if k == 0 { [1.0; 3] } else { shares.map(|v| 0.3 + 0.3 * v) };
        let color = Rgb::<S>::new(r, g, b);
        let light: [[f32; 3]; 2] =
            [eye.sees(&Light::from_rgb(color)), eye_of_rgb.sees(&Light::<3, RgbBands<S>>::from_rgb(color))];
        let surface = [
            eye.sees(Light::from_rgb(white).onto(&Reflectance::from_rgb(color))),
            eye_of_rgb.sees(Light::<3, RgbBands<S>>::from_rgb(white).onto(&Reflectance::from_rgb(color))),
        ];
        for (most, [grid, rgb]) in most.iter_mut().zip([light, surface]) {
            *most = most.max(ciede2000(lab(grid), lab(rgb)));
        }
    }
    most
}

#[test]
fn a_color_on_a_grid_is_that_in_rgb_bands() {
    for (name, most) in [
        ("sRGB on 31", apart::<31, 395, 705, Srgb>()),
        ("Display P3 on 81", apart::<81, 360, 830, DisplayP3>()),
        ("BT.2020 on 31", apart::<31, 395, 705, Bt2020>()),
        ("ACEScg on 31", apart::<31, 395, 705, AcesCg>()),
        ("ProPhoto on 81", apart::<81, 360, 830, ProPhoto>()),
        ("DCI-P3 on 31", apart::<31, 395, 705, DciP3>()),
    ] {
        assert!(most.iter().all(|most| *most < 3e-4), "{name}: {most:?}");
    }
}
