//! `cargo xtask export --shell vuel`: elements as called by Abaqus/Explicit, compared with the same elements in Rust.
//!
//! A Fortran driver calls the routine for a block of two elements at once, as bits through files: the nodes of one are at COORDS, those
//! of the other are displaced there by U from the origin.

use crate::common::{Bench, is_here};
use jointproof::catalog::{AnyForm, ELEMENTS, Form};
use jointproof::formula::Field;
use jointproof::formula::proof::Flag;
use nalgebra::{DMatrix, DVector};
use std::process::Command;

const DRIVER: &str = "
program driver
    use, intrinsic :: iso_fortran_env, only: dp => real64
    implicit none
    integer, parameter :: n = 2, nodes = NODES, dofs = DOFS, states = STATES, nprops = PROPERTIES, dims = DIMENSIONS
    real(dp) :: rhs(n, dofs), amass(n, dofs, dofs), dt(n), svars(n, states), energy(n, 12), props(nprops)
    real(dp) :: coords(n, nodes, dims), u(n, dofs), time(2), scaling(n), predef(n, nodes, 1, 2), adlmag(n)
    integer :: jprops(1), jelem(n), lflags(3), ended, what
    external :: vuel
    time = 0; scaling = 1; predef = 0; adlmag = 0; jprops = 0; jelem = [1, 2]; lflags = [17, 1, 0]
    open (10, file='points.bin', access='stream', form='unformatted', status='old')
    open (11, file='found.bin', access='stream', form='unformatted', status='replace')
    do
        read (10, iostat=ended) props, svars, coords, u
        if (ended /= 0) exit
        do what = 1, 3
            rhs = 9; amass = 9; dt = 9; energy = 0; lflags(3) = what
            call vuel(n, rhs, amass, dt, svars, states, energy, nodes, dofs, props, nprops, jprops, 1, coords, dims, u, u, u, &
                u, 1, jelem, time, 1.0e9_dp, 1.0_dp, 1.0_dp, 1, 1, lflags, scaling, predef, 1, 0, adlmag)
            write (11) rhs, amass, dt, svars, energy(:, 3)
        end do
    end do
end program driver
subroutine xplb_exit
    error stop 'the element is not defined'
end subroutine xplb_exit
";

const FLAGS: &str = "-std=f2008 -O1 -ffp-contract=off -Wall -Wextra -pedantic -Wno-unused-dummy-argument -Werror";
const MASSES: [f64; 2] = [0.25, 0.5];

fn len(fields: &[Field]) -> usize {
    fields.iter().map(Field::len).sum()
}

/// An element as a VUEL has it.
fn explicit(id: &str) -> &'static dyn AnyForm {
    let element = ELEMENTS.iter().find(|element| element.spec().id == id).unwrap();
    let has_penalties = !element.layout().multipliers.is_empty();
    if has_penalties { element.in_form(Form { has_penalties, ..Form::default() }).unwrap() } else { *element }
}

/// The same point of an element in Rust, and as Abaqus hands it in.
struct Point {
    inputs: Vec<f64>,
    props: Vec<f64>,
    svars: Vec<f64>,
    /// Node by node, and the degrees of freedom at the same places.
    positions: Vec<f64>,
    u: Vec<f64>,
}

impl Point {
    fn new(element: &dyn AnyForm, inputs: Vec<f64>, rubs: bool) -> Self {
        let layout = element.layout();
        let (nodes, rest) = inputs.split_at(len(layout.nodes));
        let (mut positions, mut props) = (Vec::new(), Vec::new());
        for (range, field) in Field::ranges(layout.nodes).zip(layout.nodes) {
            if field.name.starts_with('x') { &mut positions } else { &mut props }.extend(&nodes[range]);
        }
        let states = len(layout.state);
        let (parameters, svars) = rest.split_at(rest.len() - if rubs { states } else { 0 });
        let without_friction = vec![0.0; if rubs { 0 } else { len(layout.contact) }];
        let is_rotation = |field: &Field| field.name.starts_with('t');
        let masses = if layout.unknowns.iter().any(is_rotation) { &MASSES[..] } else { &MASSES[..1] };
        props.extend([parameters, &without_friction, masses].concat());
        let mut at = positions.iter();
        let u = layout.unknowns.iter().flat_map(|field| vec![is_rotation(field); field.len()]);
        let u = u.map(|rotates| if rotates { 0.0 } else { *at.next().unwrap() }).collect();
        let mut svars = svars.to_vec();
        svars.resize(states.max(1), 0.0);
        Self { inputs, props, svars, positions, u }
    }

