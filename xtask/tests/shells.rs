//! `cargo xtask export --shell uel`: elements as called by Abaqus, compared with the same elements in Rust.
//!
//! A Fortran driver calls the routine with the arguments of its interface, at points received through a pipe as bits,
//! and returns the results as bits.

use crate::common::{Bench, is_here};
use jointproof::connector::hinge::HingeElement;
use jointproof::connector::slot::SlotElement;
use jointproof::connector::translator::TranslatorElement;
use jointproof::connector::ujoint::UJointElement;
use jointproof::element::offset::Arms;
use jointproof::element::{Element, Nodes, Parameters};
use jointproof::element::{Forces, Stiffness};
use jointproof::formula::Fields;
use nalgebra::{DMatrix, DVector, Matrix3, Rotation3, SVector, Vector3};
use std::fmt::Write as _;
use std::io::{BufRead, BufReader, Write as _};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

const DRIVER: &str = "
program driver
    use, intrinsic :: iso_fortran_env, only: int64, dp => real64
    implicit none
    integer, parameter :: ndofel = 12 + MULTIPLIERS, nsvars = STATES, nprops = PROPERTIES
    real(dp) :: rhs(ndofel, 1), amatrx(ndofel, ndofel), svars(nsvars), energy(8), props(nprops), coords(3, 3)
    real(dp) :: u(ndofel), du(ndofel, 1), time(2), params(1), adlmag(1, 1), predef(2, 1, 3), ddlmag(1, 1), pnewdt
    integer :: jdltyp(1, 1), lflags(5), jprops(1), ended, what
    external :: uel
    energy = 0; du = 0; time = 1; params = 0; adlmag = 0; predef = 0; ddlmag = 0; jdltyp = 0; jprops = 0; lflags = 0
    do
        read (*, *, iostat=ended) what
        if (ended /= 0) exit
        lflags(3) = what
        call take(props)
        call take(svars)
        call take(coords(:, 1))
        call take(coords(:, 2))
        coords(:, 3) = 0
        call take(u)
        rhs = huge(1.0_dp)
        amatrx = huge(1.0_dp)
        pnewdt = 1
        call uel(rhs, amatrx, svars, energy, ndofel, 1, nsvars, props, nprops, coords, 3, 3, u, du, u, u, 1, time, 1.0_dp, &
            1, 1, 1, params, 0, jdltyp, adlmag, predef, 1, lflags, ndofel, ddlmag, 0, pnewdt, jprops, 0, 1.0_dp)
        call give(reshape(rhs, [ndofel]))
        call give(reshape(amatrx, [ndofel * ndofel]))
        call give(svars)
        call give([pnewdt])
        flush (6)
    end do
contains
    subroutine take(x)
        real(dp), intent(out) :: x(:)
        integer(int64) :: bits
        integer :: k
        do k = 1, size(x)
            read (*, '(z16)') bits
            x(k) = transfer(bits, 0.0_dp)
        end do
    end subroutine take
    subroutine give(x)
        real(dp), intent(in) :: x(:)
        integer :: k
        do k = 1, size(x)
            write (*, '(z16.16)') transfer(x(k), 0_int64)
        end do
    end subroutine give
end program driver
";

/// The results of the element: residual and matrix in Abaqus's sense, the state after the step, and the factor for the
/// time increment.
#[derive(Clone, Debug, PartialEq)]
struct Answer {
    rhs: Vec<f64>,
    amatrx: Vec<f64>,
    svars: Vec<f64>,
    pnewdt: f64,
}

impl Answer {
    fn bits(&self) -> Vec<u64> {
        let numbers = self.rhs.iter().chain(&self.amatrx).chain(&self.svars);
        // The negative of a derivative may have either sign of zero.
        numbers.map(|x| (x + 0.0).to_bits()).collect()
    }
}

/// A point at which the element is evaluated.
#[derive(Clone, Debug)]
struct Point {
    /// Those after the triads.
    props: Vec<f64>,
    svars: Vec<f64>,
    triads: [[Vector3<f64>; 3]; 2],
    coords: [Vector3<f64>; 2],
    u: Vec<f64>,
}

