//! The file of the certificates of a formula: a line in JSON for the graph, and one for each result and way.

use super::certificate::{Certificate, Programme, check, prove};
use super::field::Rational;
use super::parts::{Part, Rule};
use super::summary::Summary;
use super::way::Answers;
use crate::formula::Field;
use crate::toolkit::graph::{Graph, Node};
use num_traits::Zero;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::ops::Range;

/// The first line of the file: what it is about, and what the others prove.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Head {
    /// The identifier of the formula.
    pub formula: String,
    /// The SHA-256 of the [text](Graph::text) of its graph, in hexadecimal digits.
    pub graph: String,
    /// What is proved of the value.
    pub value: Summary,
    /// What is proved of the Jacobian.
    pub jacobian: Summary,
}

/// Each other line of the file.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(untagged, deny_unknown_fields)]
pub enum Line {
    /// A bound that is proved on one way.
    Proved {
        /// The operation whose result it is.
        result: u32,
        /// The answers of comparisons that make the way, by operation.
        way: Vec<(u32, bool)>,
        /// The other results beside which it is judged, if the bound is normwise.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        beside: Option<Vec<u32>>,
        /// The bound of η, a fraction.
        bound: String,
        /// Whether only the first order is proved, since a difference of rounded numbers is squared, is a divisor or an argument.
        #[serde(default, skip_serializing_if = "std::ops::Not::not")]
        first_order_only: bool,
        /// The rules, each with its amount and with the parts that it names: operation, derivative and place.
        steps: Vec<Vec<Value>>,
    },
    /// A result without proof, and why.
    Open {
        /// The operation whose result it is.
        result: u32,
        /// Why nothing is proved.
        open: String,
    },
}

/// What is proved of the results of a formula.
#[derive(Clone, Debug)]
pub struct Proof {
    /// The certificates of every distinct result in order, or why there is none.
    pub results: BTreeMap<Node, Result<Vec<Certificate>, String>>,
}

impl Proof {
    /// Proves what can be of a formula with these inputs and outputs; `solve` solves the linear programmes.
    pub fn of(graph: &Graph, [inputs, outputs]: [&[Field]; 2], solve: impl Fn(&Programme) -> Option<Vec<f64>>) -> Self {
        let prove = |(node, beside): (Node, Vec<Node>)| (node, prove(graph, inputs, node, &beside, &solve));
        Self { results: results(graph, inputs, outputs).into_iter().map(prove).collect() }
    }

    /// The file.
    pub fn render(&self, graph: &Graph, formula: &str, digest: &str) -> String {
        let [value, jacobian] = self.summaries(graph);
        let head = Head { formula: formula.into(), graph: digest.into(), value, jacobian };
        let mut lines = Vec::new();
        for (node, proved) in &self.results {
            let result = number(*node);
            match proved {
                Ok(certificates) => lines.extend(certificates.iter().map(|certificate| Line::Proved {
                    result,
                    way: certificate.way.iter().map(|(node, answer)| (number(*node), *answer)).collect(),
                    beside: certificate.beside.as_ref().map(|all| all.iter().copied().map(number).collect()),
                    bound: certificate.bound.to_string(),
                    first_order_only: !certificate.is_first_order,
                    steps: certificate.steps.iter().map(|(rule, amount)| written(rule, *amount)).collect(),
                })),
                Err(why) => lines.push(Line::Open { result, open: why.clone() }),
            }
        }
        let line = |line: &Line| serde_json::to_string(line).unwrap_or_default() + "\n";
        serde_json::to_string(&head).unwrap_or_default() + "\n" + &lines.iter().map(line).collect::<String>()
    }