    /// The arguments of a block of two elements, each array with the element as its first index.
    fn arguments(&self, dims: usize) -> Vec<f64> {
        let both = |of: &[f64]| of.iter().flat_map(|&x| [x, x]).collect::<Vec<_>>();
        let nodes = self.positions.len() / dims;
        let coords = (0..dims).flat_map(|k| (0..nodes).flat_map(move |node| [dims * node + k])).collect::<Vec<_>>();
        let coords = coords.into_iter().flat_map(|k| [self.positions[k], 0.0]).collect();
        let u = self.u.iter().flat_map(|&u| [0.0, u]).collect();
        [self.props.clone(), both(&self.svars), coords, u].concat()
    }
}

/// Exports, compiles with a driver, and runs it at these points.
fn ran(element: &dyn AnyForm, points: &[Point], form: &[&str], plant: [&str; 2]) -> Vec<f64> {
    let (bench, layout) = (Bench::new(), element.layout());
    let out = bench.path("");
    let id = element.spec().id;
    bench
        .run(&[&["export", "--shell", "vuel", "--element", id, "--out", out.to_str().unwrap()], form].concat())
        .exits(0);
    let file = format!("vuel_{}.{}", element.name(), if form.is_empty() { "f90" } else { "f" });
    let text = std::fs::read_to_string(bench.path(&file)).unwrap();
    assert!(text.contains(plant[0]));
    std::fs::write(bench.path(&file), text.replace(plant[0], plant[1])).unwrap();
    std::fs::write(bench.path("vaba_param.inc"), "      implicit double precision (a-h, o-z)\n").unwrap();
    let dims = dimensions(element);
    let sizes = [
        ("NODES", points[0].positions.len() / dims),
        ("DOFS", len(layout.unknowns)),
        ("STATES", len(layout.state).max(1)),
        ("PROPERTIES", points[0].props.len()),
        ("DIMENSIONS", dims),
    ];
    let driver = sizes.iter().fold(DRIVER.to_owned(), |text, (name, size)| text.replace(name, &size.to_string()));
    std::fs::write(bench.path("driver.f90"), driver).unwrap();
    let bytes = points.iter().flat_map(|point| point.arguments(dims)).flat_map(f64::to_le_bytes);
    std::fs::write(bench.path("points.bin"), bytes.collect::<Vec<_>>()).unwrap();
    for arguments in [format!("{FLAGS} -c {file} -o vuel.o"), format!("{FLAGS} driver.f90 vuel.o -o driver")] {
        let output = Command::new("gfortran").args(arguments.split(' ')).current_dir(&out).output().unwrap();
        assert!(output.status.success(), "{arguments}\n{}", String::from_utf8_lossy(&output.stderr));
    }
    let output = Command::new(bench.path("driver")).current_dir(&out).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let found = std::fs::read(bench.path("found.bin")).unwrap();
    found.as_chunks::<8>().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect()
}

fn dimensions(element: &dyn AnyForm) -> usize {
    element.layout().nodes.iter().find(|field| field.name.starts_with('x')).unwrap().len()
}

/// The valid cases of an element, without and with friction.
fn points(element: &dyn AnyForm) -> Vec<(Point, bool)> {
    let has_friction = !element.layout().contact.is_empty();
    let forms = [false, true].into_iter().filter(|rubs| !rubs || has_friction);
    let valid = forms.flat_map(|rubs| {
        let cases = element.cases(rubs, 40).into_iter().filter(|case| case.flag != Flag::Invalid);
        let valid = cases.filter(move |case| element.value(&case.inputs, rubs).is_ok());
        valid.map(move |case| (Point::new(element, case.inputs, rubs), rubs))
    });
    valid.collect()
}

