//! Measures the errors of each elementary function over its domain.

use super::backends::{Math, error_of, of_each};
use crate::cells::{in_order, priced, with_price};
use crate::clock::nanoseconds;
use crate::report::{Cell, Column, Table};
use std::f64::consts::TAU;
use std::hint::black_box;

/// About how many numbers each function is tried at.
const TRIED: u32 = 200_000;
/// About how many numbers are tried around the worst of these, as far as the next that were tried.
const SEARCHED: u32 = 20_000_000;

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
            "The largest errors against f64 over the whole domain of each function, found by trying some \
             {TRIED} numbers, and then every f32 around the worst of them, {SEARCHED} in all: all \
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
    let mut add = |errors: Option<[f64; 2]>, time: f64| {
        let Some((name, word, measure)) = rows.next() else { return };
        let mut row = vec![Cell::key(name), Cell::key(backend), Cell::key(measure.name())];
        row.extend(errors.map_or([Cell::Nothing, Cell::Nothing], |errors| errors.map(error_of)));
        all.push(priced(row, &format!("math-{word}-{}", backend.to_lowercase()), time));
    };
    macro_rules! one {
        ($f:expr, $exact:expr, $measure:expr, $domain:expr, $at:expr) => {
            add(worst($domain, $f, $exact, $measure), nanoseconds(runs, || ($f)(black_box($at))))
        };
    }
    use Measure::{Absolute, Relative};
    let (least, most) = (f32::MIN_POSITIVE, f32::MAX);
    one!(M::sqrt, f64::sqrt, Relative, positive(least, most), 0.3);
    one!(M::cbrt, f64::cbrt, Relative, mirrored(least, most), 0.3);
    one!(M::exp, f64::exp, Relative, mirrored(1e-6, 87.0), -1.3);
    one!(M::expm1, f64::exp_m1, Relative, mirrored(1e-12, 87.0), 1.3);
    one!(M::ln, f64::ln, Relative, positive(least, most), 0.3);
    one!(|x| M::powf(x, 2.4), |x: f64| x.powf(2.4f32.into()), Relative, positive(1e-6, 1e4), 0.3);
    one!(
        |x| M::powf(x, 1.0 / 2.4),
        |x: f64| x.powf((1.0f32 / 2.4).into()),
        Relative,
        positive(1e-6, 1e4),
        0.3
    );
    // A search over millions of pairs ended at the last two for `Fast`.
    let worst_pairs = [(1.351_303_5, 0.864_288_6), (0.708_332_36, 0.450_712_68)];
    let directions: Vec<(f32, f32)> = directions().chain(worst_pairs).collect();
    let mut angles =
        directions.iter().map(|&(y, x)| errors_of(M::atan2(y, x), f64::from(y).atan2(x.into()), Relative));
    add(angles.try_fold([0.0; 2], larger), nanoseconds(runs, || M::atan2(black_box(0.3), black_box(-0.4))));
    one!(M::cos_turns, |x| (TAU * x).cos(), Absolute, mirrored(1e-6, 1.0), 0.3);
    one!(M::sin_turns, |x| (TAU * x).sin(), Absolute, mirrored(1e-6, 1.0), 0.3);
    all
}

/// The positive f32 from `low` to `high` of a function's domain, and their mirror images if it has them.
struct Domain {
    low: f32,
    high: f32,
    mirrored: bool,
}

fn positive(low: f32, high: f32) -> Domain {
    Domain { low, high, mirrored: false }
}

fn mirrored(low: f32, high: f32) -> Domain {
    Domain { low, high, mirrored: true }
}

/// Returns the largest error, and the largest in units of the last place; `None` if a result is not finite.
fn worst(
    domain: Domain,
    f: impl Fn(f32) -> f32,
    exact: impl Fn(f64) -> f64,
    measure: Measure,
) -> Option<[f64; 2]> {
    let at = |bits: u32| {
        let x = f32::from_bits(bits);
        let errors = |x: f32| errors_of(f(x), exact(x.into()), measure);
        if domain.mirrored { larger(errors(x), errors(-x)) } else { larger(errors(x), [0.0; 2]) }
    };
    let (low, high) = (domain.low.to_bits(), domain.high.to_bits());
    // The stride is odd, so that all patterns of the low bits occur.
    let stride = ((high - low) / TRIED) | 1;
    let mut tried: Vec<(u32, [f64; 2])> =
        (low..=high).step_by(stride as usize).map(|bits| Some((bits, at(bits)?))).collect::<Option<_>>()?;
    tried.sort_by(|(_, a), (_, b)| b[0].total_cmp(&a[0]));
    tried.iter().take((SEARCHED / (2 * stride)) as usize).try_fold([0.0; 2], |worst, (bits, _)| {
        let (from, to) = (low.max(bits.saturating_sub(stride)), high.min(bits + stride));
        (from..=to).try_fold(worst, |worst, bits| larger(worst, at(bits)?))
    })
}

/// Returns the larger errors of two; `None` if one is not finite.
fn larger(one: [f64; 2], other: [f64; 2]) -> Option<[f64; 2]> {
    let finite = one[0].is_finite() && other[0].is_finite();
    finite.then(|| [one[0].max(other[0]), one[1].max(other[1])])
}

/// Returns the error as it is measured, and in units of the last place.
fn errors_of(got: f32, exact: f64, measure: Measure) -> [f64; 2] {
    if f64::from(got) == exact {
        return [0.0; 2];
    }
    let off = (f64::from(got) - exact).abs();
    let (unit, size) = match measure {
        Measure::Relative => (ulp(exact), exact.abs()),
        Measure::Absolute => (ulp(1.0), 1.0),
    };
    [off / size, off / unit]
}

/// Returns the distance between neighboring f32 around a number.
fn ulp(exact: f64) -> f64 {
    let exponent = (exact.abs().to_bits() >> 52) as i32 - 1023;
    2f64.powi(exponent.max(-126) - 23)
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
