//! Twelve degrees of freedom in a row: the translation and the spin of a, the translation and the spin of b.

use super::align::{AlignRows, AlignStiffness};
use super::join::{JoinForces, JoinRows, JoinStiffness};
use super::translator::{TranslatorRows, TranslatorStiffness};
use super::ujoint::{JointRows, JointStiffness};
use super::universal::{UniversalMoments, UniversalStiffness};
use super::{Forces, Rows, Stiffness};
use crate::element::NodalForces;
use crate::number::scalar::Scalar;
use nalgebra::{Matrix3, Vector3};

/// The places of the four motions, in threes.
const UA: usize = 0;
const TA: usize = 1;
const UB: usize = 2;
const TB: usize = 3;

/// Matrices of three rows and columns at their places.
fn stiffness<D: Scalar, const N: usize>(blocks: [(usize, usize, Matrix3<D>); N]) -> Stiffness<D> {
    let mut all = Stiffness::zeros();
    for (row, column, block) in blocks {
        all.fixed_view_mut::<3, 3>(3 * row, 3 * column).copy_from(&block);
    }
    all
}

/// Rows from what they are for each of the four motions, if anything.
fn rows<D: Scalar, const N: usize>(parts: [[Option<Vector3<D>>; 4]; N]) -> Rows<D, N> {
    Rows::from_fn(|row, column| parts[row][column / 3].map_or(D::zero(), |part| part[column % 3]))
}

impl<D: Scalar> NodalForces<D> {
    /// Force and moment on a, force and moment on b.
    pub fn vector(&self) -> Forces<D> {
        let parts = [self.fa, self.ma, self.fb, self.mb];
        Forces::from_fn(|k, _| parts[k / 3][k % 3])
    }
}

impl<D: Scalar> JointRows<D> {
    /// The four rows, JOIN's first.
    ///
    /// ```
    /// use jointproof::element::ujoint::{JointPlaces, Rows};
    /// use jointproof::formula::value;
    /// use nalgebra::Vector3;
    /// let [e1a, e2a, e3a] = [Vector3::x(), Vector3::y(), Vector3::z()];
    /// let here = JointPlaces { e1a, e2a, e3a, e3b: e3a, xa: Vector3::zeros(), xb: Vector3::zeros() };
    /// let rows = value::<Rows>(&here)?.matrix();
    /// assert_eq!((rows[(0, 0)], rows[(0, 6)]), (-1.0, 1.0)); // g1 = e1a·(xb − xa) by u_a and by u_b
    /// assert_eq!((rows[(3, 4)], rows[(3, 10)]), (-1.0, 1.0)); // e1a·e3b by θ_a and by θ_b, about e2a
    /// # Ok::<(), jointproof::Error>(())
    /// ```
    pub fn matrix(&self) -> Rows<D, 4> {
        let Self { g1_ua, g1_ta, g1_ub, g2_ua, g2_ta, g2_ub, g3_ua, g3_ta, g3_ub, g_rot_ta, g_rot_tb } = *self;
        let join = JoinRows { g1_ua, g1_ta, g1_ub, g2_ua, g2_ta, g2_ub, g3_ua, g3_ta, g3_ub };
        rows([join.all()[0], join.all()[1], join.all()[2], [None, Some(g_rot_ta), None, Some(g_rot_tb)]])
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
    pub fn matrix(&self) -> Rows<D, 3> {
        rows(self.all())
    }
}

impl<D: Scalar> JoinForces<D> {
    /// Force and moment on a, force and no moment on b.
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
    /// All blocks in their places.
    pub fn matrix(&self) -> Stiffness<D> {
        let (force, turned) = (self.k_ua_ta, self.k_ua_ta.transpose());
        stiffness([(UA, TA, force), (UB, TA, -force), (TA, UA, turned), (TA, UB, -turned), (TA, TA, self.k_ta_ta)])
    }
}

impl<D: Scalar> UniversalStiffness<D> {
    /// All blocks in their places.
    pub fn matrix(&self) -> Stiffness<D> {
        let across = self.k_ta_tb;
        stiffness([(TA, TA, self.k_ta_ta), (TA, TB, across), (TB, TA, across.transpose()), (TB, TB, self.k_tb_tb)])
    }
}

impl<D: Scalar> AlignStiffness<D> {
    /// All blocks in their places.
    pub fn matrix(&self) -> Stiffness<D> {
        let (b, a) = (self.k_tb_tb, self.k_tb_tb.transpose());
        stiffness([(TA, TA, a), (TA, TB, -b), (TB, TA, -a), (TB, TB, b)])
    }
}

impl<D: Scalar> TranslatorStiffness<D> {
    /// All blocks in their places.
    pub fn matrix(&self) -> Stiffness<D> {
        let Self { k_ua_ta, k_ta_ta, k_tb_tb } = *self;
        let aligned = AlignStiffness { k_tb_tb }.matrix();
        let mut all = JoinStiffness { k_ua_ta, k_ta_ta }.matrix();
        for (row, column) in [(TA, TB), (TB, TA), (TB, TB)] {
            all.fixed_view_mut::<3, 3>(3 * row, 3 * column).copy_from(&aligned.fixed_view::<3, 3>(3 * row, 3 * column));
        }
        all
    }
}

impl<D: Scalar> TranslatorRows<D> {
    /// The five rows, SLOT's first.
    pub fn matrix(&self) -> Rows<D, 5> {
        let Self { gy_ua, gy_ta, gy_ub, gz_ua, gz_ta, gz_ub, ur1_tb, ur2_tb, ur3_tb } = *self;
        let row = |ua, ta, ub| [Some(ua), Some(ta), Some(ub), None];
        let [r1, r2, r3] = AlignRows { ur1_tb, ur2_tb, ur3_tb }.all();
        rows([row(gy_ua, gy_ta, gy_ub), row(gz_ua, gz_ta, gz_ub), r1, r2, r3])
    }
}

impl<D: Scalar> JointStiffness<D> {
    /// All blocks in their places: what Newton's matrix has beside the rows.
    pub fn matrix(&self) -> Stiffness<D> {
        let (force, turned, across) = (self.k_ua_ta, self.k_ua_ta.transpose(), self.k_ta_tb);
        stiffness([
            (UA, TA, force),
            (UB, TA, -force),
            (TA, UA, turned),
            (TA, UB, -turned),
            (TA, TA, self.k_ta_ta),
            (TA, TB, across),
            (TB, TA, across.transpose()),
            (TB, TB, self.k_tb_tb),
        ])
    }
}
