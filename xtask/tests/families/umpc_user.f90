subroutine umpc_user(x, u, f, a, jdof, n, force, iit, idiscon)
    use jp_slider_constraint, only: jp_slider_constraint_jacobian
    implicit none
    integer, parameter :: dp = kind(1.0d0)
    integer :: n, jdof(*), iit, idiscon
    real(dp) :: x(3, *), u(3, *), f, a(*), force
    real(dp) :: x1(3), xn(3), xm(3), g(2), slope(2, 9), row(9), swapped
    integer :: equation, code, k
    ! begin
    equation = nint(x(1, 10))
    if (equation == 1) then
        xm = x(:, 1) + u(:, 1)
        x1 = x(:, 4) + u(:, 4)
        xn = x(:, 7) + u(:, 7)
    else
        x1 = x(:, 1) + u(:, 1)
        xn = x(:, 4) + u(:, 4)
        xm = x(:, 7) + u(:, 7)
    end if
    code = jp_slider_constraint_jacobian(x1, xn, xm, g(1), g(2), slope)
    f = g(equation)
    row = slope(equation, :)
    if (equation == 1) then
        row = [slope(equation, 7:9), slope(equation, 1:6)]
    end if
    a(1:9) = row
    a(10) = 0
    jdof(1:9) = [1, 2, 3, 1, 2, 3, 1, 2, 3]
    jdof(10) = 1
    k = maxloc(abs(row(1:3)), 1)
    a(1) = row(k)
    jdof(1) = k
    if (k /= 1) then
        a(k) = row(1)
        jdof(k) = 1
    end if
    ! end
end subroutine umpc_user
