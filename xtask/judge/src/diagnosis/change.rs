//! Mistakes in a single operation: what it gives instead, with its derivatives with respect to its operands.

use super::sample::single;
use jointproof::toolkit::graph::{Binary, Node, Op, Relation, Unary};

/// What an operation gives instead of its result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Change {
    /// The result times a number.
    Times(f64),
    /// An operand, with a sign.
    Operand(usize, f64),
    /// The first operand times a number plus the second one times another.
    Linear(f64, f64),
    /// Another operation on two operands.
    Other(Binary),
    /// The operands the other way round.
    Turned,
    /// Another function of one number.
    Function(Unary),
    /// The square of the result.
    Square,
    /// The root of the square plus a number.
    Softened(f64),
    /// The result plus a number.
    Shifted(f64),
    /// The smaller of two.
    Minimum,
    /// The positive part of the operand.
    Positive,
    /// The sum of the components of a length.
    Sum,
    /// A length without one of its components.
    Without(usize),
    /// A hyperbolic tangent of the number compared, divided by a width, for a sign.
    Smooth(Node, f64),
    /// The arctangent of a quotient, which knows no quadrants.
    Quotient,
    /// A number.
    Constant(f64),
    /// One of its operands is another result.
    Instead(usize, Node),
    /// Another result, as it is without any change.
    Value(Node),
}

/// A result with its derivatives with respect to the nodes that it depends on.
pub(super) type Local = (f64, Vec<(Node, f64)>);

/// The result of an operation as it is.
pub(super) fn right(op: &Op, inputs: &[f64], all: &[f64]) -> Local {
    let result = op.result(inputs, all);
    (result, derivatives(op, result, all))
}

/// The derivatives of an operation, as they follow from its result.
pub(super) fn derivatives(op: &Op, result: f64, all: &[f64]) -> Vec<(Node, f64)> {
    match op {
        Op::Select(condition, x, y) => vec![(if all[condition.index()] == 1.0 { *x } else { *y }, 1.0)],
        Op::Compare(..) | Op::Input(_) | Op::Number(_) | Op::Search(..) => Vec::new(),
        op => op.operands().into_iter().zip(op.derivatives(result, all)).collect(),
    }
}

impl Change {
    /// The result and its derivatives instead of those of an operation.
    pub(super) fn apply(self, op: &Op, inputs: &[f64], all: &[f64]) -> Local {
        let operands = op.operands();
        let value = |k: usize| operands.get(k).map_or(f64::NAN, |node| all[node.index()]);
        let scaled = |(y, by): Local, factor: f64| {
            (y * factor, by.into_iter().map(|(node, slope)| (node, slope * factor)).collect::<Vec<_>>())
        };
        match self {
            Self::Times(factor) => scaled(right(op, inputs, all), factor),
            Self::Operand(k, sign) => (sign * value(k), vec![(operands[k], sign)]),
            Self::Linear(a, b) => (a * value(0) + b * value(1), vec![(operands[0], a), (operands[1], b)]),
            Self::Other(binary) => right(&Op::Binary(binary, operands[0], operands[1]), inputs, all),
            Self::Turned => match op {
                Op::Binary(binary, x, y) => right(&Op::Binary(*binary, *y, *x), inputs, all),
                Op::Compare(relation, x, y) => right(&Op::Compare(*relation, *y, *x), inputs, all),
                Op::Select(condition, x, y) => right(&Op::Select(*condition, *y, *x), inputs, all),
                op => right(op, inputs, all),
            },
            Self::Function(unary) => right(&Op::Unary(unary, operands[0]), inputs, all),
            Self::Square => {
                let (y, by) = right(op, inputs, all);
                (y * y, by.into_iter().map(|(node, slope)| (node, 2.0 * y * slope)).collect())
            }
            Self::Softened(e) => {
                let (y, by) = right(op, inputs, all);
                let soft = (y * y + e).sqrt();
                (soft, by.into_iter().map(|(node, slope)| (node, slope * y / soft)).collect())
            }
            Self::Shifted(e) => {
                let (y, by) = right(op, inputs, all);
                (y + e, by)
            }
            Self::Minimum => {
                let k = usize::from(value(1) < value(0));
                (value(k), vec![(operands[k], 1.0)])
            }
            Self::Positive => (value(0).max(0.0), vec![(operands[0], f64::from(u8::from(value(0) > 0.0)))]),
            Self::Sum => (
                operands.iter().map(|node| all[node.index()].abs()).sum(),
                operands.iter().map(|node| (*node, all[node.index()].signum())).collect(),
            ),
            Self::Without(k) => {
                let rest = || operands.iter().enumerate().filter(|(other, _)| *other != k).map(|(_, node)| *node);
                let length = rest().map(|node| all[node.index()].powi(2)).sum::<f64>().sqrt();
                (length, rest().map(|node| (node, all[node.index()] / length)).collect())
            }
            Self::Smooth(x, width) => {
                let y = (all[x.index()] / width).tanh();
                (y, vec![(x, (1.0 - y * y) / width)])
            }
            Self::Quotient => {
                let (y, x) = (value(0), value(1));
                let square = x * x + y * y;
                ((y / x).atan(), vec![(operands[0], x / square), (operands[1], -y / square)])
            }
            Self::Constant(x) => (x, Vec::new()),
            Self::Value(other) => (all[other.index()], Vec::new()),
            Self::Instead(k, other) => {
                let mut operands = operands;
                operands[k] = other;
                right(&op.on(&operands), inputs, all)
            }
        }
    }
}

