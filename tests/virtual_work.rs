//! One sign convention, proved: in every virtual motion the work of a connector's forces on its two nodes equals that of the
//! constraint forces on the residuals minus that of the kinetic forces on the available motions.
//!
//! Motions are translations and spins of both nodes, derivatives are automatic, in 237 bits. The forces on the nodes are
//! assembled here from the formulas and the convention only: constraint forces act on b, kinetic ones on a, and their opposites,
//! in equilibrium, on the other node.

use jointproof::Octuple;
use jointproof::connector::align;
use jointproof::connector::join;
use jointproof::connector::slot::{
    Constraint, Constraint2d, ConstraintForce, CrossFrame, KineticForce, Positions, RelativeMotion, RelativePosition,
    SlotForce, SlotLengths, SlotPositions, SlotPositions2d,
};
use jointproof::connector::translator;
use jointproof::connector::ujoint;
use jointproof::connector::universal::{self, Driven, Shafts, TurnsSince, Twisted};
use jointproof::element::cardan::{Triads, accurate};
use jointproof::element::cardan::{rotation, turned};
use jointproof::formula::Formula;
use nalgebra::{Vector2, Vector3};
use num_dual::Dual;
use proptest::prelude::Rng;
use proptest::test_runner::{RngAlgorithm, TestRng};

type V = Vector3<Octuple>;
type Moving = Dual<Octuple>;

/// Far below the resolution of 237 bits after a few operations on numbers of size 1.
const TOLERANCE: f64 = 1e-66;

/// A node: its position, its triad, its virtual translation and spin.
#[derive(Clone, Copy)]
struct Node {
    x: V,
    triad: [V; 3],
    dx: V,
    spin: V,
}

/// A force and a moment on a node.
#[derive(Clone, Copy)]
struct Action {
    force: V,
    moment: V,
}

impl Node {
    fn position(&self) -> Vector3<Moving> {
        self.x.zip_map(&self.dx, Dual::new)
    }

    /// δe = spin × e.
    fn axis(&self, k: usize) -> Vector3<Moving> {
        self.triad[k].zip_map(&self.spin.cross(&self.triad[k]), Dual::new)
    }

    fn work(&self, action: Action) -> Octuple {
        action.force.dot(&self.dx) + action.moment.dot(&self.spin)
    }
}

/// Both nodes.
#[derive(Clone, Copy)]
struct Pair {
    a: Node,
    b: Node,
}

impl Pair {
    /// The work of a force and a moment on b and of their opposites on a, which are in equilibrium.
    fn work_on_b(&self, force: V, moment: V) -> Octuple {
        let arm = self.b.x - self.a.x;
        let on_a = Action { force: -force, moment: -moment - arm.cross(&force) };
        self.b.work(Action { force, moment }) + self.a.work(on_a)
    }

    /// The work of a kinetic force and moment, which act on a, and their opposites on b.
    fn kinetic_work(&self, force: V, moment: V) -> Octuple {
        self.work_on_b(-force, -moment)
    }

    fn triads(&self) -> Triads<Moving> {
        let [a, b] = [&self.a, &self.b];
        let ([e1a, e2a, e3a], [e1b, e2b, e3b]) = ([a.axis(0), a.axis(1), a.axis(2)], [b.axis(0), b.axis(1), b.axis(2)]);
        Triads { e1a, e2a, e3a, e1b, e2b, e3b }
    }

    fn positions(&self) -> Positions<Moving> {
        let Triads { e1a, e2a, e3a, .. } = self.triads();
        Positions { e1a, e2a, e3a, xa: self.a.position(), xb: self.b.position() }
    }

    /// δu1.
    fn slot_motion(&self) -> Octuple {
        let (x, zero) = (RelativePosition::eval(&self.positions()).x, Moving::from(0.0));
        RelativeMotion::eval(&SlotLengths { x, x0: zero, l1_ref: zero }).u1.eps
    }

