//! Functions: the statements of a graph, written in a language.

use super::language::Syntax;
use super::outline::{Lengths, Outline, Part, Step};
use super::recorded::{Function, Recorded, stem};
use super::repeated::{Place, Repeated};
use jointproof::formula::Field;
use jointproof::toolkit::graph::{Graph, Node, Op};
use std::collections::{BTreeSet, HashMap};

/// A language in which functions can be written.
pub(super) trait Functions: Syntax {
    /// A function that checks its inputs, computes, and assigns its results.
    fn function(&self, one: &Recorded, body: &Body, lines: &Lines, function: &Function) -> String;

    /// A part of functions, which only these call.
    fn part(&self, stem: &str, part: &PartLines) -> String;
}

/// The largest number of lines of a function.
const LONGEST: usize = 400;

/// The functions of a formula or an element, each after the parts that it is split into if it is too long.
pub(super) fn functions_of(language: &impl Functions, one: &Recorded) -> Vec<String> {
    let limits = [usize::MAX, 100, 60, 30, 15, 5];
    let mut functions = Vec::new();
    for limit in limits {
        functions = functions_within(limit, language, one);
        if functions.iter().all(|text| text.lines().count() <= LONGEST) {
            break;
        }
    }
    functions
}

/// The same with about `limit` lines of statements in a function that is not a part.
pub(super) fn functions_within(limit: usize, language: &impl Functions, one: &Recorded) -> Vec<String> {
    let stem = stem(one);
    let body = Body::of(language, one, &stem);
    let (mut texts, mut count) = (Vec::new(), 0);
    for function in one.functions() {
        let (lines, parts) = body.program(&one.results(&function), limit, count + 1);
        count += parts.len();
        texts.extend(parts.iter().map(|part| language.part(&stem, part)));
        texts.push(language.function(one, &body, &lines, &function));
    }
    texts
}

/// The body of a function for some results of a graph.
pub(super) struct Body<'a> {
    pub(super) language: &'a dyn Syntax,
    pub(super) graph: &'a Graph,
    pub(super) inputs: &'static [Field],
    /// Results with descriptive names.
    pub(super) names: &'a HashMap<Node, String>,
    /// What is written once, and called for every slave node.
    pub(super) repeated: Option<&'a Repeated>,
    /// The name of the formula.
    pub(super) stem: &'a str,
}

/// A function in printed form.
#[derive(Default)]
pub(super) struct Lines {
    pub(super) text: Vec<String>,
    /// Its temporaries.
    pub(super) numbers: Vec<String>,
    pub(super) answers: Vec<String>,
    /// The results of parts: the name of an array, and its length.
    pub(super) arrays: Vec<(String, usize)>,
    /// The names of results of other functions.
    called: HashMap<Node, String>,
}

/// A part of a function.
pub(super) struct PartLines {
    pub(super) number: usize,
    /// The inputs that it takes.
    pub(super) inputs: Vec<&'static Field>,
    /// The number of results passed to it, and the number it returns.
    pub(super) given: usize,
    pub(super) found: usize,
    pub(super) lines: Lines,
}

impl<'a> Body<'a> {
    pub(super) fn of(language: &'a dyn Syntax, one: &'a Recorded, stem: &'a str) -> Self {
        let Recorded { graph, names, repeated, .. } = one;
        Self { language, graph, inputs: one.inputs(), names, repeated: repeated.as_ref(), stem }
    }

    /// The lines that compute these results, indented, about as many as the limit allows, and the parts, numbered from
    /// `first`.
    pub(super) fn program(&self, results: &[Node], limit: usize, first: usize) -> (Lines, Vec<PartLines>) {
        let lengths = Lengths { main: limit, part: self.language.lines_of_part() };
        let outline = Outline::new(self.graph, self.repeated, results, lengths);
        let parts = outline.parts.iter().enumerate().map(|(k, part)| self.part(&outline, first, (k, part))).collect();
        let mut main = Printed { body: self, outline: &outline, first, lines: Lines::default() };
        main.block(&outline.main, 1);
        (main.lines, parts)
    }

