//! Rows 25 to 40: sigmoids, Lab, sRGB, colour differences, colour temperature.

use super::claim::Naive::{Fails, Holds};
use super::claim::{Claim, Off, absolute, relative, share};
use super::hard::color::STEEP;
use model::{cct, delta_e, transfer};

pub const CLAIMS: &[Claim] = &[
    Claim {
        row: "25",
        what: "sigmoid, ½ + x/2√(1 + x²)",
        inputs: "x = −1e4 to 1e4",
        measured: "relative",
        limit: 5.5,
        unit: "e",
        asked: "4 e",
        naive: Fails,
        test: "upsample/digits::the_sigmoid_keeps_its_digits_at_both_ends",
        judge: |at, got| relative(got, &[sigmoid(at[0])]),
    },
    Claim {
        row: "26",
        what: "sigmoid where x² overflows: mid grey",
        inputs: "x = ±1e19 to 3e38",
        measured: "absolute",
        limit: 1e-38,
        unit: "",
        asked: "",
        naive: Fails,
        test: "upsample/digits::the_sigmoid_keeps_its_digits_at_both_ends",
        judge: |at, got| absolute(got, &[if at[0] > 0.0 { 1.0 } else { 0.0 }]),
    },
    Claim {
        row: "27",
        what: "sigmoid of a steep quadratic in raw nm; in (nm − 580)/200",
        inputs: "360 to 830 nm, coefficients of 200",
        measured: "absolute",
        limit: 2e-5,
        unit: "",
        asked: "",
        naive: Fails,
        test: "upsample/digits::a_polynomial_of_the_wavelength_keeps_its_digits",
        judge: |at, got| {
            let [a, b, c] = STEEP.map(f64::from);
            let x = (at[0] - 580.0) / 200.0;
            absolute(got, &[sigmoid((a * x + b) * x + c)])
        },
    },
    Claim {
        row: "28",
        what: "cube root by powf(x, 1/3)",
        inputs: "0.008 to 1, −0.05, 1e-30",
        measured: "relative",
        limit: 4.0,
        unit: "e",
        asked: "",
        naive: Fails,
        test: "spectrum/hard_cases::cube_roots_of_lab_are_better_than_a_power",
        judge: |at, got| relative(got, &[at[0].cbrt()]),
    },
    Claim {
        row: "29",
        what: "step of L* at the knee, 0.008856 and 7.787",
        inputs: "neighbouring Y",
        measured: "absolute",
        limit: 8e-6,
        unit: "",
        asked: "0",
        naive: Fails,
        test: "color/spaces::lightness_has_no_jump_at_the_knee",
        judge: |_, got| absolute(&[got[1] - got[0]], &[0.0]),
    },
    Claim {
        row: "30",
        what: "L* of dark and negative Y, 116 powf − 16",
        inputs: "Y = −0.5 to 0.5 of white",
        measured: "relative",
        limit: 8.0,
        unit: "e, 0 for 0",
        asked: "",
        naive: Fails,
        test: "color/spaces::negative_tristimulus_values_are_on_the_straight_line",
        judge: |at, got| {
            let (knee, kappa) = (216.0 / 24389.0, 24389.0 / 27.0);
            relative(got, &[if at[0] > knee { 116.0 * at[0].cbrt() - 16.0 } else { kappa * at[0] }])
        },
    },
    Claim {
        row: "31a",
        what: "xy of black, 0/0",
        inputs: "X = Y = Z = 0",
        measured: "answers",
        limit: 0.0,
        unit: "",
        asked: "",
        naive: Fails,
        test: "color/spaces::no_finite_color_has_a_nan_in_lab_or_luv",
        judge: |_, got| absolute(got, &[0.0]),
    },
    Claim {
        row: "31b",
        what: "Luv of black",
        inputs: "X = Y = Z = 0",
        measured: "absolute",
        limit: 0.0,
        unit: "",
        asked: "",
        naive: Fails,
        test: "color/spaces::black_and_white_are_exact",
        judge: |_, got| absolute(got, &[0.0; 3]),
    },
    Claim {
        row: "31c",
        what: "Lab relative to a white with Z = 0",
        inputs: "a red laser",
        measured: "answers",
        limit: 0.0,
        unit: "",
        asked: "",
        naive: Fails,
        test: "color/spaces::lab_relative_to_a_red_laser_is_undefined_but_luv_is_not",
        judge: |_, got| absolute(got, &[0.0]),
    },
    Claim {
        row: "32a",
        what: "step of the sRGB curve at its knee",
        inputs: "0.0031308 and the next number",
        measured: "absolute",
        limit: 3e-7,
        unit: "",
        asked: "",
        naive: Holds,
        test: "color/transfer::knees_are_those_of_the_standards",
        judge: |_, got| absolute(got, &[0.0]),
    },
    Claim {
        row: "32b",
        what: "sRGB there and back, without odd extension",
        inputs: "−1 to 1",
        measured: "absolute",
        limit: 3e-7,
        unit: "",
        asked: "",
        naive: Fails,
        test: "color/transfer::there_and_back_again",
        judge: |at, got| absolute(got, &[at[0]]),
    },
    Claim {
        row: "33",
        what: "sRGB by micromath",
        inputs: "−1 to 1",
        measured: "absolute",
        limit: 0.5,
        unit: "codes of 16 bits",
        asked: "",
        naive: Fails,
        test: "color/transfer::every_curve_follows_the_model",
        judge: |at, got| {
            absolute(got, &[transfer::srgb_encode(at[0].abs()).copysign(at[0])]).per(1.0 / 65535.0)
        },
    },
    Claim {
        row: "34a",
        what: "CIEDE2000 of Sharma's pairs, hues as angles",
        inputs: "the 34 pairs",
        measured: "absolute",
        limit: 1e-4,
        unit: "",
        asked: "",
        naive: Holds,
        test: "color/differences::de00::all_published_pairs_agree",
        judge: difference,
    },
    Claim {
        row: "34b",
        what: "CIEDE2000 of nearly opposite hues",
        inputs: "3 pairs, the worst of a million",
        measured: "absolute",
        limit: 5e-5,
        unit: "",
        asked: "4e-5",
        naive: Holds,
        test: "color/differences::de00::near_pairs_are_as_exact_as_far_ones",
        judge: difference,
    },
    Claim {
        row: "34c",
        what: "CIEDE2000 of near pairs",
        inputs: "0.01 apart, chroma to 127",
        measured: "relative",
        limit: 8e-7,
        unit: "",
        asked: "",
        naive: Fails,
        test: "color/differences::de00::near_pairs_are_as_exact_as_far_ones",
        judge: |at, got| share(got, &[exact_difference(at)]),
    },
    Claim {
        row: "35",
        what: "CIEDE2000 by the cross product for any two hues",
        inputs: "Sharma's pairs 9 to 14",
        measured: "absolute",
        limit: 1e-4,
        unit: "",
        asked: "",
        naive: Fails,
        test: "color/differences::de00::all_published_pairs_agree",
        judge: difference,
    },
    Claim {
        row: "36",
        what: "CIEDE2000, C⁷/(C⁷ + 25⁷)",
        inputs: "chroma 1e5 to 3e7",
        measured: "relative",
        limit: 1e-5,
        unit: "",
        asked: "",
        naive: Fails,
        test: "color/differences::de00::greys_and_large_chromas_are_finite",
        judge: |at, got| share(got, &[exact_difference(at)]),
    },
    Claim {
        row: "37",
        what: "CCT by McCamy",
        inputs: "1001 K to 990 000 K, |Duv| to 0.05",
        measured: "mired",
        limit: 0.05,
        unit: "",
        asked: "",
        naive: Fails,
        test: "color/cct::every_temperature_from_1000_to_a_million_kelvin_is_found_at_every_duv",
        judge: mired,
    },
    Claim {
        row: "38",
        what: "CCT by Robertson, 31 isotherms",
        inputs: "the same",
        measured: "mired",
        limit: 0.05,
        unit: "",
        asked: "",
        naive: Fails,
        test: "color/cct::every_temperature_from_1000_to_a_million_kelvin_is_found_at_every_duv",
        judge: mired,
    },
    Claim {
        row: "39",
        what: "CCT by Ohno, table of 1 %",
        inputs: "the same",
        measured: "mired",
        limit: 0.05,
        unit: "",
        asked: "",
        naive: Fails,
        test: "color/cct::every_temperature_from_1000_to_a_million_kelvin_is_found_at_every_duv",
        judge: mired,
    },
    Claim {
        row: "40",
        what: "CCT where there is none, McCamy",
        inputs: "|Duv| above 0.05, sRGB primaries",
        measured: "answers",
        limit: 0.0,
        unit: "",
        asked: "",
        naive: Fails,
        test: "color/cct::beyond_the_band_there_is_a_reason_and_no_number",
        judge: |_, got| absolute(got, &[0.0]),
    },
];

fn sigmoid(x: f64) -> f64 {
    let h = 1f64.hypot(x);
    let tail = 0.5 / (h * (h + x.abs()));
    if x > 0.0 { 1.0 - tail } else { tail }
}

fn exact_difference(at: &[f64]) -> f64 {
    delta_e::de2000([at[0], at[1], at[2]], [at[3], at[4], at[5]])
}

fn difference(at: &[f64], got: &[f64]) -> Off {
    absolute(got, &[exact_difference(at)])
}

fn mired(at: &[f64], got: &[f64]) -> Off {
    absolute(&[1e6 / got[0]], &[1e6 / cct::cct([at[0], at[1]]).cct_k])
}
