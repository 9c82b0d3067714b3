//! The keywords that are read, and what becomes of them in the scene.

use super::block::Block;
use super::field::without_blanks;
use super::reading::Reading;
use super::terms::{COMPONENTS, PREDEFINED, is_rotation};
use super::{connector, contact, generate, mesh, requests};
use crate::scene::kind::{Dimension, Kind};

/// A keyword that is read.
pub(super) struct Keyword {
    name: &'static str,
    /// The parameters that are read, and those without effect on a scene.
    pub(super) parameters: &'static [&'static str],
    pub(super) without_effect: &'static [&'static str],
    /// Whether it belongs to a keyword above it.
    pub(super) is_below: bool,
    /// Whether it is read in steps, too.
    pub(super) in_steps: bool,
    pub(super) read: fn(&mut Reading<'_>, &Block),
    /// Where it gives something, the key of the scene, and the unit.
    rows: &'static [[&'static str; 3]],
}

const fn keyword(
    name: &'static str,
    parameters: &'static [&'static str],
    read: fn(&mut Reading<'_>, &Block),
    rows: &'static [[&'static str; 3]],
) -> Keyword {
    Keyword { name, parameters, without_effect: &[], is_below: false, in_steps: false, read, rows }
}

impl Keyword {
    const fn without_effect(self, without_effect: &'static [&'static str]) -> Self {
        Self { without_effect, ..self }
    }

    const fn below(self) -> Self {
        Self { is_below: true, ..self }
    }

    const fn in_steps(self) -> Self {
        Self { in_steps: true, ..self }
    }

    /// The keyword of this name, which is in upper case without blanks.
    pub(super) fn find(name: &str) -> Option<&'static Self> {
        KEYWORDS.iter().find(|keyword| keyword.name.bytes().filter(|&byte| byte != b' ').eq(name.bytes()))
    }

    /// The keyword of which an unknown name is the beginning, or a slip: the format lets keywords be abbreviated, but only one
    /// who knows all of them could tell which is meant.
    pub(super) fn meant(name: &str) -> Option<&'static str> {
        let known = KEYWORDS.iter().map(|keyword| keyword.name).chain(WALKED);
        (!OTHERS.contains(&name)).then(|| meant(name, known)).flatten()
    }

    /// The parameter that an unknown one means, likewise.
    pub(super) fn meant_parameter(&self, name: &str) -> Option<&'static str> {
        meant(name, self.parameters.iter().chain(self.without_effect).copied())
    }
}

