//! The engine of contact along a slide line: E11, E12, S11 and S12 of a slave node over an increment, and the torque of an
//! element. It evaluates only what is requested, counts its evaluations, and reports for every error where it occurred and in
//! which formula.
//!
//! [`Contact`](super::Contact) requests everything and keeps every state; a scene requests what its outputs need and updates the
//! last state in place.

use super::element::IslElement;
use super::interaction::Interaction;
use crate::Scalar;
use crate::contact::slide_line::{ClosestPoint, Foot, Place, PlacedLine, SlideLine, check_position};
use crate::formula::error::Error;
use arrayvec::ArrayVec;
use nalgebra::Vector2;

/// The positions of nodes, by number, and their displacements in an increment.
pub(crate) trait Motion<D> {
    /// The position of a node at the end of the increment.
    fn position(&self, node: u32) -> Result<Vector2<D>, Error>;
    /// The displacement of a node in the increment.
    fn displacement(&self, node: u32) -> Result<Vector2<D>, Error>;
    /// The duration of the increment; `None` for a state without an increment, in which all closing rates are 0.
    fn duration(&self) -> Option<f64>;
}

/// A slide line, and the interaction between it and the slave.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Surface {
    pub(crate) line: SlideLine,
    pub(crate) interaction: Interaction,
}

/// A slave node, and the quantities requested in addition to E11, which is always computed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slave {
    pub(crate) node: u32,
    pub(crate) wanted: Wanted,
}

/// The quantities requested of a slave node in addition to E11.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Wanted {
    pub(crate) e12: bool,
    pub(crate) s11: bool,
    pub(crate) s12: bool,
}

impl Wanted {
    /// Everything.
    pub(crate) const ALL: Self = Self { e12: true, s11: true, s12: true };

    /// The union of both requests.
    pub(crate) fn and(self, more: Self) -> Self {
        Self { e12: self.e12 | more.e12, s11: self.s11 | more.s11, s12: self.s12 | more.s12 }
    }
}

/// The stages of evaluation at a slave node, in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) enum Stage {
    /// The closest point of the line.
    Search,
    Slip,
    /// The pressure–overclosure law.
    Law,
    Damping,
    Friction,
}

/// The state of a slave node. Quantities that are not requested remain 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SlaveState<D> {
    pub(crate) e11: D,
    pub(crate) e12: D,
    pub(crate) s11: D,
    pub(crate) s12: D,
    /// The position on the line from which slip continues; none before the analysis.
    pub(crate) foot: Option<Foot<D>>,
}

impl<D: Scalar> SlaveState<D> {
    /// The state before the analysis.
    pub(crate) fn at_rest() -> Self {
        Self { e11: D::zero(), e12: D::zero(), s11: D::zero(), s12: D::zero(), foot: None }
    }

    /// The pressure if it is positive, else 0: a pull transmits no friction.
    pub(crate) fn push(&self) -> D {
        if self.s11 > 0.0 { self.s11 } else { D::zero() }
    }
}

/// The number of evaluations of each formula; for a search, the number of segments and corners examined.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tally(ArrayVec<(&'static str, usize), 12>);

impl Tally {
    pub(crate) fn add(&mut self, formula: &'static str, times: usize) {
        match self.0.iter_mut().find(|(known, _)| *known == formula) {
            Some((_, count)) => *count += times,
            None => self.0.push((formula, times)),
        }
    }

    pub(crate) fn add_all(&mut self, other: &Self) {
        other.iter().for_each(|(formula, times)| self.add(formula, times));
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = (&'static str, usize)> {
        self.0.iter().copied()
    }
}

/// The location of an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Culprit {
    /// On the line as a whole.
    Line,
    /// At a slave node, by number.
    Node(u32),
    /// In an element, by number.
    Element(u32),
}

/// An error, with its location and its formula.
#[derive(Clone, Debug)]
pub(crate) struct Failure {
    pub(crate) culprit: Culprit,
    pub(crate) formula: &'static str,
    pub(crate) error: Error,
}

