! The nodes are 1, n and m, and a fourth with {multipliers} as degrees of freedom; U has them in this order. Nodes
! 1, n and m are at COORDS + U. RHS is what the element exerts on its nodes, as slider.nodal_forces{_2d} has it, and in
! the rows of multipliers the distance from the line, as slider.constraint{_2d}. AMATRX is minus the derivative of RHS by U.
---
    subroutine ask()
        integer, parameter :: dim = {dim}, moving = 3 * dim, ndofel = 4 * dim - 1, nnode = 4, mcrd = dim
        integer, parameter :: nrhs = 1, nsvars = 1, nprops = 1, njprop = 1, npredf = 1, mlvarx = ndofel, mdload = 1
        real(dp) :: rhs(mlvarx, nrhs), amatrx(ndofel, ndofel), svars(nsvars), energy(8), props(nprops)
        real(dp) :: coords(mcrd, nnode), u(ndofel), du(mlvarx, nrhs), v(ndofel), a(ndofel), time(2), dtime, params(3)
        real(dp) :: adlmag(mdload, nrhs), predef(2, npredf, nnode), ddlmag(mdload, nrhs), pnewdt, period
        integer :: jtype, kstep, kinc, jelem, ndload, jdltyp(mdload, nrhs), lflags(5), jprops(njprop)
        external :: uel
        rhs = 0
        amatrx = 0
        svars = 0
        energy = 0
        props = 0
        coords = 0
        coords(:, 1:3) = reshape(x(1:moving) / 2, [dim, 3])
        u(1:moving) = x(1:moving) - reshape(coords(:, 1:3), [moving])
        u(moving + 1:) = {multiplier}
        du = 0
        v = 0
        a = 0
        jtype = 1
        time = 1
        dtime = 1
        kstep = 1
        kinc = 1
        jelem = 1
        params = 0
        ndload = 0
        jdltyp = 0
        adlmag = 0
        predef = 0
        lflags = [1, 1, 1, 0, 0]
        ddlmag = 0
        pnewdt = 1
        jprops = 0
        period = 1
        call uel(rhs, amatrx, svars, energy, ndofel, nrhs, nsvars, props, nprops, coords, mcrd, nnode, u, du, v, a, &
            jtype, time, dtime, kstep, kinc, jelem, params, ndload, jdltyp, adlmag, predef, npredf, lflags, mlvarx, &
            ddlmag, mdload, pnewdt, jprops, njprop, period)
        y = rhs({rows}, 1)
        jacobian = -amatrx({rows}, 1:inputs)
    end subroutine ask
