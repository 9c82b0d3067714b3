! The nodes are 1, n and m, and a fourth with {multipliers} as degrees of freedom; U has them in this order. Nodes
! 1, n and m are at COORDS + U; COORDS do not follow from U, and those of the fourth node are anything. RHS is what the
! element exerts on its nodes, as slider.nodal_forces{_2d} has it, and in the rows of multipliers the distance from the
! line, as slider.constraint{_2d}. AMATRX is minus the derivative of RHS by U. RHS and AMATRX are 0 at first. LFLAGS(3) is
! 1, then 2 for AMATRX alone and 5 for RHS alone: all must agree. PNEWDT < 1 refuses a point.
---
module driver_call
    use driver_checks
    implicit none
    integer, parameter :: dim = {dim}, moving = 3 * dim, ndofel = 4 * dim - 1, nnode = 4, mcrd = dim
    integer, parameter :: nrhs = 1, nsvars = 4, nprops = 2, njprop = 1, npredf = 1, mlvarx = ndofel + 3, mdload = 1
    real(dp), parameter :: props(nprops) = [2.0_dp, 3.0_dp]
    real(dp) :: rhs(ndofel), amatrx(ndofel, ndofel), svars(nsvars), coords(mcrd * nnode), pnewdt
contains
    subroutine ask()
        real(dp) :: u(ndofel), first(ndofel), matrix(ndofel, ndofel), most, along(ndofel), states(nsvars)
        real(dp) :: quotients(ndofel, 2), expected(ndofel), step, apart, beside(ndofel, ndofel)
        integer :: k, level, node, axis
        most = maxval(abs(x(1:moving)))
        coords = 3 * most + 1
        k = 0
        do node = 1, 3
            do axis = 1, dim
                k = k + 1
                coords(k) = started(x(k), most, k)
                u(k) = x(k) - coords(k)
            end do
        end do
        u(moving + 1:) = {multiplier}
        svars = 0
        ! An iteration elsewhere comes first.
        call element(1, -0.5_dp * u)
        svars = 0
        call element(1, u)
        is_refused = pnewdt < 1
        first = rhs
        matrix = amatrx
        states = svars
        y = rhs({rows})
        jacobian = -amatrx({rows}, 1:inputs)
        call look_at_states('SVARS', svars, max(most, maxval(abs(x))))
        if (is_refused .or. fault /= ' ') return
        svars = 0
        call element(5, u)
        if (differ(rhs, first, maxval(abs(first)))) call fail('RHS for LFLAGS(3) = 5 is not that for LFLAGS(3) = 1')
        call element(2, u)
        if (differ([amatrx], [matrix], maxval(abs(matrix)))) then
            call fail('AMATRX for LFLAGS(3) = 2 is not that for LFLAGS(3) = 1')
        end if
        ! All rows of AMATRX, in one direction, by differences where nothing is extreme.
        apart = maxval(abs(x(dim + 1:2 * dim) - x(1:dim)))
        if (most < 1e-3_dp .or. most > 1e3_dp .or. apart < 1e-2_dp * most) return
        do k = 1, ndofel
            along(k) = 0.25_dp + 0.125_dp * drawn(60 + k, 7)
        end do
        ! Not on a kink, where AMATRX jumps.
        do level = -1, 1, 2
            svars = states
            call element(2, u + level * 1e-4_dp * apart * along)
            beside = abs(amatrx - matrix)
            if (any(beside > 1e-2_dp * maxval(abs(matrix)))) return
        end do
        do level = 1, 2
            step = 1e-4_dp * apart / level
            svars = states
            call element(5, u + step * along)
            expected = rhs
            svars = states
            call element(5, u - step * along)
            quotients(:, level) = (rhs - expected) / (2 * step)
        end do
        expected = matmul(matrix, along)
        do k = 1, ndofel
            apart = maxval(abs(matrix(k, :))) + maxval(abs(first)) / most
            ! Where the quotients of two steps differ there is a kink.
            if (abs(quotients(k, 1) - quotients(k, 2)) > 1e-5_dp * apart) cycle
            if (abs(quotients(k, 2) - expected(k)) > 1e-3_dp * apart) then
                call fail('row ' // text(k) // ' of AMATRX is not minus the derivative of RHS(' // text(k) // ')')
            end if
        end do
    end subroutine ask

    {element}
end module driver_call
