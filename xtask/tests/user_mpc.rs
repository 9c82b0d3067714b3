//! `cargo xtask export --shell umpc-user`: called as CalculiX calls it, while a line moves from one place to the next.
//!
//! `tests/calculix/run` runs it in CalculiX itself, which takes minutes to build.

use crate::common::{Bench, is_here};
use jointproof::connector::slider::{Eliminate, Eliminate2d, KeptCoordinate, KeptCoordinate2d};
use jointproof::formula::{Fields, value_and_jacobian};
use nalgebra::{Vector2, Vector3};
use std::fmt::Write as _;
use std::io::Write as _;
use std::process::{Command, Stdio};

/// Answers a line with the number of MPCs of node m and the places of nodes m, 1 and n: for each MPC, JDOF, F and A. It keeps JDOF.
const DRIVER: &str = "
program driver
    use, intrinsic :: iso_fortran_env, only: dp => real64
    implicit none
    real(dp) :: places(3, 3), x(3, 8), u(3, 8), f, a(8)
    integer :: equations, jdof(8, 2), dim, n, ended, equation, idiscon
    external :: umpc_user
    jdof = 0
    jdof(1, :) = [1, 2]
    do
        read (*, *, iostat=ended) equations, places
        if (ended /= 0) exit
        dim = equations + 1
        n = 2 * dim + 2
        x(:, 1:2) = 0
        u(:, 1) = places(:, 1)
        u(:, 2) = places(:, 1)
        x(:, 3:n) = 0.5_dp
        u(:, 3:2 + dim) = spread(places(:, 2) - 0.5_dp, 2, dim)
        u(:, 3 + dim:n) = spread(places(:, 3) - 0.5_dp, 2, dim)
        do equation = 1, equations
            idiscon = 0
            call umpc_user(x, u, f, a, jdof(1, equation), n, 0.0_dp, 1, idiscon)
            write (*, '(*(g0, 1x))') jdof(:n, equation), idiscon, f, a(:n)
        end do
    end do
end program driver
";

/// A line, and node m.
type Places = [Vector3<f64>; 3];

/// Numbers of few digits, so that a start at 1/2 rounds none.
fn lines() -> Vec<Places> {
    let mut state = 7_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(state >> 52).unwrap()) / 256.0 - 8.0
    };
    (0..300).map(|_| [(); 3].map(|()| Vector3::from_fn(|_, _| next()))).collect()
}

/// The eliminated coordinates of m with their derivatives with respect to nodes 1 and n and to the one that is kept.
fn in_rust(dim: usize, [xm, x1, xn]: &Places, kept: usize) -> (Vec<f64>, Vec<Vec<f64>>) {
    if dim == 3 {
        let given = KeptCoordinate { x1: *x1, xn: *xn, xmk: xm[kept] };
        let (found, rows) = value_and_jacobian::<Eliminate>(&given).unwrap();
        (found.components(), [rows.xmi, rows.xmj].map(|row| row.components()).into())
    } else {
        let plane = |x: &Vector3<f64>| Vector2::new(x[0], x[1]);
        let given = KeptCoordinate2d { x1: plane(x1), xn: plane(xn), xmk: xm[kept] };
        let (found, rows) = value_and_jacobian::<Eliminate2d>(&given).unwrap();
        (found.components(), vec![rows.xmi.components()])
    }
}

#[test]
fn the_user_mpc_eliminates_the_coordinates_that_the_formula_does_whatever_it_did_before() {
    if !is_here("gfortran") {
        return;
    }
    let bench = Bench::new();
    let out = bench.path("");
    bench.run(&["export", "--shell", "umpc-user", "--out", out.to_str().unwrap()]).exits(0);
    std::fs::write(bench.path("driver.f90"), DRIVER).unwrap();
    let flags =
        ["-std=f2008", "-O1", "-ffp-contract=off", "-fcheck=bounds", "-o", "driver", "umpc_user.f90", "driver.f90"];
    let compiled = Command::new("gfortran").args(flags).current_dir(&out).output().unwrap();
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    for dim in [3, 2] {
        let mut given = String::new();
        for places in lines() {
            let numbers: Vec<_> = places.iter().flatten().map(|x| format!("{x:e}")).collect();
            writeln!(given, "{} {}", dim - 1, numbers.join(" ")).unwrap();
        }
        let mut command = Command::new(bench.path("driver"));
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
        let mut to = child.stdin.take().unwrap();
        let writer = std::thread::spawn(move || to.write_all(given.as_bytes()));
        let said = String::from_utf8(child.wait_with_output().unwrap().stdout).unwrap();
        writer.join().unwrap().unwrap();
        let answers: Vec<Vec<f64>> =
            said.lines().map(|line| line.split_whitespace().map(|x| x.parse().unwrap()).collect()).collect();
        assert_eq!(answers.len(), 300 * (dim - 1), "{said}");
        let (mut before, mut changes) = (vec![1.0, 2.0][..dim - 1].to_vec(), 0);
        for (places, answers) in lines().iter().zip(answers.chunks(dim - 1)) {
            let n = 2 * dim + 2;
            let eliminated: Vec<_> = answers.iter().map(|answer| answer[0]).collect();
            let all: f64 = (1..=dim).map(|axis| f64::from(u32::try_from(axis).unwrap())).sum();
            // What is kept is what none eliminates; a coordinate that was eliminated, and need not be kept, stays with its MPC.
            let kept = all - eliminated.iter().sum::<f64>();
            let moved = eliminated.iter().zip(&before).filter(|(now, before)| now != before).count();
            assert!(moved <= 1 && eliminated[0] != *eliminated.get(1).unwrap_or(&0.0), "{before:?} {eliminated:?}");
            changes += moved;
            let place = |axis: f64| (0..3).find(|&k| f64::from(u32::try_from(k + 1).unwrap()) == axis).unwrap();
            let (found, rows) = in_rust(dim, places, place(kept));
            for (answer, was) in answers.iter().zip(&before) {
                let (jdof, idiscon, f, a) = (&answer[..n], answer[n], answer[n + 1], &answer[n + 2..]);
                assert_eq!((jdof[1], idiscon != 0.0), (kept, jdof[0] != *was), "{answer:?}");
                let axes: Vec<_> = (1..=dim).map(|axis| f64::from(u32::try_from(axis).unwrap())).collect();
                assert_eq!(jdof[2..], [&axes[..], &axes].concat());
                let xm = places[0][place(jdof[0])];
                // The order of the eliminated coordinates is that of the formula.
                let is_this = |k: &usize| {
                    let by: Vec<_> =
                        [1.0, -rows[*k][2 * dim]].into_iter().chain(rows[*k][..2 * dim].iter().map(|x| -x)).collect();
                    f == xm - found[*k] && a == by
                };
                assert_eq!((0..found.len()).filter(is_this).count(), 1, "{places:?} {answer:?} {found:?}");
            }
            before = eliminated;
        }
        assert!(changes > 50, "{changes}");
    }
}
