//! Products of vectors and their gradients.

#![expect(clippy::inline_always, reason = "the compiler sees the indices, and computes no zeros")]

use crate::formula::Fields;
use crate::scalar::Scalar;
use nalgebra::{Matrix3, Vector3};

/// The gradients of the k-th component of a × b: by a, and by b.
#[inline(always)]
pub(super) fn cross_gradient<D: Scalar>(a: &Vector3<D>, b: &Vector3<D>, k: usize) -> [Vector3<D>; 2] {
    let across = |v: &Vector3<D>| skew(v).column(k).into_owned();
    [across(b), -across(a)]
}

/// \[v×\]: what takes w to v × w.
#[inline(always)]
pub(super) fn skew<D: Scalar>(v: &Vector3<D>) -> Matrix3<D> {
    let zero = D::zero();
    Matrix3::new(zero, -v.z, v.y, v.z, zero, -v.x, -v.y, v.x, zero)
}

/// The gradient of an entry of [`skew`] by the vector.
#[inline(always)]
pub(super) fn skew_gradient<D: Scalar>(row: usize, column: usize) -> Vector3<D> {
    let mut gradient = Vector3::from_element(D::zero());
    if row != column {
        gradient[3 - row - column] = if column == (row + 1) % 3 { -D::one() } else { D::one() };
    }
    gradient
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

/// The gradients of an entry of [`double_cross`]: by a, and by b.
#[inline(always)]
pub(super) fn double_cross_gradient<D: Scalar>(
    a: &Vector3<D>,
    b: &Vector3<D>,
    row: usize,
    column: usize,
) -> [Vector3<D>; 2] {
    if row == column {
        let others = |v: &Vector3<D>| Vector3::from_fn(|k, _| if k == row { D::zero() } else { -v[k] });
        return [others(b), others(a)];
    }
    let (mut by_a, mut by_b) = (Vector3::from_element(D::zero()), Vector3::from_element(D::zero()));
    by_a[row] = b[column];
    by_b[column] = a[row];
    [by_a, by_b]
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

/// ½ (a + b), component by component.
#[inline(always)]
pub(super) fn mean<D: Scalar, I: Fields<D>>(a: &I, b: &I) -> I {
    let mut sum = I::array_of(D::zero());
    for part in [a, b] {
        let mut places = sum.as_mut().iter_mut();
        part.for_each_component(&mut |x| {
            if let Some(place) = places.next() {
                *place += x;
            }
        });
    }
    let mut all = sum.as_ref().iter().map(|&x| x * 0.5);
    I::from_components(&mut || all.next().expect("an array has as many components as it was made for"))
}

/// The column of what a method gives for every index, after what else it takes. Each is a call of its own: in a loop, or through a closure, the
/// compiler would not see the index, and look up at run time where the zeros are.
///
/// The method is always inlined where the compiler optimises; where it does not, each would only take its own room on the stack.
macro_rules! column {
    ($i:ident.$method:ident $(, $of:expr)*) => {
        nalgebra::Vector3::new($i.$method($($of,)* 0), $i.$method($($of,)* 1), $i.$method($($of,)* 2))
    };
}

/// As [`column`], a matrix by its rows and columns.
macro_rules! matrix {
    ($i:ident.$method:ident $(, $of:expr)*) => {
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
    };
}

pub(super) use {column, matrix};
