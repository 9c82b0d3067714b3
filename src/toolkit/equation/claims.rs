//! Mathematical claims in prose, outside the equation of an entry.

use super::cursor::Vocabulary;
use super::error::Error;
use super::lower::{Beside, Place, Writer};
use super::name::Name;
use super::scope::{Entries, Entry, Taken};
use super::statement::{apart, chains, relations, statements, symbols};
use super::syntax::{Body, Expr, Kind, Relation, Statement};
use super::value::{Value, compare};
use super::{named, named_by, rounding};
use crate::formula::{Field, Spec};
use crate::number::octuple::Octuple;
use crate::toolkit::graph::{Graph, Node, Op};

/// A formula as prose refers to it: its symbols, and the definitions in its equation.
#[derive(Clone, Copy, Debug)]
pub struct Signature {
    /// Its specification.
    pub spec: Spec,
    /// Its inputs.
    pub inputs: &'static [Field],
    /// Its outputs.
    pub outputs: &'static [Field],
}

/// The context of mathematics in prose.
#[derive(Clone, Debug, Default)]
pub struct Setting {
    /// The formula whose symbols these are; its outputs are computed by the code.
    pub of: Option<Signature>,
    /// Symbols of other entries, separated by commas, and the entries they come from.
    pub from: Vec<(String, Spec)>,
    /// Definitions that the prose gives in words.
    pub definitions: String,
    /// The conditions under which it holds, separated by commas.
    pub condition: String,
    /// Symbols that stand for arbitrary numbers or vectors, separated by commas.
    pub free: String,
    /// Whether only inputs and outputs of the formula are known, and not the other definitions of its equation.
    pub is_closed: bool,
    /// Whether symbols that the equation takes from other entries, directly or indirectly, are known too if the
    /// entries agree on them.
    pub is_deep: bool,
    /// Whether triads are made orthonormal first, because the claims hold only for those.
    pub triads: bool,
    /// Earlier displays, whose definitions apply here too.
    pub above: Vec<String>,
    /// Values substituted for inputs of the formula: `L_a = 20,\ R_p = 1`.
    pub put: String,
    /// For what somebody else has written, as LaTeX or as plain text: symbols that stand for inputs and outputs.
    pub renamed: Option<Vec<(String, String)>>,
}

/// Claims that can be checked at points.
#[derive(Clone, Debug)]
pub struct Claims {
    graph: Graph,
    all: Vec<Claimed>,
    condition: Option<Node>,
    /// Components of inputs and the nodes substituted for them.
    put: Vec<(usize, Node)>,
    inputs: usize,
    outputs: usize,
    free: Vec<Free>,
    pub(crate) triads: bool,
    /// Whether points at which a side is infinite are left out.
    pub(crate) is_partial: bool,
}

/// An arbitrary number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Free {
    /// Of either sign: a component of a vector, a change.
    Signed,
    /// Above 0.
    Positive,
}

/// Two sides and their relation.
#[derive(Clone, Debug)]
struct Claimed {
    left: Node,
    right: Node,
    /// Whether the claim is an equality.
    is_equality: bool,
    /// The truth value of the claim.
    holds: Node,
    /// The two sides as written.
    text: String,
}

impl Claimed {
    fn new(graph: &mut Graph, left: Node, relation: Relation, right: Node, text: String) -> Self {
        let holds = compare(graph, relation, left, right);
        Self { left, right, is_equality: relation == Relation::Equal, holds, text }
    }
}

/// A claim at a point.
pub(crate) struct ClaimAt<'c> {
    pub(crate) left: Octuple,
    pub(crate) right: Octuple,
    /// Whether the claim is an equality; otherwise `holds` is its truth value.
    pub(crate) is_equality: bool,
    pub(crate) holds: bool,
    pub(crate) text: &'c str,
    sides: [Node; 2],
}

impl Claims {
    /// Reads the claims. A statement that defines a new symbol is no claim.
    ///
    /// # Errors
    /// If it cannot be read, or claims nothing.
    pub fn read(latex: &str, setting: &Setting) -> Result<Self, Error> {
        let claims = Self::compiled(latex, setting)?;
        let is_empty = claims.all.is_empty();
        if is_empty { Err(Error::new(0, "nothing is claimed: all of it defines new symbols")) } else { Ok(claims) }
    }

