//! The content of a golden file, and its text.

use super::layout::render;
use super::schema;
use crate::formula;
use crate::formula::proof::Flag;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

/// The version of the layout of golden files.
pub const LAYOUT: u32 = 2;
/// The least number of valid cases per formula.
pub const LEAST_CASES: usize = 32;

/// The golden file of one formula.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Golden file", extend("$id" = "urn:jointproof:golden"), extend(
    "if" = {"properties": {"eta": {"required": ["jacobian"]}}},
    "then" = {"properties": {"cases": {"items": {
        "if": {"properties": {"flags": {"not": {"contains": {"enum": ["kink", "invalid"]}}}}},
        "then": {"required": ["jac"]},
    }}}},
    "else" = {"properties": {"cases": {"items": {"properties": {"jac": false, "jac_scale": false}}}}},
))]
pub struct File {
    /// Where the schema of this file is.
    #[schemars(extend("const" = "schema.json"))]
    pub schema: String,
    /// The version of this layout.
    #[schemars(extend("const" = LAYOUT))]
    pub layout: u32,
    /// The formula's identifier, which is also the file's name.
    #[schemars(regex(pattern = r"^[a-z][a-z0-9_]*\.[a-z][a-z0-9_]*$"))]
    pub formula: String,
    /// Its title.
    #[schemars(length(min = 1))]
    pub title: String,
    /// The document and section it is from.
    #[schemars(length(min = 1))]
    pub source: String,
    /// How much of the equation is printed there.
    pub provenance: Provenance,
    /// The equation.
    #[schemars(length(min = 1))]
    pub latex: String,
    /// The bounds of the backward error η that the implementation in Rust keeps on these cases and many more. What is proved of them is
    /// said by the file of the same name in the folder `bounds`.
    pub eta: Bounds,
    /// What goes in.
    #[schemars(length(min = 1))]
    pub inputs: Vec<Description>,
    /// What comes out.
    #[schemars(length(min = 1))]
    pub outputs: Vec<Description>,
    /// The cases.
    #[schemars(length(min = LEAST_CASES))]
    pub cases: Vec<Record>,
}

/// How much of an equation its document prints.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "if" = {"properties": {"kind": {"const": "printed"}}},
    "then" = {"properties": {"why": false}},
    "else" = {"required": ["why"]},
))]
pub struct Provenance {
    /// `printed`; `reconstructed`, where symbols were lost; or `ours`.
    #[schemars(extend("enum" = ["printed", "reconstructed", "ours"]))]
    pub kind: String,
    /// What was lost, or why it is ours.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[schemars(length(min = 1))]
    pub why: String,
}

impl From<formula::Provenance> for Provenance {
    fn from(provenance: formula::Provenance) -> Self {
        Self { kind: provenance.kind().into(), why: provenance.why().into() }
    }
}

/// Bounds of the backward error η = |ŷ − y| / (u · scale + half the smallest subnormal), u = 2⁻⁵³.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bounds {
    /// Of every output.
    #[schemars(range(min = 0))]
    pub value: f64,
    /// Of every entry of the Jacobian; absent where the Jacobian is automatic, and cases have none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "f64", range(min = 0))]
    pub jacobian: Option<f64>,
}

/// An input or output.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Description {
    /// Its name, by which the cases refer to it.
    #[schemars(regex(pattern = r"^[a-z][a-z0-9_]*$"))]
    pub name: String,
    /// `[]` for a scalar, `[n]` for a column, `[n, m]` for a matrix of n rows.
    #[schemars(length(max = 2), inner(range(min = 2)))]
    pub shape: Vec<usize>,
    /// Its unit in powers of force F, length L, time T and temperature Θ, as `F/L^2`; `1` for none.
    #[schemars(regex(pattern = r"^(1|([FLTΘ](\^[2-9])?)+)(/([FLTΘ](\^[2-9])?)+)?$"))]
    pub unit: String,
}

