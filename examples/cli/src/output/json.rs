//! Writes JSON, with all digits of its numbers, and with a note for each number that there is not.

use crate::failure::is_unsafe;
use serde_json::{Value, json};

/// The reason if nothing else is known: what NaN and infinities have in common.
const TOO_EXTREME: &str = "the numbers that it follows from are too large, too small or not those of a light";

/// Returns an object as a line, after [`explain`] has added the missing notes.
///
/// In its texts each character that [`is_unsafe`] is escaped. JSON needs that for some of them only, but a
/// terminal may show them too. None lies beyond U+FFFF.
pub fn line(mut object: Value, why: impl Fn(&str) -> Option<&'static str>) -> String {
    explain(&mut object, why);
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

/// Adds a note for each null that has none.
///
/// A null has a note if the object around it has a text `note`, or if an entry of the list `notes` of the
/// whole object begins with the path of its key, such as `uncertainty.cct_k`, or with a path above it. `why`
/// knows the reasons by their paths; a null without a reason is a number that was too extreme. Paths with the
/// same reason share a note.
pub fn explain(object: &mut Value, why: impl Fn(&str) -> Option<&'static str>) {
    let mut nulls = Vec::new();
    find(object, "", &mut nulls);
    let Some(object) = object.as_object_mut() else { return };
    let notes = object.entry("notes").or_insert_with(|| json!([]));
    let Some(notes) = notes.as_array_mut() else { return };
    let is_noted = |path: &str| notes.iter().filter_map(Value::as_str).any(|note| is_about(note, path));
    nulls.retain(|path| !is_noted(path));
    let mut reasons: Vec<(&str, Vec<String>)> = Vec::new();
    for path in nulls {
        let reason = why(&path).unwrap_or(TOO_EXTREME);
        match reasons.iter_mut().find(|(known, _)| *known == reason) {
            Some((_, paths)) => paths.push(path),
            None => reasons.push((reason, vec![path])),
        }
    }
    notes.extend(reasons.into_iter().map(|(reason, paths)| json!(format!("{}: {reason}", paths.join(", ")))));
}

/// Collects the paths of all nulls without a text `note` beside them, each once.
fn find(value: &Value, path: &str, nulls: &mut Vec<String>) {
    match value {
        Value::Null if nulls.iter().all(|known| known != path) => nulls.push(path.to_owned()),
        Value::Array(values) => values.iter().for_each(|value| find(value, path, nulls)),
        Value::Object(object) if !object.get("note").is_some_and(Value::is_string) => {
            for (key, value) in object {
                let path = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
                find(value, &path, nulls);
            }
        }
        _ => {}
    }
}

/// Returns whether a note begins with this path, or with one above it.
fn is_about(note: &str, path: &str) -> bool {
    let Some((about, _)) = note.split_once(": ") else { return false };
    about
        .split(", ")
        .any(|key| path.strip_prefix(key).is_some_and(|rest| rest.is_empty() || rest.starts_with('.')))
}

/// Returns an f32 with the fewest digits that identify it, such as 0.3127 rather than 0.3127000033855438.
pub fn single(value: f32) -> Value {
    value.to_string().parse::<f64>().map_or(Value::Null, Value::from)
}

/// Returns an f64 with all its digits, or by [`single`] if it is exactly an f32.
///
/// An f32 below its smallest normal number has so few digits that [`single`] would change the f64.
pub fn number(value: f64) -> Value {
    let short = value as f32;
    let is_single = f64::from(short) == value && (short.is_normal() || short == 0.0);
    if is_single { single(short) } else { Value::from(value) }
}

/// Returns a list of numbers by [`single`].
pub fn numbers(values: impl IntoIterator<Item = f32>) -> Value {
    values.into_iter().map(single).collect()
}