    /// Reads the file about a formula with this graph.
    ///
    /// # Errors
    /// What is wrong with which line; or that it is about another formula or graph.
    pub fn parse(text: &str, graph: &Graph, formula: &str, digest: &str) -> Result<Self, String> {
        let mut results: BTreeMap<Node, Result<Vec<Certificate>, String>> = BTreeMap::new();
        let head = Head::parse(text)?;
        if head.formula != formula || head.graph != digest {
            return Err(format!("line 1: it is about another graph of {}: {}, not {digest}", head.formula, head.graph));
        }
        for (k, text) in text.lines().enumerate().skip(1) {
            let wrong = |why: &str| format!("line {}: {why}", k + 1);
            match serde_json::from_str(text).map_err(|error| wrong(&error.to_string()))? {
                Line::Proved { result, way, beside, bound, first_order_only, steps } => {
                    let steps = steps.iter().map(|step| read(step)).collect::<Option<_>>();
                    let certificate = Certificate {
                        way: way.into_iter().map(|(node, answer)| (node_of(node), answer)).collect::<Answers>(),
                        beside: beside.map(|all| all.into_iter().map(node_of).collect()),
                        bound: bound.parse().map_err(|_| wrong("its bound is no fraction"))?,
                        is_first_order: !first_order_only,
                        steps: steps.ok_or_else(|| wrong("a step is no rule with its amount"))?,
                    };
                    match results.entry(node_of(result)).or_insert_with(|| Ok(Vec::new())) {
                        Ok(certificates) => certificates.push(certificate),
                        Err(_) => return Err(wrong("this result is said to be open")),
                    }
                }
                Line::Open { result, open } => {
                    if results.insert(node_of(result), Err(open)).is_some() {
                        return Err(wrong("this result is said to be proved"));
                    }
                }
            }
        }
        let proof = Self { results };
        if proof.summaries(graph) != [head.value, head.jacobian] {
            return Err("line 1: the other lines say something else".into());
        }
        Ok(proof)
    }

    /// Checks every certificate, and that something is said of every result.
    ///
    /// # Errors
    /// What is wrong with which result.
    pub fn check(&self, graph: &Graph, [inputs, outputs]: [&[Field]; 2]) -> Result<(), String> {
        let expected = results(graph, inputs, outputs);
        if let Some(node) = expected.keys().find(|node| !self.results.contains_key(node)) {
            return Err(format!("nothing is said of result {}", node.index()));
        }
        if let Some(node) = self.results.keys().find(|node| !expected.contains_key(node)) {
            return Err(format!("{} is no result", node.index()));
        }
        for (node, proved) in &self.results {
            let Ok(certificates) = proved else { continue };
            check(graph, inputs, *node, &expected[node], certificates)
                .map_err(|why| format!("result {}: {why}", node.index()))?;
        }
        Ok(())
    }

    /// What is proved of value and Jacobian.
    pub fn summaries(&self, graph: &Graph) -> [Summary; 2] {
        [&graph.value, &graph.jacobian].map(|results| self.summary(results))
    }

    fn summary(&self, results: &[Node]) -> Summary {
        let mut summary = Summary::default();
        for node in results {
            match self.results.get(node) {
                Some(Ok(certificates)) => {
                    let bound = certificates.iter().map(|it| it.bound).max().unwrap_or_default();
                    summary.proved += usize::from(!bound.is_zero());
                    summary.bound = summary.bound.max(bound);
                    summary.first_order_only |= certificates.iter().any(|it| !it.is_first_order);
                    summary.normwise |= certificates.iter().any(|it| it.beside.is_some());
                }
                open => {
                    summary.entries += 1;
                    if summary.why.is_empty() {
                        summary.why = open.map_or("nothing is said of it".into(), |open| open.clone().unwrap_err());
                    }
                }
            }
        }
        summary.entries += summary.proved;
        summary
    }
}

impl Head {
    /// Reads the first line of a file.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn parse(text: &str) -> Result<Self, String> {
        serde_json::from_str(text.lines().next().unwrap_or_default()).map_err(|error| format!("line 1: {error}"))
    }
}

