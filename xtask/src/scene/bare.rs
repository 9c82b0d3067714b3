//! The generated scene without scene files: the loop one would write by hand for these connectors only.
//!
//! It does the same work: every state's displacements and loads are read from memory, the same formulas are evaluated
//! for the same connectors on all cores, and the same results are stored for every connector. But it knows in advance
//! what the scene must find out: which formulas are needed, that only second nodes move, that nothing rotates, and
//! that nothing is checked. The benchmark compares the results bit for bit.

use super::generate::{self, CAR, Connector as Sort, K_STICK, LENGTH, RADIUS, RAIL, STATES};
use jointproof::connector::align::Orientations;
use jointproof::connector::slot::{
    self, Constraint, ContactForces, CrossForces, NormalForce, Positions, RelativeMotion, RelativePosition,
    SlotLengths, SlotPositions,
};
use jointproof::connector::translator::{self, ContactLoads};
use jointproof::contact::coulomb::{Response, Sliding};
use jointproof::element::cardan::Triads;
use jointproof::formula::Formula;
use jointproof::scene::rules::{Accumulated, Alignment, Displaced, Increment, Slips, Turns};
use nalgebra::Vector3;
use rayon::prelude::*;

/// The vectors of a triad.
type Axes = [Vector3<f64>; 3];

/// The parts specific to one kind of connector.
pub(crate) trait Joint: Copy + Default + Send + Sync {
    /// The kind, as in the generator.
    const SORT: Sort;
    /// The loads in a state.
    type Loads: Copy + Send + Sync;
    /// The connector with the initial triads of its nodes.
    fn new(rail: &Axes, car: &Axes) -> Self;
    /// Selects its loads from all loads.
    fn loads(all: [f64; 5]) -> Self::Loads;
    /// Updates the rotations, and returns the contact force.
    fn contact_force(&mut self, rail: &Axes, car: &Axes, loads: &Self::Loads) -> f64;
    /// The rotations so far.
    fn turns(&self) -> &[f64];
}

/// A SLOT has no additional data.
#[derive(Clone, Copy, Default)]
pub(crate) struct Slot;

impl Joint for Slot {
    const SORT: Sort = Sort::Slot;
    type Loads = [f64; 2];
    fn new(_: &Axes, _: &Axes) -> Self {
        Self
    }
    fn loads([f2, f3, ..]: [f64; 5]) -> [f64; 2] {
        [f2, f3]
    }
    #[inline]
    fn contact_force(&mut self, _: &Axes, _: &Axes, &[f2, f3]: &[f64; 2]) -> f64 {
        slot::ContactForce::eval(&CrossForces { f2, f3 }).fc
    }
    fn turns(&self) -> &[f64] {
        &[]
    }
}

/// A TRANSLATOR stores its initial angles and its rotations.
#[derive(Clone, Copy, Default)]
pub(crate) struct Translator {
    initial: [f64; 3],
    turns: [f64; 3],
}

impl Joint for Translator {
    const SORT: Sort = Sort::Translator;
    type Loads = [f64; 5];
    fn new(&[e1a, e2a, e3a]: &Axes, &[e1b, e2b, e3b]: &Axes) -> Self {
        let angles = Turns::eval(&Triads { e1a, e2a, e3a, e1b, e2b, e3b });
        Self { initial: [angles.alpha, angles.beta, angles.gamma], turns: [0.0; 3] }
    }
    fn loads(all: [f64; 5]) -> [f64; 5] {
        all
    }
    #[inline]
    fn contact_force(
        &mut self,
        &[e1a, e2a, e3a]: &Axes,
        &[e1b, e2b, e3b]: &Axes,
        &[f2, f3, m1, m2, m3]: &[f64; 5],
    ) -> f64 {
        let [alpha0, beta0, gamma0] = self.initial;
        let turns = Alignment::eval(&Orientations { e1a, e2a, e3a, e1b, e2b, e3b, alpha0, beta0, gamma0 });
        self.turns = [turns.ur1, turns.ur2, turns.ur3];
        translator::ContactForce::eval(&ContactLoads { f2, f3, m1, m2, m3, rr: RADIUS, l: LENGTH }).fc
    }
    fn turns(&self) -> &[f64] {
        &self.turns
    }
}

/// The generated scene, in arrays.
pub(crate) struct Bare<J: Joint> {
    connectors: Vec<Connector<J>>,
    /// Initial positions, two for every connector.
    nodes: Vec<Vector3<f64>>,
    /// The orientations of the nodes: of the rails, and of the sliding nodes.
    triads: [Axes; 2],
    /// Displacements of the second nodes, state by state.
    displacements: Vec<Vec<Vector3<f64>>>,
    /// Loads, state by state.
    loads: Vec<Vec<J::Loads>>,
}

