//! Evaluating a slide line, state by state.

use super::Line;
use super::plan::{ContactPlan, Output, Slave, Wanted};
use crate::error::Error;
use crate::formula::Formula;
use crate::scene::model::{Changes, Scene};
use crate::scene::run::nodes::Nodes as SceneNodes;
use crate::scene::step::Number;
use crate::slide_line::{LinearPressures, Nodes, ParabolicPressures, Place, PlacedLine, TorqueLinear, TorqueParabolic};
use arrayvec::ArrayVec;
use nalgebra::Vector2;
use rayon::prelude::*;

/// A slide line that is being evaluated.
#[derive(Debug)]
pub(in crate::scene) struct Contact<'s, T> {
    name: &'s str,
    line: &'s Line,
    plan: &'s ContactPlan,
    /// The nodes of the line, in order.
    masters: Vec<u32>,
    slaves: Vec<State<T>>,
    /// The torque of every element, and that of the line.
    torques: Vec<T>,
    total: T,
    /// Segments and corners that were looked at so far.
    pieces: usize,
}

/// A node on its line.
#[derive(Clone, Copy, Debug)]
struct State<T> {
    e11: T,
    e12: T,
    s11: T,
    s12: T,
    /// The pressure of hard contact, given by the frames.
    multiplier: f64,
}

/// Where nodes are and were, and how long it took them.
#[derive(Debug)]
pub(in crate::scene) struct Motion<'m, T> {
    pub(in crate::scene) nodes: &'m SceneNodes<'m, T>,
    /// Unknown in the first state, which nothing leads to.
    pub(in crate::scene) duration: Option<f64>,
    /// What changes of the pressures of hard contact.
    pub(in crate::scene) pressures: &'m Changes<f64>,
}

impl<T: Number> Motion<'_, T> {
    fn at(&self, node: u32) -> Vector2<T> {
        self.nodes.positions()(self.nodes.place(node)).xy()
    }

    fn of(&self, node: u32) -> Vector2<T> {
        self.nodes.increments()(self.nodes.place(node)).xy()
    }
}

impl<'s, T: Number> Contact<'s, T> {
    pub(in crate::scene) fn new(scene: &'s Scene, plan: &'s ContactPlan) -> Option<Self> {
        let (name, line) = scene.lines.get_index(plan.line)?;
        let zero = T::zero();
        let slave = State { e11: zero, e12: zero, s11: zero, s12: zero, multiplier: 0.0 };
        let slaves = vec![slave; plan.slaves.len()];
        let torques = vec![zero; plan.elements.len()];
        let mut masters: Vec<_> = line.path.nodes().collect();
        masters.sort_unstable();
        masters.dedup();
        Some(Self { name, line, plan, masters, slaves, torques, total: zero, pieces: 0 })
    }

    /// The next state. What goes wrong is told with the formula that says so.
    pub(in crate::scene) fn advance(&mut self, motion: &Motion<'_, T>) -> Result<(), Vec<(&'static str, Error)>> {
        let search = ContactPlan::search(self.line);
        let line = self.place(motion).map_err(|error| vec![(search, error)])?;
        let advance = |(state, &slave): (&mut State<T>, &Slave)| state.advance(self.line, &line, slave, motion);
        let found: Vec<_> = self.slaves.par_iter_mut().zip(&self.plan.slaves).map(advance).collect();
        let failures: Vec<_> =
            found.iter().filter_map(|found| found.clone().err()).map(|error| (search, error)).collect();
        if !failures.is_empty() {
            return Err(failures);
        }
        self.pieces += found.into_iter().flatten().sum::<usize>();
        if self.plan.torque() {
            self.turn(motion).map_err(|error| vec![("slide_line.torque_linear", error)])?;
        }
        Ok(())
    }

    fn place(&self, motion: &Motion<'_, T>) -> Result<PlacedLine<T>, Error> {
        let at = |&number: &u32| (number, <[T; 2]>::from(motion.at(number - 1)));
        self.line.path.place(&Nodes::new(self.masters.iter().map(at))?)
    }

