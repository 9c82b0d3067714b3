//! Straight and parabolic segments, and the elements that slide on them, each with its formulas.

use super::chain::{Term, chain, components, joined, through};
use super::fields::{Isl21aNodes, Isl21aState, Isl22aNodes, Isl22aState};
use super::forces;
use crate::contact::slide_line::{
    ClosestLinear, ClosestParabolic, ContactAreaLinear, ContactAreaParabolic, CurvePoint, LinearMotion, LinearNodes,
    LinearPressures, LinearSlave, ParabolicMotion, ParabolicNodes, ParabolicPlace, ParabolicPoint, ParabolicPressures,
    ParabolicSlave, SlipIncrementLinear, SlipIncrementParabolic, TorqueLinear, TorqueParabolic, gauss,
};
use crate::formula::error::Error;
use crate::formula::{Component, Field, Fields, Formula};
use crate::number::scalar::{Scalar, abs, choice};
use nalgebra::Vector2;
use std::fmt::Debug;

pub type Point<D, const K: usize> = Vector2<Term<D, K>>;

/// The closest point of a segment.
#[derive(Clone, Copy, Debug)]
pub struct Touched<D, const K: usize> {
    pub(super) g: Term<D, K>,
    pub(super) separation: Term<D, K>,
}

/// The slave nodes of an element, and the nodes of the segment under each of them.
#[derive(Clone, Copy, Debug)]
pub struct Points<P, const N: usize> {
    pub(super) slaves: [P; N],
    pub(super) segments: [[P; N]; N],
}

/// A segment of N nodes, and the element that has as many slave nodes and K degrees of freedom. What happens at one slave node
/// depends on L of them: on the translations of all slave nodes, and of the nodes of its segment.
pub trait Segment<const N: usize, const L: usize, const K: usize>:
    Copy + Debug + PartialEq + Send + Sync + 'static
{
    /// The translations of all nodes, and the forces on them.
    const UNKNOWNS: &'static [Field];
    const FORCES: &'static [Field];
    /// The positions of all nodes.
    type Nodes<T: Component>: Fields<T>;
    /// What the slave nodes remember: their positions along the segments, then their shear stresses.
    type State<T: Component>: Fields<T>;

    /// The nodes, with derivatives with respect to the slave nodes and to the nodes of one segment.
    fn varied<D: Scalar>(nodes: &Self::Nodes<D>) -> Points<Point<D, L>, N> {
        let all = components(nodes, D::zero());
        let point = |node: usize, first: usize| {
            Vector2::from_fn(|axis, _| Term::variable(all.as_ref()[2 * node + axis], first + axis))
        };
        let segment = |slave: usize| std::array::from_fn(|k| point(N + N * slave + k, 2 * (N + k)));
        Points { slaves: std::array::from_fn(|k| point(k, 2 * k)), segments: std::array::from_fn(segment) }
    }

    /// The closest point to a slave node; past the ends of a straight segment, that of the whole line.
    fn touched<D: Scalar>(xs: Point<D, L>, segment: &[Point<D, L>; N]) -> Touched<D, L>;
    /// Whether a slave node is between the ends of its segment or exactly above one, from its closest point.
    fn is_inside<D: Scalar>(xs: Vector2<D>, segment: [Vector2<D>; N], g: D) -> bool;
    /// The distance along the segment in its current configuration, from a point to the closest point of the slave node.
    fn path_length<D: Scalar>(xs: Point<D, L>, segment: &[Point<D, L>; N], from: D, to: Term<D, L>) -> Term<D, L>;
    /// Forces on the slave node and on the segment, from area, S11 and S12.
    fn forces<D: Scalar>(
        segment: &[Point<D, L>; N],
        g: Term<D, L>,
        loads: [Term<D, L>; 3],
    ) -> (Point<D, L>, [Point<D, L>; N]);
    /// The contact areas of the nodes of an element.
    fn areas<D: Scalar>(nodes: &[Point<D, L>; N]) -> [Term<D, L>; N];
    /// The torque of an element from the pressures at its nodes; its derivatives with respect to the slave nodes, then to the
    /// pressures.
    fn torque<D: Scalar>(slaves: &[Vector2<D>; N], pressures: &[D; N]) -> (D, [Vector2<D>; N], [D; N]);
    /// Checks a slave node, and a segment of distinct nodes.
    fn check<D: Scalar>(xs: Vector2<D>, segment: [Vector2<D>; N]) -> Result<(), Error>;
}

