//! What a sensor's calibration and reconstruction should be: normal equations and elimination, in f64.

use super::linear::solve;

/// As f64, row by row.
pub fn wide<const C: usize, const N: usize>(rows: &[[f32; N]; C]) -> Vec<Vec<f64>> {
    rows.iter().map(|row| row.iter().map(|v| f64::from(*v)).collect()).collect()
}

pub fn transposed(a: &[Vec<f64>]) -> Vec<Vec<f64>> {
    (0..a[0].len()).map(|j| a.iter().map(|row| row[j]).collect()).collect()
}

pub fn product(a: &[Vec<f64>], b: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let columns = transposed(b);
    a.iter().map(|row| columns.iter().map(|column| dot(row, column)).collect()).collect()
}

pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The rows W with the least sum of (weight * (W counts - target))^2.
pub fn fit(counts: &[Vec<f64>], targets: &[Vec<f64>], weights: &[f64]) -> Vec<Vec<f64>> {
    let weighted = |rows: &[Vec<f64>]| -> Vec<Vec<f64>> {
        rows.iter().zip(weights).map(|(row, w)| row.iter().map(|v| v * w).collect()).collect()
    };
    let (a, b) = (weighted(counts), weighted(targets));
    let at = transposed(&a);
    transposed(&solve(product(&at, &a), product(&at, &b)))
}

/// correlation^|i - j|.
pub fn smooth_covariance(n: usize, correlation: f64) -> Vec<Vec<f64>> {
    (0..n).map(|i| (0..n).map(|j| correlation.powi(i.abs_diff(j) as i32)).collect()).collect()
}

/// K G' (G K G' + alpha trace(G G') / C trace(K) / N)^-1: `N` rows of `C`.
pub fn wiener(g: &[Vec<f64>], k: &[Vec<f64>], alpha: f64) -> Vec<Vec<f64>> {
    let kg = product(k, &transposed(g));
    let mut m = product(g, &kg);
    let apart: f64 = g.iter().map(|row| dot(row, row)).sum::<f64>() / g.len() as f64;
    let variance = apart * (0..k.len()).map(|n| k[n][n]).sum::<f64>() / k.len() as f64;
    (0..m.len()).for_each(|c| m[c][c] += alpha * variance);
    // M is symmetric: S M = K G' is M S' = G K.
    transposed(&solve(m, transposed(&kg)))
}

/// s >= 0 with the least |G s - c|^2 + alpha trace(G G') / C |s|^2, one bin after the other until nothing
/// moves.
pub fn nonnegative(g: &[Vec<f64>], c: &[f64], alpha: f64) -> Vec<f64> {
    let damping = alpha * g.iter().map(|row| dot(row, row)).sum::<f64>() / g.len() as f64;
    let columns = transposed(g);
    let mut s = vec![0.0; columns.len()];
    let mut rest = c.to_vec();
    for _ in 0..200_000 {
        let mut moved = 0.0f64;
        for (value, column) in s.iter_mut().zip(&columns) {
            let better =
                (*value + (dot(column, &rest) - damping * *value) / (dot(column, column) + damping)).max(0.0);
            let step = better - *value;
            rest.iter_mut().zip(column).for_each(|(rest, g)| *rest -= step * g);
            moved = moved.max(step.abs());
            *value = better;
        }
        if moved <= 1e-13 * s.iter().cloned().fold(0.0, f64::max) {
            break;
        }
    }
    s
}

/// The largest over the smallest singular value of `a`: eigenvalues of A' A by Jacobi's rotations.
pub fn condition(a: &[Vec<f64>]) -> f64 {
    let mut m = product(&transposed(a), a);
    let n = m.len();
    for _ in 0..60 {
        for p in 0..n {
            for q in p + 1..n {
                let angle = 0.5 * (2.0 * m[p][q]).atan2(m[q][q] - m[p][p]);
                let (s, c) = angle.sin_cos();
                for row in &mut m {
                    (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
                }
                let (row_p, row_q) = (m[p].clone(), m[q].clone());
                m[p] = row_p.iter().zip(&row_q).map(|(a, b)| c * a - s * b).collect();
                m[q] = row_p.iter().zip(&row_q).map(|(a, b)| s * a + c * b).collect();
            }
        }
    }
    let values: Vec<f64> = (0..n).map(|k| m[k][k]).collect();
    (values.iter().cloned().fold(0.0, f64::max) / values.iter().cloned().fold(f64::MAX, f64::min)).sqrt()
}

/// Columns of length 1.
pub fn equal_columns(a: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let mut columns = transposed(a);
    for column in &mut columns {
        let length = dot(column, column).sqrt();
        column.iter_mut().for_each(|v| *v /= length);
    }
    transposed(&columns)
}

/// Pixel counts, spread evenly over each pixel, into bins between `edges`: every pixel against every bin.
pub fn rebinned(pixel_edges: &[f64], counts: &[f64], edges: &[f64]) -> Vec<f64> {
    edges
        .windows(2)
        .map(|bin| {
            pixel_edges
                .windows(2)
                .zip(counts)
                .map(|(pixel, count)| {
                    let overlap = pixel[1].min(bin[1]) - pixel[0].max(bin[0]);
                    count * overlap.max(0.0) / (pixel[1] - pixel[0])
                })
                .sum()
        })
        .collect()
}
