//! Words for operations of a formula, and for its branches.

use super::model::{Scope, Textbook};
use super::sample::Sample;
use super::wording::expression;
use jointproof::catalog::AnyFormula;
use jointproof::formula::Field;
use jointproof::toolkit::graph::{Node, Op, Relation};
use std::collections::BTreeMap;

/// A formula with its names.
pub(super) struct Words<'a> {
    book: &'a Textbook,
    inputs: &'static [Field],
    samples: &'a [Sample],
    /// The field of every component of the inputs.
    fields: Vec<usize>,
    /// What operations have in common that differ in components, in axes, or in both.
    keys: [BTreeMap<Node, String>; 3],
}

/// What operations may differ in to be of a family.
#[derive(Clone, Copy, PartialEq)]
enum Family {
    Components,
    Axes,
    Both,
}

/// A text for every operation that is the same within a family.
fn keys(book: &Textbook, inputs: &[Field], fields: &[usize], of: Family) -> BTreeMap<Node, String> {
    let mut keys: BTreeMap<Node, String> = BTreeMap::new();
    for &node in &book.needed {
        let key = match book.graph.op(node) {
            Op::Input(k) => {
                let (field, component) =
                    (inputs[fields[*k]], k - fields.iter().position(|f| *f == fields[*k]).unwrap_or(0));
                let name = if of == Family::Components {
                    field.name.to_owned()
                } else {
                    // e1a, e3b: e#; x1, xn, xm: x#.
                    let letters: String = field.name.chars().filter(|c| !c.is_ascii_digit()).collect();
                    let stem = letters.strip_suffix(['a', 'b']).filter(|_| letters.len() < field.name.len());
                    format!("{}#", stem.unwrap_or(&letters))
                };
                if of == Family::Axes { format!("{name}[{component}]") } else { name }
            }
            Op::Number(bits) => format!("{}", f64::from_bits(*bits).abs()),
            op => {
                let kind = format!("{op:?}");
                let kind: String = kind.split("Node").next().unwrap_or_default().chars().take(24).collect();
                let parts = op.operands().iter().map(|node| keys[node].as_str()).collect::<Vec<_>>().join(",");
                // Long keys are told apart by a hash.
                let text = format!("{kind}{parts})");
                if text.len() < 60 { text } else { format!("{:x}", hash(&text)) }
            }
        };
        keys.insert(node, key);
    }
    keys
}

impl<'a> Words<'a> {
    pub(super) fn new(formula: &dyn AnyFormula, book: &'a Textbook, samples: &'a [Sample]) -> Self {
        let inputs = formula.inputs();
        let fields: Vec<usize> =
            inputs.iter().enumerate().flat_map(|(k, field)| std::iter::repeat_n(k, field.len())).collect();
        let key = |of: Family| keys(book, inputs, &fields, of);
        let keys = [Family::Components, Family::Axes, Family::Both].map(key);
        Self { book, inputs, samples, fields, keys }
    }

    /// An operation in words.
    pub(super) fn name(&self, node: Node) -> String {
        expression(&self.book.graph, self.inputs, node)
    }

    /// Operations that differ in components or axes alone, as those of a vector do.
    pub(super) fn families(&self) -> Vec<Vec<Node>> {
        let mut families: Vec<Vec<Node>> = Vec::new();
        for keys in &self.keys {
            let mut groups: BTreeMap<&str, Vec<Node>> = BTreeMap::new();
            for (&node, key) in keys {
                let op = self.book.graph.op(node);
                if !matches!(op, Op::Input(_) | Op::Number(_) | Op::Compare(..)) {
                    groups.entry(key).or_default().push(node);
                }
            }
            let groups = groups.into_values().filter(|nodes| (2..=24).contains(&nodes.len()));
            for group in groups {
                if !families.contains(&group) {
                    families.push(group);
                }
            }
        }
        families
    }

