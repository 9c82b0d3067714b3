
    ! Three vectors turned by a rotation vector.
    pure function turned(rotation, axes)
        real(dp), intent(in) :: rotation(3), axes(9)
        real(dp) :: turned(3, 3), angle, sine, versine, across(3)
        integer :: k
        turned = reshape(axes, [3, 3])
        angle = sqrt(rotation(1) * rotation(1) + rotation(2) * rotation(2) &
            + rotation(3) * rotation(3))
        if (angle <= 0) return
        sine = sin(angle) / angle
        versine = 2 * (sin(angle / 2) / angle)**2
        do k = 1, 3
            across = cross(rotation, turned(:, k))
            turned(:, k) = turned(:, k) + (sine * across + versine * cross(rotation, across))
        end do
    end function turned

    pure function cross(x, y)
        real(dp), intent(in) :: x(3), y(3)
        real(dp) :: cross(3)
        cross(1) = x(2) * y(3) - x(3) * y(2)
        cross(2) = x(3) * y(1) - x(1) * y(3)
        cross(3) = x(1) * y(2) - x(2) * y(1)
    end function cross
