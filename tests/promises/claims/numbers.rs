//! Numbers in prose.

/// Every number of a text as it is written, thousands without the space between them: `0.009`, `2e-7`, `2^-24`, `14000`.
/// Digits in a word (`f32`, `FL11`, `x86-64`) and powers of a letter (`N^3`) are none. Panics where it cannot tell.
pub fn numbers(text: &str) -> Vec<String> {
    let bytes = text.as_bytes();
    let at = |k: usize| bytes.get(k).copied().unwrap_or(b' ');
    let mut found = Vec::new();
    let mut k = 0;
    while k < bytes.len() {
        if !at(k).is_ascii_digit() {
            k += 1;
            continue;
        }
        let before = if k > 0 { at(k - 1) } else { b' ' };
        let hyphenated = before == b'-' && k > 1 && at(k - 2).is_ascii_alphanumeric();
        if before.is_ascii_alphanumeric() || before == b'_' || before == b'^' || hyphenated {
            while at(k).is_ascii_alphanumeric() || at(k) == b'_' {
                k += 1;
            }
            continue;
        }
        let end = end_of_number(bytes, k);
        let number = &text[k..end];
        assert!(!at(end).is_ascii_alphabetic() && at(end) != b'_', "a number or a word? {number} in: {text}");
        found.push(number.replace(' ', ""));
        k = end;
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
    // Thousands: 14 000.
    while end - start <= 3 || at(end - 4) == b' ' {
        if at(end) != b' '
            || digits(end + 1) != end + 4
            || at(end + 4) == b'.' && at(end + 5).is_ascii_digit()
        {
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

/// The value of a number as [`numbers`] has it.
pub fn value(number: &str) -> f64 {
    let read = |digits: &str| -> f64 { digits.parse().unwrap_or_else(|_| panic!("not a number: {number}")) };
    match number.split_once('^') {
        Some((base, power)) => read(base).powf(read(power)),
        None => read(number),
    }
}
