//! The mechanical laws of an element.

use super::compare::{EXACT, largest, record};
use super::form::{ElementSubject, Form, Here, Layout, count};
use super::linear::{Matrix, Vector, column, dot, independence};
use crate::Octuple;
use crate::formula::Field;
use crate::formula::proof::Rubbed;
use crate::formula::quantity::{Domain, Unit};
use crate::toolkit::verify::claim::Claim;
use crate::toolkit::verify::invariance::{moved, reach, rescale};
use crate::toolkit::verify::point::Point;
use num_traits::{One, Signed, Zero};

/// Rows whose independent part is smaller than this are redundant.
const DEPENDENT: f64 = 1e-40;

/// The claims.
pub(super) struct Laws {
    balance: Claim,
    indifference: Option<Claim>,
    homogeneity: Claim,
    rank: Option<Claim>,
    symmetry: Option<Claim>,
    friction: Option<[Claim; 3]>,
    sticks_and_slips: [usize; 2],
}

impl Laws {
    pub(super) fn new(element: &ElementSubject) -> Self {
        let claim = |words: &str| Claim::new(words, EXACT);
        let exact_rows = element.forms.iter().all(|form| form.has_exact_rows);
        let (holds, axial) = (element.layout.held() > 0, element.layout.is_axisymmetric());
        let rubs = element.forms.iter().any(|form| form.rubs);
        Self {
            balance: claim(if axial {
                "forces do no work in a motion along the axis, and nor do residuals change"
            } else {
                "forces do no work in a rigid-body motion, and nor do residuals change"
            }),
            indifference: element.spec.objective.then(|| {
                claim(if axial {
                    "frame indifference: where the model is moved along the axis, forces and matrix remain"
                } else {
                    "frame indifference: if the model is moved and rotated, forces and matrix rotate with it"
                })
            }),
            homogeneity: claim("dimensional homogeneity: other base units only rescale every number"),
            rank: holds.then(|| Claim::new("no condition is held twice: rows are independent", 1.0 / DEPENDENT)),
            symmetry: (exact_rows && holds).then(|| {
                claim("without friction K − Kᵀ = −[m×] where a node's own spin works on its moment, 0 elsewhere")
            }),
            friction: rubs.then(|| {
                [
                    claim("the yield function is at most 0"),
                    claim("it slips only where the yield function is 0"),
                    claim("friction costs work: force times slip is at least 0"),
                ]
            }),
            sticks_and_slips: [0; 2],
        }
    }

    pub(super) fn all(self) -> Vec<Claim> {
        let mut all = vec![self.balance, self.homogeneity];
        all.extend(self.rank);
        all.extend(self.indifference);
        all.extend(self.symmetry);
        if let Some(friction) = self.friction {
            let mut seen = Claim::new("points in stick and in slip were both seen", 0.0);
            for (count, what) in self.sticks_and_slips.into_iter().zip(["in stick", "in slip"]) {
                seen.count(if count > 0 { 0.0 } else { 1.0 }, 0.0);
                if count == 0 {
                    seen.fail(format!("no point was {what}"));
                }
            }
            all.extend(friction);
            all.push(seen);
        }
        all
    }

    pub(super) fn check(&mut self, layout: &Layout, form: &Form, point: &Point, here: &Here, held: &Here) {
        self.check_balance(layout, point, held);
        self.check_indifference(layout, form, point, here);
        self.check_homogeneity(layout, form, point, here);
        if let Some(rank) = &mut self.rank {
            let independent = independence(&here.found.rows);
            rank.record(independent.recip(), 1.0 / DEPENDENT, |size| {
                point.deviation(size, "rows".into(), independent, 1.0)
            });
        }
        if let Some(claim) = self.symmetry.as_mut().filter(|_| !form.rubs) {
            check_symmetry(claim, layout, point, here);
        }
        if form.rubs {
            self.check_friction(point, here);
        }
    }

