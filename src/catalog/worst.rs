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

#[cfg(all(test, feature = "catalog"))]
mod tests {
    use super::*;
    use crate::catalog::find;

    /// Every point is of a formula that there is, is valid, and is a case of it.
    #[test]
    fn every_point_is_a_case() {
        assert!(!POINTS.is_empty());
        for (id, points) in &*POINTS {
            let formula = find(id).unwrap_or_else(|| panic!("{id} is in the catalog"));
            let cases = cases(id, formula.inputs());
            assert_eq!(cases.len(), points.len(), "{id}");
            for case in cases {
                assert!(formula.value_and_closed_jacobian(&case.inputs).is_ok(), "{id} {}", case.id);
                assert!(formula.golden_cases().contains(&case), "{id} {}", case.id);
            }
        }
    }

    /// The points are nearly as bad as the bounds before the search: a program with other roundings is judged there.
    #[test]
    fn every_point_is_bad() {
        for (id, points) in &*POINTS {
            let formula = find(id).unwrap_or_else(|| panic!("{id} is in the catalog"));
            for (what, point) in points {
                let inputs = components(formula.inputs(), point).expect("it was read before");
                let claims = formula.eta_at(&inputs).expect("it is valid");
                let worst = claims[usize::from(what == "jacobian")].worst.as_ref().expect("it was checked");
                assert!(worst.size > 0.9, "{id} {what}: {}", worst.size);
            }
        }
    }
}
