//! Sine and cosine of an angle in turns: reduction to a quarter turn is exact there, as it can
//! never be in radians, and an f32 polynomial does the rest.

/// Cosine of `turns` full turns.
///
/// # Accuracy
/// 1.7e-7 absolute, for any finite argument.
#[must_use]
pub const fn cos(turns: f32) -> f32 {
    // What whole turns leave is exact, and so is the distance from the quarter turn.
    quarter_sine(0.25 - fraction(turns).abs())
}

/// Sine of `turns` full turns; accuracy as [`cos`].
#[must_use]
pub const fn sin(turns: f32) -> f32 {
    let part = fraction(turns);
    // Beyond a quarter turn the sine goes back as it came.
    let size = part.abs();
    let fold = if size > 0.25 { 0.5 - size } else { size };
    // At half a turn, which is as near to one whole turn as to the next, zero has the sign of the angle.
    quarter_sine(fold.copysign(if size < 0.5 { part } else { turns }))
}

/// sin(2 pi t) for |t| <= 1/4: the Taylor series in t, which at a quarter turn is off by 7e-10. Its first
/// three coefficients are a unit in the last place or so off their values, where the roundings then meet
/// best: 1.6e-7 and not 2.2e-7.
const fn quarter_sine(t: f32) -> f32 {
    let s = t * t;
    let series = 42.058_693 - s * (15.094_643 - s * 3.819_952_6);
    let series = 81.605_255 - s * (76.705_86 - s * series);
    const TURN: f32 = core::f32::consts::TAU.next_down();
    t * (TURN - s * (41.341_698 - s * series))
}

/// What is left of `turns` after the nearest whole number of them, from -1/2 to 1/2; exact.
pub(crate) const fn fraction(turns: f32) -> f32 {
    if turns.abs() < 4_194_304.0 {
        // Next to 1.5 * 2^23 an f32 has no fraction.
        turns - (turns + 12_582_912.0 - 12_582_912.0)
    } else if turns.abs() < 8_388_608.0 {
        turns - turns as i32 as f32
    } else {
        // 2^23 turns and beyond are whole; infinity and NaN have no angle.
        turns * 0.0
    }
}
