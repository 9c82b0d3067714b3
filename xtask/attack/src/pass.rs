//! One pass forwards and one backwards over the operations that a result needs, in `f64`.

use crate::rounding;
use crate::target::Target;
use jointproof::toolkit::graph::{Binary, Graph, Node, Op, Unary};
use std::ops::Range;

/// Unit roundoff of `f64`, 2⁻⁵³.
pub(crate) const U: f64 = f64::EPSILON / 2.0;

/// A smaller number is not as accurate as it should be, since what it is made from may have underflowed.
const LEAST: f64 = f64::MIN_POSITIVE / f64::EPSILON;

/// The results of all operations, and the derivatives of one result with respect to them.
pub(crate) struct Pass<'a> {
    graph: &'a Graph,
    pub(crate) all: Vec<f64>,
    pub(crate) slopes: Vec<f64>,
    /// Whether one of these derivatives has nearly underflowed.
    is_rough: bool,
    /// The components of the fields, if sensitivities are to whole vectors; else of each component by itself.
    pub(crate) fields: Vec<Range<usize>>,
    /// The derivatives of the last result with respect to the inputs, and the inputs.
    gradient: Vec<[f64; 2]>,
}

/// The error of a result and what it is judged by, to first order.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Errors {
    /// Σ ρ |∂y/∂t · t|: the largest possible error in units of u.
    pub(crate) most: f64,
    /// The error by the roundings that occur, in units of u.
    pub(crate) actual: f64,
    /// Σ |∂y/∂x · x| + |y|.
    pub(crate) size: f64,
    /// Whether a number or a derivative has nearly underflowed, so that these errors are not to be trusted.
    pub(crate) is_rough: bool,
}

impl<'a> Pass<'a> {
    pub(crate) fn over(graph: &'a Graph, fields: Vec<Range<usize>>) -> Self {
        let empty = vec![0.0; graph.ops().len()];
        let inputs = fields.last().map_or(0, |field| field.end);
        Self { graph, all: empty.clone(), slopes: empty, is_rough: false, fields, gradient: vec![[0.0; 2]; inputs] }
    }

    pub(crate) fn at(&self, node: Node) -> f64 {
        self.all[node.index()]
    }

    /// Computes these operations at a point.
    pub(crate) fn forwards(&mut self, needed: &[Node], inputs: &[f64]) {
        for &node in needed {
            self.all[node.index()] = match *self.graph.op(node) {
                Op::Input(k) => inputs[k],
                Op::Number(bits) => f64::from_bits(bits),
                Op::Binary(Binary::Add, x, y) => self.at(x) + self.at(y),
                Op::Binary(Binary::Subtract, x, y) => self.at(x) - self.at(y),
                Op::Binary(Binary::Multiply, x, y) => self.at(x) * self.at(y),
                Op::Binary(Binary::Divide, x, y) => self.at(x) / self.at(y),
                ref op => op.result(inputs, &self.all),
            };
        }
    }

    /// The derivatives of a weighted sum of results with respect to all operations that it needs.
    pub(crate) fn backwards(&mut self, of: &[(Node, f64)], needed: &[Node]) {
        for &node in needed {
            self.slopes[node.index()] = 0.0;
        }
        self.is_rough = false;
        for &(node, weight) in of {
            self.slopes[node.index()] += weight;
        }
        for &node in needed.iter().rev() {
            let slope = self.slopes[node.index()];
            if slope != 0.0 {
                self.pass_on(node, slope);
            }
        }
    }

