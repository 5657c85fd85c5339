//! Newton's method, which finds the curve whose three responses are those asked for.
//!
//! The equations are written for u = sigma^-1 (response). A response is a = 1/2 + A/2, where A is the
//! weighted mean of p / sqrt(1 + p^2). Its derivative by q is half the weighted mean of (1 + p^2)^-3/2 times
//! x^2, x and 1. These are twelve sums over the grid.
//!
//! Each sum has one accumulator and runs through the bins in order, so that a color alone, in a batch and on
//! any core has the same bits. Vectors are used for the twelve sums, or for several colors at once.

use crate::upsample::rsqrt::{rsqrt, rsqrt_near, unsigmoid};
use crate::upsample::shape::sigmoid;
use crate::upsample::start::StartMap;

/// The weights of the three responses and x, for each bin.
pub(super) type Rows<const N: usize> = [[f32; 4]; N];

/// A and the sums with x^2, x and 1, for each response.
pub(super) type Sums = [[f32; 4]; 3];

/// A step is the last one if it starts nearer to the goal than this, summed over the three u. It ends within
/// 3e-6 of the goal.
const NEAR: f32 = 2e-3;
/// The same limit for curves that are steeper than any of sRGB, for which a step gains less.
const NEAR_IF_STEEP: f32 = 1e-4;
/// A curve is steep if the sizes of its three numbers add up to more than this. For sRGB they add up to 54 at
/// most.
const STEEP: f32 = 64.0;
/// The largest number of undamped steps. Colors of sRGB on 31 bands or more need 6 at most.
const STEPS: usize = 8;
/// The largest number of damped steps, for colors that undamped steps do not find.
const DAMPED_STEPS: usize = 40;
/// The longest damped step that starts at q = 0. A quarter of the size of q is added to it.
const LONGEST: f32 = 8.0;
/// Responses that are nearer to 0 or 1 than this are replaced by this.
const LEAST: f32 = 1e-6;

/// A curve, and its responses unless they are sure to be those asked for.
pub(super) type Found = ([f32; 3], Option<[f32; 3]>);

/// Returns whether each of these responses, taken by itself, is one that a curve can have.
#[inline(always)]
fn possible(responses: [f32; 3]) -> bool {
    // a (1 - a) is about `LEAST` at that distance from 0 and from 1, and is negative outside.
    responses.iter().all(|a| a * (1.0 - a) > LEAST)
}

/// Returns the response, kept away from 0 and 1. (NaN, which may come from the sums of huge components,
/// becomes a number. No curve has either of them.)
#[inline(always)]
fn within(a: f32) -> f32 {
    let a = if a > LEAST { a } else { LEAST };
    if a < 1.0 - LEAST { a } else { 1.0 - LEAST }
}

#[inline(always)]
fn goal(responses: [f32; 3]) -> [f32; 3] {
    responses.map(|a| unsigmoid(within(a)))
}

/// Returns the curve of one color if undamped steps find it. It does nothing else, for programs that have to
/// be small.
#[inline(always)]
pub(super) fn exact<const N: usize, M: StartMap>(rows: &Rows<N>, responses: [f32; 3]) -> Option<[f32; 3]> {
    if !possible(responses) {
        return None;
    }
    let u = responses.map(unsigmoid);
    let mut q = M::start(u);
    for _ in 0..STEPS {
        let step = step(&sums(rows, q), u);
        for (q, step) in q.iter_mut().zip(step.q) {
            *q += step;
        }
        if is_last(&q, &step) {
            return Some(q);
        }
    }
    None
}

/// Returns the curve of one color, if undamped or damped steps find it.
#[inline(always)]
pub(super) fn solve<const N: usize, M: StartMap>(rows: &Rows<N>, responses: [f32; 3]) -> Option<Found> {
    match exact::<N, M>(rows, responses) {
        Some(q) => Some(settled(rows, q)),
        None => damped(rows, responses),
    }
}