/// A case: rejected with an error, or answered by `out` and, where the Jacobian is in closed form and except on a kink, `jac`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "if" = {"properties": {"flags": {"contains": {"const": "invalid"}}}},
    "then" = {
        "required": ["error"],
        "properties": {"out": false, "out_scale": false, "jac": false, "jac_scale": false},
    },
    "else" = {
        "required": ["out", "out_scale"],
        "properties": {"error": false},
    },
    "dependentRequired" = {"jac": ["jac_scale"], "jac_scale": ["jac"]},
))]
pub struct Record {
    /// Identifier, unique within the file.
    #[schemars(regex(pattern = r"^\S+$"))]
    pub id: String,
    /// What the case is for.
    #[schemars(length(min = 1), extend("uniqueItems" = true))]
    pub flags: Vec<Flag>,
    /// What is to be seen in it.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[schemars(length(min = 1))]
    pub comment: String,
    /// The inputs by name: exact doubles, or "NaN", "Infinity", "-Infinity".
    #[serde(rename = "in")]
    #[schemars(with = "schema::Inputs", extend("minProperties" = 1))]
    pub inputs: Map<String, Value>,
    /// The outputs by name: exact at the inputs, rounded once to the nearest double.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "schema::Outputs", extend("minProperties" = 1))]
    pub out: Option<Map<String, Value>>,
    /// The scale of every output y, Σᵢ |∂y/∂xᵢ · xᵢ| + |y| over all inputs, rounded up to four digits.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "schema::OutputScales", extend("minProperties" = 1))]
    pub out_scale: Option<Map<String, Value>>,
    /// The Jacobian `jac[out][in]`, exact at the inputs, rounded once to the nearest double.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "schema::Jacobian", extend("minProperties" = 1))]
    pub jac: Option<Map<String, Value>>,
    /// The scale of every entry J of the Jacobian, Σᵢ |∂J/∂xᵢ · xᵢ| + |J|, in the same way.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "schema::JacobianScales", extend("minProperties" = 1))]
    pub jac_scale: Option<Map<String, Value>>,
    /// The kind of error with which the case is rejected.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "String", regex(pattern = r"^[A-Z][A-Za-z]+$"))]
    pub error: Option<String>,
}

impl File {
    /// The text of the file.
    ///
    /// # Errors
    /// None in practice; those of `serde_json` are passed on.
    pub fn render(&self) -> serde_json::Result<String> {
        render(self)
    }

    /// Reads a file.
    ///
    /// # Errors
    /// The fault in the text and its position; also another version of the layout.
    pub fn parse(text: &str) -> serde_json::Result<Self> {
        let file: Self = serde_json::from_str(text)?;
        match file.layout {
            LAYOUT => Ok(file),
            other => Err(serde::de::Error::custom(format_args!("layout {other}; this version reads layout {LAYOUT}"))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::connector::slot::ContactForce;
    use crate::toolkit::verify::golden;

    #[test]
    fn a_file_ends_with_a_line_and_reads_back() {
        let file = golden::of(&crate::toolkit::verify::Subject::of::<ContactForce>(), golden::LEAST_RANDOM);
        let text = file.render().unwrap();
        assert!(text.starts_with("{\n  \"schema\": \"schema.json\",\n") && text.ends_with("\n}\n"));
        assert_eq!(File::parse(&text).unwrap(), file);
        let other = text.replace(&format!("\"layout\": {LAYOUT}"), "\"layout\": 7");
        assert_eq!(File::parse(&other).unwrap_err().to_string(), "layout 7; this version reads layout 2");
        assert!(File::parse(&text.replace("\"title\"", "\"name\"")).is_err());
    }

    #[test]
    fn provenance_has_its_reason() {
        let of = |provenance: formula::Provenance| serde_json::to_string(&Provenance::from(provenance)).unwrap();
        assert_eq!(of(crate::formula::Provenance::Printed), "{\"kind\":\"printed\"}");
        let ours = of(crate::formula::Provenance::Ours("no page has it"));
        assert_eq!(ours, "{\"kind\":\"ours\",\"why\":\"no page has it\"}");
    }
}
