//! `cargo xtask check --abi`: routines with the interfaces that finite-element programs prescribe, as their users write them.

use crate::common::Bench;
use crate::port::{Lang, check, sources};
use std::process::Command;

/// A routine as its users write it, and the formulas exported for it.
struct Routine<'a> {
    abi: &'static str,
    file: &'static str,
    text: &'a str,
    uses: &'static [&'static str],
}

/// A friction model in the usual style of users: fixed form, implicit types. It sticks with the stiffness PROPS(2).
const FRIC: Routine<'static> = Routine {
    abi: "fric",
    file: "routine.f",
    uses: &[],
    text: "
      SUBROUTINE FRIC(LM,TAU,DDTDDG,DDTDDP,DSLIP,SED,SFD,DDTDDT,PNEWDT,
     1 STATEV,DGAM,TAULM,PRESS,DPRESS,DDPDDH,SLIP,KSTEP,KINC,TIME,DTIME,
     2 NOEL,CINAME,SLNAME,MSNAME,NPT,NODE,NPATCH,COORDS,RCOORD,DROT,
     3 TEMP,PREDEF,NFDIR,MCRD,NPRED,NSTATV,CHRLNGTH,PROPS,NPROPS)
      IMPLICIT REAL*8(A-H,O-Z)
      CHARACTER*80 CINAME,SLNAME,MSNAME
      DIMENSION TAU(NFDIR),DDTDDG(NFDIR,NFDIR),DDTDDP(NFDIR),
     1 DSLIP(NFDIR),DDTDDT(NFDIR,2),STATEV(*),DGAM(NFDIR),TAULM(NFDIR),
     2 SLIP(NFDIR),TIME(2),COORDS(MCRD),RCOORD(MCRD),DROT(2,2),TEMP(2),
     3 PREDEF(2,*),CHRLNGTH(2),PROPS(NPROPS)
      LM = 0
      TRIAL = TAU(1) + PROPS(2)*DGAM(1)
      CRIT = PROPS(1)*PRESS
      IF (ABS(TRIAL) .LT. CRIT) THEN
        TAU(1) = TRIAL
        DDTDDG(1,1) = PROPS(2)
        DDTDDP(1) = 0.D0
      ELSE
        TAU(1) = SIGN(CRIT, TRIAL)
        DDTDDG(1,1) = 0.D0
        DDTDDP(1) = SIGN(PROPS(1), TRIAL)
      END IF
      RETURN
      END
",
};

/// An interaction: a pressure that grows with the overclosure, and friction that sticks with the stiffness PROPS(2).
const UINTER: Routine<'static> = Routine {
    abi: "uinter",
    file: "routine.f",
    uses: &[],
    text: "
      SUBROUTINE UINTER(STRESS,DDSDDR,DVISCOUS,DSTRUCTURAL,FLUX,DDFDDT,
     1 DDSDDT,DDFDDR,STATEV,SED,SFD,SPD,SVD,SCD,PNEWDT,RDISP,DRDISP,
     2 TEMP,DTEMP,PREDEF,DPRED,TIME,DTIME,FREQR,CINAME,SECNAME,
     3 MAINNAME,PROPS,COORDS,ALOCALDIR,DROT,AREA,CHRLNGTH,NODE,NDIR,
     4 NSTATV,NPRED,NPROPS,MCRD,KSTEP,KINC,KIT,LINPER,LOPENCLOSE,
     5 LSTATE,LSDI,LPRINT)
      IMPLICIT REAL*8(A-H,O-Z)
      CHARACTER*80 CINAME,SECNAME,MAINNAME
      DIMENSION STRESS(NDIR),DDSDDR(NDIR,NDIR),FLUX(2),DDFDDT(2,2),
     1 DDSDDT(NDIR,2),DDFDDR(2,NDIR),STATEV(NSTATV),RDISP(NDIR),
     2 DRDISP(NDIR),TEMP(2),DTEMP(2),PREDEF(2,NPRED),DPRED(2,NPRED),
     3 TIME(2),PROPS(NPROPS),COORDS(MCRD),ALOCALDIR(3,3),DROT(2,2),
     4 DVISCOUS(NDIR,NDIR),DSTRUCTURAL(NDIR,NDIR)
      DDSDDR = 0.D0
      IF (RDISP(1) .GT. 0.D0) THEN
        STRESS(1) = PROPS(1)*RDISP(1)
        DDSDDR(1,1) = PROPS(1)
      ELSE
        STRESS(1) = 0.D0
      END IF
      TRIAL = STRESS(2) + PROPS(2)*DRDISP(2)
      CRIT = PROPS(3)*STRESS(1)
      IF (ABS(TRIAL) .LT. CRIT) THEN
        STRESS(2) = TRIAL
        DDSDDR(2,2) = PROPS(2)
      ELSE
        STRESS(2) = SIGN(CRIT, TRIAL)
        DDSDDR(2,1) = SIGN(PROPS(3), TRIAL)*DDSDDR(1,1)
      END IF
      RETURN
      END