    /// Reads an expression, to be evaluated at points.
    ///
    /// # Errors
    /// If it cannot be read.
    pub fn expression(latex: &str, setting: &Setting) -> Result<Self, Error> {
        Self::compiled(&format!("0 = {latex}"), setting)
    }

    fn compiled(latex: &str, setting: &Setting) -> Result<Self, Error> {
        let mut known = Known::new(setting)?;
        let mut entries = Entries::default();
        entries.0.push(Entry { id: "prose", statements: Vec::new(), given: Vec::new() });
        let mut given = known.given(setting, &mut entries)?;
        let functions = || given.iter().filter(|taken| !taken.parameters.is_empty()).map(|taken| taken.name.clone());
        let mut all =
            statements(&setting.definitions, functions().collect()).map_err(|e| e.of_entry("words", "definition"))?;
        let mut claimed = Vec::new();
        for text in setting.above.iter().map(String::as_str).chain([latex]) {
            let declared = all.iter().filter(|s| !s.parameters.is_empty()).map(|s| s.names[0].clone());
            claimed.clear();
            let declared = functions().chain(declared).collect();
            let read = if setting.renamed.is_some() {
                relations(text, declared, &Vocabulary::of(&[&known.inputs[..], &known.outputs[..]].concat()))
            } else {
                chains(text, declared)
            };
            for statement in read? {
                let is_defined = |name: &Name| all.iter().any(|statement| statement.names.contains(name));
                let is_given = |name: &Name| known.has(name) || given.iter().any(|taken| taken.name == *name);
                // A written variation of a field is compared with the field's change rather than taken as a definition.
                let is_change = |name: &Name| match name.unchanged() {
                    Some(of) => !name.is_variation() || known.has(&of),
                    None => !name.change.is_empty(),
                };
                match definition(&statement, |name| is_defined(name) || is_given(name) || is_change(name)) {
                    Some(definition) => all.extend(apart(definition)),
                    None => claimed.push(statement),
                }
            }
        }
        given.retain(|taken| !all.iter().any(|statement| statement.names[0] == taken.name));
        known.let_change(all.iter().chain(&claimed));
        entries.0[0] = Entry { id: "prose", statements: all, given };
        known.claims(&entries, &claimed, setting, latex)
    }

    /// The arbitrary numbers.
    pub(crate) fn free(&self) -> &[Free] {
        &self.free
    }

    /// The inputs of the formula after substitution.
    pub(crate) fn inputs(&self, inputs: &[Octuple], free: &[Octuple]) -> Vec<Octuple> {
        if self.put.is_empty() {
            return inputs.to_vec();
        }
        let all = self.results(&self.point(inputs, None, free));
        let mut inputs = inputs.to_vec();
        for &(component, id) in &self.put {
            inputs[component] = all[id.index()];
        }
        inputs
    }

    /// All numbers from which the claims are computed.
    pub(crate) fn point(&self, inputs: &[Octuple], code: Option<[&[Octuple]; 2]>, free: &[Octuple]) -> Vec<Octuple> {
        let nothing = vec![Octuple::NAN; self.outputs * (self.inputs + 1)];
        let [values, jacobian] = code.unwrap_or_else(|| [&nothing[..self.outputs], &nothing[self.outputs..]]);
        [inputs, values, jacobian, free].concat()
    }

    /// The claims at a point; none where their condition does not hold.
    pub(crate) fn at(&self, point: &[Octuple]) -> Vec<ClaimAt<'_>> {
        let all = self.results(point);
        if self.condition.is_some_and(|condition| all[condition.index()] != 1.0) {
            return Vec::new();
        }
        let at = self.all.iter().map(|claim| {
            let [left, right] = [claim.left, claim.right].map(|side| all[side.index()]);
            ClaimAt {
                left,
                right,
                is_equality: claim.is_equality,
                holds: all[claim.holds.index()] == 1.0,
                text: &claim.text,
                sides: [claim.left, claim.right],
            }
        });
        at.collect()
    }

    /// The values of all nodes at a point.
    fn results(&self, point: &[Octuple]) -> Vec<Octuple> {
        let holds = self.all.iter().map(|claim| claim.holds);
        let put = self.put.iter().map(|&(_, node)| node);
        let results: Vec<_> = holds.chain(self.condition).chain(put).collect();
        self.graph.results(point, self.graph.needed(&results))
    }

    /// The sizes of the terms from which both sides of a claim are summed; `sizes` are those of the point itself.
    pub(crate) fn terms(&self, claim: &ClaimAt<'_>, point: &[Octuple], sizes: &[Octuple]) -> Octuple {
        let [left, right] = claim.sides.map(|side| rounding::terms(&self.graph, side, point, sizes));
        left + right
    }

    /// The value of an [`expression`](Self::expression) at a point.
    pub(crate) fn number(&self, point: &[Octuple]) -> Octuple {
        let value = self.all.first().map(|claim| self.results(point)[claim.right.index()]);
        value.unwrap_or(Octuple::NAN)
    }
}

