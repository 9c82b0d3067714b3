//! Evidence for the elements of the parent module: poses, the virtual work of pressure and shear, friction.

use super::{Isl, IslContact, Points, Segment};
use crate::contact::coulomb::{Tractions, Yield};
use crate::contact::interaction::{PressureExponential, PressureLinear};
use crate::contact::slide_line::closest::evidence::slave_point;
use crate::contact::slide_line::element::{Curved, ExponentialLaw, LinearLaw, PressureLaw, Straight};
use crate::contact::slide_line::{
    CurvePoint, LinearPlace, LinearPoint, ParabolicPlace, ParabolicPoint, length_and_tangent,
};
use crate::formula::element::Parameters;
use crate::formula::proof::{Case, Flag, ProvedElement, Rubbed, Step};
use crate::formula::{Fields, Formula};
use crate::number::scalar::{Scalar, abs, constant, leaf};
use nalgebra::{SVector, Vector2};

/// A pressure law with parameters for its cases.
trait Law: PressureLaw {
    const PARAMETERS: Self::Parameters<f64>;
    /// What contact without overclosure is: a kink where the pressure begins there.
    const TOUCHING: Flag;
    /// Whether this pose shows something of the law. Those about the line alone are shown with the linear law.
    fn is_shown(pose: &str) -> bool;
}

impl Law for PressureLinear {
    const PARAMETERS: LinearLaw<f64> = LinearLaw { k: 64.0 };
    const TOUCHING: Flag = Flag::Kink;
    fn is_shown(_: &str) -> bool {
        true
    }
}

impl Law for PressureExponential {
    const PARAMETERS: ExponentialLaw<f64> = ExponentialLaw { c0: 0.5, p0: 20.0 };
    const TOUCHING: Flag = Flag::Hard;
    fn is_shown(pose: &str) -> bool {
        ["washer", "chain", "touching", "barely", "open"].contains(&pose)
    }
}

/// A pose: what it is for, its name, what is to be seen, the slave nodes, and the segments under them.
type Pose<const N: usize> = (Flag, &'static str, &'static str, [Vector2<f64>; N], [[Vector2<f64>; N]; N]);

/// A segment with its poses.
trait Posed<const N: usize, const L: usize, const K: usize>: Segment<N, L, K> {
    fn poses(touching: Flag) -> Vec<Pose<N>>;
    fn point<D: Scalar>(segment: [Vector2<D>; N], g: D) -> CurvePoint<D>;
}

fn at(r: f64, z: f64) -> Vector2<f64> {
    Vector2::new(r, z)
}

impl Posed<2, 8, 12> for Straight {
    fn poses(touching: Flag) -> Vec<Pose<2>> {
        let (washer, cone) = ([at(1.0, 0.0), at(5.0, 0.0)], [at(1.0, 0.0), at(5.0, 2.0)]);
        let chain = [[at(1.0, 0.0), at(3.0, 1.0)], [at(3.0, 1.0), at(5.0, 1.25)]];
        let far = at(0.0, 1e8);
        let ring = |z: f64| [at(2.25, z), at(2.75, z)];
        let nodes = [at(2.0, 0.25), at(3.5, 0.75)];
        vec![
            (
                Flag::Hand,
                "washer",
                "pressed by 1/8 onto a flat washer; the first node was dragged along by 1/4",
                ring(-0.125),
                [washer; 2],
            ),
            (Flag::Hard, "chain", "each node on its own segment", nodes, chain),
            (Flag::Hard, "cone", "both nodes on one inclined segment", nodes, [cone; 2]),
            (Flag::Hard, "wall", "the segment is parallel to the axis", [at(2.125, 0.5), at(2.25, 1.0)], {
                [[at(2.0, 2.0), at(2.0, 0.0)]; 2]
            }),
            (touching, "touching", "no overclosure", ring(0.5), [washer.map(|x| x + at(0.0, 0.5)); 2]),
            (Flag::Hard, "barely", "an overclosure of 2⁻³⁰", ring(-f64::EPSILON * 4_194_304.0), [washer; 2]),
            (Flag::Hard, "open", "nothing presses with the linear law", ring(0.25), [washer; 2]),
            (
                Flag::Hard,
                "past",
                "the first node is past the end of the segment",
                [at(0.75, -0.125), at(2.0, -0.25)],
                { [washer; 2] },
            ),
            (Flag::Kink, "end", "both nodes are exactly above an end", [at(1.0, -0.125), at(5.0, -0.25)], [washer; 2]),
            (Flag::Hard, "inner", "the first node is on the axis", [at(0.0, -0.125), at(0.5, -0.125)], {
                [[at(0.0, 0.5), at(1.0, -0.25)]; 2]
            }),
            (Flag::Hard, "offset-1e8", "far along the axis", nodes.map(|x| x + far), chain.map(|s| s.map(|x| x + far))),
        ]
    }

