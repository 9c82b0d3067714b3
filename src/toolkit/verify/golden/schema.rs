//! The JSON form of the named numbers in golden files; only the schemas of these types are used.
#![expect(dead_code, reason = "never constructed: the files are written from plain JSON values")]

use schemars::JsonSchema;
use std::collections::BTreeMap;

/// Inputs by name.
pub(super) type Inputs = BTreeMap<String, Input>;
/// Outputs by name.
pub(super) type Outputs = BTreeMap<String, Output>;
/// `jac[out][in]`.
pub(super) type Jacobian = BTreeMap<String, BTreeMap<String, Entry>>;

/// The value of an input: a double, one per component of a column, or the rows of a matrix.
#[derive(JsonSchema)]
#[serde(untagged)]
pub(super) enum Input {
    Scalar(Double),
    Column(#[schemars(length(min = 2))] Vec<Double>),
    Rows(#[schemars(length(min = 2), inner(length(min = 2)))] Vec<Vec<Double>>),
}

/// The value of an output: a finite double, one per component of a column, or the rows of a matrix.
#[derive(JsonSchema)]
#[serde(untagged)]
pub(super) enum Output {
    Scalar(f64),
    Column(#[schemars(length(min = 2))] Vec<f64>),
    Rows(#[schemars(length(min = 2), inner(length(min = 2)))] Vec<Vec<f64>>),
}

/// The derivative of one output by one input, finite: nested by the shape of the output, and within it by that of the
/// input. A double where both are scalars; where both are columns, a row per component of the output.
#[derive(JsonSchema)]
#[serde(untagged)]
pub(super) enum Entry {
    Scalar(f64),
    Nested(#[schemars(length(min = 2))] Vec<Entry>),
}

/// Scales of outputs by name.
pub(super) type OutputScales = BTreeMap<String, Scale>;
/// Scales `jac_scale[out][in]`.
pub(super) type JacobianScales = BTreeMap<String, BTreeMap<String, Scale>>;

/// A scale in four digits, or nested as the numbers that it is of; "Infinity" where it is beyond all doubles.
#[derive(JsonSchema)]
#[serde(untagged)]
pub(super) enum Scale {
    Finite(#[schemars(range(min = 0))] f64),
    Overflown(Overflown),
    Nested(#[schemars(length(min = 2))] Vec<Scale>),
}

/// What is beyond all doubles.
#[derive(JsonSchema)]
pub(super) enum Overflown {
    Infinity,
}

/// A double, written so that it reads back bit for bit; a string where JSON has no number.
#[derive(JsonSchema)]
#[serde(untagged)]
pub(super) enum Double {
    Finite(f64),
    NotFinite(NotFinite),
}

/// What JSON has no number for.
#[derive(JsonSchema)]
pub(super) enum NotFinite {
    NaN,
    Infinity,
    #[serde(rename = "-Infinity")]
    NegativeInfinity,
}
