//! An element with or without friction at a point: its numbers as matrices, and their derivatives.

use super::compare::{DIFFERENCES, largest};
use super::linear::{Matrix, Vector, column};
use crate::Octuple;
use crate::formula::proof::{ProvedElement, Rubbed, Step};
use crate::formula::quantity::{Domain, Unit};
use crate::formula::{Field, Fields, Spec, WIDTH};
use crate::toolkit::verify::Sensitivity;
use crate::toolkit::verify::jet::Sweep;
use crate::toolkit::verify::point::names;
use crate::toolkit::verify::sample::Sampler;
use crate::toolkit::verify::subject::Subject;
use nalgebra::{Const, DMatrix, DVector, SVector, U1};
use num_dual::Derivative;
use num_traits::{One, Signed, Zero};

/// The order of an element's numbers: its inputs, and the rows and columns of its results.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layout {
    /// The degrees of freedom.
    pub unknowns: &'static [Field],
    /// The forces and moments on them.
    pub forces: &'static [Field],
    /// The residuals.
    pub residuals: &'static [Field],
    /// The multipliers of the residuals.
    pub multipliers: &'static [Field],
    /// Positions and orientations of the nodes.
    pub nodes: &'static [Field],
    /// Measurements in the initial configuration.
    pub start: &'static [Field],
    /// Parameters of friction; empty if it has none.
    pub contact: &'static [Field],
    /// The state of friction.
    pub state: &'static [Field],
    /// The number of slave nodes at each of which the same is done, or 1.
    pub slaves: usize,
}

/// Residuals, rows, forces, stiffness, derivative with respect to the multipliers; the state follows.
const PARTS: usize = 5;

/// The number of components.
pub(super) fn count(fields: &[Field]) -> usize {
    fields.iter().map(Field::len).sum()
}

impl Layout {
    pub(crate) fn of<E: ProvedElement<M, DOFS>, const M: usize, const DOFS: usize>() -> Self {
        let layout = Self {
            unknowns: E::UNKNOWNS,
            forces: E::FORCES,
            residuals: E::RESIDUALS,
            multipliers: E::MULTIPLIERS,
            nodes: <E::Nodes<f64> as Fields<f64>>::FIELDS,
            start: <E::Start<f64> as Fields<f64>>::FIELDS,
            contact: <E::Contact<f64> as Fields<f64>>::FIELDS,
            state: <E::State<f64> as Fields<f64>>::FIELDS,
            slaves: E::SLAVES,
        };
        let counts = [layout.unknowns, layout.forces, layout.residuals].map(count);
        let (id, held) = (E::SPEC.id, layout.held());
        assert_eq!(counts, [DOFS, DOFS, M], "{id}: a name for every unknown, force and residual");
        assert!(held == M || held == 0, "{id}: a name for every multiplier");
        layout
    }

    pub(super) fn degrees(&self) -> usize {
        count(self.unknowns)
    }

    pub(super) fn conditions(&self) -> usize {
        count(self.residuals)
    }

    /// The number of conditions that are held by multipliers: all or none.
    pub(super) fn held(&self) -> usize {
        count(self.multipliers)
    }

    /// Whether the model is axisymmetric, so that its only rigid-body motion is along the axis.
    pub(super) fn is_axisymmetric(&self) -> bool {
        self.nodes.iter().any(|field| field.quantity.domain == Domain::Meridian)
    }

    /// The results as matrices.
    pub(crate) fn part<T: nalgebra::Scalar>(&self, results: &[T]) -> Found<T> {
        let (n, m) = (self.degrees(), self.conditions());
        let mut rest = results;
        let mut next = |rows: usize, columns: usize| {
            let (part, tail) = rest.split_at(rows * columns);
            rest = tail;
            DMatrix::from_row_slice(rows, columns, part)
        };
        Found {
            residuals: next(m, 1).column(0).into_owned(),
            rows: next(m, n),
            forces: next(n, 1).column(0).into_owned(),
            stiffness: next(n, n),
            by_multipliers: next(n, self.held()),
            after: rest.to_vec(),
        }
    }

