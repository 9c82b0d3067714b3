//! The positions of the nodes of a model.

use crate::Scalar;
use crate::formula::error::Error;
use nalgebra::Vector2;
use std::collections::HashMap;

/// The positions of the nodes of a model: (r, z) by node number, in the unit of length, with z along the axis of revolution.
///
/// There is one value per state of the model. A slide line and its elements refer to their nodes by number only.
///
/// ```
/// use jointproof::contact::slide_line::Nodes;
/// let nodes = Nodes::new([(1, [1.0, 0.0]), (2, [2.0, 0.5])])?;
/// assert_eq!(nodes.position(2)?.y, 0.5);
/// assert_eq!(nodes.position(3).unwrap_err().to_string(), "node 3 is unknown; allowed are nodes with coordinates");
///
/// let error = Nodes::new([(7, [-1.0, 0.0])]).unwrap_err();
/// assert_eq!(error.to_string(), "node 7 has the radius -1; allowed are finite coordinates with r ≥ 0, once per node");
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Nodes<D = f64>(HashMap<u32, Vector2<D>>);

impl<D: Scalar> Nodes<D> {
    /// Nodes with these numbers and coordinates.
    ///
    /// # Errors
    /// [`Error::Node`]: a coordinate that is not finite, a radius below 0, or a number given twice.
    pub fn new(nodes: impl IntoIterator<Item = (u32, [D; 2])>) -> Result<Self, Error> {
        let mut positions = HashMap::new();
        for (node, x) in nodes {
            if positions.insert(node, check_position(node, x.into())?).is_some() {
                return Err(bad_position(node, "is given twice".into()));
            }
        }
        Ok(Self(positions))
    }

    /// The position of a node.
    ///
    /// # Errors
    /// [`Error::UnknownNode`].
    pub fn position(&self, node: u32) -> Result<Vector2<D>, Error> {
        self.0.get(&node).copied().ok_or(Error::UnknownNode { node })
    }

    /// The displacement of a node since an earlier state.
    ///
    /// # Errors
    /// [`Error::UnknownNode`] in either state.
    pub fn displacement(&self, before: &Self, node: u32) -> Result<Vector2<D>, Error> {
        Ok(self.position(node)? - before.position(node)?)
    }
}

impl Nodes {
    /// The same positions in another scalar, such as `Octuple` for the exact result.
    pub fn convert<D: Scalar>(&self) -> Nodes<D> {
        Nodes(self.0.iter().map(|(&node, x)| (node, x.map(D::from))).collect())
    }
}

/// Checks that a node may have this position.
pub(crate) fn check_position<D: Scalar>(node: u32, x: Vector2<D>) -> Result<Vector2<D>, Error> {
    let [r, z] = [x.x.re(), x.y.re()];
    if !(r.is_finite() && z.is_finite()) {
        Err(bad_position(node, format!("is at ({r}, {z})")))
    } else if r < 0.0 {
        Err(bad_position(node, format!("has the radius {r}")))
    } else {
        Ok(x)
    }
}

fn bad_position(node: u32, fault: String) -> Error {
    Error::Node { node, fault, allowed: "finite coordinates with r ≥ 0, once per node" }
}
