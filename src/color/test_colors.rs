//! X, Y, Z of the CIE 13.3 test colors under a light, and under its reference.
//!
//! In the order of the standard, the samples, which are tabulated every 5 nm, are interpolated to 1 nm by
//! Sprague's method and then summed: 45 sums of 471 products. Here the transpose of the interpolation is
//! applied to the product of light and color-matching function, once for all samples, which takes it to the
//! 5 nm nodes. Then each sum has 99 products. The results are the same but for rounding, for half of the
//! work, and the samples take 6 KB in place of 28.
//!
//! A reference light is a weighted sum of a few spectra: three for daylight, a Chebyshev series of ten for a
//! black body. The colors under it are the same weighted sum of the colors under those spectra, which the
//! compiler computes.

use crate::light::{S0, S1, S2, daylight_factors};
use crate::math::const_for;
use crate::observer::{CIE_1931, FineObserver};
use crate::spectrum::{BEYOND, Factor, Fine, Power, quintic};
use crate::test_samples::{TCS, TCS_5NM};

include!(concat!(env!("OUT_DIR"), "/reference.rs"));

/// X, Y and Z of the 15 samples, and of the white as the last.
pub(super) type Colors = [[f32; 16]; 3];

/// The number of nodes every 5 nm from 350 to 840 nm, two beyond each end of the CIE's range.
const NODES: usize = 99;

/// The samples at the nodes. The two beyond each end hold what the boundary formula of the interpolation
/// assumes there.
static SAMPLES: [[f32; 16]; NODES] = {
    let mut samples = [[1.0; 16]; NODES];
    const_for!(0..15, |k| {
        let at = TCS_5NM[k].values();
        const_for!(0..95, |node| samples[node + 2][k] = at[node]);
        const_for!(0..2, |step| {
            let (mut before, mut after) = (0.0, 0.0);
            const_for!(0..6, |i| {
                before += BEYOND[step][i] as f64 * at[i] as f64;
                after += BEYOND[step][i] as f64 * at[94 - i] as f64;
            });
            samples[1 - step][k] = before as f32;
            samples[97 + step][k] = after as f32;
        });
    });
    samples
};

/// The weights that the interpolation gives to the six nodes around, for 1 to 4 nm after a node.
const SHARES: [[f32; 6]; 4] = [quintic(0.2), quintic(0.4), quintic(0.6), quintic(0.8)];

/// How many nodes are computed at a time.
const BLOCK: usize = 33;

/// Computes the colors under a light.
///
/// Light and color-matching function are multiplied at each nanometer, and the products are distributed to
/// the nodes by the weights of the interpolation. A cell holds the products at a node and at the 4 nm after
/// it. Only the cells of one block of nodes are kept, and before them the last five of the block before,
/// which are zeros at first.
pub(super) fn under(light: &Fine<Power>) -> Colors {
    let mut colors = [[0.0; 16]; 3];
    for (sums, row) in colors.iter_mut().zip(CIE_1931.weights()) {
        let mut cells = [[0.0; 5]; BLOCK + 5];
        let (mut lights, mut rows) = (light.values().chunks(5 * BLOCK), row.chunks(5 * BLOCK));
        for samples in SAMPLES.as_chunks::<BLOCK>().0 {
            // (A zip of chunks would divide by their size, and keep the code for a panic if that were 0.)
            let (Some(light), Some(row)) = (lights.next(), rows.next()) else { break };
            cells.copy_within(BLOCK.., 0);
            let [_, _, _, _, _, fresh @ ..] = &mut cells;
            let fresh = fresh.as_flattened_mut();
            for (product, (light, row)) in fresh.iter_mut().zip(light.iter().zip(row)) {
                *product = light * row;
            }
            // Beyond the end of the light there is nothing.
            if let Some(rest) = fresh.get_mut(light.len()..) {
                rest.fill(0.0);
            }
            // Sums of eleven nodes are added up: a hundred terms one after the other would lose digits.
            let nodes = on_nodes(&cells);
            for (samples, at) in samples.as_chunks::<11>().0.iter().zip(nodes.as_chunks::<11>().0) {
                let mut part = [0.0; 16];
                samples.iter().zip(at).for_each(|(sample, at)| add(&mut part, *at, sample));
                add(sums, 1.0, &part);
            }
        }
    }
    colors
}