    /// δur1, δur3.
    fn turns(&self) -> [Octuple; 2] {
        let universal::Turns { alpha, gamma } = universal::Angles::eval(&self.triads());
        let zero = Moving::from(0.0);
        let since = TurnsSince { alpha, gamma, alpha0: zero, gamma0: zero, theta1_ref: zero, theta3_ref: zero };
        let motion = universal::RelativeMotion::eval(&since);
        [motion.ur1.eps, motion.ur3.eps]
    }

    /// f1 e1a, and f2 e2a + f3 e3a.
    fn slot_forces(&self, [f1, f2, f3]: [Octuple; 3]) -> (V, V) {
        let [e1a, e2a, e3a] = self.a.triad;
        (KineticForce::eval(&SlotForce { e1a, f1 }).f, ConstraintForce::eval(&CrossFrame { e2a, e3a, f2, f3 }).f)
    }

    /// m1 e1a + m3 e3b, and the moment of m2.
    fn cross_moments(&self, [m1, m2, m3]: [Octuple; 3]) -> (V, V) {
        let ([e1a, e2a, e3a], [.., e3b]) = (self.a.triad, self.b.triad);
        let kinetic = universal::KineticMoment::eval(&Driven { e1a, e3b, m1, m3 }).m;
        (kinetic, universal::ConstraintMoment::eval(&Twisted { e2a, e3a, e3b, m2 }).m)
    }
}

struct Numbers(TestRng);

impl Numbers {
    fn new() -> Self {
        Self(TestRng::from_seed(RngAlgorithm::ChaCha, &[14; 32]))
    }

    fn number(&mut self) -> Octuple {
        Octuple::from(f64::from(self.0.next_u32()) / f64::from(u32::MAX) * 2.0 - 1.0)
    }

    fn vector(&mut self) -> V {
        V::from_fn(|_, _| self.number())
    }

    fn three(&mut self) -> [Octuple; 3] {
        self.vector().into()
    }

    /// Both nodes at arbitrary positions, b rotated relative to a by these angles, in an arbitrary virtual motion.
    fn pair(&mut self, angles: [Octuple; 3]) -> Pair {
        let global = [V::x(), V::y(), V::z()];
        let [p, q, r] = self.three();
        let a = turned(&global, &rotation(p, q, r));
        let [alpha, beta, gamma] = angles;
        let b = turned(&a, &rotation(alpha, beta, gamma));
        let mut node = |triad| Node { x: self.vector(), triad, dx: self.vector(), spin: self.vector() };
        Pair { a: node(a), b: node(b) }
    }

    /// A joint as designed: the arms of the cross are perpendicular, β = 0.
    fn cross(&mut self) -> Pair {
        let angles = [self.number(), Octuple::from(0.0), self.number()];
        self.pair(angles)
    }
}

fn equal(left: Octuple, right: Octuple) {
    let difference = (left - right).to_f64().abs();
    assert!(difference < TOLERANCE, "{} is not {}: {difference:e}", left.to_f64(), right.to_f64());
    assert!(left.to_f64().abs() > 1e-9, "the motion does work");
}

const POINTS: usize = 50;

#[test]
fn slot() {
    let mut numbers = Numbers::new();
    for _ in 0..POINTS {
        let angles = numbers.three();
        let (pair, [f1, f2, f3]) = (numbers.pair(angles), numbers.three());
        let (kinetic, constraint) = pair.slot_forces([f1, f2, f3]);
        let (p, zero) = (pair.positions(), Moving::from(0.0));
        let g = Constraint::eval(&SlotPositions { e2a: p.e2a, e3a: p.e3a, xa: p.xa, xb: p.xb, y0: zero, z0: zero });
        let none = V::zeros();
        equal(pair.work_on_b(constraint, none), f2 * g.gy.eps + f3 * g.gz.eps);
        equal(pair.kinetic_work(kinetic, none), -f1 * pair.slot_motion());
    }
}

