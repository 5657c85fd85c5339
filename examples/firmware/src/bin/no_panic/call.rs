//! Calls a function with arguments of which the compiler knows nothing but their types.

use core::hint::black_box;

/// A function with arguments of the types `A`.
pub trait Call<A> {
    /// What the function returns.
    type Output;

    fn call(self) -> Self::Output;
}

macro_rules! call_with {
    ($($argument:ident)*) => {
        impl<Of: Fn($($argument),*) -> Out, Out, $($argument),*> Call<($($argument,)*)> for Of {
            type Output = Out;

            fn call(self) -> Out {
                self($(any::<$argument>()),*)
            }
        }
    };
}
call_with!();
call_with!(A);
call_with!(A B);
call_with!(A B C);
call_with!(A B C D);
call_with!(A B C D E);
call_with!(A B C D E F);
call_with!(A B C D E F G);
call_with!(A B C D E F G H);

/// Stands for any value of a type.
fn any<T>() -> T {
    let nowhere = core::ptr::dangling::<T>();
    // SAFETY: there is no value there, but the image is only linked and never run.
    unsafe { black_box(nowhere).read() }
}

/// Calls a function. This is a function of its own for each, so that a symbol names what can panic.
#[inline(never)]
pub fn call<A>(function: impl Call<A>) {
    black_box(function.call());
}

/// Calls the functions with these paths. Where an argument is an `impl Fn` or the like, the path is cast to a
/// function that takes a `fn`.
#[macro_export]
macro_rules! calls {
    [$($function:expr),* $(,)?] => { $($crate::call::call($function);)* };
}
