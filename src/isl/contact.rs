//! A set of elements on a slide line, increment by increment.

use super::{ElementSet, Interaction, SlaveNode, State};
use crate::Scalar;
use crate::error::Error;
use crate::quantity::Domain;
use crate::slide_line::{ClosestPoint, Nodes, Place, PlacedLine, SlideLine};
use arrayvec::ArrayVec;
use std::collections::BTreeMap;

/// An increment: how long it lasts, and the pressures of hard contact at its end.
///
/// ```
/// use jointproof::isl::Step;
/// let step = Step::new(0.5)?.with_pressures([(3, 20.0), (4, 25.0)])?;
/// let error = step.with_pressures([(3, -1.0)]).unwrap_err();
/// assert_eq!(error.to_string(), "node 3 has the pressure -1; allowed are finite pressures ≥ 0");
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    duration: f64,
    pressures: BTreeMap<u32, f64>,
}

impl Step {
    /// An increment of this duration > 0 (T), by which closing rates are measured.
    ///
    /// # Errors
    /// A `duration` that is not positive and finite.
    pub fn new(duration: f64) -> Result<Self, Error> {
        Error::check("duration", None, duration, Domain::Positive)?;
        Ok(Self { duration, pressures: BTreeMap::new() })
    }

    /// Gives slave nodes the pressures ≥ 0 (F/L²) of hard contact, by node number; that of a node not named is 0.
    ///
    /// # Errors
    /// [`Error::Node`]: a pressure that is negative or not finite.
    pub fn with_pressures(mut self, pressures: impl IntoIterator<Item = (u32, f64)>) -> Result<Self, Error> {
        for (node, p) in pressures {
            if !(p.is_finite() && p >= 0.0) {
                let fault = format!("has the pressure {p}");
                return Err(Error::Node { node, fault, allowed: "finite pressures ≥ 0" });
            }
            self.pressures.insert(node, p);
        }
        Ok(self)
    }
}

/// What an increment brings to a slave node, and what it had before.
struct Increment<D> {
    e12: D,
    s12: D,
    slip: D,
    closing: D,
    /// The pressure of hard contact.
    multiplier: D,
}

/// A set of ISL21A or ISL22A elements that slide along a slide line.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    line: SlideLine,
    elements: ElementSet,
    interaction: Interaction,
}

impl Contact {
    /// Associates the elements with the line.
    pub fn new(line: SlideLine, elements: ElementSet, interaction: Interaction) -> Self {
        Self { line, elements, interaction }
    }

    /// The name of the slide line: that of its element set.
    pub fn name(&self) -> &str {
        self.elements.name()
    }

    /// The elements.
    pub fn elements(&self) -> &ElementSet {
        &self.elements
    }

    /// The state where the analysis begins: at rest, without slip, shear stress or pressure of hard contact.
    ///
    /// # Errors
    /// What can be wrong with the places of the nodes: [`Error::UnknownNode`], [`Error::CoincidentNodes`], and the errors of
    /// [`PlacedLine::closest`]; [`Error::Overflow`].
    pub fn start<D: Scalar>(&self, places: Nodes<D>) -> Result<State<D>, Error> {
        let zero = D::zero();
        let rest = Increment { e12: zero, s12: zero, slip: zero, closing: zero, multiplier: zero };
        self.state(places, |_, _, _, _| Ok(Increment { ..rest }))
    }

    /// The state at the end of an increment that began in the state `before`; the nodes are now at `places`.
    ///
    /// A solver that tries several places for the end of one increment calls this with the same `before` each time.
    /// Slip and closing rate come from the displacements of the nodes, at the closest point where the increment ends. At a
    /// slave node past an end of the line nothing is transmitted.
    ///
    /// # Errors
    /// As [`Self::start`]; [`Error::Node`] where the step names a pressure for a node that is not a slave.
    pub fn advance<D: Scalar>(&self, before: &State<D>, places: Nodes<D>, step: &Step) -> Result<State<D>, Error> {
        if let Some(&node) = step.pressures.keys().find(|node| !before.slaves.contains_key(node)) {
            let fault = "has a pressure, but no element".into();
            return Err(Error::Node { node, fault, allowed: "pressures of slave nodes" });
        }
        self.state(places, |line, places, node, closest| {
            let moved = |node| places.displacement(&before.places, node);
            let dxs = moved(node)?;
            let dx = closest.weights.iter().map(|&(node, _)| moved(node)).collect::<Result<ArrayVec<_, 5>, _>>()?;
            let approach = -closest.normal.dot(&closest.relative_motion(dxs, &dx));
            let SlaveNode { e12, s12, .. } = *before.node(node)?;
            Ok(Increment {
                e12,
                s12,
                slip: line.slip_increment(closest, dxs, &dx),
                closing: approach / step.duration,
                multiplier: step.pressures.get(&node).copied().unwrap_or_default().into(),
            })
        })
    }

    /// The state at these places, given what the increment brings to each slave node.
    fn state<D: Scalar>(
        &self,
        places: Nodes<D>,
        increment: impl Fn(&PlacedLine<D>, &Nodes<D>, u32, &ClosestPoint<D>) -> Result<Increment<D>, Error>,
    ) -> Result<State<D>, Error> {
        let line = self.line.place(&places)?;
        let slave = |(node, area)| {
            let closest = line.closest(places.position(node)?)?;
            let increment = increment(&line, &places, node, &closest)?;
            Ok((node, self.respond(closest, area, &increment)?))
        };
        let slaves = self.areas(&places)?.into_iter().map(slave).collect::<Result<_, Error>>()?;
        Ok(State { places, slaves })
    }

    /// The contact area of every slave node.
    fn areas<D: Scalar>(&self, places: &Nodes<D>) -> Result<BTreeMap<u32, D>, Error> {
        let mut areas = BTreeMap::new();
        for element in self.elements.elements() {
            for (&node, area) in element.nodes().iter().zip(element.areas(places)?) {
                *areas.entry(node).or_insert_with(D::zero) += area;
            }
        }
        Ok(areas)
    }

    fn respond<D: Scalar>(
        &self,
        closest: ClosestPoint<D>,
        area: D,
        increment: &Increment<D>,
    ) -> Result<SlaveNode<D>, Error> {
        let e11 = closest.separation;
        let e12 = increment.e12 + increment.slip;
        let s11 = match closest.place {
            Place::Beyond { .. } => D::zero(),
            _ => self.interaction.pressure(-e11, increment.closing, increment.multiplier),
        };
        let s12 = self.interaction.shear(increment.s12, increment.slip, s11);
        let overflow = [("e12", e12), ("s11", s11), ("s12", s12)].into_iter().find(|(_, x)| !x.re().is_finite());
        match overflow {
            Some((name, _)) => Err(Error::Overflow { name }),
            None => Ok(SlaveNode { closest, area, e11, e12, s11, s12 }),
        }
    }

    /// The greatest torque about the z axis that the line transmits, as if the friction coefficient were 1: the sum over
    /// the elements, from the pressures at their nodes. Where damping pulls, the pressure counts as 0.
    ///
    /// # Errors
    /// [`Error::UnknownNode`] in a state of another contact; [`Error::Overflow`].
    pub fn torque<D: Scalar>(&self, state: &State<D>) -> Result<D, Error> {
        let pressure = |node| state.node(node).map(|slave| if slave.s11 > 0.0 { slave.s11 } else { D::zero() });
        let torques = self.elements.elements().iter().map(|element| element.torque(&state.places, pressure));
        torques.sum::<Result<D, _>>()
    }
}