/// A change of an operation with the words for it, in which `{0}`, `{1}` are its operands and `{}` the whole; `{+}`, `{-}` and `{?}`
/// are sides of a comparison.
pub(super) type Worded = (Change, String);

/// Widths of transitions, and numbers that are added below roots, as programs have them.
pub(super) const SMALL: [f64; 15] =
    [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-12, 1e-14, 1e-15, 1e-16, f64::EPSILON, 1e-20];

/// All changes that are tried of an operation.
#[expect(clippy::too_many_lines, reason = "a table")]
pub(super) fn changes(op: &Op) -> Vec<Worded> {
    let of = |change: Change, what: &str| (change, what.to_owned());
    let factors = |what: &str| {
        vec![
            of(Change::Times(2.0), &format!("a factor of 2 too much in {what}")),
            of(Change::Times(0.5), &format!("a factor of ½ too much in {what}")),
        ]
    };
    let mut all = match op {
        Op::Binary(Binary::Add, ..) => vec![
            of(Change::Linear(1.0, -1.0), "the sign of {1} is reversed in {}"),
            of(Change::Linear(-1.0, 1.0), "the sign of {0} is reversed in {}"),
            of(Change::Operand(0, 1.0), "the term {1} is left out of {}"),
            of(Change::Operand(1, 1.0), "the term {0} is left out of {}"),
            of(Change::Linear(1.0, 2.0), "a factor of 2 too much in {1}, a term of {}"),
            of(Change::Linear(2.0, 1.0), "a factor of 2 too much in {0}, a term of {}"),
            of(Change::Linear(1.0, 0.5), "a factor of ½ too much in {1}, a term of {}"),
            of(Change::Linear(0.5, 1.0), "a factor of ½ too much in {0}, a term of {}"),
            of(Change::Other(Binary::Multiply), "a product for the sum {}"),
        ],
        Op::Binary(Binary::Subtract, ..) => vec![
            of(Change::Linear(1.0, 1.0), "the sign of {1} is reversed in {}"),
            of(Change::Linear(-1.0, 1.0), "the sign of {} is reversed"),
            of(Change::Linear(-1.0, -1.0), "the sign of {0} is reversed in {}"),
            of(Change::Operand(0, 1.0), "the term {1} is left out of {}"),
            of(Change::Operand(1, -1.0), "the term {0} is left out of {}"),
            of(Change::Linear(1.0, -2.0), "a factor of 2 too much in {1}, a term of {}"),
            of(Change::Linear(2.0, -1.0), "a factor of 2 too much in {0}, a term of {}"),
            of(Change::Linear(1.0, -0.5), "a factor of ½ too much in {1}, a term of {}"),
            of(Change::Linear(0.5, -1.0), "a factor of ½ too much in {0}, a term of {}"),
        ],
        Op::Binary(Binary::Multiply, x, y) => {
            let mut all = vec![of(Change::Times(-1.0), "the sign of {} is reversed")];
            if x == y {
                all.push(of(Change::Operand(0, 1.0), "the square of {0} is missing: {0} for {}"));
            } else {
                all.push(of(Change::Operand(1, 1.0), "the factor {0} is missing in {}"));
                all.push(of(Change::Operand(0, 1.0), "the factor {1} is missing in {}"));
                all.push(of(Change::Other(Binary::Divide), "a quotient for the product {}: {0} is divided by {1}"));
                all.push(of(Change::Other(Binary::Add), "a sum for the product {}"));
            }
            all.extend(factors("{}"));
            all
        }
        Op::Binary(Binary::Divide, ..) => [
            vec![
                of(Change::Operand(0, 1.0), "the division by {1} is missing in {}"),
                of(Change::Other(Binary::Multiply), "a product for the quotient {}"),
                of(Change::Turned, "inverted: {1} / {0} for {}"),
                of(Change::Times(-1.0), "the sign of {} is reversed"),
            ],
            factors("{}"),
        ]
        .concat(),
        Op::Binary(Binary::Angle, ..) => vec![
            of(Change::Turned, "the arguments of {} are exchanged"),
            of(Change::Quotient, "an arctangent of a quotient, without quadrants, for {}"),
            of(Change::Times(-1.0), "the sign of {} is reversed"),
            of(Change::Times(180.0 / std::f64::consts::PI), "degrees for radians in {}"),
        ],
        Op::Binary(Binary::Maximum, ..) => vec![
            of(Change::Minimum, "the smaller for the larger in {}"),
            of(Change::Operand(0, 1.0), "{0} always, for {}"),
            of(Change::Operand(1, 1.0), "{1} always, for {}"),
        ],
        Op::Norm(parts) => {
            let mut all = vec![
                of(Change::Square, "the root is lost: the square of {}"),
                of(Change::Sum, "the sum of the components for {}"),
                of(Change::Times(-1.0), "the sign of {} is reversed"),
            ];
            let without = |k: usize| (Change::Without(k), format!("the component {{{k}}} is left out of {{}}"));
            all.extend((0..parts.len()).map(without));
            all.extend(factors("{}"));
            all
        }
        Op::Unary(Unary::Root, _) => vec![
            of(Change::Operand(0, 1.0), "the root is lost: {0} for {}"),
            of(Change::Times(-1.0), "the sign of {} is reversed"),
        ],
        Op::Unary(Unary::Absolute, _) => vec![
            of(Change::Operand(0, 1.0), "{0} for its absolute value"),
            of(Change::Positive, "max(0, {0}) for {}"),
            of(Change::Times(-1.0), "the sign of {} is reversed"),
            of(Change::Square, "the square of {0} for {}"),
        ],
        Op::Unary(Unary::Negative, _) => vec![of(Change::Operand(0, 1.0), "a minus is missing before {0}")],
        Op::Unary(Unary::Sine, _) => vec![
            of(Change::Function(Unary::Cosine), "cos for sin of {0}"),
            of(Change::Times(-1.0), "the sign of {} is reversed"),
            of(Change::Operand(0, 1.0), "the small angle {0} for {}"),
        ],
        Op::Unary(Unary::Cosine, _) => vec![
            of(Change::Function(Unary::Sine), "sin for cos of {0}"),
            of(Change::Times(-1.0), "the sign of {} is reversed"),
            of(Change::Constant(1.0), "1, as for a small angle, for {}"),
        ],
        Op::Unary(Unary::ArcSine, _) => vec![
            of(Change::Operand(0, 1.0), "the small angle {0} for {}"),
            of(Change::Times(-1.0), "the sign of {} is reversed"),
            of(Change::Times(180.0 / std::f64::consts::PI), "degrees for radians in {}"),
        ],
        Op::Unary(Unary::Exponential, _) => vec![
            of(Change::Function(Unary::ExponentialMinusOne), "1 is subtracted from {}"),
            of(Change::Operand(0, 1.0), "the exponential is left out: {0} for {}"),
        ],
        Op::Unary(Unary::ExponentialMinusOne, _) => vec![
            of(Change::Function(Unary::Exponential), "1 is not subtracted: exp for expm1 of {0}"),
            of(Change::Operand(0, 1.0), "{0} for {}"),
        ],
        Op::MultiplyAdd(..) => vec![of(Change::Operand(2, 1.0), "the term {0} {1} is left out of {}")],
        Op::Number(bits) => constant(f64::from_bits(*bits)),
        Op::Compare(relation, ..) if *relation != Relation::Equal => vec![
            of(Change::Constant(1.0), "one branch for all: {+}"),
            of(Change::Constant(0.0), "one branch for all: {-}"),
            of(Change::Turned, "the branches are exchanged: {?}"),
        ],
        _ => Vec::new(),
    };
    if matches!(op, Op::Norm(_) | Op::Unary(Unary::Root | Unary::Absolute, _)) {
        let soft = |e: f64| (Change::Softened(e), format!("√(x² + {e:e}) for x = {{}}"));
        let shifted = |e: f64| (Change::Shifted(e), format!("{e:e} is added to {{}}"));
        all.extend(SMALL.map(soft));
        all.extend(SMALL.map(shifted));
    }
    all
}

/// Other numbers than this one: of single precision, as quotients of integers, with another sign or factor.
fn constant(number: f64) -> Vec<Worded> {
    let mut all = Vec::new();
    let rounded = f64::from(single(number));
    // A number that no program would contain in this form is one of ours alone.
    let is_written = number == 0.0 || (1e-9..1e9).contains(&number.abs());
    if !is_written || number == 0.0 {
        return all;
    }
    if rounded != number {
        all.push((Change::Constant(rounded), format!("the constant {number} has single precision")));
    }
    if number.fract() != 0.0 {
        let whole = number.trunc();
        all.push((Change::Constant(whole), format!("{number} is computed with integers: {whole}")));
    }
    for (factor, word) in [(-1.0, "−"), (2.0, "2·"), (0.5, "½·")] {
        all.push((Change::Constant(number * factor), format!("{word}{number} for the constant {number}")));
    }
    if number.abs() != 1.0 {
        all.push((Change::Constant(1.0 / number), format!("inverted: 1/{number} for the constant {number}")));
        all.push((Change::Constant(1.0), format!("the constant {number} is left out: 1 for it")));
    }
    all
}
