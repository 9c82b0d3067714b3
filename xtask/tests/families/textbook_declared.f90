    real(dp) :: along(3), length, n0(3), axis(3), t0(3), t9(3), height, projector(3, 3), across(3, 3), share, on_m(3)
    real(dp) :: gaps(2), of_gaps(2, 9), loads(9), of_loads(9, 11), moved(9), dn(3), dt0(3), dt9(3), dm(3), dshare
    real(dp) :: with_first, with_second
    integer :: row_of, column_of
    ! begin
