//! What a language says for the operations of a graph.

use super::recorded::Recorded;
use jointproof::formula::Field;
use jointproof::graph::{Node, Op};

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

/// A language to print in.
pub(super) trait Language {
    /// All files of an export, by their names.
    fn files(&self, recorded: &[Recorded]) -> Vec<(String, String)>;

    /// What can build and run them.
    fn toolchains(&self) -> Vec<Toolchain>;

    /// A constant.
    fn number(&self, x: f64) -> String;

    /// A component of an argument.
    fn argument(&self, field: &Field, component: usize) -> String;

    /// An operation; what has several lines has them indented by the caller.
    fn operation(&self, op: &Op, operand: Operand) -> String;

    /// A name for a result, set once.
    fn set(&self, name: &str, is_answer: bool, value: &str) -> String;

    /// The names of results that a choice sets, announced before it; nothing where all names are announced at the head.
    fn announce(&self, name: &str) -> Option<String>;

    /// One of them is set.
    fn assign(&self, name: &str, value: &str) -> String;

    /// What a line ends with that goes on in the next.
    fn goes_on(&self) -> &'static str {
        ""
    }

    /// The head of a choice, what stands between its sides, and its end.
    fn choose(&self, condition: &str) -> [String; 3];
}
