//! Assembly over twelve degrees of freedom: the translation and the spin of a, then the translation and the spin of b.

use super::angle::{AlignRows, AlignStiffness};
use super::cross::{UniversalMoments, UniversalStiffness};
use super::line::{JoinForces, JoinRows, JoinStiffness};
use super::{Forces, Rows, Stiffness};
use crate::element::NodalForces;
use crate::number::scalar::Scalar;
use nalgebra::{Matrix3, Vector3};

/// The positions of the four motions, in blocks of three.
const UA: usize = 0;
const TA: usize = 1;
const UB: usize = 2;
const TB: usize = 3;

/// Assembles blocks of three rows and columns.
fn stiffness<D: Scalar, const N: usize>(blocks: [(usize, usize, Matrix3<D>); N]) -> Stiffness<D> {
    let mut all = Stiffness::zeros();
    for (row, column, block) in blocks {
        all.fixed_view_mut::<3, 3>(3 * row, 3 * column).copy_from(&block);
    }
    all
}

/// Assembles rows from their parts for each of the four motions, if any.
fn rows<D: Scalar, const N: usize>(parts: [[Option<Vector3<D>>; 4]; N]) -> Rows<D, N> {
    Rows::from_fn(|row, column| parts[row][column / 3].map_or(D::zero(), |part| part[column % 3]))
}

impl<D: Scalar> NodalForces<D> {
    /// Force and moment on a, then force and moment on b.
    pub fn vector(&self) -> Forces<D> {
        let parts = [self.fa, self.ma, self.fb, self.mb];
        Forces::from_fn(|k, _| parts[k / 3][k % 3])
    }
}

impl<D: Scalar> JoinRows<D> {
    fn all(&self) -> [[Option<Vector3<D>>; 4]; 3] {
        let row = |ua, ta, ub| [Some(ua), Some(ta), Some(ub), None];
        [
            row(self.g1_ua, self.g1_ta, self.g1_ub),
            row(self.g2_ua, self.g2_ta, self.g2_ub),
            row(self.g3_ua, self.g3_ta, self.g3_ub),
        ]
    }

    /// The three rows.
    ///
    /// ```
    /// use jointproof::connector::slot::Positions;
    /// use jointproof::element::line::Rows;
    /// use jointproof::formula::value;
    /// use nalgebra::Vector3;
    /// let [e1a, e2a, e3a] = [Vector3::x(), Vector3::y(), Vector3::z()];
    /// let rows = value::<Rows>(&Positions { e1a, e2a, e3a, xa: Vector3::zeros(), xb: e2a * 2.0 })?.matrix();
    /// assert_eq!((rows[(0, 0)], rows[(0, 6)]), (-1.0, 1.0)); // g1 = e1a·(xb − xa) by u_a and by u_b
    /// assert_eq!(rows[(0, 5)], 2.0); // and by θ_a about e3a
    /// # Ok::<(), jointproof::Error>(())
    /// ```
    pub fn matrix(&self) -> Rows<D, 3> {
        rows(self.all())
    }
}

impl<D: Scalar> JoinForces<D> {
    /// Force and moment on a, force on b, and no moment on b.
    pub fn vector(&self) -> Forces<D> {
        let Self { fa, ma, fb } = *self;
        NodalForces { fa, ma, fb, mb: Vector3::zeros() }.vector()
    }
}

impl<D: Scalar> UniversalMoments<D> {
    /// No forces, a moment on a and one on b.
    pub fn vector(&self) -> Forces<D> {
        let Self { ma, mb } = *self;
        NodalForces { fa: Vector3::zeros(), ma, fb: Vector3::zeros(), mb }.vector()
    }
}

impl<D: Scalar> AlignRows<D> {
    fn all(&self) -> [[Option<Vector3<D>>; 4]; 3] {
        [self.ur1_tb, self.ur2_tb, self.ur3_tb].map(|tb| [None, Some(-tb), None, Some(tb)])
    }

    /// The three rows.
    pub fn matrix(&self) -> Rows<D, 3> {
        rows(self.all())
    }
}

impl<D: Scalar> JoinStiffness<D> {
    /// The assembled matrix.
    pub fn matrix(&self) -> Stiffness<D> {
        let (force, turned) = (self.k_ua_ta, self.k_ua_ta.transpose());
        stiffness([(UA, TA, force), (UB, TA, -force), (TA, UA, turned), (TA, UB, -turned), (TA, TA, self.k_ta_ta)])
    }
}

impl<D: Scalar> UniversalStiffness<D> {
    /// Adds all blocks to the matrix `all`.
    pub(crate) fn add_to(&self, all: &mut Stiffness<D>) {
        let across = self.k_ta_tb;
        let blocks = [(TA, TA, self.k_ta_ta), (TA, TB, across), (TB, TA, across.transpose()), (TB, TB, self.k_tb_tb)];
        for (row, column, block) in blocks {
            let mut own = all.fixed_view_mut::<3, 3>(3 * row, 3 * column);
            own += block;
        }
    }

    /// The assembled matrix.
    pub fn matrix(&self) -> Stiffness<D> {
        let across = self.k_ta_tb;
        stiffness([(TA, TA, self.k_ta_ta), (TA, TB, across), (TB, TA, across.transpose()), (TB, TB, self.k_tb_tb)])
    }
}

impl<D: Scalar> AlignStiffness<D> {
    /// The assembled matrix.
    pub fn matrix(&self) -> Stiffness<D> {
        let (b, a) = (self.k_tb_tb, self.k_tb_tb.transpose());
        stiffness([(TA, TA, a), (TA, TB, -b), (TB, TA, -a), (TB, TB, b)])
    }
}