/// What every routine of Abaqus includes, in words of the standard.
const STANDARD_ABA_PARAM: &str = "      implicit double precision (a-h, o-z)\n";

/// The compiler of the shells; without it there is nothing to compare.
const COMPILER: &str = "gfortran";

/// The compiled routine, called through a pipe.
struct Peer {
    child: Child,
    to: ChildStdin,
    from: BufReader<ChildStdout>,
    sizes: [usize; 3],
    _bench: Bench,
}

impl Peer {
    /// Exports an element, compiles it without a warning, and starts its driver.
    fn new(element: &str, sizes: [usize; 3]) -> Self {
        let bench = Bench::new();
        let out = bench.path("");
        bench.run(&["export", "--shell", "uel", "--element", element, "--out", out.to_str().unwrap()]).exits(0);
        std::fs::write(bench.path("ABA_PARAM.INC"), STANDARD_ABA_PARAM).unwrap();
        let [multipliers, states, properties] = sizes.map(|size| size.to_string());
        let driver = DRIVER.replace("MULTIPLIERS", &multipliers).replace("STATES", &states);
        std::fs::write(bench.path("driver.f90"), driver.replace("PROPERTIES", &properties)).unwrap();
        let flags = "-std=f2008 -O1 -ffp-contract=off -Wall -Wextra -pedantic -Wno-unused-dummy-argument -Werror";
        let file = format!("uel_{element}.f90");
        let mut compiler = Command::new(COMPILER);
        compiler.args(flags.split(' ')).args([file.as_str(), "driver.f90", "-o", "driver"]).current_dir(&out);
        let output = compiler.output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let program = bench.path("driver");
        let mut child = Command::new(program).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
        let (to, from) = (child.stdin.take().unwrap(), BufReader::new(child.stdout.take().unwrap()));
        Self { child, to, from, sizes, _bench: bench }
    }

    /// The results of the routine at a point, for `LFLAGS(3)`.
    fn ask(&mut self, what: i32, point: &Point) -> Answer {
        let Point { props, svars, triads, coords, u } = point;
        let triads = triads.iter().flatten().flatten().copied();
        let props: Vec<_> = triads.chain(props.iter().copied()).collect();
        let mut text = format!("{what}\n");
        let numbers = props.iter().chain(svars).chain(coords.iter().flatten()).chain(u);
        numbers.for_each(|x| writeln!(text, "{:016X}", x.to_bits()).unwrap());
        self.to.write_all(text.as_bytes()).unwrap();
        let [multipliers, states, _] = self.sizes;
        let all = 12 + multipliers;
        let (rhs, amatrx, svars) = (self.take(all), self.take(all * all), self.take(states));
        Answer { rhs, amatrx, svars, pnewdt: self.take(1)[0] }
    }

    fn take(&mut self, count: usize) -> Vec<f64> {
        let mut line = String::new();
        let mut number = || {
            line.clear();
            self.from.read_line(&mut line).unwrap();
            f64::from_bits(u64::from_str_radix(line.trim(), 16).unwrap())
        };
        (0..count).map(|_| number()).collect()
    }
}

impl Drop for Peer {
    fn drop(&mut self) {
        drop(self.child.kill());
        drop(self.child.wait());
    }
}

/// A vector rotated by a rotation vector, with the same operations as in the shell.
fn turned(rotation: &[f64], e: &Vector3<f64>) -> Vector3<f64> {
    let rotation = Vector3::from_column_slice(rotation);
    let angle = rotation.dot(&rotation).sqrt();
    if angle <= 0.0 {
        return *e;
    }
    let half = (angle / 2.0).sin() / angle;
    let (sine, versine) = (angle.sin() / angle, 2.0 * (half * half));
    let across = rotation.cross(e);
    e + (across * sine + rotation.cross(&across) * versine)
}

