! RDISP(1) is the overclosure, and STRESS(1) the pressure, positive in compression. RDISP starts at 0, as do the
! stresses, so that DRDISP is RDISP.
! PROPS are {props}.
---
    subroutine ask()
        integer, parameter :: ndir = {ndir}, mcrd = ndir, nstatv = 10, npred = 1, nprops = {nprops}
        real(dp) :: stress(ndir), ddsddr(ndir, ndir), dviscous(ndir, ndir), dstructural(ndir, ndir), flux(2)
        real(dp) :: ddfddt(2, 2), ddsddt(ndir, 2), ddfddr(2, ndir), statev(nstatv), sed, sfd, spd, svd, scd, pnewdt
        real(dp) :: rdisp(ndir), drdisp(ndir), temp(2), dtemp(2), predef(2, npred), dpred(2, npred), time(2), dtime
        real(dp) :: freqr, props(nprops), coords(mcrd), alocaldir(3, 3), drot(2, 2), area, chrlngth
        integer :: node, kstep, kinc, kit, linper, lopenclose, lstate, lsdi, lprint
        character(len=80) :: ciname, secname, mainname
        external :: uinter
        stress = 0
        ddsddr = 0
        dviscous = 0
        dstructural = 0
        flux = 0
        ddfddt = 0
        ddsddt = 0
        ddfddr = 0
        statev = 0
        sed = 0
        sfd = 0
        spd = 0
        svd = 0
        scd = 0
        pnewdt = 1
        temp = 0
        dtemp = 0
        predef = 0
        dpred = 0
        time = 1
        dtime = 1
        freqr = 0
        ciname = 'INTERACTION'
        secname = 'SECONDARY'
        mainname = 'MAIN'
        coords = 0
        alocaldir = reshape([1, 0, 0, 0, 1, 0, 0, 0, 1], [3, 3])
        drot = reshape([1, 0, 0, 1], [2, 2])
        area = 1
        chrlngth = 1
        node = 1
        kstep = 1
        kinc = 1
        kit = 1
        linper = 0
        lopenclose = -1
        lstate = -1
        lsdi = 0
        lprint = 0
        {set}
        drdisp = rdisp
        call uinter(stress, ddsddr, dviscous, dstructural, flux, ddfddt, ddsddt, ddfddr, statev, sed, sfd, spd, svd, &
            scd, pnewdt, rdisp, drdisp, temp, dtemp, predef, dpred, time, dtime, freqr, ciname, secname, mainname, &
            props, coords, alocaldir, drot, area, chrlngth, node, ndir, nstatv, npred, nprops, mcrd, kstep, kinc, &
            kit, linper, lopenclose, lstate, lsdi, lprint)
        {get}
    end subroutine ask
