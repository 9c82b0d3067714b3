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
        call constrain(1, [(0.0_dp, axis=1, 3)], [(0.5_dp * x(inputs), axis=1, 3)], 1)
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
        call constrain(1, at_m, [(2.5_dp * most, axis=1, 3)], 3)
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

    {constrain}
end module driver_call
