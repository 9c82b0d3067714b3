//! A slide line that is evaluated state by state, in place.

use super::nodes::NodeStates;
use crate::contact::isl::{Failure, Motion, Slave, SlaveState, Tally, areas, torque, total_torque};
use crate::contact::slide_line::Place;
use crate::element::table::Number;
use crate::formula::error::Error;
use crate::scene::model::Changes;
use crate::scene::plan::{ContactPlan, Output, WantedElement};
use arrayvec::ArrayVec;
use nalgebra::Vector2;
use rayon::prelude::*;

/// A slide line, with the current state of its slave nodes and elements.
#[derive(Debug)]
pub(super) struct ContactRun<'s, T> {
    plan: &'s ContactPlan<'s>,
    slaves: Vec<SlaveRun<T>>,
    /// The areas of every element for which they are requested.
    areas: Vec<ArrayVec<T, 3>>,
    /// The torque of every element, and that of the line.
    torques: Vec<T>,
    total: T,
    /// The number of states so far, and whether the torque is a result of the current one.
    states: u32,
    shows_torque: bool,
    /// Whether a node on the wrong side has been told.
    told: bool,
    tally: Tally,
}

/// A slave node that is farther on the wrong side than the nearest segment is long.
pub(super) struct Astray {
    pub(super) node: u32,
    pub(super) overclosure: f64,
    pub(super) segment: f64,
}

/// A slave node.
#[derive(Clone, Debug)]
struct SlaveRun<T> {
    state: SlaveState<T>,
    /// The tangent of the line at the closest point.
    tangent: Vector2<T>,
    /// The pressure of hard contact, given by the frames.
    multiplier: f64,
}

/// The positions and displacements of nodes, and the duration of the increment.
pub(super) struct Increment<'m, T> {
    pub(super) nodes: &'m NodeStates<'m, T>,
    /// `None` in the first state, before which there is no increment.
    pub(super) duration: Option<f64>,
    /// The changes of the pressures of hard contact.
    pub(super) pressures: &'m Changes<f64>,
    /// Whether the state is the last.
    pub(super) is_last: bool,
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

/// The outcome of a part of the slave nodes.
#[derive(Default)]
struct Outcome {
    tally: Tally,
    failures: Vec<Failure>,
    /// The first one.
    astray: Option<Astray>,
}

impl Outcome {
    /// Combines it with the outcome of the nodes that follow.
    fn and(mut self, next: Self) -> Self {
        self.tally.add_all(&next.tally);
        self.failures.extend(next.failures);
        self.astray = self.astray.or(next.astray);
        self
    }
}

impl<'s, T: Number> ContactRun<'s, T> {
    pub(super) fn new(plan: &'s ContactPlan<'s>) -> Self {
        let at_rest = SlaveRun { state: SlaveState::at_rest(), tangent: Vector2::zeros(), multiplier: 0.0 };
        Self {
            plan,
            slaves: vec![at_rest; plan.slaves.len()],
            areas: vec![ArrayVec::new(); plan.elements.len()],
            torques: vec![T::zero(); plan.elements.len()],
            total: T::zero(),
            states: 0,
            shows_torque: false,
            told: false,
            tally: Tally::default(),
        }
    }

    /// Advances to the next state, or returns all failures in it. The first slave node on the wrong side is told once.
    pub(super) fn advance(&mut self, increment: &Increment<'_, T>) -> Result<Option<Astray>, Vec<Failure>> {
        let placed = self.plan.surface.place(increment).map_err(|failure| vec![failure])?;
        let advance = |mut all: Outcome, (run, &slave): (&mut SlaveRun<T>, &Slave)| {
            if let Some(pressure) = increment.pressures.get(slave.node) {
                run.multiplier = pressure;
            }
            let advanced = placed.advance(&mut run.state, slave, run.multiplier, increment, &mut all.tally);
            match advanced {
                Ok(closest) => {
                    run.tangent = closest.tangent;
                    let (overclosure, segment) = (-run.state.e11.rounded(), placed.segment_length(&closest).rounded());
                    if overclosure > segment && !matches!(closest.place, Place::Beyond { .. }) {
                        all.astray = all.astray.or(Some(Astray { node: slave.node, overclosure, segment }));
                    }
                }
                Err(failure) => all.failures.push(failure),
            }
            all
        };
        let slaves = self.slaves.par_iter_mut().zip(&self.plan.slaves);
        let Outcome { tally, failures, astray } =
            slaves.fold(Outcome::default, advance).reduce(Outcome::default, Outcome::and);
        self.tally.add_all(&tally);
        if !failures.is_empty() {
            return Err(failures);
        }
        self.states += 1;
        let frequency = self.plan.torque_frequency;
        self.shows_torque = frequency > 0 && (increment.is_last || self.states.is_multiple_of(frequency));
        self.measure(increment).and_then(|()| self.turn(increment)).map_err(|failure| vec![failure])?;
        let astray = astray.filter(|_| !self.told);
        self.told |= astray.is_some();
        Ok(astray)
    }