/// A straight segment, and ISL21A.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Straight;

impl Segment<2, 8, 12> for Straight {
    const UNKNOWNS: &'static [Field] = Isl21aNodes::<f64>::UNKNOWNS;
    const FORCES: &'static [Field] = Isl21aNodes::<f64>::FORCES;
    type Nodes<T: Component> = Isl21aNodes<T>;
    type State<T: Component> = Isl21aState<T>;

    fn touched<D: Scalar>(xs: Point<D, 8>, &[x1, x2]: &[Point<D, 8>; 2]) -> Touched<D, 8> {
        let foot = through::<ClosestLinear, _, 8>(&LinearSlave { xs, x1, x2 }, ClosestLinear::on_line);
        Touched { g: foot.g, separation: foot.separation }
    }

    fn is_inside<D: Scalar>(_: Vector2<D>, _: [Vector2<D>; 2], g: D) -> bool {
        abs(g) <= 1.0
    }

    /// Uses positions in place of displacements: they are measured from the current position of the previous point.
    fn path_length<D: Scalar>(xs: Point<D, 8>, &[x1, x2]: &[Point<D, 8>; 2], from: D, _: Term<D, 8>) -> Term<D, 8> {
        let motion = LinearMotion { x1, x2, g: Term::constant(from), dxs: xs, dx1: x1, dx2: x2 };
        chain::<SlipIncrementLinear, _, 8>(&motion).dslip
    }

    fn forces<D: Scalar>(
        &[x1, x2]: &[Point<D, 8>; 2],
        g: Term<D, 8>,
        [area, s11, s12]: [Term<D, 8>; 3],
    ) -> (Point<D, 8>, [Point<D, 8>; 2]) {
        let found = chain::<forces::Linear, _, 8>(&forces::LinearLoads { x1, x2, g, area, s11, s12 });
        (found.fs, [found.f1, found.f2])
    }

    fn areas<D: Scalar>(&[x1, x2]: &[Point<D, 8>; 2]) -> [Term<D, 8>; 2] {
        let areas = chain::<ContactAreaLinear, _, 8>(&LinearNodes { x1, x2 });
        [areas.a1, areas.a2]
    }

    fn torque<D: Scalar>(&[x1, x2]: &[Vector2<D>; 2], &[p1, p2]: &[D; 2]) -> (D, [Vector2<D>; 2], [D; 2]) {
        let (torque, by) = TorqueLinear::linearized(&LinearPressures { x1, x2, p1, p2 });
        (torque.t, [by.t.x1, by.t.x2], [by.t.p1, by.t.p2])
    }

    fn check<D: Scalar>(_: Vector2<D>, _: [Vector2<D>; 2]) -> Result<(), Error> {
        Ok(())
    }
}

/// A parabolic segment, and ISL22A.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curved;

impl Segment<3, 12, 24> for Curved {
    const UNKNOWNS: &'static [Field] = Isl22aNodes::<f64>::UNKNOWNS;
    const FORCES: &'static [Field] = Isl22aNodes::<f64>::FORCES;
    type Nodes<T: Component> = Isl22aNodes<T>;
    type State<T: Component> = Isl22aState<T>;

