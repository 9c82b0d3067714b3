! PROPS(1) is the friction coefficient and PROPS(2) the stiffness K while it sticks, which differs from point to point.
! There are three increments: it slips, then sticks, then, in a second step, goes to the trial traction TAU + K DGAM. Before the
! last one it is asked for another DGAM, as if that increment were cut back. TAU and STATEV (10 of them, 0 at first) are carried.
! DDTDDG and DDTDDP come in as the last call left them, and other points are asked for in between.
! A routine that sticks by LM = 1 need not set anything else while it sticks; TAULM is then the trial traction. DSLIP may
! stay as it is; where it is set it is the slip that is not elastic. PNEWDT < 1 refuses a point.
! FRIC is not asked for the derivative with respect to the coefficient.
---
module driver_call
    use driver_checks
    implicit none
    integer, parameter :: nfdir = outputs, mcrd = nfdir + 1, npred = 1, nstatv = 10, nprops = 2
    ! What is carried from increment to increment.
    real(dp) :: tau(nfdir), statev(nstatv), slip(nfdir), press
    integer :: kinc
    ! What a call gives besides.
    real(dp) :: ddtddg(nfdir, nfdir), ddtddp(nfdir), dslip(nfdir), stiffness, pnewdt, props(nprops)
    integer :: lm
