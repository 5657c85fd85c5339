//! The constants of `tables/upsample` are what this makes of the CIE's tables: it makes them again and
//! compares.
//!
//! `UPSAMPLE_FIT=write cargo test --release -p nanospectra --test upsample tables` writes the files instead.

use crate::fit;
use nanospectra::upsample::{CubicStart, LinearStart, QuinticStart, StartMap};
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
    let both = |name, degree, start: fn([f32; 3]) -> [f32; 3]| {
        let map = fit::start::fit(&solved, degree);
        hold(name, &map.iter().map(|row| row.to_vec()).collect::<Vec<_>>(), 1e-6);
        // And the library computes them.
        let mut worst = 0.0f64;
        for color in &solved {
            let exact = fit::start::start(color.u, degree, &map);
            let size = 1.0 + exact.iter().map(|q| q.abs()).sum::<f64>();
            for (found, exact) in start(color.u.map(|u| u as f32)).into_iter().zip(exact) {
                worst = worst.max((f64::from(found) - exact).abs() / size);
            }
        }
        println!("{name}: computed within {worst:.1e} of the size of the curve");
        assert!(worst <= 1e-6, "{name}: {worst}");
    };
    both("start_linear", 1, start::<LinearStart>);
    both("start_cubic", 3, start::<CubicStart>);
    both("start_quintic", 5, start::<QuinticStart>);
}

fn start<M: StartMap>(u: [f32; 3]) -> [f32; 3] {
    M::start(u)
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