#[test]
fn slot_in_the_plane() {
    let mut numbers = Numbers::new();
    for _ in 0..POINTS {
        let zero = Octuple::from(0.0);
        let flat = |v: V| V::new(v.x, v.y, zero);
        let mut pair = numbers.pair([zero; 3]);
        let turn = rotation(zero, zero, numbers.number());
        for node in [&mut pair.a, &mut pair.b] {
            let spin = V::new(zero, zero, node.spin.z);
            let triad = turned(&[V::x(), V::y(), V::z()], &turn);
            *node = Node { x: flat(node.x), dx: flat(node.dx), spin, triad };
        }
        let [f1, f2, _] = numbers.three();
        let (kinetic, constraint) = pair.slot_forces([f1, f2, zero]);
        let plane = |v: Vector3<Moving>| Vector2::new(v.x, v.y);
        let p = pair.positions();
        let (e2a, xa, xb, y0) = (plane(p.e2a), plane(p.xa), plane(p.xb), Moving::from(0.0));
        let gy = Constraint2d::eval(&SlotPositions2d { e2a, xa, xb, y0 }).gy.eps;
        equal(pair.work_on_b(constraint, V::zeros()), f2 * gy);
        equal(pair.kinetic_work(kinetic, V::zeros()), -f1 * pair.slot_motion());
    }
}

/// If the triads are equal, the moments work on the three angles; in general, they do no work if b rotates with a.
#[test]
fn align() {
    let mut numbers = Numbers::new();
    for _ in 0..POINTS {
        let moment = |pair: &Pair, [m1, m2, m3]: [Octuple; 3]| {
            let [e1a, e2a, e3a] = pair.a.triad;
            align::ConstraintMoment::eval(&align::Moments { e1a, e2a, e3a, m1, m2, m3 }).m
        };
        let m = numbers.three();
        let aligned = numbers.pair([Octuple::from(0.0); 3]);
        let angles = accurate(&aligned.triads());
        let work = m[0] * angles.alpha.eps + m[1] * angles.beta.eps + m[2] * angles.gamma.eps;
        equal(aligned.work_on_b(V::zeros(), moment(&aligned, m)), work);

        let angles = numbers.three();
        let mut pair = numbers.pair(angles);
        pair.b.spin = pair.a.spin;
        let kept = accurate(&pair.triads());
        let work = pair.work_on_b(V::zeros(), moment(&pair, m));
        for none in [work, kept.alpha.eps, kept.beta.eps, kept.gamma.eps] {
            assert!(none.to_f64().abs() < TOLERANCE, "{:e}", none.to_f64());
        }
    }
}

#[test]
fn translator() {
    let mut numbers = Numbers::new();
    for _ in 0..POINTS {
        let pair = numbers.pair([Octuple::from(0.0); 3]);
        let ([f1, f2, f3], [m1, m2, m3]) = (numbers.three(), numbers.three());
        let [e1a, e2a, e3a] = pair.a.triad;
        let (kinetic, constraint) = pair.slot_forces([f1, f2, f3]);
        let moment = align::ConstraintMoment::eval(&align::Moments { e1a, e2a, e3a, m1, m2, m3 }).m;
        let (t, zero) = (pair.triads(), Moving::from(0.0));
        let g = translator::Constraint::eval(&translator::Placement {
            e1a: t.e1a,
            e2a: t.e2a,
            e3a: t.e3a,
            e1b: t.e1b,
            e2b: t.e2b,
            e3b: t.e3b,
            xa: pair.a.position(),
            xb: pair.b.position(),
            y0: zero,
            z0: zero,
            alpha0: zero,
            beta0: zero,
            gamma0: zero,
        });
        let held = f2 * g.gy.eps + f3 * g.gz.eps + m1 * g.ur1.eps + m2 * g.ur2.eps + m3 * g.ur3.eps;
        let work = pair.work_on_b(constraint, moment) + pair.kinetic_work(kinetic, V::zeros());
        equal(work, held - f1 * pair.slot_motion());
    }
}

#[test]
fn join() {
    let mut numbers = Numbers::new();
    for _ in 0..POINTS {
        let angles = numbers.three();
        let (pair, [f1, f2, f3]) = (numbers.pair(angles), numbers.three());
        // All three act on b: no direction is free.
        let (along, across) = pair.slot_forces([f1, f2, f3]);
        let p = pair.positions();
        let d0 = Vector3::from_element(Moving::from(0.0));
        let (e1a, e2a, e3a) = (p.e1a, p.e2a, p.e3a);
        let g = join::Constraint::eval(&join::Joined { e1a, e2a, e3a, xa: p.xa, xb: p.xb, d0 }).g;
        equal(pair.work_on_b(along + across, V::zeros()), f1 * g.x.eps + f2 * g.y.eps + f3 * g.z.eps);
    }
}

