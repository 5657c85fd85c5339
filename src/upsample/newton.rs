//! Newton's method on u = sigma^-1 (responses): the curve whose three responses are those asked for.
//!
//! A response is a = 1/2 + A/2 with A the weighted mean of p / sqrt(1 + p^2), and its slope along q is half
//! the weighted mean of (1 + p^2)^-3/2 times x^2, x and 1: twelve sums over the grid. Sums run through the bins
//! in order, one accumulator each, so a colour alone, in a batch and on any core adds up to the same bits;
//! what is done at once is the twelve of them, or several colours.

use super::rsqrt::{rsqrt, rsqrt_near, unsigmoid};
use super::start::StartMap;

/// For each bin the weight of the three responses, and x.
pub(super) type Rows<const N: usize> = [[f32; 4]; N];

/// For each response: A, and the sums that go with x^2, x and 1.
type Sums = [[f32; 4]; 3];

/// A step that starts with less than this missing, of all three, ends within 3e-6 of the goal, and is the last one.
const NEAR: f32 = 2e-3;
/// The same for curves steeper than any of sRGB, where a step gains less.
const NEAR_IF_STEEP: f32 = 1e-4;
/// Curves with more than this in all three numbers are steep.
const STEEP: f32 = 128.0;
/// Undamped steps; sRGB colours on 31 bands or more need 6 at most.
const STEPS: usize = 8;
/// Damped steps, for what undamped ones do not find.
const DAMPED_STEPS: usize = 40;
/// Responses that are off by less in all are those asked for.
const CLOSE: f32 = 1e-6;
/// The longest damped step from the middle; further out a quarter of the way longer.
const LONGEST: f32 = 8.0;
/// Responses nearer than this to 0 or 1 are not asked for.
const LEAST: f32 = 1e-6;

/// A curve, and where it has not the responses asked for, those it has.
pub(super) type Found = ([f32; 3], Option<[f32; 3]>);

/// Can a curve have these responses, as far as each by itself can say?
#[inline(always)]
fn possible(responses: [f32; 3]) -> bool {
    responses.iter().all(|a| *a > LEAST && *a < 1.0 - LEAST)
}

/// Kept off 0 and 1; NaN stays.
#[inline(always)]
fn within(a: f32) -> f32 {
    a.clamp(LEAST, 1.0 - LEAST)
}

#[inline(always)]
fn goal(responses: [f32; 3]) -> [f32; 3] {
    let mut u = [0.0; 3];
    for (u, a) in u.iter_mut().zip(responses) {
        *u = unsigmoid(within(a));
    }
    u
}

/// The curve of one colour, if undamped steps find it; nothing else, for programs that must be small.
#[inline(always)]
pub(super) fn exact<const N: usize, M: StartMap>(rows: &Rows<N>, responses: [f32; 3]) -> Option<[f32; 3]> {
    if !possible(responses) {
        return None;
    }
    let u = goal(responses);
    let mut q = M::start(u);
    for _ in 0..STEPS {
        let step = step(&one(rows, q), u);
        for (q, step) in q.iter_mut().zip(step.q) {
            *q += step;
        }
        if is_last(&q, &step) {
            return Some(q);
        }
    }
    None
}

/// The curve of one colour.
#[inline(always)]
pub(super) fn solve<const N: usize, M: StartMap>(rows: &Rows<N>, responses: [f32; 3]) -> Found {
    if possible(responses) {
        descend(rows, responses, M::start(goal(responses)), STEPS + DAMPED_STEPS)
    } else {
        damped(rows, responses)
    }
}

