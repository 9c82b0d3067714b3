//! The generated scene without scenes: the loop that one would write by hand for these connectors and nothing else.
//!
//! It does what the scene does: every state's displacements and forces are read from memory, the same formulas are
//! evaluated for the same connectors on all cores, and the same five results are left for every connector. What it knows
//! beforehand the scene must find out: which formulas there are, that only second nodes move, that nothing turns, and
//! that nothing is checked. The benchmark compares the results bit for bit.

use super::generate::{self, K_STICK, RAIL, STATES};
use jointproof::coulomb::{ReturnMap, Trial};
use jointproof::formula::Formula;
use jointproof::scene::rules::{Slip, SlipLoads, Stick, StickLoads};
use jointproof::slot::{
    Constraint, ContactForce, ContactForces, CrossForces, NormalForce, Positions, RelativeMotion, RelativePosition,
    SlotLengths, SlotPositions,
};
use nalgebra::Vector3;
use rayon::prelude::*;

/// The generated scene, in arrays.
pub(crate) struct Bare {
    connectors: Vec<Connector>,
    /// Initial positions, two for every connector.
    nodes: Vec<Vector3<f64>>,
    /// What rails stand like; there is but one.
    triads: Vec<[Vector3<f64>; 3]>,
    /// Displacements of the second nodes, state by state.
    displacements: Vec<Vec<Vector3<f64>>>,
    /// Forces f2 and f3, state by state.
    loads: Vec<Vec<[f64; 2]>>,
}

/// What one connector keeps; its history begins with zeros.
#[derive(Clone, Copy, Default)]
pub(crate) struct Connector {
    nodes: [u32; 2],
    triad: usize,
    mu: f64,
    k_stick: f64,
    /// Initial coordinates of the second node in the rail's triad.
    initial: [f64; 3],
    pub(crate) gy: f64,
    pub(crate) gz: f64,
    pub(crate) u1: f64,
    pub(crate) csf: f64,
    pub(crate) slip: f64,
}

impl Bare {
    pub(crate) fn new(connectors: usize) -> Self {
        let nodes: Vec<_> = (0..connectors).flat_map(generate::nodes).map(Vector3::from).collect();
        let rail = RAIL.map(Vector3::from);
        let connector = |(index, first): (usize, u32)| {
            let [a, b] = generate::nodes(index).map(Vector3::from);
            let initial = RelativePosition::eval(&positions(&rail, a, b));
            let initial = [initial.x, initial.y, initial.z];
            let (nodes, mu) = ([first, first + 1], generate::mu(index));
            Connector { nodes, mu, k_stick: K_STICK, initial, ..Connector::default() }
        };
        let states = 0..STATES;
        let displacement = |state, index| Vector3::from(generate::displacement(state, index));
        Self {
            connectors: (0..connectors).zip((0..).step_by(2)).map(connector).collect(),
            nodes,
            triads: vec![rail],
            displacements: states.clone().map(|k| (0..connectors).map(|i| displacement(k, i)).collect()).collect(),
            loads: states.map(|k| (0..connectors).map(|i| generate::loads(k, i)).collect()).collect(),
        }
    }

    /// Forgets the history.
    pub(crate) fn restart(&mut self) {
        for connector in &mut self.connectors {
            let Connector { nodes, triad, mu, k_stick, initial, .. } = *connector;
            *connector = Connector { nodes, triad, mu, k_stick, initial, ..Connector::default() };
        }
    }

    /// Every state.
    pub(crate) fn run(&mut self) -> &[Connector] {
        // So many are worth a thread.
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
        &self.connectors
    }
}

fn positions(&[e1a, e2a, e3a]: &[Vector3<f64>; 3], xa: Vector3<f64>, xb: Vector3<f64>) -> Positions<f64> {
    Positions { e1a, e2a, e3a, xa, xb }
}

impl Connector {
    /// The next state.
    #[inline]
    fn advance(
        &mut self,
        nodes: &[Vector3<f64>],
        triads: &[[Vector3<f64>; 3]],
        displacement: &Vector3<f64>,
        &[f2, f3]: &[f64; 2],
    ) {
        let ([a, b], [x0, y0, z0], k_stick) = (self.nodes, self.initial, self.k_stick);
        let positions = positions(&triads[self.triad], nodes[a as usize], nodes[b as usize] + displacement);
        let Positions { e2a, e3a, xa, xb, .. } = positions;
        let residuals = Constraint::eval(&SlotPositions { e2a, e3a, xa, xb, y0, z0 });
        let x = RelativePosition::eval(&positions).x;
        let u1 = RelativeMotion::eval(&SlotLengths { x, x0, l1_ref: x0 }).u1;
        let fc = ContactForce::eval(&CrossForces { f2, f3 }).fc;
        let normal = NormalForce::eval(&ContactForces { fc, fc_int: 0.0 }).r#fn;
        let f_trial = Stick::eval(&StickLoads { u1, u1_before: self.u1, f_before: self.csf, k_stick }).f_trial;
        let csf = ReturnMap::eval(&Trial { f_trial, mu: self.mu, r#fn: normal }).f;
        let slip = Slip::eval(&SlipLoads { f_trial, csf, k_stick, slip_before: self.slip }).slip_total;
        *self = Self { gy: residuals.gy, gz: residuals.gz, u1, csf, slip, ..*self };
    }
}
