//! Golden files: the cases of a formula with their exact results, to test any code in any language against.
//!
//! Values and Jacobians are computed in 237 bits and rounded once to the nearest double, so that a file has the same
//! bytes on every machine.

mod schema;

use super::subject::Subject;
use super::{Sampler, exact, rounded};
use crate::Error;
use crate::formula::Field;
use crate::proof::{Case, Convention, Flag, Proved};
use crate::quantity::Domain;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use std::fmt;

/// At least this many valid cases a formula.
pub const LEAST_CASES: usize = 32;
/// Of which at least this many drawn at random.
const LEAST_RANDOM: usize = 16;
/// The seed of the random cases.
const SEED: u64 = 0;

/// The golden file of one formula.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Golden file", extend("$id" = "urn:jointproof:golden"))]
pub struct File {
    /// Where the schema of this file is.
    #[schemars(extend("const" = "schema.json"))]
    pub schema: String,
    /// The formula's identifier, which is also the file's name.
    #[schemars(regex(pattern = r"^[a-z][a-z0-9_]*\.[a-z][a-z0-9_]*$"))]
    pub formula: String,
    /// Its title.
    #[schemars(length(min = 1))]
    pub title: String,
    /// The document and section it is from.
    #[schemars(length(min = 1))]
    pub source: String,
    /// The equation.
    #[schemars(length(min = 1))]
    pub latex: String,
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

/// An input or output.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Description {
    /// Its name, by which the cases refer to it.
    #[schemars(regex(pattern = r"^[a-z][a-z0-9_]*$"))]
    pub name: String,
    /// `[]` for a scalar, `[n]` for a column.
    #[schemars(length(max = 1), inner(range(min = 2)))]
    pub shape: Vec<usize>,
    /// Its unit in powers of force F, length L and time T, as `F/L^2`; `1` for none.
    #[schemars(regex(pattern = r"^(1|([FLT](\^[2-9])?)+)(/([FLT](\^[2-9])?)+)?$"))]
    pub unit: String,
}

/// A case: rejected with an error, or answered by `out` and, except on a kink, `jac`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "if" = {"properties": {"flags": {"contains": {"const": "invalid"}}}},
    "then" = {"required": ["error"], "properties": {"out": false, "jac": false}},
    "else" = {
        "required": ["out"],
        "properties": {"error": false},
        "if": {"properties": {"flags": {"not": {"contains": {"const": "kink"}}}}},
        "then": {"required": ["jac"]},
    },
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
    /// The Jacobian `jac[out][in]`, exact at the inputs, rounded once to the nearest double.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "schema::Jacobian", extend("minProperties" = 1))]
    pub jac: Option<Map<String, Value>>,
    /// The kind of error with which the case is rejected.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "String", regex(pattern = r"^[A-Z][A-Za-z]+$"))]
    pub error: Option<String>,
}

/// The golden file of `F`, computed now.
pub fn file<F: Proved>() -> File {
    of(&Subject::of::<F>())
}

fn of(subject: &Subject) -> File {
    let spec = subject.spec;
    File {
        schema: "schema.json".into(),
        formula: spec.id.into(),
        title: spec.title.into(),
        source: spec.source.to_string(),
        latex: spec.latex.into(),
        inputs: describe(subject.inputs),
        outputs: describe(subject.outputs),
        cases: cases(subject).iter().map(|case| record(subject, case)).collect(),
    }
}

fn describe(fields: &[Field]) -> Vec<Description> {
    let description = |field: &Field| Description {
        name: field.name.into(),
        shape: field.quantity.shape.dimensions(),
        unit: field.quantity.unit.to_string(),
    };
    fields.iter().map(description).collect()
}

/// All cases of a formula: its own, random ones, and every way to be invalid.
fn cases(subject: &Subject) -> Vec<Case<Vec<f64>>> {
    let mut cases = (subject.cases)();
    let mut sampler = Sampler::for_formula(subject.spec.id, SEED);
    let random = LEAST_RANDOM.max(LEAST_CASES.saturating_sub(cases.len()));
    cases.extend((1..=random).map(|k| Case::new(Flag::Random, format!("random-{k}"), "", sampler.components(subject))));
    cases.extend(out_of_domain(subject));
    cases.extend((subject.invalid_cases)());
    cases
}

