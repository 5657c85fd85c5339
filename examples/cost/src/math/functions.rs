//! Measures the errors of each elementary function over its domain.

use super::backends::{Math, error_of, of_each};
use crate::cells::{in_order, priced, with_price};
use crate::clock::nanoseconds;
use crate::report::{Cell, Column, Table};
use std::f64::consts::TAU;
use std::hint::black_box;

/// About how many numbers each function is tried at.
const TRIED: u32 = 200_000;

pub fn table(runs: usize) -> Table {
    let mut rows: Vec<Vec<Cell>> = of_each!(of, runs);
    // The rows are sorted by function, and the backends of a function stay in their order.
    in_order(&mut rows, NAMES.iter().map(|name| name.0));
    let columns = with_price(vec![
        Column::key("function", "function"),
        Column::key("backend", "backend"),
        Column::key("measure", "error is"),
        Column::figure("max_error", "largest error"),
        Column::figure("max_ulp", "in ulp"),
    ]);
    Table {
        id: "math",
        title: "Elementary functions of f32, by backend".into(),
        about: format!(
            "The errors against f64 at some {TRIED} numbers over the whole domain of each function: all \
             sizes for roots and the logarithm, |x| <= 87 for exponentials, 1e-6..1e4 for powers, all \
             directions for the arctangent, and one turn in both senses for sine and cosine. A unit in the \
             last place is that of the result, or of 1 where the error is absolute. Std is the library of \
             this platform."
        ),
        columns,
        rows,
    }
}

/// How an error is measured.
#[derive(Clone, Copy)]
enum Measure {
    Relative,
    Absolute,
}

impl Measure {
    fn name(self) -> &'static str {
        match self {
            Measure::Relative => "relative",
            Measure::Absolute => "absolute",
        }
    }
}

/// The name of each function, the name of its count on record, and how its error is measured.
const NAMES: [(&str, &str, Measure); 10] = [
    ("sqrt", "sqrt", Measure::Relative),
    ("cbrt", "cbrt", Measure::Relative),
    ("exp", "exp", Measure::Relative),
    ("exp - 1", "expm1", Measure::Relative),
    ("ln", "ln", Measure::Relative),
    ("x^2.4", "pow24", Measure::Relative),
    ("x^(1/2.4)", "root24", Measure::Relative),
    ("atan2", "atan2", Measure::Relative),
    ("cos", "cos", Measure::Absolute),
    ("sin", "sin", Measure::Absolute),
];

fn of<M: Math>(backend: &'static str, runs: usize) -> Vec<Vec<Cell>> {
    let mut rows = NAMES.into_iter();
    let mut all = Vec::new();
    let mut add =
        |errors: Option<[f64; 2]>, time: f64| {
            let Some((name, word, measure)) = rows.next() else { return };
            let mut row = vec![Cell::key(name), Cell::key(backend), Cell::key(measure.name())];
            row.extend(errors.map_or([Cell::Nothing, Cell::Nothing], |errors| {
                errors.map(|error| error_of(backend, error))
            }));
            all.push(priced(row, &format!("math-{word}-{}", backend.to_lowercase()), time));
        };
    macro_rules! one {
        ($f:expr, $exact:expr, $measure:expr, $inputs:expr, $at:expr) => {
            add(worst($inputs, $f, $exact, $measure), nanoseconds(runs, || ($f)(black_box($at))))
        };
    }
    use Measure::{Absolute, Relative};
    let (least, most) = (f32::MIN_POSITIVE, f32::MAX);
    one!(M::sqrt, f64::sqrt, Relative, spread(least, most), 0.3);
    one!(M::cbrt, f64::cbrt, Relative, both(least, most), 0.3);
    one!(M::exp, f64::exp, Relative, both(1e-6, 87.0), -1.3);
    one!(M::expm1, f64::exp_m1, Relative, both(1e-12, 87.0), 1.3);
    one!(M::ln, f64::ln, Relative, spread(least, most), 0.3);
    one!(|x| M::powf(x, 2.4), |x: f64| x.powf(2.4f32.into()), Relative, spread(1e-6, 1e4), 0.3);
    one!(|x| M::powf(x, 1.0 / 2.4), |x: f64| x.powf((1.0f32 / 2.4).into()), Relative, spread(1e-6, 1e4), 0.3);
    let directions: Vec<(f32, f32)> = directions().collect();
    let angles = directions.iter().map(|&(y, x)| (M::atan2(y, x), f64::from(y).atan2(x.into())));
    add(worst_of(angles, Relative), nanoseconds(runs, || M::atan2(black_box(0.3), black_box(-0.4))));
    one!(M::cos_turns, |x| (TAU * x).cos(), Absolute, both(1e-6, 1.0), 0.3);
    one!(M::sin_turns, |x| (TAU * x).sin(), Absolute, both(1e-6, 1.0), 0.3);
    all
}

/// Returns the largest error, and the largest in units of the last place; `None` if a result is not finite.
fn worst(
    inputs: impl Iterator<Item = f32>,
    f: impl Fn(f32) -> f32,
    exact: impl Fn(f64) -> f64,
    measure: Measure,
) -> Option<[f64; 2]> {
    worst_of(inputs.map(|x| (f(x), exact(x.into()))), measure)
}

fn worst_of(pairs: impl Iterator<Item = (f32, f64)>, measure: Measure) -> Option<[f64; 2]> {
    pairs.filter(|(got, exact)| f64::from(*got) != *exact).try_fold(
        [0.0_f64; 2],
        |[error, ulps], (got, exact)| {
            let off = (f64::from(got) - exact).abs();
            let (unit, size) = match measure {
                Measure::Relative => (ulp(exact), exact.abs()),
                Measure::Absolute => (ulp(1.0), 1.0),
            };
            off.is_finite().then(|| [error.max(off / size), ulps.max(off / unit)])
        },
    )
}

/// Returns the distance between neighboring f32 around a number.
fn ulp(exact: f64) -> f64 {
    let exponent = (exact.abs().to_bits() >> 52) as i32 - 1023;
    2f64.powi(exponent.max(-126) - 23)
}

/// Gives positive f32 from `low` to `high`, spread over all exponents.
fn spread(low: f32, high: f32) -> impl Iterator<Item = f32> {
    let (low, high) = (low.to_bits(), high.to_bits());
    // The stride is odd, so that all patterns of the low bits occur.
    let stride = ((high - low) / TRIED) | 1;
    (low..=high).step_by(stride as usize).map(f32::from_bits)
}

/// Gives every second of these numbers with both signs.
fn both(low: f32, high: f32) -> impl Iterator<Item = f32> {
    spread(low, high).step_by(2).flat_map(|x| [x, -x])
}

/// Gives points in all directions from the origin, at distances of several orders of magnitude.
fn directions() -> impl Iterator<Item = (f32, f32)> {
    let angles = (0..TRIED / 25).map(|k| (f64::from(k) + 0.123) / f64::from(TRIED / 25) * TAU);
    angles.flat_map(|angle| {
        (-12..=12).map(move |size| {
            let r = 1.37f64.powi(size);
            ((r * angle.sin()) as f32, (r * angle.cos()) as f32)
        })
    })
}