contains
    subroutine ask()
        real(dp) :: trial(nfdir), most, start(nfdir), before(nfdir), states(nstatv), dgam(nfdir), plastic(nfdir), high
        real(dp) :: by_slip(nfdir, nfdir), by_press(nfdir), left(nfdir)
        integer :: k, exit_flag
        logical :: has_past, is_rigid
        trial = x(1:nfdir)
        most = maxval(abs(trial))
        stiffness = power_of_two(most, 1)
        call begin()
        ! Whether a point sticks by LM = 1.
        props = [0.5_dp, stiffness]
        call increment([(0.0625_dp / stiffness, k=1, nfdir)], 1.0_dp)
        is_rigid = lm == 1
        call begin()
        high = 0
        if (x(nfdir + 1) > 0 .and. most > 0 .and. is_ordinary) high = 8 * (most / x(nfdir + 1))
        has_past = high > 0 .and. high < 1e150_dp .and. x(nfdir + 1) * high > 4 * most
        if (has_past) then
            call increment(-2 * trial / stiffness, high / 32)
            do k = 1, nfdir
                start(k) = started(trial(k), most, 10 + k)
            end do
            if (is_rigid) start = trial / 2
            call increment((start - tau) / stiffness, high)
            if (is_rigid) tau = start
            if (differ(tau, start, most)) then
                call fail('TAU after an increment that slips and one that sticks is not TAU + PROPS(2) DGAM')
            end if
        end if
        before = tau
        states = statev
        dgam = (trial - tau) / stiffness
        call increment(-3 * dgam + 1 / stiffness, 2 * x(nfdir + 2))
        call elsewhere()
        call back()
        if (is_rigid) then
            ! While it slips, its direction may be that of DGAM or that of TAULM.
            call begin()
            dgam = trial / stiffness
        end if
        dslip = -0.375_dp * dgam
        left = dslip
        call increment(dgam, x(nfdir + 2))
        is_refused = pnewdt < 1
        exit_flag = lm
        y = tau
        if (lm == 2) y = 0
        if (lm == 1) y = trial
        by_slip = ddtddg
        by_press = ddtddp
        is_known(:, 1:nfdir) = lm /= 1
        jacobian(:, 1:nfdir) = ddtddg / stiffness
        is_known(:, nfdir + 1) = .false.
        jacobian(:, nfdir + 2) = ddtddp
        is_known(:, nfdir + 2) = lm /= 1
        if (lm == 2) jacobian = 0
        call look_at_states('STATEV', statev, max(most, maxval(abs(x)), stiffness, 1 / stiffness, maxval(abs(dgam))))
        if (is_rigid) then
            if (exit_flag /= 0) return
            before = start
            call back()
            call increment((trial - tau) / stiffness, x(nfdir + 2))
            if (lm == 1) tau = trial
            if (differ(tau, y, maxval(abs(y)))) call fail('TAU at the start of the increment is not used as it should')
            return
        end if
        if (lm == 0 .and. any(abs(dslip - left) > 0)) then
            plastic = dgam - (tau - before) / stiffness
            if (differ(dslip, plastic, maxval(abs(dgam)) + maxval(abs(before)) / stiffness)) then
                call fail('DSLIP is not the slip that is not elastic, DGAM - (TAU - TAU at the start) / PROPS(2)')
            end if
        end if
        ! The same in another iteration: nothing may depend on the one before.
        plastic = dslip
        call elsewhere()
        call back()
        dslip = plastic
        call increment(dgam, x(nfdir + 2), is_again=.true.)
        if (lm /= exit_flag .or. differ(tau, y, maxval(abs(y)))) then
            call fail('TAU of an increment that is repeated differs: it depends on LM, TAULM, DSLIP or on the last call')
        end if
        if (differ([ddtddg], [by_slip], maxval(abs(by_slip))) .or. differ(ddtddp, by_press, maxval(abs(by_press)))) then
            call fail('DDTDDG or DDTDDP of an increment that is repeated differs')
        end if
    contains
        subroutine back()
            tau = before
            statev = states
            kinc = 2
        end subroutine back
    end subroutine ask

    ! Another point, of another pair of surfaces, slips and then sticks.
    subroutine elsewhere()
        integer :: axis
        props = [0.375_dp, 1.5_dp * stiffness]
        tau = 0.5_dp
        statev = 0
        call increment([(4 / stiffness, axis=1, nfdir)], 1.0_dp)
        call increment([(-0.125_dp * axis / stiffness, axis=1, nfdir)], 5.0_dp)
        props = [x(nfdir + 1), stiffness]
    end subroutine elsewhere

    ! A point that has just closed.
    subroutine begin()
        props = [x(nfdir + 1), stiffness]
        tau = 0
        statev = 0
        slip = 0
        dslip = 0
        press = 0
        kinc = 0
        ddtddg = 0
        ddtddp = 0
    end subroutine begin

    subroutine increment(dgam, now, is_again)
        real(dp), intent(in) :: dgam(nfdir), now
        logical, intent(in), optional :: is_again
        integer, parameter :: g = margin
        real(dp) :: a_tau(1 - g:nfdir + g), a_ddg(1 - g:nfdir**2 + g), a_ddp(1 - g:nfdir + g), a_dslip(1 - g:nfdir + g)
        real(dp) :: a_ddt(1 - g:2 * nfdir + g), a_statev(1 - g:nstatv + g), a_dgam(1 - g:nfdir + g)
        real(dp) :: a_taulm(1 - g:nfdir + g), a_slip(1 - g:nfdir + g), a_props(1 - g:nprops + g)
        real(dp) :: sed, sfd, pressure, dpress, ddpddh, time(2), dtime, coords(mcrd), rcoord(mcrd)
        real(dp) :: drot(2, 2), temp(2), predef(2, npred), chrlngth(2), taulm(nfdir), coefficient(nprops)
        integer :: kstep, in_step
        character(len=80) :: ciname, slname, msname
        external :: fric
        lm = 1
        taulm = tau + props(2) * dgam
        if (present(is_again)) then
            lm = 0
            taulm = 0
        end if
        kinc = kinc + 1
        ! The third increment is the first of the second step.
        kstep = merge(2, 1, kinc > 2)
        in_step = kinc - 2 * (kstep - 1)
        coefficient = props
        a_tau = guard
        a_tau(1:nfdir) = tau
        a_ddg = guard
        a_ddg(1:nfdir**2) = reshape(ddtddg, [nfdir**2])
        a_ddp = guard
        a_ddp(1:nfdir) = ddtddp
        a_dslip = guard
        a_dslip(1:nfdir) = dslip
        a_ddt = guard
        a_ddt(1:2 * nfdir) = 0
        a_statev = guard
        a_statev(1:nstatv) = statev
        a_dgam = guard
        a_dgam(1:nfdir) = dgam
        a_taulm = guard
        a_taulm(1:nfdir) = taulm
        a_slip = guard
        a_slip(1:nfdir) = slip
        a_props = guard
        a_props(1:nprops) = coefficient
        sed = 0.125_dp
        sfd = 0
        pnewdt = 1
        pressure = now
        dpress = now - press
        ddpddh = 5
        time = [0.25_dp, 1.25_dp] * kinc
        dtime = 0.25_dp
        coords = 3.5_dp + kinc
        rcoord = 2 * coords
        drot = reshape([1.0_dp, 0.0_dp, 0.0_dp, 1.0_dp], [2, 2])
        temp = 20
        predef = 3
        chrlngth = 0.5_dp
        ciname = 'INTERACTION'
        slname = 'SLAVE'
        msname = 'MASTER'
        call clear_stack()
        call fric(lm, a_tau(1), a_ddg(1), a_ddp(1), a_dslip(1), sed, sfd, a_ddt(1), pnewdt, a_statev(1), a_dgam(1), &
            a_taulm(1), pressure, dpress, ddpddh, a_slip(1), kstep, in_step, time, dtime, 12, ciname, slname, msname, 3, 34, 2, &
            coords, rcoord, drot, temp, predef, nfdir, mcrd, npred, nstatv, chrlngth, a_props(1), nprops)
        call look_around('TAU', a_tau, nfdir)
        call look_around('DDTDDG', a_ddg, nfdir**2)
        call look_around('DDTDDP', a_ddp, nfdir)
        call look_around('DSLIP', a_dslip, nfdir)
        call look_around('DDTDDT', a_ddt, 2 * nfdir)
        call look_around('STATEV', a_statev, nstatv)
        call look_around('DGAM', a_dgam, nfdir)
        call look_around('TAULM', a_taulm, nfdir)
        call look_around('SLIP', a_slip, nfdir)
        call look_around('PROPS', a_props, nprops)
        call is_kept('DGAM', nfdir, a_dgam(1:nfdir), dgam)
        call is_kept('SLIP', nfdir, a_slip(1:nfdir), slip)
        call is_kept('PROPS', nprops, a_props(1:nprops), coefficient)
        call is_kept('PRESS', 1, [pressure], [now])
        if (lm < 0 .or. lm > 2) call fail('LM is ' // text(lm) // ', and may be 0, 1 or 2')
        if (.not. pnewdt > 0) call fail('PNEWDT is not above 0')
        tau = a_tau(1:nfdir)
        statev = a_statev(1:nstatv)
        dslip = a_dslip(1:nfdir)
        ddtddg = reshape(a_ddg(1:nfdir**2), [nfdir, nfdir])
        ddtddp = a_ddp(1:nfdir)
        if (lm == 1) tau = taulm
        if (lm == 2) tau = 0
        slip = slip + dslip
        press = now
    end subroutine increment
end module driver_call
