//! [`Scalar`] for the numbers of `num-dual` that carry derivatives.

use crate::number::scalar::{Scalar, asin, atan2, divide, exp_m1, norm, norm_and_direction};
use nalgebra::{Const, U1};
use num_dual::{Derivative, Dual, Dual2, Dual2SVec, DualSVec, HyperDual};

/// The leaf of a dual number is that of its real part.
macro_rules! inside {
    ($constant:ident) => {
        type Leaf = T::Leaf;
        const ZERO: Self = $constant(T::ZERO);
        const ONE: Self = $constant(T::ONE);
        const MINUS_ONE: Self = $constant(T::MINUS_ONE);
        #[inline]
        fn leaf_of(x: Self) -> Self::Leaf {
            T::leaf_of(x.re)
        }
        #[inline]
        fn constant_of(x: Self::Leaf) -> Self {
            Self::from_re(T::constant_of(x))
        }
    };
}

/// First-order duals: the value in `T`, and the chain rule with the partial derivatives taken in `T` too, so that
/// nesting gives second derivatives. Written out, because a dual number that squares its own derivative part (as
/// √(x²) does) overflows where the norm itself does not.
macro_rules! first_order {
    ([$($generics:tt)*] $dual:ty, $constant:ident) => {
        impl<T: Scalar $($generics)*> Scalar for $dual {
            inside!($constant);
            #[inline]
            fn norm_of<const COUNT: usize>(x: [Self; COUNT]) -> Self {
                let (length, n) = norm_and_direction(x.map(|x| x.re));
                let mut result = Self::from_re(length);
                for (x, n) in x.into_iter().zip(n) {
                    result.eps += x.eps * n;
                }
                result
            }
            /// dn = (I − n nᵀ) dx/|x|, summed from terms n_b (n_b dx_c − n_c dx_b) to avoid needless cancellation.
            #[inline]
            fn norm_and_direction_of<const COUNT: usize>(x: [Self; COUNT]) -> (Self, [Self; COUNT]) {
                let (length, n) = norm_and_direction(x.map(|x| x.re));
                let direction = std::array::from_fn(|c| {
                    let mut result = Self::from_re(n[c]);
                    for b in (0..COUNT).filter(|&b| b != c && length != 0.0) {
                        result.eps += (x[c].eps * n[b] - x[b].eps * n[c]) * n[b] / length;
                    }
                    result
                });
                (norm(x), direction)
            }
            #[inline]
            fn angle_of(y: Self, x: Self) -> Self {
                let mut result = Self::from_re(atan2(y.re, x.re));
                let square = x.re * x.re + y.re * y.re;
                result.eps = if square > 1e-30 && square < 1e30 {
                    // The difference is formed first: where the point moves straight away from the origin, it is exactly 0.
                    (y.eps * x.re - x.eps * y.re) * square.recip()
                } else {
                    let length = norm([x.re, y.re]);
                    let tangent = divide([-y.re, x.re], length);
                    let [dx, dy] = divide(tangent, length);
                    x.eps * dx + y.eps * dy
                };
                result
            }
            #[inline]
            fn asin_of(x: Self) -> Self {
                let mut result = Self::from_re(asin(x.re));
                let cosine = ((-x.re + 1.0) * (x.re + 1.0)).sqrt();
                result.eps = x.eps * cosine.recip();
                result
            }
            #[inline]
            fn exp_m1_of(x: Self) -> Self {
                let mut result = Self::from_re(exp_m1(x.re));
                result.eps = x.eps * x.re.exp();
                result
            }
        }
    };
}

first_order!([] Dual<T>, constant_dual);
first_order!([, const N: usize] DualSVec<T, N>, constant_gradient);

