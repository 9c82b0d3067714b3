//! Products of vectors and their gradients.

#![expect(clippy::inline_always, reason = "the compiler sees the indices, and computes no zeros")]

use crate::formula::{Few, Sign, next};
use crate::number::scalar::Scalar;
use nalgebra::{Matrix3, Vector3};

/// \[v×\]: what takes w to v × w.
#[inline(always)]
pub(super) fn skew<D: Scalar>(v: &Vector3<D>) -> Matrix3<D> {
    let zero = D::zero();
    Matrix3::new(zero, -v.z, v.y, v.z, zero, -v.x, -v.y, v.x, zero)
}

/// The gradient of an entry of [`skew`] by the vector.
#[inline(always)]
pub(super) fn skew_gradient<D: Scalar>(row: usize, column: usize) -> Few<D> {
    if row == column {
        return Few::none();
    }
    Few::one(3 - row - column, if column == next(row)[0] { -D::one() } else { D::one() })
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

/// The gradients of an entry of [`double_cross`]: by a, and by b, and their sign.
#[inline(always)]
pub(super) fn double_cross_gradient<D: Scalar>(
    a: &Vector3<D>,
    b: &Vector3<D>,
    row: usize,
    column: usize,
) -> ([Few<D>; 2], Sign) {
    if row == column {
        let [k, l] = next(row);
        let by = |v: &Vector3<D>| Few::two((k, v[k]), (l, v[l]));
        return ([by(b), by(a)], Sign::Minus);
    }
    ([Few::one(row, b[column]), Few::one(column, a[row])], Sign::Plus)
}

/// The gradients of an entry of the symmetric part of [`double_cross`]: by a, and by b, and their sign.
#[inline(always)]
pub(super) fn symmetric_gradient<D: Scalar>(
    a: &Vector3<D>,
    b: &Vector3<D>,
    row: usize,
    column: usize,
) -> ([Few<D>; 2], Sign) {
    if row == column {
        return double_cross_gradient(a, b, row, row);
    }
    let by = |v: &Vector3<D>| Few::two((row, v[column] * 0.5), (column, v[row] * 0.5));
    ([by(b), by(a)], Sign::Plus)
}

/// ½ (M + Mᵀ).
#[inline(always)]
pub(super) fn symmetric<D: Scalar>(m: &Matrix3<D>) -> Matrix3<D> {
    Matrix3::from_fn(
        |row, column| {
            if row == column { m[(row, row)] } else { (m[(row, column)] + m[(column, row)]) * 0.5 }
        },
    )
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

/// As [`column`], a matrix by its rows and columns.
macro_rules! matrix {
    ($i:ident.$method:ident $(, $of:expr)*) => {
        if const { size_of::<D>() > size_of::<f64>() } {
            nalgebra::Matrix3::from_fn(|row, column| $i.$method($($of,)* row, column))
        } else {
            nalgebra::Matrix3::new(
                $i.$method($($of,)* 0, 0),
                $i.$method($($of,)* 0, 1),
                $i.$method($($of,)* 0, 2),
                $i.$method($($of,)* 1, 0),
                $i.$method($($of,)* 1, 1),
                $i.$method($($of,)* 1, 2),
                $i.$method($($of,)* 2, 0),
                $i.$method($($of,)* 2, 1),
                $i.$method($($of,)* 2, 2),
            )
        }
    };
}

/// As [`matrix`], of entries that are those of their mirror images, too.
macro_rules! symmetric_matrix {
    ($i:ident.$method:ident $(, $of:expr)*) => {
        if const { size_of::<D>() > size_of::<f64>() } {
            nalgebra::Matrix3::from_fn(|row, column| $i.$method($($of,)* row.min(column), row.max(column)))
        } else {
            let (xy, xz, yz) =
                ($i.$method($($of,)* 0, 1), $i.$method($($of,)* 0, 2), $i.$method($($of,)* 1, 2));
            let (xx, yy, zz) =
                ($i.$method($($of,)* 0, 0), $i.$method($($of,)* 1, 1), $i.$method($($of,)* 2, 2));
            nalgebra::Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
        }
    };
}

pub(super) use {column, matrix, symmetric_matrix};
