//! A loop for `const fn`, in which Rust has no `for` yet.

/// `const_for!(0..N, |k| body)`: the body for each `k` of the range. It stands in the function and not in a
/// closure.
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