/// What a VUEL gives at a point, or why it is not what Rust gives.
fn off(element: &dyn AnyForm, (point, rubs): &(Point, bool), found: &[f64]) -> Option<String> {
    let layout = element.layout();
    let [n, m, states] = [layout.unknowns, layout.residuals, layout.state].map(len);
    let results = element.value(&point.inputs, *rubs).unwrap();
    let (forces, stiffness) = results[m + m * n..].split_at(n);
    let stiffness = DMatrix::from_row_slice(n, n, &stiffness[..n * n]);
    let is_rotation = layout.unknowns.iter().flat_map(|field| vec![field.name.starts_with('t'); field.len()]);
    let mass = DVector::from_iterator(n, is_rotation.map(|rotates| MASSES[usize::from(rotates)]));
    let block = found.len() / 3;
    for (element, displaced) in ["at COORDS", "displaced by U"].into_iter().enumerate() {
        let at = |what: usize, from: usize, count: usize| {
            (0..count).map(|k| found[block * (what - 1) + 2 * (from + k) + element]).collect::<Vec<_>>()
        };
        let (amass, dt, svars, energy) = (n, n + n * n, n + n * n + 1, n + n * n + 1 + states.max(1));
        // Either sign of zero.
        let bits = |numbers: &[f64]| numbers.iter().map(|x| (x + 0.0).to_bits()).collect::<Vec<_>>();
        if bits(&at(2, 0, n)) != bits(&forces.iter().map(|force| -force).collect::<Vec<_>>()) {
            return Some(format!("RHS {displaced}"));
        }
        let after = if *rubs { &results[results.len() - states..] } else { &point.svars[..states] };
        if bits(&at(2, svars, states)) != bits(after) {
            return Some(format!("SVARS {displaced}"));
        }
        if DMatrix::from_vec(n, n, at(1, amass, n * n)) != DMatrix::from_diagonal(&mass) {
            return Some(format!("AMASS {displaced}"));
        }
        if at(3, 0, n).iter().any(|&x| x != 0.0) {
            return Some(format!("RHS of a load {displaced}"));
        }
        let work: f64 = layout
            .residuals
            .iter()
            .zip(Field::ranges(layout.residuals))
            .map(|(residual, range)| {
                let kappa =
                    Field::ranges(layout.start).zip(layout.start).find(|(_, field)| **field == Form::penalty(residual));
                let first = len(layout.nodes);
                let kappa = kappa.map_or(0.0, |(range, _)| point.inputs[first + range.start]);
                results[range].iter().map(|g| kappa * g * g / 2.0).sum::<f64>()
            })
            .sum();
        if (at(2, energy, 1)[0] - work).abs() > 1e-14 * work {
            return Some(format!("ENERGY {displaced}: {:?}, not {work:e}", at(2, energy, 1)));
        }
        // Twice over the root of the largest eigenvalue between unit masses is at least the stable increment.
        let scaled = DMatrix::from_fn(n, n, |i, j| stiffness[(i, j)] / (mass[i] * mass[j]).sqrt());
        let increment = 2.0 / scaled.norm().sqrt();
        let found = at(2, dt, 1)[0];
        if (found - increment.min(1e9)).abs() > 1e-12 * found {
            return Some(format!("DTIMESTABLE {displaced}: {found:e}, not {increment:e}"));
        }
        let largest = scaled.complex_eigenvalues().iter().map(|value| value.norm()).fold(0.0, f64::max);
        if found > 2.0 / largest.sqrt() * (1.0 + 1e-12) {
            return Some(format!("DTIMESTABLE {displaced} is not stable"));
        }
    }
    None
}

/// The first difference between a routine and Rust.
fn first_off(element: &dyn AnyForm, form: &[&str], plant: [&str; 2]) -> Option<String> {
    let (points, forms): (Vec<_>, Vec<_>) = points(element).into_iter().unzip();
    let found = ran(element, &points, form, plant);
    let size = found.len() / points.len();
    let mut found = found.chunks(size);
    points.into_iter().zip(forms).find_map(|point| off(element, &point, found.next().unwrap()))
}

/// Elements in space and in the plane, with and without rotations, friction and multipliers.
#[test]
fn a_vuel_has_every_bit_of_rust() {
    if !is_here("gfortran") {
        return;
    }
    for id in ["slot", "slot_2d", "universal", "hinge", "slider", "isl21a_linear"] {
        assert_eq!(first_off(explicit(id), &[], ["", ""]), None, "{id}");
    }
    assert_eq!(first_off(explicit("translator"), &["--fixed"], ["", ""]), None);
}

#[test]
fn mistakes_in_a_vuel_are_found() {
    if !is_here("gfortran") {
        return;
    }
    for (from, to, says) in [
        ("rhs = -forces", "rhs = forces", "RHS at"),
        ("svars(:2) = after", "svars(:1) = after(:1)", "SVARS at"),
        ("= coords(:2, 2) + u(4:5)", "= coords(:2, 2)", "RHS displaced"),
        ("amass = 0", "", "AMASS at"),
        ("rhs = 0", "", "RHS of a load"),
        ("sum(residuals([1])**2) / 2", "sum(residuals([1])**2)", "ENERGY"),
        ("mass = 1 / sqrt(mass)", "mass = 1 / mass", "DTIMESTABLE"),
    ] {
        let said = first_off(explicit("slot_2d"), &[], [from, to]).unwrap_or_default();
        assert!(said.starts_with(says), "{from}: {said}");
    }
}
