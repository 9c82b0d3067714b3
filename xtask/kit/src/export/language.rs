//! What a language says for the operations of a graph.

use super::recorded::Recorded;
use jointproof::formula::Field;
use jointproof::toolkit::graph::{Node, Op};

/// The text of the operand at a node.
pub(super) type Operand<'a> = &'a dyn Fn(Node) -> String;

/// What builds and runs a driver: commands in the folder of the export.
pub(super) struct Toolchain {
    /// The program that must be here.
    pub(super) name: &'static str,
    /// The commands, each a program and its arguments; the last one is the driver.
    pub(super) commands: Vec<Vec<String>>,
    /// By how much results that come from functions such as the sine may differ from those of Rust, in units of the distance
    /// from 1 to the next number: the language has its own, which may be off by a rounding, and angles are of the size 1.
    pub(super) epsilons: f64,
}

/// A name and a text.
pub(super) type File = (String, String);

/// No file of a formula has more lines.
const LONGEST: usize = 400;

/// The files of a formula, its functions in parts where they are too long for one.
pub(super) fn files_of(language: &dyn Syntax, one: &Recorded) -> Vec<File> {
    let limits = [usize::MAX, 100, 60, 30, 15, 5];
    let mut files = Vec::new();
    for limit in limits {
        files = language.formula(one, limit);
        if files.iter().all(|(_, text)| text.lines().count() <= LONGEST) {
            break;
        }
    }
    files
}

/// A language to print in.
pub(super) trait Language {
    /// All files of an export, by their names.
    fn files(&self, recorded: &[Recorded]) -> Vec<File>;

    /// Why a formula cannot be written in it.
    fn refuses(&self, _: &Recorded) -> Option<&'static str> {
        None
    }

    /// What can build and run them.
    fn toolchains(&self) -> Vec<Toolchain>;
}

/// How a language writes functions of statements.
pub(super) trait Syntax {
    /// The files of one formula, the first of them with functions of about so many lines at most.
    fn formula(&self, one: &Recorded, limit: usize) -> Vec<File>;

    /// A constant.
    fn number(&self, x: f64) -> String;

    /// A component of an argument.
    fn argument(&self, field: &Field, component: usize) -> String;

    /// An operation; what has several lines has them indented by the caller.
    fn operation(&self, op: &Op, operand: Operand) -> String;

    /// A name for a result, set once.
    fn set(&self, name: &str, is_answer: bool, value: &str) -> String;

    /// The names of results that a choice sets, announced before it; nothing where all names are announced at the head.
    fn announce(&self, name: &str, is_answer: bool) -> Option<String>;

    /// One of them is set.
    fn assign(&self, name: &str, value: &str) -> String;

    /// How far the body of a function is indented, in steps.
    fn indent(&self) -> usize {
        1
    }

    /// An element of an array; as an answer, if it stands for one.
    fn element(&self, array: &str, k: usize, is_answer: bool) -> String;

    /// What stands for a result among numbers.
    fn as_number(&self, text: &str, _is_answer: bool) -> String {
        text.to_owned()
    }

    /// A part of a function is done: it takes inputs and other results, and gives an array.
    fn call(&self, stem: &str, part: usize, inputs: &[&Field], given: &[String], found: (&str, usize)) -> String;

    /// What a line ends with that goes on in the next.
    fn goes_on(&self) -> &'static str {
        ""
    }

    /// The head of a choice, what stands between its sides, and its end.
    fn choose(&self, condition: &str) -> [String; 3];
}
