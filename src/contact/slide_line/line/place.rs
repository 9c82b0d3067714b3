//! The closest point of a slide line.

use crate::Scalar;
use arrayvec::ArrayVec;
use nalgebra::Vector2;

/// The material point of a line that is closest. It is unchanged if the line is translated, rotated or stretched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Foot<D> {
    /// The segment or smoothed corner, in order along the line.
    pub(super) piece: usize,
    /// The coordinate there, g or t.
    pub(super) u: D,
    /// The distance past an end of the line: negative before its first node, positive after its last.
    pub(super) beyond: D,
}

/// The location of a closest point on a slide line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place<D = f64> {
    /// On a segment, counted from 0, at its coordinate g from −1 to 1.
    Segment {
        /// The segment.
        index: usize,
        /// The coordinate on it.
        g: D,
    },
    /// On the smoothed corner after a segment, at its coordinate t from 0 to 1.
    Corner {
        /// The segment before the corner.
        index: usize,
        /// The coordinate on the corner.
        t: D,
    },
    /// At a node between two segments: a corner that is not smoothed and points to the slave point.
    Node {
        /// Its number.
        number: u32,
    },
    /// On the extension of the line past an end, along the tangent there.
    Extension {
        /// The number of the node at that end.
        number: u32,
        /// The distance past it, along the line; positive, in the unit of length.
        distance: D,
    },
    /// Past the extension of an end of the line.
    Beyond {
        /// The number of the node at that end.
        number: u32,
        /// The distance past it, along the line; positive, in the unit of length.
        distance: D,
    },
}

/// The closest point of a slide line to a slave point, with the data for the variation of the separation.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosestPoint<D = f64> {
    /// The location.
    pub place: Place<D>,
    /// The unit tangent t, in the sequence of the nodes.
    pub tangent: Vector2<D>,
    /// The unit normal n = s × t, towards the slave. At a node it points to or from the slave point.
    pub normal: Vector2<D>,
    /// The separation E11, positive when open, in the unit of length.
    pub separation: D,
    /// The nodes that carry the point, with their weights, which add up to 1.
    pub weights: ArrayVec<(u32, D), 5>,
    /// The material point of the line.
    pub(crate) foot: Foot<D>,
    /// The number of segments and corners that were examined to find it.
    pub evaluated: usize,
}

/// The first variation of the overclosure h = −E11: δh = slave·δxs + Σ masterᵢ·δxᵢ.
#[derive(Clone, Debug, PartialEq)]
pub struct OverclosureVariation<D = f64> {
    /// ∂h/∂xs = −n.
    pub slave: Vector2<D>,
    /// ∂h/∂xᵢ = Nᵢ n, by node number.
    pub masters: ArrayVec<(u32, Vector2<D>), 5>,
}

impl<D: Scalar> ClosestPoint<D> {
    /// The first variation of the overclosure.
    ///
    /// To first order the motion of the foot along the line is irrelevant, so the gradient needs no derivative of the coordinate
    /// g or t.
    ///
    /// ```
    /// use jointproof::contact::slide_line::{Interpolation, Nodes, SlideLine};
    /// let nodes = Nodes::new([(1, [1.0, 0.0]), (2, [5.0, 0.0])])?;
    /// let closest = SlideLine::new(Interpolation::Linear, [1, 2])?.place(&nodes)?.closest([2.0, 1.0].into())?;
    /// let variation = closest.overclosure_variation();
    /// assert_eq!((variation.slave.x, variation.slave.y), (0.0, -1.0));
    /// assert_eq!((variation.masters[0].0, variation.masters[0].1.y), (1, 0.75));
    /// # Ok::<(), jointproof::Error>(())
    /// ```
    pub fn overclosure_variation(&self) -> OverclosureVariation<D> {
        let masters = self.weights.iter().map(|&(node, weight)| (node, self.normal * weight)).collect();
        OverclosureVariation { slave: -self.normal, masters }
    }

    /// The motion of the slave point relative to the material under it: Σ Nᵢ (Δxs − Δxᵢ), exactly 0 if all displacements are
    /// equal.
    ///
    /// `dx` are the displacement increments of the nodes of [`weights`](Self::weights).
    pub fn relative_motion(&self, dxs: Vector2<D>, dx: &[Vector2<D>]) -> Vector2<D> {
        let terms = self.weights.iter().zip(dx).map(|(&(_, weight), dx)| (dxs - dx) * weight);
        terms.fold(Vector2::from_element(D::zero()), |sum, term| sum + term)
    }
}
