//! Sine and cosine of an angle in turns. In turns the reduction to a quarter turn is exact, which it cannot
//! be in radians, and a polynomial in f32 does the rest.

/// Returns the cosine of an angle of `turns` full turns, of 360 degrees each.
///
/// See the [example](crate::math#example).
///
/// # Accuracy
/// 1.7e-7 absolute, for any finite argument.
#[must_use]
pub const fn cos(turns: f32) -> f32 {
    // The fraction of a turn is exact, and so is its distance from a quarter turn.
    quarter_sine(0.25 - fraction(turns).abs())
}

/// Returns the sine of an angle of `turns` full turns, of 360 degrees each.
///
/// It is as accurate as the cosine. See the [example](crate::math#example).
#[must_use]
pub const fn sin(turns: f32) -> f32 {
    let part = fraction(turns);
    // Beyond a quarter turn the sine takes the same values in reverse order.
    let size = part.abs();
    let fold = if size > 0.25 { 0.5 - size } else { size };
    // Half a turn is as near to one whole turn as to the next; there the zero gets the sign of the angle.
    quarter_sine(fold.copysign(if size < 0.5 { part } else { turns }))
}

/// sin(2 pi t) for |t| <= 1/4 by the Taylor series in t, which is off by 7e-10 at a quarter turn. Its first
/// three coefficients are changed by about a unit in the last place, because rounding errors then reach
/// 1.6e-7 and not 2.2e-7.
const fn quarter_sine(t: f32) -> f32 {
    let s = t * t;
    let series = 42.058_693 - s * (15.094_643 - s * 3.819_952_6);
    let series = 81.605_255 - s * (76.705_86 - s * series);
    const TURN: f32 = core::f32::consts::TAU.next_down();
    t * (TURN - s * (41.341_698 - s * series))
}

/// The difference of `turns` to the nearest whole number, from -1/2 to 1/2; it is exact.
pub(crate) const fn fraction(turns: f32) -> f32 {
    if turns.abs() < 4_194_304.0 {
        // Near 1.5 * 2^23 an f32 has no fraction.
        turns - (turns + 12_582_912.0 - 12_582_912.0)
    } else if turns.abs() < 8_388_608.0 {
        turns - turns as i32 as f32
    } else {
        // From 2^23 on all numbers are whole. Infinity and NaN are no angles and give NaN.
        turns * 0.0
    }
}