    fn part(&self, outline: &Outline, first: usize, (k, part): (usize, &Part)) -> PartLines {
        let mut printed = Printed { body: self, outline, first, lines: Lines::default() };
        for (k, &node) in part.given.iter().enumerate() {
            let text = self.language.element("given", k, self.graph.is_answer(node));
            printed.lines.called.insert(node, text);
        }
        // Where all names are declared at the head, what it gives has no other name.
        if self.language.announce("", false).is_none() {
            for (k, &node) in part.found.iter().enumerate().filter(|(_, node)| !self.graph.is_answer(**node)) {
                printed.lines.called.insert(node, self.language.element("found", k, false));
            }
        }
        printed.block(&part.steps, 1);
        for (k, &node) in part.found.iter().enumerate() {
            let place = self.language.element("found", k, false);
            if printed.lines.called.get(&node) == Some(&place) {
                continue;
            }
            let text = self.language.as_number(&self.text(&printed.lines, node), self.graph.is_answer(node));
            printed.line(1, &self.language.assign(&place, &text));
        }
        let inputs = self.inputs_of(outline, part);
        PartLines { number: first + k, inputs, given: part.given.len(), found: part.found.len(), lines: printed.lines }
    }

    /// The inputs that a part needs.
    fn inputs_of(&self, outline: &Outline, part: &Part) -> Vec<&'static Field> {
        let mut used = BTreeSet::new();
        let mut note = |node: Node| {
            if let (Op::Input(k), Err(_)) = (self.graph.op(node), part.given.binary_search(&node)) {
                used.insert(*k);
            }
        };
        outline.walk(&part.steps, &mut note, &mut |_| ());
        let mut from = 0;
        let is_used = |field: &&Field| {
            from += field.len();
            used.range(from - field.len()..from).next().is_some()
        };
        self.inputs.iter().filter(is_used).collect()
    }

    /// The field passed for another one at a slave node.
    fn passed(&self, field: &'static Field, at: Option<&Place>) -> &'static Field {
        let from = |other: &Field| self.inputs.iter().take_while(|one| one.name != other.name).map(Field::len).sum();
        let place: usize = from(field);
        let place = at.map_or(place, |at| at.inputs[place]);
        self.inputs.iter().find(|other| from(other) == place).unwrap_or(field)
    }

    /// The text of a result where it is used.
    pub(super) fn text(&self, lines: &Lines, node: Node) -> String {
        match (lines.called.get(&node), self.graph.op(node)) {
            (Some(called), _) => called.clone(),
            (None, Op::Input(k)) => self.input(*k),
            (None, Op::Number(bits)) => self.language.number(f64::from_bits(*bits)),
            (None, _) => self.name(node),
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
        self.names.get(&node).cloned().unwrap_or_else(|| format!("{letter}{}", node.index()))
    }
}

struct Printed<'a> {
    body: &'a Body<'a>,
    outline: &'a Outline<'a>,
    first: usize,
    lines: Lines,
}

