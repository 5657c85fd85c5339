//! Writes JSON, with all digits of its numbers.

use crate::failure::is_unsafe;
use serde_json::Value;

/// Returns an object as a line.
///
/// In its texts each character that [`is_unsafe`] is escaped. JSON needs that for some of them only, but a
/// terminal may show them too. None lies beyond U+FFFF.
pub fn line(object: &Value) -> String {
    let json = object.to_string();
    let mut line = String::with_capacity(json.len() + 1);
    for c in json.chars() {
        if is_unsafe(c) {
            line += &format!("\\u{:04x}", c as u32);
        } else {
            line.push(c);
        }
    }
    line + "\n"
}

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