    fn point<D: Scalar>([x1, x2]: [Vector2<D>; 2], g: D) -> CurvePoint<D> {
        LinearPoint::eval(&LinearPlace { x1, x2, g })
    }
}

impl Posed<3, 12, 24> for Curved {
    fn poses(touching: Flag) -> Vec<Pose<3>> {
        let (washer, arch) = ([at(1.0, 0.0), at(3.0, 0.0), at(5.0, 0.0)], [at(1.0, 0.0), at(2.25, 1.0), at(4.0, 0.5)]);
        let bowl = [at(1.0, 1.0), at(2.0, 0.25), at(3.0, 1.0)];
        let chain =
            [arch, [at(4.0, 0.5), at(4.5, 0.0), at(5.25, -0.25)], [at(5.25, -0.25), at(6.0, -0.375), at(7.0, 0.0)]];
        let far = at(0.0, 1e8);
        let ring = |z: f64| [at(2.25, z), at(2.5, z), at(2.75, z)];
        let nodes = [at(1.5, 0.25), at(2.25, 0.75), at(3.0, 0.5)];
        vec![
            (
                Flag::Hand,
                "washer",
                "pressed by 1/8 onto a flat washer; the first node was dragged along by 1/4",
                ring(-0.125),
                [washer; 3],
            ),
            (Flag::Hard, "arch", "all nodes on one arch", nodes, [arch; 3]),
            (
                Flag::Hard,
                "chain",
                "each node on its own segment",
                [at(2.0, 0.75), at(4.5, -0.125), at(6.0, -0.5)],
                chain,
            ),
            (Flag::Hard, "bowl", "a hollow line", [at(1.5, 0.25), at(2.125, 0.125), at(2.5, 0.375)], [bowl; 3]),
            (touching, "touching", "no overclosure", ring(0.5), [washer.map(|x| x + at(0.0, 0.5)); 3]),
            (Flag::Hard, "barely", "an overclosure of 2⁻³⁰", ring(-f64::EPSILON * 4_194_304.0), [washer; 3]),
            (Flag::Hard, "open", "nothing presses with the linear law", ring(0.25), [washer; 3]),
            (
                Flag::Hard,
                "past",
                "the first node is past the end of the segment",
                { [at(0.75, -0.125), at(2.0, -0.125), at(3.0, -0.25)] },
                [washer; 3],
            ),
            (
                Flag::Kink,
                "end",
                "two nodes are exactly above an end",
                [at(1.0, -0.125), at(3.0, -0.25), at(5.0, -0.125)],
                { [washer; 3] },
            ),
            (Flag::Hard, "offset-1e8", "far along the axis", nodes.map(|x| x + far), [arch.map(|x| x + far); 3]),
        ]
    }

    fn point<D: Scalar>([x1, x2, x3]: [Vector2<D>; 3], g: D) -> CurvePoint<D> {
        ParabolicPoint::eval(&ParabolicPlace { x1, x2, x3, g })
    }
}

/// What is known at a slave node that transmits something.
struct Slave<D, const N: usize> {
    k: usize,
    xs: Vector2<D>,
    segment: [Vector2<D>; N],
    area: D,
    g: D,
    slip: D,
    e11: D,
    s11: D,
}

/// The slave nodes that press.
fn pressing<S, P, D: Scalar, const N: usize, const L: usize, const K: usize>(
    step: &Step<Isl<S, P, N, L>, D, 1, K>,
) -> Vec<Slave<D, N>>
where
    S: Segment<N, L, K>,
    P: PressureLaw,
{
    let (Points { slaves, segments }, before) = (S::varied(&step.nodes), step.before.components());
    let areas = S::areas(&slaves);
    let slave = |k: usize| {
        let foot = S::touched(slaves[k], &segments[k]);
        let slip = S::path_length(slaves[k], &segments[k], before[k], foot.g).value;
        let (xs, segment) = (slaves[k].map(|x| x.value), segments[k].map(|x| x.map(|x| x.value)));
        let (g, e11) = (foot.g.value, foot.separation.value);
        let [s11, _] = P::pressure(-e11, &step.parameters.start);
        let presses = S::is_inside(xs, segment, g) && s11 > 0.0;
        presses.then(|| Slave { k, xs, segment, area: areas[k].value, g, slip, e11, s11 })
    };
    (0..N).filter_map(slave).collect()
}