fn meant(name: &str, mut known: impl Iterator<Item = &'static str>) -> Option<&'static str> {
    known.find(|known| {
        let known = without_blanks(known);
        name.len() > 2 && known.starts_with(name) || name.len() > 5 && is_slip(name, &known)
    })
}

/// Whether two words differ by one letter that is wrong, missing or too many, or by two that are exchanged.
fn is_slip(one: &str, other: &str) -> bool {
    let (one, other) = (one.as_bytes(), other.as_bytes());
    let before = one.iter().zip(other).take_while(|(a, b)| a == b).count();
    let [one, other] = [&one[before..], &other[before..]];
    let after = one.iter().rev().zip(other.iter().rev()).take_while(|(a, b)| a == b).count();
    match [&one[..one.len() - after], &other[..other.len() - after]] {
        [[a, b], [c, d]] => [a, b] == [d, c],
        [a, b] => a.len() <= 1 && b.len() <= 1,
    }
}

/// The keywords that the walk through the blocks reads.
const WALKED: [&str; 9] =
    ["INCLUDE", "PART", "END PART", "ASSEMBLY", "END ASSEMBLY", "INSTANCE", "END INSTANCE", "STEP", "END STEP"];

/// Keywords that are not read, with which one that is read begins.
const OTHERS: [&str; 3] = ["SURFACE", "TORQUE", "END"];

/// What they give.
pub(super) const STRUCTURE: &[[&str; 4]] = &[
    ["*INCLUDE", "INPUT", "the file is read in its place", ""],
    ["*PART, *ASSEMBLY, *INSTANCE", "NAME, PART", "names: `instance.number`", ""],
    ["*INSTANCE", "first line", "`at`: added", "L"],
    ["*INSTANCE", "second line", "`at`, `axes`: rotated about an axis by two points and an angle", "L, degrees"],
];

const KEYWORDS: &[Keyword] = &[
    keyword("HEADING", &[], mesh::heading, &[["first line", "`title`", ""]]),
    keyword(
        "NODE",
        &["NSET", "SYSTEM", "INPUT"],
        mesh::node,
        &[
            ["number", "a name in `nodes`", ""],
            ["coordinates", "`at`", "L"],
            ["SYSTEM=C", "`at`: radius, angle and height", "L, degrees, L"],
        ],
    ),
    keyword("NGEN", &["NSET", "LINE"], generate::nodes, &[["first, last, increment", "nodes at equal distances", "L"]])
        .without_effect(&["SYSTEM"]),
    keyword("NSET", &["NSET", "GENERATE", "INSTANCE"], mesh::node_set, &[["members", "nodes of constraints", ""]])
        .without_effect(&["INTERNAL", "UNSORTED"]),
    keyword(
        "ELEMENT",
        &["TYPE", "ELSET", "INPUT"],
        mesh::element,
        &[
            ["TYPE=CONN3D2", "`dimension`: `3d`", ""],
            ["TYPE=CONN2D2", "`dimension`: `2d`", ""],
            ["TYPE=ISL21A, ISL22A", "`dimension`: `axisymmetric`, `kind`", ""],
            ["number", "a name in `elements`", ""],
            ["nodes", "`nodes`", ""],
        ],
    ),
    keyword(
        "ELGEN",
        &["ELSET"],
        generate::elements,
        &[[
            "an element; of a row, of rows and of layers: how many, increments of nodes and elements",
            "`elements`",
            "",
        ]],
    )
    .without_effect(&["ALLNODES"]),
    keyword(
        "ELSET",
        &["ELSET", "GENERATE", "INSTANCE"],
        mesh::element_set,
        &[["members", "elements of a section or line", ""]],
    )
    .without_effect(&["INTERNAL", "UNSORTED"]),
    keyword(
        "ORIENTATION",
        &["NAME", "SYSTEM", "DEFINITION"],
        mesh::orientation,
        &[
            [
                "SYSTEM=RECTANGULAR (the default): a on the first axis, b in the plane of the first two, the origin",
                "`axes` or `angle`",
                "L",
            ],
            [
                "SYSTEM=Z RECTANGULAR: a on the third axis, b in the plane of the third and the first, the origin",
                "`axes` or `angle`",
                "L",
            ],
            [
                "SYSTEM=CYLINDRICAL: a and b on the axis",
                "`axes` at the node: along the radius, around, along the axis",
                "L",
            ],
            [
                "SYSTEM=SPHERICAL: the centre a, b on the polar axis",
                "`axes` at the node: along the radius, around, along the meridian",
                "L",
            ],
            ["DEFINITION=NODES", "nodes in place of coordinates", ""],
            ["second line: axis, angle", "`axes` or `angle`: rotated about it", "degrees"],
        ],
    )
    .without_effect(&["LOCALDIRECTIONS"]),
    keyword(
        "CONNECTOR SECTION",
        &["ELSET", "BEHAVIOR"],
        connector::section,
        &[
            ["first line: types", "`kind`", ""],
            ["second line: orientations at a and b", "`orientation` of the nodes", ""],
        ],
    )
    .without_effect(&["CONTROLS", "ELIMINATION"]),
    keyword("CONNECTOR BEHAVIOR", &["NAME"], connector::behavior, &[]).without_effect(&[
        "INTEGRATION",
        "EXTRAPOLATION",
        "REGULARIZE",
        "RTOL",
    ]),
    keyword(
        "CONNECTOR FRICTION",
        &["PREDEFINED", "STICKSTIFFNESS"],
        connector::friction,
        &[["STICK STIFFNESS", "`k_stick`", "F/L or F L"]],
    )
    .below(),
    keyword("FRICTION", &[], contact::friction, &[["coefficient", "`mu`", "1"]])
        .below()
        .without_effect(&["SLIPTOLERANCE", "ELASTICSLIP"]),
    keyword("CONNECTOR STOP", &["COMPONENT"], connector::stop, &[]).below(),
    keyword("CONNECTOR CONSTITUTIVE REFERENCE", &[], connector::reference, &[]).below(),
    keyword(
        "MPC",
        &[],
        contact::constraints,
        &[["SLIDER, node, first, last", "an element of `kind` `slider`: `nodes` first, last, node", ""]],
    ),
    keyword(
        "SLIDE LINE",
        &["ELSET", "TYPE", "SMOOTH", "EXTENSIONZONE", "GENERATE"],
        contact::slide_line,
        &[
            ["ELSET", "a name in `slide_lines`, and `slide_line` of the elements", ""],
            ["TYPE", "`type`", ""],
            ["nodes, or GENERATE and first, last, increment", "`nodes`", ""],
            ["SMOOTH", "`smooth`", "1"],
            ["EXTENSION ZONE", "`extension_zone`", "1"],
        ],
    ),
    keyword("INTERFACE", &["ELSET"], contact::interface, &[]),
    keyword(
        "SURFACE BEHAVIOR",
        &["PRESSURE-OVERCLOSURE"],
        contact::surface_behavior,
        &[
            ["PRESSURE-OVERCLOSURE=LINEAR: stiffness", "`pressure`: `k`", "F/L³"],
            ["PRESSURE-OVERCLOSURE=EXPONENTIAL: clearance, pressure", "`pressure`: `c0`, `p0`", "L, F/L²"],
        ],
    )
    .below(),
    keyword("TORQUE PRINT", &["FREQUENCY"], contact::torque_print, &[["FREQUENCY", "`torque_frequency`", ""]])
        .below()
        .in_steps(),
    requested("ELEMENT OUTPUT"),
    requested("EL PRINT"),
    requested("EL FILE"),
];

const fn requested(name: &'static str) -> Keyword {
    keyword(name, &["ELSET", "VARIABLE"], requests::read, &[["names of outputs", "`outputs` of the elements", ""]])
        .without_effect(&["DIRECTIONS", "FREQUENCY", "POSITION", "SUMMARY", "TOTALS"])
        .below()
        .in_steps()
}

/// What each keyword gives: the keyword, where it is given, the key of the scene, and the unit.
pub fn table() -> Vec<[String; 4]> {
    let mut table: Vec<_> = STRUCTURE.iter().map(|row| row.map(String::from)).collect();
    for Keyword { name, rows, .. } in KEYWORDS {
        table.extend(
            rows.iter().map(|[given, key, unit]| [format!("*{name}"), (*given).into(), (*key).into(), (*unit).into()]),
        );
        match *name {
            "CONNECTOR FRICTION" => table.extend(PREDEFINED.iter().flat_map(|&(kind, parameters)| {
                let row = move |(field, parameter): (usize, &&str)| {
                    let given = format!("PREDEFINED, {}: field {}", kind.to_uppercase(), field + 1);
                    [format!("*{name}"), given, format!("`{parameter}`"), unit(kind, parameter)]
                };
                parameters.iter().enumerate().map(row)
            })),
            "CONNECTOR STOP" => table.extend((1..).zip(&COMPONENTS).filter_map(|(component, [_, low, high])| {
                let given = format!("COMPONENT={component}: lower and upper limit");
                of_component(name, component, given, &[low, high])
            })),
            "CONNECTOR CONSTITUTIVE REFERENCE" => {
                table.extend((1..).zip(&COMPONENTS).filter_map(|(component, [reference, ..])| {
                    of_component(name, component, format!("field {component}"), &[reference])
                }));
            }
            _ => {}
        }
    }
    table
}

/// The row of a component of relative motion, if a kind has these parameters.
fn of_component(name: &str, component: u8, given: String, keys: &[&str]) -> Option<[String; 4]> {
    Kind::all().find(|kind| kind.parameters().any(|(name, _)| name == keys[0]))?;
    let keys = keys.iter().map(|key| format!("`{key}`")).collect::<Vec<_>>().join(", ");
    let unit = if is_rotation(component) { "degrees, in the scene radians" } else { "L" };
    Some([format!("*{name}"), given, keys, unit.into()])
}

/// The unit of a parameter.
fn unit(kind: &str, parameter: &str) -> String {
    let kind = Kind::find(kind, Dimension::Space);
    kind.and_then(|kind| kind.quantity(parameter)).map(|quantity| quantity.unit.to_string()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_parameters_of_predefined_friction_and_of_components_are_those_of_their_kinds() {
        for (kind, parameters) in PREDEFINED {
            let kind = Kind::find(kind, Dimension::Space).unwrap();
            for parameter in parameters {
                assert!(kind.parameters().any(|(name, _)| name == *parameter), "{kind:?} has no {parameter}");
            }
        }
        let table = table();
        let rows = |keyword: &str| table.iter().filter(|[name, ..]| name == keyword).count();
        // l1, theta1 and theta3 exist.
        assert_eq!([rows("*CONNECTOR STOP"), rows("*CONNECTOR CONSTITUTIVE REFERENCE")], [3, 3]);
        assert!(table.iter().all(|row| row[..3].iter().all(|cell| !cell.is_empty())));
    }

    #[test]
    fn keywords_are_found_without_their_blanks_and_not_by_a_part() {
        assert_eq!(Keyword::find("CONNECTORSECTION").map(|keyword| keyword.name), Some("CONNECTOR SECTION"));
        assert!(Keyword::find("CONNECTORSECT").is_none() && Keyword::find("").is_none());
        for (written, meant) in [
            ("CONNECTORSECT", Some("CONNECTOR SECTION")),
            ("ELEM", Some("ELEMENT")),
            ("CONECTORSTOP", Some("CONNECTOR STOP")),
            ("ORIENTATOIN", Some("ORIENTATION")),
            ("INTERFACES", Some("INTERFACE")),
            ("SURFACE", None),
            ("NO", None),
            ("MODE", None),
            ("ELASTIC", None),
            ("CONNECTORLOCK", None),
        ] {
            assert_eq!(Keyword::meant(written), meant, "{written}");
        }
    }
}
