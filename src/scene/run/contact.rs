//! A slide line that is evaluated state by state, in place.

use super::nodes::NodeStates;
use crate::error::Error;
use crate::isl::{Failure, Motion, Slave, SlaveState, Tally, torque, total_torque};
use crate::scene::evaluate::Number;
use crate::scene::model::Changes;
use crate::scene::plan::{ContactPlan, Output, WantedElement};
use arrayvec::ArrayVec;
use nalgebra::Vector2;
use rayon::prelude::*;

/// A slide line, and what its slave nodes and elements have in the current state.
#[derive(Debug)]
pub(super) struct ContactRun<'s, T> {
    plan: &'s ContactPlan<'s>,
    slaves: Vec<SlaveRun<T>>,
    /// The torque of every element, and that of the line.
    torques: Vec<T>,
    total: T,
    tally: Tally,
}

/// A slave node.
#[derive(Clone, Debug)]
struct SlaveRun<T> {
    state: SlaveState<T>,
    /// The pressure of hard contact, given by the frames.
    multiplier: f64,
}

/// Where nodes are and were, and how long it took them.
pub(super) struct Increment<'m, T> {
    pub(super) nodes: &'m NodeStates<'m, T>,
    /// Unknown in the first state, which nothing leads to.
    pub(super) duration: Option<f64>,
    /// What changes of the pressures of hard contact.
    pub(super) pressures: &'m Changes<f64>,
}

impl<T: Number> Motion<T> for Increment<'_, T> {
    fn position(&self, node: u32) -> Result<Vector2<T>, Error> {
        Ok(self.nodes.positions()(self.nodes.place(node)).xy())
    }
    fn displacement(&self, node: u32) -> Result<Vector2<T>, Error> {
        Ok(self.nodes.increments()(self.nodes.place(node)).xy())
    }
    fn duration(&self) -> Option<f64> {
        self.duration
    }
}

/// What a share of the slave nodes did.
#[derive(Default)]
struct Outcome {
    tally: Tally,
    failures: Vec<Failure>,
}

impl Outcome {
    /// Together with that of the nodes that follow.
    fn and(mut self, next: Self) -> Self {
        self.tally.add_all(&next.tally);
        self.failures.extend(next.failures);
        self
    }
}

impl<'s, T: Number> ContactRun<'s, T> {
    pub(super) fn new(plan: &'s ContactPlan<'s>) -> Self {
        let at_rest = SlaveRun { state: SlaveState::at_rest(), multiplier: 0.0 };
        Self {
            plan,
            slaves: vec![at_rest; plan.slaves.len()],
            torques: vec![T::zero(); plan.elements.len()],
            total: T::zero(),
            tally: Tally::default(),
        }
    }

    /// The next state, or everything that goes wrong in it.
    pub(super) fn advance(&mut self, increment: &Increment<'_, T>) -> Result<(), Vec<Failure>> {
        let placed = self.plan.surface.place(increment).map_err(|failure| vec![failure])?;
        let advance = |mut all: Outcome, (run, &slave): (&mut SlaveRun<T>, &Slave)| {
            if let Some(pressure) = increment.pressures.get(slave.node) {
                run.multiplier = pressure;
            }
            let advanced = placed.advance(&mut run.state, slave, run.multiplier, increment, &mut all.tally);
            all.failures.extend(advanced.err());
            all
        };
        let slaves = self.slaves.par_iter_mut().zip(&self.plan.slaves);
        let Outcome { tally, failures } = slaves.fold(Outcome::default, advance).reduce(Outcome::default, Outcome::and);
        self.tally.add_all(&tally);
        if !failures.is_empty() {
            return Err(failures);
        }
        self.turn(increment).map_err(|failure| vec![failure])
    }

    /// The torques that are wanted, from the pressures that push.
    fn turn(&mut self, increment: &Increment<'_, T>) -> Result<(), Failure> {
        self.total = T::zero();
        let elements = self.torques.iter_mut().zip(&self.plan.elements);
        for (of_element, WantedElement { element, slaves, .. }) in elements.filter(|(_, element)| element.turns()) {
            let push = |k: usize| Ok(self.slaves[slaves[k]].state.push());
            *of_element = torque(element, increment, push, &mut self.tally)?;
            self.total = total_torque(self.total, element, *of_element)?;
        }
        Ok(())
    }

    /// The name of the line.
    pub(super) fn name(&self) -> &'s str {
        self.plan.name
    }

    /// How often each formula was evaluated so far.
    pub(super) fn tally(&self) -> &Tally {
        &self.tally
    }

    /// Results of the current state: those of the elements in the order of the file, then the torque of the line.
    pub(super) fn for_each_result(&self, limit: usize, visit: &mut impl FnMut(&'s str, &'static str, &[T])) {
        for (element, torque) in self.plan.elements.iter().zip(&self.torques).take(limit) {
            for output in &element.outputs {
                let nodes = element.slaves.iter().map(|&slave| &self.slaves[slave].state);
                let components: ArrayVec<T, 3> = match output {
                    Output::E11 => nodes.map(|state| state.e11).collect(),
                    Output::E12 => nodes.map(|state| state.e12).collect(),
                    Output::S11 => nodes.map(|state| state.s11).collect(),
                    Output::S12 => nodes.map(|state| state.s12).collect(),
                    Output::Torque => std::iter::once(*torque).collect(),
                };
                visit(element.name, output.name(), &components);
            }
        }
        if self.plan.torque() {
            visit(self.plan.name, Output::Torque.name(), &[self.total]);
        }
    }

    /// Bytes that last from state to state.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.slaves) + size_of_val(&*self.torques)
    }
}
