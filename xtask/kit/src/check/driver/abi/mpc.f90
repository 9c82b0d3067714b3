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
    real(dp) :: ue(1), a(n)
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
            value = ue(1)
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
            if (differ(ue + at_m(degrees(1)), [value], abs(value) + maxval(abs(at_m)))) then
                call fail('UE is not the coordinate that is eliminated, less X of node m')
            end if
            if (differ(a, found, maxval(abs(found)))) call fail('A depends on X of node m, or on U that is eliminated')
        end do
    end subroutine ask

    {constrain}
end module driver_call