impl Surface {
    /// The formula of a stage, if this surface has it.
    fn formula(&self, stage: Stage) -> Option<&'static str> {
        match stage {
            Stage::Search => Some(self.line.closest_formula()),
            Stage::Slip => Some(self.line.slip_formula()),
            Stage::Law => self.interaction.law_formula(),
            Stage::Damping => self.interaction.damping_formula(),
            Stage::Friction => self.interaction.friction_formula(),
        }
    }

    /// Whether a stage must be evaluated for this request.
    fn needs(&self, stage: Stage, wanted: Wanted) -> bool {
        let shear = wanted.s12 && self.interaction.friction_formula().is_some();
        match stage {
            Stage::Search => true,
            Stage::Slip => wanted.e12 || shear,
            Stage::Law => wanted.s11 || shear,
            Stage::Damping => self.interaction.damping_formula().is_some() && (wanted.s11 || shear),
            Stage::Friction => shear,
        }
    }

    /// The formulas that a slave node needs, in the order of evaluation.
    pub(crate) fn formulas(&self, wanted: Wanted) -> impl Iterator<Item = (Stage, &'static str)> {
        let stages = [Stage::Search, Stage::Slip, Stage::Law, Stage::Damping, Stage::Friction];
        let needed = stages.into_iter().filter(move |&stage| self.needs(stage, wanted));
        needed.filter_map(|stage| Some((stage, self.formula(stage)?)))
    }

    /// The line at the current positions of its nodes.
    pub(crate) fn place<D: Scalar>(&self, motion: &impl Motion<D>) -> Result<PlacedSurface<'_, D>, Failure> {
        let placed = self.line.place_by(|node| motion.position(node));
        let formula = self.line.closest_formula();
        match placed {
            Ok(line) => Ok(PlacedSurface { surface: self, line }),
            Err(error) => Err(Failure { culprit: Culprit::Line, formula, error }),
        }
    }
}

/// A surface at the current positions of its nodes.
pub(crate) struct PlacedSurface<'s, D> {
    surface: &'s Surface,
    line: PlacedLine<D>,
}

impl<D: Scalar> PlacedSurface<'_, D> {
    /// The state of a slave node at the end of an increment; `multiplier` is its pressure of hard contact.
    ///
    /// Slip is the distance that the closest point travels along the line, measured in the configuration at the end of the
    /// increment; the closing rate follows from the displacements of the nodes, at the closest point there. Past the extension of
    /// an end of the line nothing is transmitted.
    pub(crate) fn advance(
        &self,
        state: &mut SlaveState<D>,
        Slave { node, wanted }: Slave,
        multiplier: f64,
        motion: &impl Motion<D>,
        tally: &mut Tally,
    ) -> Result<ClosestPoint<D>, Failure> {
        let Surface { line, interaction } = self.surface;
        let fail = |formula| move |error| Failure { culprit: Culprit::Node(node), formula, error };
        let search = line.closest_formula();
        let xs = motion.position(node).and_then(|xs| check_position(node, xs)).map_err(fail(search))?;
        let closest = self.line.closest(xs).map_err(fail(search))?;
        tally.add(search, closest.evaluated);
        state.e11 = closest.separation;

        let needs = |stage| self.surface.needs(stage, wanted);
        let (mut slip, mut closing) = (D::zero(), D::zero());
        if needs(Stage::Slip) || needs(Stage::Damping) {
            let (dxs, dx) = displacements(node, &closest, motion).map_err(fail(search))?;
            if needs(Stage::Slip) {
                let from = match state.foot {
                    Some(foot) => foot,
                    None => self.first_foot(xs, &closest, dxs, &dx, tally).map_err(fail(search))?,
                };
                let formula = line.slip_formula();
                tally.add(formula, PlacedLine::passed(&from, &closest.foot));
                slip = self.line.path_length(&from, &closest.foot);
                state.foot = Some(closest.foot);
                state.e12 = finite("e12", state.e12 + slip).map_err(fail(formula))?;
            }
            if let Some(duration) = motion.duration() {
                closing = -closest.normal.dot(&closest.relative_motion(dxs, &dx)) / duration;
            }
        }
        if needs(Stage::Law) {
            state.s11 = match closest.place {
                Place::Beyond { .. } => D::zero(),
                _ => pressure(interaction, -state.e11, closing, multiplier.into(), tally)
                    .map_err(|(formula, error)| fail(formula)(error))?,
            };
        }
        if let Some(formula) = interaction.friction_formula().filter(|_| needs(Stage::Friction)) {
            tally.add(formula, 1);
            state.s12 = finite("s12", interaction.shear(state.s12, slip, state.s11)).map_err(fail(formula))?;
        }
        Ok(closest)
    }
}

