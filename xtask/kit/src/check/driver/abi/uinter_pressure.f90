subroutine ask()
    real(dp) :: other
    {set}
    call begin()
    other = x(1) / 4
    if (drawn(1, 2) == 1) other = 2 * abs(x(1)) * 0.75_dp
    call increment(other, [0.0_dp])
    call keep()
    call increment(-x(1) / 2, [0.25_dp * x(1)])
    call elsewhere()
    call back()
    call increment(x(1), [0.0_dp])
    is_refused = pnewdt < 1
    y = stress(1)
    jacobian(1, 1) = ddsddr(1, 1)
    is_known(1, 2:) = .false.
    if (any(abs(ddsddr(1, 2:)) > 0)) call fail('DDSDDR(1,2) is not 0: the pressure does not depend on the slip')
    call look_at_states('STATEV', statev, max(maxval(abs(x)), maxval(abs(props)), abs(y(1))))
    call elsewhere()
    call back()
    call increment(x(1), [0.0_dp])
    if (differ(stress(1:1), y, abs(y(1))) .or. differ(ddsddr(1:1, 1), jacobian(1, 1:1), abs(jacobian(1, 1)))) then
        call fail('STRESS or DDSDDR of an increment that is repeated differs')
    end if
end subroutine ask
