! It is called with TAU, properties and states of the file as they are at the start of the increment; the numbers asked for are
! DGAM and PRESS. A state in which it sticks by LM = 1 has no derivative and is refused, as is one with PNEWDT < 1.
---
module driver_call
    use driver_checks
    implicit none
    integer, parameter :: nfdir = outputs, mcrd = nfdir + 1, npred = 1, nstatv = {nsvars}, nprops = {nprops}
contains
    subroutine ask()
        integer, parameter :: g = margin
        real(dp) :: a_tau(1 - g:nfdir + g), a_ddg(1 - g:nfdir**2 + g), a_ddp(1 - g:nfdir + g), a_statev(1 - g:nstatv + g)
        real(dp) :: dslip(nfdir), sed, sfd, ddtddt(nfdir, 2), pnewdt, dgam(nfdir), taulm(nfdir), press, dpress, ddpddh
        real(dp) :: slip(nfdir), time(2), dtime, coords(mcrd), rcoord(mcrd), drot(2, 2), temp(2), predef(2, npred)
        real(dp) :: chrlngth(2), properties(max(1, nprops))
        real(dp), parameter :: props(max(1, nprops)) = {props}
        real(dp), parameter :: statev(max(1, nstatv)) = {svars}
        integer :: lm
        character(len=80) :: ciname, slname, msname
        external :: fric
        lm = 0
        a_tau = guard
        a_tau(1:nfdir) = {tau}
        a_ddg = guard
        a_ddg(1:nfdir**2) = 0
        a_ddp = guard
        a_ddp(1:nfdir) = 0
        a_statev = guard
        a_statev(1:nstatv) = statev(1:nstatv)
        properties = props
        dslip = 0
        sed = 0
        sfd = 0
        ddtddt = 0
        pnewdt = 1
        dgam = x(1:nfdir)
        taulm = 0
        press = x(nfdir + 1)
        dpress = 0
        ddpddh = 1
        slip = 0
        time = {dtime}
        dtime = {dtime}
        coords = 0
        rcoord = 0
        drot = reshape([1.0_dp, 0.0_dp, 0.0_dp, 1.0_dp], [2, 2])
        temp = 0
        predef = 0
        chrlngth = 1
        ciname = 'INTERACTION'
        slname = 'SLAVE'
        msname = 'MASTER'
        call clear_stack()
        call fric(lm, a_tau(1), a_ddg(1), a_ddp(1), dslip, sed, sfd, ddtddt, pnewdt, a_statev(1), dgam, taulm, press, &
            dpress, ddpddh, slip, 1, 1, time, dtime, 1, ciname, slname, msname, 1, 1, 1, coords, rcoord, drot, temp, &
            predef, nfdir, mcrd, npred, nstatv, chrlngth, properties, nprops)
        call look_around('TAU', a_tau, nfdir)
        call look_around('DDTDDG', a_ddg, nfdir**2)
        call look_around('DDTDDP', a_ddp, nfdir)
        call look_around('STATEV', a_statev, nstatv)
        is_refused = pnewdt < 1 .or. lm == 1
        y = a_tau(1:nfdir)
        jacobian(:, 1:nfdir) = reshape(a_ddg(1:nfdir**2), [nfdir, nfdir])
        jacobian(:, nfdir + 1) = a_ddp(1:nfdir)
    end subroutine ask
end module driver_call
