subroutine ask()
    real(dp) :: trial(outputs), most, start(outputs), slip(outputs), high
    real(dp) :: by_motion(ndir, ndir), stiffness, of_pressure, press
    integer :: k
    trial = x(1:outputs)
    press = x(inputs)
    most = maxval(abs(trial))
    stiffness = power_of_two(most, 1)
    of_pressure = power_of_two(press, 3)
    if (.not. abs(of_pressure - stiffness) > 0) of_pressure = 4 * stiffness
    props = [of_pressure, stiffness, x(outputs + 1)]
    call begin()
    high = 0
    if (x(outputs + 1) > 0 .and. most > 0 .and. is_ordinary) high = 8 * (most / x(outputs + 1))
    if (high > 0 .and. high < 1e150_dp .and. x(outputs + 1) * high > 4 * most) then
        call increment(high / 32 / of_pressure, -2 * trial / stiffness)
        do k = 1, outputs
            start(k) = started(trial(k), most, 10 + k)
        end do
        call increment(high / of_pressure, (start - stress(2:)) / stiffness)
        if (differ(stress(2:), start, most)) then
            call fail('STRESS after an increment that slips and one that sticks is not STRESS + PROPS(2) DRDISP')
        end if
        if (differ(stress(1:1), [high], high)) call fail('STRESS(1) is not PROPS(1) RDISP(1)')
    end if
    call keep()
    slip = (trial - stress(2:)) / stiffness
    call increment(2 * press / of_pressure, -3 * slip + 1 / stiffness)
    call elsewhere()
    call back()
    call increment(press / of_pressure, slip)
    is_refused = pnewdt < 1
    y = stress(2:)
    by_motion = ddsddr
    jacobian(:, 1:outputs) = ddsddr(2:, 2:) / stiffness
    is_known(:, outputs + 1) = .false.
    jacobian(:, inputs) = ddsddr(2:, 1) / of_pressure
    ! Where surfaces only touch, the pressure has a kink of its own.
    is_known(:, inputs) = press > 0
    if (press > 0) then
        if (differ(stress(1:1), [press], press)) call fail('STRESS(1) is not PROPS(1) RDISP(1)')
        if (differ(ddsddr(1:1, 1), [of_pressure], of_pressure)) call fail('DDSDDR(1,1) is not PROPS(1)')
    end if
    if (any(abs(ddsddr(1, 2:)) > 0)) call fail('DDSDDR(1,2) is not 0: the pressure does not depend on the slip')
    call look_at_states('STATEV', statev, max(most, maxval(abs(x)), stiffness, 1 / stiffness, of_pressure, &
        1 / of_pressure, maxval(abs(slip)), press / of_pressure))
    call elsewhere()
    call back()
    call increment(press / of_pressure, slip)
    if (differ(stress(2:), y, maxval(abs(y))) .or. differ([ddsddr], [by_motion], maxval(abs(by_motion)))) then
        call fail('STRESS or DDSDDR of an increment that is repeated differs')
    end if
end subroutine ask
