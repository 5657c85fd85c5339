//! What plain and polarized light on their way have in common.

/// A type that holds a path `P`: how it is made of one (`|path| value`), goes on, and what it costs.
macro_rules! on_its_way {
    ([$($generics:ident),*] $light:ty, |$path:ident| $new:expr) => {
        impl<$($generics),*> $light {
            /// Light that comes by way of `path`, any [`Stimulus`](crate::observer::Stimulus) or
            /// [`StokesPath`](crate::path::StokesPath): for a path that begins with something of your own.
            #[must_use]
            #[inline]
            pub const fn new($path: P) -> Self {
                $new
            }

            /// Takes the path out again, for a [`Surface`] or a [`Filter`] of your own.
            #[must_use]
            #[inline]
            pub fn into_inner(self) -> P {
                self.0
            }

            /// This light behind a filter. (Colored glass dims all polarizations alike.)
            #[must_use]
            #[inline]
            pub fn through<F: Filter<Self>>(self, filter: F) -> F::Leaving {
                filter.transmit(self)
            }

            /// What a surface sends back of this light: polarized light off a mirror, plain light off a matt
            /// surface.
            #[must_use]
            #[inline]
            pub fn onto<S: Surface<Self>>(self, surface: S) -> S::Leaving {
                surface.reflect(self)
            }

            /// The price of working out this path once.
            #[must_use]
            pub const fn price(&self) -> Price
            where
                P: Priced,
            {
                P::PRICE
            }

            /// This path, if it takes at most `MULTIPLY_ADDS` multiplications; a longer one does not compile
            /// (it is `cargo build` that says so, and `cargo check` does not).
            ///
            /// ```
            /// # use nanospectra::{Light, Reflectance};
            /// # let (sun, paper) = (Light::<31>::flat(1.0), Reflectance::flat(0.8));
            /// let path = sun.onto(&paper).within::<31>(); // within::<30>() does not compile
            /// ```
            #[must_use]
            #[inline]
            pub fn within<const MULTIPLY_ADDS: usize>(self) -> Self
            where
                P: Priced,
            {
                const {
                    assert!(P::PRICE.multiply_adds <= MULTIPLY_ADDS, "this path takes more multiply-adds than it may")
                }
                self
            }
        }

        impl<$($generics),*> Priced for $light
        where
            P: Priced,
        {
            const PRICE: Price = P::PRICE;
            const AGAIN: usize = P::AGAIN;
        }
    };
}
pub(crate) use on_its_way;
