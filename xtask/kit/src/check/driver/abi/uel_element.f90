! Nodes have the degrees of freedom of golden/elements/{id}.json in this order: {unknowns}.
! {internal}
! PROPS are {props}.
! SVARS are {svars}. U of a rotation is a rotation vector of the whole rotation; a step adds a spin that follows it.
! RHS is what the element exerts on its nodes{residuals}; AMATRX is minus its derivative with respect to U (spins for rotations).
! RHS and AMATRX are 0 at first. An iteration elsewhere comes before each. LFLAGS(3) is 1, then 2 for AMATRX alone and 5 for RHS
! alone: all must agree. A line of input is PROPS, SVARS, COORDS and U, and the answer RHS, minus AMATRX and SVARS.
---
module driver_call
    use driver_checks
    implicit none
    integer, parameter :: ndofel = {ndofel}, nnode = {nnode}, mcrd = {mcrd}, nrhs = 1, nsvars = {nsvars}, nprops = {nprops}
    integer, parameter :: njprop = 1, npredf = 1, mlvarx = ndofel + 3, mdload = 1
    real(dp) :: rhs(ndofel), amatrx(ndofel, ndofel), svars(nsvars), props(nprops), coords(mcrd * nnode), pnewdt
contains
    subroutine ask()
        real(dp) :: u(ndofel), value(ndofel), matrix(ndofel, ndofel), given(nsvars), after(nsvars)
        props = x(1:nprops)
        given = x(nprops + 1:nprops + nsvars)
        coords = x(nprops + nsvars + 1:nprops + nsvars + mcrd * nnode)
        u = x(nprops + nsvars + mcrd * nnode + 1:)
        svars = given
        call element(1, 0.75_dp * u)
        svars = given
        call element(1, u)
        is_refused = pnewdt < 1
        value = rhs
        matrix = amatrx
        after = svars
        y = [rhs, reshape(transpose(-amatrx), [ndofel**2]), svars]
        has_jacobian = .false.
        if (is_refused) return
        svars = given
        call element(5, u)
        if (differ(rhs, value, maxval(abs(value)))) call fail('RHS for LFLAGS(3) = 5 is not that for LFLAGS(3) = 1')
        if (differ(svars, after, maxval(abs(after)))) call fail('SVARS for LFLAGS(3) = 5 are not those for LFLAGS(3) = 1')
        svars = given
        call element(2, u)
        if (differ([amatrx], [matrix], maxval(abs(matrix)))) then
            call fail('AMATRX for LFLAGS(3) = 2 is not that for LFLAGS(3) = 1')
        end if
    end subroutine ask

    {element}
end module driver_call
