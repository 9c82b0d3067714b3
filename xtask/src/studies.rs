//! Studies shown in the book: recomputed by every build, or by tests that need other programs; guarded by tests.

pub(crate) mod agreement;
pub(crate) mod arm_models;
pub(crate) mod derivatives;
pub(crate) mod near_right_angle;
pub(crate) mod routes;
