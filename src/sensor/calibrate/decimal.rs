//! Converts numbers as people write them to f32, in integers and in `const fn`.

/// Reads the number that begins at `at`, with sign, digits with or without a point, and exponent; and returns
/// where it ends.
///
/// `None` if there is no digit. Beyond the range of f32 the number is infinite.
///
/// # Accuracy
/// The nearest f32. (Of more than 19 digits, or below 1e-19 or beyond 1e19, it may be the other one within
/// 2^-50 of half way between two.)
pub(super) const fn decimal(text: &[u8], mut at: usize) -> (Option<f32>, usize) {
    let negative = byte(text, at) == b'-';
    if matches!(byte(text, at), b'-' | b'+') {
        at += 1;
    }
    let (mut digits, mut exponent, mut any, mut point) = (0u64, 0i32, false, 0);
    while at < text.len() {
        let next = text[at];
        if next.is_ascii_digit() {
            any = true;
            if digits < 1_000_000_000_000_000_000 {
                digits = digits * 10 + (next - b'0') as u64;
                exponent -= point;
            } else {
                exponent += 1 - point;
            }
        } else if next == b'.' && point == 0 {
            point = 1;
        } else {
            break;
        }
        at += 1;
    }
    if !any {
        return (None, at);
    }
    if matches!(byte(text, at), b'e' | b'E') {
        let mut end = at + 1;
        let down = byte(text, end) == b'-';
        if matches!(byte(text, end), b'-' | b'+') {
            end += 1;
        }
        if byte(text, end).is_ascii_digit() {
            let mut written = 0i32;
            while byte(text, end).is_ascii_digit() {
                if written < 100_000 {
                    written = written * 10 + (byte(text, end) - b'0') as i32;
                }
                end += 1;
            }
            exponent = exponent.saturating_add(if down { -written } else { written });
            at = end;
        }
    }
    let size = scaled(digits, exponent);
    (Some(if negative { -size } else { size }), at)
}

const fn byte(text: &[u8], at: usize) -> u8 {
    if at < text.len() { text[at] } else { 0 }
}

/// `digits` times 10^`exponent`.
const fn scaled(digits: u64, exponent: i32) -> f32 {
    if digits == 0 || exponent < -80 {
        return 0.0;
    }
    if exponent > 50 {
        return f32::INFINITY;
    }
    // m * 2^binary with the highest bit of m set; `inexact` if something below it was lost.
    let mut binary = -(digits.leading_zeros() as i32);
    let mut m = digits << digits.leading_zeros();
    let (mut left, mut inexact) = (exponent, false);
    while left > 0 {
        // Computes m * 10 / 16 in two parts that do not overflow.
        let product = (m >> 4) * 10 + (((m & 15) * 10) >> 4);
        inexact |= ((m & 15) * 10) & 15 != 0;
        binary += 4;
        let shift = product.leading_zeros();
        m = product << shift;
        binary -= shift as i32;
        left -= 1;
    }
    while left < 0 {
        // Computes m / 10^n as a quotient, and the bits below it from the remainder.
        let n = if left < -9 { 9 } else { -left };
        let divisor = power_of_ten(n);
        let (quotient, rest) = (m / divisor, m % divisor);
        let shift = quotient.leading_zeros();
        m = (quotient << shift) | ((rest << shift) / divisor);
        inexact |= (rest << shift) % divisor != 0;
        binary -= shift as i32;
        left += n;
    }
    // The exponent of the leading bit; f32 keeps 24 bits from there, fewer below 2^-126.
    let leading = binary + 63;
    let kept = if leading >= -126 { 24 } else { 24 + leading + 126 };
    if leading > 127 {
        return f32::INFINITY;
    }
    if kept < 0 {
        return 0.0;
    }
    // Rounds to the nearest, ties to even.
    let dropped = 64 - kept as u32;
    let (high, low) = if dropped >= 64 { (0, m) } else { (m >> dropped, m << (64 - dropped)) };
    let half = 1u64 << 63;
    let up = low > half || (low == half && (inexact || high & 1 == 1));
    let rounded = (high + up as u64) as u32;
    // Adding instead of combining lets a carry move into the exponent.
    let bits = if leading >= -126 { (((leading + 126) as u32) << 23) + rounded } else { rounded };
    f32::from_bits(bits)
}

/// Returns 10^n for n in 1..=9, and 10 for others. (Never 0, so that dividing by it cannot panic.)
const fn power_of_ten(n: i32) -> u64 {
    match n {
        2 => 100,
        3 => 1_000,
        4 => 10_000,
        5 => 100_000,
        6 => 1_000_000,
        7 => 10_000_000,
        8 => 100_000_000,
        9 => 1_000_000_000,
        _ => 10,
    }
}
