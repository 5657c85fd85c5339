//! The functions by the station of light that they belong to.

use crate::call::{Call, call};
use core::hint::black_box;
use core::iter::Sum;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// Calls a function that returns an iterator, and takes all that the iterator yields.
#[inline(never)]
fn walk<A, I: Iterator>(function: impl Call<A, Output = I>) {
    for item in function.call() {
        black_box(item);
    }
}

/// Calls the functions with these paths, which return iterators.
macro_rules! walks {
    [$($function:expr),* $(,)?] => { $(crate::of::walk($function);)* };
}

/// Calls the operators of types that can be added, subtracted, and multiplied with and divided by numbers.
macro_rules! operators {
    [$($type:ty),* $(,)?] => { $(crate::of::operators::<$type>();)* };
}

fn operators<T>()
where
    T: Add<Output = T> + Sub<Output = T> + Neg<Output = T> + AddAssign + SubAssign + Sum,
    T: Mul<f32, Output = T> + Div<f32, Output = T> + MulAssign<f32> + DivAssign<f32>,
{
    call(T::add);
    call(T::sub);
    call(T::neg);
    call(T::add_assign);
    call(T::sub_assign);
    call(T::mul);
    call(T::div);
    call(T::mul_assign);
    call(T::div_assign);
    call(T::sum::<core::array::IntoIter<T, 4>>);
}

/// The names in the lists: the modules of the library, and types for the parameters of its functions.
mod names {
    pub use crate::calls;
    pub use nanospectra::math::Fast;
    pub use nanospectra::*;

    pub type G = Bins<380, 730>;
    pub type H = Nodes<400, 700>;
    /// Light on its way, not polarized and polarized.
    pub type Lit = path::Plain<Power, &'static Light<31>>;
    pub type Pol = path::Stokes<path::Natural<&'static Light<31>>>;
}

mod color;
mod geometry;
mod light;
mod math;
mod matter;
mod observer;
mod path;
mod radiometry;
mod sensor;
mod spectrum;
mod upsample;

pub fn all() {
    color::all();
    geometry::all();
    light::all();
    math::all();
    matter::all();
    observer::all();
    path::all();
    radiometry::all();
    sensor::all();
    spectrum::all();
    upsample::all();
}
