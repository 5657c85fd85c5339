//! The constants of `tables/upsample` are what this makes of the CIE's tables: it makes them again and
//! compares.
//!
//! `UPSAMPLE_FIT=write cargo test --release -p nanospectra --test upsample tables` writes the files instead.

use crate::fit;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tables/upsample").join(name).with_extension("csv")
}

/// Compares with the file, or writes its rows below the header it has.
fn hold(name: &str, rows: &[Vec<f64>], allowed: f64) {
    let path = file(name);
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let heading = text.lines().position(|line| !line.starts_with('#')).expect("a heading");
    if std::env::var("UPSAMPLE_FIT").is_ok_and(|value| value == "write") {
        let mut new: String = text.lines().take(heading + 1).map(|line| format!("{line}\n")).collect();
        for row in rows {
            let cells: Vec<String> = row.iter().map(|v| format!("{}", *v as f32)).collect();
            let _ = writeln!(new, "{}", cells.join(","));
        }
        return std::fs::write(&path, new).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
    let shipped: Vec<Vec<f64>> = text
        .lines()
        .skip(heading + 1)
        .map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    assert_eq!(shipped.len(), rows.len(), "{name}: rows");
    let mut worst = 0.0f64;
    for (shipped, row) in shipped.iter().zip(rows) {
        assert_eq!(shipped.len(), row.len(), "{name}: columns");
        for (shipped, made) in shipped.iter().zip(row) {
            worst = worst.max((shipped - made).abs() / (1.0 + made.abs()));
        }
    }
    println!("{name}: within {worst:.1e} of what is shipped");
    assert!(worst <= allowed, "{name}: {worst}");
}

#[test]
fn the_narrow_responses_are_the_narrowest_that_are_not_negative() {
    hold("responses", &fit::responses::fit().map(|row| row.to_vec()), 1e-7);
}

#[test]
fn the_start_maps_are_the_best_odd_polynomials() {
    let solved = fit::start::solved(fit::responses::fit());
    assert_eq!(solved.len(), 17 * 17 * 17 - 17);
    for (name, degree) in [("start_linear", 1), ("start_cubic", 3), ("start_quintic", 5)] {
        let map: Vec<Vec<f64>> = fit::start::fit(&solved, degree).iter().map(|row| row.to_vec()).collect();
        hold(name, &map, 1e-6);
    }
}

#[test]
fn the_basis_is_the_smoothest_triple() {
    let rows: Vec<Vec<f64>> = fit::basis::fit()
        .iter()
        .enumerate()
        .map(|(k, [red, green])| vec![380.0 + 5.0 * k as f64, *red, *green])
        .collect();
    hold("basis", &rows, 1e-6);
}
