//! An element in another form: with rigid arms, by other unknowns of rotations, with penalties instead of multipliers.
//!
//! What makes a form is the library's: [`Contribution::on_arms`], [`Contribution::by_rotation_vectors`] and its like, and the
//! multipliers and the stiffness of [`Parameters::penalised`](crate::element::Parameters::penalised), in this order. Here are the
//! additional inputs, and the names of the unknowns.

use super::form::{ARMS, AnyForm, Form, PENALTIES, Rotations};
use super::formulas::{count, expect};
use crate::Error;
use crate::element::offset::Arms;
use crate::element::{Contribution, Element, Nodes, nodes};
use crate::formula::proof::{Case, Flag, ProvedElement, Step};
use crate::formula::{Field, Fields, Spec};
use crate::number::scalar::Scalar;
use crate::toolkit::graph::{Extremes, Graph, NotRecorded, record_step};
use crate::toolkit::verify::{Layout, Sampler, golden};
use nalgebra::{SMatrix, SVector, Vector3, Vector4};
use std::marker::PhantomData;

/// An element in a form.
pub(super) struct Formed<E, const M: usize, const DOFS: usize> {
    element: Box<dyn AnyForm>,
    form: Form,
    /// That of the element.
    own: Layout,
    layout: Layout,
    /// Without and with friction.
    inputs: [&'static [Field]; 2],
    of: PhantomData<E>,
}

/// What an element in a form computes from.
struct Given<E: Element<M, DOFS>, D: Scalar, const M: usize, const DOFS: usize> {
    /// At the points of the connector.
    step: Step<E, D, M, DOFS>,
    arms: Option<Arms<D>>,
    /// The unknowns of the rotations of both nodes.
    rotations: Vec<D>,
    penalties: Option<SVector<D, M>>,
}

impl<E: ProvedElement<M, DOFS>, const M: usize, const DOFS: usize> Formed<E, M, DOFS> {
    pub(super) fn new(element: Box<dyn AnyForm>, form: Form) -> Result<Self, &'static str> {
        let own = element.layout();
        let is_in_space = own.unknowns == nodes::UNKNOWNS && own.nodes == <Nodes<f64> as Fields<f64>>::FIELDS;
        if !is_in_space && (form.has_arms || form.rotations != Rotations::Spins) {
            return Err("arms and other unknowns of rotations need two nodes in space, each with a triad");
        }
        if form.has_penalties && own.multipliers.is_empty() {
            return Err("it has no multipliers that penalties could replace");
        }
        let mut layout = own;
        let arms = if form.has_arms { ARMS } else { &[] };
        let mut rotations: &[Field] = &[];
        if let Some([unknowns, moments]) = form.of_rotations() {
            let of_nodes = |translations: &[Field], of: &'static [Field]| {
                let (a, b) = of.split_at(of.len() / 2);
                kept(&[&translations[..1], a, &translations[2..3], b])
            };
            layout.unknowns = of_nodes(own.unknowns, unknowns);
            layout.forces = of_nodes(own.forces, moments);
            rotations = unknowns;
        }
        layout.nodes = kept(&[own.nodes, arms, rotations]);
        if form.has_penalties {
            let is_needed = |kappa: &Field| own.residuals.iter().any(|residual| Form::penalty(residual) == *kappa);
            let penalties: Vec<_> = PENALTIES.into_iter().filter(is_needed).collect();
            layout.start = kept(&[own.start, &penalties]);
            layout.multipliers = &[];
        }
        let smooth = kept(&[layout.nodes, layout.multipliers, layout.start]);
        let inputs = [smooth, kept(&[smooth, layout.contact, layout.state])];
        Ok(Self { element, form, own, layout, inputs, of: PhantomData })
    }

    fn given<D: Scalar>(&self, components: &[D], rubs: bool) -> Given<E, D, M, DOFS> {
        let Self { form, own, layout, .. } = self;
        let mut rest = components;
        let mut next = |number: usize| {
            let (part, tail) = rest.split_at(number);
            rest = tail;
            part
        };
        let mut nodes = next(count(own.nodes)).to_vec();
        let arms = form.has_arms.then(|| Arms { a: vector(next(3)), b: vector(next(3)) });
        let rotations = next(form.of_rotations().map_or(0, |[unknowns, _]| count(unknowns))).to_vec();
        let multipliers = next(count(layout.multipliers)).to_vec();
        let eliminated = vec![D::zero(); count(own.multipliers) - multipliers.len()];
        let start = next(count(own.start)).to_vec();
        let added = &layout.start[own.start.len()..];
        let kappas = next(added.len());
        let penalties = form.has_penalties.then(|| {
            let of = |residual: &Field| {
                let (_, &kappa) = added.iter().zip(kappas).find(|(field, _)| **field == Form::penalty(residual))?;
                Some(vec![kappa; residual.len()])
            };
            SVector::from_iterator(
                own.residuals.iter().flat_map(|residual| of(residual).expect("its penalty is an input")),
            )
        });
        if let (Some(arms), Some(at)) = (&arms, Nodes::from_slice(&nodes)) {
            nodes = Nodes { xa: at.xa + arms.a, xb: at.xb + arms.b, ..at }.components();
        }
        let step = Step::of(&[&nodes, &multipliers, &eliminated, &start, rest].concat(), rubs);
        Given { step, arms, rotations, penalties }
    }

    fn validate<D: Scalar>(&self, components: &[D], rubs: bool) -> Result<(), Error> {
        let Step { nodes, parameters, .. } = self.given(components, rubs).step;
        E::validate(&nodes, &parameters)
    }

    fn results<D: Scalar>(&self, components: &[D], rubs: bool) -> Vec<D> {
        let Given { step, arms, rotations, penalties } = self.given(components, rubs);
        let Step { nodes, mut multipliers, parameters, before } = step;
        if let Some(penalties) = &penalties {
            multipliers = parameters.penalty_multipliers(&nodes, &multipliers, penalties);
        }
        let (found, after) = parameters.contribution(&nodes, &multipliers, &before);
        let penalties = penalties.as_ref();
        let at_nodes = || {
            let found = in_space(&found);
            arms.as_ref().map_or(found, |arms| found.on_arms(arms))
        };
        let mut all = match self.form.rotations {
            Rotations::Spins if arms.is_none() => self.in_order(found, penalties),
            Rotations::Spins => self.in_order(at_nodes(), penalties),
            Rotations::Vectors => {
                self.in_order(at_nodes().by_rotation_vectors([0, 3].map(|k| vector(&rotations[k..k + 3]))), penalties)
            }
            Rotations::EulerParameters => {
                let q = [0, 4].map(|k| Vector4::from_column_slice(&rotations[k..k + 4]));
                self.in_order(at_nodes().by_euler_parameters(q), penalties)
            }
        };
        if rubs {
            all.extend(after.components());
        }
        all
    }

    fn in_order<D: Scalar, const N: usize>(
        &self,
        mut found: Contribution<D, M, N>,
        penalties: Option<&SVector<D, M>>,
    ) -> Vec<D> {
        if let Some(penalties) = penalties {
            found.stiffness = found.stiffness_with(penalties);
        }
        let mut all = Vec::new();
        found.for_each(count(self.layout.multipliers), &mut |x| all.push(x));
        all
    }
}

