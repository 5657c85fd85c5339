//! The functions that plain and polarized light have in common.

/// Gives a type that holds a path `P` its functions and its price; `|path| value` says how the type is made
/// of a path.
macro_rules! on_its_way {
    ([$($generics:ident),*] $light:ty, |$path:ident| $new:expr) => {
        impl<$($generics),*> $light {
            /// Returns this light after it has gone through a filter.
            ///
            /// Colored glass, a spectrum of factors, dims all polarizations alike. See the
            /// [example](crate::path#example).
            #[must_use]
            #[inline]
            pub fn through<F: Filter<Self>>(self, filter: F) -> F::Leaving {
                filter.transmit(self)
            }

            /// Returns the light that a surface sends back when this light falls on it.
            ///
            /// A mirror sends back polarized light, and a matt surface unpolarized light. See the
            /// [example](crate::path#example).
            #[must_use]
            #[inline]
            pub fn onto<S: Surface<Self>>(self, surface: S) -> S::Leaving {
                surface.reflect(self)
            }

            /// Returns the price that is paid to compute all bins of this path once.
            ///
            /// See the [example](crate::path::Priced#example).
            #[must_use]
            pub const fn price(&self) -> Price
            where
                P: Priced,
            {
                P::PRICE
            }

            /// Returns this path unchanged, and stops the build if it takes more than `MULTIPLY_ADDS`
            /// multiplications.
            ///
            /// `cargo build` reports a path that takes more; `cargo check` does not.
            ///
            /// ```
            /// # use nanospectra::{Light, Reflectance};
            /// # let (sun, paper) = (Light::<31>::flat(1.0), Reflectance::flat(0.8));
            /// let path = sun.onto(&paper).within::<31>(); // within::<30>() does not compile
            /// assert_eq!(path.price().multiply_adds, 31);
            /// ```
            #[must_use]
            #[inline]
            pub fn within<const MULTIPLY_ADDS: usize>(self) -> Self
            where
                P: Priced,
            {
                const {
                    assert!(
                        P::PRICE.multiply_adds <= MULTIPLY_ADDS,
                        "this path takes more multiply-adds than it may"
                    )
                }
                self
            }

            /// Starts a path with light of a type of your own, or continues one after a stage of your own.
            ///
            /// `path` is any [`Stimulus`](crate::observer::Stimulus) for [`Plain`](crate::path::Plain) light
            /// and any [`StokesPath`](crate::path::StokesPath) for [`Stokes`](crate::path::Stokes) light. A
            /// path that starts with a spectrum does not need this: call `onto` or `through` of the spectrum.
            #[must_use]
            #[inline]
            pub const fn new($path: P) -> Self {
                $new
            }

            /// Returns the stages as a value of their own type, for a [`Surface`] or a [`Filter`] of your
            /// own.
            #[must_use]
            #[inline]
            pub fn into_inner(self) -> P {
                self.0
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