    /// Checks the balance in rigid-body motions about the first node.
    fn check_balance(&mut self, layout: &Layout, point: &Point, held: &Here) {
        for motion in rigid_motions(layout, &held.inputs) {
            let work = dot(motion.as_slice(), held.found.forces.as_slice());
            let terms = motion
                .iter()
                .zip(&held.sizes.forces)
                .fold(Octuple::zero(), |sum, (&by, &force)| sum + by.abs() * force);
            record(&mut self.balance, point, || "work".into(), [work, Octuple::zero()], terms);
            for (row, size) in held.found.rows.row_iter().zip(held.sizes.rows.row_iter()) {
                let change = dot(motion.as_slice(), row.transpose().as_slice());
                let terms =
                    motion.iter().zip(size.iter()).fold(Octuple::zero(), |sum, (&by, &size)| sum + by.abs() * size);
                record(&mut self.balance, point, || "residual".into(), [change, Octuple::zero()], terms);
            }
        }
    }

    fn check_indifference(&mut self, layout: &Layout, form: &Form, point: &Point, here: &Here) {
        let Some(claim) = &mut self.indifference else { return };
        let inputs = form.subject.inputs;
        let turned = form.at_values(layout, &moved(inputs, &point.exact, reach(inputs, &point.exact)));
        let one = Octuple::one();
        let turn = |fields: &[Field], v: &[Octuple]| moved(fields, v, one);
        let rows = |matrix: &Matrix, fields: &[Field]| {
            let rows = matrix.row_iter().flat_map(|row| turn(fields, row.transpose().as_slice())).collect::<Vec<_>>();
            Matrix::from_row_slice(matrix.nrows(), matrix.ncols(), &rows)
        };
        let columns = |matrix: &Matrix, fields: &[Field]| rows(&matrix.transpose(), fields).transpose();
        let found = &here.found;
        let expected = [
            column(&found.residuals),
            rows(&found.rows, layout.unknowns),
            columns(&column(&found.forces), layout.forces),
            columns(&rows(&found.stiffness, layout.unknowns), layout.forces),
            columns(&found.by_multipliers, layout.forces),
        ];
        // Cancellation leaves rounding errors proportional to the inputs, in numbers of any size.
        let size = point.exact.iter().fold(one, |size, x| size + x.abs());
        compare_all(claim, point, &turned.matrices(), &expected, &here.sizes.matrices(), size * size);
    }

    fn check_homogeneity(&mut self, layout: &Layout, form: &Form, point: &Point, here: &Here) {
        let scaled = form.at_values(layout, &rescale(form.subject.inputs, &point.exact));
        let factors = |fields: &[Field]| rescale(fields, &vec![Octuple::one(); count(fields)]);
        let [unknowns, forces, residuals, multipliers] =
            [layout.unknowns, layout.forces, layout.residuals, layout.multipliers].map(factors);
        let one = [Octuple::one()];
        let by = |matrix: Matrix, rows: &[Octuple], columns: &[Octuple]| {
            Matrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)] * rows[i] / columns[j])
        };
        let [r, g, f, k, l] = here.found.matrices();
        let expected = [
            by(r, &residuals, &one),
            by(g, &residuals, &unknowns),
            by(f, &forces, &one),
            by(k, &forces, &unknowns),
            by(l, &forces, &multipliers),
        ];
        let scales = [
            by(column(&here.sizes.residuals), &residuals, &one),
            by(here.sizes.rows.clone(), &residuals, &unknowns),
            by(column(&here.sizes.forces), &forces, &one),
            by(here.sizes.stiffness.clone(), &forces, &unknowns),
            by(here.sizes.by_multipliers.clone(), &forces, &multipliers),
        ];
        compare_all(&mut self.homogeneity, point, &scaled.matrices(), &expected, &scales, Octuple::zero());
    }

    fn check_friction(&mut self, point: &Point, here: &Here) {
        let Some([yields, slips, costs]) = &mut self.friction else { return };
        for rubbed in &here.rubbed {
            let (Rubbed { motion, force: [before, after], k_stick, phi }, size) = (*rubbed, rubbed.force[1].abs());
            // What does not slip changes the friction.
            let slipped = motion - (after - before) / k_stick;
            let (work, limit) = (after * slipped, size + phi.abs());
            let beyond = if phi > Octuple::zero() { phi } else { Octuple::zero() };
            record(yields, point, || "phi".into(), [beyond, Octuple::zero()], limit);
            let has_slipped = phi.abs() <= limit * EXACT;
            self.sticks_and_slips[usize::from(has_slipped)] += 1;
            let idle = if has_slipped { Octuple::zero() } else { slipped };
            record(slips, point, || "slip".into(), [idle, Octuple::zero()], motion.abs() + before.abs() / k_stick);
            let gained = if has_slipped && work < Octuple::zero() { -work } else { Octuple::zero() };
            record(
                costs,
                point,
                || "work".into(),
                [gained, Octuple::zero()],
                size * (motion.abs() + before.abs() / k_stick),
            );
        }
    }
}

