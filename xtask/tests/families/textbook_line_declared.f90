    real(dp) :: along(3), length, n0(3), projector(3, 3), share
    integer :: row_of, column_of, chosen(2)
    ! begin