/// The data of one connector; its history starts with zeros.
#[derive(Clone, Copy, Default)]
pub(crate) struct Connector<J> {
    nodes: [u32; 2],
    triads: [u32; 2],
    mu: f64,
    k_stick: f64,
    /// Initial coordinates of the second node in the rail's triad.
    initial: [f64; 3],
    gy: f64,
    gz: f64,
    u1: f64,
    csf: f64,
    slip: f64,
    joint: J,
}

impl<J: Joint> Bare<J> {
    pub(crate) fn new(connectors: usize) -> Self {
        let nodes: Vec<_> = (0..connectors).flat_map(generate::nodes).map(Vector3::from).collect();
        let triads @ [rail, car] = [RAIL, CAR].map(|triad| triad.map(Vector3::from));
        let connector = |(index, first): (usize, u32)| {
            let [a, b] = generate::nodes(index).map(Vector3::from);
            let initial = RelativePosition::eval(&positions(&rail, a, b));
            let initial = [initial.x, initial.y, initial.z];
            let (nodes, mu) = ([first, first + 1], generate::mu(index));
            let joint = J::new(&rail, &car);
            Connector { nodes, triads: [0, 1], mu, k_stick: K_STICK, initial, joint, ..Connector::default() }
        };
        let states = 0..STATES;
        let displacement = |state, index| Vector3::from(generate::displacement(state, index));
        let loads = |state, index| J::loads(generate::loads(state, index));
        Self {
            connectors: (0..connectors).zip((0..).step_by(2)).map(connector).collect(),
            nodes,
            triads,
            displacements: states.clone().map(|k| (0..connectors).map(|i| displacement(k, i)).collect()).collect(),
            loads: states.map(|k| (0..connectors).map(|i| loads(k, i)).collect()).collect(),
        }
    }

    /// Clears the history.
    pub(crate) fn restart(&mut self) {
        for connector in &mut self.connectors {
            let Connector { nodes, triads, mu, k_stick, initial, joint, .. } = *connector;
            *connector = Connector { nodes, triads, mu, k_stick, initial, joint, ..Connector::default() };
        }
    }

    /// Evaluates every state.
    pub(crate) fn run(&mut self) {
        // The number of connectors worth a thread.
        const TASK: usize = 1024;
        let (nodes, triads) = (&self.nodes, &self.triads);
        for (displacements, loads) in self.displacements.iter().zip(&self.loads) {
            if self.connectors.len() <= TASK {
                for ((connector, u), loads) in self.connectors.iter_mut().zip(displacements).zip(loads) {
                    connector.advance(nodes, triads, u, loads);
                }
            } else {
                let all = self.connectors.par_iter_mut().zip(displacements).zip(loads).with_min_len(TASK);
                all.for_each(|((connector, u), loads)| connector.advance(nodes, triads, u, loads));
            }
        }
    }

    /// The results, in the order of a scene's results.
    pub(crate) fn results(&self) -> impl Iterator<Item = f64> {
        let before = |c: &Connector<J>| [c.u1, c.gy, c.gz];
        let after = |c: &Connector<J>| [c.csf, c.slip];
        self.connectors.iter().flat_map(move |c| before(c).into_iter().chain(c.joint.turns().to_vec()).chain(after(c)))
    }
}

fn positions(&[e1a, e2a, e3a]: &Axes, xa: Vector3<f64>, xb: Vector3<f64>) -> Positions<f64> {
    Positions { e1a, e2a, e3a, xa, xb }
}

impl<J: Joint> Connector<J> {
    /// Advances to the next state.
    #[inline]
    fn advance(&mut self, nodes: &[Vector3<f64>], triads: &[Axes; 2], displacement: &Vector3<f64>, loads: &J::Loads) {
        let ([a, b], [x0, y0, z0], k_stick) = (self.nodes, self.initial, self.k_stick);
        let [rail, car] = self.triads.map(|triad| &triads[triad as usize]);
        let positions = positions(rail, nodes[a as usize], nodes[b as usize] + displacement);
        let Positions { e2a, e3a, xa, xb, .. } = positions;
        let residuals = Constraint::eval(&SlotPositions { e2a, e3a, xa, xb, y0, z0 });
        let x = RelativePosition::eval(&positions).x;
        let u1 = RelativeMotion::eval(&SlotLengths { x, x0, l1_ref: x0 }).u1;
        let fc = self.joint.contact_force(rail, car, loads);
        let normal = NormalForce::eval(&ContactForces { fc, fc_int: 0.0 }).r#fn;
        let du = Increment::eval(&Displaced { u1, u1_before: self.u1 }).du;
        let found = Response::eval(&Sliding { du, f_before: self.csf, k_stick, mu: self.mu, r#fn: normal });
        let slip = Accumulated::eval(&Slips { slip: found.slip, slip_before: self.slip }).slip_total;
        *self = Self { gy: residuals.gy, gz: residuals.gz, u1, csf: found.f, slip, ..*self };
    }
}