/// Compares every number relative to its scale, to the largest number of its matrix, and to the possible rounding error.
fn compare_all(
    claim: &mut Claim,
    point: &Point,
    found: &[Matrix; 5],
    expected: &[Matrix; 5],
    scales: &[Matrix; 5],
    left: Octuple,
) {
    let names = ["residuals", "rows", "forces", "stiffness", "by_multipliers"];
    for (name, ((found, expected), scales)) in names.into_iter().zip(found.iter().zip(expected).zip(scales)) {
        let most = largest(scales.iter().copied());
        for ((&found, &expected), &scale) in found.iter().zip(expected).zip(scales) {
            record(claim, point, || name.into(), [found, expected], scale + most + left);
        }
    }
}

/// Translations and rotations of the whole model, as values of the degrees of freedom; of an axisymmetric model, the
/// translation along the axis.
fn rigid_motions(layout: &Layout, inputs: &[Octuple]) -> Vec<Vector> {
    if layout.is_axisymmetric() {
        let along = |k: usize, _| if k % 2 == 1 { Octuple::one() } else { Octuple::zero() };
        return vec![Vector::from_fn(layout.degrees(), along)];
    }
    let mut places = Vec::new();
    let mut first = 0;
    for field in layout.nodes {
        if field.quantity.domain == Domain::Point {
            places.push(&inputs[first..first + field.len()]);
        }
        first += field.len();
    }
    let dimensions = places.first().map_or(0, |place| place.len());
    let zero = Octuple::zero();
    let unit = |k: usize, axis: usize| if k == axis { Octuple::one() } else { zero };
    let motion = |translation: &dyn Fn(&[Octuple]) -> Vec<Octuple>, spin: &[Octuple]| {
        let (mut all, mut place) = (Vec::new(), places.iter());
        for field in layout.unknowns {
            if field.quantity.unit == Unit::L {
                let place = place.next().expect("every translation is of a point");
                let arm: Vec<_> = place.iter().zip(places[0]).map(|(&x, &origin)| x - origin).collect();
                all.extend(translation(&arm));
            } else {
                all.extend(spin);
            }
        }
        Vector::from_vec(all)
    };
    let spins = if dimensions == 2 { 1 } else { 3 };
    let still = vec![zero; spins];
    let translations =
        (0..dimensions).map(|axis| motion(&|_| (0..dimensions).map(|k| unit(k, axis)).collect(), &still));
    let turns = (0..spins).map(|axis| {
        let spin: Vec<_> = (0..spins).map(|k| unit(k, axis)).collect();
        let turned = |arm: &[Octuple]| match (arm, &spin[..]) {
            (&[x, y], &[spin]) => vec![-y * spin, x * spin],
            (&[x, y, z], &[p, q, r]) => vec![q * z - r * y, r * x - p * z, p * y - q * x],
            _ => Vec::new(),
        };
        motion(&turned, &spin)
    });
    translations.chain(turns).collect()
}

/// K − Kᵀ is −[m×] in the block of a node's own spin, with the moment m on that node.
fn check_symmetry(claim: &mut Claim, layout: &Layout, point: &Point, here: &Here) {
    let (k, scales) = (&here.found.stiffness, &here.sizes.stiffness);
    let mut expected = Matrix::zeros(k.nrows(), k.ncols());
    let mut first = 0;
    for field in layout.unknowns {
        if field.quantity.unit == Unit::ONE && field.len() == 3 {
            let m = here.found.forces.rows(first, 3).into_owned();
            for (row, column, moment) in [(0, 1, m[2]), (1, 2, m[0]), (2, 0, m[1])] {
                expected[(first + row, first + column)] = moment;
                expected[(first + column, first + row)] = -moment;
            }
        }
        first += field.len();
    }
    let most = largest(scales.iter().copied());
    for row in 0..k.nrows() {
        for column in 0..k.ncols() {
            let size = scales[(row, column)] + scales[(column, row)] + most;
            record(
                claim,
                point,
                || "K − Kᵀ".into(),
                [k[(row, column)] - k[(column, row)], expected[(row, column)]],
                size,
            );
        }
    }
}