    fn pass_on(&mut self, node: Node, slope: f64) {
        let (graph, result) = (self.graph, self.at(node));
        let is_rough = &mut self.is_rough;
        let mut add = |node: Node, by: f64| {
            let part = slope * by;
            *is_rough |= part.abs() < LEAST && by != 0.0;
            self.slopes[node.index()] += part;
        };
        let at = |node: &Node| self.all[node.index()];
        match graph.op(node) {
            Op::Unary(function, x) => {
                let by = match function {
                    Unary::Negative => -1.0,
                    Unary::Absolute => {
                        if at(x) == 0.0 {
                            0.0
                        } else {
                            at(x).signum()
                        }
                    }
                    Unary::Root => 0.5 / result,
                    Unary::Sine => at(x).cos(),
                    Unary::Cosine => -at(x).sin(),
                    Unary::ArcSine => ((1.0 - at(x)) * (1.0 + at(x))).sqrt().recip(),
                    Unary::Exponential => result,
                    Unary::ExponentialMinusOne => at(x).exp(),
                    Unary::PowerOfTwo | Unary::NearestInteger => 0.0,
                };
                add(*x, by);
            }
            Op::Binary(operation, x, y) => {
                let [by_x, by_y] = match operation {
                    Binary::Add => [1.0, 1.0],
                    Binary::Subtract => [1.0, -1.0],
                    Binary::Multiply => [at(y), at(x)],
                    Binary::Divide => [at(y).recip(), -result / at(y)],
                    Binary::Angle => {
                        let length = at(x).hypot(at(y));
                        [at(y) / length / length, -at(x) / length / length]
                    }
                    Binary::Maximum if at(y) > at(x) => [0.0, 1.0],
                    Binary::Maximum => [1.0, 0.0],
                };
                add(*x, by_x);
                add(*y, by_y);
            }
            Op::MultiplyAdd(x, y, z) => {
                add(*x, at(y));
                add(*y, at(x));
                add(*z, 1.0);
            }
            Op::Select(condition, x, y) => add(if at(condition) == 1.0 { *x } else { *y }, 1.0),
            Op::Norm(parts) if result != 0.0 => {
                parts.iter().for_each(|part| add(*part, at(part) / result));
            }
            Op::ExactSum(products) => {
                for product in products {
                    for (k, factor) in product.iter().enumerate() {
                        let others = (0..4).filter(|&other| other != k).map(|other| at(&product[other]));
                        add(*factor, others.product::<f64>());
                    }
                }
            }
            Op::Norm(_) | Op::Input(_) | Op::Number(_) | Op::Compare(..) | Op::Search(..) => {}
        }
    }

    /// The errors of a result, after a pass forwards; `needed` is what it alone needs. The roundings that occur take longer.
    pub(crate) fn errors(&mut self, of: Node, needed: &[Node], with_actual: bool) -> Errors {
        self.backwards(&[(of, 1.0)], needed);
        let mut errors = Errors { size: self.at(of).abs(), ..Errors::default() };
        self.gradient.fill([0.0; 2]);
        for &node in needed {
            let slope = self.slopes[node.index()];
            if slope == 0.0 {
                continue;
            }
            if let Op::Input(k) = *self.graph.op(node) {
                self.gradient[k] = [slope, self.at(node)];
                continue;
            }
            errors.is_rough |= self.has_underflowed(node);
            let most = rounding::most(self.graph, node, &self.all);
            if most > 0.0 {
                errors.most += most * (slope * self.at(node)).abs();
                if with_actual {
                    errors.actual += slope * (rounding::actual(self.graph, node, &self.all) / U);
                }
            }
        }
        let length = |field: &Range<usize>, part: usize| match self.gradient[field.clone()] {
            [both] => both[part].abs(),
            ref all => all.iter().fold(0.0, |length: f64, both| length.hypot(both[part])),
        };
        errors.is_rough |= self.is_rough;
        errors.size += self.fields.iter().map(|field| length(field, 0) * length(field, 1)).sum::<f64>();
        errors
    }

    /// Whether a product or a quotient of numbers that are not 0 has nearly underflowed, or the derivative of a quotient.
    fn has_underflowed(&self, node: Node) -> bool {
        let Op::Binary(operation @ (Binary::Multiply | Binary::Divide), x, y) = *self.graph.op(node) else {
            return false;
        };
        let result = self.at(node).abs();
        let slope = if operation == Binary::Divide { result / self.at(y).abs() } else { result };
        self.at(x) != 0.0 && self.at(y) != 0.0 && result.min(slope) < LEAST
    }

    /// Whether no divisor of a result vanishes for relative changes of the inputs by less than this, after a pass forwards.
    pub(crate) fn is_apart(&mut self, target: &Target, least: f64) -> bool {
        if target.singular.is_empty() {
            return true;
        }
        self.backwards(&[(target.own.0, 1.0)], &target.own.1);
        let is_live = |(node, _): &&(Node, Vec<_>)| self.slopes[node.index()] != 0.0;
        let live: Vec<_> = target.singular.iter().filter(is_live).collect();
        live.into_iter().all(|(_, numbers)| {
            let (mut size, mut change) = (0.0_f64, 0.0);
            for (node, needed) in numbers {
                size = size.max(self.at(*node).abs());
                let errors = self.errors(*node, needed, false);
                change += errors.size - self.at(*node).abs();
            }
            size >= change * least
        })
    }

    /// The derivatives of the result of the last pass backwards, by input; `inputs` is their number.
    pub(crate) fn gradient(&self, needed: &[Node], inputs: usize) -> Vec<f64> {
        let mut gradient = vec![0.0; inputs];
        for &node in needed {
            if let Op::Input(k) = *self.graph.op(node) {
                gradient[k] = self.slopes[node.index()];
            }
        }
        gradient
    }
}