#[test]
fn universal() {
    let mut numbers = Numbers::new();
    for _ in 0..POINTS {
        let (pair, [m1, m2, m3]) = (numbers.cross(), numbers.three());
        let (kinetic, constraint) = pair.cross_moments([m1, m2, m3]);
        let t = pair.triads();
        let g = universal::Constraint::eval(&Shafts { e1a: t.e1a, e3b: t.e3b, c0: Moving::from(0.0) }).g.eps;
        let [ur1, ur3] = pair.turns();
        equal(pair.work_on_b(V::zeros(), constraint), m2 * g);
        // With the constraint satisfied: the arms of the cross remain perpendicular.
        let mut kept = pair;
        let across = pair.a.triad[0].cross(&pair.b.triad[2]);
        let relative = kept.b.spin - kept.a.spin;
        kept.b.spin -= across * across.dot(&relative);
        let [kept1, kept3] = kept.turns();
        equal(kept.kinetic_work(V::zeros(), kinetic), -(m1 * kept1 + m3 * kept3));
        assert!(kept.work_on_b(V::zeros(), constraint).to_f64().abs() < TOLERANCE);
        equal(pair.kinetic_work(V::zeros(), kinetic), -(m1 * ur1 + m3 * ur3));
    }
}

#[test]
fn ujoint() {
    let mut numbers = Numbers::new();
    for _ in 0..POINTS {
        let pair = numbers.cross();
        let (f, [m1, m2, m3]) = (numbers.three(), numbers.three());
        let (along, across) = pair.slot_forces(f);
        let (kinetic, constraint) = pair.cross_moments([m1, m2, m3]);
        let (t, zero) = (pair.triads(), Moving::from(0.0));
        let g = ujoint::Constraint::eval(&ujoint::Jointed {
            e1a: t.e1a,
            e2a: t.e2a,
            e3a: t.e3a,
            e3b: t.e3b,
            xa: pair.a.position(),
            xb: pair.b.position(),
            d0: Vector3::from_element(zero),
            c0: zero,
        });
        let held = f[0] * g.g.x.eps + f[1] * g.g.y.eps + f[2] * g.g.z.eps + m2 * g.g_rot.eps;
        let [ur1, ur3] = pair.turns();
        let work = pair.work_on_b(along + across, constraint) + pair.kinetic_work(V::zeros(), kinetic);
        equal(work, held - m1 * ur1 - m3 * ur3);
    }
}

impl Pair {
    /// Nodes a and b exchanged, with these vectors as the triads of b and of a.
    fn exchanged(&self, of_b: &[V; 3], of_a: &[V; 3]) -> Self {
        Self { a: Node { triad: *of_b, ..self.b }, b: Node { triad: *of_a, ..self.a } }
    }

    /// The rates of change of the five residuals of a TRANSLATOR.
    fn translator_rates(&self) -> [Octuple; 5] {
        let (t, zero) = (self.triads(), Moving::from(0.0));
        let g = translator::Constraint::eval(&translator::Placement {
            e1a: t.e1a,
            e2a: t.e2a,
            e3a: t.e3a,
            e1b: t.e1b,
            e2b: t.e2b,
            e3b: t.e3b,
            xa: self.a.position(),
            xb: self.b.position(),
            y0: zero,
            z0: zero,
            alpha0: zero,
            beta0: zero,
            gamma0: zero,
        });
        [g.gy.eps, g.gz.eps, g.ur1.eps, g.ur2.eps, g.ur3.eps]
    }

