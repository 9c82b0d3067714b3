! F is the distance of node m from the line, and A its derivatives with respect to the displacements.
! {nodes}
! All nodes are at X + U; X does not follow from U. It is called as CalculiX 2.20 does: JDOF is (1, 0, 0, ...) the first
! time and later what the routine has left; the routine sets the degrees of freedom of all terms, and moves to the first
! place one whose coefficient is not 0, because that one is eliminated. F comes in as anything.
---
module driver_call
    use driver_checks
    implicit none
    integer, parameter :: dim = {dim}, n = 3 * dim{more}
    real(dp) :: f, a(n)
    integer :: jdof(n)
contains
    subroutine ask()
        real(dp) :: value, found(inputs), again(inputs)
        integer :: equation
        do equation = 1, outputs
            a = 0
            jdof = 0
            jdof(1) = 1
            call constrain(equation, 1, 0.0_dp)
            value = f
            call derivatives(equation, found)
            y(equation) = value
            jacobian(equation, :) = found
            if (fault /= ' ') return
            call constrain(equation, 3, 2.5_dp)
            call derivatives(equation, again)
            if (differ([f], [value], abs(value)) .or. differ(again, found, maxval(abs(found)))) then
                call fail('in the second iteration, with JDOF and A as the first one left them, the answer differs')
            end if
        end do
    end subroutine ask

    ! Behind which input the position of a term's node stands; -1 for none.
    pure function behind(equation, term)
        integer, intent(in) :: equation, term
        integer :: behind
        integer, parameter :: all_nodes(3) = [2 * dim, 0, dim]
        behind = -1
        if (term <= 3 * dim) behind = all_nodes(1 + modulo(equation - 1 + (term - 1) / dim, 3))
    end function behind

    subroutine derivatives(equation, found)
        integer, intent(in) :: equation
        real(dp), intent(out) :: found(inputs)
        integer :: term, column
        found = 0
        do term = 1, n
            if (.not. abs(a(term)) > 0) cycle
            if (behind(equation, term) < 0) then
                call fail('A is not 0 for the node that only has the number of the equation')
            else if (jdof(term) == 0) then
                call fail('JDOF(' // text(term) // ') is still 0: CalculiX passes in (1, 0, 0, ...), and 0 is the temperature')
            else if (jdof(term) < 0 .or. jdof(term) > dim) then
                call fail('JDOF(' // text(term) // ') is no degree of freedom of the line')
            else
                column = behind(equation, term) + jdof(term)
                found(column) = found(column) + a(term)
            end if
        end do
        if (abs(a(1)) <= 1e-10_dp * maxval(abs(a)) .and. maxval(abs(a(2:dim))) > 1e-6_dp * maxval(abs(a))) then
            call fail('A(1) is 0, and the first term is eliminated: JDOF(1) must be one with a coefficient that is not 0')
        end if
    end subroutine derivatives

    subroutine constrain(equation, iteration, force)
        integer, intent(in) :: equation, iteration
        real(dp), intent(in) :: force
        integer, parameter :: g = margin
        real(dp) :: x0(3, n), u(3, n), a_x(1 - g:3 * n + g), a_u(1 - g:3 * n + g), a_a(1 - g:n + g), given
        integer :: a_jdof(1 - g:n + g), term, axis, iit, idiscon, terms, place
        external :: umpc_user
        x0 = 0
        u = 0
        do term = 1, n
            if (behind(equation, term) < 0) then
                x0(1, term) = equation
                cycle
            end if
            do axis = 1, dim
                place = behind(equation, term) + axis
                x0(axis, term) = started(x(place), maxval(abs(x)), place)
                u(axis, term) = x(place) - x0(axis, term)
            end do
        end do
        a_x = guard
        a_x(1:3 * n) = reshape(x0, [3 * n])
        a_u = guard
        a_u(1:3 * n) = reshape(u, [3 * n])
        a_a = guard
        a_a(1:n) = a
        a_jdof = integer_guard
        a_jdof(1:n) = jdof
        f = guard
        given = force
        iit = iteration
        idiscon = 0
        terms = n
        call clear_stack()
        call umpc_user(a_x(1), a_u(1), f, a_a(1), a_jdof(1), terms, given, iit, idiscon)
        call look_around('X', a_x, 3 * n)
        call look_around('U', a_u, 3 * n)
        call look_around('A', a_a, n)
        call look_around_integers('JDOF', a_jdof, n)
        call is_kept('X', 3 * n, a_x(1:3 * n), [x0])
        call is_kept('U', 3 * n, a_u(1:3 * n), [u])
        if (terms /= n) call fail('changes N, which it is only given')
        if (idiscon < 0 .or. idiscon > 1) call fail('IDISCON is neither 0 nor 1')
        a = a_a(1:n)
        jdof = a_jdof(1:n)
    end subroutine constrain
end module driver_call