/// Returns the curves of several colors, with the same bits as one by one.
#[inline(always)]
pub(super) fn solve_some<const L: usize, const N: usize, M: StartMap>(
    rows: &Rows<N>,
    responses: &[[f32; 3]; L],
) -> [Option<Found>; L] {
    let (mut u, mut q) = ([[0.0; L]; 3], [[0.0; L]; 3]);
    for l in 0..L {
        let lane = goal(responses[l]);
        let start = M::start(lane);
        (u[0][l], u[1][l], u[2][l]) = (lane[0], lane[1], lane[2]);
        (q[0][l], q[1][l], q[2][l]) = (start[0], start[1], start[2]);
    }
    let mut open = [1.0f32; L];
    for _ in 0..STEPS {
        let [[a0, a1, a2, a3], [b0, b1, b2, b3], [c0, c1, c2, c3]] = &sums_of_lanes(rows, &q);
        let ([u0, u1, u2], [q0, q1, q2]) = (&u, &mut q);
        for l in 0..L {
            let sums =
                [[a0[l], a1[l], a2[l], a3[l]], [b0[l], b1[l], b2[l], b3[l]], [c0[l], c1[l], c2[l], c3[l]]];
            let step = step(&sums, [u0[l], u1[l], u2[l]]);
            let [s0, s1, s2] = step.q;
            (q0[l], q1[l], q2[l]) =
                if open[l] > 0.0 { (q0[l] + s0, q1[l] + s1, q2[l] + s2) } else { (q0[l], q1[l], q2[l]) };
            open[l] = if is_last(&[q0[l], q1[l], q2[l]], &step) { 0.0 } else { open[l] };
        }
        if open == [0.0; L] {
            break;
        }
    }
    let mut found = [None; L];
    for l in 0..L {
        found[l] = if open[l] == 0.0 && possible(responses[l]) {
            Some(settled(rows, [q[0][l], q[1][l], q[2][l]]))
        } else {
            damped(rows, responses[l])
        };
    }
    found
}

/// Returns the curve that up to forty steps of limited length find from q = 0.
#[inline(never)]
fn damped<const N: usize>(rows: &Rows<N>, asked: [f32; 3]) -> Option<Found> {
    if !possible(asked) {
        return None;
    }
    let (u, mut q) = (goal(asked), [0.0; 3]);
    for _ in 0..DAMPED_STEPS {
        let step = step(&sums(rows, q), u);
        let (length, longest) = (size(&step.q), LONGEST + 0.25 * size(&q));
        if !length.is_finite() {
            break;
        }
        let part = if length > longest { longest / length } else { 1.0 };
        for (q, step) in q.iter_mut().zip(step.q) {
            *q += part * step;
        }
        if is_last(&q, &step) {
            return Some(settled(rows, q));
        }
    }
    None
}

/// Returns a curve after its last step. The responses of a steep curve may be off by rounding in f32, and
/// those on few bands by what the last step leaves, so for these the responses are computed.
#[inline(always)]
fn settled<const N: usize>(rows: &Rows<N>, q: [f32; 3]) -> Found {
    (q, if N < 16 || size(&q) > STEEP { Some(responses(rows, q)) } else { None })
}

/// Returns the responses of a curve. Small ones are exact to their last digits.
#[inline(never)]
pub(super) fn responses<const N: usize>(rows: &Rows<N>, [q0, q1, q2]: [f32; 3]) -> [f32; 3] {
    let mut sums = [0.0; 3];
    for [w0, w1, w2, x] in rows {
        let share = sigmoid((q0 * x + q1) * x + q2);
        sums = [sums[0] + w0 * share, sums[1] + w1 * share, sums[2] + w2 * share];
    }
    sums
}

/// Returns whether the curve is exact after this step.
#[inline(always)]
fn is_last(q: &[f32; 3], step: &Step) -> bool {
    step.far < if size(q) > STEEP { NEAR_IF_STEEP } else { NEAR }
}

/// Returns the sum of the absolute values of all three, which is NaN if one of them is.
#[inline(always)]
fn size([a, b, c]: &[f32; 3]) -> f32 {
    a.abs() + b.abs() + c.abs()
}

struct Step {
    /// The numbers that are added to the curve.
    q: [f32; 3],
    /// The distance to the goal before the step, summed over the three u. If it is below `NEAR`, the curve is
    /// exact after the step.
    far: f32,
}

/// Returns the step that follows from the sums.
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
fn step(sums: &Sums, u: [f32; 3]) -> Step {
    let (mut goal, mut far) = ([0.0; 3], 0.0);
    for k in 0..3 {
        let a = within(0.5 + 0.5 * sums[k][0]);
        // The derivative du/da is 1/4 (a (1 - a))^-3/2, and da/dq is half the sum.
        let g = a * (1.0 - a);
        let root = rsqrt(g);
        let missing = u[k] - (a - 0.5) * root;
        goal[k] = 8.0 * missing * (g * g * root);
        far += missing.abs();
    }
    let [[_, a, b, c], [_, d, e, f], [_, g, h, i]] = *sums;
    Step { q: solved(&[[a, b, c], [d, e, f], [g, h, i]], goal), far }
}