",
};

/// A constraint that keeps node m on a line: coordinates i and j follow from k.
const MPC: Routine<'static> = Routine { abi: "mpc", file: "routine.f90", uses: &["slider.eliminate"], text: "
subroutine mpc(ue, a, jdof, mdof, n, jtype, x, u, uinit, maxdof, lmpc, kstep, kinc, time, nt, nf, temp, field, ltran, tran)
    use jp_slider_eliminate, only: jp_slider_eliminate_jacobian
    implicit none
    integer, parameter :: dp = kind(1.0d0)
    integer :: mdof, n, jdof(n), jtype, maxdof, lmpc, kstep, kinc, nt, nf, ltran(n)
    real(dp) :: ue(mdof), a(n), x(6, n), u(maxdof, n), uinit(maxdof, n), time(2), temp(nt, n), field(nf, nt, n), tran(3, 3, n)
    real(dp) :: x1(3), xn(3), d(3), y(2), jacobian(2, 7)
    integer :: axes(3), p, q, e, k
    x1 = x(1:3, 3) + u(1:3, 3)
    xn = x(1:3, 6) + u(1:3, 6)
    d = abs(xn - x1)
    d = scale(d, -exponent(maxval(d)))
    p = merge(3, 2, d(3) >= d(2))
    q = 5 - p
    axes = [q, p, 1]
    if (d(p) > 0 .and. d(p)**2 + d(q)**2 >= d(p) * d(1)) axes = [q, 1, p]
    e = axes(jtype)
    k = axes(3)
    if (jp_slider_eliminate_jacobian(x1, xn, x(k, 2) + u(k, 2), y(1), y(2), jacobian) /= 0) stop 1
    ue(1) = y(jtype) - x(e, 1)
    jdof = [e, k, 1, 2, 3, 1, 2, 3]
    a = [1.0_dp, -jacobian(jtype, 7), -jacobian(jtype, 1:6)]
end subroutine mpc
" };

/// The same constraint by its distances, as CalculiX calls it: the last term has the number of the equation.
const UMPC: Routine<'static> = Routine {
    abi: "umpc_user",
    file: "routine.f90",
    uses: &["slider.constraint"],
    text: include_str!("families/umpc_user.f90"),
};

/// The same constraint as an element with two multipliers.
const UEL: Routine<'static> = Routine { abi: "uel", file: "routine.f90", uses: &["slider.nodal_forces", "slider.constraint"], text: "
subroutine uel(rhs, amatrx, svars, energy, ndofel, nrhs, nsvars, props, nprops, coords, mcrd, nnode, u, du, v, a, &
        jtype, time, dtime, kstep, kinc, jelem, params, ndload, jdltyp, adlmag, predef, npredf, lflags, mlvarx, &
        ddlmag, mdload, pnewdt, jprops, njprop, period)
    use jp_slider_nodal_forces, only: jp_slider_nodal_forces_jacobian
    use jp_slider_constraint, only: jp_slider_constraint_jacobian
    implicit none
    integer, parameter :: dp = kind(1.0d0)
    integer :: ndofel, nrhs, nsvars, nprops, mcrd, nnode, jtype, kstep, kinc, jelem, ndload, npredf, mlvarx, mdload
    integer :: njprop, jdltyp(mdload, *), lflags(*), jprops(*)
    real(dp) :: rhs(mlvarx, *), amatrx(ndofel, ndofel), svars(*), energy(8), props(*), coords(mcrd, nnode), u(ndofel)
    real(dp) :: du(mlvarx, *), v(ndofel), a(ndofel), time(2), dtime, params(3), adlmag(mdload, *), ddlmag(mdload, *)
    real(dp) :: predef(2, npredf, nnode), pnewdt, period, x(3, 3), g(2), of_g(2, 9), f(3, 3), of_f(9, 11)
    x = coords(:, 1:3) + reshape(u(1:9), [3, 3])
    if (jp_slider_constraint_jacobian(x(:, 1), x(:, 2), x(:, 3), g(1), g(2), of_g) /= 0) stop 1
    if (jp_slider_nodal_forces_jacobian(x(:, 1), x(:, 2), x(:, 3), u(10), u(11), f(:, 1), f(:, 2), f(:, 3), of_f) /= 0) stop 1
    rhs(1:11, 1) = [f, g]
    amatrx(1:9, :) = -of_f
    amatrx(10:11, 1:9) = -of_g
    amatrx(10:11, 10:11) = 0