/// Every input in turn not finite, and outside its domain.
fn out_of_domain(subject: &Subject) -> Vec<Case<Vec<f64>>> {
    let valid = Sampler::for_formula(subject.spec.id, SEED).components(subject);
    let mut invalid = Vec::new();
    let mut end = 0;
    for field in subject.inputs {
        end += field.len();
        for (what, value) in bad_values(field.quantity.domain) {
            let mut components = valid.clone();
            components[end - 1] = value;
            invalid.push(Case::invalid(format!("{}-{what}", field.name), "", components));
        }
    }
    invalid
}

fn bad_values(domain: Domain) -> Vec<(&'static str, f64)> {
    let mut bad = vec![("nan", f64::NAN), ("infinite", f64::INFINITY), ("negative-infinite", f64::NEG_INFINITY)];
    match domain {
        Domain::NonNegative => bad.push(("negative", -1.0)),
        Domain::Positive => bad.extend([("zero", 0.0), ("negative", -1.0)]),
        Domain::Between(low, high) => bad.extend([("too-small", low), ("too-large", high)]),
        Domain::HalfOpen(low, high) => bad.extend([("too-small", low.next_down()), ("too-large", high)]),
        Domain::Within(low, high) => bad.extend([("too-small", low.next_down()), ("too-large", high.next_up())]),
        _ => {}
    }
    bad
}

fn record(subject: &Subject, case: &Case<Vec<f64>>) -> Record {
    let mut record = Record {
        id: case.id.clone(),
        flags: vec![case.flag],
        comment: case.comment.into(),
        inputs: named(subject.inputs, &case.inputs),
        out: None,
        jac: None,
        error: None,
    };
    if let Err(error) = (subject.check)(&case.inputs) {
        record.error = Some(error.kind().into());
        return record;
    }
    let exact = exact(&case.inputs);
    let kink = subject.kink(&exact);
    if kink.is_some_and(|convention| convention != Convention::Cut) {
        record.flags.push(Flag::Kink);
    }
    record.out = Some(named(subject.outputs, &rounded(&(subject.exact_value)(&exact))));
    if kink != Some(Convention::Switch) {
        record.jac = Some(named_jacobian(subject, &rounded(&(subject.exact_jacobian)(&exact))));
    }
    record
}

/// `jac[out][in]`.
fn named_jacobian(subject: &Subject, entries: &[f64]) -> Map<String, Value> {
    let columns = subject.inputs.iter().map(Field::len).sum();
    let mut rows = entries.chunks(columns).map(|row| named(subject.inputs, row));
    let mut jacobian = Map::new();
    for output in subject.outputs {
        let rows: Vec<_> = rows.by_ref().take(output.len()).collect();
        let mut by_input = Map::new();
        for input in subject.inputs {
            let of_input = |row: &Map<_, _>| row.get(input.name).cloned().unwrap_or_default();
            let entry = match rows.as_slice() {
                [row] => of_input(row),
                rows => Value::Array(rows.iter().map(of_input).collect()),
            };
            by_input.insert(input.name.into(), entry);
        }
        jacobian.insert(output.name.into(), by_input.into());
    }
    jacobian
}

/// Components by the names of their fields.
pub(crate) fn named(fields: &[Field], components: &[f64]) -> Map<String, Value> {
    let mut rest = components.iter().map(|&x| number(x));
    let mut part = |field: &Field| match field.len() {
        1 => rest.next().unwrap_or_default(),
        len => Value::Array(rest.by_ref().take(len).collect()),
    };
    fields.iter().map(|field| (field.name.to_string(), part(field))).collect()
}

