//! The names that Abaqus has for outputs of connectors.
//!
//! Its connector element library names them by component: CU1 is the relative displacement in the 1-direction. A name is accepted
//! for an output that is the same number, with the same sign and in the same axes. Where only a similar output exists, such as a
//! vector in the global axes instead of components along node a's, a message names it.

/// Abaqus' name of an output, and ours. CSF, CSM, CASU, CASUR, E11, E12, S11 and S12 have the same name in both.
pub const SAME_OUTPUTS: [(&str, &str); 7] = [
    ("CU1", "U1"),
    ("CUR1", "UR1"),
    ("CUR2", "UR2"),
    ("CUR3", "UR3"),
    ("CCU1", "U1MAT"),
    ("CCUR1", "UR1MAT"),
    ("CCUR3", "UR3MAT"),
];

/// Its names of outputs that have the same name here.
const SHARED: [&str; 10] = ["CSF1", "CSM1", "CSM3", "CASU1", "CASUR1", "CASUR3", "E11", "E12", "S11", "S12"];

/// Its names of all components together.
const GROUPS: [(&str, &[&str]); 6] = [
    ("CU", &["U1", "UR1", "UR2", "UR3"]),
    ("CCU", &["U1MAT", "UR1MAT", "UR3MAT"]),
    ("CSF", &["CSF1", "CSM1", "CSM3"]),
    ("CASU", &["CASU1", "CASUR1", "CASUR3"]),
    ("E", &["E11", "E12"]),
    ("S", &["S11", "S12"]),
];

/// Abaqus' names without the number of the component, and what is similar.
const SIMILAR: [(&str, &str); 14] = [
    ("CTF", "KF, of load and friction alone and in the global axes"),
    ("CTM", "KM, of load and friction alone and in the global axes"),
    ("CRF", "RF, in the global axes and without the reactions of stops"),
    ("CRM", "RM, in the global axes"),
    ("CNF", "FN, which is not negative"),
    ("CNM", "MN, MN1 or MN3, which are not negative"),
    ("CP", "X, Y or Z"),
    ("CPR", "ALPHA, BETA or GAMMA"),
    ("CSLST", "GAPMIN and GAPMAX, which are negative past a stop"),
    ("CTRQ", "T"),
    ("CSHEAR", "S12"),
    ("CPRESS", "S11"),
    ("COPEN", "E11"),
    ("CSLIP", "E12"),
];

/// Our name of an output.
pub(super) fn own_name(name: &str) -> &str {
    SAME_OUTPUTS.iter().find(|(theirs, _)| *theirs == name).map_or(name, |(_, ours)| ours)
}

/// Our names of the outputs that one of Abaqus' names requests; none if we have only something similar.
pub(super) fn same_outputs(name: &str) -> Vec<&'static str> {
    let same = SAME_OUTPUTS.into_iter().chain(SHARED.map(|name| (name, name)));
    let single = same.filter(|(theirs, _)| *theirs == name).map(|(_, ours)| ours);
    let group = GROUPS.iter().filter(|(theirs, _)| *theirs == name).flat_map(|(_, ours)| *ours).copied();
    single.chain(group).collect()
}

/// What somebody may mean who writes an unknown name where these are known.
pub(super) fn meant(name: &str, known: &[&str]) -> Option<String> {
    let upper = name.to_uppercase();
    let own = own_name(&upper);
    if known.contains(&own) {
        return Some(own.into());
    }
    let without_component = upper.trim_end_matches(|c: char| c.is_ascii_digit());
    let similar = SIMILAR.iter().find(|(theirs, _)| *theirs == without_component).map(|(_, similar)| *similar);
    similar.filter(|similar| similar.split([' ', ',']).any(|word| known.contains(&word))).map(String::from)
}

#[cfg(test)]
mod tests {
    use super::{GROUPS, SAME_OUTPUTS, SHARED, SIMILAR, meant, own_name, same_outputs};
    use crate::scene::kind::Kind;

    #[test]
    fn every_name_is_of_an_output_that_exists_and_of_nothing_else() {
        let outputs: Vec<_> = Kind::all().flat_map(Kind::outputs).map(|(name, _)| name).collect();
        for (theirs, ours) in SAME_OUTPUTS {
            assert!(outputs.contains(&ours) && !outputs.contains(&theirs), "{theirs}");
        }
        for ours in SHARED.iter().chain(GROUPS.iter().flat_map(|(_, ours)| *ours)) {
            assert!(outputs.contains(ours), "{ours}");
        }
        for (theirs, similar) in SIMILAR {
            assert!(!outputs.contains(&theirs) && meant(theirs, &outputs).as_deref() == Some(similar), "{theirs}");
        }
    }

    #[test]
    fn a_name_is_ours_or_a_hint() {
        assert_eq!([same_outputs("CUR3"), same_outputs("E12")], [["UR3"], ["E12"]]);
        assert_eq!(same_outputs("CSF"), ["CSF1", "CSM1", "CSM3"]);
        assert!(same_outputs("CTF1").is_empty() && same_outputs("U1").is_empty());
        assert_eq!([own_name("CU1"), own_name("U1"), own_name("CTF1")], ["U1", "U1", "CTF1"]);
        let known = ["U1", "KF"];
        assert_eq!(meant("u1", &known).as_deref(), Some("U1"));
        assert_eq!(meant("cu1", &known).as_deref(), Some("U1"));
        assert_eq!(meant("CTF2", &known).as_deref(), Some("KF, of load and friction alone and in the global axes"));
        assert_eq!([meant("CUR1", &known), meant("CRF1", &known), meant("XYZ", &known)], [None, None, None]);
    }
}