/// Second-order duals, computed as the nested first-order duals that they are equal to.
macro_rules! second_order {
    ([$($generics:tt)*] $dual:ty, $constant:ident, $unfold:ident, $fold:ident) => {
        impl<T: Scalar $($generics)*> Scalar for $dual {
            inside!($constant);
            fn norm_of<const COUNT: usize>(x: [Self; COUNT]) -> Self {
                $fold(norm(x.map($unfold)))
            }
            fn norm_and_direction_of<const COUNT: usize>(x: [Self; COUNT]) -> (Self, [Self; COUNT]) {
                let (length, n) = norm_and_direction(x.map($unfold));
                ($fold(length), n.map($fold))
            }
            fn angle_of(y: Self, x: Self) -> Self {
                $fold(atan2($unfold(y), $unfold(x)))
            }
            fn asin_of(x: Self) -> Self {
                $fold(asin($unfold(x)))
            }
            fn exp_m1_of(x: Self) -> Self {
                $fold(exp_m1($unfold(x)))
            }
        }
    };
}

second_order!([] HyperDual<T>, constant_hyper, unfold_hyper, fold_hyper);
second_order!([] Dual2<T>, constant_second, unfold_second, fold_second);
second_order!([, const N: usize] Dual2SVec<T, N>, constant_hessian, unfold_hessian, fold_hessian);

const fn constant_dual<T: Scalar>(re: T) -> Dual<T> {
    Dual { re, eps: T::ZERO }
}

const fn constant_gradient<T: Scalar, const N: usize>(re: T) -> DualSVec<T, N> {
    DualSVec { re, eps: Derivative(None) }
}

const fn constant_hyper<T: Scalar>(re: T) -> HyperDual<T> {
    HyperDual { re, eps1: T::ZERO, eps2: T::ZERO, eps1eps2: T::ZERO }
}

const fn constant_second<T: Scalar>(re: T) -> Dual2<T> {
    Dual2 { re, v1: T::ZERO, v2: T::ZERO }
}

const fn constant_hessian<T: Scalar, const N: usize>(re: T) -> Dual2SVec<T, N> {
    Dual2SVec { re, v1: Derivative(None), v2: Derivative(None) }
}

fn unfold_hyper<T: Scalar>(x: HyperDual<T>) -> Dual<Dual<T>> {
    Dual::new(Dual::new(x.re, x.eps1), Dual::new(x.eps2, x.eps1eps2))
}

fn fold_hyper<T: Scalar>(x: Dual<Dual<T>>) -> HyperDual<T> {
    HyperDual::new(x.re.re, x.re.eps, x.eps.re, x.eps.eps)
}

fn unfold_second<T: Scalar>(x: Dual2<T>) -> Dual<Dual<T>> {
    Dual::new(Dual::new(x.re, x.v1), Dual::new(x.v1, x.v2))
}

fn fold_second<T: Scalar>(x: Dual<Dual<T>>) -> Dual2<T> {
    Dual2::new(x.re.re, x.re.eps, x.eps.eps)
}

fn unfold_hessian<T: Scalar, const N: usize>(x: Dual2SVec<T, N>) -> DualSVec<DualSVec<T, N>, N> {
    let gradient = x.v1.unwrap_generic(U1, Const::<N>);
    let hessian = x.v2.unwrap_generic(Const::<N>, Const::<N>);
    let row = |re: T, eps| DualSVec::new(re, Derivative::some(eps));
    let rows = nalgebra::SVector::<_, N>::from_fn(|i, _| row(gradient[i], hessian.row(i).transpose()));
    DualSVec::new(row(x.re, gradient.transpose()), Derivative::some(rows))
}

fn fold_hessian<T: Scalar, const N: usize>(x: DualSVec<DualSVec<T, N>, N>) -> Dual2SVec<T, N> {
    let unwrap = |eps: Derivative<T, Const<N>, U1>| eps.unwrap_generic(Const::<N>, U1);
    let rows = x.eps.unwrap_generic(Const::<N>, U1).map(|row| unwrap(row.eps));
    let hessian = nalgebra::SMatrix::from_fn(|i, j| rows[i][j]);
    Dual2SVec::new(x.re.re, Derivative::some(unwrap(x.re.eps).transpose()), Derivative::some(hessian))
}
