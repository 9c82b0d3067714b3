//! The state of a contact at the end of an increment.

use super::engine::SlaveState;
use crate::Scalar;
use crate::contact::slide_line::{ClosestPoint, Nodes};
use crate::formula::error::Error;
use nalgebra::Vector2;
use std::collections::BTreeMap;

/// The contact at a slave node.
#[derive(Clone, Debug, PartialEq)]
pub struct SlaveNode<D = f64> {
    /// The closest point of the slide line.
    pub closest: ClosestPoint<D>,
    /// Contact area, the sum over the elements at the node, around the whole circumference (L²).
    pub area: D,
    /// Separation, positive when open (L).
    pub e11: D,
    /// Accumulated relative tangential displacement, positive along the line (L).
    pub e12: D,
    /// Pressure, positive when it pushes (F/L²).
    pub s11: D,
    /// Shear stress, positive when it resists positive slip (F/L²).
    pub s12: D,
}

impl<D: Scalar> SlaveNode<D> {
    /// The part of the state from which the engine continues.
    pub(super) fn engine_state(&self) -> SlaveState<D> {
        SlaveState { e11: self.e11, e12: self.e12, s11: self.s11, s12: self.s12, foot: Some(self.closest.foot) }
    }

    /// The force on the slave node, in the axes (r, z): A (S11 n − S12 t).
    pub fn force(&self) -> Vector2<D> {
        (self.closest.normal * self.s11 - self.closest.tangent * self.s12) * self.area
    }

    /// The balancing forces on the master nodes, by node number: −Nᵢ times the force on the slave node.
    pub fn reactions(&self) -> impl Iterator<Item = (u32, Vector2<D>)> {
        let force = self.force();
        self.closest.weights.iter().map(move |&(node, weight)| (node, -force * weight))
    }
}

/// The state of a contact, created by [`Contact::start`](super::Contact::start) and
/// [`Contact::advance`](super::Contact::advance).
#[derive(Clone, Debug, PartialEq)]
pub struct ContactState<D = f64> {
    pub(super) places: Nodes<D>,
    pub(super) slaves: BTreeMap<u32, SlaveNode<D>>,
}

impl<D: Scalar> ContactState<D> {
    /// The slave nodes by number.
    pub fn nodes(&self) -> &BTreeMap<u32, SlaveNode<D>> {
        &self.slaves
    }

    /// A slave node.
    ///
    /// # Errors
    /// [`Error::UnknownNode`]: the node is not one of the contact's elements.
    pub fn node(&self, node: u32) -> Result<&SlaveNode<D>, Error> {
        self.slaves.get(&node).ok_or(Error::UnknownNode { node })
    }

    /// The positions of the nodes.
    pub fn places(&self) -> &Nodes<D> {
        &self.places
    }

    /// The forces on slave and master nodes, by node number, in the axes (r, z). They add up to zero.
    pub fn forces(&self) -> BTreeMap<u32, Vector2<D>> {
        let mut forces = BTreeMap::new();
        for (&node, slave) in &self.slaves {
            for (node, force) in slave.reactions().chain([(node, slave.force())]) {
                *forces.entry(node).or_insert_with(|| Vector2::from_element(D::zero())) += force;
            }
        }
        forces
    }
}
