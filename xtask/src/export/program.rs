//! The body of a function: the statements of a graph in a language.

use super::language::Language;
use jointproof::formula::Field;
use jointproof::graph::{Graph, Node, Op, Statement};

/// What is printed, and the temporaries in it.
#[derive(Default)]
pub(super) struct Lines {
    pub(super) text: Vec<String>,
    pub(super) numbers: Vec<String>,
    pub(super) answers: Vec<String>,
}

/// A function's body for some results of a graph.
pub(super) struct Body<'a> {
    pub(super) language: &'a dyn Language,
    pub(super) graph: &'a Graph,
    pub(super) inputs: &'static [Field],
}

impl Body<'_> {
    /// The lines that compute these results, from an indentation on.
    pub(super) fn lines(&self, results: &[Node], indent: usize) -> Lines {
        let mut printed = Printed { body: self, lines: Lines::default() };
        printed.block(&self.graph.statements(results), indent);
        printed.lines
    }

    /// How a result is called where it is used.
    pub(super) fn text(&self, node: Node) -> String {
        match self.graph.op(node) {
            Op::Input(k) => self.input(*k),
            Op::Number(bits) => self.language.number(f64::from_bits(*bits)),
            _ => self.name(node),
        }
    }

    fn input(&self, mut k: usize) -> String {
        for field in self.inputs {
            if k < field.len() {
                return self.language.argument(field, k);
            }
            k -= field.len();
        }
        unreachable!("a graph has the inputs of its formula")
    }

    fn name(&self, node: Node) -> String {
        let letter = if self.graph.is_answer(node) { 'c' } else { 't' };
        format!("{letter}{}", node.index())
    }
}

struct Printed<'a> {
    body: &'a Body<'a>,
    lines: Lines,
}

impl Printed<'_> {
    fn block(&mut self, statements: &[Statement], indent: usize) {
        for statement in statements {
            match statement {
                Statement::Compute(node) => self.compute(*node, indent),
                Statement::Choose { condition, results, yes, no } => {
                    self.choose(*condition, results, [yes, no], indent);
                }
            }
        }
    }

    fn compute(&mut self, node: Node, indent: usize) {
        let Body { language, graph, .. } = *self.body;
        let value = language.operation(graph.op(node), &|operand| self.body.text(operand));
        let name = self.named(node);
        let is_answer = graph.is_answer(node);
        self.line(indent, &language.set(&name, is_answer, &value));
    }

    fn choose(&mut self, condition: Node, results: &[[Node; 3]], sides: [&[Statement]; 2], indent: usize) {
        let (language, names) = (self.body.language, results.iter().map(|&[select, ..]| self.named(select)));
        let names: Vec<_> = names.collect();
        for announced in names.iter().filter_map(|name| language.announce(name)) {
            self.line(indent, &announced);
        }
        let [head, between, end] = language.choose(&self.body.text(condition));
        for (head, statements, side) in [(head, sides[0], 1), (between, sides[1], 2)] {
            self.line(indent, &head);
            self.block(statements, indent + 1);
            for (name, result) in names.iter().zip(results) {
                self.line(indent + 1, &language.assign(name, &self.body.text(result[side])));
            }
        }
        self.line(indent, &end);
    }

    fn named(&mut self, node: Node) -> String {
        let name = self.body.name(node);
        let names = if self.body.graph.is_answer(node) { &mut self.lines.answers } else { &mut self.lines.numbers };
        names.push(name.clone());
        name
    }

    fn line(&mut self, indent: usize, text: &str) {
        let indent = "    ".repeat(indent);
        let lines = text.lines().flat_map(|line| folded(&format!("{indent}{line}"), self.body.language.goes_on()));
        self.lines.text.extend(lines);
    }
}

/// No line is longer than this.
const WIDTH: usize = 100;

/// A line that is too long, broken between arguments.
fn folded(line: &str, goes_on: &str) -> Vec<String> {
    let room = WIDTH - goes_on.len();
    match line.get(..room).and_then(|start| start.rfind(", ")).filter(|_| line.len() > WIDTH) {
        None => vec![line.to_owned()],
        Some(comma) => {
            let indent = line.len() - line.trim_start().len() + 4;
            let rest = format!("{}{}", " ".repeat(indent), &line[comma + 2..]);
            [vec![format!("{},{goes_on}", &line[..comma])], folded(&rest, goes_on)].concat()
        }
    }
}
