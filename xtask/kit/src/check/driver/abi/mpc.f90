! It works in degree of freedom mode, with an equation for each coordinate of node m that is eliminated: JTYPE is its
! number. The nodes of the terms are m, whose eliminated coordinate comes first, m again with the coordinate that
! is kept, then node 1 and node n, {dim} times each; JDOF says which degree of freedom of its node a term has, or 0.
! Nodes are at X + U; X does not follow from U. UE is the displacement of the eliminated coordinate; U of node m is what the
! program has before it is eliminated, and so is UE at first. A and JDOF are 0 at first. Derivatives are -A(k)/A(1).
! LMPC = 0 refuses a point.
---
module driver_call
    use driver_checks
    implicit none
    integer, parameter :: dim = {dim}, n = 2 + 2 * dim, mdof = 6, maxdof = 6, nt = 1, nf = 1
    ! Behind which input the position of a term's node stands; that of m is not given.
    integer :: term
    integer, parameter :: behind(n) = [(0, term=1, 2 + dim), (dim, term=1, dim)]
    real(dp) :: ue, a(n)
    integer :: jdof(n), lmpc
contains
    subroutine ask()
        real(dp) :: at_m(3), value, found(n), most
        integer :: equation, column, axis, degrees(n)
        most = maxval(abs(x))
        do equation = 1, outputs
            ! X of m is 0 where the answer must not be rounded.
            call constrain(equation, [(0.0_dp, axis=1, 3)], [(0.5_dp * x(inputs), axis=1, 3)], 1)
            is_refused = is_refused .or. lmpc == 0
            value = ue
            found = a
            degrees = jdof
            if (any(jdof < 0 .or. jdof > dim)) then
                call fail('JDOF is no degree of freedom of the line')
                return
            end if
            if (jdof(1) == 0 .or. .not. abs(a(1)) > 0) then
                call fail('A(1) or JDOF(1) is 0: the first term is the one that is eliminated')
                return
            end if
            if (is_ordinary .and. jdof(1) /= axes(equation)) then
                call fail('JDOF(1) is not the coordinate that equation JTYPE eliminates')
                return
            end if
            y(equation) = value
            jacobian(equation, :) = 0
            if (jdof(2) > 0) then
                if (jdof(2) == jdof(1)) call fail('JDOF(2) is the degree of freedom that is eliminated')
                jacobian(equation, inputs) = -a(2) / a(1)
            end if
            do term = 3, n
                if (jdof(term) == 0) cycle
                column = behind(term) + jdof(term)
                jacobian(equation, column) = jacobian(equation, column) - a(term) / a(1)
            end do
            ! Where nodes nearly coincide roundings grow.
            if (is_refused .or. .not. maxval(abs(x(dim + 1:2 * dim) - x(1:dim))) > 1e-3_dp * most) cycle
            do axis = 1, 3
                at_m(axis) = 3 * started(0.0_dp, most, 40 + axis)
            end do
            call constrain(equation, at_m, [(2.5_dp * most, axis=1, 3)], 3)
            if (is_ordinary .and. any(jdof /= degrees)) then
                call fail('JDOF depends on X and U of node m beyond the coordinate that is kept')
            end if
            if (differ([ue + at_m(degrees(1))], [value], abs(value) + maxval(abs(at_m)))) then
                call fail('UE is not the coordinate that is eliminated, less X of node m')
            end if
            if (differ(a, found, maxval(abs(found)))) call fail('A depends on X of node m, or on U that is eliminated')
        end do
    end subroutine ask

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
        real(dp) :: a_ue(1 - g:1 + g), a_a(1 - g:n + g), a_x(1 - g:6 * n + g), a_u(1 - g:maxdof * n + g)
        real(dp) :: x0(6, n), u(maxdof, n), uinit(maxdof, n), time(2), temp(nt, n), field(nf, nt, n), tran(3, 3, n)
        integer :: a_jdof(1 - g:n + g), ltran(n), axis, kept
        external :: mpc
        x0 = 0
        u = 0
        kept = axes(dim)
        do term = 1, n
            x0(4:6, term) = [0.6_dp, 0.0_dp, 0.8_dp]
            if (term < 3) then
                x0(1:dim, term) = at_m(1:dim)
                u(1:dim, term) = eliminated(1:dim)
                u(kept, term) = x(inputs) - at_m(kept)
            else
                do axis = 1, dim
                    x0(axis, term) = started(x(behind(term) + axis), maxval(abs(x)), behind(term) + axis)
                    u(axis, term) = x(behind(term) + axis) - x0(axis, term)
                end do
            end if
        end do
        u(4:, :) = 0.125_dp
        uinit = 0.375_dp * u
        a_ue = guard
        a_ue(1) = eliminated(1)
        a_a = guard
        a_a(1:n) = 0
        a_jdof = integer_guard
        a_jdof(1:n) = 0
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
        call look_around('UE', a_ue, 1)
        call look_around('A', a_a, n)
        call look_around_integers('JDOF', a_jdof, n)
        call look_around('X', a_x, 6 * n)
        call look_around('U', a_u, maxdof * n)
        call is_kept('X', 6 * n, a_x(1:6 * n), [x0])
        call is_kept('U', maxdof * n, a_u(1:maxdof * n), [u])
        ue = a_ue(1)
        a = a_a(1:n)
        jdof = a_jdof(1:n)
    end subroutine constrain
end module driver_call
