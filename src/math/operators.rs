//! Macros that make families of operators from one formula, so that values and references compute alike.

/// Makes a binary operator from a formula of two references: `a + b`, `a + &b`, `&a + b` and `&a + &b`.
macro_rules! operator {
    ([$($of:tt)*] $op:ident $method:ident |$x:ident: $a:ty, $y:ident: $b:ty| -> $out:ty $formula:block) => {
        impl<$($of)*> core::ops::$op<$b> for $a {
            type Output = $out;
            #[inline]
            fn $method(self, other: $b) -> $out {
                let ($x, $y) = (&self, &other);
                $formula
            }
        }

        impl<$($of)*> core::ops::$op<&$b> for $a {
            type Output = $out;
            #[inline]
            fn $method(self, $y: &$b) -> $out {
                let $x = &self;
                $formula
            }
        }

        impl<$($of)*> core::ops::$op<$b> for &$a {
            type Output = $out;
            #[inline]
            fn $method(self, other: $b) -> $out {
                let ($x, $y) = (self, &other);
                $formula
            }
        }

        impl<$($of)*> core::ops::$op<&$b> for &$a {
            type Output = $out;
            #[inline]
            fn $method(self, $y: &$b) -> $out {
                let $x = self;
                $formula
            }
        }
    };
}
pub(crate) use operator;

/// Makes a binary operator whose result has the type on the left, and its assigning form: `a += b`,
/// `a += &b`.
macro_rules! assigning_operator {
    ([$($of:tt)*] $op:ident $method:ident $assign:ident $assign_method:ident
     |$x:ident: $a:ty, $y:ident: $b:ty| $formula:block) => {
        $crate::math::operator! { [$($of)*] $op $method |$x: $a, $y: $b| -> $a $formula }

        impl<$($of)*> core::ops::$assign<$b> for $a {
            #[inline]
            fn $assign_method(&mut self, other: $b) {
                let ($x, $y) = (&*self, &other);
                *self = $formula;
            }
        }

        impl<$($of)*> core::ops::$assign<&$b> for $a {
            #[inline]
            fn $assign_method(&mut self, $y: &$b) {
                let $x = &*self;
                *self = $formula;
            }
        }
    };
}
pub(crate) use assigning_operator;

/// Makes the operators of a linear space: `+` and `-`, products with and quotients by plain numbers, unary
/// minus, the assigning forms, and sums of iterators.
macro_rules! linear_operators {
    ([$($of:tt)*] $type:ty, $zero:expr;
     |$x:ident, $y:ident| $add:block $sub:block $times:block $over:block $minus:block) => {
        $crate::math::assigning_operator! { [$($of)*] Add add AddAssign add_assign |$x: $type, $y: $type| $add }
        $crate::math::assigning_operator! { [$($of)*] Sub sub SubAssign sub_assign |$x: $type, $y: $type| $sub }
        $crate::math::assigning_operator! { [$($of)*] Mul mul MulAssign mul_assign |$x: $type, $y: f32| $times }
        $crate::math::assigning_operator! { [$($of)*] Div div DivAssign div_assign |$x: $type, $y: f32| $over }
        $crate::math::operator! { [$($of)*] Mul mul |$y: f32, $x: $type| -> $type $times }

        impl<$($of)*> core::ops::Neg for $type {
            type Output = Self;
            #[inline]
            fn neg(self) -> Self {
                let $x = &self;
                $minus
            }
        }

        impl<$($of)*> core::ops::Neg for &$type {
            type Output = $type;
            #[inline]
            fn neg(self) -> $type {
                let $x = self;
                $minus
            }
        }

        impl<$($of)*> core::iter::Sum for $type {
            fn sum<I: Iterator<Item = Self>>(parts: I) -> Self {
                parts.fold($zero, |sum, part| sum + part)
            }
        }

        impl<'a, $($of)*> core::iter::Sum<&'a Self> for $type {
            fn sum<I: Iterator<Item = &'a Self>>(parts: I) -> Self {
                parts.fold($zero, |sum, part| sum + part)
            }
        }
    };
}
pub(crate) use linear_operators;
