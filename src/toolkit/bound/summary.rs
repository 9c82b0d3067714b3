//! What is known of the accuracy of a formula, in figures and in words.

use super::field::{Rational, to_f64};
use crate::formula::{Bounds, NORMWISE, Spec};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

/// What is proved of value or Jacobian.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Summary {
    /// The number of entries that rounding can change at all.
    pub entries: usize,
    /// Those of them that are proved.
    pub proved: usize,
    /// The largest proved bound of η of an entry.
    #[serde(serialize_with = "written", deserialize_with = "read")]
    pub bound: Rational,
    /// Whether of some proved entry only the first order is.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub first_order_only: bool,
    /// Whether the bound of some proved entry is normwise.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub normwise: bool,
    /// Why the first of the other entries is not proved.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub why: String,
}

fn written<S: Serializer>(bound: &Rational, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(bound)
}

fn read<'a, D: Deserializer<'a>>(deserializer: D) -> Result<Rational, D::Error> {
    String::deserialize(deserializer)?.parse().map_err(de::Error::custom)
}

impl Summary {
    /// The bound as a double, not below it.
    pub fn bound(&self) -> f64 {
        if self.bound.is_integer() { to_f64(self.bound) } else { to_f64(self.bound).next_up() }
    }

    /// Whether every entry is proved.
    pub fn is_whole(&self) -> bool {
        self.proved == self.entries
    }

    /// The bound where every entry is proved as its formula states it: a normwise proof says nothing of a bound by components.
    pub fn of_all(&self, spec: &Spec) -> Option<f64> {
        (self.is_whole() && (!self.normwise || spec.normwise.is_some())).then(|| self.bound())
    }

    /// The bound of η, and how it is known; `stated` is what the audit checks, `by` says how that is meant. A proof may give less than
    /// a search shows.
    fn said(&self, stated: f64, by: &str, found: Option<f64>) -> String {
        let Self { entries, proved, bound, first_order_only, normwise, .. } = self;
        let order = if *first_order_only { " to first order" } else { "" };
        let proof = format!("η ≤ {bound}, proved{order}{}", if *normwise { NORMWISE } else { "" });
        if *entries == 0 {
            return "exact".into();
        }
        // A normwise proof says less than a search by components.
        let is_best = self.is_whole() && to_f64(*bound) <= stated && (!normwise || by == NORMWISE);
        let mut details: Vec<_> = found.map(|found| format!("largest found {found:.2}")).into_iter().collect();
        match (self.is_whole(), proved) {
            (true, _) if is_best => {}
            (true, _) => details.push(proof.clone()),
            (false, 0) => {}
            (false, _) => details.push(format!("{proved} of {entries} entries {proof}")),
        }
        let details = if details.is_empty() { String::new() } else { format!(" ({})", details.join("; ")) };
        if is_best { proof + &details } else { format!("η ≤ {stated}, measured{by}{details}") }
    }
}

/// The bounds of η of value and Jacobian in words, each proved or measured, with the largest η found where it is known.
///
/// ```
/// use jointproof::connector::slider::rows::Rows;
/// use jointproof::connector::ujoint::HingeAxial;
/// use jointproof::formula::Formula;
/// use jointproof::toolkit::bound::{Summary, accuracy};
///
/// let proved = Summary { entries: 4, proved: 4, bound: "5/3".parse()?, ..Summary::default() };
/// let some = Summary { proved: 3, ..proved.clone() };
/// assert_eq!(
///     accuracy(&HingeAxial::SPEC, Some(&[proved, some]), [Some(1.56), None]),
///     "value: η ≤ 5/3, proved (largest found 1.56); Jacobian: η ≤ 5.5, measured (3 of 4 entries η ≤ 5/3, proved)"
/// );
/// assert_eq!(accuracy(&Rows::SPEC, None, [None; 2]), "value: η ≤ 12, measured, normwise; Jacobian: automatic");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn accuracy(spec: &Spec, proved: Option<&[Summary; 2]>, found: [Option<f64>; 2]) -> String {
    let (Bounds { value, jacobian }, by) = spec.bounds();
    // Without a proof it is enough that there is an entry.
    let nothing = [(); 2].map(|()| Summary { entries: 1, ..Summary::default() });
    let [of_value, of_jacobian] = proved.unwrap_or(&nothing);
    let jacobian = jacobian.map_or("automatic".into(), |stated| of_jacobian.said(stated, by, found[1]));
    format!("value: {}; Jacobian: {jacobian}", of_value.said(value, by, found[0]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::connector::slider::rows::Rows;
    use crate::connector::ujoint::HingeAxial;
    use crate::formula::Formula;

    /// A normwise proof is none of a bound by components, however small it is.
    #[test]
    fn a_normwise_proof_does_not_replace_a_bound_by_components() {
        let by_components = Summary { entries: 1, proved: 1, bound: 1.into(), ..Summary::default() };
        let normwise = Summary { normwise: true, ..by_components.clone() };
        let of_all = |of: &Summary| [of.of_all(&HingeAxial::SPEC), of.of_all(&Rows::SPEC)];
        assert_eq!([of_all(&by_components), of_all(&normwise)], [[Some(1.0); 2], [None, Some(1.0)]]);
        let said = |of: Summary| accuracy(&HingeAxial::SPEC, Some(&[of.clone(), of]), [None; 2]);
        assert!(said(by_components).starts_with("value: η ≤ 1, proved;"));
        assert!(said(normwise).contains("measured (η ≤ 1, proved, normwise); Jacobian"));
    }
}