/// Sums what the six cells around each node give to it: node `k` is that of cell `k` + 3.
///
/// (Inlined, it would not have the registers that the caller's sums are in.)
#[inline(never)]
fn on_nodes(cells: &[[f32; 5]; BLOCK + 5]) -> [f32; BLOCK] {
    let mut nodes = [0.0; BLOCK];
    for (node, near) in nodes.iter_mut().zip(cells.windows(6)) {
        let [[_, a @ ..], [_, b @ ..], [_, c @ ..], [at_node, d @ ..], [_, e @ ..], [_, f @ ..]] = near
        else {
            continue;
        };
        let mut sum = *at_node;
        for ((((((shares, a), b), c), d), e), f) in SHARES.iter().zip(a).zip(b).zip(c).zip(d).zip(e).zip(f) {
            let [of_f, of_e, of_d, of_c, of_b, of_a] = shares;
            sum = sum + of_f * f + of_e * e + of_d * d + of_c * c + of_b * b + of_a * a;
        }
        *node = sum;
    }
    nodes
}

/// Computes the colors under the reference light of this temperature: a black body below 5000 K, CIE
/// daylight from there.
pub(super) fn under_reference(cct_k: f32) -> Colors {
    if cct_k < 5000.0 {
        let mired = 1e6 / cct_k;
        let ([cool, warm], [cool_colors, warm_colors]) = (HALVES, &BLACK_BODY_COLORS);
        let ((middle, half), series) =
            if mired < cool.0 + cool.1 { (cool, cool_colors) } else { (warm, warm_colors) };
        mixed(&chebyshev((mired - middle) / half), series)
    } else {
        let [m1, m2] = daylight_factors(cct_k);
        mixed(&[1.0, m1, m2], &DAYLIGHT_COLORS)
    }
}

/// Computes the Chebyshev polynomials T0 to T9.
fn chebyshev(x: f32) -> [f32; TERMS] {
    let (mut this, mut next) = (1.0, x);
    [(); TERMS].map(|()| {
        let term = this;
        (this, next) = (next, 2.0 * x * next - this);
        term
    })
}

/// Returns the weighted sum of the colors under several lights.
fn mixed(shares: &[f32], parts: &[Colors]) -> Colors {
    let mut sum = [[0.0; 16]; 3];
    for (share, part) in shares.iter().zip(parts).rev() {
        for (sum, part) in sum.iter_mut().zip(part) {
            add(sum, *share, part);
        }
    }
    sum
}

#[inline]
fn add(sum: &mut [f32; 16], share: f32, part: &[f32; 16]) {
    for (sum, part) in sum.iter_mut().zip(part) {
        *sum += share * part;
    }
}

static BLACK_BODY_COLORS: [[Colors; TERMS]; 2] =
    [colors(&BLACK_BODIES[0], &CIE_1931, &TCS), colors(&BLACK_BODIES[1], &CIE_1931, &TCS)];

static DAYLIGHT_COLORS: [Colors; 3] = {
    let parts = [S0, S1, S2];
    let mut lights = [[0.0; 471]; 3];
    const_for!(0..3, |m| {
        let fine: Fine<Power> = parts[m].fine();
        const_for!(0..471, |nm| lights[m][nm] = fine.values()[nm] as f64);
    });
    colors(&lights, &CIE_1931, &TCS)
};

/// Computes the colors under given lights by sums over every nanometer, in f64 while compiling.
const fn colors<const M: usize>(
    lights: &[[f64; 471]; M],
    eye: &FineObserver<3>,
    samples: &[Fine<Factor>; 15],
) -> [Colors; M] {
    let mut colors = [[[0.0; 16]; 3]; M];
    const_for!(0..M, |m| {
        const_for!(0..3, |c| {
            const_for!(0..16, |k| {
                let mut sum = 0.0;
                const_for!(0..471, |nm| {
                    let share = if k < 15 { samples[k].values()[nm] as f64 } else { 1.0 };
                    sum += lights[m][nm] * eye.weights()[c][nm] as f64 * share;
                });
                colors[m][c][k] = sum as f32;
            });
        });
    });
    colors
}
