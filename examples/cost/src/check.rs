//! Compares what was measured now with what is on record.

use serde_json::{Map, Value};

/// The relative difference up to which two figures are equal: one unit of their last digit.
const ALIKE: f64 = 1.001e-3;

/// Returns one line for each figure, row or table that differs from the record. Times are not compared, and
/// neither are tables that were not measured now.
pub fn differences(now: &Value, record: &Value) -> Vec<String> {
    let mut found = Vec::new();
    let (Some(now), Some(record)) = (now["tables"].as_object(), record["tables"].as_object()) else {
        return vec!["no tables".to_owned()];
    };
    for (id, table) in now {
        match record.get(id) {
            Some(recorded) => of_tables(id, table, recorded, &mut found),
            None => found.push(format!("{id}: not on record")),
        }
    }
    found
}

fn of_tables(id: &str, now: &Value, record: &Value, found: &mut Vec<String>) {
    let words = |key: &str| -> Vec<&str> {
        now[key].as_array().into_iter().flatten().filter_map(Value::as_str).collect()
    };
    let (keys, figures) = (words("keys"), words("figures"));
    let name =
        |row: &Value| keys.iter().map(|key| row[*key].as_str().unwrap_or("")).collect::<Vec<_>>().join(", ");
    let rows = |table: &Value| -> Map<String, Value> {
        table["rows"].as_array().into_iter().flatten().map(|row| (name(row), row.clone())).collect()
    };
    let (now, record) = (rows(now), rows(record));
    for gone in record.keys().filter(|name| !now.contains_key(*name)) {
        found.push(format!("{id}: {gone}: on record, and not measured now"));
    }
    for (name, row) in &now {
        let Some(recorded) = record.get(name) else {
            found.push(format!("{id}: {name}: not on record"));
            continue;
        };
        for figure in &figures {
            let (now, before) = (&row[*figure], &recorded[*figure]);
            if !alike(now, before) {
                found.push(format!(
                    "{id}: {name}: {figure} is {now}, on record {before}{}",
                    worse(now, before)
                ));
            }
        }
    }
}

fn alike(now: &Value, before: &Value) -> bool {
    match (now.as_f64(), before.as_f64()) {
        (Some(now), Some(before)) => (now - before).abs() <= ALIKE * now.abs().max(before.abs()),
        _ => now == before,
    }
}

fn worse(now: &Value, before: &Value) -> String {
    match (now.as_f64(), before.as_f64()) {
        (Some(now), Some(before)) if before > 0.0 => {
            let percent = 100.0 * (now / before - 1.0);
            format!(" ({percent:+.1} %{})", if percent > 2.0 { ", WORSE" } else { "" })
        }
        _ => String::new(),
    }
}
