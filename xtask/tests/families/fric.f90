subroutine fric(lm, tau, ddtddg, ddtddp, dslip, sed, sfd, ddtddt, pnewdt, statev, dgam, taulm, press, dpress, ddpddh, &
        slip, kstep, kinc, time, dtime, noel, ciname, slname, msname, npt, node, npatch, coords, rcoord, drot, temp, &
        predef, nfdir, mcrd, npred, nstatv, chrlngth, props, nprops)
    implicit none
    integer, parameter :: dp = kind(1.0d0)
    integer :: lm, kstep, kinc, noel, npt, node, npatch, nfdir, mcrd, npred, nstatv, nprops
    character(len=80) :: ciname, slname, msname
    real(dp) :: tau(2), ddtddg(2, 2), ddtddp(2), dslip(2), sed, sfd, ddtddt(2, 2), pnewdt, statev(*), dgam(2), taulm(2), press
    real(dp) :: dpress, ddpddh, slip(2), time(2), dtime, coords(3), rcoord(3), drot(2, 2), temp(2), predef(2, *), chrlngth(2)
    real(dp) :: props(*)
    real(dp) :: stick, limit, t1, t2, length, n1, n2, slope
    ! begin
    lm = 0
    stick = props(2)
    limit = props(1) * press
    t1 = tau(1) + stick * dgam(1)
    t2 = tau(2) + stick * dgam(2)
    length = hypot(t1, t2)
    if (length <= limit) then
        tau(1) = t1
        tau(2) = t2
        ddtddg(1, 1) = stick
        ddtddg(1, 2) = 0
        ddtddg(2, 1) = 0
        ddtddg(2, 2) = stick
        ddtddp(1) = 0
        ddtddp(2) = 0
        dslip(1) = 0
        dslip(2) = 0
    else
        n1 = t1 / length
        n2 = t2 / length
        tau(1) = limit * n1
        tau(2) = limit * n2
        slope = stick * (limit / length)
        ddtddg(1, 1) = slope * n2 * n2
        ddtddg(1, 2) = -slope * n1 * n2
        ddtddg(2, 1) = -slope * n2 * n1
        ddtddg(2, 2) = slope * n1 * n1
        ddtddp(1) = props(1) * n1
        ddtddp(2) = props(1) * n2
        dslip(1) = (length - limit) / stick * n1
        dslip(2) = (length - limit) / stick * n2
    end if
    ! end
end subroutine fric
