//! Studies that the book shows: computed anew by every build, and held by tests of the library.

pub(crate) mod arm_models;
pub(crate) mod near_right_angle;
pub(crate) mod routes;
