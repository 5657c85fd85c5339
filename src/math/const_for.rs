//! A loop for `const fn`, where Rust has no `for` yet.

/// Evaluates the body of `const_for!(0..N, |k| body)` for each `k` of the range. The body is not a closure:
/// it is part of the function that it stands in.
macro_rules! const_for {
    ($range:expr, |$k:ident| $body:expr) => {{
        let core::ops::Range { start: mut $k, end } = $range;
        while $k < end {
            $body;
            $k += 1;
        }
    }};
}
pub(crate) use const_for;