impl<D: Scalar> PlacedSurface<'_, D> {
    /// The length of the segment of a closest point.
    #[cfg(feature = "scene")]
    pub(crate) fn segment_length(&self, closest: &ClosestPoint<D>) -> D {
        self.line.segment_length(closest)
    }

    /// The previous position on the line of a slave node that has none yet: the motion relative to the line is undone.
    fn first_foot(
        &self,
        xs: Vector2<D>,
        closest: &ClosestPoint<D>,
        dxs: Vector2<D>,
        dx: &[Vector2<D>],
        tally: &mut Tally,
    ) -> Result<Foot<D>, Error> {
        let motion = closest.relative_motion(dxs, dx);
        if motion == Vector2::zeros() {
            return Ok(closest.foot);
        }
        let was = self.line.closest(xs - motion)?;
        tally.add(self.surface.line.closest_formula(), was.evaluated);
        Ok(was.foot)
    }
}

/// The displacements of the slave node, and of each node that carries its closest point.
type Displacements<D> = (Vector2<D>, ArrayVec<Vector2<D>, 5>);

fn displacements<D: Scalar>(
    node: u32,
    closest: &ClosestPoint<D>,
    motion: &impl Motion<D>,
) -> Result<Displacements<D>, Error> {
    let masters = closest.weights.iter().map(|&(master, _)| motion.displacement(master));
    Ok((motion.displacement(node)?, masters.collect::<Result<_, _>>()?))
}

/// The pressure of the law and of damping, or the formula that made it overflow.
fn pressure<D: Scalar>(
    interaction: &Interaction,
    h: D,
    v: D,
    multiplier: D,
    tally: &mut Tally,
) -> Result<D, (&'static str, Error)> {
    let mut p = interaction.law(h, multiplier);
    if let Some(formula) = interaction.law_formula() {
        tally.add(formula, 1);
        p = finite("s11", p).map_err(|error| (formula, error))?;
    }
    if let Some((formula, damping)) = interaction.damping_formula().zip(interaction.damping(h, v)) {
        tally.add(formula, 1);
        p = finite("s11", p + damping).map_err(|error| (formula, error))?;
    }
    Ok(p)
}

fn finite<D: Scalar>(name: &'static str, value: D) -> Result<D, Error> {
    if value.re().is_finite() { Ok(value) } else { Err(Error::Overflow { name }) }
}

/// The greatest torque that an element transmits, from the positive pressures at its nodes, counted from 0.
pub(crate) fn torque<D: Scalar>(
    element: &IslElement,
    motion: &impl Motion<D>,
    push: impl Fn(usize) -> Result<D, Error>,
    tally: &mut Tally,
) -> Result<D, Failure> {
    let formula = element.torque_formula();
    tally.add(formula, 1);
    let fail = |error| Failure { culprit: Culprit::Element(element.number()), formula, error };
    element.torque_by(|node| motion.position(node), push).map_err(fail)
}

/// The contact areas of the nodes of an element.
pub(crate) fn areas<D: Scalar>(
    element: &IslElement,
    motion: &impl Motion<D>,
    tally: &mut Tally,
) -> Result<ArrayVec<D, 3>, Failure> {
    let formula = element.area_formula();
    tally.add(formula, 1);
    let fail = |error| Failure { culprit: Culprit::Element(element.number()), formula, error };
    element.areas_by(|node| motion.position(node)).map_err(fail)
}

/// Adds the torque of an element to the sum so far.
pub(crate) fn total_torque<D: Scalar>(sum: D, element: &IslElement, torque: D) -> Result<D, Failure> {
    let fail = |error| Failure { culprit: Culprit::Line, formula: element.torque_formula(), error };
    finite("torque", sum + torque).map_err(fail)
}
