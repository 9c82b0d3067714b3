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
    real(dp) :: coords(mcrd, nnode), rhs(ndofel), amatrx(ndofel, ndofel), svars(nsvars), pnewdt
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
                coords(axis, node) = started(x(k), most, k)
                u(k) = x(k) - coords(axis, node)
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

    subroutine element(what, u)
        integer, intent(in) :: what
        real(dp), intent(in) :: u(ndofel)
        integer, parameter :: g = margin
        real(dp) :: a_rhs(1 - g:mlvarx * nrhs + g), a_amatrx(1 - g:ndofel**2 + g), a_svars(1 - g:nsvars + g)
        real(dp) :: a_coords(1 - g:mcrd * nnode + g), a_u(1 - g:ndofel + g), a_du(1 - g:mlvarx + g), a_props(1 - g:nprops + g)
        real(dp) :: energy(8), v(ndofel), a(ndofel), time(2), dtime, params(3), adlmag(mdload, nrhs), given(nprops)
        real(dp) :: predef(2, npredf, nnode), ddlmag(mdload, nrhs), period
        integer :: jdltyp(mdload, nrhs), lflags(5), jprops(njprop)
        external :: uel
        a_rhs = guard
        a_rhs(1:mlvarx * nrhs) = 0
        a_amatrx = guard
        a_amatrx(1:ndofel**2) = 0
        a_svars = guard
        a_svars(1:nsvars) = svars
        a_coords = guard
        a_coords(1:mcrd * nnode) = reshape(coords, [mcrd * nnode])
        a_u = guard
        a_u(1:ndofel) = u
        a_du = guard
        a_du(1:mlvarx) = 0
        a_du(1:ndofel) = 0.375_dp * u
        given = [2.0_dp, 3.0_dp]
        a_props = guard
        a_props(1:nprops) = given
        energy = 0
        v = 0.125_dp
        a = 0.25_dp
        time = [0.25_dp, 1.25_dp]
        dtime = 0.25_dp
        params = 0
        jdltyp = 0
        adlmag = 0
        predef = 20
        lflags = [1, 1, what, 0, 0]
        ddlmag = 0
        pnewdt = 1
        jprops = 7
        period = 2
        call clear_stack()
        call uel(a_rhs(1), a_amatrx(1), a_svars(1), energy, ndofel, nrhs, nsvars, a_props(1), nprops, a_coords(1), mcrd, &
            nnode, a_u(1), a_du(1), v, a, 1, time, dtime, 2, 3, 12, params, 0, jdltyp, adlmag, predef, npredf, lflags, mlvarx, &
            ddlmag, mdload, pnewdt, jprops, njprop, period)
        call look_around('RHS', a_rhs, mlvarx * nrhs)
        call look_around('AMATRX', a_amatrx, ndofel**2)
        call look_around('SVARS', a_svars, nsvars)
        call look_around('COORDS', a_coords, mcrd * nnode)
        call look_around('U', a_u, ndofel)
        call look_around('DU', a_du, mlvarx)
        call look_around('PROPS', a_props, nprops)
        call is_kept('COORDS', mcrd * nnode, a_coords(1:mcrd * nnode), [coords])
        call is_kept('U', ndofel, a_u(1:ndofel), u)
        call is_kept('PROPS', nprops, a_props(1:nprops), given)
        if (.not. pnewdt > 0) call fail('PNEWDT is not above 0')
        if (what /= 2) rhs = a_rhs(1:ndofel)
        if (what /= 5) amatrx = reshape(a_amatrx(1:ndofel**2), [ndofel, ndofel])
        svars = a_svars(1:nsvars)
    end subroutine element
end module driver_call
