! The axes that are eliminated, and then the one that is kept, as slider.eliminate{_2d} says.
function axes(k)
    integer, intent(in) :: k
    integer :: axes, in_order(dim)
    real(dp) :: d(dim)
    {axes}
    axes = in_order(k)
end function axes

! A call with node m at these coordinates at first, and these displacements of what is eliminated.
subroutine constrain(equation, at_m, eliminated, kinc)
    integer, intent(in) :: equation, kinc
    real(dp), intent(in) :: at_m(3), eliminated(3)
    integer, parameter :: g = margin
    real(dp) :: a_ue(1 - g:size(ue) + g), a_a(1 - g:size(a) + g), a_x(1 - g:6 * n + g), a_u(1 - g:maxdof * n + g)
    real(dp) :: x0(6, n), u(maxdof, n), uinit(maxdof, n), time(2), temp(nt, n), field(nf, nt, n), tran(3, 3, n)
    integer :: a_jdof(1 - g:size(jdof) + g), ltran(n), node, axis, kept
    external :: mpc
    x0 = 0
    u = 0
    kept = axes(dim)
    do node = 1, n
        x0(4:6, node) = [0.6_dp, 0.0_dp, 0.8_dp]
        if (node < 3) then
            x0(1:dim, node) = at_m(1:dim)
            u(1:dim, node) = eliminated(1:dim)
            u(kept, node) = x(inputs) - at_m(kept)
        else
            do axis = 1, dim
                x0(axis, node) = started(x(behind(node) + axis), maxval(abs(x)), behind(node) + axis)
                u(axis, node) = x(behind(node) + axis) - x0(axis, node)
            end do
        end if
    end do
    u(4:, :) = 0.125_dp
    uinit = 0.375_dp * u
    a_ue = guard
    a_ue(1:size(ue)) = eliminated(1)
    a_a = guard
    a_a(1:size(a)) = 0
    a_jdof = integer_guard
    a_jdof(1:size(jdof)) = 0
    a_x = guard
    a_x(1:6 * n) = reshape(x0, [6 * n])
    a_u = guard
    a_u(1:maxdof * n) = reshape(u, [maxdof * n])
    lmpc = 1
    time = [0.25_dp, 1.25_dp]
    temp = 20
    field = 3
    ltran = 0
    tran = 0
    tran(1, 1, :) = 1
    tran(2, 2, :) = 1
    tran(3, 3, :) = 1
    call clear_stack()
    call mpc(a_ue(1), a_a(1), a_jdof(1), mdof, n, equation, a_x(1), a_u(1), uinit, maxdof, lmpc, 2, kinc, time, nt, nf, &
        temp, field, ltran, tran)
    call look_around('UE', a_ue, size(ue))
    call look_around('A', a_a, size(a))
    call look_around_integers('JDOF', a_jdof, size(jdof))
    call look_around('X', a_x, 6 * n)
    call look_around('U', a_u, maxdof * n)
    call is_kept('X', 6 * n, a_x(1:6 * n), [x0])
    call is_kept('U', maxdof * n, a_u(1:maxdof * n), [u])
    ue = a_ue(1:size(ue))
    a = reshape(a_a(1:size(a)), shape(a))
    jdof = reshape(a_jdof(1:size(jdof)), shape(jdof))
end subroutine constrain
