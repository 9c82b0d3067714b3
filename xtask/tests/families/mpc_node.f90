subroutine mpc(ue, a, jdof, mdof, n, jtype, x, u, uinit, maxdof, lmpc, kstep, kinc, time, nt, nf, temp, field, ltran, tran)
    use jp_slider_eliminate, only: jp_slider_eliminate_jacobian
    implicit none
    integer, parameter :: dp = kind(1.0d0)
    integer :: mdof, n, jdof(6, *), jtype, maxdof, lmpc, kstep, kinc, nt, nf, ltran(*)
    real(dp) :: ue(*), a(6, 6, *), x(6, *), u(6, *), uinit(6, *), time(2), temp(*), field(*), tran(3, 3, *)
    real(dp) :: x1(3), xn(3), d(3), y(2), slope(2, 7), kept
    integer :: p, q, i, j, k, code
    ! begin
    x1 = x(1:3, 3) + u(1:3, 3)
    xn = x(1:3, 4) + u(1:3, 4)
    d = abs(xn - x1)
    d = scale(d, -exponent(maxval(d)))
    p = merge(3, 2, d(3) >= d(2))
    q = 5 - p
    i = q
    j = p
    k = 1
    if (d(p) > 0 .and. d(p)**2 + d(q)**2 >= d(p) * d(1)) then
        j = 1
        k = p
    end if
    kept = x(k, 2) + u(k, 2)
    code = jp_slider_eliminate_jacobian(x1, xn, kept, y(1), y(2), slope)
    ue(1) = y(1) - x(i, 1)
    ue(2) = y(2) - x(j, 1)
    jdof(1, 1) = i
    jdof(2, 1) = j
    jdof(1, 2) = k
    jdof(1:3, 3) = [1, 2, 3]
    jdof(1:3, 4) = [1, 2, 3]
    a(1, 1, 1) = 1
    a(2, 2, 1) = 1
    a(1, 1, 2) = -slope(1, 7)
    a(2, 1, 2) = -slope(2, 7)
    a(1, 1:3, 3) = -slope(1, 1:3)
    a(2, 1:3, 3) = -slope(2, 1:3)
    a(1, 1:3, 4) = -slope(1, 4:6)
    a(2, 1:3, 4) = -slope(2, 4:6)
    ! end
end subroutine mpc
