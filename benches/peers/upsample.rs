//! The way from an RGB color to a spectrum of 31 bands. The crate `rgb2spec` reads a table of 16^3 cells, and
//! nanospectra solves for the coefficients.

use crate::race::{Races, each};
use nanospectra::color::{EncodedRgb, Rgb, Srgb};
use nanospectra::observer::CIE_1931;
use nanospectra::upsample::{Basis, Sigmoid, Viewing};
use nanospectra::{Curve, Nodes, light::D65};
use rgb2spec::optimize::{gamut::Gamut, optimize};

type Grid = Nodes<400, 700>;

pub fn all(races: &mut Races) {
    let light = D65.fine();
    let viewing: Viewing<31, Grid> = Viewing::new(&CIE_1931.under(&light).fold(Curve::Step));
    let sigmoid: Sigmoid<31, Grid> = Sigmoid::new(&viewing);
    let basis = Basis::new(&viewing);
    let table = optimize(Gamut::SRGB, 16).expect("a table");
    let read = |rgb: [f32; 3]| {
        let coefficients = table.fetch(rgb);
        core::array::from_fn::<f32, 31, _>(|k| rgb2spec::eval_precise(coefficients, 400.0 + 10.0 * k as f32))
    };
    assert!((read([0.5; 3])[15] - 0.5).abs() < 1e-2);

    let mut state = 12345u32;
    let mut next = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 24) as u8
    };
    let codes: Vec<[u8; 3]> = (0..4096).map(|_| [next(), next(), next()]).collect();
    let colors: Vec<Rgb<Srgb>> = codes.iter().map(|c| EncodedRgb::<Srgb>::from_u8(*c).decode()).collect();
    for (code, rgb) in codes.iter().zip(&colors) {
        assert_eq!(viewing.rgb(&sigmoid.reflectance(*rgb).spectrum.on_grid()).encode().to_u8(), *code);
        assert_eq!(viewing.rgb(&basis.reflectance(*rgb)).encode().to_u8(), *code);
    }

    let peer = "rgb2spec, 16^3 cells";
    let theirs = || each(&colors, |rgb| read(rgb.to_array()));
    let by_sigmoid = each(&colors, |rgb| sigmoid.reflectance(*rgb).spectrum.on_grid::<31, Grid>());
    races.run("RGB to 31 bands, Sigmoid", None, 1.0, by_sigmoid, (peer, theirs()));
    let by_basis = each(&colors, |rgb| basis.reflectance(*rgb));
    races.run("RGB to 31 bands, Basis", None, 1.0, by_basis, (peer, theirs()));
}