    pub(super) fn names(&self) -> Names {
        let blocks = |fields: &[Field]| {
            fields.iter().enumerate().flat_map(|(k, field)| vec![k; field.len()]).collect::<Vec<_>>()
        };
        let [unknowns, forces, residuals, multipliers] =
            [self.unknowns, self.forces, self.residuals, self.multipliers].map(names);
        let variables = [unknowns, multipliers].concat();
        let (mut results, mut kinds) = (Vec::new(), Vec::new());
        let parts: [_; PARTS] = [
            (&residuals, self.residuals, None),
            (&residuals, self.residuals, Some((0, self.unknowns))),
            (&forces, self.forces, None),
            (&forces, self.forces, Some((0, self.unknowns))),
            (&forces, self.forces, Some((self.degrees(), self.multipliers))),
        ];
        for (part, (rows, fields, by)) in parts.into_iter().enumerate() {
            for (row, block) in rows.iter().zip(blocks(fields)) {
                let Some((first, by)) = by else {
                    results.push(row.clone());
                    kinds.push([part, block, 0]);
                    continue;
                };
                for (column, across) in blocks(by).into_iter().enumerate() {
                    results.push(format!("∂{row}/∂{}", variables[first + column]));
                    kinds.push([part, block, across]);
                }
            }
        }
        for (name, block) in names(self.state).into_iter().zip(blocks(self.state)) {
            results.push(format!("{name} after"));
            kinds.push([PARTS, block, 0]);
        }
        Names { residuals, forces, variables, results, blocks: kinds }
    }

    /// The units of degrees of freedom and multipliers.
    pub(super) fn units_of_variables(&self) -> Vec<Unit> {
        [self.unknowns, self.multipliers]
            .concat()
            .iter()
            .flat_map(|field| vec![field.quantity.unit; field.len()])
            .collect()
    }
}

/// Names of components.
pub(super) struct Names {
    pub(super) residuals: Vec<String>,
    pub(super) forces: Vec<String>,
    /// Degrees of freedom, then multipliers.
    pub(super) variables: Vec<String>,
    pub(super) results: Vec<String>,
    /// The part, row block and column block of each result.
    pub(super) blocks: Vec<[usize; 3]>,
}

impl Names {
    pub(super) fn conditions_and_forces(&self, k: usize) -> &str {
        let conditions = self.residuals.len();
        if k < conditions { &self.residuals[k] } else { &self.forces[k - conditions] }
    }
}

/// The results as matrices.
pub(crate) struct Found<T = Octuple> {
    pub(crate) residuals: DVector<T>,
    pub(crate) rows: DMatrix<T>,
    pub(crate) forces: DVector<T>,
    pub(crate) stiffness: DMatrix<T>,
    pub(crate) by_multipliers: DMatrix<T>,
    pub(crate) after: Vec<T>,
}

impl Found {
    /// Residuals, rows, forces, stiffness and derivative with respect to the multipliers.
    pub(super) fn matrices(&self) -> [Matrix; 5] {
        let Self { residuals, rows, forces, stiffness, by_multipliers, .. } = self;
        [column(residuals), rows.clone(), column(forces), stiffness.clone(), by_multipliers.clone()]
    }
}

/// An element with or without friction.
pub(crate) struct Form {
    pub(crate) rubs: bool,
    pub(crate) subject: Subject,
    pub(super) has_exact_rows: bool,
    pub(super) held: fn(&[Octuple]) -> Vec<Octuple>,
    /// The derivative of the inputs with respect to a degree of freedom.
    motion: fn(&[Octuple], usize) -> Vec<Octuple>,
    /// The friction forces, from the inputs and the state after the step.
    rubbed: fn(&[Number], &[Number]) -> Vec<Rubbed<Number>>,
    /// The virtual work of the loads of an element without multipliers, from the same.
    work: fn(&[Number], &[Number]) -> Number,
}

/// A number with derivatives along a few directions.
type Number = Sweep<Octuple>;

impl Form {
    pub(super) fn of<E: ProvedElement<M, DOFS>, const M: usize, const DOFS: usize, const RUBS: bool>() -> Self {
        Self {
            rubs: RUBS,
            subject: Subject::of_element::<E, M, DOFS, RUBS>(),
            has_exact_rows: E::EXACT_ROWS,
            held: |i| E::held(Step::of(i, RUBS)).components(),
            motion: |i, degree| {
                let still: Vec<_> = i.iter().map(|&x| Sweep::from_re(x)).collect();
                let step = Step::<E, _, M, DOFS>::of(&still, RUBS);
                let motions = SVector::from_fn(|k, _| {
                    let zero = Sweep::from_re(Octuple::zero());
                    if k == degree { zero.derivative(0) } else { zero }
                });
                let moved = Step { nodes: E::moved(&step.nodes, &motions), ..step };
                moved.components().iter().map(|x| slope(x, 0)).collect()
            },
            rubbed: |i, after| E::rubbed(&Step::of(i, RUBS), &state(after)),
            work: |i, after| E::work(&Step::of(i, RUBS), &state(after)),
        }
    }

