//! Straight and parabolic segments, and the elements that slide on them, each with its formulas.

use crate::contact::slide_line::element::chain::{Term, chain, through};
use crate::contact::slide_line::element::forces;
use crate::contact::slide_line::{
    ClosestLinear, ClosestParabolic, ContactAreaLinear, ContactAreaParabolic, CurvePoint, LinearMotion, LinearNodes,
    LinearPressures, LinearSlave, ParabolicMotion, ParabolicNodes, ParabolicPlace, ParabolicPoint, ParabolicPressures,
    ParabolicSlave, SlipIncrementLinear, SlipIncrementParabolic, TorqueLinear, TorqueParabolic, gauss,
};
use crate::formula::check;
use crate::formula::error::Error;
use crate::number::scalar::Scalar;
use nalgebra::Vector2;

type Point<D, const K: usize> = Vector2<Term<D, K>>;

/// The closest point of a segment.
pub(super) struct Touched<D, const K: usize> {
    pub(super) g: Term<D, K>,
    pub(super) separation: Term<D, K>,
    /// Whether it is between the ends.
    pub(super) inside: bool,
}

/// A segment of N nodes, and an element with the same number of nodes.
pub(super) trait Shape<const N: usize> {
    /// The closest point to a slave node.
    fn foot<D: Scalar, const K: usize>(xs: Point<D, K>, segment: &[Point<D, K>; N]) -> Touched<D, K>;
    /// The distance along the segment in its current configuration, from a point to the closest point of the slave node.
    fn path_length<D: Scalar, const K: usize>(
        xs: Point<D, K>,
        segment: &[Point<D, K>; N],
        from: D,
        to: Term<D, K>,
    ) -> Term<D, K>;
    /// Forces on the slave node and on the segment, from area, S11 and S12.
    fn forces<D: Scalar, const K: usize>(
        segment: &[Point<D, K>; N],
        g: Term<D, K>,
        loads: [Term<D, K>; 3],
    ) -> (Point<D, K>, [Point<D, K>; N]);
    /// The contact areas of the nodes of an element.
    fn areas<D: Scalar, const K: usize>(nodes: &[Point<D, K>; N]) -> [Term<D, K>; N];
    /// The torque of an element from the pressures at its nodes.
    fn torque<D: Scalar, const K: usize>(nodes: &[Point<D, K>; N], pressures: &[Term<D, K>; N]) -> Term<D, K>;
    /// Checks the positions.
    fn check(nodes: &[Vector2<f64>; N], slave: usize, segment: &[Vector2<f64>; N]) -> Result<(), Error>;
}

/// A straight segment, and ISL21A.
#[derive(Clone, Copy, Debug)]
pub(super) struct Straight;

impl Shape<2> for Straight {
    fn foot<D: Scalar, const K: usize>(xs: Point<D, K>, &[x1, x2]: &[Point<D, K>; 2]) -> Touched<D, K> {
        let foot = through::<ClosestLinear, _, K>(&LinearSlave { xs, x1, x2 }, ClosestLinear::on_line);
        let inside = foot.g.value >= -1.0 && foot.g.value <= 1.0;
        Touched { g: foot.g, separation: foot.separation, inside }
    }

    /// Uses positions in place of displacements: they are measured from the current position of the previous point.
    fn path_length<D: Scalar, const K: usize>(
        xs: Point<D, K>,
        &[x1, x2]: &[Point<D, K>; 2],
        from: D,
        _: Term<D, K>,
    ) -> Term<D, K> {
        let motion = LinearMotion { x1, x2, g: Term::constant(from), dxs: xs, dx1: x1, dx2: x2 };
        chain::<SlipIncrementLinear, _, K>(&motion).dslip
    }

    fn forces<D: Scalar, const K: usize>(
        &[x1, x2]: &[Point<D, K>; 2],
        g: Term<D, K>,
        [area, s11, s12]: [Term<D, K>; 3],
    ) -> (Point<D, K>, [Point<D, K>; 2]) {
        let found = chain::<forces::Linear, _, K>(&forces::LinearLoads { x1, x2, g, area, s11, s12 });
        (found.fs, [found.f1, found.f2])
    }

    fn areas<D: Scalar, const K: usize>(&[x1, x2]: &[Point<D, K>; 2]) -> [Term<D, K>; 2] {
        let areas = chain::<ContactAreaLinear, _, K>(&LinearNodes { x1, x2 });
        [areas.a1, areas.a2]
    }

    fn torque<D: Scalar, const K: usize>(&[x1, x2]: &[Point<D, K>; 2], &[p1, p2]: &[Term<D, K>; 2]) -> Term<D, K> {
        chain::<TorqueLinear, _, K>(&LinearPressures { x1, x2, p1, p2 }).t
    }

