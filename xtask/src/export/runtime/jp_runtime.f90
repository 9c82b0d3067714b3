! What the formulas call: lengths that neither overflow nor underflow, and sums of products that lose
! nothing. Printed by jointproof; free of conditions (CC0-1.0).
module jp_runtime
    use, intrinsic :: iso_c_binding, only: c_double
    use, intrinsic :: iso_fortran_env, only: int64, dp => real64
    use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_positive_inf
    implicit none
    public

    interface
        pure function jp_fma(x, y, z) bind(c, name='fma') result(w)
            import :: c_double
            real(c_double), value :: x, y, z
            real(c_double) :: w
        end function jp_fma
        pure function jp_expm1(x) bind(c, name='expm1') result(w)
            import :: c_double
            real(c_double), value :: x
            real(c_double) :: w
        end function jp_expm1
    end interface

    ! An exact sum, kept as parts that do not overlap, smaller ones first, none of them 0 (Shewchuk).
    type :: jp_expansion
        real(dp) :: part(144)
        integer :: n = 0
    end type jp_expansion

contains

    pure function jp_infinity() result(x)
        real(dp) :: x
        x = ieee_value(0.0_dp, ieee_positive_inf)
    end function jp_infinity

    ! Equality, spelt so that no compiler warns of it: here it is meant.
    pure function jp_equal(x, y) result(equal)
        real(dp), intent(in) :: x, y
        logical :: equal
        equal = x <= y .and. x >= y
    end function jp_equal

    ! The square root of a sum of squares that is rescaled where it would leave the range of doubles.
    pure function jp_norm(x) result(length)
        real(dp), intent(in) :: x(:)
        real(dp) :: length, total, factor
        integer :: k
        total = 0.0_dp
        do k = 1, size(x)
            total = total + x(k)*x(k)
        end do
        if (total > 2.0_dp**(-900) .and. total < 2.0_dp**1000) then
            length = sqrt(total)
            return
        end if
        factor = 2.0_dp**600
        if (any(abs(x) > 1.0_dp)) factor = 2.0_dp**(-600)
        total = 0.0_dp
        do k = 1, size(x)
            total = total + (x(k)*factor)*(x(k)*factor)
        end do
        length = sqrt(total)/factor
    end function jp_norm

    pure function jp_norm2(x, y) result(length)
        real(dp), intent(in) :: x, y
        real(dp) :: length
        length = jp_norm([x, y])
    end function jp_norm2

    pure function jp_norm3(x, y, z) result(length)
        real(dp), intent(in) :: x, y, z
        real(dp) :: length
        length = jp_norm([x, y, z])
    end function jp_norm3

    pure function jp_norm4(x, y, z, w) result(length)
        real(dp), intent(in) :: x, y, z, w
        real(dp) :: length
        length = jp_norm([x, y, z, w])
    end function jp_norm4

    ! The largest power of two that is not above a positive number, within 2**(-1022) and 2**1022.
    pure function jp_power_of_two(x) result(power)
        real(dp), intent(in) :: x
        real(dp) :: power
        power = scale(1.0_dp, min(exponent(x) - 1, 1022))
    end function jp_power_of_two

    pure subroutine jp_add(total, x)
        type(jp_expansion), intent(inout) :: total
        real(dp), intent(in) :: x
        real(dp) :: a, b, high, b_part, low, carried
        integer :: k, kept
        if (.not. abs(x) > 0.0_dp) return
        kept = 0
        carried = x
        do k = 1, total%n
            a = carried
            b = total%part(k)
            high = a + b
            b_part = high - a
            low = (a - (high - b_part)) + (b - b_part)
            carried = high
            if (abs(low) > 0.0_dp) then
                kept = kept + 1
                total%part(kept) = low
            end if
        end do
        if (abs(carried) > 0.0_dp) then
            kept = kept + 1
            total%part(kept) = carried
        end if
        total%n = kept
    end subroutine jp_add

    ! Dekker's product, with Veltkamp's splitting.
    pure subroutine jp_add_product(total, a, b)
        type(jp_expansion), intent(inout) :: total
        real(dp), intent(in) :: a, b
        real(dp) :: high, low, large, a1, a2, b1, b2
        if (.not. (abs(a) > 0.0_dp .and. abs(b) > 0.0_dp)) return
        high = a*b
        large = a*134217728.0_dp + a
        a1 = large - (large - a)
        a2 = a - a1
        large = b*134217728.0_dp + b
        b1 = large - (large - b)
        b2 = b - b1
        low = a2*b2 - (((high - a1*b1) - a2*b1) - a1*b2)
        call jp_add(total, low)
        call jp_add(total, high)
    end subroutine jp_add_product

    ! A sum of products of four numbers each, one after the other: nothing is rounded but the sum.
    pure function jp_exact_sum(factors) result(total)
        real(dp), intent(in) :: factors(:)
        real(dp) :: total
        type(jp_expansion) :: two, three, all
        integer :: k, i
        do k = 1, size(factors), 4
            two%n = 0
            three%n = 0
            call jp_add_product(two, factors(k), factors(k + 1))
            do i = 1, two%n
                call jp_add_product(three, two%part(i), factors(k + 2))
            end do
            do i = 1, three%n
                call jp_add_product(all, three%part(i), factors(k + 3))
            end do
        end do
        total = 0.0_dp
        do i = 1, all%n
            total = total + all%part(i)
        end do
    end function jp_exact_sum

end module jp_runtime
