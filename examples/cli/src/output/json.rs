//! Numbers in JSON, with all the digits they have.

use serde_json::Value;

/// An f32 with the fewest digits that bring it back: 0.3127 rather than 0.3127000033855438.
pub fn single(value: f32) -> Value {
    value.to_string().parse::<f64>().map_or(Value::Null, Value::from)
}

/// The same for an f32 that went through f64; all digits for an f64 that is none.
pub fn number(value: f64) -> Value {
    let short = value as f32;
    if f64::from(short) == value { single(short) } else { Value::from(value) }
}

/// A list of them.
pub fn numbers(values: impl IntoIterator<Item = f32>) -> Value {
    values.into_iter().map(single).collect()
}
