//! What [`Octuple`](crate::Octuple) and [`Single`](crate::Single) have in common: the operators, the traits of
//! num-traits and `num_dual::DualNum`, all in terms of the inner float and a set of functions on it.
//!
//! The invariant behind every impl: an operation of the newtype is exactly one operation of the inner float, after any
//! `f64` operand has gone through `From<f64>`.

pub(crate) mod spherical_bessel;

/// `$Op` of the newtype with itself, by value and by reference, and with `f64`; `$OpAssign` likewise. Each calls
/// `$function` on the two inner floats.
macro_rules! newtype_operator {
    ($type:ident, $op:ident, $method:ident, $op_assign:ident, $method_assign:ident, $function:path) => {
        impl ::std::ops::$op for $type {
            type Output = $type;
            #[inline]
            fn $method(self, rhs: $type) -> $type {
                $type($function(self.0, rhs.0))
            }
        }
        impl ::std::ops::$op<&$type> for $type {
            type Output = $type;
            #[inline]
            fn $method(self, rhs: &$type) -> $type {
                ::std::ops::$op::$method(self, *rhs)
            }
        }
        impl ::std::ops::$op<$type> for &$type {
            type Output = $type;
            #[inline]
            fn $method(self, rhs: $type) -> $type {
                ::std::ops::$op::$method(*self, rhs)
            }
        }
        impl ::std::ops::$op<&$type> for &$type {
            type Output = $type;
            #[inline]
            fn $method(self, rhs: &$type) -> $type {
                ::std::ops::$op::$method(*self, *rhs)
            }
        }
        impl ::std::ops::$op<f64> for $type {
            type Output = $type;
            #[inline]
            fn $method(self, rhs: f64) -> $type {
                ::std::ops::$op::$method(self, $type::from(rhs))
            }
        }
        impl ::std::ops::$op_assign for $type {
            #[inline]
            fn $method_assign(&mut self, rhs: $type) {
                *self = ::std::ops::$op::$method(*self, rhs);
            }
        }
        impl ::std::ops::$op_assign<f64> for $type {
            #[inline]
            fn $method_assign(&mut self, rhs: f64) {
                *self = ::std::ops::$op::$method(*self, rhs);
            }
        }
    };
}

/// Operators, comparisons with `f64`, and the traits of num-traits except `FromPrimitive`.
///
/// `$type` is a tuple struct around `$float`, with `From<f64>` and `FromStr<Err = ParseFloatError>`.
macro_rules! newtype_number {
    ($type:ident($float:ty), zero: $zero:expr, one: $one:expr, rem: $rem:path) => {
        $crate::number::newtype::newtype_operator!($type, Add, add, AddAssign, add_assign, ::std::ops::Add::add);
        $crate::number::newtype::newtype_operator!($type, Sub, sub, SubAssign, sub_assign, ::std::ops::Sub::sub);
        $crate::number::newtype::newtype_operator!($type, Mul, mul, MulAssign, mul_assign, ::std::ops::Mul::mul);
        $crate::number::newtype::newtype_operator!($type, Div, div, DivAssign, div_assign, ::std::ops::Div::div);
        $crate::number::newtype::newtype_operator!($type, Rem, rem, RemAssign, rem_assign, $rem);

        impl ::std::ops::Neg for $type {
            type Output = $type;
            #[inline]
            fn neg(self) -> $type {
                $type(-self.0)
            }
        }
        impl ::std::ops::Neg for &$type {
            type Output = $type;
            #[inline]
            fn neg(self) -> $type {
                -*self
            }
        }

        impl PartialEq<f64> for $type {
            #[inline]
            fn eq(&self, other: &f64) -> bool {
                *self == Self::from(*other)
            }
        }
        impl PartialOrd<f64> for $type {
            #[inline]
            fn partial_cmp(&self, other: &f64) -> Option<::std::cmp::Ordering> {
                self.partial_cmp(&Self::from(*other))
            }
            #[inline]
            fn lt(&self, other: &f64) -> bool {
                *self < Self::from(*other)
            }
            #[inline]
            fn le(&self, other: &f64) -> bool {
                *self <= Self::from(*other)
            }
            #[inline]
            fn gt(&self, other: &f64) -> bool {
                *self > Self::from(*other)
            }
            #[inline]
            fn ge(&self, other: &f64) -> bool {
                *self >= Self::from(*other)
            }
        }

        impl ::std::iter::Sum for $type {
            fn sum<I: Iterator<Item = Self>>(iter: I) -> Self {
                iter.fold($type($zero), |sum, x| sum + x)
            }
        }
        impl<'a> ::std::iter::Sum<&'a $type> for $type {
            fn sum<I: Iterator<Item = &'a Self>>(iter: I) -> Self {
                iter.copied().sum()
            }
        }
        impl ::std::iter::Product for $type {
            fn product<I: Iterator<Item = Self>>(iter: I) -> Self {
                iter.fold($type($one), |product, x| product * x)
            }
        }
        impl<'a> ::std::iter::Product<&'a $type> for $type {
            fn product<I: Iterator<Item = &'a Self>>(iter: I) -> Self {
                iter.copied().product()
            }
        }

        impl ::num_traits::Zero for $type {
            #[inline]
            fn zero() -> Self {
                $type($zero)
            }
            #[inline]
            fn is_zero(&self) -> bool {
                self.0 == $zero
            }
        }
        impl ::num_traits::One for $type {
            #[inline]
            fn one() -> Self {
                $type($one)
            }
        }
        impl ::num_traits::Inv for $type {
            type Output = $type;
            #[inline]
            fn inv(self) -> $type {
                $type($one / self.0)
            }
        }
        impl ::num_traits::Num for $type {
            type FromStrRadixErr = ::std::num::ParseFloatError;
            /// Parses a decimal literal; a radix other than 10 is an error.
            fn from_str_radix(text: &str, radix: u32) -> Result<Self, Self::FromStrRadixErr> {
                // Parsing an empty literal is the only way to create a ParseFloatError.
                if radix == 10 { text } else { "" }.parse()
            }
        }
        /// Signs as for `f64`: the sign bit decides, also for zeros.
        impl ::num_traits::Signed for $type {
            #[inline]
            fn abs(&self) -> Self {
                $type(self.0.abs())
            }
            #[inline]
            fn abs_sub(&self, other: &Self) -> Self {
                if self <= other { $type($zero) } else { self - other }
            }
            #[inline]
            fn signum(&self) -> Self {
                $type(self.0.signum())
            }
            #[inline]
            fn is_positive(&self) -> bool {
                self.0.is_sign_positive()
            }
            #[inline]
            fn is_negative(&self) -> bool {
                self.0.is_sign_negative()
            }
        }
    };
}

