//! Tests that the record supports the statements for which it is quoted.

use serde_json::Value;

fn record() -> Value {
    serde_json::from_str(include_str!("../../data/cost.json")).expect("JSON")
}

fn rows<'a>(record: &'a Value, table: &str) -> &'a [Value] {
    record["tables"][table]["rows"].as_array().expect("a table on record")
}

const LAMPS: [&str; 5] = ["smooth", "halophosphate", "triphosphor", "led", "hid"];

/// Finds the row of a choice.
fn choice<'a>(rows: &'a [Value], range: &str, scheme: &str, bands: &str) -> &'a Value {
    rows.iter()
        .find(|row| row["range"] == range && row["scheme"] == scheme && row["bands"] == bands)
        .unwrap_or_else(|| panic!("{scheme} N = {bands} on {range} is not on record"))
}

fn number(row: &Value, column: &str) -> f64 {
    row[column].as_f64().unwrap_or_else(|| panic!("{column} of {row}"))
}

#[test]
fn sixteen_folded_bands_are_within_the_gate_at_the_price_that_is_quoted() {
    let record = record();
    let mean = choice(rows(&record, "xyz"), "380..730", "folded spline", "16");
    let spread = choice(rows(&record, "xyz-spread"), "380..730", "folded spline", "16");
    for class in ["halophosphate", "triphosphor", "led"] {
        assert!(number(mean, class) <= 0.06, "{class}: mean {}", mean[class]);
        let worst = number(spread, &format!("{class}_max"));
        assert!(worst <= 1.0, "{class}: max {worst}");
    }
    assert!(number(mean, "m4f_instructions") <= 180.0);
    assert_eq!((number(mean, "constant_bytes"), number(mean, "surface_bytes")), (192.0, 64.0));
}

#[test]
fn sixteen_folded_bands_beat_sixty_averages_under_every_class_of_lamps() {
    let record = record();
    let sweep = rows(&record, "xyz");
    let folded = choice(sweep, "380..730", "folded spline", "16");
    let plain = choice(sweep, "380..730", "averages", "60");
    for class in LAMPS.into_iter().chain(["lines"]) {
        assert!(number(folded, class) < number(plain, class), "{class}");
    }
    assert!(4.0 * number(folded, "m4f_instructions") < number(plain, "m4f_instructions"));
}

#[test]
fn a_folded_light_keeps_its_color_and_steps_are_never_negative() {
    let record = record();
    for row in rows(&record, "xyz-light") {
        if row["scheme"].as_str().is_some_and(|scheme| scheme.starts_with("folded")) {
            assert!(number(row, "lamps_percent_y") < 0.1 && number(row, "lamps_uv") < 3e-4, "{row}");
        }
    }
    for row in rows(&record, "filters").iter().filter(|row| row["scheme"] == "folded step") {
        assert_eq!(number(row, "negative_10nm"), 0.0, "{row}");
    }
    // Those by a smooth curve are negative at times, as the README says.
    let spline = choice(rows(&record, "filters"), "380..730", "folded spline", "16");
    assert!(number(spline, "negative_10nm") > 1.0);
}

#[test]
fn the_front_is_folded_and_leads_down() {
    let record = record();
    let front: Vec<&Value> = rows(&record, "frontier").iter().filter(|row| row["lamps"] == "lamps").collect();
    assert!(front.len() > 6);
    for pair in front.windows(2) {
        assert!(number(pair[0], "m4f_instructions") < number(pair[1], "m4f_instructions"));
        assert!(number(pair[0], "mean_de2000") > number(pair[1], "mean_de2000"));
    }
    // Among the choices that take more instructions than a product of colors, the best are folded.
    assert!(
        front.iter().skip(1).all(|row| row["scheme"].as_str().is_some_and(|name| name.starts_with("folded")))
    );
    let losses = rows(&record, "losses");
    let points = losses.iter().any(|row| row["more"] == "more bands" && number(row, "ratio") > 10.0);
    assert!(points, "points at some N are ten times as far off as at fewer");
}
