! It works in nodal mode: the nodes are m, m again, 1 and n. JDOF(:,1) are the coordinates of m that are eliminated,
! JDOF(:,2) the one that is kept, JDOF(:,3) and JDOF(:,4) those of the line, each followed by 0; MDOF is 6. Row i of
! A(:,:,k) is the equation of the degree of freedom JDOF(i,1). Which coordinates are eliminated slider.eliminate{_2d} says.
! Nodes are at X + U; X does not follow from U. UE are the displacements of the eliminated coordinates; U of node m is what
! the program has before they are eliminated, and so is UE at first. A and JDOF are 0 at first. LMPC = 0 refuses a point.
---
module driver_call
    use driver_checks
    implicit none
    integer, parameter :: dim = {dim}, n = 4, mdof = 6, maxdof = 6, nt = 1, nf = 1, m = outputs
    ! Behind which input the position of a node stands; that of m is not given.
    integer, parameter :: behind(n) = [0, 0, 0, dim]
    real(dp) :: ue(mdof), a(mdof, mdof, n)
    integer :: jdof(mdof, n), lmpc
contains
    subroutine ask()
        real(dp) :: at_m(3), found(m, inputs), value(m), most, again(m, inputs)
        integer :: axis, k, rows(m), degrees(mdof, n)
        most = maxval(abs(x))
        ! X of m is 0 where the answer must not be rounded.
        call constrain([(0.0_dp, axis=1, 3)], [(0.5_dp * x(inputs), axis=1, 3)], 1)
        is_refused = lmpc == 0
        if (is_refused .or. fault /= ' ') return
        rows = 0
        do k = 1, m
            if (jdof(k, 1) == axes(k)) rows(k) = k
            if (jdof(3 - k, 1) == axes(k) .and. m == 2) rows(k) = 3 - k
        end do
        if (.not. is_ordinary .and. any(rows == 0)) rows = [(k, k=1, m)]
        if (any(rows == 0) .or. any(jdof(m + 1:, 1) /= 0)) then
            call fail('JDOF(:,1) is not what slider.eliminate{_2d} eliminates here')
            return
        end if
        degrees = jdof
        value = ue(rows)
        call solve(rows, found)
        y = value
        jacobian = found
        ! Where nodes nearly coincide roundings grow.
        if (.not. maxval(abs(x(dim + 1:2 * dim) - x(1:dim))) > 1e-3_dp * most) return
        do axis = 1, 3
            at_m(axis) = 3 * started(0.0_dp, most, 40 + axis)
        end do
        call constrain(at_m, [(2.5_dp * most, axis=1, 3)], 3)
        if (is_ordinary .and. any(jdof /= degrees)) then
            call fail('JDOF depends on X and U of node m beyond the coordinate that is kept')
            return
        end if
        if (differ(ue(rows) + at_m(jdof(rows, 1)), value, maxval(abs(value)) + maxval(abs(at_m)))) then
            call fail('UE is not the coordinate that is eliminated, less X of node m')
        end if
        call solve(rows, again)
        if (differ([again], [found], maxval(abs(found)))) call fail('A depends on X of node m, or on U that is eliminated')
    end subroutine ask

    ! The axes that are eliminated, and then the one that is kept, as slider.eliminate{_2d} says.
    function axes(k)
        integer, intent(in) :: k
        integer :: axes, in_order(dim)
        real(dp) :: d(dim)
        {axes}
        axes = in_order(k)
    end function axes

    ! The derivatives of what is eliminated: the matrix of the first node need not be the unit matrix.
    subroutine solve(rows, found)
        integer, intent(in) :: rows(m)
        real(dp), intent(out) :: found(m, inputs)
        real(dp) :: right(m, inputs), determinant
        integer :: k, j, row, column
        right = 0
        do k = 2, n
            do j = 1, mdof
                if (jdof(j, k) == 0) cycle
                if (jdof(j, k) < 0 .or. jdof(j, k) > dim) then
                    call fail('JDOF is no degree of freedom of the line')
                    return
                end if
                column = merge(inputs, behind(k) + jdof(j, k), k == 2)
                if (is_ordinary .and. k == 2 .and. jdof(j, k) /= axes(dim)) then
                    call fail('JDOF(:,2) is not the coordinate that is kept')
                    return
                end if
                do row = 1, m
                    right(row, column) = right(row, column) - a(row, j, k)
                end do
            end do
        end do
        {inverted}
        if (.not. abs(determinant) > 0) call fail('A(:,:,1) is singular: nothing can be eliminated')
    end subroutine solve

    ! A call with node m at these coordinates at first, and these displacements of what is eliminated.
    subroutine constrain(at_m, eliminated, kinc)
        integer, intent(in) :: kinc
        real(dp), intent(in) :: at_m(3), eliminated(3)
        integer, parameter :: g = margin, all_a = mdof * mdof * n
        real(dp) :: a_ue(1 - g:mdof + g), a_a(1 - g:all_a + g), a_x(1 - g:6 * n + g), a_u(1 - g:maxdof * n + g)
        real(dp) :: x0(6, n), u(maxdof, n), uinit(maxdof, n), time(2), temp(nt, n), field(nf, nt, n), tran(3, 3, n)
        integer :: a_jdof(1 - g:mdof * n + g), ltran(n), axis, k, kept
        external :: mpc
        x0 = 0
        u = 0
        kept = axes(dim)
        do k = 1, n
            x0(4:6, k) = [0.6_dp, 0.0_dp, 0.8_dp]
            if (k < 3) then
                x0(1:dim, k) = at_m(1:dim)
                u(1:dim, k) = eliminated(1:dim)
                u(kept, k) = x(inputs) - at_m(kept)
            else
                do axis = 1, dim
                    x0(axis, k) = started(x(behind(k) + axis), maxval(abs(x)), behind(k) + axis)
                    u(axis, k) = x(behind(k) + axis) - x0(axis, k)
                end do
            end if
        end do
        u(4:, :) = 0.125_dp
        uinit = 0.375_dp * u
        a_ue = guard
        a_ue(1:mdof) = eliminated(1)
        a_a = guard
        a_a(1:all_a) = 0
        a_jdof = integer_guard
        a_jdof(1:mdof * n) = 0
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
        call mpc(a_ue(1), a_a(1), a_jdof(1), mdof, n, 1, a_x(1), a_u(1), uinit, maxdof, lmpc, 2, kinc, time, nt, nf, temp, &
            field, ltran, tran)
        call look_around('UE', a_ue, mdof)
        call look_around('A', a_a, all_a)
        call look_around_integers('JDOF', a_jdof, mdof * n)
        call look_around('X', a_x, 6 * n)
        call look_around('U', a_u, maxdof * n)
        call is_kept('X', 6 * n, a_x(1:6 * n), [x0])
        call is_kept('U', maxdof * n, a_u(1:maxdof * n), [u])
        ue = a_ue(1:mdof)
        a = reshape(a_a(1:all_a), [mdof, mdof, n])
        jdof = reshape(a_jdof(1:mdof * n), [mdof, n])
    end subroutine constrain
end module driver_call