impl<S, P, const N: usize, const L: usize, const K: usize> ProvedElement<1, K> for Isl<S, P, N, L>
where
    S: Posed<N, L, K>,
    P: Law,
{
    fn cases() -> Vec<Case<Step<Self, f64, 1, K>>> {
        let state = [vec![-0.5; N], vec![0.125; N]].concat();
        let before = S::State::from_slice(&state).expect("a state has two numbers for every slave node");
        let stiff = IslContact { k_stick: 1e3, mu: 0.25 };
        let ways = [("", None), ("-sticks", Some(IslContact { k_stick: 0.5, ..stiff })), ("-slips", Some(stiff))];
        let pose = |(flag, id, comment, slaves, segments): Pose<N>| {
            let points: Vec<_> = slaves.iter().chain(segments.as_flattened()).flat_map(|x| [x.x, x.y]).collect();
            let nodes = S::Nodes::from_slice(&points).expect("a pose has a point for every node");
            ways.map(|(how, contact)| {
                let parameters = Parameters { start: P::PARAMETERS, contact };
                let step = Step { nodes, multipliers: SVector::zeros(), parameters, before };
                Case::new(flag, format!("{id}{how}"), comment, step)
            })
        };
        let poses = S::poses(P::TOUCHING).into_iter().filter(|(_, id, ..)| P::is_shown(id));
        poses.flat_map(pose).collect()
    }

    /// Segments of a length of about 1, with the slave nodes above or below them.
    fn placed(drawn: Step<Self, f64, 1, K>) -> Step<Self, f64, 1, K> {
        let bounded = |x: f64| x / (1.0 + x.abs());
        let all = drawn.nodes.components();
        let point = |node: usize| at(all[2 * node], all[2 * node + 1]);
        let mut points = vec![Vector2::zeros(); N];
        for slave in 0..N {
            let of = |k: usize| point(N + N * slave + k).map(bounded);
            let first = at(3.0, 0.0) + of(0) * 2.0;
            let last = first + at(1.5, 0.0) + of(N - 1);
            let middle = (first + last) * 0.5 + of(1) * 0.25;
            let segment = std::array::from_fn(|k| {
                if k == 0 {
                    first
                } else if k == N - 1 {
                    last
                } else {
                    middle
                }
            });
            let drawn = point(slave);
            points[slave] = slave_point(at(drawn.x, bounded(drawn.y) * 0.25), |g| {
                let CurvePoint { x, dx } = S::point(segment, g);
                [x, dx]
            });
            points.extend(segment);
        }
        let points: Vec<_> = points.iter().flat_map(|x| [x.x, x.y]).collect();
        let mut state = drawn.before.components();
        state[..N].iter_mut().for_each(|g| *g = bounded(*g));
        let nodes = S::Nodes::from_slice(&points).expect("there are as many points");
        Step { nodes, before: S::State::from_slice(&state).expect("there are as many numbers"), ..drawn }
    }

    fn work<D: Scalar>(step: &Step<Self, D, 1, K>, after: &S::State<D>) -> D {
        let (held, s12) = (|x: D| constant::<D>(leaf(x)), after.components().split_off(N));
        pressing(step).into_iter().fold(D::zero(), |work, slave| {
            let (_, t) = length_and_tangent(S::point(slave.segment, slave.g).dx);
            // The motion relative to the material at the closest point.
            let motion = t.map(held).dot(&(slave.xs - S::point(slave.segment, held(slave.g)).x));
            work + held(slave.area) * (held(slave.s11) * slave.e11 - held(s12[slave.k]) * motion)
        })
    }

    fn rubbed<D: Scalar>(step: &Step<Self, D, 1, K>, after: &S::State<D>) -> Vec<Rubbed<D>> {
        let Some(IslContact { k_stick, mu }) = step.parameters.contact else { return Vec::new() };
        let (before, after) = (step.before.components().split_off(N), after.components().split_off(N));
        let rubbed = |Slave { k, slip, s11, .. }: Slave<D, N>| {
            let phi = Yield::eval(&Tractions { p: abs(after[k]), mu, r#fn: s11 }).phi;
            Rubbed { motion: slip, force: [before[k], after[k]], k_stick, phi }
        };
        pressing(step).into_iter().map(rubbed).collect()
    }
}