fn nodes(point: &Point) -> Nodes<f64> {
    let Point { triads: [a, b], coords: [xa, xb], u, .. } = point;
    let moved = |x: &Vector3<f64>, u: &[f64]| x + Vector3::from_column_slice(u);
    let triads = [a.map(|e| turned(&u[3..6], &e)), b.map(|e| turned(&u[9..12], &e))];
    Nodes::new(triads, [moved(xa, &u[..3]), moved(xb, &u[6..9])])
}

/// An element from PROPS: first the measurements in the initial configuration, then the friction parameters, if the
/// stick stiffness is not 0.
fn made<E: Element<N>, const N: usize>(props: &[f64]) -> Parameters<E, f64, N> {
    let (start, contact) = props.split_at(E::Start::<f64>::LEN);
    let contact = (contact[0] > 0.0).then(|| Fields::from_slice(contact).unwrap());
    Parameters { start: Fields::from_slice(start).unwrap(), contact }
}

/// The results of the element in Rust at a point, in Abaqus's sense.
fn in_rust<E: Element<N, Nodes<f64> = Nodes<f64>>, const N: usize>(point: &Point) -> Answer {
    let multipliers = SVector::<f64, N>::from_column_slice(&point.u[12..]);
    let before = Fields::from_slice(&point.svars).unwrap();
    let (found, after) = made::<E, N>(&point.props).newton(&nodes(point), &multipliers, &before).unwrap();
    let mut amatrx = DMatrix::zeros(12 + N, 12 + N);
    amatrx.view_mut((0, 0), (12, 12)).copy_from(&-found.stiffness);
    amatrx.view_mut((0, 12), (12, N)).copy_from(&-found.by_multipliers);
    amatrx.view_mut((12, 0), (N, 12)).copy_from(&-found.rows);
    let rhs = found.forces.iter().chain(&found.residuals).copied().collect();
    Answer { rhs, amatrx: amatrx.as_slice().to_vec(), svars: after.components(), pnewdt: 1.0 }
}

/// Numbers between −1 and 1, the same in every run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        #[expect(clippy::cast_precision_loss, reason = "53 bits are a double")]
        let part = (self.0 >> 11) as f64 / (1_u64 << 52) as f64;
        part - 1.0
    }
    fn vector(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.next())
    }
    fn triad(&mut self) -> [Vector3<f64>; 3] {
        axes(&Rotation3::new(self.vector()))
    }
    fn some(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| self.next()).collect()
    }
}

fn axes(turn: &Rotation3<f64>) -> [Vector3<f64>; 3] {
    let m: &Matrix3<f64> = turn.matrix();
    [0, 1, 2].map(|k| m.column(k).into_owned())
}

/// Evaluates both at points that stick and slip: every bit agrees, whatever is requested.
fn compare<E: Element<N, Nodes<f64> = Nodes<f64>>, const N: usize>(
    element: &str,
    props: impl Fn(&mut Numbers) -> Vec<f64>,
) {
    if !is_here(COMPILER) {
        return;
    }
    let mut numbers = Numbers(7);
    let first = props(&mut numbers);
    let states = E::State::<f64>::LEN;
    let mut peer = Peer::new(element, [N, states, 18 + first.len()]);
    for _ in 0..200 {
        let point = Point {
            props: props(&mut numbers),
            svars: numbers.some(states),
            triads: [numbers.triad(), numbers.triad()],
            coords: [numbers.vector(), numbers.vector()],
            u: numbers.some(12 + N),
        };
        let expected = in_rust::<E, N>(&point);
        let found = peer.ask(1, &point);
        assert_eq!(found.bits(), expected.bits(), "{point:?}\n{found:?}\n{expected:?}");
        assert_eq!(found.pnewdt, 1.0);
        let residual = peer.ask(5, &point);
        assert_eq!((&residual.rhs, residual.amatrx.iter().all(|&x| x == 0.0)), (&found.rhs, true));
        let stiffness = peer.ask(2, &point);
        assert_eq!((&stiffness.amatrx, &stiffness.svars), (&found.amatrx, &point.svars));
        let mass = peer.ask(4, &point);
        assert!(mass.rhs.iter().chain(&mass.amatrx).all(|&x| x == 0.0));
        // If a node has an invalid position, or a moment overflows, a smaller increment is requested.
        let (mut lost, mut strained) = (point.clone(), point.clone());
        lost.u[0] = f64::NAN;
        strained.coords[1] *= 1e200;
        strained.u[12] = 1e200;
        for refused in [lost, strained].map(|point| peer.ask(1, &point)) {
            assert_eq!((refused.pnewdt, refused.rhs.iter().all(|&x| x == 0.0)), (0.5, true));
        }
    }
}