/// The symbols that prose need not define.
struct Known {
    inputs: Vec<(Name, Field)>,
    outputs: Vec<(Name, Field)>,
    free: Vec<Name>,
    /// The changes of the symbols that vary.
    changing: Vec<Name>,
}

impl Known {
    fn new(setting: &Setting) -> Result<Self, Error> {
        let renamed = setting.renamed.iter().flatten().map(|(symbol, name)| (symbol.as_str(), name.as_str()));
        let renamed: Vec<_> = renamed.collect();
        let fields = |fields: Option<&[Field]>| named_by(&renamed, fields.unwrap_or_default());
        let listed = if setting.free.is_empty() { Vec::new() } else { symbols(&setting.free)? };
        Ok(Self {
            inputs: fields(setting.of.map(|of| of.inputs))?,
            outputs: fields(setting.of.map(|of| of.outputs))?,
            free: listed.into_iter().map(|(name, _)| name).collect(),
            changing: Vec::new(),
        })
    }

    fn has(&self, name: &Name) -> bool {
        let fields = self.inputs.iter().chain(&self.outputs).map(|(name, _)| name);
        fields.chain(&self.free).any(|known| known == name || name.component().is_some_and(|(of, _)| of == *known))
    }

    /// The symbols that the formula's equation defines, and those that it or the setting takes from elsewhere.
    fn given(&self, setting: &Setting, entries: &mut Entries) -> Result<Vec<Taken>, Error> {
        let mut given: Vec<Taken> = Vec::new();
        for (listed, spec) in &setting.from {
            let from = entries.add_spec(spec)?;
            let listed = symbols(listed).map_err(|error| error.of_entry(spec.id, "where"))?;
            given.extend(listed.into_iter().map(|(name, parameters)| Taken { name, parameters, from }));
        }
        if let Some(of) = setting.of.filter(|_| !setting.is_closed) {
            let from = entries.add_spec(&of.spec)?;
            let entry = &entries.0[from];
            let own = entry.statements.iter().map(|s| (s.names[0].clone(), s.parameters.clone()));
            let others = entry.given.iter().map(|taken| (taken.name.clone(), taken.parameters.clone()));
            for (name, parameters) in own.chain(others) {
                let is_output = parameters.is_empty() && self.has(&name);
                if !is_output && !given.iter().any(|taken| taken.name == name) {
                    given.push(Taken { name, parameters, from });
                }
            }
        }
        if setting.is_deep {
            for (from, entry) in entries.0.iter().enumerate() {
                for statement in &entry.statements {
                    let (name, parameters) = (statement.names[0].clone(), statement.parameters.clone());
                    if !self.has(&name) && !given.iter().any(|taken| taken.name == name) {
                        given.push(Taken { name, parameters, from });
                    }
                }
            }
        }
        Ok(given)
    }