    /// All exact results at a point.
    pub(super) fn at(&self, layout: &Layout, inputs: Vec<Octuple>) -> Here {
        let values = (self.subject.exact_value)(&inputs);
        let gradients = self.subject.derivative(&inputs);
        let sizes = gradients.chunks(inputs.len()).zip(&values);
        let scales: Vec<_> =
            sizes.map(|(gradient, &value)| Sensitivity::new(gradient, &inputs).plus(value).size()).collect();
        let directions = self.directions(layout, &inputs);
        let (n, m, all) = (layout.degrees(), layout.conditions(), directions.len());
        // By the chain rule, which takes less time than another sweep through the element.
        let along = |result: usize, direction: &[Octuple]| {
            let gradient = &gradients[result * inputs.len()..][..inputs.len()];
            let moving = gradient.iter().zip(direction).filter(|(_, by)| !by.is_zero());
            moving.fold(Octuple::zero(), |sum, (&slope, &by)| sum + slope * by)
        };
        let slopes = |first: usize, count: usize| Matrix::from_fn(count, all, |k, d| along(first + k, &directions[d]));
        let (first_after, states) = (values.len() - count(layout.state), count(layout.state));
        let (mut motions, mut rubbed, mut work) = (Vec::new(), Vec::new(), Vec::new());
        for few in directions.chunks(WIDTH) {
            let seeded: Vec<_> = inputs.iter().enumerate().map(|(k, &x)| seed(x, few, k)).collect();
            // Without friction there is no state.
            let after: Vec<_> = (0..states)
                .map(|k| {
                    if !self.rubs {
                        return Sweep::from_re(Octuple::zero());
                    }
                    let none: &[_] = &[];
                    sweep(values[first_after + k], |d| along(first_after + k, few.get(d).map_or(none, Vec::as_slice)))
                })
                .collect();
            let frictions = if self.rubs { (self.rubbed)(&seeded, &after) } else { Vec::new() };
            let loads = (self.work)(&seeded, &after);
            for direction in 0..few.len() {
                work.push(slope(&loads, direction));
                motions.extend(frictions.iter().map(|friction| slope(&friction.motion, direction)));
            }
            rubbed = frictions.iter().map(real_part).collect();
        }
        let motions = Matrix::from_vec(rubbed.len(), all, motions);
        let derivative = Derivatives {
            residuals: slopes(0, m),
            forces: slopes(m + m * n, n),
            motions: motions.columns(0, n).into_owned(),
            work: Vector::from_vec(work[..n].to_vec()),
        };
        let multipliers = Vector::from_column_slice(&inputs[count(layout.nodes)..][..layout.held()]);
        let (found, sizes) = (layout.part(&values), layout.part(&scales));
        Here { inputs, directions, multipliers, results: values, scales, found, sizes, derivative, rubbed }
    }

    /// The results alone.
    pub(super) fn at_values(&self, layout: &Layout, inputs: &[Octuple]) -> Found {
        layout.part(&(self.subject.exact_value)(inputs))
    }

    /// The derivatives of the inputs with respect to every degree of freedom and every multiplier.
    fn directions(&self, layout: &Layout, inputs: &[Octuple]) -> Vec<Vec<Octuple>> {
        let first = count(layout.nodes);
        let multiplier = |m: usize| {
            let one = |k| if k == first + m { Octuple::one() } else { Octuple::zero() };
            (0..inputs.len()).map(one).collect()
        };
        let degrees = (0..layout.degrees()).map(|degree| (self.motion)(inputs, degree));
        degrees.chain((0..layout.held()).map(multiplier)).collect()
    }

    /// The derivatives of residuals and forces along a motion of everything, by differences and by automatic
    /// differentiation, and the sizes they are judged by.
    pub(super) fn along(&self, layout: &Layout, here: &Here, label: &str) -> [Vec<Octuple>; 3] {
        let mut sampler = Sampler::named(&format!("{} along {label}", self.subject.spec.id), 0);
        let Here { inputs, directions, .. } = here;
        let reach = largest(inputs[..count(layout.nodes)].iter().copied());
        let loads = largest(here.multipliers.iter().copied());
        let way: Vec<_> = layout
            .units_of_variables()
            .iter()
            .enumerate()
            .map(|(k, unit)| {
                let part = Octuple::from(if sampler.coin() { 0.5 } else { -0.5 } * (1.0 + sampler.unit()));
                let size = if k >= layout.degrees() {
                    loads
                } else if *unit == Unit::L {
                    reach
                } else {
                    Octuple::one()
                };
                part * size
            })
            .collect();
        let moves = (0..inputs.len())
            .map(|i| directions.iter().zip(&way).fold(Octuple::zero(), |sum, (d, &w)| sum + d[i] * w))
            .collect::<Vec<_>>();
        let (n, m) = (layout.degrees(), layout.conditions());
        let values = |steps: Octuple| {
            let moved: Vec<_> = inputs.iter().zip(&moves).map(|(&x, &by)| x + by * steps).collect();
            let found = layout.part(&(self.subject.exact_value)(&moved));
            [found.residuals.as_slice(), found.forces.as_slice()].concat()
        };
        let way = Vector::from_vec(way);
        let expected =
            [(&here.derivative.residuals * &way).as_slice(), (&here.derivative.forces * &way).as_slice()].concat();
        let scales: Vec<_> = here
            .sizes
            .residuals
            .iter()
            .chain(here.sizes.forces.iter())
            .zip(&expected)
            .map(|(&scale, &slope)| scale + slope.abs())
            .collect();
        let attempt = |step: f64| {
            let h = Octuple::from(step);
            let [far_below, below, above, far_above] = [-2.0, -1.0, 1.0, 2.0].map(|steps| values(h * steps));
            (0..m + n)
                .map(|k| ((above[k] - below[k]) * 8.0 - (far_above[k] - far_below[k])) / (h * 12.0))
                .collect::<Vec<_>>()
        };
        let is_near = |found: &[Octuple]| {
            found
                .iter()
                .zip(&expected)
                .zip(&scales)
                .all(|((&found, &expected), &scale)| (found - expected).abs() <= scale * DIFFERENCES)
        };
        let first = attempt(3e-19);
        let found = if is_near(&first) { first } else { attempt(1e-26) };
        [found, expected, scales]
    }
}

