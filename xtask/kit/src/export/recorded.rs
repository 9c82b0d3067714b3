//! A formula or an element to be exported, and its parts common to all languages: names, description, and the inputs it rejects.

use super::element;
use super::names;
use super::repeated::Repeated;
use super::subject::placed;
pub(super) use super::subject::{Function, Output, Shape, Subject};
use crate::files;
use crate::project::Project;
use jointproof::Error;
use jointproof::formula::Field;
use jointproof::toolkit::graph::{Graph, Node, NotRecorded};
use rayon::iter::{Either, IntoParallelRefIterator, ParallelIterator};
use std::collections::HashMap;
use std::path::Path;

/// What can be exported, with its operations.
pub(super) struct Recorded {
    pub(super) subject: Subject,
    pub(super) graph: Graph,
    /// Temporaries that are results of other formulas, by the names they have there.
    pub(super) names: HashMap<Node, String>,
    /// What is done alike at each slave node of an element.
    pub(super) repeated: Option<Repeated>,
    /// The SHA-256 of the golden file, where there is one.
    checksum: Option<String>,
    /// Its bounds of η in words.
    accuracy: String,
}

/// The graphs of formulas and elements, and those without one. The golden files of a project are identified by their checksums.
pub(super) fn record(subjects: &[Subject], project: Option<&Project>) -> (Vec<Recorded>, Vec<(Subject, NotRecorded)>) {
    let of = |&subject: &Subject| match subject.graph() {
        Ok(graph) => Either::Left((subject, graph)),
        Err(why) => Either::Right((subject, why)),
    };
    let (known, refused): (Vec<_>, Vec<_>) = subjects.par_iter().partition_map(of);
    let names: Vec<_> = known.iter().map(|one| names::of(one, &known)).collect();
    let recorded = known.into_iter().zip(names).map(|((subject, graph), names)| {
        let checksum = project.and_then(|project| checksum(&project.golden().join(subject.golden()?)));
        let repeated = match subject {
            Subject::Formula(_) => None,
            Subject::Element(element, rubs) => Repeated::of(&graph, &element.layout(), element.inputs(rubs)),
        };
        Recorded { subject, graph, names, repeated, checksum, accuracy: subject.accuracy(project) }
    });
    (recorded.collect(), refused)
}

fn checksum(path: &Path) -> Option<String> {
    std::fs::read(path).ok().map(files::digest)
}

impl Recorded {
    pub(super) fn inputs(&self) -> &'static [Field] {
        self.subject.inputs()
    }

    /// The functions that are printed; the last one has all results. A formula has one for its value, and one for the Jacobian if
    /// that is in closed form.
    pub(super) fn functions(&self) -> Vec<Function> {
        let formula = match self.subject {
            Subject::Formula(formula) => formula,
            Subject::Element(element, rubs) => {
                return vec![Function { name: "step", outputs: element::outputs(&element.layout(), rubs) }];
            }
        };
        let shape = |field: &Field| match field.len() {
            1 => Shape::Number,
            len => Shape::Vector(len),
        };
        let shapes = formula.outputs().iter().map(|field| (field.name, shape(field)));
        let jacobian = ("jacobian", Shape::Matrix(self.graph.value.len(), self.row()));
        let value = Function { name: "value", outputs: placed(shapes.clone()) };
        let with_jacobian = Function { name: "jacobian", outputs: placed(shapes.chain([jacobian])) };
        let with_jacobian = formula.spec().is_closed().then_some(with_jacobian);
        [value].into_iter().chain(with_jacobian).collect()
    }

    /// The function with all results.
    pub(super) fn largest_function(&self) -> Function {
        self.functions().pop().expect("there is a function")
    }

    /// The nodes of an output.
    pub(super) fn nodes(&self, output: &Output) -> &[Node] {
        let Graph { value, jacobian, .. } = &self.graph;
        match output.first.checked_sub(value.len()) {
            Some(first) => &jacobian[first..first + output.len()],
            None => &value[output.first..output.first + output.len()],
        }
    }

    /// The results of a function, starting with the rejection of inputs.
    pub(super) fn results(&self, function: &Function) -> Vec<Node> {
        let outputs = function.outputs.iter().flat_map(|output| self.nodes(output));
        self.graph.refusal.iter().chain(outputs).copied().collect()
    }

    /// The number of components of the inputs: that of the entries in a row of the Jacobian.
    pub(super) fn row(&self) -> usize {
        self.inputs().iter().map(Field::len).sum()
    }

    /// The rows of a matrix that are written, each with its position; the rest are all zeros.
    pub(super) fn rows(&self, output: &Output) -> Vec<(usize, &[Node])> {
        let Shape::Matrix(_, columns) = output.shape else { return vec![(0, self.nodes(output))] };
        let rows = self.nodes(output).chunks(columns).enumerate();
        rows.filter(|(_, row)| !row.iter().all(|&entry| self.is_zero(entry))).collect()
    }

    /// The places in an output that are always 0, and the others with their nodes.
    pub(super) fn entries(&self, output: &Output) -> (Vec<usize>, Vec<(usize, Node)>) {
        let entries = self.nodes(output).iter().copied().enumerate();
        let (zeros, others): (Vec<_>, Vec<_>) = entries.partition(|&(_, entry)| self.is_zero(entry));
        (zeros.into_iter().map(|(k, _)| k).collect(), others)
    }

    fn is_zero(&self, node: Node) -> bool {
        self.graph.constant(node).is_some_and(|x| x.to_bits() == 0)
    }
}

