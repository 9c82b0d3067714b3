//! Studies that the book shows: computed anew by every build, or by tests that need other programs; held by tests.

pub(crate) mod agreement;
pub(crate) mod arm_models;
pub(crate) mod near_right_angle;
pub(crate) mod routes;
