subroutine uinter(stress, ddsddr, dviscous, dstructural, flux, ddfddt, ddsddt, ddfddr, statev, sed, sfd, spd, svd, scd, &
        pnewdt, rdisp, drdisp, temp, dtemp, predef, dpred, time, dtime, freqr, ciname, secname, mainname, props, coords, &
        alocaldir, drot, area, chrlngth, node, ndir, nstatv, npred, nprops, mcrd, kstep, kinc, kit, linper, lopenclose, &
        lstate, lsdi, lprint)
    implicit none
    integer, parameter :: dp = kind(1.0d0)
    integer :: node, ndir, nstatv, npred, nprops, mcrd, kstep, kinc, kit, linper, lopenclose, lstate, lsdi, lprint
    character(len=80) :: ciname, secname, mainname
    real(dp) :: stress(3), ddsddr(3, 3), dviscous(3, 3), dstructural(3, 3), flux(2), ddfddt(2, 2), ddsddt(3, 2), ddfddr(2, 3)
    real(dp) :: statev(*), sed, sfd, spd, svd, scd, pnewdt, rdisp(3), drdisp(3), temp(2), dtemp(2), predef(2, *), dpred(2, *)
    real(dp) :: time(2), dtime, freqr, props(*), coords(3), alocaldir(3, 3), drot(2, 2), area, chrlngth
    real(dp) :: limit, t1, t2, length, n1, n2, slope
    ! begin
    ddsddr(1, 1) = 0
    ddsddr(1, 2) = 0
    ddsddr(1, 3) = 0
    ddsddr(2, 1) = 0
    ddsddr(3, 1) = 0
    stress(1) = 0
    if (rdisp(1) > 0) then
        stress(1) = props(1) * rdisp(1)
        ddsddr(1, 1) = props(1)
    end if
    limit = props(3) * stress(1)
    t1 = statev(1) + props(2) * drdisp(2)
    t2 = statev(2) + props(2) * drdisp(3)
    length = hypot(t1, t2)
    if (length <= limit) then
        stress(2) = t1
        stress(3) = t2
        ddsddr(2, 2) = props(2)
        ddsddr(2, 3) = 0
        ddsddr(3, 2) = 0
        ddsddr(3, 3) = props(2)
    else
        n1 = t1 / length
        n2 = t2 / length
        stress(2) = limit * n1
        stress(3) = limit * n2
        slope = props(2) * (limit / length)
        ddsddr(2, 2) = slope * n2 * n2
        ddsddr(2, 3) = -slope * n1 * n2
        ddsddr(3, 2) = -slope * n2 * n1
        ddsddr(3, 3) = slope * n1 * n1
        ddsddr(2, 1) = props(3) * n1 * ddsddr(1, 1)
        ddsddr(3, 1) = props(3) * n2 * ddsddr(1, 1)
    end if
    statev(1) = stress(2)
    statev(2) = stress(3)
    ! end
end subroutine uinter
