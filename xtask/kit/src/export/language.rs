//! The syntax of a language for the operations of a graph.

use super::recorded::Recorded;
use jointproof::formula::Field;
use jointproof::toolkit::graph::{Node, Op};

/// The text of the operand at a node.
pub(super) type Operand<'a> = &'a dyn Fn(Node) -> String;

/// The commands that build and run a driver in the folder of the export.
pub(super) struct Toolchain {
    /// The program that must be available.
    pub(super) name: &'static str,
    /// The commands, each a program and its arguments; the last one is the driver.
    pub(super) commands: Vec<Vec<String>>,
    /// The tolerance for results computed with functions such as the sine, compared with Rust, in units of the distance from 1 to
    /// the next number: each language has its own functions, which may be off by a rounding, and angles are of the size 1.
    pub(super) epsilons: f64,
}

/// A name and a text.
pub(super) type File = (String, String);

/// A language to print in.
pub(super) trait Language {
    /// All files of an export, by their names.
    fn files(&self, recorded: &[Recorded]) -> Vec<File>;

    /// Why a formula or an element cannot be written in it.
    fn refuses(&self, _: &Recorded) -> Option<&'static str> {
        None
    }

    /// The toolchains that can build and run the files.
    fn toolchains(&self) -> Vec<Toolchain>;
}

/// A language in which functions consist of statements.
pub(super) trait Syntax {
    /// The approximate number of lines of the statements of a part: fewer than a function may have, by as many as declare
    /// arguments and assign results.
    fn lines_of_part(&self) -> usize {
        180
    }

    /// A constant.
    fn number(&self, x: f64) -> String;

    /// A component of an argument.
    fn argument(&self, field: &Field, component: usize) -> String;

    /// An operation; if it spans several lines, the caller indents them.
    fn operation(&self, op: &Op, operand: Operand) -> String;

    /// The result of an operation under a name.
    fn statement(&self, name: &str, is_answer: bool, op: &Op, operand: Operand) -> String {
        self.set(name, is_answer, &self.operation(op, operand))
    }

    /// A name for a result, set once.
    fn set(&self, name: &str, is_answer: bool, value: &str) -> String;

    /// The declaration of results that a choice sets, before it; `None` if all names are declared at the head.
    fn announce(&self, name: &str, is_answer: bool) -> Option<String>;

    /// The assignment of one of them.
    fn assign(&self, name: &str, value: &str) -> String;

    /// An element of an array; converted to a Boolean if it represents one.
    fn element(&self, array: &str, k: usize, is_answer: bool) -> String;

    /// The representation of a result among numbers.
    fn as_number(&self, text: &str, _is_answer: bool) -> String {
        text.to_owned()
    }

    /// The call of a part of a function: it takes inputs, each with the one that is passed for it, and other results, and
    /// returns an array.
    fn call(&self, stem: &str, part: usize, inputs: &[[&Field; 2]], given: &[String], found: (&str, usize)) -> String;

    /// The mark at the end of a line that continues on the next.
    fn goes_on(&self) -> &'static str {
        ""
    }

    /// The head of a choice, the text between its branches, and its end.
    fn choose(&self, condition: &str) -> [String; 3];
}