/// `num_dual::DualNum` and its two companions, each function being `$math::function` on the inner float.
macro_rules! newtype_dual_num {
    ($type:ident, $math:ident) => {
        impl ::num_dual::DualStruct for $type {
            type Real = f64;
            type Inner = Self;
            #[inline]
            fn re(&self) -> f64 {
                self.to_f64()
            }
            #[inline]
            fn from_inner(inner: &Self) -> Self {
                *inner
            }
        }
        impl ::num_dual::Mappable<$type> for $type {
            type Output<O> = O;
            #[inline]
            fn map_dual<M: FnOnce(Self) -> O, O>(self, f: M) -> O {
                f(self)
            }
        }
        impl ::num_dual::DualNum for $type {
            type Primitive = f64;
            type InnerDual = Self;
            const NDERIV: usize = 0;

            #[inline]
            fn from_re(re: Self) -> Self {
                re
            }
            #[inline]
            fn scale(self, factor: &Self) -> Self {
                self * factor
            }
            $crate::number::newtype::newtype_functions!($math: recip sqrt cbrt exp exp2 exp_m1 ln log2 log10 ln_1p sin cos tan
                asin acos atan sinh cosh tanh asinh acosh atanh);
            fn powi(&self, n: i32) -> Self {
                Self($math::powi(self.0, n))
            }
            fn powf(&self, n: f64) -> Self {
                self.powd(Self::from(n))
            }
            fn powd(&self, n: Self) -> Self {
                Self($math::powf(self.0, n.0))
            }
            fn log(&self, base: f64) -> Self {
                Self($math::log(self.0, Self::from(base).0))
            }
            fn sin_cos(&self) -> (Self, Self) {
                let (sin, cos) = $math::sin_cos(self.0);
                (Self(sin), Self(cos))
            }
            fn atan2(&self, x: Self) -> Self {
                Self($math::atan2(self.0, x.0))
            }
            fn mul_add(&self, factor: Self, addend: Self) -> Self {
                Self($math::mul_add(self.0, factor.0, addend.0))
            }
            fn sph_j0(&self) -> Self {
                $crate::number::newtype::spherical_bessel::j0(*self)
            }
            fn sph_j1(&self) -> Self {
                $crate::number::newtype::spherical_bessel::j1(*self)
            }
            fn sph_j2(&self) -> Self {
                $crate::number::newtype::spherical_bessel::j2(*self)
            }
        }
    };
}

/// Parsed and formatted like the inner float.
macro_rules! newtype_text {
    ($type:ident: $($trait:ident),*) => {
        impl ::std::str::FromStr for $type {
            type Err = ::std::num::ParseFloatError;
            /// The number nearest to a decimal literal.
            fn from_str(text: &str) -> Result<Self, Self::Err> {
                text.parse().map(Self)
            }
        }
        $(impl ::std::fmt::$trait for $type {
            fn fmt(&self, f: &mut ::std::fmt::Formatter<'_>) -> ::std::fmt::Result {
                ::std::fmt::$trait::fmt(&self.0, f)
            }
        })*
    };
}

macro_rules! newtype_functions {
    ($math:ident: $($function:ident)*) => {
        $(#[inline]
        fn $function(&self) -> Self {
            Self($math::$function(self.0))
        })*
    };
}

pub(crate) use {newtype_dual_num, newtype_functions, newtype_number, newtype_operator, newtype_text};