/// A stick stiffness for sticking or slipping, or 0 for no friction.
fn stiffness(numbers: &mut Numbers) -> f64 {
    let x = numbers.next();
    if x < -0.6 { 0.0 } else { 10_f64.powf(4.0 * x) }
}

#[test]
fn slot_has_every_bit_of_rust() {
    compare::<SlotElement, 2>("slot", |numbers| {
        let start = numbers.some(3);
        [start, vec![stiffness(numbers), numbers.next(), numbers.next().abs()]].concat()
    });
}

#[test]
fn translator_has_every_bit_of_rust() {
    compare::<TranslatorElement, 5>("translator", |numbers| {
        let start = numbers.some(6);
        let k_stick = stiffness(numbers);
        let positive: Vec<_> = numbers.some(2).iter().map(|x| x.abs()).collect();
        [start, vec![k_stick], positive, vec![numbers.next(), numbers.next().abs()]].concat()
    });
}

#[test]
fn ujoint_has_every_bit_of_rust() {
    compare::<UJointElement, 4>("ujoint", |numbers| {
        let start = numbers.some(6);
        let (k_stick1, k_stick3) = (stiffness(numbers), 10_f64.powf(2.0 * numbers.next()));
        let cross: Vec<_> = numbers.some(4).iter().map(|x| x.abs()).collect();
        [start, vec![k_stick1, k_stick3], cross, numbers.some(2), vec![numbers.next().abs()]].concat()
    });
}

#[test]
fn hinge_has_every_bit_of_rust() {
    compare::<HingeElement, 5>("hinge", |numbers| {
        let start = numbers.some(6);
        let positive: Vec<_> = numbers.some(3).iter().map(|x| x.abs()).collect();
        [start, vec![stiffness(numbers)], positive, vec![numbers.next(), numbers.next().abs()]].concat()
    });
}

/// Springs that hold both bodies: from the ends of arms, which rotate with them, to fixed points.
const SPRINGS: [[[f64; 3]; 2]; 4] = [
    [[0.5, 1.0, -0.25], [0.75, 1.5, 0.5]],
    [[-0.5, 0.25, 1.0], [-0.25, 0.5, 1.0]],
    [[1.0, -0.5, 0.25], [2.0, 0.25, 0.75]],
    [[0.25, 0.5, -1.0], [1.0, 1.25, -0.5]],
];

/// Adds springs to right-hand side and matrix: the first two act on a, the others on b.
fn add_springs(point: &Point, matrix: &mut DMatrix<f64>, right: &mut DVector<f64>) {
    const SPRING: f64 = 50.0;
    for (k, [arm, place]) in SPRINGS.map(|spring| spring.map(Vector3::from)).into_iter().enumerate() {
        let first = 6 * (k / 2);
        let arm = turned(&point.u[first + 3..first + 6], &arm);
        let end = point.coords[k / 2] + Vector3::from_column_slice(&point.u[first..first + 3]) + arm;
        let (mut pull, mut soft) = (Forces::<f64>::zeros(), Stiffness::<f64>::zeros());
        pull.fixed_rows_mut::<3>(first).copy_from(&((place - end) * SPRING));
        soft.fixed_view_mut::<3, 3>(first, first).fill_diagonal(-SPRING);
        let none = Vector3::zeros();
        let arms = if k < 2 { Arms { a: arm, b: none } } else { Arms { a: none, b: arm } };
        let mut forces = right.rows_mut(0, 12);
        forces += arms.forces(&pull);
        let mut block = matrix.view_mut((0, 0), (12, 12));
        block += arms.stiffness(&soft, &pull);
    }
}

