! RDISP(1) is the overclosure, and STRESS(1) the pressure, positive in compression.
! PROPS are {props}.
{history}
! STRESS, RDISP and STATEV (10 of them, 0 at first) are carried from increment to increment; before the last one the
! routine is asked for another motion, as if that increment were cut back, and for other points. DDSDDR comes in as the last
! call left it. PNEWDT < 1 refuses a point.
---
module driver_call
    use driver_checks
    implicit none
    integer, parameter :: ndir = {ndir}, mcrd = ndir, nstatv = 10, npred = 1, nprops = {nprops}
    ! What is carried from increment to increment.
    real(dp) :: stress(ndir), statev(nstatv), rdisp(ndir)
    integer :: kinc
    ! The same at the start of the last increment.
    real(dp) :: before(ndir), states(nstatv), moved(ndir)
    ! What a call gives besides.
    real(dp) :: ddsddr(ndir, ndir), pnewdt, props(nprops)
contains
    {problem}

    ! The last increment begins here.
    subroutine keep()
        before = stress
        states = statev
        moved = rdisp
    end subroutine keep

    ! It is cut back.
    subroutine back()
        stress = before
        statev = states
        rdisp = moved
        kinc = 2
    end subroutine back

    ! A point that has never touched.
    subroutine begin()
        stress = 0
        statev = 0
        rdisp = 0
        ddsddr = 0
        kinc = 0
    end subroutine begin

    ! Another point, of another pair of surfaces, is open, then slips and sticks.
    subroutine elsewhere()
        real(dp) :: given(nprops)
        integer :: axis
        given = props
        stress = 0
        statev = 0
        rdisp = 0
        props = given * [(1.5_dp + axis, axis=1, nprops)]
        call increment(-1 / props(1), [(1 / props(2), axis=2, ndir)])
        {open}
        call increment(0.5_dp / props(1), [(4 / props(2), axis=2, ndir)])
        call increment(50 / props(1), [(-0.125_dp * axis / props(2), axis=2, ndir)])
        props = given
    end subroutine elsewhere

    ! An increment to this overclosure, with this slip.
    subroutine increment(overclosure, slip)
        real(dp), intent(in) :: overclosure, slip(ndir - 1)
        integer, parameter :: g = margin
        real(dp) :: a_stress(1 - g:ndir + g), a_ddr(1 - g:ndir**2 + g), a_viscous(1 - g:ndir**2 + g), given(nprops)
        real(dp) :: a_structural(1 - g:ndir**2 + g), a_ddt(1 - g:2 * ndir + g), a_fdr(1 - g:2 * ndir + g)
        real(dp) :: a_statev(1 - g:nstatv + g), a_rdisp(1 - g:ndir + g), a_drdisp(1 - g:ndir + g)
        real(dp) :: a_props(1 - g:nprops + g), flux(2), ddfddt(2, 2), sed, sfd, spd, svd, scd, temp(2), dtemp(2)
        real(dp) :: predef(2, npred), dpred(2, npred), time(2), dtime, freqr, coords(mcrd), alocaldir(3, 3), drot(2, 2)
        real(dp) :: area, chrlngth, reached(ndir), motion(ndir)
        integer :: lopenclose, lstate, lsdi, kstep, in_step
        character(len=80) :: ciname, secname, mainname
        external :: uinter
        given = props
        motion = [overclosure - rdisp(1), slip]
        reached = [overclosure, rdisp(2:) + slip]
        kinc = kinc + 1
        ! The third increment is the first of the second step.
        kstep = merge(2, 1, kinc > 2)
        in_step = kinc - 2 * (kstep - 1)
        a_stress = guard
        a_stress(1:ndir) = stress
        a_ddr = guard
        a_ddr(1:ndir**2) = reshape(ddsddr, [ndir**2])
        a_viscous = guard
        a_viscous(1:ndir**2) = 0
        a_structural = guard
        a_structural(1:ndir**2) = 0
        a_ddt = guard
        a_ddt(1:2 * ndir) = 0
        a_fdr = guard
        a_fdr(1:2 * ndir) = 0
        a_statev = guard
        a_statev(1:nstatv) = statev
        a_rdisp = guard
        a_rdisp(1:ndir) = reached
        a_drdisp = guard
        a_drdisp(1:ndir) = motion
        a_props = guard
        a_props(1:nprops) = given
        flux = 0
        ddfddt = 0
        sed = 0.125_dp
        sfd = 0
        spd = 0
        svd = 0
        scd = 0
        pnewdt = 1
        temp = 20
        dtemp = 1
        predef = 3
        dpred = 1
        time = [0.25_dp, 1.25_dp] * kinc
        dtime = 0.25_dp
        freqr = 0
        ciname = 'INTERACTION'
        secname = 'SECONDARY'
        mainname = 'MAIN'
        coords = 3.5_dp + kinc
        alocaldir = reshape([0, 1, 0, 0, 0, 1, 1, 0, 0], [3, 3])
        drot = reshape([1, 0, 0, 1], [2, 2])
        area = 0.75_dp
        chrlngth = 0.5_dp
        lopenclose = -1
        lstate = -1
        lsdi = 0
        call clear_stack()
        call uinter(a_stress(1), a_ddr(1), a_viscous(1), a_structural(1), flux, ddfddt, a_ddt(1), a_fdr(1), a_statev(1), &
            sed, sfd, spd, svd, scd, pnewdt, a_rdisp(1), a_drdisp(1), temp, dtemp, predef, dpred, time, dtime, freqr, &
            ciname, secname, mainname, a_props(1), coords, alocaldir, drot, area, chrlngth, 34, ndir, nstatv, npred, &
            nprops, mcrd, kstep, in_step, 2, 0, lopenclose, lstate, lsdi, 0)
        call look_around('STRESS', a_stress, ndir)
        call look_around('DDSDDR', a_ddr, ndir**2)
        call look_around('DVISCOUS', a_viscous, ndir**2)
        call look_around('DSTRUCTURAL', a_structural, ndir**2)
        call look_around('DDSDDT', a_ddt, 2 * ndir)
        call look_around('DDFDDR', a_fdr, 2 * ndir)
        call look_around('STATEV', a_statev, nstatv)
        call look_around('RDISP', a_rdisp, ndir)
        call look_around('DRDISP', a_drdisp, ndir)
        call look_around('PROPS', a_props, nprops)
        call is_kept('RDISP', ndir, a_rdisp(1:ndir), reached)
        call is_kept('DRDISP', ndir, a_drdisp(1:ndir), motion)
        call is_kept('PROPS', nprops, a_props(1:nprops), given)
        if (.not. pnewdt > 0) call fail('PNEWDT is not above 0')
        if (abs(lsdi) > 1) call fail('LSDI is neither 0 nor 1')
        stress = a_stress(1:ndir)
        statev = a_statev(1:nstatv)
        ddsddr = reshape(a_ddr(1:ndir**2), [ndir, ndir])
        rdisp = reached
    end subroutine increment
end module driver_call
