subroutine element(what, u)
    integer, intent(in) :: what
    real(dp), intent(in) :: u(ndofel)
    integer, parameter :: g = margin
    real(dp) :: a_rhs(1 - g:mlvarx * nrhs + g), a_amatrx(1 - g:ndofel**2 + g), a_svars(1 - g:nsvars + g)
    real(dp) :: a_coords(1 - g:mcrd * nnode + g), a_u(1 - g:ndofel + g), a_du(1 - g:mlvarx + g), a_props(1 - g:nprops + g)
    real(dp) :: energy(8), v(ndofel), a(ndofel), time(2), dtime, params(3), adlmag(mdload, nrhs)
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
    a_coords(1:mcrd * nnode) = coords
    a_u = guard
    a_u(1:ndofel) = u
    a_du = guard
    a_du(1:mlvarx) = 0
    a_du(1:ndofel) = 0.375_dp * u
    a_props = guard
    a_props(1:nprops) = props
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
    call is_kept('COORDS', mcrd * nnode, a_coords(1:mcrd * nnode), coords)
    call is_kept('U', ndofel, a_u(1:ndofel), u)
    call is_kept('PROPS', nprops, a_props(1:nprops), props)
    if (.not. pnewdt > 0) call fail('PNEWDT is not above 0')
    if (what /= 2) rhs = a_rhs(1:ndofel)
    if (what /= 5) amatrx = reshape(a_amatrx(1:ndofel**2), [ndofel, ndofel])
    svars = a_svars(1:nsvars)
end subroutine element