    /// The rates of change of the four residuals of a UJOINT.
    fn joint_rates(&self) -> [Octuple; 4] {
        let (t, zero) = (self.triads(), Moving::from(0.0));
        let (xa, xb, d0) = (self.a.position(), self.b.position(), Vector3::from_element(zero));
        let joint = ujoint::Jointed { e1a: t.e1a, e2a: t.e2a, e3a: t.e3a, e3b: t.e3b, xa, xb, d0, c0: zero };
        let g = ujoint::Constraint::eval(&joint);
        [g.g.x.eps, g.g.y.eps, g.g.z.eps, g.g_rot.eps]
    }
}

fn largest<const N: usize>(rates: [Octuple; N]) -> f64 {
    rates.into_iter().map(|rate| rate.to_f64().abs()).fold(0.0, f64::max)
}

/// A motion that one order of the nodes allows, the other allows too; a motion that one forbids, the other forbids too.
#[test]
fn the_order_of_the_nodes_changes_no_enforcement() {
    let mut numbers = Numbers::new();
    for _ in 0..POINTS {
        // b anywhere along the slot, aligned, carried along by a and moved along e1a: an allowed motion.
        let mut free = numbers.pair([Octuple::from(0.0); 3]);
        let ([e1, ..], slide) = (free.a.triad, numbers.number());
        free.b.spin = free.a.spin;
        free.b.dx = free.a.dx + free.a.spin.cross(&(free.b.x - free.a.x)) + e1 * slide;
        let order = |pair: &Pair| pair.exchanged(&pair.b.triad, &pair.a.triad);
        assert!(largest(free.translator_rates()).max(largest(order(&free).translator_rates())) < TOLERANCE);
        let mut held = free;
        held.b.dx += free.a.triad[1] * Octuple::from(0.25);
        held.b.spin += free.a.triad[2] * Octuple::from(0.5);
        for pair in [held, order(&held)] {
            let [gy, .., ur3] = pair.translator_rates().map(|rate| rate.to_f64().abs());
            assert!(gy > 1e-9 && (ur3 - 0.5).abs() < TOLERANCE, "{gy} {ur3}");
        }

        // b at the position of a, rotated about both arms of the cross: an allowed motion.
        let mut free = numbers.cross();
        let ([e1a, ..], [e1b, e2b, e3b]) = (free.a.triad, free.b.triad);
        (free.b.x, free.b.dx) = (free.a.x, free.a.dx);
        free.b.spin = free.a.spin + e1a * numbers.number() + e3b * numbers.number();
        let order = |pair: &Pair| pair.exchanged(&[e3b, e1b, e2b], &[free.a.triad[1], free.a.triad[2], e1a]);
        assert!(largest(free.joint_rates()).max(largest(order(&free).joint_rates())) < TOLERANCE);
        let mut held = free;
        held.b.dx += e1a * Octuple::from(0.25);
        held.b.spin += e3b.cross(&e1a) * Octuple::from(0.5);
        let [here, there] = [held, order(&held)].map(|pair| pair.joint_rates());
        for rates in [here, there] {
            assert!(largest([rates[0], rates[1], rates[2]]) > 0.1);
        }
        assert!((here[3].to_f64().abs() - 0.5).abs() < TOLERANCE && (here[3] - there[3]).to_f64().abs() < TOLERANCE);
    }
}

/// A friction force is positive if it resists positive motion: it absorbs work, in whichever direction b moves.
#[test]
fn friction_takes_up_work() {
    let mut numbers = Numbers::new();
    for _ in 0..POINTS {
        let angles = numbers.three();
        let pair = numbers.pair(angles);
        let motion = pair.slot_motion();
        // The trial force follows the motion, and so does the remaining force.
        let trial = jointproof::contact::coulomb::Trial {
            f_trial: motion * 1e3,
            mu: Octuple::from(0.3),
            r#fn: Octuple::from(2.0),
        };
        let f1 = jointproof::contact::coulomb::ReturnMap::eval(&trial).f;
        let zero = Octuple::from(0.0);
        let (kinetic, _) = pair.slot_forces([f1, zero, zero]);
        let work = pair.kinetic_work(kinetic, V::zeros());
        equal(work, -(f1 * motion));
        assert!(work.to_f64() < 0.0);
    }
}