    /// If a change is written, all inputs change, and so do arbitrary numbers that appear with `\mathrm{d}`.
    fn let_change<'s>(&mut self, statements: impl Iterator<Item = &'s Statement>) {
        let mut names = Vec::new();
        statements.flat_map(Statement::expressions).for_each(|e| collect_changes(e, &mut names));
        if names.is_empty() {
            return;
        }
        let is_variation = names.iter().any(Name::is_variation);
        let inputs = self.inputs.iter().map(|(name, _)| name).filter(|name| is_variation || name.change.is_empty());
        let is_written = |of: &&Name| names.iter().any(|name| name.base == of.base && name.below == of.below);
        let changing = inputs.chain(self.free.iter().filter(is_written)).cloned();
        self.changing =
            changing.map(|name| if is_variation { name.varied() } else { Name { change: "d", ..name } }).collect();
    }

    /// Writes the operations of all claims.
    fn claims(
        &self,
        entries: &Entries,
        claimed: &[Statement],
        setting: &Setting,
        latex: &str,
    ) -> Result<Claims, Error> {
        let mut writer = Writer::new(entries, &self.inputs);
        if let (Some(_), Some(of)) = (&setting.renamed, setting.of) {
            writer.be_lenient(&named(of.inputs)?);
        }
        let inputs = writer.solution;
        let (mut next, mut free) = (inputs, Vec::new());
        let mut take = |writer: &mut Writer<'_>, count: usize| -> Vec<Node> {
            next += count;
            (next - count..next).map(|k| writer.graph.enter(Op::Input(k))).collect()
        };
        let mut values = Vec::new();
        for (name, field) in &self.outputs {
            let parts = take(&mut writer, field.len());
            values.extend(parts.iter().copied());
            writer.inputs.push((name.clone(), value(parts)));
        }
        let rows: Vec<_> = values.iter().map(|&id| (id, take(&mut writer, inputs))).collect();
        let outputs = rows.len();
        for name in &self.free {
            let parts = take(&mut writer, if name.bold { 3 } else { 1 });
            let kind = if name.bold || !name.change.is_empty() { Free::Signed } else { Free::Positive };
            free.extend(parts.iter().map(|_| kind));
            writer.inputs.push((name.clone(), value(parts)));
        }
        let mut changes = Vec::new();
        for change in &self.changing {
            let name = change.unchanged();
            let known = writer.inputs.iter().find(|(known, _)| Some(known) == name.as_ref());
            let of = known.map(|(_, value)| parts(value.clone())).unwrap_or_default();
            let own = writer.inputs.iter().find(|(known, _)| known == change).map(|(_, value)| value.clone());
            let by = own.map_or_else(
                || {
                    free.extend(of.iter().map(|_| Free::Signed));
                    take(&mut writer, of.len())
                },
                parts,
            );
            changes.extend(of.into_iter().zip(by.iter().copied()));
            writer.inputs.push((change.clone(), value(by)));
        }
        writer.beside = Beside { outputs: rows, changes };
        let put = put(&mut writer, &self.inputs, setting)?;
        let condition = condition(&mut writer, &setting.condition)?;
        let mut all = Vec::new();
        for statement in claimed {
            all.extend(sides(&mut writer, statement, latex)?);
        }
        // Definitions that nothing refers to may also have two forms.
        for statement in &entries.0[0].statements {
            let name = &statement.names[0];
            let is_whole = statement.parameters.iter().all(|p| writer.symbol(p, statement.at, Place::ROOT).is_ok());
            if is_whole {
                writer.symbol(name, statement.at, Place::ROOT)?;
            }
        }
        for (left, right) in std::mem::take(&mut writer.equal) {
            let text = "two forms of a definition".into();
            all.push(Claimed::new(&mut writer.graph, left, Relation::Equal, right, text));
        }
        let triads = setting.triads;
        let is_partial = setting.renamed.is_some();
        Ok(Claims { graph: writer.graph, all, condition, put, inputs, outputs, free, triads, is_partial })
    }
}

fn value(mut parts: Vec<Node>) -> Value {
    match parts.len() {
        1 => Value::Scalar(parts.swap_remove(0)),
        4 | 9 => Value::Matrix(parts),
        _ => Value::Vector(parts),
    }
}

fn parts(value: Value) -> Vec<Node> {
    match value {
        Value::Scalar(id) => vec![id],
        Value::Vector(parts) | Value::Matrix(parts) => parts,
        Value::Normal | Value::Zero => Vec::new(),
    }
}

fn collect_changes(e: &Expr, names: &mut Vec<Name>) {
    if let Kind::Symbol(name) = &e.kind
        && name.unchanged().is_some()
    {
        names.push(name.clone());
    }
    if let Kind::Sum { index, from, to, body } = &e.kind {
        return (*from..=*to).for_each(|k| collect_changes(&body.with_index(index, k), names));
    }
    e.parts().into_iter().for_each(|part| collect_changes(part, names));
}

