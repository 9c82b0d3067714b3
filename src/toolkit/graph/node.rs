//! The list of operations, without repeated computations.

use crate::Octuple;
use crate::formula::error::Error;
use crate::number::scalar::{self, Leaf};
use rustc_hash::FxHashMap;
use std::fmt;
use std::hash::{Hash, Hasher};

/// The index of a result in the list: a number, or the Boolean of a comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Node(u32);

impl Node {
    pub(crate) fn at(index: usize) -> Self {
        Self(u32::try_from(index).expect("fewer than 2³² operations"))
    }

    /// The index, from 0.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A function of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Unary {
    /// −x
    Negative,
    /// |x|
    Absolute,
    /// √x
    Root,
    /// sin x
    Sine,
    /// cos x
    Cosine,
    /// arcsin x
    ArcSine,
    /// eˣ
    Exponential,
    /// eˣ − 1
    ExponentialMinusOne,
    /// The largest power of two that is not above x, within 2⁻¹⁰²² … 2¹⁰²²; x is positive.
    PowerOfTwo,
    /// The nearest integer; of two that are equally near, the one farther from 0.
    NearestInteger,
}

/// An operation on two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Binary {
    /// x + y
    Add,
    /// x − y
    Subtract,
    /// x y
    Multiply,
    /// x / y
    Divide,
    /// The angle of the point (y, x): the ordinate comes first.
    Angle,
    /// The larger of x and y.
    Maximum,
}

/// A comparison of two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Relation {
    /// x < y
    Less,
    /// x ≤ y
    LessOrEqual,
    /// x = y
    Equal,
}

/// A search, identified by its name and executed by a function.
#[derive(Clone, Copy)]
pub struct Search {
    /// Its name.
    pub name: &'static str,
    /// The result of the search from its list of numbers.
    pub(super) find: fn(&[f64]) -> f64,
    /// The same in 237 bits.
    pub(super) find_exactly: fn(&[Octuple]) -> Octuple,
}

impl Search {
    /// A search used by formulas, as an operation.
    pub(crate) fn of<S: scalar::Search<N>, const N: usize>() -> Self {
        Self { name: S::NAME, find: found::<_, S, N>, find_exactly: found::<_, S, N> }
    }
}

/// The result of a search, from a slice with the right number of numbers.
fn found<L: Leaf, S: scalar::Search<N>, const N: usize>(numbers: &[L]) -> L {
    S::find(std::array::from_fn(|k| numbers[k]))
}

impl PartialEq for Search {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Search {}

impl Hash for Search {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.name.hash(state);
    }
}

impl fmt::Debug for Search {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

/// How a result is computed from earlier ones.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Op {
    /// A component of the inputs, in order.
    Input(usize),
    /// A number, stored as bits so that it can be hashed.
    Number(u64),
    /// A function of one number.
    Unary(Unary, Node),
    /// An operation on two numbers.
    Binary(Binary, Node, Node),
    /// x y + z, rounded once.
    MultiplyAdd(Node, Node, Node),
    /// The length of a vector, as [`norm`](crate::number::scalar::norm) computes it.
    Norm(Box<[Node]>),
    /// A sum of products of four numbers each, with only the final sum rounded.
    ExactSum(Box<[[Node; 4]]>),
    /// The result of a search from these numbers.
    Search(Search, Box<[Node]>),
    /// A comparison, which yields a Boolean.
    Compare(Relation, Node, Node),
    /// The second if the first, a Boolean, is true; else the third. Both may be Booleans.
    Select(Node, Node, Node),
}

impl Op {
    /// The conjunction of two Booleans; the second counts only if the first is true.
    pub(crate) fn both(first: Node, second: Node) -> Self {
        Self::Select(first, second, first)
    }

    /// The disjunction of two Booleans; the second counts only if the first is false.
    pub(super) fn either(first: Node, second: Node) -> Self {
        Self::Select(first, first, second)
    }

    /// The operands, if this is a conjunction.
    pub fn both_of(&self) -> Option<[Node; 2]> {
        match *self {
            Self::Select(first, second, no) if no == first => Some([first, second]),
            _ => None,
        }
    }

    /// The operands, if this is a disjunction.
    pub fn either_of(&self) -> Option<[Node; 2]> {
        match *self {
            Self::Select(first, yes, second) if yes == first => Some([first, second]),
            _ => None,
        }
    }

    /// Its operands.
    pub fn operands(&self) -> Vec<Node> {
        let mut operands = Vec::new();
        self.each_operand(|operand| operands.push(operand));
        operands
    }

    /// Visits its operands one by one.
    pub(super) fn each_operand(&self, mut f: impl FnMut(Node)) {
        match self {
            Self::Input(_) | Self::Number(_) => {}
            Self::Unary(_, x) => f(*x),
            Self::Binary(_, x, y) | Self::Compare(_, x, y) => {
                f(*x);
                f(*y);
            }
            Self::MultiplyAdd(x, y, z) | Self::Select(x, y, z) => {
                f(*x);
                f(*y);
                f(*z);
            }
            Self::Norm(parts) | Self::Search(_, parts) => parts.iter().copied().for_each(f),
            Self::ExactSum(products) => products.iter().flatten().copied().for_each(f),
        }
    }

    /// The same operation on other operands.
    ///
    /// # Panics
    /// If their number differs.
    #[must_use]
    pub fn on(&self, operands: &[Node]) -> Self {
        assert_eq!(operands.len(), self.operands().len(), "an operation keeps the number of its operands");
        self.with_operands(operands)
    }