    /// The same operand of every operation of a family, instead of which another input may be taken: the words, and what is
    /// taken in each.
    pub(super) fn other_fields(&self, family: &[Node]) -> Vec<(String, usize, Vec<Node>)> {
        let graph = &self.book.graph;
        let input = |node: Node| if let Op::Input(k) = graph.op(node) { Some(*k) } else { None };
        let count = graph.op(family[0]).operands().len();
        let mut others = Vec::new();
        let start = |field: usize| self.fields.iter().position(|f| *f == field).unwrap_or(0);
        let node_of = |k: usize| self.book.needed.iter().copied().find(|node| *graph.op(*node) == Op::Input(k));
        for k in 0..count {
            let own: Option<Vec<usize>> = family.iter().map(|node| input(graph.op(*node).operands()[k])).collect();
            let Some(own) = own else { continue };
            let field = self.fields[own[0]];
            let places: Vec<usize> = own.iter().map(|k| k - start(self.fields[*k])).collect();
            if own.iter().all(|k| self.fields[*k] == field) {
                // Another vector.
                for (other, alike) in self.inputs.iter().enumerate() {
                    let mine = self.inputs[field];
                    if other == field || alike.quantity.unit != mine.quantity.unit || alike.len() != mine.len() {
                        continue;
                    }
                    let nodes: Option<Vec<Node>> = places.iter().map(|place| node_of(start(other) + place)).collect();
                    if let Some(nodes) = nodes {
                        others.push((format!("{} for {}", alike.name, mine.name), k, nodes));
                    }
                }
            }
            if places.iter().all(|place| *place == places[0]) {
                // Another component.
                for other in (0..self.inputs[field].len()).filter(|other| *other != places[0]) {
                    let component = |k: &usize| node_of(start(self.fields[*k]) + other);
                    let nodes: Option<Vec<Node>> = own.iter().map(component).collect();
                    if let Some(nodes) = nodes {
                        let name = self.inputs[field].name;
                        others.push((format!("the component [{other}] for [{}] of {name}", places[0]), k, nodes));
                    }
                }
            }
        }
        others
    }

    /// Operands of an operation that may be mistaken for others, by their indices: of the same field, or alike.
    pub(super) fn others(&self, place: Node) -> Vec<(usize, Node)> {
        let op = self.book.graph.op(place);
        if matches!(
            op,
            Op::Input(_) | Op::Number(_) | Op::Select(..) | Op::Compare(..) | Op::ExactSum(_) | Op::Search(..)
        ) {
            return Vec::new();
        }
        let mut others = Vec::new();
        for (k, operand) in op.operands().into_iter().enumerate() {
            let is_alike = |other: &Node| match (self.book.graph.op(operand), self.book.graph.op(*other)) {
                (Op::Input(own), Op::Input(other)) => {
                    let [own, other] = [self.fields[*own], self.fields[*other]];
                    let [mine, others] = [self.inputs[own], self.inputs[other]];
                    own == other || mine.quantity.unit == others.quantity.unit && mine.len() == others.len()
                }
                (Op::Number(_) | Op::Input(_), _) | (_, Op::Number(_) | Op::Input(_)) => false,
                _ => self.keys[2][&operand] == self.keys[2][other],
            };
            let alike = self.book.needed.iter().filter(|other| **other != operand && is_alike(other));
            others.extend(alike.map(|other| (k, *other)));
            // A function that is left out at one of its uses.
            let users = self.book.needed.iter().filter(|user| self.book.graph.op(**user).operands().contains(&operand));
            if users.count() > 1 {
                let mut within = self.book.graph.op(operand).operands();
                within.dedup();
                let is_number = |node: &Node| self.book.graph.constant(*node).is_none();
                others.extend(within.into_iter().filter(is_number).map(|within| (k, within)));
            }
        }
        others
    }