/// The curves of several colours, the same bits as one by one.
#[inline(always)]
pub(super) fn solve_some<const L: usize, const N: usize, M: StartMap>(
    rows: &Rows<N>,
    responses: &[[f32; 3]; L],
) -> [Found; L] {
    let (mut u, mut q) = ([[0.0; L]; 3], [[0.0; L]; 3]);
    for l in 0..L {
        let lane = goal(responses[l]);
        let start = M::start(lane);
        (u[0][l], u[1][l], u[2][l]) = (lane[0], lane[1], lane[2]);
        (q[0][l], q[1][l], q[2][l]) = (start[0], start[1], start[2]);
    }
    let mut open = [1.0f32; L];
    for _ in 0..STEPS {
        let [[a0, a1, a2, a3], [b0, b1, b2, b3], [c0, c1, c2, c3]] = &some(rows, &q);
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
    let mut found = [([0.0; 3], None); L];
    for l in 0..L {
        found[l] = if open[l] == 0.0 && possible(responses[l]) {
            ([q[0][l], q[1][l], q[2][l]], None)
        } else {
            damped(rows, responses[l])
        };
    }
    found
}

fn damped<const N: usize>(rows: &Rows<N>, responses: [f32; 3]) -> Found {
    descend(rows, responses, [0.0; 3], DAMPED_STEPS)
}

/// Undamped steps from `q`, then up to forty of limited length from the middle, the best of which is kept.
#[inline(never)]
fn descend<const N: usize>(rows: &Rows<N>, asked: [f32; 3], mut q: [f32; 3], steps: usize) -> Found {
    let u = goal(asked);
    // What is nearest to a colour out of reach is nearest to where its responses leave 0..=1.
    let reachable = asked.map(within);
    let (mut best, mut found) = (f32::INFINITY, (q, Some([0.5; 3])));
    let mut left = steps;
    while left > 0 {
        if left == DAMPED_STEPS {
            q = [0.0; 3];
        }
        let step = step(&one(rows, q), u);
        let [s0, s1, s2] = step.q;
        let mut part = 1.0;
        if left <= DAMPED_STEPS {
            let off = size(&step.responses, &reachable);
            if off < best {
                (best, found) = (off, (q, Some(step.responses)));
            }
            let length = size(&step.q, &[0.0; 3]);
            if !length.is_finite() {
                break;
            }
            let longest = LONGEST + 0.25 * size(&q, &[0.0; 3]);
            if length > longest {
                part = longest / length;
            }
        }
        q = [q[0] + part * s0, q[1] + part * s1, q[2] + part * s2];
        if is_last(&q, &step) && possible(asked) {
            return (q, None);
        }
        left -= 1;
    }
    let (q, given) = found;
    // Steep curves keep wandering by what f32 cannot hold.
    (q, if best < CLOSE && possible(asked) { None } else { given })
}

/// Is the curve, after a step, exact?
#[inline(always)]
fn is_last(q: &[f32; 3], step: &Step) -> bool {
    step.far < if size(q, &[0.0; 3]) > STEEP { NEAR_IF_STEEP } else { NEAR }
}

/// How far apart, over the three; NaN if one is.
#[inline(always)]
fn size([a, b, c]: &[f32; 3], [x, y, z]: &[f32; 3]) -> f32 {
    (a - x).abs() + (b - y).abs() + (c - z).abs()
}

struct Step {
    /// To be added to the curve.
    q: [f32; 3],
    /// How much of u was missing before, over the three; below `NEAR` the curve is exact after.
    far: f32,
    /// The responses before.
    responses: [f32; 3],
}

/// From the sums to the step.
#[inline(always)]
fn step(sums: &Sums, u: [f32; 3]) -> Step {
    let (mut goal, mut responses, mut far) = ([0.0; 3], [0.0; 3], 0.0);
    for k in 0..3 {
        let a = within(0.5 + 0.5 * sums[k][0]);
        // du/da = 1/4 (a (1 - a))^-3/2, and da/dq is half the sum.
        let g = a * (1.0 - a);
        let root = rsqrt(g);
        let missing = u[k] - (a - 0.5) * root;
        goal[k] = 8.0 * missing * (g * g * root);
        responses[k] = a;
        far += missing.abs();
    }
    // Cramer's rule.
    let [[_, a, b, c], [_, d, e, f], [_, g, h, i]] = *sums;
    let (m0, m1, m2) = (e * i - f * h, f * g - d * i, d * h - e * g);
    let per_det = 1.0 / (a * m0 + b * m1 + c * m2);
    let [y0, y1, y2] = goal;
    let q0 = m0 * y0 + (c * h - b * i) * y1 + (b * f - c * e) * y2;
    let q1 = m1 * y0 + (a * i - c * g) * y1 + (c * d - a * f) * y2;
    let q2 = m2 * y0 + (b * g - a * h) * y1 + (a * e - b * d) * y2;
    Step { q: [q0 * per_det, q1 * per_det, q2 * per_det], far, responses }
}

/// The twelve sums of several colours. One loop over the lanes with all that is done for a bin in it: long enough
/// for the compiler to make vectors of it, where loops of one operation each are unrolled to scalars first.
#[inline(always)]
fn some<const L: usize, const N: usize>(rows: &Rows<N>, [q0, q1, q2]: &[[f32; L]; 3]) -> [[[f32; L]; 4]; 3] {
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

/// The twelve sums of one colour, on a core without vectors.
#[cfg(target_os = "none")]
#[inline(always)]
fn one<const N: usize>(rows: &Rows<N>, [q0, q1, q2]: [f32; 3]) -> Sums {
    some(rows, &[[q0], [q1], [q2]]).map(|row| row.map(|[sum]| sum))
}

/// The twelve sums of one colour. First every term, which goes several bins at a time; then the weights of a
/// bin, three in a vector, times each of its terms. (The fourth, x times the term, is not used.)
#[cfg(not(target_os = "none"))]
#[inline(always)]
fn one<const N: usize>(rows: &Rows<N>, [q0, q1, q2]: [f32; 3]) -> Sums {
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
