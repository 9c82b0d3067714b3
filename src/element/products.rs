//! Products of vectors and their gradients.

#![expect(clippy::inline_always, reason = "the compiler sees the indices, and computes no zeros")]

use crate::number::scalar::Scalar;
use nalgebra::{Matrix3, Vector3};

/// \[v×\]: what takes w to v × w.
#[inline(always)]
pub(super) fn skew<D: Scalar>(v: &Vector3<D>) -> Matrix3<D> {
    let zero = D::zero();
    Matrix3::new(zero, -v.z, v.y, v.z, zero, -v.x, -v.y, v.x, zero)
}

/// a ⊗ b − (a·b) I = \[b×\] \[a×\]: what takes w to b × (a × w).
///
/// Its diagonal is a sum over the other two axes, without the product that would cancel.
#[inline(always)]
pub(super) fn double_cross<D: Scalar>(a: &Vector3<D>, b: &Vector3<D>) -> Matrix3<D> {
    let diagonal = |j: usize, k: usize| -(a[j] * b[j] + a[k] * b[k]);
    let mut m = a * b.transpose();
    m[(0, 0)] = diagonal(1, 2);
    m[(1, 1)] = diagonal(2, 0);
    m[(2, 2)] = diagonal(0, 1);
    m
}

/// The column of what a method gives for every index, after what else it takes. Each is a call of its own: in a loop, or through a closure, the
/// compiler would not see the index, and look up at run time where the zeros are. It may for what is larger than a double, where
/// one operation takes longer than that: nine times the code would be most of a program.
///
/// The method is always inlined where the compiler optimises; where it does not, each would only take its own room on the stack.
macro_rules! column {
    ($i:ident.$method:ident $(, $of:expr)*) => {
        if const { size_of::<D>() > size_of::<f64>() } {
            nalgebra::Vector3::from_fn(|row, _| $i.$method($($of,)* row))
        } else {
            nalgebra::Vector3::new($i.$method($($of,)* 0), $i.$method($($of,)* 1), $i.$method($($of,)* 2))
        }
    };
}

pub(super) use column;
