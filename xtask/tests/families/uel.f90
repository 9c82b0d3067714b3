subroutine uel(rhs, amatrx, svars, energy, ndofel, nrhs, nsvars, props, nprops, coords, mcrd, nnode, u, du, v, a, &
        jtype, time, dtime, kstep, kinc, jelem, params, ndload, jdltyp, adlmag, predef, npredf, lflags, mlvarx, &
        ddlmag, mdload, pnewdt, jprops, njprop, period)
    use jp_slider_nodal_forces, only: jp_slider_nodal_forces_jacobian
    use jp_slider_constraint, only: jp_slider_constraint_jacobian
    implicit none
    integer, parameter :: dp = kind(1.0d0)
    integer :: ndofel, nrhs, nsvars, nprops, mcrd, nnode, jtype, kstep, kinc, jelem, ndload, npredf, mlvarx, mdload
    integer :: njprop, jdltyp(1, *), lflags(*), jprops(*)
    real(dp) :: rhs(*), amatrx(11, 11), svars(*), energy(8), props(*), coords(3, *), u(11), du(*), v(11), a(11), time(2), dtime
    real(dp) :: params(3), adlmag(1, *), ddlmag(1, *), predef(2, 1, *), pnewdt, period
    real(dp) :: x1(3), xn(3), xm(3), first, second, g(2), of_g(2, 9), f(9), of_f(9, 11)
    integer :: code
    ! begin
    x1 = coords(:, 1) + u(1:3)
    xn = coords(:, 2) + u(4:6)
    xm = coords(:, 3) + u(7:9)
    first = u(10)
    second = u(11)
    code = jp_slider_constraint_jacobian(x1, xn, xm, g(1), g(2), of_g)
    code = jp_slider_nodal_forces_jacobian(x1, xn, xm, first, second, f(1:3), f(4:6), f(7:9), of_f)
    if (lflags(3) == 1 .or. lflags(3) == 5) then
        rhs(1:3) = f(1:3)
        rhs(4:6) = f(4:6)
        rhs(7:9) = f(7:9)
        rhs(10:11) = g
    end if
    if (lflags(3) == 1 .or. lflags(3) == 2) then
        amatrx(1:3, :) = -of_f(1:3, :)
        amatrx(4:6, :) = -of_f(4:6, :)
        amatrx(7:9, :) = -of_f(7:9, :)
        amatrx(10, 1:9) = -of_g(1, :)
        amatrx(11, 1:9) = -of_g(2, :)
        amatrx(10:11, 10:11) = 0
    end if
    ! end
end subroutine uel