/// The components of inputs that are given by name, as in golden files.
///
/// # Errors
/// [`Error::Unreadable`] naming what is missing, unknown, or not of its shape.
pub fn components(fields: &[Field], inputs: &Map<String, Value>) -> Result<Vec<f64>, Error> {
    if let Some(unknown) = inputs.keys().find(|name| fields.iter().all(|field| field.name != *name)) {
        let names: Vec<_> = fields.iter().map(|field| field.name).collect();
        return Err(Error::Unreadable { name: unknown.clone(), found: "no input".into(), allowed: names.join(", ") });
    }
    let mut components = Vec::new();
    for field in fields {
        let value = inputs.get(field.name).unwrap_or(&Value::Null);
        let part = match (field.len(), value) {
            (1, value) => double(value).map(|x| vec![x]),
            (len, Value::Array(part)) if part.len() == len => part.iter().map(double).collect(),
            _ => None,
        };
        components.extend(part.ok_or_else(|| unreadable(field, value))?);
    }
    Ok(components)
}

fn unreadable(field: &Field, value: &Value) -> Error {
    let allowed = match field.len() {
        1 => "a number".into(),
        len => format!("an array of {len} numbers"),
    };
    let found = if value.is_null() { "missing".into() } else { value.to_string() };
    Error::Unreadable { name: field.name.into(), found, allowed }
}

/// The reverse of [`number`].
fn double(value: &Value) -> Option<f64> {
    match value.as_str() {
        Some("NaN") => Some(f64::NAN),
        Some("Infinity") => Some(f64::INFINITY),
        Some("-Infinity") => Some(f64::NEG_INFINITY),
        _ => value.as_f64(),
    }
}

/// A double, in JSON, which has no NaN and no infinity.
fn number(x: f64) -> Value {
    serde_json::Number::from_f64(x).map_or_else(
        || {
            Value::from(if x.is_nan() {
                "NaN"
            } else if x > 0.0 {
                "Infinity"
            } else {
                "-Infinity"
            })
        },
        Value::Number,
    )
}

impl File {
    /// The text of the file.
    ///
    /// # Errors
    /// None in practice; those of `serde_json` are passed on.
    pub fn render(&self) -> serde_json::Result<String> {
        let mut text = Vec::new();
        let mut serializer = serde_json::Serializer::with_formatter(&mut text, Layout::default());
        self.serialize(&mut serializer)?;
        text.push(b'\n');
        String::from_utf8(text).map_err(serde::ser::Error::custom)
    }

    /// Reads a file.
    ///
    /// # Errors
    /// What is wrong with the text, and where.
    pub fn parse(text: &str) -> serde_json::Result<Self> {
        serde_json::from_str(text)
    }

    /// What differs in `other`, which has been read from the committed file, from this one.
    pub fn differences(&self, other: &Self) -> Vec<Difference> {
        let mut differences = Vec::new();
        for case in &self.cases {
            match other.cases.iter().find(|candidate| candidate.id == case.id) {
                None => differences.push(Difference::new(&case.id, "", "absent", "present")),
                Some(committed) => case.compare(committed, &mut differences),
            }
        }
        for case in &other.cases {
            if !self.cases.iter().any(|candidate| candidate.id == case.id) {
                differences.push(Difference::new(&case.id, "", "present", "absent"));
            }
        }
        differences
    }
}

impl Record {
    fn compare(&self, committed: &Self, differences: &mut Vec<Difference>) {
        let tree = |record: &Self| serde_json::to_value(record).unwrap_or_default();
        compare_values(&self.id, "", &tree(committed), &tree(self), differences);
    }
}

fn compare_values(case: &str, field: &str, committed: &Value, now: &Value, differences: &mut Vec<Difference>) {
    match (committed, now) {
        (Value::Object(committed), Value::Object(now)) => {
            let mut names: Vec<_> = committed.keys().chain(now.keys()).collect();
            names.sort();
            names.dedup();
            for name in names {
                let part = |map: &Map<_, _>| map.get(name).cloned().unwrap_or_default();
                let path = if field.is_empty() { name.clone() } else { format!("{field}.{name}") };
                compare_values(case, &path, &part(committed), &part(now), differences);
            }
        }
        (Value::Array(committed), Value::Array(now)) if committed.len() == now.len() => {
            for (k, (committed, now)) in committed.iter().zip(now).enumerate() {
                compare_values(case, &format!("{field}[{k}]"), committed, now, differences);
            }
        }
        // -0.0 and 0.0 are equal, but not the same text.
        _ if text(committed) == text(now) => {}
        _ => {
            let mut difference = Difference::new(case, field, &text(committed), &text(now));
            difference.ulps = committed.as_f64().zip(now.as_f64()).map(|(a, b)| ulps(a, b));
            differences.push(difference);
        }
    }
}

