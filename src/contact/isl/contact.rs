//! A set of elements on a slide line, increment by increment.

use super::element::{ElementSet, IslElement};
use super::engine::{self, Motion, Slave, SlaveState, Surface, Tally, Wanted};
use super::interaction::Interaction;
use super::state::{ContactState, SlaveNode};
use crate::Scalar;
use crate::contact::slide_line::{Nodes, SlideLine};
use crate::formula::error::Error;
use crate::formula::quantity::Domain;
use nalgebra::Vector2;
use std::collections::BTreeMap;

/// An increment: its duration, and the pressures of hard contact at its end.
///
/// ```
/// use jointproof::contact::isl::Increment;
/// let increment = Increment::new(0.5)?.with_pressures([(3, 20.0), (4, 25.0)])?;
/// let error = increment.with_pressures([(3, -1.0)]).unwrap_err();
/// assert_eq!(error.to_string(), "node 3 has the pressure -1; allowed are finite pressures ≥ 0");
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Increment {
    duration: f64,
    pressures: BTreeMap<u32, f64>,
}

impl Increment {
    /// An increment of this duration > 0 (T), from which closing rates are computed.
    ///
    /// # Errors
    /// A `duration` that is not positive and finite.
    pub fn new(duration: f64) -> Result<Self, Error> {
        Error::check("duration", None, duration, Domain::Positive)?;
        Ok(Self { duration, pressures: BTreeMap::new() })
    }

    /// Sets the pressures ≥ 0 (F/L²) of hard contact of slave nodes, by node number; that of a node not named is 0.
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

    /// The pressure of hard contact of a node; 0 if it is not named.
    fn pressure(&self, node: u32) -> f64 {
        self.pressures.get(&node).map_or(0.0, |&pressure| pressure)
    }
}

/// The positions of the nodes, now and at the beginning of the increment; at the start of the analysis there are no earlier ones.
struct Step<'m, D> {
    places: &'m Nodes<D>,
    before: Option<(&'m Nodes<D>, &'m Increment)>,
}

impl<D: Scalar> Motion<D> for Step<'_, D> {
    fn position(&self, node: u32) -> Result<Vector2<D>, Error> {
        self.places.position(node)
    }
    fn displacement(&self, node: u32) -> Result<Vector2<D>, Error> {
        match self.before {
            Some((before, _)) => self.places.displacement(before, node),
            None => Ok(Vector2::from_element(D::zero())),
        }
    }
    fn duration(&self) -> Option<f64> {
        self.before.map(|(_, increment)| increment.duration)
    }
}

/// A set of ISL21A or ISL22A elements that slide along a slide line.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    surface: Surface,
    elements: ElementSet,
}

impl Contact {
    /// Associates the elements with the line.
    pub fn new(line: SlideLine, elements: ElementSet, interaction: Interaction) -> Self {
        Self { surface: Surface { line, interaction }, elements }
    }

    /// The name of the slide line: that of its element set.
    pub fn name(&self) -> &str {
        self.elements.name()
    }

    /// The elements.
    pub fn elements(&self) -> &ElementSet {
        &self.elements
    }

    /// The state at the beginning of the analysis: at rest, without slip, shear stress or pressure of hard contact.
    ///
    /// # Errors
    /// Invalid positions of the nodes: [`Error::UnknownNode`], [`Error::CoincidentNodes`], and the errors of
    /// [`PlacedLine::closest`](crate::contact::slide_line::PlacedLine::closest); [`Error::Overflow`].
    pub fn start<D: Scalar>(&self, places: Nodes<D>) -> Result<ContactState<D>, Error> {
        let at_rest = |_| Ok((SlaveState::at_rest(), 0.0));
        let slaves = self.slaves(&Step { places: &places, before: None }, at_rest)?;
        Ok(ContactState { places, slaves })
    }

    /// The state at the end of an increment that begins in the state `before`; the nodes are now at `places`.
    ///
    /// A solver that tries several positions for the end of one increment calls this with the same `before` each time. Slip is
    /// the distance that the closest point travels along the line, measured in the configuration at the end of the increment
    /// ([`PlacedLine::slip`](crate::contact::slide_line::PlacedLine::slip)), so that it does not depend on the size of the
    /// increments; the closing rate follows from the displacements of the nodes, at the closest point there. A slave node past the
    /// extension of an end of the line transmits nothing.
    ///
    /// # Errors
    /// As [`Self::start`]; [`Error::Node`] if the increment names a pressure for a node that is not a slave.
    pub fn advance<D: Scalar>(
        &self,
        before: &ContactState<D>,
        places: Nodes<D>,
        increment: &Increment,
    ) -> Result<ContactState<D>, Error> {
        if let Some(&node) = increment.pressures.keys().find(|node| !before.slaves.contains_key(node)) {
            let fault = "has a pressure, but no element".into();
            return Err(Error::Node { node, fault, allowed: "pressures of slave nodes" });
        }
        let was = |node| Ok((before.node(node)?.engine_state(), increment.pressure(node)));
        let slaves = self.slaves(&Step { places: &places, before: Some((&before.places, increment)) }, was)?;
        Ok(ContactState { places, slaves })
    }

    /// The slave nodes at the end of a step, given their previous states and their pressures of hard contact.
    fn slaves<D: Scalar>(
        &self,
        step: &Step<'_, D>,
        was: impl Fn(u32) -> Result<(SlaveState<D>, f64), Error>,
    ) -> Result<BTreeMap<u32, SlaveNode<D>>, Error> {
        let mut tally = Tally::default();
        let placed = self.surface.place(step).map_err(|failure| failure.error)?;
        let slave = |(node, area)| {
            let (mut state, multiplier) = was(node)?;
            let slave = Slave { node, wanted: Wanted::ALL };
            let closest = placed.advance(&mut state, slave, multiplier, step, &mut tally);
            let closest = closest.map_err(|failure| failure.error)?;
            let SlaveState { e11, e12, s11, s12, .. } = state;
            Ok((node, SlaveNode { closest, area, e11, e12, s11, s12 }))
        };
        self.areas(step.places)?.into_iter().map(slave).collect()
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

    /// The greatest torque about the z axis that the line transmits, as if the friction coefficient were 1: the sum over the
    /// elements, from the pressures at their nodes. If damping makes a pressure negative, it counts as 0.
    ///
    /// # Errors
    /// [`Error::UnknownNode`] in a state of another contact; [`Error::Overflow`].
    pub fn torque<D: Scalar>(&self, state: &ContactState<D>) -> Result<D, Error> {
        let step = Step { places: &state.places, before: None };
        let mut tally = Tally::default();
        let mut add = |sum, element: &IslElement| {
            let push = |k: usize| Ok(state.node(element.nodes()[k])?.engine_state().push());
            let torque = engine::torque(element, &step, push, &mut tally)?;
            engine::total_torque(sum, element, torque)
        };
        let total = self.elements.elements().iter().try_fold(D::zero(), &mut add);
        total.map_err(|failure| failure.error)
    }
}
