//! What must not compile, and what the compiler then says: spectra on different grids, grids that are none, a
//! light applied twice, paths that mix what cannot be mixed.

use crate::programs::Package;
use std::process::Output;

/// Program, source, and what its error must say.
const REFUSED: [(&str, &str, &[&str]); 41] = [
    (
        "adds_two_grids",
        "use nanospectra::{Bins, Light};
        fn main() {
            let sum = Light::<16>::flat(1.0) + Light::<16, Bins<400, 700>>::flat(1.0);
            println!(\"{sum:?}\");
        }",
        &["cannot add `Spectrum<Power, 16, Bins<400, 700>>` to `Spectrum<Power, 16>`"],
    ),
    (
        "adds_two_sizes",
        "use nanospectra::Light;
        fn main() { println!(\"{:?}\", Light::<16>::flat(1.0) + Light::<31>::flat(1.0)); }",
        &["cannot add `Spectrum<Power, 31>` to `Spectrum<Power, 16>`"],
    ),
    (
        "shows_another_grid",
        "use nanospectra::{Curve, Nodes, Observer, Power, Light, observer::CIE_1931};
        fn main() {
            let eye: Observer<3, 36, Power> = CIE_1931.fold(Curve::Step);
            println!(\"{:?}\", eye.sees(&Light::<36, Nodes<380, 730>>::flat(1.0)));
        }",
        &[
            "is no stimulus of `Power` in 36 bins of `Bins<380, 730>`",
            "Nodes<380, 730>",
            "all stages lie on one grid",
        ],
    ),
    (
        "shows_a_lamp_to_a_folded_eye",
        "use nanospectra::{Curve, Light, Observer, light::L41, observer::CIE_1931};
        fn main() {
            let eye: Observer<3, 16> = CIE_1931.under(&L41).fold(Curve::Spline);
            println!(\"{:?}\", eye.sees(&Light::<16>::flat(1.0)));
        }",
        &[
            "is no stimulus of `Factor` in 16 bins",
            "an eye that has a light folded in (`under`) reads `Factor`",
        ],
    ),
    (
        "lights_an_eye_twice",
        "use nanospectra::{light::L41, observer::CIE_1931};
        fn main() { println!(\"{:?}\", CIE_1931.under(&L41).under(&L41).row_sums()); }",
        &["under", "Factor", "Power"],
    ),
    (
        "sums_the_power_of_a_surface",
        "use nanospectra::Reflectance;
        fn main() { println!(\"{}\", Reflectance::<16>::flat(0.5).power()); }",
        &["power", "Factor", "Power"],
    ),
    (
        "shows_counts_of_bins_to_an_eye",
        "use nanospectra::{Fine, PerBin, observer::CIE_1931};
        fn main() { println!(\"{:?}\", CIE_1931.sees(&Fine::<PerBin>::flat(1.0))); }",
        &["is no stimulus of `Power` in 471 bins", "PerBin"],
    ),
    (
        "resamples_counts_of_bins",
        "use nanospectra::{Bins, Fine, PerBin};
        fn main() {
            println!(\"{:?}\", Fine::<PerBin>::flat(1.0).resample::<3, Bins<400, 700>>());
        }",
        &["resample", "PerBin", "Quantity"],
    ),
    (
        "reads_a_wrong_table",
        "use nanospectra::{Nodes, Observer, Power, sensor::responsivities};
        static CHIP: Observer<1, 3, Power, Nodes<400, 402>> = responsivities(\"nm,a\\n400,1\\n402,1\\n\");
        fn main() { println!(\"{:?}\", CHIP); }",
        &["line 3: the wavelength is not the next one of the grid"],
    ),
    (
        "counts_in_i32",
        "use nanospectra::sensor::{Calibration, Exposure, Meter};
        fn main() {
            let meter = Meter::new(&Exposure::new(1.0, 1.0, 65_535), &Calibration::from_rows([[1.0; 8]; 3]));
            println!(\"{:?}\", meter.xyz(&[18_000; 8]));
        }",
        &["`i32` is no raw count", "[18_000_u16; 8]"],
    ),
    (
        "has_no_exposures",
        "use nanospectra::{const_unwrap, sensor::AutoExposure};
        static AUTO: AutoExposure<'static> = const_unwrap!(AutoExposure::new(&[]));
        fn main() { println!(\"{:?}\", AUTO); }",
        &["no exposure to choose from"],
    ),
    (
        "ends_before_it_starts",
        "use nanospectra::{Bins, Light};
        fn main() { println!(\"{:?}\", Light::<16, Bins<730, 380>>::flat(1.0)); }",
        &["a grid must end above its start"],
    ),
    (
        "ends_where_it_starts",
        "use nanospectra::{Light, Nodes};
        fn main() { println!(\"{:?}\", Light::<16, Nodes<500, 500>>::flat(1.0)); }",
        &["a grid must end above its start"],
    ),
    (
        "has_no_bands",
        "use nanospectra::Light;
        fn main() { println!(\"{:?}\", Light::<0>::flat(1.0)); }",
        &["a spectrum needs at least one band"],
    ),
    (
        "has_one_node",
        "use nanospectra::{Light, Nodes};
        fn main() { println!(\"{:?}\", Light::<1, Nodes<380, 780>>::from_bins([1.0])); }",
        &["one band has no spacing: use Bins for it"],
    ),
    (
        "mirrors_plain_light",
        "use nanospectra::{Light, matter::Mirror};
        fn main() {
            let lake = Mirror::<31>::dielectric(&[1.33; 31], 0.6, 0.0);
            println!(\"{:?}\", Light::<31>::flat(1.0).onto(&lake).price());
        }",
        &[
            "is not polarized light in 31 bins",
            "write `light.polarized()` first",
            "mirror.ignoring_polarization()",
        ],
    ),
    (
        "polarizes_what_a_matt_surface_sent_back",
        "use nanospectra::{Light, Reflectance, matter::Polarizer};
        fn main() {
            let (sheet, paper) = (Polarizer::<31>::ideal(0.0), Reflectance::flat(0.5));
            let light = Light::<31>::flat(1.0);
            println!(\"{:?}\", light.polarized().through(&sheet).onto(&paper).through(&sheet).price());
        }",
        &["is not polarized light in 31 bins", "write `light.polarized()` first"],
    ),
    (
        "looks_at_polarized_light",
        "use nanospectra::{Curve, Light, Observer, Power, observer::CIE_1931};
        fn main() {
            let eye: Observer<3, 31, Power> = CIE_1931.fold(Curve::Step);
            println!(\"{:?}\", eye.sees(Light::<31>::flat(1.0).polarized()));
        }",
        &["is no stimulus of `Power` in 31 bins", "by `.ignoring_polarization()`"],
    ),
    (
        "sees_a_vest_without_light",
        "use nanospectra::{Curve, Observer, light::L41, matter::Dye, observer::CIE_1931};
        fn main() { see(CIE_1931.under(&L41).fold(Curve::Step), todo!()) }
        fn see(eye: Observer<3, 31>, vest: Dye<31>) { println!(\"{:?}\", eye.sees(&vest)); }",
        &["is no stimulus of `Factor` in 31 bins", "`eye.looking_at_dye(&dye).under(&lamp)`"],
    ),
    (
        "makes_a_vest_glow_by_a_factor",
        "use nanospectra::{Observer, Reflectance, matter::Dye};
        fn main() {}
        pub fn see(eye: Observer<3, 31>, paper: Reflectance<31>, vest: Dye<31>) {
            println!(\"{:?}\", eye.sees(paper.onto(&vest)));
        }",
        &["cannot make matter fluoresce", "`eye.looking_at_dye(&dye).under(&lamp)`"],
    ),
    (
        "folds_a_vest_in_after_the_light",
        "use nanospectra::{Light, Observer, Power, matter::Dye};
        fn main() {}
        pub fn fold(eye: Observer<3, 31, Power>, lamp: Light<31>, vest: Dye<31>) {
            println!(\"{:?}\", eye.under(&lamp).looking_at_dye(&vest));
        }",
        &["method `looking_at_dye` is available on `&Observer<3, 31, Power>`"],
    ),
    (
        "folds_an_afterglow",
        "use nanospectra::{Observer, Power, matter::Phosphor, path::Scene};
        fn main() {}
        pub fn fold(eye: Observer<3, 31, Power>, paint: Phosphor<31>) {
            println!(\"{:?}\", eye.looking_at_matter(&paint));
            println!(\"{:?}\", Scene::<31, 1>::new().push(&paint));
        }",
        &[
            "does not fold into an eye of 31 bins of `Bins<380, 730>`",
            "if twice the light makes twice as much leave",
        ],
    ),
    (
        "puts_an_effect_into_the_path_bare",
        "use nanospectra::{Light, matter::Effect};
        struct Ink;
        impl Effect<31> for Ink {
            fn leaving(&self, light: &Light<31>) -> Light<31> { *light }
        }
        fn main() { println!(\"{:?}\", Light::<31>::flat(1.0).onto(&Ink).collected()); }",
        &["is no surface that", "on an effect of your own in `Own::new(&ink)`"],
    ),
    (
        "puts_a_filter_of_another_grid_into_the_path",
        "use nanospectra::{Bins, Light, Reflectance};
        fn main() {
            let glass = Reflectance::<16, Bins<400, 700>>::flat(0.5);
            println!(\"{:?}\", Light::<16>::flat(1.0).through(&glass).price());
        }",
        &["is no stimulus of `Power` in 16 bins of `Bins<400, 700>`", "all stages lie on one grid"],
    ),
    (
        "puts_a_dye_of_another_size_into_the_path",
        "use nanospectra::{Light, matter::Dye};
        fn main() {}
        pub fn glow(sun: Light<16>, vest: Dye<31>) { println!(\"{:?}\", sun.onto(&vest).price()); }",
        &["is no stimulus of `Power` in 31 bins"],
    ),
    (
        "shines_light_onto_light",
        "use nanospectra::Light;
        fn main() { println!(\"{:?}\", Light::<31>::flat(1.0).onto(&Light::<31>::flat(1.0)).price()); }",
        &["is no surface that", "is applied once, as the start of the path"],
    ),
    (
        "shines_light_through_light",
        "use nanospectra::Light;
        fn main() { println!(\"{:?}\", Light::<31>::flat(1.0).through(&Light::<31>::flat(1.0)).price()); }",
        &["is no filter that", "is applied once, as the start of the path"],
    ),
    (
        "puts_wine_behind_a_polarizer",
        "use nanospectra::{Light, matter::{Dye, Polarizer}};
        fn main() {}
        pub fn see(sun: Light<31>, sheet: Polarizer<31>, wine: Dye<31>) {
            println!(\"{:?}\", sun.polarized().through(&sheet).through(&wine).price());
        }",
        &["is no filter that", "`.ignoring_polarization()` before `.through(&dye)`"],
    ),
    (
        "pushes_bare_glass_into_a_scene",
        "use nanospectra::{Reflectance, path::Scene};
        fn main() {}
        pub fn build<'a>(scene: &mut Scene<'a, 31, 4>, glass: &'a Reflectance<31>) {
            println!(\"{:?}\", scene.push(glass));
        }",
        &["does not say what it is in a scene", "write `Part::Filter(&glass)` or `Part::Surface(&paper)`"],
    ),
    (
        "shows_a_lit_paper_to_a_folded_eye",
        "use nanospectra::{Light, Observer, Reflectance};
        fn main() {}
        pub fn see(eye: Observer<3, 31>, sun: Light<31>, paper: Reflectance<31>) {
            println!(\"{:?}\", eye.sees(sun.onto(&paper)));
        }",
        &[
            "is no stimulus of `Factor` in 31 bins",
            "an eye that has a light folded in (`under`) reads `Factor`",
        ],
    ),
    (
        "shows_a_radiance",
        "use nanospectra::{Light, Observer, Power, radiometry::Radiance};
        pub fn look(eye: Observer<3, 31, Power>, seen: Radiance<Light<31>>) { eye.sees(seen); }",
        &["is no stimulus of `Power` in 31 bins", "by reference, `eye.sees(&lamp)`", "the `.value()`"],
    ),
    (
        "samples_an_rgb",
        "use nanospectra::{Light, color::RgbBands, color::Srgb};
        fn main() {
            println!(\"{:?}\", Light::<3, RgbBands<Srgb>>::from_samples(&[(400.0, 1.0)]));
        }",
        &["from_samples", "Srgb>: Grid`", "from_rgb"],
    ),
    (
        "soaps_an_rgb",
        "use nanospectra::{color::RgbBands, color::Srgb, math::Fast, matter::ThinFilm};
        fn main() {
            let film = ThinFilm::new([1.0, 1.33, 1.0], 300.0);
            println!(\"{:?}\", film.bins_with::<Fast, 3, RgbBands<Srgb>>(1.0, |shares| shares.reflected));
        }",
        &["Srgb>` has no wavelengths", "work the matter out on a grid", "`Reflectance::from_rgb(color)`"],
    ),
    (
        "glazes_an_rgb",
        "use nanospectra::{color::RgbBands, color::Srgb, matter::{Glass, N_BK7}};
        fn main() { println!(\"{:?}\", N_BK7.indices::<3, RgbBands<Srgb>>()); }",
        &["Srgb>` has no wavelengths", "work the matter out on a grid"],
    ),
    (
        "dyes_an_rgb",
        "use nanospectra::{Light, Reflectance, color::RgbBands, color::Srgb, matter::Dye};
        fn main() {
            let paper = Reflectance::<3, RgbBands<Srgb>>::flat(0.5);
            println!(\"{:?}\", Dye::new(&paper, &paper, &Light::flat(1.0), 0.5));
        }",
        &["Srgb>` has no wavelengths", "work the matter out on a grid"],
    ),
    (
        "asks_an_rgb_for_a_center",
        "use nanospectra::{Bands, Light};
        fn main() {}
        pub fn first<const N: usize, G: Bands>(_: Light<N, G>) -> f32 { Light::<N, G>::center_nm(0) }",
        &["center_nm", "`G` has no wavelengths"],
    ),
    (
        "has_four_of_red_green_and_blue",
        "use nanospectra::{Light, color::RgbBands, color::Srgb};
        fn main() { println!(\"{:?}\", Light::<4, RgbBands<Srgb>>::flat(1.0)); }",
        &["red, green and blue are three bands"],
    ),
    (
        "takes_the_color_of_another_space",
        "use nanospectra::{Light, color::{DisplayP3, Rgb, RgbBands, Srgb}};
        fn main() {
            println!(\"{:?}\", Light::<3, RgbBands<Srgb>>::from_rgb(Rgb::<DisplayP3>::new(1.0, 1.0, 1.0)));
        }",
        &["mismatched types", "Srgb>`, found `Rgb<DisplayP3>`"],
    ),
    (
        "shines_a_spectrum_onto_an_rgb",
        "use nanospectra::{Light, Reflectance, color::RgbBands, color::Srgb};
        fn main() {}
        pub fn shine(sun: Light<3>, red: Reflectance<3, RgbBands<Srgb>>) {
            println!(\"{:?}\", sun.onto(&red).price());
        }",
        &["is no stimulus of `Power` in 3 bins of `RgbBands<"],
    ),
    (
        "takes_longer_than_it_may",
        "use nanospectra::{Light, Reflectance};
        fn main() {
            let path = (Light::<31>::flat(1.0), Reflectance::<31>::flat(1.0));
            println!(\"{:?}\", path.0.onto(&path.1).within::<30>().price());
        }",
        &["this path takes more multiply-adds than it may"],
    ),
    (
        "packs_a_matrix_wrongly",
        "use nanospectra::{Reflectance, matter::Donaldson};
        fn main() { println!(\"{:?}\", Donaldson::<31, 495>::from_reflectance(&Reflectance::flat(0.5))); }",
        &["a Donaldson matrix of N bins has N * (N + 1) / 2 pairs"],
    ),
];

/// Shows that the others do not fail for want of something else.
const ACCEPTED: &str = "
use nanospectra::{Bins, Curve, Light, Observer, Power, Reflectance, light::L41, observer::CIE_1931};
fn main() {
    let eye: Observer<3, 16> = CIE_1931.under(&L41).fold(Curve::Spline);
    println!(\"{:?}\", eye.sees(&Reflectance::flat(1.0)));
    let eye: Observer<3, 1, Power, Bins<400, 700>> = CIE_1931.fold(Curve::Step);
    println!(\"{:?}\", eye.sees(&(Light::flat(1.0) + Light::flat(1.0))));
}
";

/// The errors of `cargo .. --message-format json`, as a terminal shows them: (program, text).
fn errors(output: &Output) -> Vec<(String, String)> {
    let lines = String::from_utf8_lossy(&output.stdout).into_owned();
    let mut found = Vec::new();
    for line in lines.lines() {
        let message: serde_json::Value = serde_json::from_str(line).expect("cargo prints JSON");
        if message["message"]["level"] == "error" {
            let text = |value: &serde_json::Value| value.as_str().unwrap_or_default().to_string();
            found.push((text(&message["target"]["name"]), text(&message["message"]["rendered"])));
        }
    }
    found
}

#[test]
fn what_makes_no_sense_does_not_build_and_the_message_says_why() {
    let mut programs: Vec<(&str, &str)> = REFUSED.iter().map(|(name, source, _)| (*name, *source)).collect();
    programs.push(("accepted", ACCEPTED));
    let package = Package::using_the_crate("refusals", &programs);
    // Bad grids die when code is generated, so this builds and does not only check.
    let output = package.cargo(&["build", "--keep-going", "--message-format", "json"]);
    assert!(!output.status.success(), "all of them built");
    let errors = errors(&output);
    assert!(!errors.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    for (name, _, says) in REFUSED {
        let text: String =
            errors.iter().filter(|(program, _)| program == name).map(|(_, text)| text.as_str()).collect();
        assert!(!text.is_empty(), "{name} was built");
        for phrase in says {
            assert!(text.contains(phrase), "{name}: the message does not say '{phrase}':\n{text}");
        }
    }
    let wrong: Vec<_> = errors.iter().filter(|(program, _)| program == "accepted").collect();
    assert!(wrong.is_empty(), "{wrong:?}");
    assert!(package.folder.join("target/debug/accepted").exists(), "the good program was not built");
}