end subroutine uel
" };

/// The output of `check` for a routine with a text replaced in it; the exit code is asserted.
fn checked(routine: &Routine<'_>, id: &str, [from, to]: [&str; 2], code: i32) -> String {
    assert!(routine.text.contains(from), "{from}");
    let bench = Bench::new();
    std::fs::write(bench.path(routine.file), routine.text.replace(from, to)).unwrap();
    let driver = bench.run(&["check", "--formula", id, "--abi", routine.abi]).quiet().stdout;
    std::fs::write(bench.path("around.f90"), driver).unwrap();
    let mut files = Vec::new();
    for used in routine.uses {
        let out = bench.path("");
        bench.run(&["export", "--lang", "fortran", "--filter", used, "--out", out.to_str().unwrap()]).exits(0);
        files.extend(sources(&out, &used.replace('.', "_"), "f90"));
    }
    if !files.is_empty() {
        files.insert(0, "jp_runtime.f90".to_owned());
    }
    let flags = ["-std=legacy", "-O1", "-ffp-contract=off", "-o", "port"];
    let own = [routine.file, "around.f90"].map(str::to_owned);
    let output =
        Command::new("gfortran").args(flags).args(files).args(own).current_dir(bench.path("")).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let program = [bench.path("port").to_str().unwrap().to_owned()];
    check(&bench, id, &program, &["--valid-only", "--samples", "200"], code)
}

const AS_IT_IS: [&str; 2] = ["", ""];

/// Exported shells are routines with these interfaces.
#[test]
fn exported_shells_are_right() {
    if !Lang::Fortran.is_here() {
        return;
    }
    let [fric, mpc] = ["fric", "mpc"].map(|name| {
        let bench = Bench::new();
        bench.run(&["export", "--shell", name, "--out", bench.path("").to_str().unwrap()]).exits(0);
        let text = std::fs::read_to_string(bench.path(&format!("{name}.f90"))).unwrap();
        text.replace("include 'ABA_PARAM.INC'", "implicit double precision (a-h, o-z)")
    });
    let fric = Routine { abi: "fric", file: "routine.f90", text: &fric, uses: &[] };
    checked(&fric, "coulomb.return_map", AS_IT_IS, 0);
    checked(&fric, "coulomb.return_map_2d", AS_IT_IS, 0);
    let said = checked(&fric, "coulomb.return_map_2d", ["slope(:nfdir, nfdir + 2)", "slope(:nfdir, nfdir + 1)"], 1);
    assert!(said.contains("wrong"), "{said}");
    checked(&mpc_of(&mpc), "slider.eliminate", AS_IT_IS, 0);
    let said = checked(&mpc_of(&mpc), "slider.eliminate", ["-slope(jtype, 7)", "slope(jtype, 7)"], 1);
    assert!(said.contains("wrong"), "{said}");
}

const fn mpc_of(text: &str) -> Routine<'_> {
    Routine { abi: "mpc", file: "routine.f90", text, uses: &[] }
}

#[test]
fn a_friction_routine_is_checked_as_it_is() {
    if !Lang::Fortran.is_here() {
        return;
    }
    let id = "coulomb.return_map";
    checked(&FRIC, id, AS_IT_IS, 0);
    let said = checked(&FRIC, id, ["DDTDDG(1,1) = 0.D0", "DDTDDG(1,1) = PROPS(2)"], 1);
    assert!(said.contains("diagnosis: stick"), "{said}");
    let said = checked(&FRIC, id, ["DDTDDP(1) = SIGN(PROPS(1), TRIAL)", "DDTDDP(1) = PROPS(1)"], 1);
    assert!(said.contains("∂f/∂fn is "), "{said}");
}