    fn touched<D: Scalar>(xs: Point<D, 12>, &[x1, x2, x3]: &[Point<D, 12>; 3]) -> Touched<D, 12> {
        let foot =
            through::<ClosestParabolic, _, 12>(&ParabolicSlave { xs, x1, x2, x3 }, joined::<ClosestParabolic, _, 18>);
        Touched { g: foot.g, separation: foot.separation }
    }

    /// The search stops at the ends of a segment, both for a slave node exactly above an end and for one past it: above an end
    /// the line to the slave node is normal to the segment.
    fn is_inside<D: Scalar>(xs: Vector2<D>, [x1, x2, x3]: [Vector2<D>; 3], g: D) -> bool {
        let CurvePoint { x, dx } = ParabolicPoint::eval(&ParabolicPlace { x1, x2, x3, g });
        (g > -1.0 && g < 1.0) || (xs - x).dot(&dx) == 0.0
    }

    /// A single Gauss–Legendre rule, as in [`isl`](crate::contact::isl) if the segment bends little between the two points.
    fn path_length<D: Scalar>(
        _: Point<D, 12>,
        &[x1, x2, x3]: &[Point<D, 12>; 3],
        from: D,
        to: Term<D, 12>,
    ) -> Term<D, 12> {
        let constant = |x: D| Term::constant(x);
        let half = constant(D::from(0.5));
        let (middle, reach) = ((to + constant(from)) * half, (to + constant(-from)) * half);
        let none = Vector2::from_element(constant(D::zero()));
        let part = |[place, weight]: [D; 2]| {
            let g = middle + reach * constant(place);
            let rate = chain::<ParabolicPoint, _, 12>(&ParabolicPlace { x1, x2, x3, g }).dx;
            let dxs = rate.map(|rate| rate * reach * constant(weight));
            let motion = ParabolicMotion { x1, x2, x3, g, dxs, dx1: none, dx2: none, dx3: none };
            through::<SlipIncrementParabolic, _, 12>(&motion, joined::<SlipIncrementParabolic, _, 16>).dslip
        };
        gauss().into_iter().map(part).fold(constant(D::zero()), |path_length, part| path_length + part)
    }

    fn forces<D: Scalar>(
        &[x1, x2, x3]: &[Point<D, 12>; 3],
        g: Term<D, 12>,
        [area, s11, s12]: [Term<D, 12>; 3],
    ) -> (Point<D, 12>, [Point<D, 12>; 3]) {
        let loads = forces::ParabolicLoads { x1, x2, x3, g, area, s11, s12 };
        let found = through::<forces::Parabolic, _, 12>(&loads, joined::<forces::Parabolic, _, 88>);
        (found.fs, [found.f1, found.f2, found.f3])
    }

    fn areas<D: Scalar>(&[x1, x2, x3]: &[Point<D, 12>; 3]) -> [Term<D, 12>; 3] {
        let areas = chain::<ContactAreaParabolic, _, 12>(&ParabolicNodes { x1, x2, x3 });
        [areas.a1, areas.a2, areas.a3]
    }

    fn torque<D: Scalar>(slaves: &[Vector2<D>; 3], pressures: &[D; 3]) -> (D, [Vector2<D>; 3], [D; 3]) {
        let ([x1, x2, x3], [p1, p2, p3]) = (*slaves, *pressures);
        let (torque, by) = joined::<TorqueParabolic, _, 10>(&ParabolicPressures { x1, x2, x3, p1, p2, p3 });
        (torque.t, [by.t.x1, by.t.x2, by.t.x3], [by.t.p1, by.t.p2, by.t.p3])
    }

    fn check<D: Scalar>(xs: Vector2<D>, [x1, x2, x3]: [Vector2<D>; 3]) -> Result<(), Error> {
        let slave = ParabolicSlave { xs, x1, x2, x3 };
        let [g, has_tangent] = choice(|| slave.foot_and_tangent());
        if has_tangent > 0.0 { Ok(()) } else { Err(Error::NoTangent { coordinate: "g", value: g.re() }) }
    }
}