    /// Computes the requested areas.
    fn measure(&mut self, increment: &Increment<'_, T>) -> Result<(), Failure> {
        let elements = self.areas.iter_mut().zip(&self.plan.elements);
        for (of_element, WantedElement { element, .. }) in elements.filter(|(_, element)| element.wants(Output::Area)) {
            *of_element = areas(element, increment, &mut self.tally)?;
        }
        Ok(())
    }

    /// Computes the requested torques, from the positive pressures.
    fn turn(&mut self, increment: &Increment<'_, T>) -> Result<(), Failure> {
        self.total = T::zero();
        let elements = self.torques.iter_mut().zip(&self.plan.elements);
        for (of_element, WantedElement { element, slaves, .. }) in
            elements.filter(|(_, element)| element.wants(Output::Torque))
        {
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

    /// The number of evaluations of each formula so far.
    pub(super) fn tally(&self) -> &Tally {
        &self.tally
    }

    /// Results of the current state: those of the elements, by their numbers, in the order of the file, then the torque of the
    /// line, which has no number.
    pub(super) fn for_each_result(&self, limit: usize, visit: &mut impl FnMut(Option<u32>, &'static str, &[T])) {
        for (k, element) in self.plan.elements.iter().enumerate().take(limit) {
            for &output in &element.outputs {
                visit(Some(element.element.number()), output.name(), &self.components(k, element, output));
            }
        }
        if self.plan.torque() {
            let total = self.shows_torque.then_some(self.total);
            visit(None, Output::Torque.name(), total.as_slice());
        }
    }

    /// The outputs of the elements by their numbers, each with its number of components, in the order of the results.
    pub(super) fn outputs(&self) -> impl Iterator<Item = (Option<u32>, &'static str, usize)> {
        let of_element = |element: &'s WantedElement| {
            let slaves = element.slaves.len();
            element.outputs.iter().map(move |output| {
                (
                    Some(element.element.number()),
                    output.name(),
                    output.components() * if output.is_of_nodes() { slaves } else { 1 },
                )
            })
        };
        let torque = self.plan.torque().then_some((None, Output::Torque.name(), 1));
        self.plan.elements.iter().flat_map(of_element).chain(torque)
    }

    /// The components of an output of an element, which has this index in the plan.
    fn components(&self, place: usize, element: &WantedElement, output: Output) -> ArrayVec<T, 6> {
        let slaves = element.slaves.iter().map(|&slave| &self.slaves[slave]);
        match output {
            Output::E11 => slaves.map(|slave| slave.state.e11).collect(),
            Output::E12 => slaves.map(|slave| slave.state.e12).collect(),
            Output::S11 => slaves.map(|slave| slave.state.s11).collect(),
            Output::S12 => slaves.map(|slave| slave.state.s12).collect(),
            Output::Torque => self.shows_torque.then_some(self.torques[place]).into_iter().collect(),
            Output::Area => self.areas[place].iter().copied().collect(),
            Output::Tangent => slaves.flat_map(|slave| [slave.tangent.x, slave.tangent.y]).collect(),
            Output::Normal => slaves.flat_map(|slave| [-slave.tangent.y, slave.tangent.x]).collect(),
            Output::SecondTangent => slaves.map(|_| -T::one()).collect(),
        }
    }

    /// The number of bytes that persist from state to state.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.slaves) + size_of_val(&*self.areas) + size_of_val(&*self.torques)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Plan, Scene};

    #[test]
    fn bytes_are_those_of_nodes_and_elements() {
        let scene = Scene::parse(include_str!("../../../golden/scenes/thread.json")).unwrap();
        let plan = Plan::new(&scene);
        let of_element = size_of::<ArrayVec<f64, 3>>() + size_of::<f64>();
        let run = ContactRun::<f64>::new(&plan.contacts[0]);
        assert_eq!(run.bytes(), 5 * size_of::<SlaveRun<f64>>() + 4 * of_element);
    }
}