    /// The same operation on other operands of the same number.
    pub(super) fn with_operands(&self, operands: &[Node]) -> Self {
        match (self, operands) {
            (Self::Unary(function, _), &[x]) => Self::Unary(*function, x),
            (Self::Binary(operation, ..), &[x, y]) => Self::Binary(*operation, x, y),
            (Self::Compare(relation, ..), &[x, y]) => Self::Compare(*relation, x, y),
            (Self::MultiplyAdd(..), &[x, y, z]) => Self::MultiplyAdd(x, y, z),
            (Self::Select(..), &[x, y, z]) => Self::Select(x, y, z),
            (Self::Norm(_), parts) => Self::Norm(parts.into()),
            (Self::Search(search, _), parts) => Self::Search(*search, parts.into()),
            (Self::ExactSum(_), factors) => Self::ExactSum(factors.as_chunks().0.into()),
            _ => self.clone(),
        }
    }

    /// Whether it has this operand.
    pub(super) fn mentions(&self, node: Node) -> bool {
        let mut mentions = false;
        self.each_operand(|operand| mentions |= operand == node);
        mentions
    }

    /// Whether both are the same operation, perhaps on different operands. Inputs and numbers never are.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Unary(mine, _), Self::Unary(others, _)) => mine == others,
            (Self::Binary(mine, ..), Self::Binary(others, ..)) => mine == others,
            (Self::Compare(mine, ..), Self::Compare(others, ..)) => mine == others,
            (Self::MultiplyAdd(..), Self::MultiplyAdd(..)) | (Self::Select(..), Self::Select(..)) => true,
            (Self::Norm(mine), Self::Norm(others)) => mine.len() == others.len(),
            (Self::ExactSum(mine), Self::ExactSum(others)) => mine.len() == others.len(),
            (Self::Search(mine, numbers), Self::Search(others, more)) => mine == others && numbers.len() == more.len(),
            _ => false,
        }
    }
}

/// A formula as a list of operations: its value, and its Jacobian output by output, each over all inputs.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    ops: Vec<Op>,
    known: FxHashMap<Op, Node>,
    /// The components of the value.
    pub value: Vec<Node>,
    /// The entries of the Jacobian.
    pub jacobian: Vec<Node>,
    /// 0 if inputs in their domains are valid together, else the position in `refusals`, from 1; `None` if they always are.
    pub refusal: Option<Node>,
    /// The reasons for rejecting inputs. Numbers in these are NaN, since they depend on the inputs.
    pub refusals: Vec<Error>,
}

impl Graph {
    /// The operations in order: operands come before the operations that use them.
    pub fn ops(&self) -> &[Op] {
        &self.ops
    }

    /// The operation that computes a result.
    pub fn op(&self, node: Node) -> &Op {
        &self.ops[node.index()]
    }

    /// The index of a result, which is added if it is new.
    pub(crate) fn enter(&mut self, op: Op) -> Node {
        if let Some(&node) = self.known.get(&op) {
            return node;
        }
        let node = Node::at(self.ops.len());
        self.ops.push(op.clone());
        self.known.insert(op, node);
        node
    }

    /// The indices in another graph of the components of this value; the inputs of this graph are those of the other
    /// at the positions `inputs`.
    pub fn value_within(&self, other: &Self, inputs: &[usize]) -> Vec<Option<Node>> {
        let mut places: Vec<Option<Node>> = Vec::with_capacity(self.ops.len());
        for op in &self.ops {
            let operands: Option<Vec<_>> = op.operands().into_iter().map(|node| places[node.index()]).collect();
            let there = operands.map(|operands| match op {
                Op::Input(k) => Op::Input(inputs[*k]),
                op => op.with_operands(&operands),
            });
            places.push(there.and_then(|op| other.known.get(&op).copied()));
        }
        self.value.iter().map(|node| places[node.index()]).collect()
    }

    /// The value of a constant.
    pub fn constant(&self, node: Node) -> Option<f64> {
        match self.op(node) {
            Op::Number(bits) => Some(f64::from_bits(*bits)),
            _ => None,
        }
    }

    /// The graph without operations that no result needs, the rest in the same order.
    #[must_use]
    pub(super) fn pruned(&self) -> Self {
        let results = [self.refusal.as_slice(), &self.value, &self.jacobian].concat();
        let mut pruned = Self::default();
        let mut places = FxHashMap::default();
        for node in self.needed(&results) {
            let op = self.op(node);
            let operands: Vec<_> = op.operands().iter().map(|node| places[node]).collect();
            places.insert(node, pruned.enter(op.with_operands(&operands)));
        }
        pruned.with_results_of(self, |node| places[&node])
    }

    /// This graph with the results of another one, whose indices are mapped by `moved`.
    pub(super) fn with_results_of(mut self, other: &Self, moved: impl Fn(Node) -> Node) -> Self {
        self.value = other.value.iter().map(|&node| moved(node)).collect();
        self.jacobian = other.jacobian.iter().map(|&node| moved(node)).collect();
        self.refusal = other.refusal.map(moved);
        self.refusals.clone_from(&other.refusals);
        self
    }
}

#[cfg(test)]
mod tests {
    use super::{Node, Op, Search};
    use crate::Octuple;

    #[test]
    fn searches_are_told_apart_by_their_names() {
        let named = |name| Search { name, find: |_| 0.0, find_exactly: |_| Octuple::from(0.0) };
        assert_eq!(named("nearest_place"), named("nearest_place"));
        assert_ne!(named("nearest_place"), named("root"));
    }

    #[test]
    fn both_and_either_are_known_again() {
        let [x, y, z] = [1, 2, 3].map(Node::at);
        let known = |op: Op| [op.both_of(), op.either_of()];
        assert_eq!(known(Op::both(x, y)), [Some([x, y]), None]);
        assert_eq!(known(Op::either(x, y)), [None, Some([x, y])]);
        assert_eq!(known(Op::Select(x, y, z)), [None, None]);
    }
}
