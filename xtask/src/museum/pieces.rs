//! The errors. Rows of a Jacobian are the outputs, columns the inputs, with components in the order of the entry.

use super::piece::{Piece, Planted};
use super::shipped::{Inputs, Mistake, OPTIONS, Right, Rows, Shipped, changed, judged, rows};
use jointproof::connector::{slot, ujoint, universal};
use jointproof::contact::{coulomb, slide_line};
use jointproof::element;
use jointproof::formula::proof::Proved;
use jointproof::formula::{Fields, Formula};
use jointproof::number::scalar::{Scalar, norm};
use jointproof::toolkit::verify::{Audit, audit};
use judge::Judged;

fn piece<M: Mistake>([thread, there, here]: [&'static str; 3], claim: &'static str) -> Piece {
    let control: fn() -> Audit = || audit::<Shipped<Right<M::Of>>>(&OPTIONS);
    let formula = M::Of::SPEC.id;
    let planted = if in_value::<M>() { Planted::Value } else { Planted::Jacobian };
    let judged: [fn() -> Judged; 2] = [judged::<M>, judged::<Right<M::Of>>];
    Piece { thread, there, here, formula, claim, planted, audit: || audit::<Shipped<M>>(&OPTIONS), control, judged }
}

/// Whether the value is wrong at a case of the formula, alone or where it comes with the Jacobian.
fn in_value<M: Mistake>() -> bool {
    let same = |a: Vec<f64>, b: Vec<f64>| a.iter().map(|x| x.to_bits()).eq(b.iter().map(|x| x.to_bits()));
    <M::Of as Proved>::cases().iter().filter(|case| M::Of::validate(&case.inputs).is_ok()).any(|case| {
        let right = || M::Of::eval(&case.inputs).components();
        !same(M::value(&case.inputs), right()) || !same(M::value_with_jacobian(&case.inputs), right())
    })
}

const CLOSED: &str = "closed form = automatic differentiation";

/// Every error.
pub(super) fn all() -> Vec<Piece> {
    vec![
        piece::<LimitSign>(
            [
                "GEOS, [pull request 3439](https://github.com/GEOS-DEV/GEOS/pull/3439)",
                "Coulomb friction: the derivative of the limit with respect to the normal traction had the wrong sign. One caller corrected the sign, another did not.",
                "the derivative of the friction force with respect to the normal force has the wrong sign.",
            ],
            CLOSED,
        ),
        piece::<NearBranch>(
            [
                "ipc-toolkit, pull requests [238](https://github.com/ipc-sim/ipc-toolkit/pull/238) and [239](https://github.com/ipc-sim/ipc-toolkit/pull/239); polyfem, [pull request 501](https://github.com/polyfem/polyfem/pull/501)",
                "A derivative was wrong near a branch that the test, at random points, never reached.",
                "below a length of a millionth the derivative is that of a smoothed length.",
            ],
            CLOSED,
        ),
        piece::<DistanceFromOrigin>(
            [
                "newton, [issue 3866](https://github.com/newton-physics/newton/issues/3866) and [pull request 3868](https://github.com/newton-physics/newton/pull/3868)",
                "The Jacobian was wrong by the distance from the origin.",
                "the lever arm of the moment is the position of b instead of the vector from a to b.",
            ],
            "frame indifference",
        ),
        piece::<NormalDerivative>(
            [
                "moose, [issue 33378](https://github.com/idaholab/moose/issues/33378) and [pull request 33390](https://github.com/idaholab/moose/pull/33390)",
                "The derivatives of the nodal normal were missing.",
                "the normal of the slide line is treated as constant.",
            ],
            CLOSED,
        ),
        piece::<MissingMinus>(
            [
                "goma, [pull request 188](https://github.com/goma/goma/pull/188)",
                "A minus sign was missing; all 106 tests passed before and after the correction.",
                "the derivative of the rotation with respect to its initial value has the wrong sign.",
            ],
            CLOSED,
        ),
        piece::<CopiedStiffness>(
            [
                "mastodon, [issue 333](https://github.com/idaholab/mastodon/issues/333)",
                "A stiffness matrix was copied wrongly from another program.",
                "the stiffness by the spin of a is copied from a program that stores matrices by columns.",
            ],
            "printed equation = value",
        ),
        piece::<TwoResiduals>(
            [
                "tacs, [pull request 74](https://github.com/smdogroup/tacs/pull/74)",
                "The residual computed together with the Jacobian differs from the residual computed alone.",
                "the value computed with the Jacobian omits the internal contact force.",
            ],
            "η of the value",
        ),
        piece::<OtherConvention>(
            [
                "Marmot, [pull request 40](https://github.com/MAteRialMOdelingToolbox/Marmot/pull/40)",
                "The stiffness was the derivative of the force in one place and its negative in another.",
                "the Jacobian is that of the negative forces.",
            ],
            CLOSED,
        ),
        piece::<OneColumn>(
            [
                "CADET, [pull request 358](https://github.com/cadet/CADET-Core/pull/358)",
                "The test of the Jacobian compared a column with itself.",
                "a column is that of another input, which such a test does not detect.",
            ],
            CLOSED,
        ),
        piece::<ChainRule>(
            [
                "kaolin, [pull request 983](https://github.com/NVIDIAGameWorks/kaolin/pull/983)",
                "A term of the chain rule through the friction was missing.",
                "the derivative of the yield function omits the dependence of the normal force on the transverse forces.",
            ],
            CLOSED,
        ),
        piece::<Transposed>(
            [
                "moose, [issue 22225](https://github.com/idaholab/moose/issues/22225)",
                "A tangent was transposed and wrong by up to 80 %, while the Jacobian debugger reported no error.",
                "the Jacobian is transposed.",
            ],
            CLOSED,
        ),
        piece::<OtherAngle>(
            [
                "A user routine for a constant-velocity joint, as mirrors of one edition print it",
                "In a product, the cosine of one half angle and the sine of the other are exchanged; the printed derivative is that of the correct product.",
                "in a product of the value two indices are exchanged, but not in its derivative.",
            ],
            CLOSED,
        ),
    ]
}

#[derive(Clone, Copy)]
struct LimitSign;
impl Mistake for LimitSign {
    type Of = coulomb::ReturnMap;
    fn rows<D: Scalar>(i: &Inputs<Self, D>) -> Rows<D> {
        let mut rows = rows::<Self::Of, D>(i);
        rows[0][2] = -rows[0][2];
        rows
    }
}

#[derive(Clone, Copy)]
struct NearBranch;
impl Mistake for NearBranch {
    type Of = slot::ContactForce;
    fn rows<D: Scalar>(i: &Inputs<Self, D>) -> Rows<D> {
        let length = norm([i.f2, i.f3]);
        if length > 0.0 && length < 1e-6 {
            return vec![vec![i.f2 / 1e-6, i.f3 / 1e-6]];
        }
        rows::<Self::Of, D>(i)
    }
}

#[derive(Clone, Copy)]
struct DistanceFromOrigin;
impl DistanceFromOrigin {
    /// With node a at the origin.
    fn there<D: Scalar>(i: &Inputs<Self, D>) -> Inputs<Self, D> {
        changed(i, |x, k| if (9..12).contains(&k) { D::zero() } else { x[k] })
    }
}
impl Mistake for DistanceFromOrigin {
    type Of = element::line::Rows;
    fn value<D: Scalar>(i: &Inputs<Self, D>) -> Vec<D> {
        use jointproof::formula::Fields;
        Self::Of::eval(&Self::there(i)).components()
    }
    fn rows<D: Scalar>(i: &Inputs<Self, D>) -> Rows<D> {
        let mut rows = rows::<Self::Of, D>(&Self::there(i));
        for row in &mut rows {
            row[9..12].fill(D::zero());
        }
        rows
    }
}

#[derive(Clone, Copy)]
struct NormalDerivative;
impl Mistake for NormalDerivative {
    type Of = slide_line::LocalBasis;
    fn rows<D: Scalar>(i: &Inputs<Self, D>) -> Rows<D> {
        let mut rows = rows::<Self::Of, D>(i);
        rows[2..].iter_mut().for_each(|row| row.fill(D::zero()));
        rows
    }
}

#[derive(Clone, Copy)]
struct MissingMinus;
impl Mistake for MissingMinus {
    type Of = universal::RelativeMotion;
    fn rows<D: Scalar>(i: &Inputs<Self, D>) -> Rows<D> {
        let mut rows = rows::<Self::Of, D>(i);
        // ∂ur1/∂α₀
        rows[0][2] = -rows[0][2];
        rows
    }
}

#[derive(Clone, Copy)]
struct CopiedStiffness;
impl CopiedStiffness {
    /// The second matrix, transposed.
    fn place(k: usize) -> usize {
        if k < 9 { k } else { 9 + 3 * ((k - 9) % 3) + (k - 9) / 3 }
    }
}
impl Mistake for CopiedStiffness {
    type Of = element::line::GeometricStiffness;
    fn value<D: Scalar>(i: &Inputs<Self, D>) -> Vec<D> {
        use jointproof::formula::Fields;
        let right = Self::Of::eval(i).components();
        (0..right.len()).map(|k| right[Self::place(k)]).collect()
    }
    fn rows<D: Scalar>(i: &Inputs<Self, D>) -> Rows<D> {
        let right = rows::<Self::Of, D>(i);
        (0..right.len()).map(|k| right[Self::place(k)].clone()).collect()
    }
}

#[derive(Clone, Copy)]
struct TwoResiduals;
impl Mistake for TwoResiduals {
    type Of = slot::Friction;
    fn value_with_jacobian<D: Scalar>(i: &Inputs<Self, D>) -> Vec<D> {
        Self::value(&slot::SlotLoads { fc_int: D::zero(), ..*i })
    }
}

#[derive(Clone, Copy)]
struct OtherConvention;
impl Mistake for OtherConvention {
    type Of = element::line::Forces;
    fn rows<D: Scalar>(i: &Inputs<Self, D>) -> Rows<D> {
        let right = rows::<Self::Of, D>(i);
        right.into_iter().map(|row| row.into_iter().map(|entry| -entry).collect()).collect()
    }
}

#[derive(Clone, Copy)]
struct OneColumn;
impl Mistake for OneColumn {
    type Of = slot::Friction;
    fn rows<D: Scalar>(i: &Inputs<Self, D>) -> Rows<D> {
        let mut rows = rows::<Self::Of, D>(i);
        for row in &mut rows {
            row[2] = row[1];
        }
        rows
    }
}

#[derive(Clone, Copy)]
struct ChainRule;
impl Mistake for ChainRule {
    type Of = slot::Friction;
    fn rows<D: Scalar>(i: &Inputs<Self, D>) -> Rows<D> {
        let mut rows = rows::<Self::Of, D>(i);
        rows[2][1..3].fill(D::zero());
        rows
    }
}

#[derive(Clone, Copy)]
struct Transposed;
impl Mistake for Transposed {
    type Of = ujoint::TwistFactors;
    fn rows<D: Scalar>(i: &Inputs<Self, D>) -> Rows<D> {
        let right = rows::<Self::Of, D>(i);
        (0..2).map(|row| (0..2).map(|column| right[column][row]).collect()).collect()
    }
}

#[derive(Clone, Copy)]
struct OtherAngle;
impl Mistake for OtherAngle {
    type Of = ujoint::CrossDirection;
    fn value<D: Scalar>(i: &Inputs<Self, D>) -> Vec<D> {
        use jointproof::formula::Fields;
        let (x, mut cross) = (i.components(), Self::Of::eval(i).components());
        // a₂ b₃ for a₃ b₂ in the first component of a × b
        cross[0] += x[1] * x[5] - x[2] * x[4];
        cross
    }
}

#[cfg(test)]
mod tests {
    use super::CopiedStiffness;

    #[test]
    fn the_second_matrix_alone_is_transposed() {
        let places: Vec<_> = (0..18).map(CopiedStiffness::place).collect();
        assert_eq!(places, [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 12, 15, 10, 13, 16, 11, 14, 17]);
    }
}