fn text(value: &Value) -> String {
    value.to_string()
}

/// How many doubles lie between two doubles.
pub fn ulps(a: f64, b: f64) -> u64 {
    let ordered = |x: f64| {
        let magnitude = i128::from(x.abs().to_bits());
        if x.is_sign_negative() { -magnitude } else { magnitude }
    };
    u64::try_from(ordered(a).abs_diff(ordered(b))).unwrap_or(u64::MAX)
}

/// A difference between a committed golden file and what the code says.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Difference {
    /// The case.
    pub case: String,
    /// The field: `out.fc`, `jac.fc.f2`; empty where the whole case differs.
    pub field: String,
    /// What the committed file says.
    pub committed: String,
    /// What the code says.
    pub now: String,
    /// Their distance, for numbers.
    pub ulps: Option<u64>,
}

impl Difference {
    fn new(case: &str, field: &str, committed: &str, now: &str) -> Self {
        let [case, field, committed, now] = [case, field, committed, now].map(String::from);
        Self { case, field, committed, now, ulps: None }
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "case {}", self.case)?;
        if !self.field.is_empty() {
            write!(f, ", {}", self.field)?;
        }
        write!(f, ": committed {}, computed {}", self.committed, self.now)?;
        self.ulps.map_or(Ok(()), |ulps| write!(f, " ({ulps} ulp apart)"))
    }
}

/// Objects are opened down to the fields of a case, everything below stands on one line.
#[derive(Default)]
struct Layout {
    depth: usize,
}

/// Root, list of cases, case, its inputs.
const OPEN: usize = 4;

impl Layout {
    fn line<W: ?Sized + std::io::Write>(&self, writer: &mut W) -> std::io::Result<()> {
        write!(writer, "\n{:1$}", "", 2 * self.depth)
    }

    fn begin<W: ?Sized + std::io::Write>(&mut self, writer: &mut W, bracket: &[u8]) -> std::io::Result<()> {
        self.depth += 1;
        writer.write_all(bracket)
    }

    fn separate<W: ?Sized + std::io::Write>(&self, writer: &mut W, first: bool, open: bool) -> std::io::Result<()> {
        match (open, first) {
            (true, true) => self.line(writer),
            (true, false) => writer.write_all(b",").and_then(|()| self.line(writer)),
            (false, true) => Ok(()),
            (false, false) => writer.write_all(b", "),
        }
    }

    fn end<W: ?Sized + std::io::Write>(&mut self, writer: &mut W, bracket: &[u8], open: bool) -> std::io::Result<()> {
        self.depth -= 1;
        if open {
            self.line(writer)?;
        }
        writer.write_all(bracket)
    }
}

impl serde_json::ser::Formatter for Layout {
    fn begin_array<W: ?Sized + std::io::Write>(&mut self, writer: &mut W) -> std::io::Result<()> {
        self.begin(writer, b"[")
    }
    fn end_array<W: ?Sized + std::io::Write>(&mut self, writer: &mut W) -> std::io::Result<()> {
        let open = self.depth == 2;
        self.end(writer, b"]", open)
    }
    fn begin_array_value<W: ?Sized + std::io::Write>(&mut self, writer: &mut W, first: bool) -> std::io::Result<()> {
        self.separate(writer, first, self.depth == 2)
    }
    fn begin_object<W: ?Sized + std::io::Write>(&mut self, writer: &mut W) -> std::io::Result<()> {
        self.begin(writer, b"{")
    }
    fn end_object<W: ?Sized + std::io::Write>(&mut self, writer: &mut W) -> std::io::Result<()> {
        let open = self.depth <= OPEN;
        self.end(writer, b"}", open)
    }
    fn begin_object_key<W: ?Sized + std::io::Write>(&mut self, writer: &mut W, first: bool) -> std::io::Result<()> {
        self.separate(writer, first, self.depth <= OPEN)
    }
    fn begin_object_value<W: ?Sized + std::io::Write>(&mut self, writer: &mut W) -> std::io::Result<()> {
        writer.write_all(b": ")
    }
}