    /// The torques, from the pressures that push.
    fn turn(&mut self, motion: &Motion<'_, T>) -> Result<(), Error> {
        let zero = T::zero();
        self.total = zero;
        for (torque, element) in self.torques.iter_mut().zip(&self.plan.elements) {
            if !element.outputs.contains(&Output::Torque) {
                continue;
            }
            let x = |k: usize| motion.at(self.plan.slaves[element.nodes[k]].node);
            let p = |k: usize| Some(self.slaves[element.nodes[k]].s11).filter(|&p| p > zero).unwrap_or(zero);
            *torque = if element.nodes.len() == 2 {
                TorqueLinear::eval(&LinearPressures { x1: x(0), x2: x(1), p1: p(0), p2: p(1) }).t
            } else {
                let (x1, x2, x3, p1, p2, p3) = (x(0), x(1), x(2), p(0), p(1), p(2));
                TorqueParabolic::eval(&ParabolicPressures { x1, x2, x3, p1, p2, p3 }).t
            };
            self.total += *torque;
        }
        if self.total.rounded().is_finite() { Ok(()) } else { Err(Error::Overflow { name: "torque" }) }
    }

    /// The name of the line.
    pub(in crate::scene) fn name(&self) -> &'s str {
        self.name
    }

    /// How many segments and corners were looked at, and by which formula.
    pub(in crate::scene) fn looked_at(&self) -> (&'static str, usize) {
        (ContactPlan::search(self.line), self.pieces)
    }

    /// Results of the current state: those of the elements in the order of the file, then the torque of the line.
    pub(in crate::scene) fn for_each_result(
        &self,
        scene: &'s Scene,
        limit: usize,
        visit: &mut impl FnMut(&'s str, &'static str, &[T]),
    ) {
        for (Wanted { element, nodes, outputs }, torque) in self.plan.elements.iter().zip(&self.torques).take(limit) {
            let Some((name, _)) = scene.elements.get_index(*element as usize) else { continue };
            for output in outputs {
                let of_node = |place: &usize| self.slaves[*place].output(*output);
                let components: ArrayVec<T, 3> = match output {
                    Output::Torque => std::iter::once(*torque).collect(),
                    _ => nodes.iter().map(of_node).collect(),
                };
                visit(name, output.name(), &components);
            }
        }
        if self.plan.torque() {
            visit(self.name, Output::Torque.name(), &[self.total]);
        }
    }

    /// Bytes that last from state to state.
    pub(in crate::scene) fn bytes(&self) -> usize {
        size_of_val(&*self.slaves) + size_of_val(&*self.torques)
    }
}

impl<T: Number> State<T> {
    /// Answers how many pieces of the line were looked at.
    fn advance(
        &mut self,
        Line { interaction, .. }: &Line,
        line: &PlacedLine<T>,
        slave: Slave,
        motion: &Motion<'_, T>,
    ) -> Result<usize, Error> {
        let (needs, zero) = (slave.needs, T::zero());
        self.multiplier = motion.pressures.get(slave.node).unwrap_or(self.multiplier);
        let closest = line.closest(motion.at(slave.node))?;
        self.e11 = closest.separation;
        let (mut slip, mut closing) = (zero, zero);
        if needs.slip || needs.closing {
            let dxs = motion.of(slave.node);
            let dx: ArrayVec<_, 5> = closest.weights.iter().map(|&(number, _)| motion.of(number - 1)).collect();
            if needs.slip {
                slip = line.slip_increment(&closest, dxs, &dx);
                self.e12 += slip;
            }
            if let Some(duration) = motion.duration.filter(|_| needs.closing) {
                closing = -closest.normal.dot(&closest.relative_motion(dxs, &dx)) / duration;
            }
        }
        if needs.pressure {
            let on_line = !matches!(closest.place, Place::Beyond { .. });
            let pressure = || interaction.pressure(-self.e11, closing, T::exactly(self.multiplier));
            self.s11 = if on_line { pressure() } else { zero };
        }
        if needs.shear {
            self.s12 = interaction.shear(self.s12, slip, self.s11);
        }
        let outputs = [("e12", self.e12), ("s11", self.s11), ("s12", self.s12)];
        match outputs.into_iter().find(|(_, value)| !value.rounded().is_finite()) {
            Some((name, _)) => Err(Error::Overflow { name }),
            None => Ok(closest.evaluated),
        }
    }

    fn output(&self, output: Output) -> T {
        match output {
            Output::E11 => self.e11,
            Output::E12 => self.e12,
            Output::S11 => self.s11,
            Output::S12 => self.s12,
            // The torque belongs to the element.
            Output::Torque => T::zero(),
        }
    }
}
