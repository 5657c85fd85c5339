//! Turns numbers into text: every number of a report, a picture or a message comes from here.
//!
//! A number that does not exist is a word here, and not `NaN` or `inf`: a sum that exceeds every number is
//! "too large", and a number that has no value is "undefined". In JSON both are `null`, and
//! [`json::line`](super::json::line) adds the note. (A test looks for other places that format numbers.)

use std::fmt::Display;

/// The number from which an exponent is easier to read than all digits.
const LONG: f64 = 1e9;

/// Returns a number with this many decimals, or with an exponent if it has more than nine digits in front of
/// them.
pub fn fixed(value: impl Into<f64>, decimals: usize) -> String {
    let value = value.into();
    word(value).unwrap_or_else(|| {
        if value.abs() < LONG { format!("{value:.decimals$}") } else { format!("{value:.5e}") }
    })
}

/// Returns a number as [`fixed`] does, with its sign.
pub fn signed(value: impl Into<f64>, decimals: usize) -> String {
    let value = value.into();
    word(value).unwrap_or_else(|| {
        if value.abs() < LONG { format!("{value:+.decimals$}") } else { format!("{value:+.5e}") }
    })
}

/// Returns a number with this many significant digits, without an exponent where that is readable.
pub fn significant(value: impl Into<f64>, digits: usize) -> String {
    let value = value.into();
    let size = value.abs();
    word(value).unwrap_or_else(|| {
        if size == 0.0 {
            return "0".into();
        }
        if !(1e-3..1e6).contains(&size) {
            return format!("{value:.*e}", digits - 1);
        }
        let decimals = digits as i32 - 1 - size.log10().floor() as i32;
        format!("{value:.*}", decimals.clamp(0, digits as i32 + 2) as usize)
    })
}

/// Returns a number with four significant digits at least, and with an exponent if it is tiny or long.
pub fn at_least_four(value: impl Into<f64>) -> String {
    let value = value.into();
    let decimals = (3.0 - value.abs().log10().floor()).clamp(0.0, 9.0);
    word(value).unwrap_or_else(|| {
        if value == 0.0 {
            "0".into()
        } else if decimals < 9.0 && value.abs() < LONG {
            format!("{value:.*}", decimals as usize)
        } else {
            format!("{value:.3e}")
        }
    })
}

/// Returns a number with the digits that identify it: all of them up to nine, and else an exponent.
pub fn shortest<T: Copy + Display + std::fmt::LowerExp + Into<f64>>(value: T) -> String {
    let size = value.into().abs();
    word(value.into()).unwrap_or_else(|| {
        if size == 0.0 || (1e-6..LONG).contains(&size) { value.to_string() } else { format!("{value:e}") }
    })
}

/// Returns a number that is in units of a power of ten, with these decimals. The power is not written if it
/// is 0.
pub fn with_exponent(value: f64, decimals: usize, power: i32) -> String {
    let number = fixed(value, decimals);
    if power == 0 || value == 0.0 { number } else { format!("{number}e{power}") }
}

/// Returns several numbers with this many decimals, with `between` between them.
pub fn all<T: Into<f64>>(values: impl IntoIterator<Item = T>, decimals: usize, between: &str) -> String {
    values.into_iter().map(|value| fixed(value, decimals)).collect::<Vec<_>>().join(between)
}

/// Returns the word for a number that does not exist.
fn word(value: f64) -> Option<String> {
    let word = match value {
        finite if finite.is_finite() => return None,
        nothing if nothing.is_nan() => "undefined",
        above if above > 0.0 => "too large",
        _ => "too large (negative)",
    };
    Some(word.into())
}