/// The meanings of the return codes that reject inputs, one line each.
pub(super) fn refusals(one: &Recorded) -> Vec<String> {
    let lines = required(one).into_iter().enumerate();
    lines.flat_map(|(k, what)| wrapped(&format!("{} unless {what}", k + 1))).collect()
}

/// What is required, by the return codes that reject inputs.
pub(super) fn required(one: &Recorded) -> Vec<String> {
    let alone = one.inputs().iter().map(|field| format!("{}: {}", field.name, field.quantity.domain.allowed()));
    alone.chain(one.graph.refusals.iter().map(Error::required)).collect()
}

/// The name of a formula or an element in the names of functions and files.
pub(super) fn stem(one: &Recorded) -> String {
    one.subject.stem()
}

/// The comment at the head of a file, line by line.
pub(super) fn description(one: &Recorded) -> Vec<String> {
    let (spec, subject, golden) = (one.subject.spec(), one.subject, one.subject.golden());
    let mut lines = match subject {
        Subject::Formula(_) => vec![format!("{}: {}", spec.id, spec.title)],
        Subject::Element(_, rubs) => {
            vec![format!("{}, {} friction", spec.title, if rubs { "with" } else { "without" })]
        }
    };
    lines.push(format!("{}; {}", spec.source, spec.source.provenance));
    lines.push(String::new());
    match subject {
        Subject::Formula(formula) => {
            lines.extend([spec.latex.to_owned(), String::new()]);
            lines.extend(formula.inputs().iter().map(|field| described("in ", field)));
            lines.extend(formula.outputs().iter().map(|field| described("out", field)));
        }
        Subject::Element(element, rubs) => {
            lines.extend(element.inputs(rubs).iter().map(|field| described("in ", field)));
            lines.extend(element::described(&element.layout(), rubs));
            lines.extend(element.form().remarks().into_iter().map(str::to_owned));
        }
    }
    lines.push(String::new());
    // Compilers of Fortran ask for ASCII.
    let accuracy = one.accuracy.replace('η', "eta").replace('≤', "<=");
    lines.push(match golden {
        Some(_) => format!("{accuracy}; in units of 2^-53, where inputs are 0 or {} in size", spec.sizes()),
        None => accuracy,
    });
    if let Subject::Formula(formula) = subject {
        lines.extend(formula.kinks().iter().map(|kink| format!("kink: {}", kink.condition)));
    }
    let version = env!("CARGO_PKG_VERSION");
    lines.extend(golden.map(|path| format!("Golden cases: golden/{path} of jointproof {version}")));
    lines.extend(one.checksum.iter().map(|checksum| format!("SHA-256 {checksum}")));
    lines.push("Printed by jointproof; free of conditions (CC0-1.0).".into());
    lines.iter().flat_map(|line| wrapped(line)).collect()
}

pub(super) fn described(role: &str, field: &Field) -> String {
    let shape = match field.len() {
        1 => String::new(),
        len => format!("({len})"),
    };
    format!("{role} {}{shape} [{}] {}", field.name, field.quantity.unit, field.quantity.meaning)
}

/// Wraps a text at spaces into lines of at most 90 characters; an empty text is an empty line.
pub(super) fn wrapped(text: &str) -> Vec<String> {
    let lines = filled(text.split_whitespace(), 90);
    if lines.is_empty() { vec![String::new()] } else { lines }
}

/// Joins short texts into lines of at most this many characters.
pub(super) fn filled(texts: impl Iterator<Item = impl AsRef<str>>, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for text in texts {
        let text = text.as_ref();
        match lines.last_mut() {
            Some(last) if last.chars().count() + 1 + text.chars().count() <= width => *last = format!("{last} {text}"),
            _ => lines.push(text.to_owned()),
        }
    }
    lines
}

/// A name that is no reserved word of the language.
pub(super) fn unreserved(name: &str, reserved: &[&str]) -> String {
    if reserved.contains(&name) { format!("{name}_") } else { name.to_owned() }
}

/// A text that grows.
pub(super) struct Text(String);

impl Text {
    pub(super) fn push(&mut self, text: impl AsRef<str>) {
        self.0.push_str(text.as_ref());
    }

    pub(super) fn push_all(&mut self, texts: impl IntoIterator<Item = impl AsRef<str>>) {
        for text in texts {
            self.push(text);
        }
    }

    pub(super) fn finished(self) -> String {
        self.0
    }
}

