! A quadrilateral in plane strain, of a compressible neo-Hookean material: PROPS are both of Lame's constants and the thickness.
subroutine uel(rhs, amatrx, svars, energy, ndofel, nrhs, nsvars, props, nprops, coords, mcrd, nnode, u, du, v, a, &
        jtype, time, dtime, kstep, kinc, jelem, params, ndload, jdltyp, adlmag, predef, npredf, lflags, mlvarx, &
        ddlmag, mdload, pnewdt, jprops, njprop, period)
    implicit none
    integer, parameter :: dp = kind(1.0d0)
    integer :: ndofel, nrhs, nsvars, nprops, mcrd, nnode, jtype, kstep, kinc, jelem, ndload, npredf, mlvarx, mdload
    integer :: njprop, jdltyp(mdload, *), lflags(*), jprops(*)
    real(dp) :: rhs(mlvarx, *), amatrx(ndofel, ndofel), svars(*), energy(8), props(*), coords(mcrd, nnode), u(ndofel)
    real(dp) :: du(mlvarx, *), v(ndofel), a(ndofel), time(2), dtime, params(3), adlmag(mdload, *), ddlmag(mdload, *)
    real(dp) :: predef(2, npredf, nnode), pnewdt, period
    real(dp) :: at(2), shape(2, 4), map(2, 2), slope(2, 4), f(2, 2), g(2, 2), stress(2, 2), moduli, area, jacobian, volume
    integer :: p, n, m, i, j, k, l, row, column
    real(dp), parameter :: corners(2, 4) = reshape([-1, -1, 1, -1, 1, 1, -1, 1], [2, 4])
    rhs(1:8, 1) = 0
    amatrx = 0
    do p = 1, 4
        at = corners(:, p) / sqrt(3.0_dp)
        do n = 1, 4
            shape(1, n) = corners(1, n) * (1 + corners(2, n) * at(2)) / 4
            shape(2, n) = corners(2, n) * (1 + corners(1, n) * at(1)) / 4
        end do
        map = matmul(shape, transpose(coords))
        area = map(1, 1) * map(2, 2) - map(1, 2) * map(2, 1)
        slope = matmul(inverse(map), shape)
        volume = area * props(3)
        f = reshape([1, 0, 0, 1], [2, 2])
        f = f + matmul(reshape(u, [2, 4]), transpose(slope))
        jacobian = f(1, 1) * f(2, 2) - f(1, 2) * f(2, 1)
        if (jacobian <= 0) then
            pnewdt = 0.5_dp
            return
        end if
        g = inverse(f)
        stress = props(2) * (f - transpose(g)) + props(1) * log(jacobian) * transpose(g)
        do n = 1, 4
            do i = 1, 2
                row = 2 * (n - 1) + i
                rhs(row, 1) = rhs(row, 1) - volume * dot_product(stress(i, :), slope(:, n))
                do m = 1, 4
                    do k = 1, 2
                        column = 2 * (m - 1) + k
                        do j = 1, 2
                            do l = 1, 2
                                moduli = props(1) * g(j, i) * g(l, k) + (props(2) - props(1) * log(jacobian)) * g(j, k) * g(l, i)
                                if (i == k .and. j == l) moduli = moduli + props(2)
                                amatrx(row, column) = amatrx(row, column) + volume * slope(j, n) * moduli * slope(l, m)
                            end do
                        end do
                    end do
                end do
            end do
        end do
    end do
    ! end of the tangent
contains
    pure function inverse(of)
        real(dp), intent(in) :: of(2, 2)
        real(dp) :: inverse(2, 2)
        inverse = reshape([of(2, 2), -of(2, 1), -of(1, 2), of(1, 1)], [2, 2]) / (of(1, 1) * of(2, 2) - of(1, 2) * of(2, 1))
    end function inverse
end subroutine uel
