! PROPS(1) is the friction coefficient and PROPS(2) the stiffness while it sticks, which is 1. Tractions start
! at 0, so that DGAM is the trial traction. FRIC is not asked for the derivative by the coefficient.
---
    subroutine ask()
        integer, parameter :: nfdir = outputs, mcrd = nfdir + 1, npred = 1, nstatv = 10, nprops = 2
        real(dp) :: tau(nfdir), ddtddg(nfdir, nfdir), ddtddp(nfdir), dslip(nfdir), sed, sfd, ddtddt(nfdir, 2), pnewdt
        real(dp) :: statev(nstatv), dgam(nfdir), taulm(nfdir), press, dpress, ddpddh, slip(nfdir), time(2), dtime
        real(dp) :: coords(mcrd), rcoord(mcrd), drot(2, 2), temp(2), predef(2, npred), chrlngth(2), props(nprops)
        integer :: lm, kstep, kinc, noel, npt, node, npatch
        character(len=80) :: ciname, slname, msname
        external :: fric
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
        dgam = x(1:nfdir)
        taulm = x(nfdir + 1) * x(nfdir + 2)
        press = x(nfdir + 2)
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
        props = [x(nfdir + 1), 1.0_dp]
        call fric(lm, tau, ddtddg, ddtddp, dslip, sed, sfd, ddtddt, pnewdt, statev, dgam, taulm, press, dpress, &
            ddpddh, slip, kstep, kinc, time, dtime, noel, ciname, slname, msname, npt, node, npatch, coords, rcoord, &
            drot, temp, predef, nfdir, mcrd, npred, nstatv, chrlngth, props, nprops)
        y = tau
        jacobian(:, 1:nfdir) = ddtddg
        is_known(:, nfdir + 1) = .false.
        jacobian(:, nfdir + 2) = ddtddp
    end subroutine ask
