//! The dimension of a scene.

/// The dimension of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Dimension {
    /// Space, `3d`.
    Space,
    /// The plane, `2d`.
    Plane,
    /// The half plane of radius and axis, `axisymmetric`.
    Axisymmetric,
}

impl Dimension {
    /// Every dimension.
    pub const ALL: [Self; 3] = [Self::Space, Self::Plane, Self::Axisymmetric];

    /// The name in scene files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Space => "3d",
            Self::Plane => "2d",
            Self::Axisymmetric => "axisymmetric",
        }
    }

    /// The number of coordinates of a node.
    pub const fn coordinates(self) -> usize {
        if matches!(self, Self::Space) { 3 } else { 2 }
    }
}
