//! What the named numbers of golden files look like in JSON; only the schemas of these types are used.
#![expect(dead_code, reason = "never constructed: the files are written from plain JSON values")]

use schemars::JsonSchema;
use std::collections::BTreeMap;

/// Inputs by name.
pub(super) type Inputs = BTreeMap<String, Input>;
/// Outputs by name.
pub(super) type Outputs = BTreeMap<String, Output>;
/// `jac[out][in]`.
pub(super) type Jacobian = BTreeMap<String, BTreeMap<String, Entry>>;

/// The value of an input: a double, or one per component of a column.
#[derive(JsonSchema)]
#[serde(untagged)]
pub(super) enum Input {
    Scalar(Double),
    Column(#[schemars(length(min = 2))] Vec<Double>),
}

/// The value of an output: a finite double, or one per component of a column.
#[derive(JsonSchema)]
#[serde(untagged)]
pub(super) enum Output {
    Scalar(f64),
    Column(#[schemars(length(min = 2))] Vec<f64>),
}

/// The derivative of one output by one input, finite: a double where both are scalars; a column where one of them is;
/// where both are columns, a row per component of the output.
#[derive(JsonSchema)]
#[serde(untagged)]
pub(super) enum Entry {
    Scalar(f64),
    Column(#[schemars(length(min = 2))] Vec<f64>),
    Rows(#[schemars(length(min = 2), inner(length(min = 2)))] Vec<Vec<f64>>),
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
