//! How the forces change as the segment moves: the tangent in the frame of the segment, where what cancels is left out.
//!
//! In stick S12 is what it was and k_el times the slip ½ℓ (g − g'), where g' is the place before and N' are its weights. Near a node
//! k_el N' and S12/ℓ would cancel. Since ½ (g − g') is N₂ − N₂' and N₁' − N₁, together they are k_el N and what it was by ℓ.

use crate::contact::slide_line::{Projection, shape};
use crate::number::scalar::Scalar;
use nalgebra::Vector2;

/// What a force changes by along n and t, as a node moves along n and t: the force is named first.
struct Block<D> {
    nn: D,
    nt: D,
    tn: D,
    tt: D,
    /// nn − tt.
    difference: D,
}

impl<D: Scalar> Block<D> {
    /// Along the axes, a row for each component of the force; n is t turned to the left.
    #[inline(always)]
    fn rows(&self, t: &Vector2<D>) -> [Vector2<D>; 2] {
        let Self { nn, nt, tn, tt, difference } = *self;
        let (xx, yy, xy) = (t.x * t.x, t.y * t.y, t.x * t.y);
        let (mixed, unlike) = ((tn + nt) * xy, difference * xy);
        [
            Vector2::new(nn * yy + tt * xx - mixed, tn * xx - nt * yy - unlike),
            Vector2::new(nt * xx - tn * yy - unlike, nn * xx + tt * yy + mixed),
        ]
    }
}

/// What the forces on the slave point and on both nodes change by, as x1 and x2 move: a row for each component.
pub(super) struct BySegment<D> {
    pub(super) fs: [[Vector2<D>; 2]; 2],
    pub(super) f1: [[Vector2<D>; 2]; 2],
    pub(super) f2: [[Vector2<D>; 2]; 2],
}

/// What the blocks are made of; where there are two, of both nodes.
pub(super) struct Parts<D> {
    weights: [D; 2],
    /// Of the place before.
    before: [D; 2],
    /// E11/ℓ.
    lean: D,
    /// A S11/ℓ and A S12/ℓ, and of S12 what is not `stuck` times the slip.
    normal: D,
    shear: D,
    rest: D,
    /// What S12 changes by with S11.
    by_s11: D,
    /// A times what S11 falls by with E11, A times what S12 changes by with the slip, and the difference.
    pressed: D,
    stuck: D,
    unlike: D,
}

/// x1 turns the segment to the right as it moves along n, and x2 to the left.
const SIGNS: [f64; 2] = [-1.0, 1.0];

impl<D: Scalar> Parts<D> {
    /// With g and S12 before, and A, S11 and S12. S11 falls by `stiffness` times E11; S12 changes with S11, the slip, and what it
    /// was, by the last three.
    #[inline(always)]
    pub(super) fn new(
        line: &Projection<D>,
        [g, s12_before]: [D; 2],
        [area, s11, s12]: [D; 3],
        stiffness: D,
        [by_s11, by_dslip, by_before]: [D; 3],
    ) -> Self {
        let per = area * line.per_length;
        Self {
            weights: line.weights,
            before: shape::linear(g),
            lean: line.separation * line.per_length,
            normal: s11 * per,
            shear: s12 * per,
            rest: (s12_before * by_before + s11 * by_s11) * per,
            by_s11,
            pressed: area * stiffness,
            stuck: area * by_dslip,
            unlike: area * (stiffness - by_dslip),
        }
    }

    /// Where N' and S12/ℓ would stand: `stuck` times N', and ± A S12/ℓ.
    #[inline(always)]
    fn held(&self, j: usize) -> D {
        self.weights[j] * self.stuck + self.rest * SIGNS[j]
    }

    /// Of the force on the slave point, as node j moves. S11 is what it falls by with E11, times −E11. The difference is
    /// `pressed` less `held(j)`, where both stiffnesses may be nearly equal: they are subtracted before the weight is a factor.
    #[inline(always)]
    fn of_slave(&self, j: usize) -> Block<D> {
        let (sign, pressed) = (SIGNS[j], self.weights[j] * self.pressed);
        Block {
            nn: pressed - self.shear * sign,
            nt: D::zero(),
            tn: self.lean * self.unlike * sign - pressed * self.by_s11,
            tt: self.before[j] * self.stuck,
            difference: self.weights[j] * self.unlike - self.rest * sign,
        }
    }

    /// Of the force on node i, −Nᵢ fs, where ℓ δNᵢ is ± (E11/ℓ δn − Nⱼ δt).
    #[inline(always)]
    fn of_node(&self, i: usize, j: usize) -> Block<D> {
        let Self { weights, normal, shear, .. } = *self;
        let (slave, weight) = (self.of_slave(j), weights[i]);
        let (along, across) = (weights[j] * SIGNS[i], self.lean * (SIGNS[i] * SIGNS[j]));
        Block {
            nn: -(slave.nn * weight + normal * across),
            nt: normal * along,
            tn: shear * across - slave.tn * weight,
            tt: -if i == j { self.held(j) * weight } else { slave.tt * weight + shear * along },
            difference: shear * along - (slave.difference * weight + normal * across),
        }
    }

    #[inline(always)]
    pub(super) fn by_segment(&self, t: &Vector2<D>) -> BySegment<D> {
        BySegment {
            fs: [self.of_slave(0).rows(t), self.of_slave(1).rows(t)],
            f1: [self.of_node(0, 0).rows(t), self.of_node(0, 1).rows(t)],
            f2: [self.of_node(1, 0).rows(t), self.of_node(1, 1).rows(t)],
        }
    }
}