/// The distinct results of a graph, each with those beside it: of a component, the others of the same output; of a derivative, those with
/// respect to the other components of the same input, or where that is a scalar, those of the other components of the same output.
fn results(graph: &Graph, inputs: &[Field], outputs: &[Field]) -> BTreeMap<Node, Vec<Node>> {
    let [of_inputs, of_outputs] = [inputs, outputs].map(|fields| Field::ranges(fields).collect::<Vec<_>>());
    let count = of_inputs.last().map_or(0, |last| last.end);
    let field =
        |fields: &[Range<usize>], k: usize| fields.iter().find(|field| field.contains(&k)).cloned().unwrap_or(k..k + 1);
    let values = (0..graph.value.len()).map(|k| (graph.value[k], graph.value[field(&of_outputs, k)].to_vec()));
    let entries = (0..graph.jacobian.len()).map(|entry| {
        let (output, input) = (entry / count, entry % count);
        let by = field(&of_inputs, input);
        let all: Vec<_> = if by.len() > 1 {
            by.map(|k| output * count + k).collect()
        } else {
            field(&of_outputs, output).map(|k| k * count + input).collect()
        };
        (graph.jacobian[entry], all.into_iter().map(|k| graph.jacobian[k]).collect())
    });
    let mut results: BTreeMap<Node, Vec<Node>> = BTreeMap::new();
    for (node, beside) in values.chain(entries) {
        // What stands at several places is judged at each.
        results.entry(node).and_modify(|known| known.retain(|other| beside.contains(other))).or_insert(beside);
    }
    for (node, beside) in &mut results {
        beside.retain(|other| other != node);
        beside.sort_unstable();
        beside.dedup();
    }
    results
}

fn number(node: Node) -> u32 {
    u32::try_from(node.index()).expect("a node is numbered by 32 bits")
}

fn node_of(number: u32) -> Node {
    Node::at(number as usize)
}

fn written(rule: &Rule, amount: Rational) -> Vec<Value> {
    let part = |Part(node, form, place): &Part| vec![json!(node.index()), json!(form), json!(place)];
    let mut step = vec![json!(""), json!(amount.to_string())];
    step[0] = match rule {
        Rule::Sum(terms) => {
            let term =
                |(factor, named): &(Rational, Part)| [vec![json!(factor.to_string())], part(named)].concat().into();
            step.extend(terms.iter().map(term));
            json!("sum")
        }
        Rule::Parts(node, form) => {
            step.extend([json!(node.index()), json!(form)]);
            json!("parts")
        }
        Rule::Beside(node, form) => {
            step.extend([json!(node.index()), json!(form)]);
            json!("beside")
        }
        Rule::Range(named, other, by) => {
            step.extend([part(named).into(), part(other).into(), json!(by.index())]);
            json!("range")
        }
    };
    step
}

fn read(step: &[Value]) -> Option<(Rule, Rational)> {
    let [name, amount, rest @ ..] = step else { return None };
    // No graph has more operations than 32 bits count.
    let count = |place: &Value| place.as_u64().and_then(|place| u32::try_from(place).ok()).map(|place| place as usize);
    let node = |place: &Value| count(place).map(Node::at);
    let part = |places: &[Value]| match places {
        [of, form, place] => Some(Part(node(of)?, count(form)?, count(place)?)),
        _ => None,
    };
    let term = |term: &Value| {
        let (factor, named) = term.as_array()?.split_first()?;
        Some((factor.as_str()?.parse().ok()?, part(named)?))
    };
    let rule = match (name.as_str()?, rest) {
        ("sum", terms) => Rule::Sum(terms.iter().map(term).collect::<Option<_>>()?),
        ("parts", [of, form]) => Rule::Parts(node(of)?, count(form)?),
        ("beside", [of, form]) => Rule::Beside(node(of)?, count(form)?),
        ("range", [named, other, by]) => Rule::Range(part(named.as_array()?)?, part(other.as_array()?)?, node(by)?),
        _ => return None,
    };
    Some((rule, amount.as_str()?.parse().ok()?))
}