    fn check(nodes: &[Vector2<f64>; 2], slave: usize, &[x1, x2]: &[Vector2<f64>; 2]) -> Result<(), Error> {
        let [first, second] = *nodes;
        check::<ContactAreaLinear>(&LinearNodes { x1: first, x2: second })?;
        check::<ClosestLinear>(&LinearSlave { xs: nodes[slave], x1, x2 })
    }
}

/// Whether the line from a point to the slave node is normal to the segment. The search stops at the ends of a segment, both for
/// a slave node exactly above an end and for one past it.
fn is_upright<D: Scalar, const K: usize>(xs: Point<D, K>, place: &ParabolicPlace<Term<D, K>>) -> bool {
    let CurvePoint { x, dx } = chain::<ParabolicPoint, _, K>(place);
    let [along_r, along_z] = [0, 1].map(|axis| (xs[axis] + -x[axis]) * dx[axis]);
    (along_r + along_z).value == D::zero()
}

/// A parabolic segment, and ISL22A.
#[derive(Clone, Copy, Debug)]
pub(super) struct Curved;

impl Shape<3> for Curved {
    fn foot<D: Scalar, const K: usize>(xs: Point<D, K>, &[x1, x2, x3]: &[Point<D, K>; 3]) -> Touched<D, K> {
        let foot = chain::<ClosestParabolic, _, K>(&ParabolicSlave { xs, x1, x2, x3 });
        let is_between = foot.g.value > -1.0 && foot.g.value < 1.0;
        let inside = is_between || is_upright(xs, &ParabolicPlace { x1, x2, x3, g: foot.g });
        Touched { g: foot.g, separation: foot.separation, inside }
    }

    /// A single Gauss–Legendre rule, as in [`isl`](crate::contact::isl) if the segment bends little between the two points.
    fn path_length<D: Scalar, const K: usize>(
        _: Point<D, K>,
        &[x1, x2, x3]: &[Point<D, K>; 3],
        from: D,
        to: Term<D, K>,
    ) -> Term<D, K> {
        let constant = |x: D| Term::constant(x);
        let half = constant(D::from(0.5));
        let (middle, reach) = ((to + constant(from)) * half, (to + constant(-from)) * half);
        let none = Vector2::from_element(constant(D::zero()));
        let part = |[place, weight]: [D; 2]| {
            let g = middle + reach * constant(place);
            let rate = chain::<ParabolicPoint, _, K>(&ParabolicPlace { x1, x2, x3, g }).dx;
            let dxs = rate.map(|rate| rate * reach * constant(weight));
            let motion = ParabolicMotion { x1, x2, x3, g, dxs, dx1: none, dx2: none, dx3: none };
            chain::<SlipIncrementParabolic, _, K>(&motion).dslip
        };
        gauss().into_iter().map(part).fold(constant(D::zero()), |path_length, part| path_length + part)
    }

    fn forces<D: Scalar, const K: usize>(
        &[x1, x2, x3]: &[Point<D, K>; 3],
        g: Term<D, K>,
        [area, s11, s12]: [Term<D, K>; 3],
    ) -> (Point<D, K>, [Point<D, K>; 3]) {
        let found = chain::<forces::Parabolic, _, K>(&forces::ParabolicLoads { x1, x2, x3, g, area, s11, s12 });
        (found.fs, [found.f1, found.f2, found.f3])
    }

    fn areas<D: Scalar, const K: usize>(&[x1, x2, x3]: &[Point<D, K>; 3]) -> [Term<D, K>; 3] {
        let areas = chain::<ContactAreaParabolic, _, K>(&ParabolicNodes { x1, x2, x3 });
        [areas.a1, areas.a2, areas.a3]
    }

    fn torque<D: Scalar, const K: usize>(nodes: &[Point<D, K>; 3], pressures: &[Term<D, K>; 3]) -> Term<D, K> {
        let ([x1, x2, x3], [p1, p2, p3]) = (*nodes, *pressures);
        chain::<TorqueParabolic, _, K>(&ParabolicPressures { x1, x2, x3, p1, p2, p3 }).t
    }

    fn check(nodes: &[Vector2<f64>; 3], slave: usize, &[x1, x2, x3]: &[Vector2<f64>; 3]) -> Result<(), Error> {
        let [first, second, third] = *nodes;
        check::<ContactAreaParabolic>(&ParabolicNodes { x1: first, x2: second, x3: third })?;
        check::<ClosestParabolic>(&ParabolicSlave { xs: nodes[slave], x1, x2, x3 })
    }
}
