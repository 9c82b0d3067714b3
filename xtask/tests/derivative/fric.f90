! Friction whose coefficient decays with the slip rate and the pressure: PROPS are its limits, the decay, and the stiffness.
subroutine fric(lm, tau, ddtddg, ddtddp, dslip, sed, sfd, ddtddt, pnewdt, statev, dgam, taulm, press, dpress, ddpddh, &
        slip, kstep, kinc, time, dtime, noel, ciname, slname, msname, npt, node, npatch, coords, rcoord, drot, temp, &
        predef, nfdir, mcrd, npred, nstatv, chrlngth, props, nprops)
    implicit none
    integer, parameter :: dp = kind(1.0d0)
    integer :: lm, kstep, kinc, noel, npt, node, npatch, nfdir, mcrd, npred, nstatv, nprops
    character(len=80) :: ciname, slname, msname
    real(dp) :: tau(1), ddtddg(1, 1), ddtddp(1), dslip(1), sed, sfd, ddtddt(1, 2), pnewdt, statev(*), dgam(1), taulm(1), press
    real(dp) :: dpress, ddpddh, slip(1), time(2), dtime, coords(2), rcoord(2), drot(2, 2), temp(2), predef(2, *), chrlngth(2)
    real(dp) :: props(*)
    real(dp) :: trial, rate, mu, dmu, s
    lm = 0
    trial = tau(1) + props(4) * dgam(1)
    rate = abs(dgam(1)) / dtime
    mu = props(1) + (props(2) - props(1)) * exp(-props(3) * rate)
    dmu = -props(3) * (props(2) - props(1)) * exp(-props(3) * rate) / dtime
    if (abs(trial) < mu * press) then
        tau(1) = trial
        ddtddg(1, 1) = props(4)
        ddtddp(1) = 0
    else
        s = sign(1.0_dp, trial)
        tau(1) = s * mu * press
        ddtddg(1, 1) = s * dmu * press * sign(1.0_dp, dgam(1))
        ddtddp(1) = s * mu
    end if
end subroutine fric
