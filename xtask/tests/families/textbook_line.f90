    ! By the direction as a unit vector, whose derivative is everybody's projector.
    along = xn - x1
    length = sqrt(along(1)**2 + along(2)**2 + along(3)**2)
    n0 = along / length
    do row_of = 1, 3
        do column_of = 1, 3
            projector(row_of, column_of) = (merge(1.0_dp, 0.0_dp, row_of == column_of) - n0(row_of) * n0(column_of)) / length
        end do
    end do
    do row_of = 1, 2
        along = projector(chosen(row_of), :) / n0(k) - n0(chosen(row_of)) * projector(k, :) / n0(k)**2
        share = n0(chosen(row_of)) / n0(k)
        y(row_of) = x1(chosen(row_of)) + share * (kept - x1(k))
        slope(row_of, 1:3) = -along * (kept - x1(k))
        slope(row_of, 4:6) = along * (kept - x1(k))
        slope(row_of, chosen(row_of)) = slope(row_of, chosen(row_of)) + 1
        slope(row_of, k) = slope(row_of, k) - share
        slope(row_of, 7) = share
    end do
