//! Products of vectors and their gradients.

#![expect(clippy::inline_always, reason = "zeros are left out where the compiler sees the indices")]

use crate::scalar::Scalar;
use nalgebra::{Matrix3, Vector3};

/// A vector of which most components are zero whatever the inputs: these are not computed with.
#[derive(Clone, Copy)]
pub(super) struct Sparse<D>([Option<D>; 3]);

impl<D: Scalar> Sparse<D> {
    #[inline(always)]
    pub(super) fn none() -> Self {
        Self([None; 3])
    }

    /// With a component, also.
    #[inline(always)]
    pub(super) fn with(mut self, axis: usize, value: D) -> Self {
        self.0[axis] = Some(value);
        self
    }

    #[inline(always)]
    fn map(self, f: impl Fn(D) -> D) -> Self {
        let [x, y, z] = self.0;
        Self([x.map(&f), y.map(&f), z.map(&f)])
    }

    #[inline(always)]
    pub(super) fn dense(&self) -> Vector3<D> {
        let [x, y, z] = self.0.map(|x| x.unwrap_or_else(D::zero));
        Vector3::new(x, y, z)
    }

    #[inline(always)]
    pub(super) fn times(&self, factor: D) -> Vector3<D> {
        self.map(|x| x * factor).dense()
    }

    #[inline(always)]
    pub(super) fn negative(&self) -> Vector3<D> {
        self.map(|x| -x).dense()
    }

    #[inline(always)]
    pub(super) fn dot(&self, v: &Vector3<D>) -> D {
        let term = |k: usize| self.0[k].map(|x| x * v[k]);
        let sum = |a: Option<D>, b: Option<D>| match (a, b) {
            (Some(a), Some(b)) => Some(a + b),
            (a, b) => a.or(b),
        };
        sum(sum(term(0), term(1)), term(2)).unwrap_or_else(D::zero)
    }
}

/// The gradients of the k-th component of a × b: by a, and by b.
#[inline(always)]
pub(super) fn cross_gradient<D: Scalar>(a: &Vector3<D>, b: &Vector3<D>, k: usize) -> [Sparse<D>; 2] {
    let (next, last) = ((k + 1) % 3, (k + 2) % 3);
    [Sparse::none().with(next, b[last]).with(last, -b[next]), Sparse::none().with(next, -a[last]).with(last, a[next])]
}

/// \[v×\]: what takes w to v × w.
#[inline(always)]
pub(super) fn skew<D: Scalar>(v: &Vector3<D>) -> Matrix3<D> {
    let zero = D::zero();
    Matrix3::new(zero, -v.z, v.y, v.z, zero, -v.x, -v.y, v.x, zero)
}

/// The gradient of an entry of [`skew`] by the vector.
#[inline(always)]
pub(super) fn skew_gradient<D: Scalar>(row: usize, column: usize) -> Sparse<D> {
    if row == column {
        return Sparse::none();
    }
    Sparse::none().with(3 - row - column, if column == (row + 1) % 3 { -D::one() } else { D::one() })
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
) -> [Sparse<D>; 2] {
    if row == column {
        let (next, last) = ((row + 1) % 3, (row + 2) % 3);
        let others = |v: &Vector3<D>| Sparse::none().with(next, -v[next]).with(last, -v[last]);
        return [others(b), others(a)];
    }
    [Sparse::none().with(row, b[column]), Sparse::none().with(column, a[row])]
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

/// The gradients of an entry of the [`symmetric`] part of [`double_cross`]: by a, and by b.
#[inline(always)]
pub(super) fn symmetric_gradient<D: Scalar>(
    a: &Vector3<D>,
    b: &Vector3<D>,
    row: usize,
    column: usize,
) -> [Sparse<D>; 2] {
    if row == column {
        return double_cross_gradient(a, b, row, column);
    }
    let half = |v: &Vector3<D>| Sparse::none().with(row, v[column] * 0.5).with(column, v[row] * 0.5);
    [half(b), half(a)]
}

/// The column of what a method gives for every index, after what else it takes. Each is a call of its own: in a loop, or through a closure, the
/// compiler would not see the index, and look up at run time where the zeros are.
macro_rules! column {
    ($i:ident.$method:ident $(, $of:expr)*) => {
        nalgebra::Vector3::new($i.$method($($of,)* 0), $i.$method($($of,)* 1), $i.$method($($of,)* 2))
    };
}

/// As [`column`], a matrix by its rows and columns.
macro_rules! matrix {
    ($i:ident.$method:ident) => {
        nalgebra::Matrix3::new(
            $i.$method(0, 0),
            $i.$method(0, 1),
            $i.$method(0, 2),
            $i.$method(1, 0),
            $i.$method(1, 1),
            $i.$method(1, 2),
            $i.$method(2, 0),
            $i.$method(2, 1),
            $i.$method(2, 2),
        )
    };
}

pub(super) use {column, matrix};
