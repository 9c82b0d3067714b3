//! Conversion to programs whose unknowns are not spins, but rotation vectors or Euler parameters.

use super::Contribution;
use crate::element::rotation::{EulerParameters, QuaternionLoad, RotationVector, TurnedLoad};
use crate::formula::Formula;
use crate::number::scalar::Scalar;
use nalgebra::{SMatrix, SVector, Vector3, Vector4};

/// The rotation of a node as a function of other unknowns.
struct Turning<D, const N: usize> {
    /// The derivative of the spin with respect to the unknowns.
    spin: SMatrix<D, 3, N>,
    /// The derivative of the generalised moment with respect to the unknowns, with the moment held.
    bending: SMatrix<D, N, N>,
}

impl<D: Scalar> Turning<D, 3> {
    fn by_rotation_vector(psi: Vector3<D>, m: Vector3<D>) -> Self {
        let rows = RotationVector::jacobian(&TurnedLoad { psi, m }).m_psi;
        Self { spin: SMatrix::from_fn(|k, j| rows[j].m[k]), bending: SMatrix::from_fn(|j, k| rows[j].psi[k]) }
    }
}

impl<D: Scalar> Turning<D, 4> {
    fn by_euler_parameters(q: Vector4<D>, m: Vector3<D>) -> Self {
        let found = EulerParameters::jacobian(&QuaternionLoad { q0: q[0], q: q.fixed_rows::<3>(1).into_owned(), m });
        let row = |j: usize| if j == 0 { found.m_q0 } else { found.m_q[j - 1] };
        let by_parameter =
            |QuaternionLoad { q0, q, .. }: QuaternionLoad<D>, k: usize| if k == 0 { q0 } else { q[k - 1] };
        Self { spin: SMatrix::from_fn(|k, j| row(j).m[k]), bending: SMatrix::from_fn(|j, k| by_parameter(row(j), k)) }
    }
}

/// Replaces the columns of spins by those of the unknowns; the columns of translations are unchanged.
fn columns<D: Scalar, const ROWS: usize, const N: usize, const DOFS: usize>(
    by_spins: &SMatrix<D, ROWS, 12>,
    nodes: &[Turning<D, N>; 2],
) -> SMatrix<D, ROWS, DOFS> {
    const { assert!(DOFS == 2 * (3 + N)) };
    let mut all = SMatrix::<D, ROWS, DOFS>::zeros();
    for (k, node) in nodes.iter().enumerate() {
        let (from, to) = (6 * k, (3 + N) * k);
        all.fixed_columns_mut::<3>(to).copy_from(&by_spins.fixed_columns::<3>(from));
        all.fixed_columns_mut::<N>(to + 3).copy_from(&(by_spins.fixed_columns::<3>(from + 3) * node.spin));
    }
    all
}

impl<D: Scalar, const MULTIPLIERS: usize> Contribution<D, MULTIPLIERS> {
    /// The same for nodes whose unknowns are rotation vectors: u_a, ψ_a, u_b, ψ_b.
    ///
    /// A node's triad is that at ψ = 0 rotated by ψ. At a whole turn the rows are rank-deficient: a program must change ψ before
    /// that.
    ///
    /// ```
    /// use jointproof::connector::universal::{UniversalElement, UniversalStart};
    /// use jointproof::element::{Nodes, Nothing, Parameters};
    /// use nalgebra::{Vector1, Vector3};
    /// let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    /// // a has turned by a right angle about z.
    /// let (a, psi) = ([axes[1], -axes[0], axes[2]], Vector3::z() * std::f64::consts::FRAC_PI_2);
    /// let nodes = Nodes::new([a, axes], [Vector3::zeros(); 2]);
    /// let universal = Parameters::<UniversalElement, f64, 1> { start: UniversalStart { c0: 0.0 }, contact: None };
    /// let (step, _) = universal.newton(&nodes, &Vector1::new(2.0), &Nothing::new())?;
    /// let turned = step.by_rotation_vectors([psi, Vector3::zeros()]);
    /// assert_eq!(step.rows[(0, 3)], 1.0);
    /// assert!((turned.rows[(0, 3)] - 2.0 / std::f64::consts::PI).abs() < 1e-15); // sin ψ/ψ
    /// # Ok::<(), jointproof::Error>(())
    /// ```
    #[must_use]
    pub fn by_rotation_vectors(&self, psi: [Vector3<D>; 2]) -> Self {
        self.with(&[0, 1].map(|k| Turning::by_rotation_vector(psi[k], self.moment(k))))
    }

    /// The same for Euler parameters, unit quaternions (q0, q1, q2, q3): u_a, q_a, u_b, q_b, fourteen unknowns.
    ///
    /// The program must hold the length of each quaternion.
    #[must_use]
    pub fn by_euler_parameters(&self, q: [Vector4<D>; 2]) -> Contribution<D, MULTIPLIERS, 14> {
        self.with(&[0, 1].map(|k| Turning::by_euler_parameters(q[k], self.moment(k))))
    }

    /// The moment on node a or b.
    fn moment(&self, node: usize) -> Vector3<D> {
        self.forces.fixed_rows::<3>(6 * node + 3).into_owned()
    }

    fn with<const N: usize, const DOFS: usize>(
        &self,
        nodes: &[Turning<D, N>; 2],
    ) -> Contribution<D, MULTIPLIERS, DOFS> {
        let forces: SMatrix<D, 1, DOFS> = columns(&self.forces.transpose(), nodes);
        let by_columns: SMatrix<D, 12, DOFS> = columns(&self.stiffness, nodes);
        let mut stiffness: SMatrix<D, DOFS, DOFS> = columns(&by_columns.transpose(), nodes).transpose();
        for (k, node) in nodes.iter().enumerate() {
            let at = (3 + N) * k + 3;
            let mut block = stiffness.fixed_view_mut::<N, N>(at, at);
            block += node.bending;
        }
        let by_multipliers: SMatrix<D, MULTIPLIERS, DOFS> = columns(&self.by_multipliers.transpose(), nodes);
        Contribution {
            residuals: self.residuals,
            rows: columns(&self.rows, nodes),
            forces: SVector::from(forces.transpose()),
            stiffness,
            by_multipliers: by_multipliers.transpose(),
        }
    }
}
