! UEL of Abaqus/Standard, by the type of the element.
subroutine uel(rhs, amatrx, svars, energy, ndofel, nrhs, nsvars, props, nprops, coords, mcrd, &
        nnode, u, du, v, a, jtype, time, dtime, kstep, kinc, jelem, params, ndload, jdltyp, &
        adlmag, predef, npredf, lflags, mlvarx, ddlmag, mdload, pnewdt, jprops, njprop, period)
    {uses}
    include 'ABA_PARAM.INC'
    dimension rhs(mlvarx, *), amatrx(ndofel, ndofel), svars(*), energy(8), props(*), &
        coords(mcrd, nnode), u(ndofel), du(mlvarx, *), v(ndofel), a(ndofel), time(2), params(*), &
        jdltyp(mdload, *), adlmag(mdload, *), predef(2, npredf, nnode), lflags(*), &
        ddlmag(mdload, *), jprops(*)
    {calls}
end subroutine uel
