//! Responsivities from CSV text: the numbers, what may stand around them, and what the messages say.

use model::noise::Noise;
use nanospectra::sensor::{
    ResponsivityError, ResponsivityErrorKind as Kind, read_responsivities, responsivities,
};
use nanospectra::{Bins, Grid, Nodes, Observer, Power};
use proptest::prelude::*;

type Small = Observer<2, 3, Power, Nodes<400, 402>>;

/// Read while compiling: a published table of 471 rows, comments and all.
static CMF: Observer<3, 471, Power, Nodes<360, 830>> =
    responsivities(include_str!("../../tables/cmf/cie_1931_2deg_xyz_1nm.csv"));

#[test]
fn a_published_table_is_read_while_compiling() {
    assert_eq!(CMF, nanospectra::observer::CIE_1931);
}

#[test]
fn a_table_may_be_written_in_many_ways() {
    let expected: Small = Observer::from_rows([[0.5, 0.25, 0.0], [1e-3, -2.0, 1.0]]);
    for csv in [
        "400,0.5,1e-3\n401,0.25,-2\n402,0,1\n",
        "nm,blue,red\n400,0.5,0.001\n401,.25,-2.\n402,0,1",
        "# chip 7\r\n\r\nwavelength in nm;a;b\r\n400;5e-1;1E-3\r\n401;+0.25;-2.0\r\n# half way\r\n402;-0;1e0\r\n",
        "\u{feff}nm\tblue\tred\n400\t0.5\t0.001\n401\t0.25\t-2\n402\t0\t1\n\n  \n",
        "  400 , 0.5 , 0.001 \n 401.0 , 0.25 , -2\n4.02e2,0.0,1.00\n   # the end",
    ] {
        let read: Result<Small, _> = read_responsivities(csv);
        assert_eq!(read, Ok(expected), "{csv:?}");
    }
    // On a grid wider than 1 nm the weights are times the width.
    let wide: Result<Observer<1, 2, Power, Bins<400, 500>>, _> = read_responsivities("425,1\n475,0.5\n");
    assert_eq!(wide.map(|sensor| *sensor.weights()), Ok([[50.0, 25.0]]));
}

#[test]
fn a_wrong_table_says_where_and_what() {
    let cases: [(&str, u32, Kind, &str); 17] = [
        ("", 1, Kind::MissingRows, "the table ends before the grid does"),
        ("# only\n", 2, Kind::MissingRows, "before"),
        ("400,1,2\n401,1,2\n", 3, Kind::MissingRows, "before"),
        ("400,1,2\n401,1,2\n402,1,2\n403,1,2\n", 4, Kind::TooManyRows, "more rows"),
        ("400,1,2\n402,1,2\n", 2, Kind::AnotherWavelength, "wavelength"),
        ("400.01,1,2\n", 1, Kind::AnotherWavelength, "wavelength"),
        ("# a\n\nnm,a,b\n401,1,2\n", 4, Kind::AnotherWavelength, "wavelength"),
        ("nm,a,b\n400,1\n", 2, Kind::MissingColumn, "a column is missing"),
        ("400,1,2,3\n", 1, Kind::MoreColumns, "more columns"),
        ("400,1,2,\n", 1, Kind::MoreColumns, "more columns"),
        ("400,1,\n", 1, Kind::NoNumber, "not a number"),
        ("400,1,x\n", 1, Kind::NoNumber, "not a number"),
        ("400,1,2 3\n", 1, Kind::NoNumber, "not a number"),
        ("400,1,0x1\n", 1, Kind::NoNumber, "not a number"),
        ("400,1,NaN\n", 1, Kind::NoNumber, "not a number"),
        ("400,1,1e39\n", 1, Kind::TooLarge, "too large"),
        ("nm,a,b\nnm,a,b\n", 2, Kind::NoNumber, "not a number"),
    ];
    for (csv, line, kind, says) in cases {
        let read: Result<Small, _> = read_responsivities(csv);
        let error = read.expect_err("a wrong table");
        assert_eq!(error, ResponsivityError { line, kind }, "{csv:?}");
        let text = error.to_string();
        assert!(text.starts_with(&format!("line {line}: ")) && text.contains(says), "{text}");
    }
}