/// The chain as a definition, if its first side is new: a symbol, a function of symbols, or a tuple of symbols.
fn definition(statement: &Statement, is_known: impl Fn(&Name) -> bool) -> Option<Statement> {
    let Body::Chain(first, rest) = &statement.body else { return None };
    let symbol = |e: &Expr| match &e.kind {
        Kind::Symbol(name) if !is_known(name) => Some(name.clone()),
        _ => None,
    };
    let (names, parameters) = match &first.kind {
        Kind::Apply(name, arguments) if !is_known(name) => {
            let parameter = |e: &Expr| if let Kind::Symbol(name) = &e.kind { Some(name.clone()) } else { None };
            (vec![name.clone()], arguments.iter().map(parameter).collect::<Option<Vec<_>>>()?)
        }
        Kind::Tuple(items) => (items.iter().map(symbol).collect::<Option<Vec<_>>>()?, Vec::new()),
        _ => (vec![symbol(first)?], Vec::new()),
    };
    let is_equal = !rest.is_empty() && rest.iter().all(|(relation, _)| *relation == Relation::Equal);
    let sides = rest.iter().map(|(_, side)| side.clone()).collect();
    is_equal.then_some(Statement { names, parameters, body: Body::Equal(sides), at: statement.at })
}

/// Both sides of every relation, component by component.
fn sides(writer: &mut Writer<'_>, statement: &Statement, latex: &str) -> Result<Vec<Claimed>, Error> {
    let Body::Chain(first, rest) = &statement.body else { return Ok(Vec::new()) };
    let end = |k: usize| rest.get(k + 1).map_or(latex.len(), |(_, next)| next.at);
    let (mut all, mut left, mut from) = (Vec::new(), writer.expression(first, Place::ROOT)?, first.at);
    for (k, (relation, side)) in rest.iter().enumerate() {
        let right = writer.expression(side, Place::ROOT)?;
        let text = latex.get(from..end(k)).unwrap_or_default().split(r"\quad").next().unwrap_or_default();
        let text = text.trim().trim_end_matches(['=', ',']).trim_end().to_owned();
        let zero = writer.graph.number(0.0);
        let pairs: Vec<_> = match (left, right.clone()) {
            (Value::Scalar(a), Value::Scalar(b)) => vec![(a, b)],
            (Value::Vector(a), Value::Vector(b)) | (Value::Matrix(a), Value::Matrix(b))
                if a.len() == b.len() && *relation == Relation::Equal =>
            {
                a.into_iter().zip(b).collect()
            }
            (Value::Vector(a), Value::Scalar(b)) if b == zero && *relation == Relation::Equal => {
                a.into_iter().map(|a| (a, zero)).collect()
            }
            (Value::Vector(a), Value::Zero) if *relation == Relation::Equal => {
                a.into_iter().map(|a| (a, zero)).collect()
            }
            _ => return Err(Error::new(side.at, "the two sides have not the same shape")),
        };
        let claimed = |(left, right)| Claimed::new(&mut writer.graph, left, *relation, right, text.clone());
        all.extend(pairs.into_iter().map(claimed));
        (left, from) = (right, side.at);
    }
    Ok(all)
}

/// A node that is 1 if all conditions hold.
fn condition(writer: &mut Writer<'_>, latex: &str) -> Result<Option<Node>, Error> {
    let mut all = None;
    for statement in chains(latex, Vec::new()).map_err(|error| error.of_entry("words", "condition"))? {
        for Claimed { holds, .. } in sides(writer, &statement, latex)? {
            all = Some(all.map_or(holds, |all| writer.graph.enter(Op::both(all, holds))));
        }
    }
    Ok(all)
}

/// Components of inputs and the nodes substituted for them.
fn put(writer: &mut Writer<'_>, inputs: &[(Name, Field)], setting: &Setting) -> Result<Vec<(usize, Node)>, Error> {
    let mut all = Vec::new();
    for statement in statements(&setting.put, Vec::new()).map_err(|error| error.of_entry("words", "input"))? {
        let Body::Equal(sides) = &statement.body else { continue };
        let mut first = 0;
        let place = inputs.iter().find_map(|(name, field)| {
            first += field.len();
            (*name == statement.names[0]).then(|| first - field.len()..first)
        });
        let place = place.ok_or_else(|| Error::new(statement.at, format!("{} is no input", statement.names[0])))?;
        let parts = parts(writer.expression(&sides[0], Place::ROOT)?);
        if parts.len() != place.len() {
            return Err(Error::new(statement.at, format!("{} has {} components", statement.names[0], place.len())));
        }
        all.extend(place.zip(parts));
    }
    Ok(all)
}

#[cfg(test)]
mod tests;
