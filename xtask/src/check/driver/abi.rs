//! Drivers around routines whose interface a program of finite elements prescribes.

use jointproof::catalog::AnyFormula;
use jointproof::coulomb::ReturnMap;
use jointproof::formula::Formula;

/// An interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Abi {
    /// A friction model: FRIC, in two dimensions
    Fric,
}

/// The driver of an interface; `None` where it computes another formula.
pub(crate) fn text(abi: Abi, formula: &dyn AnyFormula) -> Option<String> {
    match abi {
        Abi::Fric => (formula.spec().id == ReturnMap::SPEC.id).then(|| FRIC.replace("{id}", ReturnMap::SPEC.id)),
    }
}

/// TAU(1) starts at 0 and the stiffness while it sticks is 1, so that DGAM(1) is the trial force, and DDTDDG(1,1) the
/// derivative by it.
const FRIC: &str = "! Answers `jointproof check --formula {id} --valid-only -- PROGRAM` with a routine FRIC:
!
!     gfortran -std=legacy this.f90 fric.f
!
! PROPS(1) is the friction coefficient and PROPS(2) the stiffness while it sticks, which is 1. Tractions start
! at 0, so that DGAM(1) is the trial traction. The derivative by the coefficient is not asked of FRIC: it is `-`.
program answer
    implicit none
    integer, parameter :: dp = kind(1.0d0), nfdir = 1, mcrd = 2, npred = 1, nstatv = 10, nprops = 2
    real(dp) :: f_trial, mu, fn
    real(dp) :: tau(nfdir), ddtddg(nfdir, nfdir), ddtddp(nfdir), dslip(nfdir), sed, sfd, ddtddt(nfdir, 2), pnewdt
    real(dp) :: statev(nstatv), dgam(nfdir), taulm(nfdir), press, dpress, ddpddh, slip(nfdir), time(2), dtime
    real(dp) :: coords(mcrd), rcoord(mcrd), drot(2, 2), temp(2), predef(2, npred), chrlngth(2), props(nprops)
    integer :: lm, kstep, kinc, noel, npt, node, npatch, status
    character(len=80) :: ciname, slname, msname
    external :: fric
    do
        read (*, *, iostat=status) f_trial, mu, fn
        if (status /= 0) exit
        lm = 0
        tau = 0
        ddtddg = 0
        ddtddp = 0
        dslip = 0
        sed = 0
        sfd = 0
        ddtddt = 0
        pnewdt = 1
        statev = 0
        dgam = f_trial
        taulm = mu * fn
        press = fn
        dpress = 0
        ddpddh = 0
        slip = 0
        kstep = 1
        kinc = 1
        time = 0
        dtime = 1
        noel = 1
        ciname = 'INTERACTION'
        slname = 'SLAVE'
        msname = 'MASTER'
        npt = 1
        node = 1
        npatch = 1
        coords = 0
        rcoord = 0
        drot = reshape([1.0_dp, 0.0_dp, 0.0_dp, 1.0_dp], [2, 2])
        temp = 0
        predef = 0
        chrlngth = 1
        props = [mu, 1.0_dp]
        call fric(lm, tau, ddtddg, ddtddp, dslip, sed, sfd, ddtddt, pnewdt, statev, dgam, taulm, press, dpress, &
            ddpddh, slip, kstep, kinc, time, dtime, noel, ciname, slname, msname, npt, node, npatch, coords, rcoord, &
            drot, temp, predef, nfdir, mcrd, npred, nstatv, chrlngth, props, nprops)
        write (*, '(2es25.16e3, a, es25.16e3)') tau(1), ddtddg(1, 1), ' -', ddtddp(1)
        flush (6)
    end do
end program answer
";