impl Printed<'_> {
    fn block(&mut self, steps: &[Step], indent: usize) {
        for step in steps {
            match step {
                Step::Compute(node) => self.compute(*node, indent),
                Step::Choose { condition, results, yes, no } => {
                    self.choose(*condition, results, [yes, no], indent);
                }
                Step::Call(part) => self.call(*part, None, indent),
                Step::Repeat { part, slave } => self.call(*part, Some(*slave), indent),
            }
        }
    }

    fn text(&self, node: Node) -> String {
        self.body.text(&self.lines, node)
    }

    fn compute(&mut self, node: Node, indent: usize) {
        let Body { language, graph, .. } = *self.body;
        let (name, is_answer) = (self.named(node), graph.is_answer(node));
        let statement = language.statement(&name, is_answer, graph.op(node), &|operand| self.text(operand));
        self.line(indent, &statement);
    }

    fn choose(&mut self, condition: Node, results: &[[Node; 3]], sides: [&[Step]; 2], indent: usize) {
        let language = self.body.language;
        let names: Vec<_> = results.iter().map(|&[select, ..]| self.named(select)).collect();
        for (name, &[select, ..]) in names.iter().zip(results) {
            if let Some(announced) = language.announce(name, self.body.graph.is_answer(select)) {
                self.line(indent, &announced);
            }
        }
        let [head, between, end] = language.choose(&self.text(condition));
        for (head, steps, side) in [(head, sides[0], 1), (between, sides[1], 2)] {
            self.line(indent, &head);
            self.block(steps, indent + 1);
            for (name, result) in names.iter().zip(results) {
                self.line(indent + 1, &language.assign(name, &self.text(result[side])));
            }
        }
        self.line(indent, &end);
    }

    /// The call of a part, for a slave node if it is the part that all of them share.
    fn call(&mut self, part: usize, slave: Option<usize>, indent: usize) {
        let Body { language, graph, repeated, .. } = *self.body;
        let called = &self.outline.parts[part];
        let at = slave.and_then(|slave| repeated?.at.get(slave));
        let here = |nodes: &[Node]| nodes.iter().map(|node| at.map_or(*node, |at| at.nodes[node])).collect::<Vec<_>>();
        let [given, found] = [here(&called.given), here(&called.found)];
        let number = self.first + part;
        let array = slave.map_or(format!("part_{number}"), |slave| format!("part_{number}_{}", slave + 1));
        let given: Vec<_> =
            given.iter().map(|&node| language.as_number(&self.text(node), graph.is_answer(node))).collect();
        let inputs = self.body.inputs_of(self.outline, called);
        let inputs: Vec<_> = inputs.iter().map(|&field| [field, self.body.passed(field, at)]).collect();
        let call = language.call(self.body.stem, number, &inputs, &given, (&array, found.len()));
        self.line(indent, &call);
        for (k, &node) in found.iter().enumerate() {
            self.lines.called.insert(node, language.element(&array, k, graph.is_answer(node)));
        }
        self.lines.arrays.push((array, found.len()));
    }

    fn named(&mut self, node: Node) -> String {
        if let Some(place) = self.lines.called.get(&node) {
            return place.clone();
        }
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

/// The largest length of a line; a continuation mark may follow.
pub(super) const WIDTH: usize = 98;

/// A long line, broken between arguments, or before the first of them where the name alone is long; indented less where even that does
/// not fit.
pub(super) fn folded(line: &str, goes_on: &str) -> Vec<String> {
    let mut indent = line.len() - line.trim_start().len();
    let (mut lines, mut rest) = (Vec::new(), line.to_owned());
    while rest.chars().count() > WIDTH {
        let start = rest.get(..WIDTH - goes_on.len()).unwrap_or_default();
        if let Some(end) = start.rfind(", ").or_else(|| start.rfind('(')).map(|place| place + 1) {
            lines.push(format!("{}{goes_on}", &rest[..end]));
            rest = format!("{}{}", " ".repeat(indent + 4), rest[end..].trim_start());
        } else if indent > 0 {
            let inner = rest.len() - rest.trim_start().len() - indent;
            indent /= 2;
            rest = format!("{}{}", " ".repeat(indent + inner), rest.trim_start());
        } else {
            break;
        }
    }
    lines.push(rest);
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_broken_at_the_last_comma_that_leaves_room_for_the_sign() {
        let call = |first: usize| format!("  call({}, {}, c);", "a".repeat(first), "b".repeat(40));
        // 98 characters, and one more.
        let [most, more] = [44, 45].map(call);
        assert_eq!((most.len(), folded(&most, "")), (WIDTH, vec![most.clone()]));
        let rest = |text: &str| format!("      {text}");
        assert_eq!(folded(&more, ""), [more.replace(", c);", ","), rest("c);")]);
        // A comma at the limit, and with a continuation mark.
        let edge = |first: usize| format!("  call({}, {});", "a".repeat(first), "b".repeat(40));
        for (first, sign, breaks) in [(89, "", 2), (90, "", 3), (88, " &", 3), (87, " &", 2)] {
            let lines = folded(&edge(first), sign);
            assert_eq!(lines.len(), breaks, "{lines:#?}");
            let (name, [a, b]) =
                ("  call(", [format!("{},{sign}", "a".repeat(first)), format!("{});", "b".repeat(40))]);
            let after_name =
                if breaks == 2 { vec![format!("{name}{a}")] } else { vec![format!("{name}{sign}"), rest(&a)] };
            assert_eq!(lines, [after_name, vec![rest(&b)]].concat());
        }
        let named = format!("{}{}([{}]);", " ".repeat(40), "f".repeat(50), vec!["argument"; 20].join(", "));
        let lines = folded(&named, " &");
        assert!(lines[0].ends_with("f( &") && lines.iter().all(|line| line.len() <= WIDTH + 1), "{lines:#?}");
        let deep = format!("{}{}", " ".repeat(60), named.trim_start());
        let lines = folded(&deep, " &");
        assert!(
            lines[0].trim_start().starts_with('f') && lines.iter().all(|line| line.len() <= WIDTH + 1),
            "{lines:#?}"
        );
        let uninterrupted = "x".repeat(200);
        assert_eq!(folded(&uninterrupted, " &"), std::slice::from_ref(&uninterrupted));
        // As often as needed.
        let long = format!("f({});", vec!["argument"; 60].join(", "));
        let lines = folded(&long, " &");
        assert!(lines.len() > 5 && lines.iter().all(|line| line.len() <= WIDTH + 1), "{lines:#?}");
        assert!(lines[1..].iter().all(|line| line.starts_with("    argument")), "{lines:#?}");
        assert_eq!(lines.concat().replace(", &    ", ", "), long);
    }
}
