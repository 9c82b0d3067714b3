! It is called with the coordinates, properties and states of the file; the numbers asked for are U. LFLAGS(3) is 1, then 2 for
! AMATRX alone and 5 for RHS alone: all must agree. DU is U less what it was at the start of the increment. PNEWDT < 1 refuses a state.
---
module driver_call
    use driver_checks
    implicit none
    integer, parameter :: ndofel = inputs, nnode = {nnode}, mcrd = {mcrd}, nrhs = 1, nsvars = {nsvars}, nprops = {nprops}
    integer, parameter :: njprop = {njprop}, npredf = 1, mlvarx = ndofel, mdload = 1
    real(dp) :: rhs(ndofel), amatrx(ndofel, ndofel), pnewdt
contains
    subroutine ask()
        real(dp) :: value(ndofel), matrix(ndofel, ndofel)
        call element({lflags})
        is_refused = pnewdt < 1
        value = rhs
        matrix = amatrx
        y = rhs
        jacobian = -amatrx
        if (is_refused) return
        call other(5)
        if (differ(rhs, value, maxval(abs(value)))) call fail('RHS for LFLAGS(3) = 5 is not that for LFLAGS(3) = 1')
        call other(2)
        if (differ([amatrx], [matrix], maxval(abs(matrix)))) then
            call fail('AMATRX for LFLAGS(3) = 2 is not that for LFLAGS(3) = 1')
        end if
    end subroutine ask

    subroutine other(what)
        integer, intent(in) :: what
        integer :: flags(5)
        flags = {lflags}
        flags(3) = what
        call element(flags)
    end subroutine other

    subroutine element(flags)
        integer, intent(in) :: flags(5)
        integer, parameter :: g = margin
        real(dp) :: a_rhs(1 - g:mlvarx + g), a_amatrx(1 - g:ndofel**2 + g), a_svars(1 - g:nsvars + g)
        real(dp) :: a_coords(1 - g:mcrd * nnode + g), a_u(1 - g:ndofel + g), a_props(1 - g:nprops + g), du(mlvarx, nrhs)
        real(dp) :: energy(8), v(ndofel), a(ndofel), time(2), dtime, params(3), adlmag(mdload, nrhs)
        real(dp) :: predef(2, npredf, nnode), ddlmag(mdload, nrhs), period
        real(dp), parameter :: coords(max(1, mcrd * nnode)) = {coords}
        real(dp), parameter :: props(max(1, nprops)) = {props}
        real(dp), parameter :: svars(max(1, nsvars)) = {svars}
        real(dp), parameter :: start(ndofel) = {start}
        integer, parameter :: jprops(max(1, njprop)) = {jprops}
        integer :: jdltyp(mdload, nrhs), lflags(5), whole_properties(max(1, njprop))
        external :: {routine}
{material}        a_rhs = guard
        a_rhs(1:mlvarx) = 0
        a_amatrx = guard
        a_amatrx(1:ndofel**2) = 0
        a_svars = guard
        a_svars(1:nsvars) = svars(1:nsvars)
        a_coords = guard
        a_coords(1:mcrd * nnode) = coords(1:mcrd * nnode)
        a_u = guard
        a_u(1:ndofel) = x
        a_props = guard
        a_props(1:nprops) = props(1:nprops)
        du(:, 1) = x - start
        energy = 0
        v = 0
        a = 0
        time = {dtime}
        dtime = {dtime}
        params = 0
        jdltyp = 0
        adlmag = 0
        predef = 0
        lflags = flags
        ddlmag = 0
        pnewdt = 1
        whole_properties = jprops
        period = 1
        call clear_stack()
        call {routine}(a_rhs(1), a_amatrx(1), a_svars(1), energy, ndofel, nrhs, nsvars, a_props(1), nprops, a_coords(1), mcrd, &
            nnode, a_u(1), du, v, a, {jtype}, time, dtime, 1, 1, 1, params, 0, jdltyp, adlmag, predef, npredf, lflags, mlvarx, &
            ddlmag, mdload, pnewdt, whole_properties, njprop, period{more})
        call look_around('RHS', a_rhs, mlvarx)
        call look_around('AMATRX', a_amatrx, ndofel**2)
        call look_around('SVARS', a_svars, nsvars)
        call is_kept('U', ndofel, a_u(1:ndofel), x)
        call is_kept('COORDS', mcrd * nnode, a_coords(1:mcrd * nnode), coords(1:mcrd * nnode))
        call is_kept('PROPS', nprops, a_props(1:nprops), props(1:nprops))
        if (flags(3) /= 2) rhs = a_rhs(1:ndofel)
        if (flags(3) /= 5) amatrx = reshape(a_amatrx(1:ndofel**2), [ndofel, ndofel])
    end subroutine element
end module driver_call