impl<S: Into<String>> From<S> for Text {
    fn from(text: S) -> Self {
        Self(text.into())
    }
}

/// Formulas of these identifiers.
#[cfg(test)]
pub(super) fn formulas(ids: &[&str]) -> Vec<Recorded> {
    let formula = |id: &&str| Subject::Formula(jointproof::catalog::find(id).expect("a formula is named"));
    let (recorded, refused) = record(&ids.iter().map(formula).collect::<Vec<_>>(), None);
    assert!(refused.is_empty());
    recorded
}

/// An element without friction, and with friction if it can have any.
#[cfg(test)]
pub(super) fn element_of(id: &str) -> Vec<Recorded> {
    let element = jointproof::catalog::ELEMENTS.iter().find(|element| element.spec().id == id);
    record(&Subject::forms(*element.expect("an element is named")), None).0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_filled_to_its_width_and_no_further() {
        assert_eq!(filled(["aa", "bb", "cc"].into_iter(), 5), ["aa bb", "cc"]);
        assert_eq!(filled(["aa", "bb", "cc"].into_iter(), 4), ["aa", "bb", "cc"]);
        assert_eq!(filled(["ää", "bb", "much too long"].into_iter(), 5), ["ää bb", "much too long"]);
        assert_eq!(filled(std::iter::empty::<&str>(), 5), [""; 0]);
    }

    #[test]
    fn texts_are_broken_at_spaces_where_a_line_would_have_more_than_90_characters() {
        let [most, more] = [45, 46].map(|length| format!("{}  {}", "a".repeat(44), "b".repeat(length)));
        assert_eq!(wrapped(&most), [most.replace("  ", " ")]);
        assert_eq!(wrapped(&more), ["a".repeat(44), "b".repeat(46)]);
        assert_eq!(wrapped(""), [""]);
    }

    #[test]
    fn what_is_always_0_is_told_from_other_entries_and_rows() {
        let one = &formulas(&["slider.eliminate"])[0];
        let jacobian = one.largest_function().outputs.pop().unwrap();
        let ((zeros, others), rows) = (one.entries(&jacobian), one.rows(&jacobian));
        assert_eq!(zeros.len() + others.len(), one.graph.jacobian.len());
        assert_eq!(one.graph.jacobian.len(), one.row() * one.graph.value.len());
        assert!(zeros.iter().all(|&k| one.graph.constant(one.graph.jacobian[k]) == Some(0.0)));
        assert!(
            others.iter().all(|&(k, entry)| one.graph.jacobian[k] == entry && one.graph.constant(entry) != Some(0.0))
        );
        // A row is written if any of its entries is.
        let there: std::collections::BTreeSet<_> = others.iter().map(|(k, _)| k / one.row()).collect();
        assert!(rows.iter().map(|(row, _)| *row).eq(there));
        let functions = one.functions();
        let [alone, both] = [0, 1].map(|k| one.results(&functions[k]));
        assert_eq!(both.len() - alone.len(), one.graph.jacobian.len());
        assert_eq!(both[..alone.len()], alone);
    }

    #[test]
    fn what_refuses_inputs_is_told_by_its_code() {
        let one = &formulas(&["slide_line.contact_area_parabolic"])[0];
        let (inputs, lines) = (one.inputs(), refusals(one));
        // One code per line, apart from continuation lines.
        let count = inputs.len() + one.graph.refusals.len();
        for code in 1..=count {
            let found: Vec<_> = lines.iter().filter(|line| line.starts_with(&format!("{code} unless "))).collect();
            assert_eq!(found.len(), 1, "{lines:#?}");
            let field = inputs.get(code - 1);
            assert!(
                field.is_none_or(|field| found[0].starts_with(&format!("{code} unless {}: ", field.name))),
                "{found:?}"
            );
        }
        assert_eq!(stem(one), "slide_line_contact_area_parabolic");
    }

    #[test]
    fn a_word_of_the_language_is_no_name() {
        assert_eq!(["lambda", "mu"].map(|name| unreserved(name, &["if", "lambda"])), ["lambda_", "mu"]);
    }

    #[test]
    fn a_golden_file_is_told_by_its_checksum_where_there_is_one() {
        let root = tempfile::tempdir().unwrap();
        let project = Project::new("told", root.path().to_str().unwrap().to_owned().leak(), &[]);
        let formula = Subject::Formula(jointproof::catalog::find("slot.contact_force").unwrap());
        let said = |project| {
            let (recorded, _) = record(&[formula], project);
            description(&recorded[0]).into_iter().filter(|line| line.starts_with("SHA-256 ")).collect::<Vec<_>>()
        };
        assert_eq!((said(None), said(Some(&project))), (vec![], vec![]));
        std::fs::create_dir(project.golden()).unwrap();
        std::fs::write(project.golden_file("slot.contact_force"), "").unwrap();
        let empty = "SHA-256 e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
        assert_eq!(said(Some(&project)), [empty]);
    }
}