/// Solves three linear equations by Cramer's rule.
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
fn solved([[a, b, c], [d, e, f], [g, h, i]]: &[[f32; 3]; 3], [y0, y1, y2]: [f32; 3]) -> [f32; 3] {
    let (m0, m1, m2) = (e * i - f * h, f * g - d * i, d * h - e * g);
    let per_det = 1.0 / (a * m0 + b * m1 + c * m2);
    let q0 = m0 * y0 + (c * h - b * i) * y1 + (b * f - c * e) * y2;
    let q1 = m1 * y0 + (a * i - c * g) * y1 + (c * d - a * f) * y2;
    let q2 = m2 * y0 + (b * g - a * h) * y1 + (a * e - b * d) * y2;
    [q0 * per_det, q1 * per_det, q2 * per_det]
}

/// Returns the twelve sums of several colors. The loop over the lanes holds all that is done for a bin: the
/// compiler makes vectors of such a loop, while it would unroll loops of one operation each to scalars.
#[inline(always)]
fn sums_of_lanes<const L: usize, const N: usize>(
    rows: &Rows<N>,
    [q0, q1, q2]: &[[f32; L]; 3],
) -> [[[f32; L]; 4]; 3] {
    let mut sums = [[[0.0; L]; 4]; 3];
    let [[a0, a1, a2, a3], [b0, b1, b2, b3], [c0, c1, c2, c3]] = &mut sums;
    for [w0, w1, w2, x] in rows {
        for l in 0..L {
            let p = (q0[l] * x + q1[l]) * x + q2[l];
            let r = rsqrt_near(p * p + 1.0);
            let (t0, d0) = (p * r, r * r * r);
            let d1 = d0 * x;
            let d2 = d1 * x;
            a0[l] += t0 * w0;
            a1[l] += d2 * w0;
            a2[l] += d1 * w0;
            a3[l] += d0 * w0;
            b0[l] += t0 * w1;
            b1[l] += d2 * w1;
            b2[l] += d1 * w1;
            b3[l] += d0 * w1;
            c0[l] += t0 * w2;
            c1[l] += d2 * w2;
            c2[l] += d1 * w2;
            c3[l] += d0 * w2;
        }
    }
    sums
}

/// Returns the twelve sums of one color, on targets without vectors.
#[cfg(any(target_os = "none", all(target_arch = "wasm32", not(target_feature = "simd128"))))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
pub(super) fn sums<const N: usize>(rows: &Rows<N>, [q0, q1, q2]: [f32; 3]) -> Sums {
    sums_of_lanes(rows, &[[q0], [q1], [q2]]).map(|row| row.map(|[sum]| sum))
}

/// Returns the twelve sums of one color. First all terms are computed, several bins at a time. Then the
/// weights of a bin, three in a vector, are multiplied by each of its terms. (The fourth product, x times the
/// term, is not used.)
#[cfg(not(any(target_os = "none", all(target_arch = "wasm32", not(target_feature = "simd128")))))]
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
pub(super) fn sums<const N: usize>(rows: &Rows<N>, [q0, q1, q2]: [f32; 3]) -> Sums {
    let mut terms = [[0.0; N]; 4];
    let [t0, t1, t2, t3] = &mut terms;
    let places = t0.iter_mut().zip(t1).zip(t2).zip(t3);
    for ((((t0, t1), t2), t3), [.., x]) in places.zip(rows) {
        let p = (q0 * *x + q1) * *x + q2;
        let r = rsqrt_near(p * p + 1.0);
        let d0 = r * r * r;
        let d1 = d0 * *x;
        (*t0, *t1, *t2, *t3) = (p * r, d1 * *x, d1, d0);
    }
    let [mut s0, mut s1, mut s2, mut s3] = [[0.0f32; 4]; 4];
    let [t0, t1, t2, t3] = &terms;
    for ((((t0, t1), t2), t3), row) in t0.iter().zip(t1).zip(t2).zip(t3).zip(rows) {
        for k in 0..4 {
            s0[k] += t0 * row[k];
            s1[k] += t1 * row[k];
            s2[k] += t2 * row[k];
            s3[k] += t3 * row[k];
        }
    }
    [0, 1, 2].map(|k| [s0[k], s1[k], s2[k], s3[k]])
}
