! A beam with shear in space, of two nodes with rotation vectors: strains are measured in the triad of node 1, curvatures by the
! skew part of the relative rotation. PROPS: length, stiffness of tension, shear and shear, of torsion, bending and bending.
! Moments and the tangent are by spins; the tangent is by complex steps.
subroutine uel(rhs, amatrx, svars, energy, ndofel, nrhs, nsvars, props, nprops, coords, mcrd, nnode, u, du, v, a, &
        jtype, time, dtime, kstep, kinc, jelem, params, ndload, jdltyp, adlmag, predef, npredf, lflags, mlvarx, &
        ddlmag, mdload, pnewdt, jprops, njprop, period)
    implicit none
    integer, parameter :: dp = kind(1.0d0)
    integer :: ndofel, nrhs, nsvars, nprops, mcrd, nnode, jtype, kstep, kinc, jelem, ndload, npredf, mlvarx, mdload
    integer :: njprop, jdltyp(mdload, *), lflags(*), jprops(*)
    real(dp) :: rhs(mlvarx, *), amatrx(ndofel, ndofel), svars(*), energy(8), props(*), coords(mcrd, nnode), u(ndofel)
    real(dp) :: du(mlvarx, *), v(ndofel), a(ndofel), time(2), dtime, params(3), adlmag(mdload, *), ddlmag(mdload, *)
    real(dp) :: predef(2, npredf, nnode), pnewdt, period, step, whole(12, 12)
    complex(dp) :: q(12), spin(3, 2), found(12)
    logical :: by_vectors
    integer :: k
    by_vectors = .false.
    step = 1e-30_dp
    spin = 0
    q = u
    rhs(1:12, 1) = real(forces(q, spin))
    do k = 1, 12
        q = u
        spin = 0
        if (by_vectors .or. k <= 3 .or. (k >= 7 .and. k <= 9)) then
            q(k) = cmplx(u(k), step, dp)
        else if (k <= 6) then
            spin(k - 3, 1) = cmplx(0.0_dp, step, dp)
        else
            spin(k - 9, 2) = cmplx(0.0_dp, step, dp)
        end if
        found = forces(q, spin)
        whole(:, k) = -aimag(found) / step
    end do
    amatrx = whole
    ! end of the tangent
contains
    function forces(q, spin)
        complex(dp), intent(in) :: q(12), spin(3, 2)
        complex(dp) :: forces(12), r1(3, 3), r2(3, 3), between(3), strain(3), relative(3, 3), curved(3), n(3), m(3)
        r1 = turned(spin(:, 1), q(4:6))
        r2 = turned(spin(:, 2), q(10:12))
        between = coords(:, 2) - coords(:, 1) + q(7:9) - q(1:3)
        strain = matmul(transpose(r1), between) / props(1)
        strain(1) = strain(1) - 1
        relative = matmul(transpose(r1), r2)
        curved(1) = relative(3, 2) - relative(2, 3)
        curved(2) = relative(1, 3) - relative(3, 1)
        curved(3) = relative(2, 1) - relative(1, 2)
        n = matmul(r1, props(2:4) * strain)
        m = props(5:7) * curved / (2 * props(1))
        m = ((relative(1, 1) + relative(2, 2) + relative(3, 3)) * m - matmul(transpose(relative), m)) / 2
        m = matmul(r1, m)
        forces(1:3) = n
        forces(4:6) = m - cross(n, between)
        forces(7:9) = -n
        forces(10:12) = -m
    end function forces

    ! A spin that follows the rotation of a rotation vector.
    function turned(spin, theta)
        complex(dp), intent(in) :: spin(3), theta(3)
        complex(dp) :: turned(3, 3), square, first, second
        complex(dp) :: angle
        square = sum(theta**2)
        if (abs(square) < 1e-6_dp) then
            first = 1 - square / 6 + square**2 / 120
            second = 0.5_dp - square / 24 + square**2 / 720
        else
            angle = sqrt(square)
            first = sin(angle) / angle
            second = (1 - cos(angle)) / square
        end if
        turned = first * skew(theta) + second * matmul(skew(theta), skew(theta)) + unit()
        turned = turned + matmul(skew(spin), turned)
    end function turned

    function unit()
        complex(dp) :: unit(3, 3)
        unit = 0
        unit(1, 1) = 1
        unit(2, 2) = 1
        unit(3, 3) = 1
    end function unit

    function skew(x)
        complex(dp), intent(in) :: x(3)
        complex(dp) :: skew(3, 3)
        skew = 0
        skew(3, 2) = x(1)
        skew(2, 3) = -x(1)
        skew(1, 3) = x(2)
        skew(3, 1) = -x(2)
        skew(2, 1) = x(3)
        skew(1, 2) = -x(3)
    end function skew

    function cross(x, y)
        complex(dp), intent(in) :: x(3), y(3)
        complex(dp) :: cross(3)
        cross = matmul(skew(x), y)
    end function cross
end subroutine uel
