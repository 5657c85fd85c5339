//! The simplex method of Nelder and Mead, which finds the least of a function that has no derivatives.

/// A point, and the value of the function there.
pub(super) type Vertex = ([f32; 3], f32);

/// Returns the least that a number of steps finds from `start`, where `widths` are the sizes of the first
/// simplex. Along a width of 0 nothing is searched. The steps end when the value at the worst corner is
/// within this share of that at the best. A value that is NaN counts as larger than any number.
///
/// # Reference
/// J. A. Nelder, R. Mead, "A simplex method for function minimization", The Computer Journal 7 (1965).
pub(super) fn least(
    start: Vertex,
    widths: [f32; 3],
    (steps, share): (usize, f32),
    value: impl Fn(&[f32; 3]) -> f32,
) -> Vertex {
    let mut best = start;
    let mut rest = [best; 3];
    for (k, vertex) in rest.iter_mut().enumerate() {
        for (j, (part, width)) in vertex.0.iter_mut().zip(widths).enumerate() {
            *part += if j == k { width } else { 0.0 };
        }
        vertex.1 = value(&vertex.0);
    }
    for _ in 0..steps {
        for vertex in &mut rest {
            if vertex.1 < best.1 {
                core::mem::swap(vertex, &mut best);
            }
        }
        // The worst, the middle of all others, and the worst of those.
        let (mut worst, mut middle, mut second) = (best, [0.0; 3], f32::NEG_INFINITY);
        for vertex in rest {
            let is_worst = vertex.1.total_cmp(&worst.1).is_gt();
            let other = if is_worst { core::mem::replace(&mut worst, vertex) } else { vertex };
            for (middle, part) in middle.iter_mut().zip(other.0) {
                *middle += part * (1.0 / 3.0);
            }
            second = if other.1 < second { second } else { other.1 };
        }
        if worst.1 - best.1 < share * best.1 {
            break;
        }
        let at = |part: f32| {
            let mut point = middle;
            for (point, worst) in point.iter_mut().zip(worst.0) {
                *point += part * (worst - *point);
            }
            let found = value(&point);
            (point, found)
        };
        let mirrored = at(-1.0);
        let new = if mirrored.1 < best.1 {
            let further = at(-2.0);
            if further.1 < mirrored.1 { further } else { mirrored }
        } else if mirrored.1 < second {
            mirrored
        } else {
            at(if mirrored.1 < worst.1 { -0.5 } else { 0.5 })
        };
        if new.1 < worst.1 {
            if let Some(vertex) = rest.iter_mut().find(|vertex| vertex.0 == worst.0) {
                *vertex = new;
            }
        } else {
            for vertex in &mut rest {
                for (part, best) in vertex.0.iter_mut().zip(best.0) {
                    *part = 0.5 * (*part + best);
                }
                vertex.1 = value(&vertex.0);
            }
        }
    }
    rest.into_iter().fold(best, |best, vertex| if vertex.1 < best.1 { vertex } else { best })
}
