! A bar with plasticity and hardening in increments: PROPS are E, the limit, the hardening and the section; SVARS are the plastic
! strain and the stress. It takes its strain increment from DU.
subroutine uelmat(rhs, amatrx, svars, energy, ndofel, nrhs, nsvars, props, nprops, coords, mcrd, nnode, u, du, v, a, &
        jtype, time, dtime, kstep, kinc, jelem, params, ndload, jdltyp, adlmag, predef, npredf, lflags, mlvarx, &
        ddlmag, mdload, pnewdt, jprops, njprop, period, materiallib)
    implicit none
    integer, parameter :: dp = kind(1.0d0)
    integer :: ndofel, nrhs, nsvars, nprops, mcrd, nnode, jtype, kstep, kinc, jelem, ndload, npredf, mlvarx, mdload
    integer :: njprop, jdltyp(mdload, *), lflags(*), jprops(*)
    character(len=80) :: materiallib
    real(dp) :: rhs(mlvarx, *), amatrx(ndofel, ndofel), svars(*), energy(8), props(*), coords(mcrd, nnode), u(ndofel)
    real(dp) :: du(mlvarx, *), v(ndofel), a(ndofel), time(2), dtime, params(3), adlmag(mdload, *), ddlmag(mdload, *)
    real(dp) :: predef(2, npredf, nnode), pnewdt, period
    real(dp) :: length, stress, limit, modulus, plastic
    length = coords(1, 2) - coords(1, 1)
    stress = svars(2) + props(1) * (du(2, 1) - du(1, 1)) / length
    limit = props(2) + props(3) * svars(1)
    modulus = props(1)
    if (abs(stress) > limit) then
        plastic = (abs(stress) - limit) / (props(1) + props(3))
        stress = sign(abs(stress) - props(1) * plastic, stress)
        svars(1) = svars(1) + plastic
        modulus = props(1) * props(3) / (props(1) + props(3))
    end if
    svars(2) = stress
    rhs(1, 1) = props(4) * stress
    rhs(2, 1) = -props(4) * stress
    amatrx = props(4) * modulus / length * reshape([1, -1, -1, 1], [2, 2])
end subroutine uelmat