/// The same where the type does not say that the degrees of freedom are twelve.
fn in_space<D: Scalar, const M: usize, const DOFS: usize>(found: &Contribution<D, M, DOFS>) -> Contribution<D, M> {
    Contribution {
        residuals: found.residuals,
        rows: SMatrix::from_fn(|row, column| found.rows[(row, column)]),
        forces: SVector::from_fn(|row, _| found.forces[row]),
        stiffness: SMatrix::from_fn(|row, column| found.stiffness[(row, column)]),
        by_multipliers: SMatrix::from_fn(|row, column| found.by_multipliers[(row, column)]),
    }
}

fn vector<D: Scalar>(components: &[D]) -> Vector3<D> {
    Vector3::from_column_slice(components)
}

/// Lists of fields as one, which is kept while the process runs.
fn kept(lists: &[&[Field]]) -> &'static [Field] {
    Vec::leak(lists.concat())
}

impl<E: ProvedElement<M, DOFS>, const M: usize, const DOFS: usize> AnyForm for Formed<E, M, DOFS> {
    fn spec(&self) -> Spec {
        E::SPEC
    }
    fn form(&self) -> Form {
        self.form
    }
    fn layout(&self) -> Layout {
        self.layout
    }
    fn inputs(&self, rubs: bool) -> &'static [Field] {
        self.inputs[usize::from(rubs)]
    }
    /// Those of the element, with drawn numbers for what the form adds.
    fn cases(&self, rubs: bool, random: usize) -> Vec<Case<Vec<f64>>> {
        let (inputs, own) = (self.inputs(rubs), self.element.inputs(rubs));
        let added: Vec<_> = inputs.iter().filter(|field| !own.contains(field)).copied().collect();
        let mut sampler = Sampler::named(&self.name(), 0);
        let in_form = |case: Case<Vec<f64>>| {
            let drawn = sampler.fields(&added);
            let component = |field: &Field| {
                let of = |fields: &[Field], all: &[f64]| {
                    let range = Field::ranges(fields).zip(fields).find(|(_, one)| *one == field)?.0;
                    Some(all[range].to_vec())
                };
                of(own, &case.inputs).or_else(|| of(&added, &drawn)).expect("a field is the element's, or added")
            };
            Case { inputs: inputs.iter().flat_map(component).collect(), ..case }
        };
        let valid = self.element.cases(rubs, random).into_iter().filter(|case| case.flag != Flag::Invalid);
        let mut cases: Vec<_> = valid.map(in_form).collect();
        cases.extend(golden::out_of_domain(inputs, &cases[0].inputs));
        cases
    }
    fn graph(&self, rubs: bool, extremes: Extremes) -> Result<Graph, NotRecorded> {
        let validate = |inputs: &[_]| self.validate(inputs, rubs);
        record_step(self.inputs(rubs), extremes, &validate, &|inputs| self.results(inputs, rubs))
    }
    fn value(&self, components: &[f64], rubs: bool) -> Result<Vec<f64>, Error> {
        let inputs = self.inputs(rubs);
        expect(count(inputs), components.len())?;
        for (range, field) in Field::ranges(inputs).zip(inputs) {
            for (k, &x) in components[range].iter().enumerate() {
                Error::check(field.name, (field.len() > 1).then_some(k), x, field.quantity.domain)?;
            }
        }
        self.validate(components, rubs)?;
        let results = self.results(components, rubs);
        let is_finite =
            results[..results.len() - if rubs { count(self.layout.state) } else { 0 }].iter().all(|x| x.is_finite());
        if is_finite { Ok(results) } else { Err(Error::Overflow { name: "contribution" }) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Octuple;
    use crate::catalog::Erased;
    use crate::connector::slot::SlotElement;
    use crate::connector::translator::TranslatorElement;
    use crate::contact::interaction::PressureLinear;
    use crate::contact::slide_line::element::Isl21aElement;
    use crate::element::rotation::proof::{from_euler, rodrigues};
    use nalgebra::{Matrix3, Vector2};
    use num_dual::Dual;

    type Moving = Dual<Octuple>;
    type Translator = Formed<TranslatorElement, 5, 12>;

    fn formed<E: ProvedElement<M, DOFS>, const M: usize, const DOFS: usize>(e: E, form: Form) -> Formed<E, M, DOFS> {
        Formed::new(Box::new(Erased(e)), form).unwrap()
    }

    #[test]
    fn penalties_are_those_of_the_library() {
        let form = formed::<_, 2, 12>(SlotElement, Form { has_penalties: true, ..Form::default() });
        assert_eq!(form.name(), "slot_penalty");
        let case = form.cases(true, 1).remove(0);
        let Step { nodes, parameters, before, .. } = form.given::<f64>(&case.inputs, true).step;
        let kappa = case.inputs[Field::ranges(form.inputs(true))
            .zip(form.inputs(true))
            .find(|(_, field)| field.name == "kappa")
            .unwrap()
            .0
            .start];
        assert!(kappa > 0.0);
        let (penalised, after) =
            parameters.penalised(&nodes, &Vector2::zeros(), &Vector2::from_element(kappa), &before);
        let (held, _) = parameters.contribution(&nodes, &Vector2::zeros(), &before);
        let found = form.layout.part(&form.value(&case.inputs, true).unwrap());
        assert_eq!((found.forces.as_slice(), found.after), (penalised.forces.as_slice(), after.components()));
        assert_eq!(found.stiffness.as_slice(), penalised.stiffness.as_slice());
        assert_eq!(
            (found.residuals.as_slice(), found.rows.as_slice()),
            (held.residuals.as_slice(), held.rows.as_slice())
        );
        assert_eq!(penalised.multipliers, -held.residuals * kappa);
    }

    /// The inputs of TRANSLATOR in a form whose unknowns have these values: triads and arms rotate with the nodes.
    fn inputs<D: Scalar<Leaf = Octuple>>(form: &Translator, unknowns: &[D]) -> Vec<D> {
        let exact = |numbers: &[f64]| numbers.iter().map(|&x| D::from(x)).collect::<Vec<_>>();
        let half = unknowns.len() / 2;
        let turns = [0, 1].map(|node| {
            let of = &unknowns[half * node + 3..half * (node + 1)];
            if let [q0, x, y, z] = of {
                let length = of.iter().fold(D::zero(), |sum, &x| sum + x * x).sqrt();
                from_euler(*q0 / length, &(Vector3::new(*x, *y, *z) / length))
            } else {
                rodrigues(&vector(of))
            }
        });
        let turned = |turn: &Matrix3<D>, axes: [[f64; 3]; 3]| axes.map(|e| *turn * vector(&exact(&e)));
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let arms = [[0.5, -1.0, 0.25], [-0.25, 0.75, 1.5]];
        let mut all: Vec<D> = turns.iter().flat_map(|turn| turned(turn, axes)).flat_map(|e| [e.x, e.y, e.z]).collect();
        all.extend([&unknowns[..3], &unknowns[half..half + 3]].concat());
        let arms = turns.iter().zip(arms).map(|(turn, arm)| turned(turn, [arm; 3])[0]);
        all.extend(arms.flat_map(|arm| [arm.x, arm.y, arm.z]));
        all.extend([&unknowns[3..half], &unknowns[half + 3..]].concat());
        // Initial measurements, penalties, friction, and its state.
        let numbers = [0.125, 0.25, -0.5, 0.4, 0.2, -0.6, 100.0, 30.0, 1e3, 0.25, 2.0, 1.0, 0.25, 0.5, -0.25];
        all.extend(exact(&numbers));
        assert_eq!(all.len(), count(form.inputs(true)));
        all
    }

    /// In all forms together, which are their own derivative: rows that of the residuals, the stiffness that of the forces.
    #[test]
    fn in_every_form_it_is_its_own_derivative() {
        let euler = [([2.0, 3.0, 6.0, 0.0], 7.0), ([4.0, -4.0, 7.0, 0.0], 9.0)]
            .map(|(q, length)| q.map(|x: f64| Octuple::from(x) / Octuple::from(length)));
        let psi = [[0.5, -1.0, 0.25], [1.5, 0.5, -1.0]].map(|psi| psi.map(Octuple::from));
        let places = [[1.0, 2.0, 3.0], [2.5, 2.25, 4.0]].map(|x| x.map(Octuple::from));
        let of = |turns: [&[Octuple]; 2]| [&places[0], turns[0], &places[1], turns[1]].concat();
        for (rotations, unknowns) in
            [(Rotations::Vectors, of([&psi[0], &psi[1]])), (Rotations::EulerParameters, of([&euler[0], &euler[1]]))]
        {
            let form: Translator = formed(TranslatorElement, Form { has_arms: true, rotations, has_penalties: true });
            let found = form.layout.part(&form.results(&inputs(&form, &unknowns), true));
            for k in 0..unknowns.len() {
                let moving: Vec<_> = unknowns
                    .iter()
                    .enumerate()
                    .map(|(j, &x)| Moving::new(x, Octuple::from(if j == k { 1.0 } else { 0.0 })))
                    .collect();
                let moved = form.layout.part(&form.results(&inputs(&form, &moving), true));
                let pairs = [(&moved.residuals, found.rows.column(k)), (&moved.forces, found.stiffness.column(k))];
                for (moved, found) in pairs {
                    for (moved, &found) in moved.iter().zip(&found) {
                        let off = (moved.eps - found).to_f64().abs();
                        assert!(off < 1e-55, "{rotations:?}, {k}: {off:e}");
                    }
                }
            }
        }
    }

    #[test]
    fn what_a_form_needs_is_told() {
        let ring = Erased::<Isl21aElement<PressureLinear>, 1, 12>(Isl21aElement::ELEMENT);
        let why = |form| Formed::<Isl21aElement<PressureLinear>, 1, 12>::new(Box::new(ring), form).err().unwrap();
        assert_eq!(
            why(Form { has_penalties: true, ..Form::default() }),
            "it has no multipliers that penalties could replace"
        );
        assert!(why(Form { has_arms: true, ..Form::default() }).starts_with("arms and other unknowns"));
        assert!(why(Form { rotations: Rotations::Vectors, ..Form::default() }).starts_with("arms and other unknowns"));
    }
}
