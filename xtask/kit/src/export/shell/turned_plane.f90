
    ! A vector turned by an angle.
    pure function turned(rotation, axis)
        real(dp), intent(in) :: rotation, axis(2)
        real(dp) :: turned(2)
        turned(1) = cos(rotation) * axis(1) - sin(rotation) * axis(2)
        turned(2) = sin(rotation) * axis(1) + cos(rotation) * axis(2)
    end function turned
