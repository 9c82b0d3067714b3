//! The points at which a search that climbs found the largest backward errors: cases of the golden files, so that other programs
//! are judged there, too.
//!
//! They are kept in `worst.json`: by formula, one for the value and one for the Jacobian, only where a bound of every component is
//! nearly reached. Each is as `audit --attack` prints it.

use crate::formula::Field;
use crate::formula::proof::{Case, Flag};
use crate::toolkit::verify::golden::components;
use serde_json::{Map, Value};
use std::collections::HashMap;
use std::sync::LazyLock;

/// The inputs by name, of each formula for value and Jacobian.
type Points = HashMap<String, Map<String, Value>>;

static POINTS: LazyLock<HashMap<String, Points>> =
    LazyLock::new(|| serde_json::from_str(include_str!("worst.json")).expect("the file is tested"));

/// The cases of a formula with these inputs; points of inputs that it no longer has are left out, which a test finds.
pub(super) fn cases(id: &str, inputs: &[Field]) -> Vec<Case<Vec<f64>>> {
    let of = |what: &str| {
        let point = POINTS.get(id)?.get(what)?;
        let comment = "the largest η that a search found, in roundings";
        Some(Case::new(Flag::Worst, format!("worst-{what}"), comment, components(inputs, point).ok()?))
    };
    ["value", "jacobian"].into_iter().filter_map(of).collect()
}
