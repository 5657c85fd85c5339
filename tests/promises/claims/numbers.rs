//! Numbers in prose: found, read, and written anew in the form that they had.

use std::ops::Range;

/// Where the numbers of a text are: `0.009`, `2e-7`, `2^-24`, `14 000`, `14,000`. Digits in a word (`f32`,
/// `FL11`, `x86-64`, `3D`) and powers of a letter (`N^3`) are none.
pub fn numbers(text: &str) -> Vec<Range<usize>> {
    let bytes = text.as_bytes();
    let at = |k: usize| bytes.get(k).copied().unwrap_or(b' ');
    let in_word = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_';
    let mut found = Vec::new();
    let mut k = 0;
    while k < bytes.len() {
        if !at(k).is_ascii_digit() {
            k += 1;
            continue;
        }
        let before = if k > 0 { at(k - 1) } else { b' ' };
        let hyphenated = before == b'-' && k > 1 && at(k - 2).is_ascii_alphanumeric();
        let end = end_of_number(bytes, k);
        if !in_word(before) && before != b'^' && !hyphenated && !in_word(at(end)) {
            found.push(k..end);
            k = end;
        }
        while in_word(at(k)) {
            k += 1;
        }
    }
    found
}

fn end_of_number(bytes: &[u8], start: usize) -> usize {
    let at = |k: usize| bytes.get(k).copied().unwrap_or(b' ');
    let digits = |mut k: usize| {
        while at(k).is_ascii_digit() {
            k += 1;
        }
        k
    };
    let mut end = digits(start);
    // Thousands.
    let mark = at(end);
    while end - start <= 3 || at(end - 4) == mark {
        let runs_on = at(end + 4) == b'.' && at(end + 5).is_ascii_digit();
        if ![b' ', b','].contains(&mark) || at(end) != mark || digits(end + 1) != end + 4 || runs_on {
            break;
        }
        end += 4;
    }
    if at(end) == b'.' && at(end + 1).is_ascii_digit() {
        end = digits(end + 1);
    }
    for mark in [b'e', b'^'] {
        let sign = usize::from(at(end + 1) == b'-');
        if at(end) == mark && at(end + 1 + sign).is_ascii_digit() {
            end = digits(end + 1 + sign);
        }
    }
    end
}

/// A number without separators of thousands.
pub fn plain(number: &str) -> String {
    number.replace([' ', ','], "")
}

/// The value of a number.
pub fn value(number: &str) -> f64 {
    let read =
        |digits: &str| -> f64 { plain(digits).parse().unwrap_or_else(|_| panic!("not a number: {number}")) };
    match number.split_once('^') {
        Some((base, power)) => read(base).powf(read(power)),
        None => read(number),
    }
}

/// How digits that are left off are dealt with.
#[derive(Clone, Copy)]
pub enum Rounding {
    /// A bound: away from zero.
    Up,
    /// A count: to the nearest, with more digits than there were where that would be more than 2 % off.
    Nearest,
}

/// This value with the digits of a number and in its form: with a power of ten, or separators of thousands.
pub fn like(number: &str, value: f64, rounding: Rounding) -> String {
    assert!(!number.contains('^') && value > 0.0, "no form for {value}: {number}");
    let mantissa = plain(number.split('e').next().unwrap_or_default());
    let written = mantissa.trim_start_matches(['0', '.']);
    let written = if mantissa.contains('.') { written } else { written.trim_end_matches('0') };
    let digits = written.bytes().filter(u8::is_ascii_digit).count().max(1);
    let rounded =
        (digits..).find_map(|digits| rounded(value, digits, rounding)).expect("some digits are enough");
    if number.contains('e') {
        return format!("{rounded:e}");
    }
    let text = if mantissa.contains('.') {
        let decimals = (digits as i32 - 1 - rounded.log10().floor() as i32).max(0) as usize;
        format!("{rounded:.decimals$}")
    } else {
        rounded.to_string()
    };
    let mut grouped = String::new();
    let whole = text.find('.').unwrap_or(text.len());
    for (k, digit) in text.char_indices() {
        if let Some(mark) = number.chars().find(|c| [' ', ','].contains(c))
            && (1..whole).contains(&k)
            && (whole - k).is_multiple_of(3)
        {
            grouped.push(mark);
        }
        grouped.push(digit);
    }
    grouped
}

/// A value with so many digits, unless they are too few.
fn rounded(value: f64, digits: usize, rounding: Rounding) -> Option<f64> {
    let text = format!("{value:.*e}", digits - 1);
    let nearest: f64 = text.parse().ok()?;
    match rounding {
        Rounding::Nearest => ((nearest - value).abs() <= 0.02 * value).then_some(nearest),
        Rounding::Up if nearest >= value => Some(nearest),
        Rounding::Up => {
            let (mantissa, exponent) = text.split_once('e')?;
            let (mantissa, exponent): (u64, i32) =
                (mantissa.replace('.', "").parse().ok()?, exponent.parse().ok()?);
            format!("{}e{}", mantissa + 1, exponent + 1 - digits as i32).parse().ok()
        }
    }
}