/// Newton's method for two bodies on springs, joined by the element: the size of every step, and the final state.
fn steps(start: &Point, mut ask: impl FnMut(&Point) -> Answer) -> (Vec<f64>, Vec<f64>) {
    let mut point = start.clone();
    let all = point.u.len();
    let (mut sizes, mut after) = (Vec::new(), Vec::new());
    while sizes.len() < 40 && sizes.last().is_none_or(|&size| size > 1e-13) {
        let answer = ask(&point);
        let mut matrix = -DMatrix::from_column_slice(all, all, &answer.amatrx);
        let mut right = DVector::from_column_slice(&answer.rhs);
        add_springs(&point, &mut matrix, &mut right);
        let step = matrix.lu().solve(&-right).expect("the springs hold what the element leaves free");
        let turn = |of: &[f64]| Rotation3::new(Vector3::from_column_slice(of));
        let turns = [3, 9].map(|k| turn(&step.as_slice()[k..k + 3]) * turn(&point.u[k..k + 3]));
        point.u.iter_mut().zip(&step).for_each(|(u, step)| *u += step);
        for (k, turn) in [3, 9].into_iter().zip(turns) {
            point.u[k..k + 3].copy_from_slice(turn.scaled_axis().as_slice());
        }
        sizes.push(step.rows(0, 12).amax());
        after = answer.svars;
    }
    (sizes, after)
}

/// From step to step the error is squared, down to rounding, once it no longer grows because of beginning slip.
fn is_quadratic(sizes: &[f64]) -> bool {
    let last_growth = sizes.windows(2).rposition(|pair| pair[1] > pair[0]).map_or(0, |k| k + 1);
    let mut small = sizes[last_growth..].windows(2).filter(|pair| pair[0] < 0.1);
    sizes.len() < 12 && small.all(|pair| pair[1] < 10.0 * pair[0] * pair[0] + 1e-13)
}

#[test]
fn newton_converges_through_the_interface_as_in_rust() {
    if !is_here(COMPILER) {
        return;
    }
    let triads = [axes(&Rotation3::identity()), axes(&Rotation3::identity())];
    let point = |props: &[f64], states: usize, multipliers: usize| Point {
        props: props.to_vec(),
        svars: vec![0.0; states],
        triads,
        coords: [Vector3::zeros(), Vector3::new(0.5, 0.25, 0.0)],
        u: vec![0.0; 12 + multipliers],
    };
    let mut peers = [Peer::new("translator", [5, 2, 29]), Peer::new("ujoint", [4, 4, 33])];
    // Without friction, sticking, slipping.
    for (k_stick, mu, fit, slips) in [(0.0, 0.25, 0.0, false), (20.0, 0.25, 100.0, false), (1e3, 0.02, 0.0, true)] {
        let at_start = [0.5, 0.25, 0.0, 0.0, 0.0, 0.0, k_stick];
        let props = [&at_start[..], &[0.25, 2.0, fit, mu]].concat();
        let start = point(&props, 2, 5);
        let found = steps(&start, |at| peers[0].ask(1, at));
        assert_eq!(found, steps(&start, in_rust::<TranslatorElement, 5>));
        let has_slipped = |motion: f64, friction: f64| k_stick > 0.0 && k_stick * motion != friction;
        assert!(
            is_quadratic(&found.0) && has_slipped(found.1[0], found.1[1]) == slips,
            "TRANSLATOR, {k_stick}: {found:?}"
        );

        let props = [&at_start[..], &[k_stick, 0.125, 0.5, 0.25, 0.5, fit, fit, mu]].concat();
        let start = point(&props, 4, 4);
        let found = steps(&start, |at| peers[1].ask(1, at));
        assert_eq!(found, steps(&start, in_rust::<UJointElement, 4>));
        assert!(is_quadratic(&found.0) && has_slipped(found.1[0], found.1[2]) == slips, "UJOINT, {k_stick}: {found:?}");
    }
}