    /// Pairs of results that may be exchanged: inputs are exchanged elsewhere.
    pub(super) fn pairs(&self) -> Vec<(Node, Node)> {
        let mut groups: BTreeMap<&str, Vec<Node>> = BTreeMap::new();
        for (&node, key) in &self.keys[2] {
            if !matches!(self.book.graph.op(node), Op::Input(_) | Op::Number(_) | Op::Compare(..) | Op::Select(..)) {
                groups.entry(key).or_default().push(node);
            }
        }
        let few = groups.into_values().filter(|group| (2..=6).contains(&group.len()));
        few.flat_map(|group| {
            let pairs = group.iter().enumerate().flat_map(|(k, a)| group[k + 1..].iter().map(|b| (*a, *b)));
            pairs.collect::<Vec<_>>()
        })
        .collect()
    }

    /// The number whose sign this operation chooses by.
    pub(super) fn sign_of(&self, place: Node) -> Option<Node> {
        let graph = &self.book.graph;
        let Op::Select(condition, yes, no) = *graph.op(place) else { return None };
        let is_sign = |node: Node| {
            graph.constant(node).is_some_and(|x| x.abs() <= 1.0) || matches!(graph.op(node), Op::Select(..))
        };
        let Op::Compare(Relation::Less | Relation::LessOrEqual, x, y) = *graph.op(condition) else { return None };
        let zero = |node: Node| graph.constant(node) == Some(0.0);
        if !is_sign(yes) || !is_sign(no) {
            return None;
        }
        if zero(x) {
            Some(y)
        } else if zero(y) {
            Some(x)
        } else {
            None
        }
    }

    /// The side of a comparison in words: stick and slip, if friction decides.
    pub(super) fn side(&self, comparison: Node, holds: bool) -> String {
        if let Some(sticks) = self.sticks(comparison) {
            return if sticks == holds { "stick" } else { "slip" }.to_owned();
        }
        let condition = self.name(comparison);
        if condition.contains(" if ") || condition.contains('…') || condition.len() > 40 {
            return if holds { "one branch" } else { "the other branch" }.to_owned();
        }
        if holds { condition } else { format!("not {condition}") }
    }

    /// The outcome of a comparison when friction is large, if it depends on friction.
    fn sticks(&self, comparison: Node) -> Option<bool> {
        let mu = self.inputs.iter().position(|field| field.name == "mu")?;
        let place = self.fields.iter().position(|field| *field == mu)?;
        let depends =
            self.book.graph.needed(&[comparison]).iter().any(|node| *self.book.graph.op(*node) == Op::Input(place));
        let with = |factor: f64| {
            let outcome = |sample: &Sample| {
                let mut inputs = sample.inputs.clone();
                inputs[place] = factor;
                self.book.holds(comparison, &inputs)
            };
            self.samples.iter().take(24).filter(|sample| outcome(sample)).count()
        };
        let [none, much] = [with(0.0), with(1e12)];
        (depends && none != much).then_some(much > none)
    }

    /// A sentence with the names of an operation and its operands.
    pub(super) fn fill(&self, template: &str, place: Node, scope: Scope, is_value_alone: bool) -> String {
        let op = self.book.graph.op(place);
        if let Op::Compare(..) = op {
            let [yes, no] = [true, false].map(|holds| self.side(place, holds));
            let [from, into] = if template.contains("{+}") { [yes, no] } else { [no, yes] };
            let what = match scope {
                Scope::Jacobian => " tangent",
                Scope::Value => " value",
                Scope::All | Scope::Used => "",
            };
            return if template.contains("{?}") {
                format!("the branches {from} and {into} are exchanged{what}")
            } else if from == "stick" || into == "stick" {
                format!("{from}{what} in {into}")
            } else {
                format!("one branch for all{what}: {from}, also where {into}")
            };
        }
        let mut text = template.replace("{}", &self.name(place));
        for (k, operand) in op.operands().into_iter().enumerate() {
            let name = format!("{{{k}}}");
            if text.contains(&name) {
                text = text.replace(&name, &self.name(operand));
            }
        }
        match scope {
            Scope::Value if !is_value_alone => format!("value: {text}"),
            Scope::Jacobian => format!("Jacobian: {text}"),
            _ => text,
        }
    }
}

/// FNV-1a.
fn hash(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}