#[test]
#[should_panic(expected = "line 2: a column is missing")]
fn the_one_for_compile_time_panics_with_the_same_words() {
    let _: Small = responsivities("400,1,2\n401,1\n");
}

#[test]
#[should_panic(expected = "line 1203: a column is missing")]
fn lines_of_four_digits_are_named() {
    let _: Small = responsivities(&format!("{}400,1,2\n401,1\n", "# nothing\n".repeat(1201)));
}

/// What the table reader makes of one number.
fn read(number: &str) -> Option<f32> {
    let csv = format!("400,{number}\n");
    let sensor: Result<Observer<1, 1, Power, OneNode>, _> = read_responsivities(&csv);
    sensor.ok().map(|sensor| sensor.weights()[0][0])
}

/// One bin of 1 nm around 400 nm.
#[derive(Clone, Copy, Debug)]
struct OneNode;

impl Grid for OneNode {
    const FIRST: f64 = 399.5;
    const LAST: f64 = 400.5;
    const CENTERED: bool = false;
}

#[test]
fn numbers_are_the_nearest_f32() {
    let mut noise = Noise(1);
    let compare = |text: String| {
        let (Some(got), Ok(expected)) = (read(&text), text.parse::<f32>()) else { panic!("{text}") };
        assert_eq!(got.to_bits(), expected.to_bits(), "{text}: got {got:e}, not {expected:e}");
    };
    for _ in 0..200_000 {
        let digits = (noise.uniform() * 10f64.powf(1.0 + 17.0 * noise.uniform())) as u64;
        let exponent = (noise.uniform() * 80.0) as i32 - 55;
        if digits as f64 * 10f64.powi(exponent) < 3.4e38 {
            compare(format!("{digits}e{exponent}"));
        }
        compare(format!("{:.*}", (noise.uniform() * 12.0) as usize, noise.uniform() * 10.0));
    }
    // Every bit pattern that a program prints comes back.
    for step in 0..400_000u32 {
        compare(format!("{:e}", f32::from_bits(step * 5347)));
    }
    // Exactly half way between two, one up and one down; the smallest; the largest.
    for text in
        ["16777217", "16777219", "1.401298464324817e-45", "0.7e-45", "0.8e-45", "3.4028235e38", "1e-60"]
    {
        compare(text.to_string());
    }
    // Above half way by less than 2^-64, where the nearest below is even.
    for text in ["190753383897462997e3", "157926440384982732e4", "117453954843016201e6"] {
        compare(text.to_string());
    }
    assert_eq!((read("-0"), read("1e-99999999999")), (Some(-0.0), Some(0.0)));
    assert_eq!((read("1e99999999999"), read("3.5e38")), (None, None));
    assert_eq!(read("0.000000000000000000000000000000000000000000000000000000000001e60"), Some(1.0));
    assert_eq!(read("100000000000000000000000000000000000000000000000000000000e-56"), Some(1.0));
    // More digits than are counted, on both sides of the point.
    compare("12345678901234567890123.4567890123456789012345".to_string());
    compare("1.2345678901234567890123456789e3".to_string());
    compare("0.12345678901234567890123456789012345".to_string());
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 2000,
        ..ProptestConfig::default()
    })]

    #[test]
    fn any_text_is_a_table_or_an_error(text in "[ -~\n\r\t\u{0}é]{0,60}", digits in "[0-9eE+.,;\n-]{0,80}") {
        let _: Result<Small, _> = read_responsivities(&text);
        let _: Result<Small, _> = read_responsivities(&digits);
        let _: Result<Small, _> = read_responsivities(&format!("400,{digits}"));
    }
}