#[test]
fn an_interaction_is_checked_by_its_pressure_and_by_its_friction() {
    if !Lang::Fortran.is_here() {
        return;
    }
    checked(&UINTER, "interaction.pressure_linear", AS_IT_IS, 0);
    checked(&UINTER, "coulomb.return_map", AS_IT_IS, 0);
    let coupling = ["DDSDDR(2,1) = SIGN(PROPS(3), TRIAL)*DDSDDR(1,1)", "DDSDDR(2,1) = 0.D0"];
    let said = checked(&UINTER, "coulomb.return_map", coupling, 1);
    assert!(said.contains("diagnosis: left out (always 0): ∂f/∂fn"), "{said}");
    let tension = ["STRESS(1) = PROPS(1)*RDISP(1)", "STRESS(1) = -PROPS(1)*RDISP(1)"];
    let said = checked(&UINTER, "interaction.pressure_linear", tension, 1);
    assert!(said.contains("diagnosis: wrong sign: p"), "{said}");
}

#[test]
fn constraints_are_checked_by_what_they_eliminate_and_by_their_distance() {
    if !Lang::Fortran.is_here() {
        return;
    }
    checked(&MPC, "slider.eliminate", AS_IT_IS, 0);
    let said = checked(&MPC, "slider.eliminate", ["a = [1.0_dp", "a = [-1.0_dp"], 1);
    assert!(said.contains("diagnosis: wrong sign: the whole Jacobian"), "{said}");
    checked(&UMPC, "slider.constraint", AS_IT_IS, 0);
    let said = checked(&UMPC, "slider.constraint", ["jdof(k) = 1", "jdof(k) = k"], 1);
    assert!(said.contains("wrong"), "{said}");
    let said = checked(&UMPC, "slider.constraint", ["k = maxloc(abs(row(1:3)), 1)", "k = 1"], 1);
    assert!(said.contains("A(1) is 0, and the first term is eliminated"), "{said}");
    let said = checked(&UMPC, "slider.constraint", ["jdof(1:9) = [1, 2, 3, 1, 2, 3, 1, 2, 3]", ""], 1);
    assert!(said.contains("is still 0: CalculiX passes in (1, 0, 0, ...)"), "{said}");
}

#[test]
fn an_element_is_checked_by_its_forces_and_by_its_constraint() {
    if !Lang::Fortran.is_here() {
        return;
    }
    for id in UEL.uses {
        checked(&UEL, id, AS_IT_IS, 0);
    }
    let said = checked(&UEL, "slider.nodal_forces", ["= -of_f", "= of_f"], 1);
    assert!(said.contains("diagnosis: wrong sign: the whole Jacobian"), "{said}");
}

#[test]
fn every_driver_compiles_without_a_warning() {
    if !Lang::Fortran.is_here() {
        return;
    }
    let bench = Bench::new();
    for abi in ["fric", "mpc", "mpc-node", "uinter", "uel", "umpc_user"] {
        let other =
            bench.run(&["check", "--formula", "join.rows", "--abi", abi]).bad_usage("does not compute join.rows");
        let ids: Vec<_> = other.stderr.lines().skip(1).map(str::trim).collect();
        assert!(ids.len() > 1, "{other:?}");
        for id in ids {
            let driver = bench.run(&["check", "--formula", id, "--abi", abi]).quiet().stdout;
            std::fs::write(bench.path("around.f90"), driver).unwrap();
            let flags = ["-std=f2008", "-Wall", "-Werror", "-fsyntax-only", "around.f90"];
            let output = Command::new("gfortran").args(flags).current_dir(bench.path("")).output().unwrap();
            assert!(output.status.success(), "{abi} {id}: {}", String::from_utf8_lossy(&output.stderr));
        }
    }
}

#[test]
fn what_a_routine_cannot_compute_is_told_with_what_it_can() {
    for (abi, id, instead) in [
        ("fric", "slider.line", "coulomb.return_map"),
        ("mpc", "slider.constraint", "slider.eliminate"),
        ("uinter", "interaction.damping", "interaction.pressure_linear"),
        ("uel", "join.rows", "slider.nodal_forces"),
        ("umpc_user", "slider.eliminate", "slider.constraint"),
    ] {
        let ran = Bench::new().run(&["check", "--formula", id, "--abi", abi]);
        ran.bad_usage(&format!("does not compute {id}, but\n  ")).says(instead);
    }
}
