//! What the study of cost has on record: that it says what it is quoted for, and agrees with an earlier one.
#![cfg(feature = "libm")]

use serde_json::Value;
use std::collections::BTreeMap;

fn record() -> Value {
    serde_json::from_str(include_str!("../examples/cost/data/cost.json")).expect("JSON")
}

fn rows<'a>(record: &'a Value, table: &str) -> &'a [Value] {
    record["tables"][table]["rows"].as_array().expect("a table on record")
}

const LAMPS: [&str; 5] = ["smooth", "halophosphate", "triphosphor", "led", "hid"];

/// The row of a scheme.
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
fn a_folded_light_keeps_its_colour_and_steps_are_never_negative() {
    let record = record();
    for row in rows(&record, "xyz-light") {
        if row["scheme"].as_str().is_some_and(|scheme| scheme.starts_with("folded")) {
            assert!(number(row, "lamps_percent_y") < 0.1 && number(row, "lamps_uv") < 3e-4, "{row}");
        }
    }
    for row in rows(&record, "filters").iter().filter(|row| row["scheme"] == "folded step") {
        assert_eq!(number(row, "negative_10nm"), 0.0, "{row}");
    }
    // And those by a curve are, as the README says.
    let spline = choice(rows(&record, "filters"), "380..730", "folded spline", "16");
    assert!(number(spline, "negative_10nm") > 1.0);
}

/// Rows of the earlier study that its frontier lists, each with its mean per class.
fn earlier() -> Vec<(String, BTreeMap<String, f64>)> {
    let text = include_str!("../examples/cost/data/earlier.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    let columns = reader.headers().expect("columns").clone();
    let rows = reader.records().map(|record| -> BTreeMap<String, String> {
        let record = record.expect("a row");
        columns.iter().map(str::to_owned).zip(record.iter().map(str::to_owned)).collect()
    });
    rows.filter(|cells| cells["frontier"] == "yes")
        .map(|cells| {
            let name = format!("{}|{}|{}", cells["range"], cells["scheme"], cells["bands"]);
            let means = LAMPS
                .map(|class| (class.to_owned(), cells[&format!("{class}_mean")].parse().expect("a mean")));
            (name, BTreeMap::from(means))
        })
        .collect()
}

#[test]
fn schemes_rank_as_in_the_earlier_study() {
    let record = record();
    let earlier = earlier();
    assert_eq!(earlier.len(), 12);
    let ours = |name: &str, class: &str| {
        let key: Vec<&str> = name.split('|').collect();
        number(choice(rows(&record, "xyz"), key[0], key[1], key[2]), class)
    };
    let mut compared = 0;
    for class in LAMPS {
        for (one, one_was) in &earlier {
            for (two, two_was) in &earlier {
                // Half the last digit of both, and what the sum at 1 nm adds: nobody can rank below that.
                let (a, b) = (one_was[class], two_was[class]);
                if a + 0.006 < 0.9 * b {
                    compared += 1;
                    assert!(ours(one, class) < ours(two, class), "{class}: {one} is not better than {two}");
                }
            }
        }
    }
    assert!(compared > 200, "{compared} pairs");
}

#[test]
fn what_moved_since_the_earlier_study_has_a_cause() {
    let record = record();
    let moved = rows(&record, "earlier-rows");
    assert!(!moved.is_empty());
    for row in moved {
        assert_ne!(row["cause"], "NOT FOUND", "{row}");
    }
    // With the same lamps everything else is as it was.
    for row in rows(&record, "earlier").iter().filter(|row| row["lamps"] == "the same") {
        let explained = moved.iter().filter(|moved| {
            moved["range"] == row["range"]
                && moved["scheme"] == row["scheme"]
                && moved["class"] == row["class"]
        });
        assert_eq!(number(row, "alike") + explained.count() as f64, number(row, "compared"), "{row}");
    }
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
    // Dearer than a product of colours, the best is folded.
    assert!(
        front.iter().skip(1).all(|row| row["scheme"].as_str().is_some_and(|name| name.starts_with("folded")))
    );
    let losses = rows(&record, "losses");
    let points = losses.iter().any(|row| row["more"] == "more bands" && number(row, "ratio") > 10.0);
    assert!(points, "points at some N are ten times as far off as at fewer");
}
