
    ! Whether the compiler keeps the order of operations: Intel's default reorders sums.
    function keeps_order()
        logical :: keeps_order
        real(dp), volatile :: large, beside
        real(dp) :: a, b
        large = 2.0_dp**53
        beside = 1 + 2.0_dp**(-30)
        a = large
        b = beside
        keeps_order = abs((a + 1) - a) <= 0 .and. abs(b * b - (1 + 2.0_dp**(-29))) <= 0
    end function keeps_order
