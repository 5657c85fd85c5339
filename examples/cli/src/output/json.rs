//! Writes numbers as JSON, with all their digits.

use serde_json::Value;

/// Returns an f32 with the fewest digits that identify it, such as 0.3127 rather than 0.3127000033855438.
pub fn single(value: f32) -> Value {
    value.to_string().parse::<f64>().map_or(Value::Null, Value::from)
}

/// Returns an f64 with all its digits, or by [`single`] if it is exactly an f32.
pub fn number(value: f64) -> Value {
    let short = value as f32;
    if f64::from(short) == value { single(short) } else { Value::from(value) }
}

/// Returns a list of numbers by [`single`].
pub fn numbers(values: impl IntoIterator<Item = f32>) -> Value {
    values.into_iter().map(single).collect()
}