fn real_part(rubbed: &Rubbed<Sweep<Octuple>>) -> Rubbed<Octuple> {
    let Rubbed { motion, force: [before, after], k_stick, phi } = rubbed;
    Rubbed { motion: motion.re, force: [before.re, after.re], k_stick: k_stick.re, phi: phi.re }
}

/// The derivative along a direction.
fn slope(x: &Sweep<Octuple>, direction: usize) -> Octuple {
    x.eps.unwrap_generic(Const::<WIDTH>, U1)[direction]
}

/// The k-th input, with its derivatives along these directions.
fn seed(x: Octuple, directions: &[Vec<Octuple>], k: usize) -> Sweep<Octuple> {
    sweep(x, |d| directions.get(d).map_or_else(Octuple::zero, |direction| direction[k]))
}

/// A number with these derivatives.
fn sweep(x: Octuple, along: impl Fn(usize) -> Octuple) -> Sweep<Octuple> {
    Sweep::new(x, Derivative::some(SVector::from_fn(|d, _| along(d))))
}

/// Derivatives with respect to the degrees of freedom and the multipliers.
pub(super) struct Derivatives {
    pub(super) residuals: Matrix,
    pub(super) forces: Matrix,
    /// The derivatives of the displacements against which friction acts, with respect to the degrees of freedom.
    motions: Matrix,
    /// The derivative of the virtual work of the loads with respect to the degrees of freedom.
    work: Vector,
}

/// The state of these components.
fn state<X: Fields<Number>>(components: &[Number]) -> X {
    let mut rest = components.iter().copied();
    X::from_components(&mut || rest.next().expect("the state after was computed"))
}

/// The exact results at a point.
pub(super) struct Here {
    pub(super) inputs: Vec<Octuple>,
    /// The derivatives of the inputs with respect to every degree of freedom and every multiplier.
    directions: Vec<Vec<Octuple>>,
    multipliers: Vector,
    pub(super) results: Vec<Octuple>,
    /// For every result, its sensitivity to the inputs plus its own size.
    pub(super) scales: Vec<Octuple>,
    /// Both as matrices.
    pub(super) found: Found,
    pub(super) sizes: Found,
    pub(super) derivative: Derivatives,
    pub(super) rubbed: Vec<Rubbed<Octuple>>,
}

impl Here {
    /// rowsᵀ λ, and the friction forces against their motions; without multipliers, the derivative of the virtual work.
    pub(super) fn work(&self) -> Vector {
        if self.multipliers.is_empty() {
            return self.derivative.work.clone();
        }
        let frictions = Vector::from_iterator(self.rubbed.len(), self.rubbed.iter().map(|rubbed| rubbed.force[1]));
        self.found.rows.transpose() * &self.multipliers - self.derivative.motions.transpose() * frictions
    }
}

/// An element with its types erased.
pub(crate) struct ElementSubject {
    pub(crate) spec: Spec,
    pub(crate) layout: Layout,
    /// Without friction, and with friction if it can have any.
    pub(crate) forms: Vec<Form>,
}

impl ElementSubject {
    pub(crate) fn of<E: ProvedElement<M, DOFS>, const M: usize, const DOFS: usize>() -> Self {
        let rubs = !<E::Contact<f64> as Fields<f64>>::FIELDS.is_empty();
        let mut forms = vec![Form::of::<E, M, DOFS, false>()];
        if rubs {
            forms.push(Form::of::<E, M, DOFS, true>());
        }
        Self { spec: E::SPEC, layout: Layout::of::<E, M, DOFS>(), forms }
    }
}
