subroutine mpc(ue, a, jdof, mdof, n, jtype, x, u, uinit, maxdof, lmpc, kstep, kinc, time, nt, nf, temp, field, ltran, tran)
    use jp_slider_eliminate, only: jp_slider_eliminate_jacobian
    implicit none
    integer, parameter :: dp = kind(1.0d0)
    integer :: mdof, n, jdof(*), jtype, maxdof, lmpc, kstep, kinc, nt, nf, ltran(*)
    real(dp) :: ue(*), a(*), x(6, *), u(6, *), uinit(6, *), time(2), temp(*), field(*), tran(3, 3, *)
    real(dp) :: x1(3), xn(3), d(3), y(2), slope(2, 7), kept
    integer :: axes(3), p, q, e, k, code
    ! begin
    x1 = x(1:3, 3) + u(1:3, 3)
    xn = x(1:3, 6) + u(1:3, 6)
    d = abs(xn - x1)
    d = scale(d, -exponent(maxval(d)))
    p = merge(3, 2, d(3) >= d(2))
    q = 5 - p
    axes = [q, p, 1]
    if (d(p) > 0 .and. d(p)**2 + d(q)**2 >= d(p) * d(1)) then
        axes = [q, 1, p]
    end if
    e = axes(jtype)
    k = axes(3)
    kept = x(k, 2) + u(k, 2)
    code = jp_slider_eliminate_jacobian(x1, xn, kept, y(1), y(2), slope)
    ue(1) = y(jtype) - x(e, 1)
    jdof(1) = e
    jdof(2) = k
    jdof(3:5) = [1, 2, 3]
    jdof(6:8) = [1, 2, 3]
    a(1) = 1
    a(2) = -slope(jtype, 7)
    a(3:5) = -slope(jtype, 1:3)
    a(6:8) = -slope(jtype, 4:6)
    ! end
end subroutine mpc
