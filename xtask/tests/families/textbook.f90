    ! The basis normal to the line and what slides along it, as textbooks write them: lengths are roots of sums of squares,
    ! and the derivative of a unit vector is everybody's projector.
    along = xn - x1
    length = sqrt(sum(along**2))
    n0 = along / length
    axis = [1.0_dp, 0.0_dp, 0.0_dp]
    t0 = cshift(n0, 1) * cshift(axis, -1) - cshift(n0, -1) * cshift(axis, 1)
    if (all(t0 == 0)) then
        axis = [0.0_dp, 0.0_dp, 1.0_dp]
        t0 = cshift(n0, 1) * cshift(axis, -1) - cshift(n0, -1) * cshift(axis, 1)
    end if
    height = sqrt(sum(t0**2))
    t0 = t0 / height
    t9 = cshift(n0, 1) * cshift(t0, -1) - cshift(n0, -1) * cshift(t0, 1)
    do row_of = 1, 3
        do column_of = 1, 3
            projector(row_of, column_of) = (merge(1.0_dp, 0.0_dp, row_of == column_of) - n0(row_of) * n0(column_of)) / length
            across(row_of, column_of) = (merge(1.0_dp, 0.0_dp, row_of == column_of) - t0(row_of) * t0(column_of)) / height
        end do
    end do
    share = dot_product(xm - x1, n0) / length
    gaps = [dot_product(xm - x1, t0), dot_product(xm - x1, t9)]
    on_m = with_first * t0 + with_second * t9
    loads = [-(1 - share) * on_m, -share * on_m, on_m]
    do column_of = 1, 9
        moved = 0
        moved(column_of) = 1
        along = moved(4:6) - moved(1:3)
        dn = matmul(projector, along)
        dt0 = matmul(across, cshift(dn, 1) * cshift(axis, -1) - cshift(dn, -1) * cshift(axis, 1))
        dt9 = cshift(dn, 1) * cshift(t0, -1) - cshift(dn, -1) * cshift(t0, 1) &
            + cshift(n0, 1) * cshift(dt0, -1) - cshift(n0, -1) * cshift(dt0, 1)
        dshare = (dot_product(moved(7:9) - moved(1:3), n0) + dot_product(xm - x1, dn) - share * dot_product(n0, along)) / length
        of_gaps(1, column_of) = dot_product(moved(7:9) - moved(1:3), t0) + dot_product(xm - x1, dt0)
        of_gaps(2, column_of) = dot_product(moved(7:9) - moved(1:3), t9) + dot_product(xm - x1, dt9)
        dm = with_first * dt0 + with_second * dt9
        of_loads(:, column_of) = [dshare * on_m - (1 - share) * dm, -dshare * on_m - share * dm, dm]
    end do
    of_loads(:, 10) = [-(1 - share) * t0, -share * t0, t0]
    of_loads(:, 11) = [-(1 - share) * t9, -share * t9, t9]
